// The report as a table to be read, and as comma-separated values.
#include "Report.h"

#include <cstdio>

namespace tlgen {
namespace {

using Cells = std::vector<std::string>;

const size_t numbersFrom = 3; // columns before are words

Cells head() {
  return {"function",  "form",    "why",        "values",     "adds",      "products",   "repeated",   "reciprocals",
          "functions", "vectors", "iterations", "tape_bytes", "row_bytes", "work_bytes", "estimate_ns"};
}

std::string bytes(long numbers) { return std::to_string(numbers * long(sizeof(double))); }

Cells cellsOf(const ReportedForm &f) {
  const Operations &o = f.cost.operations;
  char estimate[32];
  std::snprintf(estimate, sizeof estimate, "%.0f", f.estimate);
  Cells cells = {f.function, f.rows ? "rows" : "registers", f.taken ? f.why : "not taken"};
  for (long n : {o.values, o.adds, o.products, o.repeated, o.reciprocals, o.functions, o.vectors, o.iterations})
    cells.push_back(std::to_string(n));
  for (long n : {f.cost.tape, f.cost.rows, f.cost.workspace}) cells.push_back(bytes(n));
  cells.push_back(estimate);
  return cells;
}

// Columns as wide as their widest cell; words to the left, numbers to the right.
std::string table(const std::vector<Cells> &lines, size_t words) {
  std::vector<size_t> widths(lines[0].size());
  for (const Cells &line : lines)
    for (size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  std::string s;
  for (const Cells &line : lines) {
    std::string text = " ";
    for (size_t k = 0; k < line.size(); ++k) {
      const std::string blanks(widths[k] - line[k].size(), ' ');
      text += " " + (k < words ? line[k] + blanks : blanks + line[k]);
    }
    s += text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  }
  return s;
}

std::string joined(const Cells &cells) {
  std::string s;
  for (const std::string &cell : cells) s += (s.empty() ? "" : ",") + cell;
  return s + "\n";
}

} // namespace

std::string Report::text() const {
  std::vector<Cells> functions = {head()}, classes = {{"rows of", "zero", "local", "prefix", "dense", "entries", "of"}};
  for (const ReportedForm &f : forms) functions.push_back(cellsOf(f));
  for (const ReportedMatrix &m : matrices) {
    const RowClasses &c = m.classes;
    Cells cells = {m.name};
    for (long n : {c.zero, c.local, c.prefix, c.dense, c.entries, c.all}) cells.push_back(std::to_string(n));
    classes.push_back(cells);
  }
  std::string s =
      "Motion functions of '" + model + "', one evaluation each, without the solution of M qdd = Q:\n" + table(functions, numbersFrom);
  for (const std::string &sentence : proved) s += sentence + "\n";
  return matrices.empty() ? s : s + "Where matrices can be other than zero:\n" + table(classes, 1);
}

std::string Report::csv() const {
  std::string s;
  for (const ReportedForm &f : forms) s += model + "," + joined(cellsOf(f));
  return s;
}

std::string Report::csvHeader() { return "model," + joined(head()); }

} // namespace tlgen
