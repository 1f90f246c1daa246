// Model functions, statements and calls.
#include "Trace.h"
#include "Tracer.h"

#include <algorithm>

namespace tlgen {

const char *const TRACE_PARAMS = "p";

Traced trace(Graph &graph, const Program &program, const Model &model, const ModelFunction &function, const TraceOptions &options) {
  const Guard *guard = graph.guard;
  graph.guard = nullptr;
  auto run = [&](const TraceOptions &o) { return symbols::Tracer(graph, program, model, o).run(function); };
  Traced result;
  if (!options.keepLoops) {
    result = run(options);
  } else {
    try {
      result = run(options);
    } catch (const Unsuitable &kept) {
      if (kept.large) throw;
      TraceOptions unrolled = options; // what a kept loop leaves may be less than is needed
      unrolled.keepLoops = false;
      result = run(unrolled);
    }
  }
  graph.guard = guard;
  return result;
}

namespace symbols {

Traced Tracer::run(const ModelFunction &f) {
  state_.live = true;
  take(nullptr);
  at(f.function->loc);
  frames_.assign(1, {});
  auto dof = options_.sizes.find(model_.dof.member);
  dof_ = model_.dof.member.empty() ? model_.dof.value : dof != options_.sizes.end() ? dof->second : -1;
  std::vector<Cells> args;
  int out = Pointer::null;
  for (size_t i = 0; i < f.args.size(); ++i) {
    args.push_back(argument(f, i));
    if (f.args[i].role == ArgRole::Out) out = args.back()[0].pointer->object;
  }
  runBody(f.function, args);
  Traced result;
  result.assigned = assigned_;
  result.unrolled = unrolled_;
  if (!state_.live) unsuitable("the function never returns");
  int values = out != Pointer::null ? out : frames_.back().result; // what is returned beside results is a status
  if (isScalar(f.role))
    result.value = resultCell(values, 0);
  else
    result.rows = rows(values, f.function->name);
  return result;
}

long Tracer::count(const Count &c) const {
  if (c.member.empty()) return c.value;
  auto size = options_.sizes.find(c.member);
  if (size == options_.sizes.end()) unsuitable("the value of '" + c.member + "' is not known");
  return size->second;
}

// An array of coordinates is an input, that of results an object of its own; of a force it is zero before.
Cells Tracer::argument(const ModelFunction &f, size_t i) {
  const Arg &arg = f.args[i];
  const Variable *param = f.function->params[i];
  Object o;
  o.text = param->name;
  o.type = param->type->kind == Type::Pointer ? param->type->element : param->type;
  switch (arg.role) {
  case ArgRole::T:
  case ArgRole::Q:
  case ArgRole::Qd: {
    Slot s;
    s.kind = o.slot = arg.role == ArgRole::T ? Slot::T : arg.role == ArgRole::Q ? Slot::Q : Slot::Qd;
    if (arg.role == ArgRole::T) return {{Cell::Number, graph_.leaf(graph_.slot(s)), nullptr}};
    if (arg.index >= 0) return {{Cell::Number, graph_.leaf(graph_.slot(s), {graph_.integer(arg.index)}), nullptr}};
    o.kind = Object::Coordinates;
    o.unbounded = true;
    break;
  }
  case ArgRole::Params:
    o.kind = Object::Parameters;
    o.text = TRACE_PARAMS;
    break;
  case ArgRole::Out: {
    bool force = f.role == Role::Force;
    long length = count(force ? model_.dof : f.rows);
    Cell zero{Cell::Number, graph_.number(0), nullptr};
    int id = newObject(std::move(o));
    store(id, Cells(size_t(length), force ? zero : Cell{}));
    return {{Cell::Address, nullptr, to(id)}};
  }
  }
  return {{Cell::Address, nullptr, to(newObject(std::move(o)))}};
}

// What the function left in a place of its results.
Node *Tracer::resultCell(int object, size_t i) {
  const Cell &c = state_.objects.at(object)->at(i);
  if (c.kind != Cell::Number) unsuitable("not every path writes row " + std::to_string(i) + " of the result");
  return c.node;
}

// The array whose elements the cells are, in order; null where there is none.
static Array *wholeArray(const Cells &cells) {
  Array *array = cells.empty() || cells[0].kind != Cell::Number ? nullptr : cells[0].node->array;
  if (!array || array->length != long(cells.size())) return nullptr;
  for (size_t i = 0; i < cells.size(); ++i) {
    const Node *n = cells[i].kind == Cell::Number ? cells[i].node : nullptr;
    if (!n || n->op != Node::Read || n->array != array || !n->args[0]->isConstant() || n->args[0]->offset != long(i)) return nullptr;
  }
  return array;
}

// The results as an array.
Array *Tracer::rows(int object, const std::string &name) {
  const size_t length = state_.objects.at(object)->size();
  if (Array *whole = wholeArray(*state_.objects.at(object))) return whole;
  Array *array = graph_.array(name, long(length));
  for (size_t i = 0; i < length; ++i) {
    Node *value = resultCell(object, i);
    graph_.write(array, nullptr, graph_.integer(long(i)), value);
  }
  return array;
}

// Calls

void Tracer::runBody(const Function *f, const std::vector<Cells> &args) {
  const Path *before = state_.path;
  frames_.push_back({});
  const size_t depth = frames_.size();
  if (depth > maxDepth) unsuitable("calls are nested too deep: what ends them depends on values of run time");
  frames_.back().result = object(depth, f, f->name, f->result);
  for (size_t i = 0; i < f->params.size(); ++i) store(object(depth, f->params[i], f->params[i]->name, f->params[i]->type), args[i]);
  exec(f->body);
  std::vector<State> ends = std::move(frames_.back().returned);
  ends.push_back(std::move(state_));
  State end = mergeAll(ends);
  end.path = before; // whatever way it took
  take(std::move(end));
}

Cells Tracer::call(const Expr *e) {
  std::vector<Cells> args;
  for (const Expr *arg : e->args) args.push_back(eval(arg));
  runBody(e->callee, args);
  at(e->loc);
  if (!state_.live) unsuitable("the call of '" + e->callee->name + "' never returns");
  Cells result(1);
  auto value = state_.objects.find(frames_.back().result);
  if (value != state_.objects.end()) result = *value->second;
  dropObjects(frames_.size());
  frames_.pop_back();
  return result;
}

// Statements

void Tracer::exec(const Stmt *s) {
  bool entry = s && (s->kind == Stmt::Label || s->kind == Stmt::Case);
  if (!s || (!state_.live && !entry)) return;
  checkSize();
  if (s->loc.line) at(s->loc);
  switch (s->kind) {
  case Stmt::Block:
    return execBlock(s);
  case Stmt::Declare:
    return declare(s->var, s->expr);
  case Stmt::Evaluate:
    eval(s->expr);
    return;
  case Stmt::If:
    return execIf(s);
  case Stmt::While:
  case Stmt::DoWhile:
  case Stmt::For:
    return execLoop(s);
  case Stmt::Switch:
    return execSwitch(s);
  case Stmt::Case:
    return execCase(s);
  case Stmt::Label: {
    std::vector<State> &jumps = frames_.back().gotos[s->label];
    jumps.push_back(std::move(state_));
    State here = mergeAll(jumps);
    jumps.clear();
    return take(std::move(here));
  }
  default:
    jump(s);
  }
}

void Tracer::execBlock(const Stmt *s) {
  for (const Stmt *part : s->body) exec(part);
  endScope(s);
}

// Frees the variables of a block.
void Tracer::endScope(const Stmt *block) {
  for (const Stmt *part : block->body)
    if (part && part->kind == Stmt::Declare && !part->var->isStatic)
      free(object(frames_.size(), part->var, part->var->name, part->var->type));
}

void Tracer::declare(const Variable *v, const Expr *init) {
  if (v->isStatic) return;
  Cells cells = init ? fill(v->type, init) : Cells(size_t(leaves(v->type)));
  if (init) name(v->name, cells);
  define(object(frames_.size(), v, v->name, v->type), std::move(cells));
}

// The jumps of this call that wait for the place where they go.
size_t Tracer::pending() const {
  const Frame &frame = frames_.back();
  size_t n = frame.returned.size();
  for (auto &label : frame.gotos) n += label.second.size();
  for (const Jumps &around : frame.jumps) n += around.breaks.size() + around.continues.size();
  return n;
}

void Tracer::execIf(const Stmt *s) {
  if (s->expr->kind == Expr::Binary && hasEffects(s->expr)) {
    const Path *before = state_.path;
    const size_t jumps = pending();
    State yes, no;
    decide(s->expr, yes, no);
    take(yes);
    exec(s->then);
    State after = std::move(state_);
    take(no);
    exec(s->otherwise);
    take(mergeAll({after, state_}));
    return pending() == jumps ? take(before) : void();
  }
  Node *condition = truth(s->expr);
  if (condition->isConstant()) return exec(condition->offset ? s->then : s->otherwise);
  branch(condition, [&] { exec(s->then); }, [&] { exec(s->otherwise); });
}

void Tracer::jump(const Stmt *s) {
  Frame &frame = frames_.back();
  if (s->kind == Stmt::Return) {
    if (s->expr) store(frame.result, s->expr->type->kind == Type::Void ? (eval(s->expr), Cells(1)) : eval(s->expr));
    frames_.back().returned.push_back(state_);
  } else if (s->kind == Stmt::Goto) {
    frame.gotos[s->label].push_back(state_);
  } else if (s->kind == Stmt::Break) {
    frame.jumps.back().breaks.push_back(state_);
  } else {
    size_t k = frame.jumps.size();
    while (frame.jumps[k - 1].isSwitch) --k;
    frame.jumps[k - 1].continues.push_back(state_);
  }
  state_.live = false;
}

// The ways into the cases are made first: one per label, each where none before it was taken.
void Tracer::execSwitch(const Stmt *s) {
  Node *selector = number(s->expr);
  std::vector<Entry> entries;
  const Stmt *otherwise = nullptr;
  for (const Stmt *label : s->then->body) {
    if (label->kind != Stmt::Case) continue;
    if (!label->expr) otherwise = label;
    if (!label->expr || !state_.live) continue;
    Node *hit = compare("==", selector, number(label->expr), s->expr->type);
    if (hit->isConstant() && !hit->offset) continue;
    State entry = state_;
    if (!hit->isConstant()) {
      entry.path = under(hit);
      take(under(graph_.logicalNot(hit)));
    }
    entries.push_back({label, entry});
    state_.live = !hit->isConstant();
  }
  Jumps around;
  around.isSwitch = true;
  if (otherwise && state_.live) entries.push_back({otherwise, state_});
  if (!otherwise && state_.live) around.breaks.push_back(state_);
  state_.live = false;
  frames_.back().jumps.push_back(std::move(around));
  frames_.back().switches.push_back(std::move(entries));
  execBlock(s->then);
  std::vector<State> ends = std::move(frames_.back().jumps.back().breaks);
  ends.push_back(std::move(state_));
  frames_.back().jumps.pop_back();
  frames_.back().switches.pop_back();
  take(mergeAll(ends));
}

void Tracer::execCase(const Stmt *s) {
  for (Entry &entry : frames_.back().switches.back())
    if (entry.label == s) take(mergeAll({state_, entry.state}));
}

} // namespace symbols
} // namespace tlgen
