// Traces a model's functions, and finds the members to differentiate by.
#include "MotionValues.h"
#include "Elimination.h"
#include "MultiplyOut.h"
#include "Order.h"
#include "Structure.h"

#include <algorithm>

namespace tlgen {

MotionValues::MotionValues(const Program &program, const Model &model, const MotionOptions &options, bool inRows)
    : rows(inRows), analyses(options.analyses) {
  graph.simplifying = analyses.algebra;
  TraceOptions how;
  how.sizes = options.sizes;
  how.keepLoops = rows;
  Equations equations;
  equations.n = model.dof.member.empty() ? model.dof.value : options.sizes.at(model.dof.member);
  for (const ModelFunction &f : model.functions) {
    Traced traced = trace(graph, program, model, f, how);
    if (f.role == Role::Lagrangian) equations.lagrangian = traced.value;
    if (f.role == Role::Dissipation) equations.dissipation = traced.value;
    if (f.role == Role::Force) equations.force = traced.rows;
    if (f.role == Role::Holonomic) equations.holonomic.push_back(traced.rows);
    if (f.role == Role::Nonholonomic) equations.nonholonomic.push_back(traced.rows);
    if (!analyses.deadCode) addAssigned(equations, traced.assigned);
  }
  findParameters(model, options);
  setEquations(std::move(equations), model.name);
}

MotionValues::MotionValues(std::function<Equations(Graph &)> make, bool inRows, const Analyses &with) : rows(inRows), analyses(with) {
  graph.simplifying = analyses.algebra;
  setEquations(make(graph), "model");
}

// Reverse and Jets take loops side by side, of a number of iterations that is known before they begin. The first one of those that the
// values need that is not so, and why.
std::optional<Unsuitable> MotionValues::unsuitableLoop(const std::vector<Node *> &values) const {
  Needed needed(values);
  for (const Loop &loop : graph.loops()) {
    if (!needed.has(&loop)) continue;
    if (!loop.trips) return Unsuitable{"how often the loop runs depends on values of run time", loop.index->loc};
    if (loop.outer) return Unsuitable{"the loop is inside of another", loop.index->loc};
  }
  return std::nullopt;
}

// What can be computed along with the results.
void MotionValues::addAssigned(Equations &equations, const std::vector<Node *> &assigned) const {
  for (Node *node : assigned)
    if (!isInteger(node) && !unsuitableLoop({node})) equations.assigned.push_back(node);
}

void MotionValues::setEquations(Equations equations, const std::string &name) {
  if (auto why = unsuitableLoop(valuesOf(equations))) throw *why;
  autonomous = analyses.time && isAutonomous(equations);
  graph.sharing = analyses.common;
  identity = {name + "_identity", padded(std::max(2 * equations.n, long(parameters.size())))};
  n = equations.n;
  for (const Array *function : equations.holonomic) m1 += function->length;
  for (const Array *function : equations.nonholonomic) m2 += function->length;
  equations_ = equations;
  needs_ = std::make_unique<Needs>(graph, std::move(equations), !rows, analyses, identity);
}

bool MotionValues::constantMass() { return analyses.constantMass && isMassConstant(results("simulate")); }

Results &MotionValues::results(const std::string &need) {
  auto known = results_.find(need);
  if (known != results_.end()) return known->second;
  if (need == "constrained") return results_.emplace(need, eliminated(graph, results("simulate"), n, m1, m2)).first->second;
  if (need == "taylor") return results_.emplace(need, taylor()).first->second;
  Results made = need == "energy"      ? needs_->energy()
                 : need == "simulate"  ? needs_->simulate()
                 : need == "residual"  ? needs_->residual()
                 : need == "linearise" ? needs_->linearise()
                 : need == "tangent"   ? needs_->tangent()
                                       : needs_->parameters(columns_, long(parameters.size()));
  auto checkFormulas = [](const Node *without) {
    if (without) throw Unsuitable{"there is no formula for the derivative of '" + without->text + "'", without->loc};
  };
  checkFormulas(needs_->noFormula());
  for (const auto &jets : made.jets) {
    checkFormulas(jets->noFormula());
    if (const Node *read = jets->unsuitable())
      throw Unsuitable{"which coordinate is read here depends on a loop or a table", read->loc};
  }
  return results_.emplace(need, std::move(made)).first->second;
}

// Of the accelerations that solve the equations.
std::unique_ptr<Recurrences> MotionValues::recurrencesOf(const Results &solved) {
  std::vector<Node *> accelerations(size_t(n), graph.number(0));
  for (const Write &write : solved.arrays.at("qdd")->writes) accelerations[size_t(write.index->offset)] = write.value;
  return std::make_unique<Recurrences>(graph, accelerations);
}

// Recurrences of another form of L where these are less work: products of series cost more than all else, and velocities in Cartesian
// coordinates hide squares that add up.
void MotionValues::lookAtMultipliedOut() {
  Equations other = equations_;
  other.lagrangian = multipliedOut(graph, other.lagrangian);
  if (!other.lagrangian || other.lagrangian == equations_.lagrangian) return;
  try {
    Needs needs(graph, std::move(other), true, analyses, identity);
    std::unique_ptr<Recurrences> made = recurrencesOf(eliminated(graph, needs.simulate(), n, m1, m2));
    if (made->pairs().size() < recurrences_->pairs().size()) recurrences_ = std::move(made);
  } catch (const Unsuitable &) { // the given form it is
  }
}

Results MotionValues::taylor() {
  if (rows) throw Unsuitable{"recurrences are straight-line code", {}};
  recurrences_ = recurrencesOf(results("constrained"));
  if (analyses.algebra) lookAtMultipliedOut();
  Results made;
  made.grouped = true;
  Array *fixed = made.arrays["fixed"] = graph.array("fixed", long(recurrences_->fixed().size()));
  for (Node *value : recurrences_->fixed()) graph.write(fixed, nullptr, graph.integer(long(fixed->writes.size())), value);
  return made;
}

const Type *numberMember(const Model &model, const std::string &member) {
  const Type *type = nullptr;
  for (const Field &field : model.params ? model.params->fields : std::vector<Field>())
    if (field.name == member) type = field.type;
  const bool array = type && type->kind == Type::Array;
  const Type *number = array ? type->element : type;
  return number && number->kind == Type::Real && !(array && type->count < 1) ? type : nullptr;
}

void MotionValues::findParameters(const Model &model, const MotionOptions &options) {
  for (const std::string &member : options.parameters) {
    const Type *type = numberMember(model, member);
    const bool array = type->kind == Type::Array;
    Slot slot;
    slot.kind = Slot::Member;
    slot.text = std::string(TRACE_PARAMS) + "->" + member + (array ? "[%]" : "");
    slot.length = array ? type->count : 1;
    columns_.push_back({graph.slot(slot), long(parameters.size())});
    for (long k = 0; k < slot.length; ++k)
      parameters.push_back(std::string(TRACE_PARAMS) + "->" + member + (array ? "[" + std::to_string(k) + "]" : ""));
  }
}

} // namespace tlgen
