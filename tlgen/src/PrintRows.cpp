// C for rows of tangents.
#include "PrintRows.h"

namespace tlgen {
namespace {

const long shortest = 32; // columns; loops over fewer are not divided where a row's first columns end

std::string blanks(int n) { return std::string(size_t(n), ' '); }

// A carried row that stays as it was but for single columns.
bool addsColumnsOnly(const RowUpdate &update) {
  if (update.index || !update.row->carriedBy || update.before) return false;
  bool stays = false;
  for (auto &[direction, factor] : update.sum) {
    if (!direction->row) continue;
    if (direction->row != update.row || direction->updated || !factor->is(1)) return false;
    stays = true;
  }
  return stays;
}

} // namespace

RowPrinter::RowPrinter(GraphPrinter &printer, const Schedule &schedule, long columns,
                       std::function<std::string(const std::string &)> fresh)
    : printer_(printer), schedule_(schedule), columns_(columns), fresh_(std::move(fresh)) {}

void RowPrinter::bind(const Row *row, const std::string &name, long stride) { put(row, {name, stride, false}); }

const RowPrinter::Place &RowPrinter::put(const Row *row, const Place &place) {
  rows_.push_back(row);
  return places_[row] = place;
}

const RowPrinter::Place &RowPrinter::place(const Row *row) {
  auto known = places_.find(row);
  if (known != places_.end()) return known->second;
  if (row->given) return put(row, {row->name, row->given, false});
  long stride = padded(columns_);
  if (row->count > 1) workspace_ += row->count * stride;
  return put(row, {fresh_(row->count > 1 ? "rows" : "row"), stride, true});
}

std::string RowPrinter::declarations(long offset) const {
  std::string s;
  for (const Row *row : rows_) {
    const Place &p = places_.at(row);
    if (!p.ours) continue;
    if (row->count > 1) {
      s += "  tl_real *const restrict " + p.name + " = work + " + std::to_string(offset) + ";\n";
      offset += row->count * p.stride;
    } else {
      s += "  TL_ALIGNED tl_real " + p.name + "[" + std::to_string(p.stride) + "] = {0};\n";
    }
  }
  for (const Row *row : rows_) {
    const Place &p = places_.at(row);
    if (row->summed) s += "  for (int i = 0; i < " + std::to_string(row->count * p.stride) + "; ++i) " + p.name + "[i] = TL_C(0.0);\n";
  }
  return s;
}

long RowPrinter::kept() const {
  long numbers = 0;
  for (const Row *row : rows_) numbers += places_.at(row).ours ? row->count * places_.at(row).stride : 0;
  return numbers;
}

std::string RowPrinter::at(const Row *row, const Node *which) {
  const Place &p = place(row);
  if (!which || (which->isConstant() && which->offset == 0)) return p.name;
  return "(" + p.name + " + (" + index(which) + ") * " + std::to_string(p.stride) + ")";
}

std::string RowPrinter::at(const RowUpdate &update) { return at(update.row, update.index); }

// As the left operand of a product.
std::string RowPrinter::factor(const Node *n) {
  std::string text = printer_.text(n);
  return text.find(' ') == std::string::npos ? text : "(" + text + ")";
}

// Part of a sum at column c. below: columns from there on are beyond the first columns of such rows.
std::string RowPrinter::term(const Direction *d, const Node *value, const Node *below, bool beyond) {
  std::string number;
  if (d->updated && news_.count(d->row))
    number = place(d->row).name + "_new";
  else if (!d->updated && olds_.count(d->row))
    number = place(d->row).name + "_old";
  else
    number = at(d->row, d->index) + "[c]";
  if (d->bound && d->bound == below) number = "(c < " + index(d->bound) + " ? " + number + " : TL_C(0.0))";
  if (d->from && !beyond) number = "(c < " + index(d->from) + " ? TL_C(0.0) : " + number + ")";
  if (value->is(1)) return " + " + number;
  if (value->is(-1)) return " - " + number;
  return " + " + factor(value) + " * " + number;
}

// beyond: of columns where rows that have first columns only are zero.
std::string RowPrinter::sum(const RowUpdate &update, const Node *below, bool beyond) {
  std::string s;
  for (auto &[direction, value] : update.sum)
    if (direction->row && !(beyond && direction->bound))
      s += term(direction, value, direction->bound ? direction->bound : below, beyond);
  if (s.empty()) return "TL_C(0.0)";
  return s[1] == '+' ? s.substr(3) : "-" + s.substr(3);
}

std::string RowPrinter::body(const Updates &updates, const Node *below, bool beyond, int indent) {
  std::string loads, s, in = blanks(indent);
  std::set<const Row *> written;
  olds_.clear();
  news_.clear();
  for (const RowUpdate &u : updates)
    if (!u.index && u.row->carriedBy) written.insert(u.row);
  for (const RowUpdate &u : updates)
    for (auto &[direction, value] : u.sum)
      if (direction->row && !direction->updated && written.count(direction->row) && olds_.insert(direction->row).second)
        loads += in + "const tl_real " + place(direction->row).name + "_old = " + at(direction->row, nullptr) + "[c];\n";
  for (const RowUpdate &u : updates) {
    std::string value = sum(u, below, beyond), to = at(u) + "[c]";
    if (!u.index && u.row->carriedBy && !u.before) {
      std::string name = place(u.row).name + "_new";
      if (value != place(u.row).name + "_old") {
        s += in + "const tl_real " + name + " = " + value + ";\n" + in + to + " = " + name + ";\n";
      } else { // as it was
        s += in + "const tl_real " + name + " = " + value + ";\n";
      }
      news_.insert(u.row);
    } else {
      s += in + to + (u.add ? " += " : " = ") + value + ";\n";
    }
  }
  return loads + s;
}

std::string RowPrinter::columnLoop(const std::string &from, const std::string &to, const std::string &body, int indent) {
  std::string in = blanks(indent), in2 = blanks(indent + 2);
  std::string head = in + "for (long b = " + from + "; b < " + to + "; b += TL_ROW_PAD)\n";
  return head + in2 + "TL_INDEPENDENT\n" + in2 + "for (long c = b; c < b + TL_ROW_PAD; ++c) {\n" + body + in2 + "}\n";
}

// One loop over the columns, or two where the first columns of other rows end.
std::string RowPrinter::ranges(const Updates &updates, int indent) {
  if (updates.empty()) return "";
  const Node *bound = updates[0].bound, *first = nullptr, *from = updates[0].from;
  bool several = false;
  for (const RowUpdate &u : updates) {
    if (u.bound != bound) bound = nullptr;
    if (u.from != from) from = nullptr;
    for (auto &[direction, value] : u.sum)
      if (direction->bound) {
        several = several || (first && direction->bound != first);
        first = direction->bound;
      }
  }
  std::string begin = from ? "(" + index(from) + ") / TL_ROW_PAD * TL_ROW_PAD" : "0";
  std::string end = bound ? index(bound) : std::to_string(columns_);
  if (!first || several || bound || from || columns_ <= shortest)
    return columnLoop(begin, end, body(updates, nullptr, false, indent + 4), indent);
  Updates rest;
  for (const RowUpdate &u : updates) {
    RowUpdate beyond = u;
    for (auto it = beyond.sum.begin(); it != beyond.sum.end();) it = it->first->bound ? beyond.sum.erase(it) : std::next(it);
    if (!addsColumnsOnly(beyond)) rest.push_back(beyond);
  }
  const std::string behind = columnLoop("TL_ROW(" + index(first) + ")", end, body(rest, first, true, indent + 4), indent);
  return columnLoop("0", index(first), body(updates, first, false, indent + 4), indent) + behind;
}

// Single columns, when the body's sums are done.
std::string RowPrinter::columns(const Updates &updates, int indent) {
  std::string s;
  for (const RowUpdate &u : updates)
    for (auto &[direction, value] : u.sum) {
      if (!direction->column) continue;
      std::string text = printer_.text(value);
      s += blanks(indent) + at(u) + "[" + index(direction->column) + "]" + (u.fill ? " = " : " += ") + text + ";\n";
    }
  return s;
}

std::string RowPrinter::print(const Loop *loop, bool start, int indent) {
  Updates all = schedule_.updates(loop, start), first, later;
  std::set<const Row *> changed;
  for (const RowUpdate &u : all) {
    if (addsColumnsOnly(u)) continue;
    bool upper = u.from != nullptr;
    for (auto &[direction, value] : u.sum)
      if (direction->row && !direction->updated && changed.count(direction->row)) upper = false;
    if (!u.index && u.row->carriedBy) changed.insert(u.row);
    (upper ? later : first).push_back(u);
  }
  const std::string own = columns(all, indent), upper = ranges(later, indent);
  return ranges(first, indent) + upper + own;
}

} // namespace tlgen
