// What tlgen --report prints: what each motion function costs in which form, why it got that form, and what was proved.
#ifndef TLGEN_REPORT_H
#define TLGEN_REPORT_H

#include "MotionFunctions.h"
#include "Structure.h"

namespace tlgen {

// One function in one form.
struct ReportedForm {
  std::string function;
  bool rows, taken;
  std::string why; // of the form that was taken
  MotionFunction cost;
  double estimate; // ns
};

// A matrix of a need, in the form that was taken.
struct ReportedMatrix {
  std::string name;
  RowClasses classes;
};

struct Report {
  std::string model;
  std::vector<ReportedForm> forms;
  std::vector<ReportedMatrix> matrices;
  std::vector<std::string> proved; // sentences

  std::string text() const;
  // Lines of csvHeader()'s columns.
  std::string csv() const;
  static std::string csvHeader();
};

} // namespace tlgen

#endif
