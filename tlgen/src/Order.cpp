// Reachability and order of nodes and loops.
#include "Order.h"

#include <algorithm>
#include <tuple>

namespace tlgen {

Needed::Needed(const std::vector<Node *> &nodes) {
  for (Node *node : nodes) add(node);
  while (!todo_.empty()) {
    Node *node = todo_.back();
    todo_.pop_back();
    for (Node *arg : node->args) add(arg);
    for (auto &[loop, factor] : node->terms) add(loop);
    if (node->loop) add(node->loop);
    for (const Guard *guard = node->guard; guard; guard = guard->outer) add(guard->holds);
    if (node->op == Node::Carried || node->op == Node::Final) {
      const Carry &carry = node->of->carried[size_t(node->which)];
      add(node->of);
      carries_.insert({node->of, size_t(node->which)});
      add(carry.init);
      add(carry.in);
      add(carry.out);
    }
    if (node->op == Node::Read && arrays_.insert(node->array).second)
      for (const Write &write : node->array->writes) {
        if (write.loop) add(write.loop);
        add(write.index);
        add(write.value);
      }
  }
  std::sort(nodes_.begin(), nodes_.end(), ById());
  sort();
}

void Needed::add(Node *node) {
  if (!known_.insert(node).second) return;
  todo_.push_back(node);
  nodes_.push_back(node);
}

void Needed::add(Loop *loop) {
  if (!loops_.insert(loop).second) return;
  if (loop->outer) add(loop->outer);
  if (loop->trips) add(loop->trips);
  if (loop->condition) add(loop->condition);
}

namespace {

// A node or a loop, as a place in the order.
struct Item {
  const Node *node;
  const Loop *loop;
  const Loop *region() const { return node ? node->loop : loop->outer; }
  bool operator<(const Item &o) const {
    return std::make_tuple(node ? node->id : -1, loop ? loop->id : -1) <
           std::make_tuple(o.node ? o.node->id : -1, o.loop ? o.loop->id : -1);
  }
  bool operator==(const Item &o) const { return node == o.node && loop == o.loop; }
};

// The item as part of the region: itself, or the loop of the region that it is in.
Item within(Item item, const Loop *region) {
  while (item.region() != region) item = {nullptr, item.region()};
  return item;
}

struct Dependencies {
  std::map<Item, std::vector<Item>> of;

  void item(Item i) { of[i]; }

  // One needs the other, in the innermost region that has both.
  void add(Item user, Item used) {
    const Loop *region = user.region();
    auto contains = [&](const Loop *loop) { return !loop || (used.region() && used.region()->within(loop)); };
    if (user.loop && used.region() == user.loop) return; // part of it
    while (!contains(region)) region = region->outer;
    Item a = within(user, region), b = within(used, region);
    if (!(a == b)) of[a].push_back(b);
  }
};

} // namespace

void Needed::sort() {
  Dependencies deps;
  auto written = [&](const Item &user, const Array *array) {
    for (const Write &write : array->writes) {
      if (!write.loop) {
        deps.add(user, {write.index, nullptr});
        deps.add(user, {write.value, nullptr});
      } else if (!user.node->loop || !user.node->loop->within(write.loop)) {
        deps.add(user, {nullptr, write.loop});
      }
    }
  };
  for (const Node *node : nodes_) {
    Item user{node, nullptr};
    deps.item(user);
    for (const Node *arg : node->args) deps.add(user, {arg, nullptr});
    for (const Guard *guard = node->guard; guard; guard = guard->outer) deps.add(user, {guard->holds, nullptr});
    if (node->op == Node::Final) deps.add(user, {nullptr, node->of});
    if (node->op == Node::Read) written(user, node->array);
  }
  auto outside = [&](const Loop *loop, const Node *node) {
    if (node && !(node->loop && node->loop->within(loop))) deps.add({nullptr, loop}, {node, nullptr});
  };
  for (const Loop *loop : loops_) {
    deps.item({nullptr, loop});
    outside(loop, loop->trips);
    for (size_t k = 0; k < loop->carried.size(); ++k)
      if (has(loop, k)) {
        outside(loop, loop->carried[k].init);
        outside(loop, loop->carried[k].out);
      }
  }
  for (const Array *array : arrays_)
    for (const Write &write : array->writes)
      if (write.loop) {
        outside(write.loop, write.index);
        outside(write.loop, write.value);
      }

  // Depth first, each item after what it needs; on a stack of our own, since chains of values are long.
  std::set<Item> done;
  for (auto &[start, needs] : deps.of) {
    std::vector<std::pair<Item, size_t>> stack;
    if (done.insert(start).second) stack.push_back({start, 0});
    while (!stack.empty()) {
      Item item = stack.back().first;
      const std::vector<Item> &next = deps.of[item];
      if (stack.back().second < next.size()) {
        Item need = next[stack.back().second++];
        if (done.insert(need).second) stack.push_back({need, 0});
        continue;
      }
      steps_[item.region()].push_back({const_cast<Node *>(item.node), const_cast<Loop *>(item.loop)});
      stack.pop_back();
    }
  }
}

const std::vector<Step> &Needed::steps(const Loop *loop) const {
  static const std::vector<Step> none;
  auto known = steps_.find(loop);
  return known == steps_.end() ? none : known->second;
}

} // namespace tlgen
