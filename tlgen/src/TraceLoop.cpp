// Loops: unrolled, or kept as loops of the graph.
//
// A loop is kept where it is regular: nothing leaves it but its condition, which compares iteration numbers; integers and pointers move
// by constants; arrays are written at offsets that differ from iteration to iteration. This is found out by tracing one iteration with
// a symbol for its number, first as if nothing changed, then again with what was seen to change: integers as functions of the number,
// reals as values that iterations hand on. When nothing new is seen, that iteration is the loop. A loop whose iterations differ in a
// comparison of the number is split there. Whatever is irregular is unrolled.
#include "Tracer.h"

#include <algorithm>

namespace tlgen::symbols {
namespace {} // namespace

bool hasEffects(const Expr *e) {
  if (!e) return false;
  if (e->kind == Expr::Assign || e->kind == Expr::Step || e->kind == Expr::Call) return true;
  return std::any_of(e->args.begin(), e->args.end(), hasEffects);
}

void Tracer::execLoop(const Stmt *s) {
  const bool declares = s->init && s->init->kind == Stmt::Block;
  if (declares) {
    for (const Stmt *part : s->init->body) exec(part);
  } else {
    exec(s->init);
  }
  const Path *before = state_.path;
  const size_t jumps = pending();
  frames_.back().jumps.push_back({});
  runLoop(s);
  std::vector<State> ends = std::move(frames_.back().jumps.back().breaks);
  frames_.back().jumps.pop_back();
  take(mergeAll(ends));
  if (state_.live && pending() == jumps) take(before); // whatever way it took
  if (declares) endScope(s->init);
}

// Part by part: a part is kept or unrolled.
void Tracer::runLoop(const Stmt *s) {
  for (bool more = true; more;) {
    long limit = -1; // iterations of this part
    bool regular = options_.keepLoops;
    while (regular) {
      try {
        more = keep(s, limit);
        break;
      } catch (const Split &split) {
        if (split.level != kept_.size()) throw; // of a loop around
        limit = split.at;
        regular = limit >= options_.minTrips;
      } catch (const Unsuitable &u) {
        unrolls(s, u.why);
        regular = false;
        limit = -1;
      }
    }
    if (!regular) more = unroll(s, limit);
  }
}

// Remembers why a loop was not kept; the last reason counts.
void Tracer::unrolls(const Stmt *loop, const std::string &why) {
  auto same = [&](const Unsuitable &u) {
    return u.loc.file == loop->loc.file && u.loc.line == loop->loc.line && u.loc.column == loop->loc.column;
  };
  auto known = std::find_if(unrolled_.begin(), unrolled_.end(), same);
  if (known == unrolled_.end())
    unrolled_.push_back({why, loop->loc, false});
  else
    known->why = why;
}

// Iteration after iteration, at most limit of them (-1: all); false at the loop's end. Where that depends on values of run time, all
// ends are merged behind the loop, if one is sure to come.
bool Tracer::unroll(const Stmt *s, long limit) {
  int forks = 0;
  bool tested = s->kind != Stmt::DoWhile;
  for (long n = 0; state_.live; tested = true, ++n) {
    if (n == limit && tested == (s->kind != Stmt::DoWhile)) return true;
    if (tested && s->expr) {
      State yes, no;
      decide(s->expr, yes, no);
      if (yes.live && no.live && ++forks > maxForks) endless(s, yes.path->condition);
      if (no.live) frames_.back().jumps.back().breaks.push_back(no);
      take(yes);
      if (!state_.live) return false;
    }
    if (n == limit) return true;
    round(s);
  }
  return false;
}

void Tracer::round(const Stmt *s) {
  exec(s->then);
  std::vector<State> ends = std::move(frames_.back().jumps.back().continues);
  frames_.back().jumps.back().continues.clear();
  ends.push_back(std::move(state_));
  take(mergeAll(ends));
  if (s->step && state_.live) eval(s->step);
}

void Tracer::endless(const Stmt *s, Node *condition) {
  at(s->loc);
  unsuitable("how often the loop runs depends on " + dependence(condition));
}

// Keeping

// Keeps the next limit iterations (-1: all) as a loop; true where more are to come. Throws where they are irregular, and changes
// nothing.
bool Tracer::keep(const Stmt *s, long limit) {
  Kept mine;
  mine.before = state_;
  mine.loop = graph_.loop(kept_.empty() ? nullptr : kept_.back()->loop, limit < 0 ? nullptr : graph_.integer(limit), false);
  const std::deque<Frame> frames = frames_;
  const size_t depth = kept_.size(), assigned = assigned_.size();
  kept_.push_back(&mine);
  try {
    passes(s, mine);
    finish(mine);
    if (limit < 0 && s->kind != Stmt::DoWhile && hasEffects(s->expr)) truth(s->expr); // it fails, and the loop ends
  } catch (...) {
    splits_ = true;
    kept_.resize(depth);
    assigned_.resize(assigned);
    frames_ = frames;
    take(mine.before);
    throw;
  }
  if (limit >= 0) return true;
  frames_.back().jumps.back().breaks.push_back(state_);
  state_.live = false;
  return false;
}

void Tracer::passes(const Stmt *s, Kept &mine) {
  const std::deque<Frame> frames = frames_;
  const size_t assigned = assigned_.size();
  for (mine.pass = 0; mine.pass < maxPasses; ++mine.pass) {
    frames_ = frames;
    assigned_.resize(assigned);
    start(mine);
    const State begin = state_;
    iterate(s, mine);
    bool settled = settle(mine, begin);
    if (settled && mine.pass >= surveyed) return checkOverlaps(mine);
    if (mine.pass >= surveyed && !mine.loop->trips) irregular("the loop's condition does not end it");
  }
  irregular("what the loop changes is not found out");
}

// The state as an iteration begins.
void Tracer::start(Kept &mine) {
  take(mine.before);
  for (auto &[place, mark] : mine.cells) {
    Cells cells = *state_.objects.at(place.first);
    cells[size_t(place.second)] = mark.start;
    store(place.first, std::move(cells));
  }
  for (auto &[place, mark] : mine.elements)
    state_.elements[place.first].push_back({place.second, nullptr, kept_.size(), mark.start, nullptr});
}

void Tracer::iterate(const Stmt *s, Kept &mine) {
  const Path *path = state_.path;
  const size_t before = pending();
  if (s->kind != Stmt::DoWhile) condition(s, mine);
  round(s);
  if (s->kind == Stmt::DoWhile && state_.live) condition(s, mine);
  if (pending() != before || !state_.live || state_.path != path) irregular("something may leave the loop");
}

// The loop's condition, which holds in each iteration; as soon as it moves it says how many there are.
void Tracer::condition(const Stmt *s, Kept &mine) {
  if (!s->expr) irregular("the loop has no condition");
  const bool open = !mine.loop->trips;
  splits_ = !open; // it may fail at once for some numbers of loops around
  Node *holds = truth(s->expr);
  splits_ = true;
  if (!open) return;
  if (holds->isConstant() && !holds->offset) irregular("the loop is short");
  Node *test = holds->op == Node::Not ? holds->args[0] : holds;
  bool still =
      std::all_of(test->args.begin(), test->args.end(), [&](Node *n) { return n->op == Node::Affine && !factorOf(n, mine.loop); });
  if (still && (test->op == Node::Compare || test->isConstant())) return; // what moves is found out by this pass
  Node *trips = tripsOf(holds, mine.loop);
  if (s->kind == Stmt::DoWhile) trips = graph_.integerOp("+", trips, graph_.integer(1));
  if (trips->isConstant() && trips->offset < options_.minTrips) irregular("the loop is short");
  mine.loop->trips = trips;
}

// How often a condition on the iteration number holds, from 0 on.
Node *Tracer::tripsOf(Node *condition, const Loop *loop) {
  bool negated = condition->op == Node::Not;
  Node *test = negated ? condition->args[0] : condition;
  bool integers = test->op == Node::Compare && test->args[0]->op == Node::Affine && test->args[1]->op == Node::Affine;
  if (!integers) irregular("the loop's condition is no comparison of integers that move by constants");
  Node *d = graph_.integerOp("-", test->args[0], test->args[1]); // holds while d < 0, d <= 0, d == 0 or the opposite
  if (test->text == "==" && !negated) irregular("the loop ends at an inequality");
  if (test->text == "==") {
    if (factorOf(d, loop) < 0) d = graph_.integerOp("-", graph_.integer(0), d);
  } else {
    if (negated) d = graph_.integerOp("-", graph_.integer(0), d);
    if ((test->text == "<") == negated) d = graph_.integerOp("-", d, graph_.integer(1)); // of whole numbers: d <= 0 is d - 1 < 0
  }
  long factor = factorOf(d, loop);
  if (factor <= 0) irregular("the loop's condition does not end it");
  Graph::Replacement first = {{loop->index, graph_.integer(0)}};
  Node *begin = graph_.replace(d, first);
  if (factor == 1) return graph_.integerOp("-", graph_.integer(0), begin);
  if (!begin->isConstant() || (test->text == "==" && begin->offset % factor))
    irregular("the loop's number of iterations is no whole formula");
  return graph_.integer(begin->offset >= 0 ? 0 : (-begin->offset + factor - 1) / factor);
}

// What an iteration changed, beside what is known already; true where nothing is new.
bool Tracer::settle(Kept &mine, const State &begin) {
  bool settled = true;
  for (auto it = mine.cells.begin(); it != mine.cells.end();) {
    auto now = state_.objects.find(it->first.first);
    const Cell *cell = now == state_.objects.end() ? nullptr : &now->second->at(size_t(it->first.second));
    if (!cell || cell->same(it->second.start)) { // an iteration with other numbers changed it, this one does not
      it = mine.cells.erase(it);
      settled = false;
      continue;
    }
    settled = settle(mine, it->second, *cell) && settled;
    ++it;
  }
  for (auto &[object, first] : begin.objects) {
    auto now = state_.objects.find(object);
    if (now == state_.objects.end() || now->second == first) continue;
    if (now->second->size() != first->size()) irregular("an array of variable length changes in the loop");
    for (size_t i = 0; i < first->size(); ++i) {
      const Cell &before = (*first)[i], &after = (*now->second)[i];
      if (after.same(before) || mine.cells.count({object, long(i)})) continue;
      Mark mark = classify(mine, before, after);
      if (mark.kind == Mark::Steps && mark.step == 0) continue; // the same pointer again
      mine.cells[{object, long(i)}] = mark;
      settled = false;
    }
  }
  return settleElements(mine) && settled;
}

static bool sameNumber(const Cell &a, const Cell &b) { return a.kind == Cell::Number && b.kind == Cell::Number && a.node == b.node; }

// Whether a cell is changed as was thought.
bool Tracer::settle(Kept &mine, Mark &mark, const Cell &now) {
  if (mark.kind == Mark::Lost) return true;
  if (mark.kind == Mark::Carried && now.kind == Cell::Number && !isInteger(now.node)) {
    graph_.setOut(mark.carried, now.node);
    return true;
  }
  if (mark.kind == Mark::Steps) {
    Graph::Replacement next = {{mine.loop->index, graph_.integerOp("+", mine.loop->index, graph_.integer(1))}};
    Cell expected = substituted(mark.start, mine.loop, next.begin()->second);
    if (expected.kind == Cell::Number && sameNumber(expected, now)) return true;
    bool pointers = now.kind == Cell::Address && expected.kind == Cell::Address && !now.pointer->condition;
    if (pointers && now.pointer->object == expected.pointer->object && sameOffset(*now.pointer, *expected.pointer)) return true;
  }
  mark.kind = Mark::Lost;
  mark.start = {Cell::Lost, nullptr, nullptr};
  return false;
}

Mark Tracer::classify(Kept &mine, const Cell &start, const Cell &now) {
  Mark mark{Mark::Lost, start, {Cell::Lost, nullptr, nullptr}, 0, nullptr};
  Node *k = mine.loop->index;
  bool fromPointer = start.kind == Cell::Address && now.kind == Cell::Address && !start.pointer->condition && !now.pointer->condition;
  if (fromPointer && start.pointer->object == now.pointer->object && start.pointer->object != Pointer::null) {
    Node *before = offset(*start.pointer), *d = graph_.integerOp("-", offset(*now.pointer), before);
    if (!d->isConstant()) return mark;
    mark.kind = Mark::Steps;
    mark.step = d->offset;
    long stride = std::abs(d->offset);
    Node *index = d->offset < 0 ? graph_.integerOp("-", graph_.integer(0), k) : k;
    mark.start = start;
    if (stride) mark.start.pointer = moved(start.pointer, stride, index);
    return mark;
  }
  if (now.kind != Cell::Number || (start.kind != Cell::Number && start.kind != Cell::Unset)) return mark;
  if (start.kind == Cell::Number && start.node->op == Node::Affine && now.node->op == Node::Affine) {
    Node *d = graph_.integerOp("-", now.node, start.node);
    if (!d->isConstant()) return mark;
    mark.kind = Mark::Steps;
    mark.step = d->offset;
    mark.start = {Cell::Number, graph_.integerOp("+", start.node, graph_.integerOp("*", d, k)), nullptr};
    return mark;
  }
  bool whole = now.node->op == Node::Read && now.node->array->home == mine.loop; // an array that each iteration fills anew
  if (whole || isInteger(now.node) || (start.kind == Cell::Number && isInteger(start.node))) return mark;
  mark.kind = Mark::Carried;
  mark.carried = graph_.carry(mine.loop, start.kind == Cell::Unset ? graph_.number(0) : start.node);
  graph_.setOut(mark.carried, now.node);
  mark.start = {Cell::Number, mark.carried, nullptr};
  return mark;
}

// The same for elements: those that move with the loop are listed, the others are carried.
bool Tracer::settleElements(Kept &mine) {
  bool settled = true;
  std::map<int, std::vector<Node *>> written;
  const std::map<int, Elements> all = state_.elements;
  for (auto &[object, elements] : all) {
    if (!mine.before.objects.count(object)) continue;
    for (const Element &e : elements) {
      if (e.level != kept_.size()) continue;
      if (factorOf(e.at, mine.loop)) {
        written[object].push_back(e.at);
        continue;
      }
      if (e.over) { // each iteration writes it anew
        Range r = bounds(e.at);
        for (long i = std::max(0L, r.lo); i <= r.hi && i < long(mine.before.objects.at(object)->size()); ++i) {
          Cell before = (*mine.before.objects.at(object))[size_t(i)];
          Mark lost{Mark::Lost, before, {Cell::Lost, nullptr, nullptr}, 0, nullptr};
          settled = !mine.cells.insert({{object, i}, lost}).second && settled;
        }
        continue;
      }
      auto known = mine.elements.find({object, e.at});
      if (known != mine.elements.end()) {
        settled = settle(mine, known->second, e.cell) && settled;
        continue;
      }
      State now = state_;
      kept_.pop_back();
      state_ = mine.before;
      Cell before = element(object, e.at);
      kept_.push_back(&mine);
      state_ = std::move(now);
      mine.elements[{object, e.at}] = classify(mine, before, e.cell);
      settled = false;
    }
  }
  settled = settled && written == mine.written;
  mine.written = std::move(written);
  return settled;
}

// Two iterations never write one element.
void Tracer::checkOverlaps(const Kept &mine) {
  for (auto &[object, offsets] : mine.written)
    for (size_t i = 0; i < offsets.size(); ++i) {
      for (size_t k = 0; k < i; ++k) {
        Node *d = graph_.integerOp("-", offsets[i], offsets[k]);
        long factor = factorOf(offsets[i], mine.loop);
        bool meet = d->isConstant() ? d->offset % factor == 0 : !apart(offsets[i], offsets[k]);
        if (meet) irregular("several iterations write one element");
      }
      for (auto &[place, mark] : mine.cells)
        if (place.first == object && !apart(offsets[i], graph_.integer(place.second)))
          irregular("several iterations write one element");
    }
}

// The state behind the loop.
void Tracer::finish(Kept &mine) {
  Loop *loop = mine.loop;
  const State end = state_;
  for (auto &[place, chain] : mine.earlier) {
    Node *out = nullptr;
    for (const Element &e : end.elements.at(place.first))
      if (e.level == kept_.size() && e.at == place.second && !e.over) out = e.cell.kind == Cell::Number ? e.cell.node : nullptr;
    if (!out || isInteger(out)) irregular("integers or pointers are handed from iteration to iteration in an array");
    for (Node *carried : chain) {
      graph_.setOut(carried, out);
      out = carried;
    }
  }
  kept_.pop_back();
  take(mine.before);
  for (auto &[place, mark] : mine.cells) {
    Cells cells = *state_.objects.at(place.first);
    cells[size_t(place.second)] = after(mark, loop);
    store(place.first, std::move(cells));
  }
  for (auto &[place, mark] : mine.elements) setElement(place.first, place.second, after(mark, loop));
  for (auto &[object, offsets] : mine.written) {
    const Elements elements = end.elements.at(object);
    for (const Element &e : elements)
      if (e.level == kept_.size() + 1 && factorOf(e.at, loop)) leave(object, e, loop);
  }
}

Cell Tracer::after(const Mark &mark, const Loop *loop) {
  if (mark.kind == Mark::Carried) return {Cell::Number, graph_.final(mark.carried->of, mark.carried->which), nullptr};
  bool known = mark.kind == Mark::Steps && bounds(loop->trips).lo >= 0;
  return known ? substituted(mark.start, loop, loop->trips) : Cell{Cell::Lost, nullptr, nullptr};
}

// An element of each iteration, as it is behind the loop.
void Tracer::leave(int object, const Element &e, Loop *loop) {
  Element all = e.over ? e : tape(object, e, loop);
  all.level = kept_.size();
  Graph::Replacement first = {{loop->index, graph_.integer(0)}};
  if (e.over) first[e.over->index] = graph_.integer(0);
  Node *rest = graph_.replace(e.at, first);
  bool countable = rest->isConstant() && loop->trips->isConstant();
  if (countable) return spread(object, all, loop);
  if (e.over) irregular("an array is written by more than two loops");
  all.over = loop;
  state_.elements[object].push_back(all);
}

// Whether a number follows from iteration numbers at once.
static bool isKnown(const Node *n) {
  bool input = n->op == Node::Leaf && std::all_of(n->args.begin(), n->args.end(), [](const Node *i) { return i->op == Node::Affine; });
  return input || n->op == Node::Affine || n->op == Node::Number;
}

// The element's values in an array of their own, with an index per loop that the offset moves with.
Element Tracer::tape(int object, const Element &e, Loop *loop) {
  if (e.cell.kind != Cell::Number || isKnown(e.cell.node)) return e; // known for each number
  if (isInteger(e.cell.node)) irregular("integers are written to an array");
  Node *index = graph_.integer(0);
  long length = 1;
  Loop *home = loop;
  for (; home && factorOf(e.at, home); home = home->outer) {
    long trips = bounds(home->trips).hi;
    index = graph_.integerOp("+", index, graph_.integerOp("*", graph_.integer(length), home->index));
    if (__builtin_mul_overflow(length, trips, &length) || length > maxLeaves) irregular("an array is too large");
  }
  for (Loop *outer = home; outer; outer = outer->outer)
    if (factorOf(e.at, outer)) irregular("an array is written anew by a loop between two others");
  Array *array = graph_.array(objects_[size_t(object)].text, length);
  array->home = home;
  graph_.write(array, loop, index, e.cell.node);
  Element result = e;
  result.array = array;
  result.cell.node = graph_.read(array, index);
  return result;
}

// Cell by cell.
void Tracer::spread(int object, const Element &e, Loop *loop) {
  Cells cells = *state_.objects.at(object);
  auto set = [&](Node *at, const Cell &cell) {
    if (!at->isConstant() || at->offset < 0 || at->offset >= long(cells.size())) irregular("an index leaves its array");
    cells[size_t(at->offset)] = cell;
  };
  for (long k = 0; k < loop->trips->offset; ++k) {
    Graph::Replacement by = {{loop->index, graph_.integer(k)}};
    Node *at = graph_.replace(e.at, by);
    Cell cell = substituted(e.cell, loop, graph_.integer(k));
    if (!e.over) {
      set(at, cell);
      continue;
    }
    Node *trips = graph_.replace(e.over->trips, by);
    if (!trips->isConstant()) irregular("an array is written by more than two loops");
    for (long j = 0; j < trips->offset; ++j) {
      Graph::Replacement inner = {{e.over->index, graph_.integer(j)}};
      const Cell value = substituted(cell, e.over, graph_.integer(j));
      set(graph_.replace(at, inner), value);
    }
  }
  store(object, std::move(cells));
}

} // namespace tlgen::symbols
