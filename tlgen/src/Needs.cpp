// The formulas of each need.
#include "Needs.h"

namespace tlgen {

std::vector<RowUpdate> Results::updates() const {
  std::vector<RowUpdate> all;
  for (const auto &part : jets) all.insert(all.end(), part->updates().begin(), part->updates().end());
  return all;
}

std::vector<Node *> Results::kept() const {
  std::vector<Node *> all;
  for (const auto &part : jets) all.insert(all.end(), part->kept().begin(), part->kept().end());
  return all;
}

Needs::Needs(Graph &graph, Equations equations, bool explicitColumns, const Analyses &analyses, const Identity &identity)
    : graph_(graph), equations_(std::move(equations)), explicit_(explicitColumns), analyses_(analyses), identity_(identity) {
  long m = rowsOf(equations_.holonomic) + rowsOf(equations_.nonholonomic);
  q_ = slot(Slot::Q, equations_.n);
  qd_ = slot(Slot::Qd, equations_.n);
  t_ = slot(Slot::T, 1);
  qdd_ = slot(Slot::Qdd, equations_.n);
  lambda_ = slot(Slot::Lambda, m);
}

const Slot *Needs::slot(Slot::Kind kind, long length) {
  Slot s;
  s.kind = kind;
  s.length = length;
  return graph_.slot(s);
}

long Needs::rowsOf(const std::vector<Array *> &functions) const {
  long rows = 0;
  for (const Array *function : functions) rows += function->length;
  return rows;
}

const Adjoints &Needs::adjoints() {
  if (!adjoints_) {
    adjoints_ = std::make_unique<Adjoints>(reverse(graph_, {{equations_.lagrangian, graph_.number(1)}}, {q_, qd_}, analyses_));
    if (adjoints_->noFormula) noFormula_ = adjoints_->noFormula;
  }
  return *adjoints_;
}

// dD/dqd, the force of dissipation with the other sign.
const Adjoints &Needs::dissipationAdjoints() {
  if (!dissipationAdjoints_) {
    dissipationAdjoints_ = std::make_unique<Adjoints>(reverse(graph_, {{equations_.dissipation, graph_.number(1)}}, {qd_}, analyses_));
    if (dissipationAdjoints_->noFormula) noFormula_ = dissipationAdjoints_->noFormula;
  }
  return *dissipationAdjoints_;
}

// The derivative of the sum of lambda times a constraint, by q for holonomic and by qd for other constraints: a part of A' lambda.
const Adjoints &Needs::constraintAdjoints(bool holonomic) {
  auto &known = constraintAdjoints_[holonomic];
  if (!known) {
    std::vector<Seed> seeds;
    long offset = holonomic ? 0 : rowsOf(equations_.holonomic);
    for (const Array *function : holonomic ? equations_.holonomic : equations_.nonholonomic) {
      for (const Write &write : function->writes)
        seeds.push_back({write.value, graph_.leaf(lambda_, {graph_.integerOp("+", graph_.integer(offset), write.index)})});
      offset += function->length;
    }
    known = std::make_unique<Adjoints>(reverse(graph_, seeds, {holonomic ? q_ : qd_}, analyses_));
    if (known->noFormula) noFormula_ = known->noFormula;
  }
  return *known;
}

void Needs::collect(Parts &parts, const Adjoints &adjoints, const Slot *of, int power, double factor) {
  auto known = adjoints.of.find(of);
  if (known == adjoints.of.end()) return;
  for (const Contribution &c : known->second) parts.push_back({c.loop, c.indices[0], {c.value, power, factor}});
}

void Needs::collect(Parts &parts, const Array *rows, int power, double factor, long offset) {
  for (const Write &write : rows->writes)
    parts.push_back({write.loop, graph_.integerOp("+", graph_.integer(offset), write.index), {write.value, power, factor}});
}

void Needs::collect(Parts &parts, const std::vector<Array *> &functions, int power, double factor, long offset) {
  for (const Array *function : functions) {
    collect(parts, function, power, factor, offset);
    offset += function->length;
  }
}

// r = M qdd - Q, minus the constraint forces where these are wanted.
Needs::Parts Needs::residualParts(bool constraintForces) {
  Parts parts;
  collect(parts, adjoints(), qd_, 1, 1);
  collect(parts, adjoints(), q_, 0, -1);
  if (equations_.force) collect(parts, equations_.force, 0, -1, 0);
  if (equations_.dissipation) collect(parts, dissipationAdjoints(), qd_, 0, 1);
  if (constraintForces && !equations_.holonomic.empty()) collect(parts, constraintAdjoints(true), q_, 0, -1);
  if (constraintForces && !equations_.nonholonomic.empty()) collect(parts, constraintAdjoints(false), qd_, 0, -1);
  return parts;
}

// A qdd - b: the second derivative in time of holonomic constraints, the first of others.
Needs::Parts Needs::constraintParts() {
  Parts parts;
  collect(parts, equations_.holonomic, 2, 2, 0);
  collect(parts, equations_.nonholonomic, 1, 1, rowsOf(equations_.holonomic));
  return parts;
}

// Whether no element is written twice; covered: those that are written.
bool Needs::separate(const std::vector<JetOutput> &outputs, long count, std::vector<bool> &covered) const {
  covered.assign(size_t(count), false);
  for (const JetOutput &output : outputs) {
    const Node *index = output.index;
    const Loop *loop = output.loop;
    if (index->op != Node::Affine || index->terms.size() > 1) return false;
    if (loop && (loop->outer || !loop->trips || !loop->trips->isConstant() || index->terms.empty())) return false;
    long trips = loop ? loop->trips->offset : 1;
    for (long k = 0; k < trips; ++k) {
      long element = index->offset + (loop ? k * index->terms[0].second : 0);
      if (element < 0 || element >= count || covered[size_t(element)]) return false;
      covered[size_t(element)] = true;
    }
  }
  return true;
}

// One output for all parts of an element. Elements without parts are zero; those with parts in several places are summed.
void Needs::emit(std::vector<JetOutput> &outputs, const Parts &parts, long count, Target target, bool upper) {
  std::vector<JetOutput> mine;
  for (const Part &part : parts) {
    bool outside = part.index->isConstant() && (part.index->offset < 0 || part.index->offset >= count);
    if (outside) continue; // behind a condition that never holds
    JetOutput *same = nullptr;
    for (JetOutput &output : mine)
      if (output.loop == part.loop && output.index == part.index) same = &output;
    if (!same) same = &mine.emplace_back(JetOutput{part.loop, part.index, {}, target.scalar, target.row, target.matrix, upper});
    same->terms.push_back(part.term);
  }
  std::vector<bool> covered;
  if (separate(mine, count, covered)) {
    for (long k = 0; k < count; ++k)
      if (!covered[size_t(k)]) mine.push_back({nullptr, graph_.integer(k), {}, target.scalar, target.row, target.matrix, upper});
  } else {
    if (target.scalar) target.scalar->summed = true;
    if (target.matrix) target.matrix->summed = true;
    if (target.row) target.row->summed = true;
  }
  outputs.insert(outputs.end(), mine.begin(), mine.end());
}

Jets &Needs::jets(Results &results, std::function<LeafJet(Node *)> inputs, int powers, long columns, bool explicitColumns) {
  return *results.jets.emplace_back(
      std::make_unique<Jets>(graph_, std::move(inputs), powers, columns, explicitColumns, analyses_, identity_));
}

void Needs::addScalar(Results &results, std::vector<JetOutput> &outputs, const std::string &name, const Parts &parts, long count) {
  if (!count) return;
  Target target;
  target.scalar = results.arrays[name] = graph_.array(name, count);
  emit(outputs, parts, count, target, false);
}

void Needs::addMatrix(Results &results, Jets &jets, std::vector<JetOutput> &outputs, const std::string &name, const Parts &parts,
                      long count, long columns, bool explicitColumns, bool upper) {
  if (!count || !columns) return;
  Target target;
  if (explicitColumns)
    target.matrix = results.arrays[name] = graph_.array(name, count * columns);
  else
    target.row = results.rows[name] = jets.row(name, count);
  if (!explicitColumns) results.columns = columns;
  emit(outputs, parts, count, target, upper && analyses_.demand);
}

Results Needs::energy() {
  Results results;
  auto fixed = [](Node *) { return LeafJet(); };
  Jets &values = jets(results, fixed, 1, 0, true);
  std::vector<JetOutput> outputs;
  Parts momentum, rate;
  collect(momentum, adjoints(), qd_, 0, 1);
  collect(rate, adjoints(), q_, 0, 1);
  if (equations_.force) collect(rate, equations_.force, 0, 1, 0);
  if (equations_.dissipation) collect(rate, dissipationAdjoints(), qd_, 0, -1);
  addScalar(results, outputs, "momentum", momentum, equations_.n);
  addScalar(results, outputs, "momentum_rate", rate, equations_.n);
  addScalar(results, outputs, "lagrangian", {{nullptr, graph_.integer(0), {equations_.lagrangian, 0, 1}}}, 1);
  values.run(outputs, equations_.assigned);
  return results;
}

Results Needs::simulate() {
  Results results;
  long n = equations_.n, m1 = rowsOf(equations_.holonomic), m2 = rowsOf(equations_.nonholonomic);
  Node *one = graph_.number(1);
  // At rest in qdd: the curve q + s qd. Tangents of velocities give M and dpsi/dqd, those of coordinates dphi/dq.
  auto curve = [=](Node *leaf, Slot::Kind varied) {
    LeafJet jet;
    if (leaf->slot == q_) jet.s = element(qd_, leaf);
    if (leaf->slot == t_) jet.s = one;
    if (leaf->slot->kind == varied) jet.tangents[0].push_back({leaf->args[0], one});
    return jet;
  };
  auto velocities = [=](Node *leaf) { return curve(leaf, Slot::Qd); };
  auto coordinates = [=](Node *leaf) { return curve(leaf, Slot::Q); };
  Jets &rates = jets(results, velocities, 2, n, explicit_);
  std::vector<JetOutput> outputs;
  Parts momentum, force, psi, b;
  collect(momentum, adjoints(), qd_, 0, 1);
  collect(force, adjoints(), q_, 0, 1);
  collect(force, adjoints(), qd_, 1, -1);
  if (equations_.force) collect(force, equations_.force, 0, 1, 0);
  if (equations_.dissipation) collect(force, dissipationAdjoints(), qd_, 0, -1);
  addMatrix(results, rates, outputs, "M", momentum, n, n, explicit_, true);
  addScalar(results, outputs, "Q", force, n);
  collect(psi, equations_.nonholonomic, 0, 1, 0);
  collect(b, equations_.nonholonomic, 1, -1, 0);
  addScalar(results, outputs, "psi", psi, m2);
  addScalar(results, outputs, "b_psi", b, m2);
  addMatrix(results, rates, outputs, "A_psi", psi, m2, n, explicit_);
  rates.run(outputs, equations_.assigned);
  if (m1) {
    Jets &along = jets(results, coordinates, 3, n, explicit_);
    std::vector<JetOutput> rows;
    Parts phi, first, second;
    collect(phi, equations_.holonomic, 0, 1, 0);
    collect(first, equations_.holonomic, 1, 1, 0);
    collect(second, equations_.holonomic, 2, -2, 0);
    addScalar(results, rows, "phi", phi, m1);
    addScalar(results, rows, "phi_dot", first, m1);
    addScalar(results, rows, "b_phi", second, m1);
    addMatrix(results, along, rows, "A_phi", phi, m1, n, explicit_);
    along.run(rows);
  }
  return results;
}

LeafJet Needs::motion(Node *leaf) {
  LeafJet jet;
  if (leaf->slot == q_) {
    jet.s = element(qd_, leaf);
    jet.s2 = graph_.scale(0.5, element(qdd_, leaf));
  }
  if (leaf->slot == qd_) jet.s = element(qdd_, leaf);
  if (leaf->slot == t_) jet.s = graph_.number(1);
  return jet;
}

Results Needs::residual() {
  Results results;
  Jets &curve = jets(results, [this](Node *leaf) { return motion(leaf); }, 2, 0, true);
  std::vector<JetOutput> outputs;
  addScalar(results, outputs, "r", residualParts(false), equations_.n);
  curve.run(outputs, equations_.assigned);
  return results;
}

// The parts' sums without tangents, each as the one part of its element.
Needs::Parts Needs::summed(const Parts &parts, long count, Results &results) {
  Jets &along = jets(results, [this](Node *leaf) { return motion(leaf); }, POWERS, 0, true);
  std::vector<JetOutput> outputs;
  Array *sums = graph_.array("sums", count);
  emit(outputs, parts, count, {sums}, false);
  along.run(outputs, equations_.assigned);
  Parts made;
  collect(made, sums, 0, 1, 0);
  return made;
}

// The tangents of r - A' lambda and of A qdd - b. In straight-line code they are those of the sums, so that what cancels there has
// none.
Results Needs::derivatives(const std::string &suffix, std::function<LeafJet(Node *)> inputs, long columns, bool explicitColumns) {
  Results results;
  long n = equations_.n, m1 = rowsOf(equations_.holonomic), m = m1 + rowsOf(equations_.nonholonomic);
  Parts r = residualParts(true), g = constraintParts();
  if (explicit_) r = summed(r, n, results), g = summed(g, m, results);
  Jets &curve = jets(results, std::move(inputs), m1 ? 3 : 2, columns, explicitColumns);
  std::vector<JetOutput> outputs;
  addMatrix(results, curve, outputs, "r_" + suffix, r, n, columns, explicitColumns);
  addMatrix(results, curve, outputs, "g_" + suffix, g, m, columns, explicitColumns);
  curve.run(outputs, explicit_ ? std::vector<Node *>() : equations_.assigned);
  return results;
}

Results Needs::linearise() {
  long n = equations_.n;
  auto column = [=](Node *index, bool velocity) { // rows: interleaved, so that a coordinate's columns stand together
    Node *offset = graph_.integer(!velocity ? 0 : explicit_ ? n : 1);
    return graph_.integerOp("+", explicit_ ? index : graph_.integerOp("*", graph_.integer(2), index), offset);
  };
  Node *one = graph_.number(1);
  auto inputs = [=](Node *leaf) {
    LeafJet jet = motion(leaf);
    if (leaf->slot == q_) {
      jet.tangents[0].push_back({column(leaf->args[0], false), one});
      jet.tangents[1].push_back({column(leaf->args[0], true), one});
    }
    if (leaf->slot == qd_) jet.tangents[0].push_back({column(leaf->args[0], true), one});
    return jet;
  };
  return derivatives("y", inputs, 2 * n, explicit_);
}

Results Needs::tangent() {
  long n = equations_.n;
  const Slot *w = slot(Slot::Direction, 2 * n);
  Node *only = graph_.integer(0);
  auto inputs = [=](Node *leaf) {
    LeafJet jet = motion(leaf);
    if (leaf->slot != q_ && leaf->slot != qd_) return jet;
    Node *rate = graph_.leaf(w, {graph_.integerOp("+", leaf->args[0], graph_.integer(n))});
    if (leaf->slot == q_) {
      jet.tangents[0].push_back({only, graph_.leaf(w, {leaf->args[0]})});
      jet.tangents[1].push_back({only, rate});
    } else {
      jet.tangents[0].push_back({only, rate});
    }
    return jet;
  };
  return derivatives("w", inputs, 1, true);
}

Results Needs::parameters(const std::vector<ParameterColumns> &by, long columns) {
  Node *one = graph_.number(1);
  auto inputs = [=](Node *leaf) {
    LeafJet jet = motion(leaf);
    for (const ParameterColumns &p : by)
      if (leaf->slot == p.slot) {
        Node *column = leaf->args.empty() ? graph_.integer(0) : leaf->args[0];
        jet.tangents[0].push_back({graph_.integerOp("+", column, graph_.integer(p.column)), one});
      }
    return jet;
  };
  return derivatives("p", inputs, columns, explicit_);
}

} // namespace tlgen
