// Statements, calls and the model functions.
#include "MemoryCheck.h"

#include <algorithm>

namespace tlgen {

void MemoryCheck::run() {
  for (const ModelFunction &f : model_.functions) runModel(f);
  for (const auto &f : findings_) {
    const Finding &finding = f.second;
    bool guarded = finding.reached == Reached::Perhaps && finding.id == std::string("index-range");
    if (finding.sure || (finding.always && !guarded && !over())) diags_.add(finding.id, program_, finding.loc, finding.what);
  }
}

namespace {

bool leavesArray(const Program &program, const Model &model, const std::string &member, long size) {
  Diagnostics found;
  MemoryCheck(program, model, found, {{member, size}}).run();
  return found.has("index-range");
}

} // namespace

long largestSize(const Program &program, const Model &model, const std::string &member) {
  const long mostSize = 120; // of the rounds that loops are run for
  if (!leavesArray(program, model, member, mostSize) || leavesArray(program, model, member, 0)) return 0;
  long good = 0, bad = mostSize;
  while (bad - good > 1) {
    const long middle = (good + bad) / 2;
    (leavesArray(program, model, member, middle) ? bad : good) = middle;
  }
  return good;
}

void MemoryCheck::runModel(const ModelFunction &f) {
  state_ = {};
  state_.live = true;
  frames_.assign(1, {});
  std::vector<Cells> args;
  for (size_t i = 0; i < f.args.size(); ++i) args.push_back(argument(f, i));
  runBody(f.function, args);
  if (!over())
    for (const Arg &arg : f.args) checkRows(f, arg);
}

// Every row of a constraint, and the result of a Lagrangian or dissipation function, is written on some path.
void MemoryCheck::checkRows(const ModelFunction &f, const Arg &arg) {
  if (arg.role != ArgRole::Out || f.role == Role::Force) return;
  const Object *rows = find(object(0, &arg, "", nullptr));
  if (!rows || rows->isSummary()) return;
  for (size_t i = 0; i < rows->cells.size(); ++i)
    if (!rows->cells[i].assigned)
      diags_.add("row-unwritten", program_, f.function->loc, "row " + std::to_string(i) + " of '" + f.function->name + "'");
}

// An array of coordinates or results has a length of its own; a parameter struct may be anywhere.
Cells MemoryCheck::argument(const ModelFunction &f, size_t i) {
  const Arg &arg = f.args[i];
  const Variable *param = f.function->params[i];
  Cell cell;
  cell.value.varied = arg.role != ArgRole::Params;
  if (arg.role == ArgRole::Params || param->type->kind != Type::Pointer) return {cell};
  Count count = arg.role != ArgRole::Out || f.role == Role::Force ? model_.dof : f.rows;
  cell.assigned = arg.role != ArgRole::Out || f.role == Role::Force; // the runtime sets a force's results to zero before
  int id = object(0, &arg, param->name, param->type);
  auto size = sizes_.find(count.member);
  store(id, arrayOf({cell}, count.member.empty() ? count.value : size != sizes_.end() ? size->second : -1));
  Cell pointer;
  pointer.value = Value::pointer(id, Range::of(0));
  return {pointer};
}

void MemoryCheck::runBody(const Function *f, const std::vector<Cells> &args) {
  for (size_t i = 0; i < f->params.size(); ++i) {
    const Variable *param = f->params[i];
    Cells cells = i < args.size() ? args[i] : unknown(param->type);
    store(object(frames_.size(), param, param->name, param->type), holding(std::move(cells), param->type));
  }
  Mark before = mark();
  frames_.push_back({});
  exec(f->body);
  state_.include(frames_.back().returned);
  state_.reached = before.reached; // whatever way it took
}

Cells MemoryCheck::call(const Expr *e) {
  std::vector<Cells> args;
  for (const Expr *arg : e->args) args.push_back(eval(arg));
  if (frames_.size() > maxDepth || over()) return state_.forget(), unknown(e->type);
  State before = state_;
  size_t depth = frames_.size();
  frames_.back().call = e->loc;
  runBody(e->callee, args);
  Cells result = std::move(frames_.back().result);
  frames_.pop_back();
  if (!state_.live) { // it seems to loop for ever
    state_ = before;
    state_.forget();
    state_.reached = Reached::Perhaps;
  }
  for (auto it = state_.objects.begin(); it != state_.objects.end();)
    it = named_[static_cast<size_t>(it->first)].depth >= depth ? state_.objects.erase(it) : std::next(it);
  return result.empty() ? unknown(e->type) : result;
}

void MemoryCheck::exec(const Stmt *s) {
  bool entry = s && (s->kind == Stmt::Label || s->kind == Stmt::Case);
  if (!s || over() || (!state_.live && !entry)) return;
  ++steps_;
  switch (s->kind) {
  case Stmt::Block:
    for (const Stmt *part : s->body) exec(part);
    break;
  case Stmt::Declare:
    declare(s->var, s->expr);
    break;
  case Stmt::Evaluate:
    eval(s->expr);
    break;
  case Stmt::If:
    execIf(s);
    break;
  case Stmt::While:
  case Stmt::DoWhile:
  case Stmt::For:
    execLoop(s);
    break;
  case Stmt::Switch:
    execSwitch(s);
    break;
  case Stmt::Case:
    execCase(s);
    break;
  case Stmt::Label:
    state_.include(frames_.back().gotos[s->label]);
    break;
  default:
    jump(s);
  }
}

void MemoryCheck::declare(const Variable *v, const Expr *init) {
  if (v->isStatic) return;
  int id = object(frames_.size() - 1, v, v->name, v->type);
  if (init) return store(id, holding(fill(v->type, init), v->type));
  Range count = Range::of(1);
  const Type *t = v->type;
  for (; t->kind == Type::Array; t = t->element)
    count = arithmetic("*", count, t->length ? value(t->length).range : Range::of(t->count));
  bool known = count.exact() && count.lo > 0 && leaves(t) > 0;
  store(id, arrayOf(unknown(t, false), known ? count.lo : -1));
}

// What comes after a branch or loop is as sure as what came before, unless a jump led farther out.
void MemoryCheck::rejoin(const Mark &before, size_t level) {
  const std::vector<size_t> &jumps = frames_.back().diversion;
  bool all = std::all_of(jumps.begin() + static_cast<long>(before.jumps), jumps.end(), [&](size_t j) { return j >= level; });
  if (all) state_.reached = before.reached;
}

void MemoryCheck::doubt(const Value &condition) {
  state_.reached = std::min(state_.reached, condition.varied ? Reached::ByInputs : Reached::Perhaps);
}

void MemoryCheck::execIf(const Stmt *s) {
  Value condition = value(s->expr);
  if (!condition.range.holds(0)) return exec(s->then);
  if (condition.range == Range::of(0)) return exec(s->otherwise);
  Mark before = mark();
  doubt(condition);
  State other = state_;
  exec(s->then);
  std::swap(state_, other);
  exec(s->otherwise);
  state_.include(other);
  rejoin(before, SIZE_MAX);
}

// A jump's level is 2k to leave the k-th loop or switch, 2k + 1 to end a round of it, 0 to go farther.
void MemoryCheck::jump(const Stmt *s) {
  Frame &frame = frames_.back();
  size_t k = frame.jumps.size();
  if (s->kind == Stmt::Return) {
    Cells result = s->expr ? eval(s->expr) : Cells{};
    Frame &top = frames_.back();
    bool isFirst = top.result.size() != result.size();
    for (size_t i = 0; !isFirst && i < result.size(); ++i) result[i] = joined(result[i], top.result[i]);
    top.result = std::move(result);
    top.returned.include(state_);
    diverted(0);
  } else if (s->kind == Stmt::Goto) {
    frame.gotos[s->label].include(state_);
    diverted(0);
  } else if (s->kind == Stmt::Break) {
    frame.jumps[k - 1].breaks.include(state_);
    diverted(2 * k);
  } else {
    while (k > 1 && frame.jumps[k - 1].isSwitch) --k;
    frame.jumps[k - 1].continues.include(state_);
    diverted(2 * k + 1);
  }
  state_.live = false;
}

void MemoryCheck::execSwitch(const Stmt *s) {
  Mark before = mark();
  Choice choice;
  choice.selector = value(s->expr);
  choice.entry = state_;
  bool hasDefault = false;
  for (const Stmt *part : s->then->body) {
    if (part->kind != Stmt::Case) continue;
    hasDefault |= !part->expr;
    choice.known |= part->expr && choice.selector.range.exact() && value(part->expr).range == choice.selector.range;
  }
  frames_.back().jumps.push_back({});
  frames_.back().jumps.back().isSwitch = true;
  frames_.back().choices.push_back(choice);
  state_.live = false;
  for (const Stmt *part : s->then->body) exec(part);
  if (!hasDefault && !choice.known) state_.include(choice.entry);
  state_.include(frames_.back().jumps.back().breaks);
  size_t k = frames_.back().jumps.size();
  frames_.back().jumps.pop_back();
  frames_.back().choices.pop_back();
  rejoin(before, 2 * k);
}

void MemoryCheck::execCase(const Stmt *s) {
  const Choice &choice = frames_.back().choices.back();
  State entry = choice.entry;
  const Range &selector = choice.selector.range;
  if (!s->expr) {
    if (choice.known) return;
    if (!selector.exact()) entry.reached = Reached::Perhaps;
  } else {
    std::swap(entry, state_);
    Range label = value(s->expr).range;
    std::swap(entry, state_);
    if (selector.exact() && label.exact() && !(selector == label)) return;
    if (!selector.exact()) entry.reached = Reached::Perhaps;
  }
  state_.include(entry);
}

void MemoryCheck::execLoop(const Stmt *s) {
  exec(s->init);
  Mark before = mark();
  frames_.back().jumps.push_back({});
  State exit;
  bool tested = s->kind != Stmt::DoWhile;
  long until = steps_ + maxLoopSteps;
  for (int n = 0; state_.live && n < maxRounds && steps_ < until; ++n, tested = true) {
    if (tested && s->expr) {
      State untested = state_;
      Range condition = value(s->expr).range;
      if (condition == Range::of(0)) {
        exit = std::move(state_);
        state_.live = false;
        break;
      }
      if (condition.holds(0)) {
        state_ = std::move(untested);
        break;
      }
    }
    round(s);
  }
  if (state_.live) joinRounds(s, exit);
  state_ = std::move(exit);
  state_.include(frames_.back().jumps.back().breaks);
  size_t k = frames_.back().jumps.size();
  frames_.back().jumps.pop_back();
  rejoin(before, 2 * k);
}

// All further rounds at once.
void MemoryCheck::joinRounds(const Stmt *s, State &exit) {
  for (State head = state_;;) {
    state_ = head;
    Range condition = s->expr ? value(s->expr).range : Range::of(1);
    if (condition.holds(0)) exit.include(state_);
    if (condition == Range::of(0) || over()) return;
    state_.reached = Reached::Perhaps;
    round(s);
    if (!head.include(state_, true)) return;
  }
}

void MemoryCheck::round(const Stmt *s) {
  Mark before = mark();
  exec(s->then);
  Jumps &jumps = frames_.back().jumps.back();
  state_.include(jumps.continues);
  jumps.continues = {};
  rejoin(before, 2 * frames_.back().jumps.size() + 1);
  if (s->step && state_.live) eval(s->step);
}

} // namespace tlgen
