// The reverse sweep over a graph, loop by loop from the last to the first.
#include "Reverse.h"

#include "Tapes.h"
#include "Varied.h"

namespace tlgen {
namespace {

class Sweep {
public:
  Sweep(Graph &graph, const std::vector<Seed> &seeds, const std::set<const Slot *> &wanted, const Analyses &analyses)
      : graph_(graph), seeds_(seeds), analyses_(analyses), needed_(values(seeds)), varied_(needed_, wanted),
        tapes_(graph, analyses.recompute) {}

  Adjoints run() {
    Region outside{nullptr, nullptr, nullptr, {}, {}, {}};
    region_ = &outside;
    sweepRegion();
    return std::move(result_);
  }

private:
  // A loop (null: outside of all) and the one that runs it backwards.
  struct Region {
    Loop *forward, *backward;
    Region *outer;
    std::unordered_map<Node *, Node *> adjoint;    // of the forward loop's own nodes
    std::map<int, std::pair<Node *, Node *>> sums; // by number: nodes of outer loops, and what an iteration adds to their adjoints
    Graph::Replacement at;                         // nodes of the forward loops in the backward ones
  };

  static std::vector<Node *> values(const std::vector<Seed> &seeds) {
    std::vector<Node *> nodes;
    for (const Seed &seed : seeds) nodes.push_back(seed.value);
    return nodes;
  }

  // Whether the value gets an adjoint.
  bool isActive(const Node *node) const { return analyses_.activity ? varied_.has(node) : differentiable(node) && !isInteger(node); }

  void addTo(std::unordered_map<Node *, Node *> &sums, Node *node, Node *value) {
    Node *&sum = sums[node];
    sum = sum ? graph_.add(sum, value) : value;
  }

  // value is a part of the adjoint of a node of this region or one outside of it. Where the conditions that it was computed under do
  // not hold it is no part. If it may be no number there, it is left out, or the node's adjoint is one under the node's own conditions
  // only.
  void contribute(Node *to, Node *value, const Guard *under = nullptr) {
    if (!isActive(to) || value->is(0)) return;
    const bool ends = to->op == Node::Leaf || to->op == Node::Read || to->op == Node::Final; // goes where no conditions are known
    const bool covered = Graph::covers(under, to->guard), fails = covered && under && mayFail(value);
    if (!covered || (fails && ends))
      value = graph_.select(at(under->holds), value, graph_.number(0));
    else if (fails)
      conditional_.insert(to);
    if (to->loop == region_->forward) return addTo(region_->adjoint, to, value);
    auto &sum = region_->sums[to->id];
    sum = {to, sum.second ? graph_.add(sum.second, value) : value};
  }

  // Whether the value may be no number where conditions of the source do not hold.
  bool mayFail(const Node *value) {
    auto [known, isNew] = mayFail_.emplace(value, false); // no, for what comes back to itself
    if (!isNew) return known->second;
    static const std::set<Node::Op> functions = {Node::Math, Node::Recip, Node::Taylor, Node::Carried, Node::Final, Node::Read};
    bool result = value->guard && functions.count(value->op);
    for (const Node *arg : value->args) result = result || mayFail(arg);
    if (value->op == Node::Read)
      for (const Write &write : value->array->writes) result = result || mayFail(write.value);
    return mayFail_[value] = result;
  }

  // The conditions that the node's adjoint was computed under; null: it is zero where there is none.
  const Guard *conditions(Node *node) const { return conditional_.count(node) ? node->guard : nullptr; }

  // A value of the forward sweep as the backward loop sees it.
  Node *at(Node *node) { return tapes_.at(node, region_->at); }

  const Guard *guardAt(const Guard *guard) {
    return graph_.remade(guard, [this](Node *node) { return at(node); });
  }

  void sweepRegion() {
    for (const Seed &seed : seeds_)
      if (seed.value->loop == region_->forward) contribute(seed.value, at(seed.adjoint));
    if (region_->forward) sweepFixedWrites();
    const std::vector<Step> &steps = needed_.steps(region_->forward);
    for (size_t k = steps.size(); k-- > 0;)
      if (steps[k].loop)
        sweepLoop(steps[k].loop);
      else
        sweepNode(steps[k].node);
  }

  void sweepNode(Node *node) {
    if (!isActive(node)) return;
    for (const auto &[array, write] : writesOf(node))
      if (write->loop == node->loop) contributeWritten(array, *write);
    auto known = region_->adjoint.find(node);
    if (known == region_->adjoint.end() || known->second->is(0)) return;
    Node *adjoint = known->second;
    if (node->op == Node::Leaf) {
      std::vector<Node *> indices;
      for (Node *arg : node->args) indices.push_back(at(arg));
      result_.of[node->slot].push_back({region_->backward, indices, adjoint});
    } else if (node->op == Node::Read) {
      Array *&of = arrayAdjoints_[{node->array, backwardOf(node->array->home)}];
      if (!of) {
        of = graph_.array("adj_" + node->array->name, node->array->length);
        of->summed = true;
        of->home = backwardOf(node->array->home);
      }
      graph_.write(of, region_->backward, at(node->args[0]), adjoint);
    } else if (node->op != Node::Carried && node->op != Node::Final) {
      Graph::Making making(graph_, guardAt(node->guard), node->loc);
      sweepOperation(node, adjoint);
    }
  }

  // What has been read of an element goes to the value that was written there.
  void contributeWritten(const Array *array, const Write &write) {
    auto adjoint = arrayAdjoints_.find({const_cast<Array *>(array), backwardOf(array->home)});
    if (adjoint != arrayAdjoints_.end()) contribute(write.value, graph_.read(adjoint->second, at(write.index)));
  }

  // Iterations that write what does not vary in them.
  void sweepFixedWrites() {
    for (const Array &array : graph_.arrays())
      if (needed_.has(&array))
        for (const Write &write : array.writes)
          if (isFixedIn(write, region_->forward) && isActive(write.value)) contributeWritten(&array, write);
  }

  static bool isFixedIn(const Write &write, const Loop *loop) { return write.loop == loop && write.value->loop != loop; }

  Loop *backwardOf(const Loop *forward) {
    for (Region *r = region_; forward && r; r = r->outer)
      if (r->forward == forward) return r->backward;
    return nullptr;
  }

  std::vector<std::pair<Array *, const Write *>> writesOf(Node *node) {
    if (!writesKnown_) {
      for (const Array &array : graph_.arrays())
        if (needed_.has(&array))
          for (const Write &write : array.writes) writes_[write.value].push_back({const_cast<Array *>(&array), &write});
      writesKnown_ = true;
    }
    auto known = writes_.find(node);
    return known == writes_.end() ? std::vector<std::pair<Array *, const Write *>>() : known->second;
  }

  void sweepOperation(Node *node, Node *adjoint) {
    Node *zero = graph_.number(0);
    auto give = [&](Node *arg, Node *value) { contribute(arg, value, node->guard); };
    auto &args = node->args;
    switch (node->op) {
    case Node::Add:
      contribute(args[0], adjoint, conditions(node));
      contribute(args[1], adjoint, conditions(node));
      return;
    case Node::Mul:
      if (args[0] == args[1]) {
        Node *factor = at(args[0]);
        return give(args[0], graph_.mul(graph_.scale(2, adjoint), factor));
      }
      for (size_t k = 0; k < 2; ++k)
        if (isActive(args[k])) give(args[k], graph_.mul(adjoint, at(args[1 - k])));
      return;
    case Node::Recip: {
      Node *value = at(node);
      give(args[0], graph_.neg(graph_.mul(adjoint, graph_.mul(value, value))));
      return;
    }
    case Node::Select: {
      Node *condition = at(args[0]);
      contribute(args[1], graph_.select(condition, adjoint, zero), conditions(node));
      contribute(args[2], graph_.select(condition, zero, adjoint), conditions(node));
      return;
    }
    default:
      break;
    }
    for (size_t k = 0; k < args.size(); ++k) {
      if (!isActive(args[k])) continue;
      Node *partial = partialOf(node, k);
      if (!partial) {
        if (varied_.has(args[k])) result_.noFormula = node;
        continue;
      }
      give(args[k], graph_.mul(adjoint, at(partial)));
    }
  }

  // d node / d argument, of the forward sweep.
  Node *partialOf(Node *node, size_t argument) {
    Graph::Making making(graph_, node->guard, node->loc);
    return derivative(graph_, node, argument);
  }

  // Adjoints that turn out the same in every iteration are not carried: each is taken for constant until it is seen to change.
  void sweepLoop(Loop *loop) {
    if (!reachesLoop(loop)) return;
    std::vector<size_t> active;
    for (size_t k = 0; k < loop->carried.size(); ++k)
      if (needed_.has(loop, k) && isActive(loop->carried[k].in)) active.push_back(k);
    auto before = result_.of;
    auto arrays = arrayAdjoints_;
    std::map<Array *, size_t> writes;
    for (auto &[forward, adjoint] : arrays) writes[adjoint] = adjoint->writes.size();
    std::set<size_t> changing;
    while (!tryLoop(loop, active, changing)) {
      result_.of = before;
      arrayAdjoints_ = arrays;
      for (auto &[array, count] : writes) array->writes.resize(count);
    }
  }

  // Whether anything in the loop can have an adjoint: something is seeded in it, or read of it later.
  bool reachesLoop(const Loop *loop) {
    for (const Node *node : needed_.nodes())
      if (isActive(node) && node->loop && node->loop->within(loop)) return true;
    for (const Array &array : graph_.arrays())
      if (needed_.has(&array))
        for (const Write &write : array.writes)
          if (write.loop && write.loop->within(loop) && isFixedIn(write, write.loop) && isActive(write.value)) return true;
    return false;
  }

  bool tryLoop(Loop *loop, const std::vector<size_t> &active, std::set<size_t> &changing) {
    Region *outer = region_;
    Region inner{loop, nullptr, outer, {}, {}, {}};
    Node *trips = at(loop->trips);
    inner.backward = graph_.loop(outer->backward, trips, !loop->down);
    for (Region *r = &inner; r->forward; r = r->outer) inner.at[r->forward->index] = r->backward->index;
    std::map<size_t, Node *> in;
    for (size_t k : active) {
      Node *init = finalAdjoint(outer, loop, k);
      in[k] = changing.count(k) ? graph_.carry(inner.backward, init) : init;
    }
    region_ = &inner;
    for (size_t k : active) contribute(loop->carried[k].out, in[k]);
    sweepRegion();
    size_t known = changing.size();
    for (size_t k : active) {
      auto found = inner.adjoint.find(loop->carried[k].in);
      Node *out = found == inner.adjoint.end() ? graph_.number(0) : found->second;
      if (changing.count(k))
        graph_.setOut(in[k], out);
      else if (out != in[k])
        changing.insert(k);
    }
    region_ = outer;
    if (changing.size() != known) return false;
    for (size_t k : active) {
      const Carry &carry = loop->carried[k];
      Node *adjoint = changing.count(k) ? graph_.final(inner.backward, in[k]->which) : in[k];
      contribute(carry.init, adjoint, conditions(carry.in));
    }
    for (auto &[id, sum] : inner.sums) {
      Node *carried = graph_.carry(inner.backward, graph_.number(0));
      graph_.setOut(carried, graph_.add(carried, sum.second));
      contribute(sum.first, graph_.final(inner.backward, carried->which));
    }
    return true;
  }

  Node *finalAdjoint(Region *outer, Loop *loop, size_t k) {
    Node *final = graph_.final(loop, int(k));
    auto found = outer->adjoint.find(final);
    return found == outer->adjoint.end() || final->op != Node::Final ? graph_.number(0) : found->second;
  }

  Graph &graph_;
  const std::vector<Seed> &seeds_;
  const Analyses &analyses_;
  Needed needed_;
  Varied varied_;
  Region *region_ = nullptr;
  std::unordered_map<const Node *, bool> mayFail_;
  std::set<const Node *> conditional_;                          // nodes with an adjoint that may be no number without their conditions
  std::map<std::pair<Array *, Loop *>, Array *> arrayAdjoints_; // by the loop in which they are filled
  Tapes tapes_;
  std::unordered_map<Node *, std::vector<std::pair<Array *, const Write *>>> writes_;
  bool writesKnown_ = false;
  Adjoints result_;
};

} // namespace

Adjoints reverse(Graph &graph, const std::vector<Seed> &seeds, const std::set<const Slot *> &wanted, const Analyses &analyses) {
  Graph::Making making(graph, nullptr, graph.loc);
  return Sweep(graph, seeds, wanted, analyses).run();
}

} // namespace tlgen
