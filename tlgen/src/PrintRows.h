// C for rows of tangents: what the body of a loop does to rows in memory, all of it in one loop over columns.
#ifndef TLGEN_PRINTROWS_H
#define TLGEN_PRINTROWS_H

#include "PrintGraph.h"

namespace tlgen {

class RowPrinter {
public:
  // columns: of every row. fresh: gives a name that is not taken yet.
  RowPrinter(GraphPrinter &printer, const Schedule &schedule, long columns, std::function<std::string(const std::string &)> fresh);

  // The row, or matrix of rows, is memory of that name; its rows are stride numbers apart.
  void bind(const Row *row, const std::string &name, long stride);
  // To be given to GraphPrinter::setRows.
  std::string print(const Loop *loop, bool start, int indent);
  // Declarations that go before the first phase; the rows in caller's memory begin at work + offset. To be asked for last.
  std::string declarations(long offset) const;
  long workspace() const { return workspace_; }
  // Numbers of all rows that are not results.
  long kept() const;

private:
  struct Place {
    std::string name;
    long stride;
    bool ours; // to be declared
  };
  using Updates = std::vector<RowUpdate>;

  const Place &put(const Row *row, const Place &place);
  const Place &place(const Row *row);
  std::string at(const RowUpdate &update);
  std::string at(const Row *row, const Node *index);
  std::string index(const Node *n) { return printer_.text(n); }
  std::string factor(const Node *n);
  std::string columnLoop(const std::string &from, const std::string &to, const std::string &body, int indent);
  std::string body(const Updates &updates, const Node *below, bool beyond, int indent);
  std::string term(const Direction *d, const Node *value, const Node *below, bool beyond);
  std::string sum(const RowUpdate &update, const Node *below, bool beyond);
  std::string ranges(const Updates &updates, int indent);
  std::string columns(const Updates &updates, int indent);

  GraphPrinter &printer_;
  const Schedule &schedule_;
  long columns_;
  std::function<std::string(const std::string &)> fresh_;
  std::map<const Row *, Place> places_;
  std::vector<const Row *> rows_;     // those of places_, in the order of finding
  std::set<const Row *> olds_, news_; // rows whose content before, and after, this body's updates is in a local
  long workspace_ = 0;
};

} // namespace tlgen

#endif
