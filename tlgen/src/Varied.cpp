// Dependence on inputs, found out to a fixed point, since loops carry values around.
#include "Varied.h"

namespace tlgen {

bool differentiable(const Node *node) {
  switch (node->op) {
  case Node::Leaf:
  case Node::Carried:
  case Node::Final:
  case Node::Read:
  case Node::Add:
  case Node::Mul:
  case Node::Recip:
  case Node::Math:
  case Node::Taylor:
  case Node::Select:
    return true;
  default:
    return false;
  }
}

Varied::Varied(const Needed &needed, const std::set<const Slot *> &slots) : needed_(needed), slots_(slots) {
  for (bool changed = true; changed;) {
    changed = false;
    findIn(nullptr, changed);
  }
}

void Varied::findIn(const Loop *loop, bool &changed) {
  for (const Step &step : needed_.steps(loop)) {
    if (step.loop) findIn(step.loop, changed);
    if (step.node && !has(step.node) && varies(step.node)) {
      nodes_.insert(step.node);
      changed = true;
    }
  }
}

bool Varied::varies(const Node *node) const {
  if (!differentiable(node)) return false;
  if (node->op == Node::Leaf) return slots_.count(node->slot) != 0;
  if (node->op == Node::Carried || node->op == Node::Final) {
    const Carry &carry = node->of->carried[size_t(node->which)];
    return has(carry.init) || has(carry.out);
  }
  if (node->op == Node::Read) {
    for (const Write &write : node->array->writes)
      if (has(write.value)) return true;
    return false;
  }
  size_t first = node->op == Node::Select ? 1 : 0;
  for (size_t k = first; k < node->args.size(); ++k)
    if (has(node->args[k])) return true;
  return false;
}

} // namespace tlgen
