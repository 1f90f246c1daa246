// Frame bounds: the fixed part by the deepest chain of calls; arrays of variable length by the sum over all calls, where a length
// counts as often as in the call that has it most often.
#include "FrameBound.h"

#include <algorithm>

namespace tlgen {

std::string Bound::text() const {
  std::string s = fixed || terms.empty() ? std::to_string(fixed) : "";
  for (const std::string &t : terms) s += (s.empty() ? "" : " + ") + t;
  return s;
}

bool Bound::usesParams() const {
  return std::any_of(terms.begin(), terms.end(), [](const std::string &t) { return t.find("p->") != std::string::npos; });
}

Bound FrameBound::of(const Variant *root, const std::vector<Arg> &args) {
  Environment env;
  for (size_t i = 0; i < args.size(); ++i)
    if (args[i].role == ArgRole::Params) env[root->function->params[i]] = "p";
  return bound(root, env);
}

// The text of an expression in the model's parameters; false where it depends on anything else.
bool FrameBound::expand(const Expr *e, const Environment &env, const Frame &frame, std::string &text) const {
  std::string a, b;
  switch (e->kind) {
  case Expr::Literal:
    return text = e->text, true;
  case Expr::Ref: {
    auto known = env.find(e->var);
    if (known != env.end()) return text = known->second, true;
    auto constant = frame.constants.find(e->var);
    return constant != frame.constants.end() && constant->second->kind != Expr::InitList && expand(constant->second, env, frame, text);
  }
  case Expr::Member:
    if (!expand(e->args[0], env, frame, a)) return false;
    return text = a + (e->arrow ? "->" : ".") + e->text, true;
  case Expr::AddressOf:
    if (!expand(e->args[0], env, frame, a)) return false;
    return text = "(&" + a + ")", true;
  case Expr::Cast:
    if (!expand(e->args[0], env, frame, a)) return false;
    return text = "(" + declaration(e->type, "") + ")" + a, true;
  case Expr::Unary:
    if (!expand(e->args[0], env, frame, a)) return false;
    return text = "(" + e->text + a + ")", true;
  case Expr::Binary:
    if (!expand(e->args[0], env, frame, a) || !expand(e->args[1], env, frame, b)) return false;
    return text = "(" + a + " " + e->text + " " + b + ")", true;
  default:
    return false;
  }
}

bool FrameBound::expandLength(const Type *type, const Environment &env, const Frame &frame, std::string &text) const {
  text.clear();
  long fixed = 1;
  for (; variableLength(type); type = type->element) {
    std::string length;
    if (!type->length)
      fixed *= type->count;
    else if (!expand(type->length, env, frame, length))
      return false;
    else
      text += (text.empty() ? "" : "*") + std::string("(size_t)(") + length + ")";
  }
  fixed *= elements(type);
  if (fixed != 1) text = std::to_string(fixed) + "*" + text;
  return true;
}

Bound FrameBound::bound(const Variant *v, const Environment &env) {
  const Frame &frame = emitted_.frames.at(v);
  Bound total;
  total.fixed = frame.fixed;
  if (std::find(stack_.begin(), stack_.end(), v) != stack_.end()) return {}; // counted by its recursion's depth
  stack_.push_back(v);
  for (const Variable *array : frame.arrays) {
    std::string term;
    if (expandLength(array->type, env, frame, term))
      total.terms.push_back(term);
    else
      diags_.add("vla", program_, array->loc, "'" + array->name + "'");
  }
  long deepest = 0;
  std::vector<std::string> called;
  for (const auto &call : frame.calls) {
    Environment inner;
    for (size_t i = 0; i < call.first->args.size(); ++i) {
      std::string text;
      if (expand(call.first->args[i], env, frame, text)) inner[call.second->function->params[i]] = text;
    }
    Bound callee = bound(call.second, inner);
    deepest = std::max(deepest, callee.fixed);
    for (const std::string &t : callee.terms) {
      auto count = [&](const std::vector<std::string> &in) { return std::count(in.begin(), in.end(), t); };
      if (count(called) < count(callee.terms)) called.push_back(t);
    }
  }
  total.terms.insert(total.terms.end(), called.begin(), called.end());
  total.fixed += deepest;
  stack_.pop_back();
  auto depth = model_.recursion.find(v->function);
  bool empty = total.fixed == 0 && total.terms.empty();
  if (depth != model_.recursion.end() && !empty) { // the first call and each one inside it may take all of it
    const Count &deep = depth->second;
    std::string levels = deep.member.empty() ? std::to_string(deep.value + 1) : "((size_t)p->" + deep.member + " + 1)";
    if (deep.member.empty() && total.terms.empty())
      total.fixed *= deep.value + 1;
    else
      total = {0, {levels + "*(" + total.text() + ")"}};
  }
  return total;
}

} // namespace tlgen
