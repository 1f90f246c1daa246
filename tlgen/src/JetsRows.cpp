// Rows of tangents made simpler, once all that is done to them is known.
#include "Jets.h"

#include <algorithm>

namespace tlgen {

std::set<const Row *> sourcesOf(std::set<const Row *> rows, const std::vector<RowUpdate> &updates) {
  for (size_t before = 0; before != rows.size();) {
    before = rows.size();
    for (const RowUpdate &update : updates)
      if (rows.count(update.row))
        for (auto &[direction, factor] : update.sum)
          if (direction->row) rows.insert(direction->row);
  }
  return rows;
}

// Demand: updates of rows that no result comes from.
void Jets::dropUnused() {
  std::set<const Row *> results;
  for (const Row &row : rows_)
    if (row.result) results.insert(&row);
  const std::set<const Row *> used = sourcesOf(std::move(results), updates_);
  auto unused = [&](const RowUpdate &update) { return !used.count(update.row); };
  updates_.erase(std::remove_if(updates_.begin(), updates_.end(), unused), updates_.end());
}

// A carried row R that every iteration, counting down, adds first columns of a finished row P to, times a number f of the iteration's
// own: with S_i the sum of f over the iterations so far, the iteration leaves R_c = S_i P_c in the first columns and S_j P_c beyond
// them, j the iteration whose own column c is. So only the sums S are carried, and there is one row of the products S_j P_c, the tail.
struct Jets::ClosedSum {
  struct Part {
    const Direction *view;
    Node *factor;
    Loop *from;   // the loop that made P
    Tangents own; // P's columns of an iteration
  };
  Loop *loop = nullptr;
  Node *bound = nullptr;
  std::vector<Part> parts;
};

void Jets::closeSums() {
  for (size_t k = 0; k < updates_.size(); ++k) {
    ClosedSum sum;
    if (!isClosed(updates_[k], sum)) continue;
    const Row *row = updates_[k].row;
    updates_.erase(updates_.begin() + long(k--));
    replaceSum(row, sum, tailOf(sum));
  }
}

bool Jets::isClosed(const RowUpdate &update, ClosedSum &sum) const {
  Loop *loop = sum.loop = update.loop;
  if (explicit_ || !loop || loop->outer || !loop->trips || !loop->trips->isConstant() || !loop->down || update.before || update.index ||
      update.row->carriedBy != loop)
    return false;
  for (const RowUpdate &other : updates_) {
    if (&other != &update && other.row == update.row) return false;
    for (auto &[direction, factor] : other.sum)
      if (direction->row == update.row && &other != &update && (!direction->updated || other.loop != loop)) return false;
  }
  for (auto &[direction, factor] : update.sum) {
    if (direction->row == update.row && !direction->updated && factor->is(1)) continue;
    ClosedSum::Part part{direction, factor, nullptr, {}};
    if (direction->column || !direction->bound || direction->index || direction->from || !direction->row->carriedBy) return false;
    part.from = direction->row->carriedBy;
    Node *end = ownColumns(direction, part.from, part.own);
    Graph::Replacement here = {{part.from->index, loop->index}};
    if (part.from == loop || part.from->trips != loop->trips || !end || graph_.replace(end, here) != direction->bound) return false;
    if ((sum.bound && sum.bound != direction->bound) || tapes_.followsCarried(factor)) return false;
    sum.bound = direction->bound;
    sum.parts.push_back(std::move(part));
  }
  return !sum.parts.empty();
}

const Row *Jets::tailOf(const ClosedSum &sum) {
  Loop *fill = fillLoop(sum.loop->trips);
  Row *tail = &rows_.emplace_back(Row{int(rows_.size()), "row", 1, fill, false, false});
  Tangents columns;
  for (const ClosedSum::Part &part : sum.parts) {
    Graph::Replacement there = {{part.from->index, fill->index}}, by = there;
    Node *s = graph_.read(graph_.runningSums(part.factor, sum.loop), fill->index);
    for (auto &[own, value] : part.own) {
      const Direction *filled = column(graph_.replace(own->column, by));
      accumulate(columns, filled, graph_.mul(s, tapes_.at(value, there)));
    }
  }
  columns[direction({0, nullptr, tail, nullptr, nullptr, false})] = graph_.number(1);
  updates_.push_back({fill, tail, nullptr, false, false, nullptr, nullptr, columns, analyses_.demand});
  return tail;
}

// What the iteration leaves in the row, in terms of first columns and tail, wherever it is referred to.
void Jets::replaceSum(const Row *row, const ClosedSum &sum, const Row *tail) {
  for (RowUpdate &update : updates_) {
    auto found = std::find_if(update.sum.begin(), update.sum.end(), [&](auto &term) { return term.first->row == row; });
    if (found == update.sum.end()) continue;
    Node *factor = found->second;
    update.sum.erase(found);
    // The tail has what the iteration adds by itself, too.
    Node *beyond = update.from ? graph_.integerOp("-", sum.bound, update.from) : nullptr;
    bool tailAlone = beyond && beyond->isConstant() && beyond->offset <= sum.bound->terms[0].second;
    Tangents instead = {
        {direction({0, nullptr, const_cast<Row *>(tail), nullptr, nullptr, false, tailAlone ? nullptr : sum.bound}), factor}};
    for (const ClosedSum::Part &part : sum.parts)
      if (!tailAlone) instead[part.view] = graph_.mul(factor, graph_.read(graph_.runningSums(part.factor, sum.loop), sum.loop->index));
    accumulate(update.sum, graph_.number(1), instead);
  }
}

bool Jets::isReferred(const Row *row, const Loop *loop) const {
  for (const RowUpdate &update : updates_)
    for (auto &[direction, factor] : update.sum)
      if (direction->row == row && update.row != row && update.loop == loop) return true;
  return false;
}

Loop *Jets::fillLoop(Node *trips) {
  Loop *&fill = fills_[trips];
  return fill ? fill : fill = graph_.loop(nullptr, trips, false);
}

// Rows that only get columns of the iteration's own, and that nothing else in the loop needs, are filled in a loop of their own: one
// without anything that iterations carry, so that compilers make vectors of it.
void Jets::separateFills() {
  for (RowUpdate &update : updates_) {
    Loop *loop = update.loop;
    Tangents own;
    if (explicit_ || !loop || loop->outer || !loop->trips || !loop->trips->isConstant() || update.index || update.before ||
        isReferred(update.row, loop))
      continue;
    const Direction *self = direction({0, nullptr, update.row, nullptr, nullptr, false});
    if (!ownColumns(self, loop, own)) continue;
    if (std::any_of(own.begin(), own.end(), [&](auto &term) { return tapes_.followsCarried(term.second); })) continue;
    Loop *fill = fillLoop(loop->trips);
    update.fill = analyses_.demand; // what nothing reads must not be set only: compilers warn of that
    update.loop = fill;
    update.row->carriedBy = fill;
    update.bound = nullptr;
    update.sum = {{self, graph_.number(1)}};
    Graph::Replacement there = {{loop->index, fill->index}}, by = there;
    for (auto &[column, value] : own) update.sum[this->column(graph_.replace(column->column, by))] = tapes_.at(value, there);
  }
}

} // namespace tlgen
