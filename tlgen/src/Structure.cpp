// Proofs by reachability: an input that no computation reaches has no influence.
#include "Structure.h"

#include "Order.h"

namespace tlgen {
namespace {

void addWrites(std::vector<Node *> &values, const Array *array) {
  for (const Write &write : array->writes) {
    values.push_back(write.value);
    values.push_back(write.index);
    if (write.loop) values.push_back(write.loop->index);
  }
}

// The columns of one row that can be other than zero, from the first on; all for a row of which nothing is known.
using Columns = std::set<long>;

Columns firstColumns(long count) {
  Columns columns;
  for (long j = 0; j < count; ++j) columns.insert(j);
  return columns;
}

// At one iteration (of its loop) of an index; -1 where it depends on more than that.
long at(const Node *index, const Loop *loop, long iteration) {
  if (index->op != Node::Affine || index->terms.size() > 1) return -1;
  if (index->terms.empty()) return index->offset;
  return index->terms[0].first == loop ? index->offset + iteration * index->terms[0].second : -1;
}

long tripsOf(const Loop *loop) { return !loop ? 1 : loop->trips && loop->trips->isConstant() ? loop->trips->offset : -1; }

// The columns that one update can reach in one iteration.
Columns columnsOf(const RowUpdate &update, long iteration, long columns) {
  Columns reached;
  for (auto &[direction, factor] : update.sum) {
    const Node *bound = update.bound ? update.bound : direction->bound;
    const long end = direction->column ? at(direction->column, update.loop, iteration)
                     : bound           ? at(bound, update.loop, iteration)
                                       : columns;
    if (end < 0 || (direction->row && end >= columns)) return firstColumns(columns);
    if (direction->column)
      reached.insert(end);
    else
      reached.merge(firstColumns(end));
  }
  const long from = update.from ? at(update.from, update.loop, iteration) : 0;
  if (from > 0) reached.erase(reached.begin(), reached.lower_bound(from));
  return reached;
}

// Of a matrix that is a row in memory: by row.
std::vector<Columns> reachedBy(const std::vector<RowUpdate> &updates, const Row *row, long columns) {
  std::vector<Columns> reached(static_cast<size_t>(row->count));
  for (const RowUpdate &update : updates) {
    if (update.row != row) continue;
    const long trips = tripsOf(update.loop);
    for (long k = 0; k < trips; ++k) {
      const long i = at(update.index, update.loop, k);
      if (i >= 0 && i < row->count) reached[size_t(i)].merge(columnsOf(update, k, columns));
    }
    const bool unknown = trips < 0 || at(update.index, update.loop, 0) < 0;
    if (unknown) reached.assign(reached.size(), firstColumns(columns));
  }
  return reached;
}

// Of a matrix with explicit columns.
std::vector<Columns> reachedBy(const Array *matrix, long columns) {
  std::vector<Columns> reached(static_cast<size_t>(matrix->length / columns));
  for (const Write &write : matrix->writes) {
    const bool known = write.index->isConstant();
    if (!known) return std::vector<Columns>(reached.size(), firstColumns(columns));
    if (!write.value->is(0)) reached[size_t(write.index->offset / columns)].insert(write.index->offset % columns);
  }
  return reached;
}

// Columns as coordinates: explicit ones are all of q, then all of qd; others alternate. Those of M are coordinates anyway.
Columns coordinatesOf(const Columns &reached, long columns, long n, bool isExplicit) {
  Columns coordinates;
  for (long j : reached) coordinates.insert(columns == n ? j : isExplicit ? j % n : j / 2);
  return coordinates;
}

} // namespace

std::vector<Node *> valuesOf(const Results &results, const std::string &name) {
  std::vector<Node *> values;
  auto array = results.arrays.find(name);
  auto row = results.rows.find(name);
  if (array != results.arrays.end()) addWrites(values, array->second);
  if (row == results.rows.end()) return values;
  const std::vector<RowUpdate> all = results.updates();
  const std::set<const Row *> rows = sourcesOf({row->second}, all);
  for (const RowUpdate &update : all) {
    if (!rows.count(update.row)) continue;
    if (update.loop) values.push_back(update.loop->index);
    for (auto &[direction, factor] : update.sum) {
      values.push_back(factor);
      for (Node *node : {direction->column, direction->index, update.index})
        if (node) values.push_back(node);
    }
  }
  return values;
}

std::vector<Node *> valuesOf(const Equations &equations) {
  std::vector<Node *> values = {equations.lagrangian};
  if (equations.dissipation) values.push_back(equations.dissipation);
  if (equations.force) addWrites(values, equations.force);
  for (const auto *functions : {&equations.holonomic, &equations.nonholonomic})
    for (const Array *function : *functions) addWrites(values, function);
  return values;
}

bool dependOn(const std::vector<Node *> &values, const std::set<Slot::Kind> &kinds) {
  Needed needed(values);
  for (const Node *node : needed.nodes())
    if (node->op == Node::Leaf && kinds.count(node->slot->kind)) return true;
  return false;
}

RowClasses classesOf(const Results &results, const std::string &name, long columns, long n) {
  RowClasses classes;
  auto array = results.arrays.find(name);
  auto row = results.rows.find(name);
  const bool isExplicit = array != results.arrays.end();
  if (!isExplicit && row == results.rows.end()) return classes;
  const std::vector<Columns> all = isExplicit ? reachedBy(array->second, columns) : reachedBy(results.updates(), row->second, columns);
  for (const Columns &reached : all) {
    const Columns coordinates = coordinatesOf(reached, columns, n, isExplicit);
    const long last = coordinates.empty() ? -1 : *coordinates.rbegin();
    ++(coordinates.empty() ? classes.zero : coordinates.size() == 1 ? classes.local : last < n - 1 ? classes.prefix : classes.dense);
    classes.entries += long(reached.size());
    classes.all += columns;
  }
  return classes;
}

bool isMassConstant(const Results &simulate) {
  const std::vector<Node *> values = valuesOf(simulate, "M");
  return !values.empty() && !dependOn(values, {Slot::Q, Slot::Qd, Slot::T});
}

bool isAutonomous(const Equations &equations) { return !dependOn(valuesOf(equations), {Slot::T}); }

} // namespace tlgen
