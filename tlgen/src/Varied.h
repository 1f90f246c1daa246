// Activity: which values depend on elements of given inputs.
#ifndef TLGEN_VARIED_H
#define TLGEN_VARIED_H

#include "Order.h"

namespace tlgen {

// Operations that can hand a derivative on.
bool differentiable(const Node *node);

class Varied {
public:
  // Of the values that are needed, those that depend differentiably on the slots.
  Varied(const Needed &needed, const std::set<const Slot *> &slots);

  bool has(const Node *node) const { return nodes_.count(node) != 0; }

private:
  void findIn(const Loop *loop, bool &changed);
  bool varies(const Node *node) const;

  const Needed &needed_;
  const std::set<const Slot *> &slots_;
  std::unordered_set<const Node *> nodes_;
};

} // namespace tlgen

#endif
