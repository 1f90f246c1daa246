// Motion-shape coefficients of values: the rules of the algebra, on nodes.
#include "Jets.h"

namespace tlgen {

Jets::Jets(Graph &graph, std::function<LeafJet(Node *)> inputs, int powers, long columns, bool explicitColumns,
           const Analyses &analyses, const Identity &identity)
    : graph_(graph), inputs_(std::move(inputs)), powers_(powers), columns_(columns), explicit_(explicitColumns), analyses_(analyses),
      identity_(identity), tapes_(graph) {}

Row *Jets::row(const std::string &name, long count) {
  return &rows_.emplace_back(Row{int(rows_.size()), name, count, nullptr, false, true});
}

const Direction *Jets::direction(Direction d) {
  auto id = [](const Node *n) { return n ? std::to_string(n->id) : "-"; };
  std::string key = id(d.column) + " " + (d.row ? std::to_string(d.row->id) : "-") + " " + id(d.index) + " " + id(d.from) + " " +
                    id(d.bound) + " " + (d.updated ? "new" : "old");
  Direction *&known = directions_[key];
  if (!known) {
    d.id = int(allDirections_.size());
    known = &allDirections_.emplace_back(d);
  }
  return known;
}

Node *Jets::coefficient(Node *node, int power) {
  Node *known = info_[node].c[power];
  if (known) return known;
  Graph::Making making(graph_, remade(node->guard), node->loc);
  Node *made = power ? computeHigher(node, power) : computeValue(node);
  return info_[node].c[power] = made;
}

const Guard *Jets::remade(const Guard *guard) {
  return graph_.remade(guard, [this](Node *node) { return value(node); });
}

Node *Jets::computeValue(Node *node) {
  switch (node->op) {
  case Node::Number:
    return node;
  case Node::Affine: {
    Graph::Replacement by;
    for (auto &[loop, factor] : node->terms) by[loop->index] = clones_.at(loop)->index;
    return graph_.replace(node, by);
  }
  case Node::Carried:
    return node; // of a loop that is not made anew: not reached
  case Node::Final: {
    Node *in = coefficient(node->of->carried[size_t(node->which)].in, 0);
    return graph_.final(in->of, in->which);
  }
  case Node::Read: {
    const Stored &stored = stored_.at(node->array);
    Node *index = value(node->args[0]);
    return stored.taped ? tapedAt(stored, value(stored.taped), index) : graph_.read(stored.c[0], index);
  }
  default:
    break;
  }
  std::vector<Node *> args;
  for (Node *arg : node->args) args.push_back(value(arg));
  return graph_.rebuild(node, std::move(args));
}

Node *Jets::computeHigher(Node *node, int power) {
  Node *sum = graph_.number(0);
  auto plus = [&](Node *a, Node *b) { sum = graph_.add(sum, graph_.mul(a, b)); };
  auto c = [&](Node *n, int k) { return coefficient(n, k); };
  auto plusProduct = [&](Node *a, Node *b, int k) { // the part of order k in a
    Node *right = c(b, power - k);
    plus(c(a, k), right);
  };
  auto &args = node->args;
  switch (node->op) {
  case Node::Leaf: {
    LeafJet jet = inputs_(value(node));
    Node *known = power == 1 ? jet.s : jet.s2;
    return known ? known : sum;
  }
  case Node::Final: {
    Node *in = coefficient(node->of->carried[size_t(node->which)].in, power);
    return in->op == Node::Carried ? graph_.final(in->of, in->which) : in;
  }
  case Node::Read: {
    const Stored &stored = stored_.at(node->array);
    if (!stored.taped && !stored.c[power]) return sum;
    Node *index = value(args[0]);
    return stored.taped ? tapedAt(stored, c(stored.taped, power), index) : graph_.read(stored.c[power], index);
  }
  case Node::Add: {
    Node *right = c(args[1], power);
    return graph_.add(c(args[0], power), right);
  }
  case Node::Mul:
    for (int k = 0; k <= power; ++k) plusProduct(args[0], args[1], k);
    return sum;
  case Node::Recip:
    for (int k = 1; k <= power; ++k) plusProduct(args[0], node, k);
    return graph_.neg(graph_.mul(sum, c(node, 0)));
  case Node::Math:
  case Node::Taylor:
    for (size_t i = 0; i < args.size(); ++i)
      for (int k = 1; k <= power; ++k) {
        Node *x = c(args[i], k);
        if (!x->is(0)) plus(graph_.scale(double(k) / power, c(partial(node, i), power - k)), x);
      }
    return sum;
  case Node::Select: {
    Node *no = c(args[2], power), *yes = c(args[1], power);
    return graph_.select(value(args[0]), yes, no);
  }
  default:
    return sum;
  }
}

// d function / d argument: of the function's graph, and so under the function's own conditions. Integers have no derivatives, even
// where those of all that loops carry are taken for there.
Node *Jets::partial(Node *function, size_t argument) {
  Graph::Making making(graph_, function->guard, function->loc);
  Node *made = derivative(graph_, function, argument);
  if (!made && !isInteger(function->args[argument])) noFormula_ = function;
  return made ? made : graph_.number(0);
}

const Tangents &Jets::tangents(Node *node, int power) {
  if (!info_[node].known[power]) {
    Graph::Making making(graph_, remade(node->guard), node->loc);
    Tangents made = computeTangents(node, power);
    auto out = outOf_.find(node);
    if (out != outOf_.end()) made = keepUpdated(out->second.first, out->second.second, power, std::move(made));
    info_[node].t[power] = std::move(made);
    info_[node].known[power] = true;
  }
  return info_[node].t[power];
}

void Jets::accumulate(Tangents &sum, Node *factor, const Tangents &t) {
  if (factor->is(0)) return;
  for (auto &[direction, value] : t) accumulate(sum, direction, graph_.mul(factor, value));
}

void Jets::accumulate(Tangents &sum, const Direction *direction, Node *term) {
  Node *&total = sum[direction];
  total = total ? graph_.add(total, term) : term;
  if (total->is(0)) sum.erase(direction);
}

void Jets::seed(Tangents &sum, const Node *leaf, Node *column, Node *factor) {
  if (!analyses_.activity)
    seedAnywhere(sum, column, factor);
  else if (explicit_ ? !column->isConstant() : column->op != Node::Affine)
    unsuitable_ = leaf;
  else
    sum[this->column(column)] = factor;
}

// In all columns: factor times a row of the identity.
void Jets::seedAnywhere(Tangents &sum, Node *column, Node *factor) {
  if (!explicit_) {
    if (!identityRow_)
      identityRow_ = &rows_.emplace_back(Row{int(rows_.size()), identity_.name, columns_, nullptr, false, false, identity_.stride});
    sum[direction({0, nullptr, identityRow_, column, nullptr, false})] = factor;
    return;
  }
  Slot table;
  table.kind = Slot::Member;
  table.text = identity_.name + "[%*" + std::to_string(identity_.stride) + " + %]";
  const Slot *slot = graph_.slot(table);
  for (long j = 0; j < columns_; ++j)
    sum[this->column(graph_.integer(j))] = graph_.mul(factor, graph_.leaf(slot, {column, graph_.integer(j)}));
}

Tangents Jets::computeTangents(Node *node, int power) {
  Tangents sum;
  auto &args = node->args;
  Node *one = graph_.number(1);
  switch (node->op) {
  case Node::Leaf:
    for (auto &[column, factor] : inputs_(value(node)).tangents[power]) seed(sum, node, column, factor);
    return sum;
  case Node::Final:
    return finalTangents(node, power);
  case Node::Read:
    return readTangents(node, power);
  case Node::Add:
    accumulate(sum, one, tangents(args[0], power));
    accumulate(sum, one, tangents(args[1], power));
    return sum;
  case Node::Mul:
    for (int k = 0; k <= power; ++k) {
      for (size_t i = 0; i < 2; ++i) {
        const Tangents &other = tangents(args[1 - i], power - k);
        accumulate(sum, coefficient(args[i], k), other);
      }
    }
    return sum;
  case Node::Recip:
    for (int k = 0; k <= power; ++k) {
      Node *square = graph_.number(0);
      const Tangents &x = tangents(args[0], power - k);
      if (x.empty()) continue;
      for (int i = 0; i <= k; ++i) {
        Node *right = coefficient(node, k - i);
        square = graph_.add(square, graph_.mul(coefficient(node, i), right));
      }
      accumulate(sum, graph_.neg(square), x);
    }
    return sum;
  case Node::Math:
  case Node::Taylor:
    for (size_t i = 0; i < args.size(); ++i)
      for (int k = 0; k <= power; ++k) {
        const Tangents &x = tangents(args[i], power - k);
        if (!x.empty()) accumulate(sum, coefficient(partial(node, i), k), x);
      }
    return sum;
  case Node::Select: {
    const Tangents &a = tangents(args[1], power), &b = tangents(args[2], power);
    Node *condition = value(args[0]);
    for (const Tangents *t : {&a, &b})
      for (auto &[direction, factor] : *t) {
        Node *no = number(args[2], power, direction), *yes = number(args[1], power, direction);
        sum[direction] = graph_.select(condition, yes, no);
      }
    return sum;
  }
  default:
    return sum;
  }
}

// What is done once the carried values' coefficients are known.
Tangents Jets::finalTangents(Node *node, int power) {
  Node *in = node->of->carried[size_t(node->which)].in;
  Tangents sum;
  for (auto &[direction, value] : tangents(in, power))
    sum[direction] = value->op == Node::Carried ? graph_.final(value->of, value->which) : value;
  return sum;
}

Tangents Jets::readTangents(Node *node, int power) {
  Tangents sum;
  const Stored &stored = stored_.at(node->array);
  Node *index = value(node->args[0]);
  auto here = [&](Node *ofIteration) {
    if (!ofIteration || !stored.loop) return ofIteration;
    Graph::Replacement by = {{stored.loop->index, index}};
    return graph_.replace(ofIteration, by);
  };
  for (const Part &part : stored.parts[power]) {
    const Direction *d =
        part.column ? this->column(here(part.column)) : direction({0, nullptr, part.row, nullptr, here(part.bound), false});
    accumulate(sum, d, tapedAt(stored, part.factor, index));
  }
  for (auto &[column, array] : stored.columns[power]) sum[this->column(here(column))] = graph_.read(array, index);
  Node *bound = here(stored.bound[power]);
  if (stored.rows[power]) sum[direction({0, nullptr, stored.rows[power], index, bound, false})] = graph_.number(1);
  if (stored.wide[power])
    for (long j = 0; j < columns_; ++j) sum[column(graph_.integer(j))] = graph_.read(stored.wide[power], wideIndex(index, j));
  return sum;
}

// What has a value in each iteration of the loop that fills the tape, as it was in one of them.
Node *Jets::tapedAt(const Stored &stored, Node *ofIteration, Node *index) {
  Graph::Replacement &there = taped_[{stored.loop, index}];
  there[stored.loop->index] = index;
  return tapes_.at(ofIteration, there);
}

Node *Jets::wideIndex(Node *index, long column) {
  Node *offset = graph_.integer(column), *row = graph_.integerOp("*", index, graph_.integer(columns_));
  return graph_.integerOp("+", row, offset);
}

} // namespace tlgen
