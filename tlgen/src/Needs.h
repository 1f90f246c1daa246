// What each need of the runtime is made of: which derivatives of a model's functions give its numbers (DESIGN: adjoint jets).
//
// One reverse sweep of L gives the adjoints x of q and u of qd as values. Along the motion q + s qd + s^2/2 qdd their coefficients are
// the equations of motion: r = [s]u - [1]x + dD/dqd - force. Their tangents are the derivatives of these.
#ifndef TLGEN_NEEDS_H
#define TLGEN_NEEDS_H

#include "Jets.h"
#include "Reverse.h"

#include <memory>

namespace tlgen {

// A model's functions as values of one graph. Rows of the arrays are elements 0, 1, ..
struct Equations {
  long n = 0;
  Node *lagrangian = nullptr;
  Array *force = nullptr;                       // null: none
  Node *dissipation = nullptr;                  // likewise
  std::vector<Array *> holonomic, nonholonomic; // one per function
  std::vector<Node *> assigned;                 // to be computed though no result needs them
};

// The numbers of a need, by name: M Q phi phi_dot b_phi A_phi psi b_psi A_psi; r; r_y g_y; r_w g_w; r_p g_p; momentum momentum_rate
// lagrangian. Holonomic and other constraints have parts of b and A of their own. A name that is not there has no elements.
struct Results {
  std::map<std::string, Array *> arrays; // also matrices with explicit columns, row-major
  std::map<std::string, Row *> rows;     // matrices as rows in memory; columns of r_y and g_y are q_0, qd_0, q_1, qd_1, ..
  long columns = 0;                      // of the rows
  bool grouped = false;                  // products are to stay as they are
  std::vector<std::unique_ptr<Jets>> jets;

  std::vector<RowUpdate> updates() const;
  std::vector<Node *> kept() const; // computed though nothing needs them
};

// A member of the parameter struct to differentiate by: column of its first element.
struct ParameterColumns {
  const Slot *slot;
  long column;
};

class Needs {
public:
  // explicitColumns: tangents as one value per column; otherwise as rows in memory.
  Needs(Graph &graph, Equations equations, bool explicitColumns, const Analyses &analyses, const Identity &identity);

  Results energy();    // momentum, momentum_rate, lagrangian
  Results simulate();  // M (its upper triangle), Q, phi, phi_dot, b_phi, A_phi, psi, b_psi, A_psi
  Results residual();  // r
  Results linearise(); // r_y, g_y; explicit columns are q_0, q_1, .. qd_0, qd_1, ..
  Results tangent();   // r_w, g_w in one direction, a Slot::Direction of 2n elements
  Results parameters(const std::vector<ParameterColumns> &by, long columns); // r_p, g_p

  const Node *noFormula() const { return noFormula_; } // a function without a formula for its derivative, where one was met

private:
  struct Part { // of one element of a result
    Loop *loop;
    Node *index;
    Term term;
  };
  using Parts = std::vector<Part>;
  struct Target {
    Array *scalar = nullptr, *matrix = nullptr;
    Row *row = nullptr;
  };

  const Slot *slot(Slot::Kind kind, long length);
  Node *element(const Slot *slot, Node *like) { return graph_.leaf(slot, like->args); }
  const Adjoints &adjoints();
  const Adjoints &dissipationAdjoints();
  const Adjoints &constraintAdjoints(bool holonomic);
  void collect(Parts &parts, const Adjoints &adjoints, const Slot *slot, int power, double factor);
  void collect(Parts &parts, const Array *rows, int power, double factor, long offset);
  void collect(Parts &parts, const std::vector<Array *> &functions, int power, double factor, long offset);
  long rowsOf(const std::vector<Array *> &functions) const;
  Parts residualParts(bool constraintForces);
  Parts constraintParts();
  Parts summed(const Parts &parts, long count, Results &results);
  void emit(std::vector<JetOutput> &outputs, const Parts &parts, long count, Target target, bool upper);
  bool separate(const std::vector<JetOutput> &outputs, long count, std::vector<bool> &covered) const;
  Jets &jets(Results &results, std::function<LeafJet(Node *)> inputs, int powers, long columns, bool explicitColumns);
  void addScalar(Results &results, std::vector<JetOutput> &outputs, const std::string &name, const Parts &parts, long count);
  void addMatrix(Results &results, Jets &jets, std::vector<JetOutput> &outputs, const std::string &name, const Parts &parts, long count,
                 long columns, bool explicitColumns, bool upper = false);
  Results derivatives(const std::string &suffix, std::function<LeafJet(Node *)> inputs, long columns, bool explicitColumns);
  LeafJet motion(Node *leaf); // along the motion with accelerations qdd

  Graph &graph_;
  Equations equations_;
  bool explicit_;
  Analyses analyses_;
  Identity identity_;
  const Slot *q_, *qd_, *t_, *qdd_, *lambda_;
  std::unique_ptr<Adjoints> adjoints_, dissipationAdjoints_, constraintAdjoints_[2];
  const Node *noFormula_ = nullptr;
};

} // namespace tlgen

#endif
