// Loops.
#include "Tracer.h"

namespace tlgen::symbols {

void Tracer::execLoop(const Stmt *s) {
  const bool declares = s->init && s->init->kind == Stmt::Block;
  if (declares) {
    for (const Stmt *part : s->init->body) exec(part);
  } else {
    exec(s->init);
  }
  frames_.back().jumps.push_back({});
  unroll(s);
  std::vector<State> ends = std::move(frames_.back().jumps.back().breaks);
  frames_.back().jumps.pop_back();
  take(mergeAll(ends));
  if (declares) endScope(s->init);
}

// Iteration after iteration. Where its end depends on values of run time, all ends are merged behind it, if one is sure to come.
void Tracer::unroll(const Stmt *s) {
  int forks = 0;
  for (bool tested = s->kind != Stmt::DoWhile; state_.live; tested = true) {
    Node *condition = tested && s->expr ? truth(s->expr) : graph_.integer(1);
    std::vector<State> &ends = frames_.back().jumps.back().breaks;
    if (!condition->isConstant()) {
      if (++forks > maxForks) endless(s, condition);
      const Path *on = under(condition);
      ends.push_back(state_);
      ends.back().path = under(graph_.logicalNot(condition));
      take(on);
    } else if (!condition->offset) {
      ends.push_back(state_);
      state_.live = false;
      return;
    }
    round(s);
  }
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

} // namespace tlgen::symbols
