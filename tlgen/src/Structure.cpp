// Proofs by reachability: an input that no computation reaches has no influence.
#include "Structure.h"

#include "Order.h"

namespace tlgen {
namespace {

// The updates that the row's content comes from, through other rows.
std::vector<const RowUpdate *> updatesOf(const std::vector<RowUpdate> &all, const Row *row) {
  std::vector<const RowUpdate *> found;
  std::set<const Row *> rows = {row};
  for (size_t before = 0; before != rows.size();) {
    before = rows.size();
    found.clear();
    for (const RowUpdate &update : all) {
      if (!rows.count(update.row)) continue;
      found.push_back(&update);
      for (auto &[direction, factor] : update.sum)
        if (direction->row) rows.insert(direction->row);
    }
  }
  return found;
}

void addWrites(std::vector<Node *> &values, const Array *array) {
  for (const Write &write : array->writes) {
    values.push_back(write.value);
    values.push_back(write.index);
  }
}

} // namespace

std::vector<Node *> valuesOf(const Results &results, const std::string &name) {
  std::vector<Node *> values;
  auto array = results.arrays.find(name);
  auto row = results.rows.find(name);
  if (array != results.arrays.end()) addWrites(values, array->second);
  if (row == results.rows.end()) return values;
  const std::vector<RowUpdate> all = results.updates();
  for (const RowUpdate *update : updatesOf(all, row->second)) {
    if (update->loop) values.push_back(update->loop->index);
    for (auto &[direction, factor] : update->sum) {
      values.push_back(factor);
      for (Node *node : {direction->column, direction->index, update->index})
        if (node) values.push_back(node);
    }
  }
  return values;
}

bool dependOn(const std::vector<Node *> &values, const std::set<Slot::Kind> &kinds) {
  Needed needed(values);
  for (const Node *node : needed.nodes())
    if (node->op == Node::Leaf && kinds.count(node->slot->kind)) return true;
  return false;
}

bool isMassConstant(const Results &simulate) {
  const std::vector<Node *> values = valuesOf(simulate, "M");
  return !values.empty() && !dependOn(values, {Slot::Q, Slot::Qd, Slot::T});
}

bool isAutonomous(const Equations &equations) {
  std::vector<Node *> values = {equations.lagrangian};
  if (equations.force) addWrites(values, equations.force);
  for (const auto *functions : {&equations.holonomic, &equations.nonholonomic})
    for (const Array *function : *functions) addWrites(values, function);
  return !dependOn(values, {Slot::T});
}

} // namespace tlgen
