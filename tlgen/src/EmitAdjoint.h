// The adjoint emitter: a model's motion at one size as C functions, one for each need of the runtime.
//
// What each function computes is said in eom/motion.h; how it follows from the model, in Needs.h.
#ifndef TLGEN_EMITADJOINT_H
#define TLGEN_EMITADJOINT_H

#include "Analyses.h"
#include "Diagnostics.h"
#include "FormCost.h"

#include <map>

namespace tlgen {

// Registers: straight-line code on scalars. Rows: loops kept, tangents as rows in memory. Auto: by need and size.
enum class Form { Auto, Registers, Rows };

struct MotionOptions {
  std::set<std::string> needs;         // of allNeeds()
  std::map<std::string, long> sizes;   // integer members of the parameter struct, known when code is generated
  std::vector<std::string> parameters; // members to differentiate by
  Form form = Form::Auto;
  Analyses analyses;
  FormCost cost;            // by which auto decides
  bool lanes = false;       // the solved forms for many states at once too
  bool reportAsCsv = false; // not as a table
};

const std::vector<std::string> &allNeeds();

// The first line of a report as comma-separated values.
std::string reportHeader();

struct MotionText {
  long n = 0, m1 = 0, m2 = 0, work = 0; // as in eom_motion
  bool constantMass = false;
  std::map<std::string, long> sizes;  // of members of the parameter struct
  std::vector<std::string> functions; // that were printed: "simulate", "acceleration"
  std::string source;                 // functions and tables, for the model's .c file
  std::string header;                 // their declarations
  std::string report;                 // see Report.h
  bool any() const { return !source.empty(); }
};

// Empty where the model needs sizes that are not given, or is outside of what this emitter can do; then diags says why.
MotionText emitAdjoint(const Program &program, const Model &model, const MotionOptions &options, Diagnostics &diags);

} // namespace tlgen

#endif
