// Elements whose offsets depend on the iteration numbers of kept loops.
//
// What an iteration reads is, newest first: what it wrote itself, what earlier iterations wrote (carried along), what stood there
// before the loop. Where it is not certain which of these it is, the loop is irregular and gets unrolled.
#include "Tracer.h"

#include <algorithm>
#include <numeric>

namespace tlgen::symbols {

long factorOf(const Node *n, const Loop *loop) {
  for (auto &[l, factor] : n->terms)
    if (l == loop) return factor;
  return 0;
}

// The greatest common divisor of the factors of iteration numbers.
static long divisor(const Node *n) {
  long g = 0;
  for (auto &term : n->terms) g = std::gcd(g, term.second);
  return g;
}

// Whether two offsets of the same iterations may be equal.
bool Tracer::mayMeet(Node *a, Node *b) {
  Node *d = graph_.integerOp("-", a, b);
  if (d->isConstant()) return d->offset == 0;
  return bounds(d).holds(0) && d->offset % divisor(d) == 0;
}

// Whether two offsets differ whatever iterations they belong to.
bool Tracer::apart(Node *a, Node *b) {
  Range x = bounds(a), y = bounds(b);
  if (x.hi < y.lo || y.hi < x.lo) return true;
  long g = std::gcd(divisor(a), divisor(b));
  return g != 0 ? (a->offset - b->offset) % g != 0 : a->offset != b->offset;
}

// A place with a constant offset holds no element of a kept loop.
void Tracer::checkConcrete(int object, long at) {
  if (kept_.empty()) return;
  Node *place = graph_.integer(at);
  auto written = state_.elements.find(object);
  if (written != state_.elements.end())
    for (const Element &e : written->second)
      if (!apart(e.at, place)) irregular("an array is used by a loop's number and by a constant index");
  for (const Kept *k : kept_) {
    auto offsets = k->written.find(object);
    if (offsets == k->written.end()) continue;
    for (Node *w : offsets->second)
      if (!apart(w, place)) irregular("an array is used by a loop's number and by a constant index");
  }
}

// Whether it is not found out yet where a loop around ends and what it writes: a later pass looks again.
bool Tracer::isTentative() const {
  return std::any_of(kept_.begin(), kept_.end(), [](const Kept *k) { return k->pass < surveyed || !k->loop->trips; });
}

// A place outside of an array of the inputs, where no condition of run time stands before it, is a fault of the source at these sizes.
void Tracer::checkIndex(Node *index, long length) {
  const bool outside = index->isConstant() && length >= 0 && (index->offset < 0 || index->offset >= length);
  if (outside && !graph_.guard)
    throw Unsuitable{"number " + std::to_string(index->offset) + " (counted from 0) of " + std::to_string(length), graph_.loc, false,
                     "index-range"};
  if (index->op != Node::Affine || index->isConstant() || length < 0) return;
  Range r = bounds(index);
  if (!isTentative() && (r.lo < 0 || r.hi >= length)) irregular("an index leaves its array for some numbers of the loops");
}

Cell Tracer::substituted(const Cell &c, const Loop *loop, Node *number) {
  Cell result = c;
  Graph::Replacement by = {{loop->index, number}};
  if (c.kind == Cell::Number) result.node = graph_.replace(c.node, by);
  if (c.kind != Cell::Address) return result;
  if (c.pointer->condition) irregular("a choice between pointers is kept in an array");
  Pointer p = *c.pointer;
  for (auto &index : p.indices) index.second = graph_.replace(index.second, by);
  result.pointer = std::make_shared<const Pointer>(std::move(p));
  return result;
}

// The content at an offset that depends on iteration numbers, or on constants alone.
Cell Tracer::element(int object, Node *at) {
  const Elements elements = state_.elements.count(object) ? state_.elements.at(object) : Elements{};
  for (size_t level = kept_.size() + 1; level-- > 0;) {
    for (size_t i = elements.size(); i-- > 0;) {
      const Element &e = elements[i];
      if (e.level != level) continue;
      if (!e.over) {
        if (e.at == at) return e.cell;
        if (mayMeet(e.at, at)) irregular("two indices of an array may be the same");
        continue;
      }
      long factor = factorOf(e.at, e.over);
      Graph::Replacement first = {{e.over->index, graph_.integer(0)}};
      Node *distance = graph_.integerOp("-", at, graph_.replace(e.at, first));
      auto terms = distance->terms;
      bool whole = distance->offset % factor == 0;
      for (auto &term : terms) whole = whole && term.second % factor == 0, term.second /= factor;
      Node *number = graph_.affine(distance->offset / factor, std::move(terms));
      bool inside = whole && bounds(number).lo >= 0 && bounds(graph_.integerOp("-", e.over->trips, number)).lo >= 1;
      if (inside) return substituted(e.cell, e.over, number);
      if (!apart(e.at, at)) irregular("a part of an array that a loop wrote is read beside others");
    }
    if (level == 0) break;
    Kept &loop = *kept_[level - 1];
    auto written = loop.written.find(object);
    if (written == loop.written.end()) continue;
    bool found = false;
    for (Node *w : written->second) {
      Cell earlier = writtenBefore(object, at, w, loop, found);
      if (found) return earlier;
    }
  }
  const Cells cells = *state_.objects.at(object);
  if (!at->isConstant()) return uniform(cells, at, object);
  return at->offset >= 0 && at->offset < long(cells.size()) ? cells[size_t(at->offset)] : Cell{};
}

// What an earlier iteration left at an offset where iterations write: carried from iteration to iteration.
Cell Tracer::writtenBefore(int object, Node *at, Node *written, Kept &loop, bool &found) {
  long factor = factorOf(written, loop.loop);
  Node *d = graph_.integerOp("-", written, at);
  if (factor == 0 || !d->isConstant()) {
    if (!apart(written, at)) irregular("what an iteration reads may have been written by an earlier one");
    return {};
  }
  if (d->offset % factor != 0 || d->offset / factor <= 0) return {};
  size_t distance = size_t(d->offset / factor);
  std::vector<Node *> &chain = loop.earlier[{object, written}];
  while (chain.size() < distance) { // before the first iteration it is what stood there
    long back = -long(chain.size()) - 1;
    Graph::Replacement by = {{loop.loop->index, graph_.integer(back)}};
    Node *place = graph_.replace(written, by);
    State now = state_;
    std::vector<Kept *> inner;
    while (kept_.back() != &loop) inner.push_back(kept_.back()), kept_.pop_back();
    kept_.pop_back();
    state_ = loop.before;
    bool exists = !place->isConstant() || (place->offset >= 0 && place->offset < long(state_.objects.at(object)->size()));
    Cell init = exists ? element(object, place) : Cell{};
    state_ = std::move(now);
    kept_.push_back(&loop);
    while (!inner.empty()) kept_.push_back(inner.back()), inner.pop_back();
    bool real = init.kind == Cell::Unset || (init.kind == Cell::Number && !isInteger(init.node));
    if (!real) irregular("integers or pointers are handed from iteration to iteration in an array");
    chain.push_back(graph_.carry(loop.loop, init.kind == Cell::Unset ? graph_.number(0) : init.node));
  }
  found = true;
  return {Cell::Number, chain[distance - 1], nullptr};
}

void Tracer::setElement(int object, Node *at, const Cell &cell) {
  Elements &elements = state_.elements[object];
  for (const Element &e : elements)
    if (e.level == kept_.size() && e.at != at && mayMeet(e.at, at)) irregular("two indices of an array may be the same");
  for (Element &e : elements)
    if (e.level == kept_.size() && e.at == at && !e.over) {
      e.cell = cell;
      return;
    }
  elements.push_back({at, nullptr, kept_.size(), cell, nullptr});
}

// What elements written on one of two ways are behind them.
Elements Tracer::mergedElements(Node *condition, const State &yes, const State &no, int object) {
  const Elements none;
  auto of = [&](const State &s) -> const Elements & { return s.elements.count(object) ? s.elements.at(object) : none; };
  const Elements &a = of(yes), &b = of(no);
  auto same = [](const Element &x, const Element &y) { return x.at == y.at && x.over == y.over && x.cell.same(y.cell); };
  size_t common = 0;
  while (common < a.size() && common < b.size() && same(a[common], b[common])) ++common;
  Elements result(a.begin(), a.begin() + long(common));
  std::vector<Node *> offsets;
  for (const Elements *side : {&a, &b})
    for (size_t i = common; i < side->size(); ++i) {
      if ((*side)[i].over) irregular("a loop that writes an array stands in a branch");
      if (std::find(offsets.begin(), offsets.end(), (*side)[i].at) == offsets.end()) offsets.push_back((*side)[i].at);
    }
  State now = state_;
  for (Node *at : offsets) {
    state_ = yes;
    Cell first = element(object, at);
    state_ = no;
    Cell second = element(object, at);
    result.push_back({at, nullptr, kept_.size(), merged(condition, first, second), nullptr});
  }
  state_ = std::move(now);
  return result;
}

// The cell at an offset that runs over several, where they are all made alike.
Cell Tracer::uniform(const Cells &cells, Node *at, int object) {
  Range r = bounds(at);
  const long last = long(cells.size()) - 1;
  if (isTentative()) { // of the first number
    const Cell &any = cells[size_t(std::min(std::max(r.lo, 0L), last))];
    return any.kind == Cell::Lost ? Cell{} : any;
  }
  if (r.lo < 0 || r.hi > last) irregular("an index leaves its array for some numbers of the loops");
  const long step = divisor(at);
  std::vector<Node *> nodes;
  const Cell &first = cells[size_t(r.lo)];
  bool same = true, allNumbers = true;
  for (long i = r.lo; i <= r.hi; i += step) {
    const Cell &c = cells[size_t(i)];
    same = same && c.same(first);
    allNumbers = allNumbers && c.kind == Cell::Number;
    nodes.push_back(c.node);
  }
  if (same) return first;
  if (!allNumbers) irregular("the elements of '" + objects_[size_t(object)].text + "' are not alike");
  Node *distance = graph_.integerOp("-", at, graph_.integer(r.lo));
  auto terms = distance->terms;
  for (auto &term : terms) term.second /= step;
  Node *number = graph_.affine(distance->offset / step, std::move(terms));
  Node *node = uniform(nodes, number);
  if (!node) node = graph_.read(snapshot(nodes, objects_[size_t(object)].text), number);
  return {Cell::Number, node, nullptr};
}

// The node that is nodes[number] for each number; null where there is none without an array.
Node *Tracer::uniform(const std::vector<Node *> &nodes, Node *number) {
  Node *first = nodes[0];
  bool same = true, alike = true;
  for (Node *n : nodes) {
    same = same && n == first;
    alike = alike && n->op == first->op && n->slot == first->slot && n->array == first->array && n->args.size() == first->args.size();
  }
  if (same) return first;
  if (!alike) return nullptr;
  if (first->op == Node::Affine) {
    Node *step = graph_.integerOp("-", nodes[1], first);
    for (size_t i = 1; i < nodes.size(); ++i)
      if (graph_.integerOp("-", nodes[i], nodes[i - 1]) != step) return nullptr;
    return step->isConstant() ? graph_.integerOp("+", first, graph_.integerOp("*", step, number)) : nullptr;
  }
  if (first->op != Node::Leaf && first->op != Node::Read) return nullptr;
  std::vector<Node *> args;
  for (size_t i = 0; i < first->args.size(); ++i) {
    std::vector<Node *> column;
    for (Node *n : nodes) column.push_back(n->args[i]);
    args.push_back(uniform(column, number));
    if (!args.back()) return nullptr;
  }
  return graph_.rebuild(first, std::move(args));
}

// An array of numbers, filled where all of them are known.
Array *Tracer::snapshot(const std::vector<Node *> &nodes, const std::string &name) {
  auto known = snapshots_.find(nodes);
  if (known != snapshots_.end()) return known->second;
  Loop *home = nullptr;
  for (Node *n : nodes) {
    if (isInteger(n)) irregular("integers of '" + name + "' are read by a loop's number");
    if (n->loop && n->loop->within(home)) home = n->loop;
  }
  if (home && home == kept_.back()->loop) irregular("the elements of '" + name + "' are not alike");
  Array *array = graph_.array(name, long(nodes.size()));
  array->home = home;
  for (size_t i = 0; i < nodes.size(); ++i) graph_.write(array, home, graph_.integer(long(i)), nodes[i]);
  return snapshots_[nodes] = array;
}

} // namespace tlgen::symbols
