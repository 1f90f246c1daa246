// A model's functions as the values of one graph, in one form, and what the needs make of them.
#ifndef TLGEN_MOTIONVALUES_H
#define TLGEN_MOTIONVALUES_H

#include "EmitAdjoint.h"
#include "Needs.h"
#include "Recurrences.h"
#include "Trace.h"

#include <optional>

namespace tlgen {

// The type of a member of the parameter struct that can be differentiated by, a number or an array of a constant number of them; null
// where it is none.
const Type *numberMember(const Model &model, const std::string &member);

class MotionValues {
public:
  // rows: loops are kept and tangents are rows in memory; otherwise all is straight-line. Throws Unsuitable.
  MotionValues(const Program &program, const Model &model, const MotionOptions &options, bool rows);
  // Of functions that are there as values.
  MotionValues(std::function<Equations(Graph &)> make, bool rows, const Analyses &analyses = {});

  // Of a need, or constrained: the solution of what simulate makes, or taylor: what recurrences() take of the parameters. Computed
  // once. Throws Unsuitable.
  Results &results(const std::string &need);
  // Of the accelerations; after results("taylor").
  const Recurrences &recurrences() const { return *recurrences_; }
  // Proved: no equation depends on t. The mass matrix is the same at all states (of models with simulate).
  bool autonomous = false;
  bool constantMass();

  const bool rows;
  const Analyses analyses;
  long n = 0, m1 = 0, m2 = 0;          // coordinates, holonomic and other constraint rows
  std::vector<std::string> parameters; // what is differentiated by, as in "p->mass[2]"
  Graph graph;
  Identity identity; // what tangents are seeded with, without activity

private:
  std::optional<Unsuitable> unsuitableLoop(const std::vector<Node *> &values) const;
  void addAssigned(Equations &equations, const std::vector<Node *> &assigned) const;
  void setEquations(Equations equations, const std::string &name);
  void findParameters(const Model &model, const MotionOptions &options);

  Results taylor();
  std::unique_ptr<Recurrences> recurrencesOf(const Results &simulate);
  void lookAtMultipliedOut();

  std::unique_ptr<Needs> needs_;
  Equations equations_;
  std::unique_ptr<Recurrences> recurrences_;
  std::map<std::string, Results> results_;
  std::vector<ParameterColumns> columns_;
};

} // namespace tlgen

#endif
