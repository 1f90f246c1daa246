// Ranges, and the joining of what is known on several paths.
#include "Values.h"

#include <algorithm>

namespace tlgen {

Range hull(const Range &a, const Range &b, bool widen) {
  Range h{std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
  return widen && !(h == a) ? Range{} : h;
}

static bool compute(const std::string &op, long a, long b, long &result) {
  if (op == "+") return !__builtin_add_overflow(a, b, &result);
  if (op == "-") return !__builtin_sub_overflow(a, b, &result);
  if (op == "*") return !__builtin_mul_overflow(a, b, &result);
  if (op == "/" || op == "%") {
    if (b == 0 || (a == LONG_MIN && b == -1)) return false;
    return result = op == "/" ? a / b : a % b, true;
  }
  if (op == "<<" || op == ">>") {
    if (a < 0 || b < 0 || b > 62 || (op == "<<" && a > (LONG_MAX >> b))) return false;
    return result = op == "<<" ? a << b : a >> b, true;
  }
  if (op == "&") return result = a & b, true;
  if (op == "|") return result = a | b, true;
  if (op == "^") return result = a ^ b, true;
  return false;
}

Range arithmetic(const std::string &op, const Range &a, const Range &b) {
  bool monotone = op == "+" || op == "-" || op == "*" || (op == "/" && (b.lo > 0 || b.hi < 0));
  if (op == "%" && b.lo > 0 && a.lo >= 0 && !a.exact()) return {0, std::min(a.hi, b.hi - 1)};
  if (op == "&" && b.exact() && b.lo >= 0 && !a.exact()) return {0, b.lo};
  if (a.isWhole() || b.isWhole() || (!monotone && !(a.exact() && b.exact()))) return {};
  Range r{LONG_MAX, LONG_MIN};
  for (long x : {a.lo, a.hi})
    for (long y : {b.lo, b.hi}) {
      long z = 0;
      if (!compute(op, x, y, z)) return {};
      r = {std::min(r.lo, z), std::max(r.hi, z)};
    }
  return r;
}

static Range truth(bool always, bool never) { return always ? Range::of(1) : never ? Range::of(0) : Range{0, 1}; }

Range comparison(const std::string &op, const Range &a, const Range &b) {
  if (a.isWhole() || b.isWhole()) return {0, 1};
  if (op == "<") return truth(a.hi < b.lo, a.lo >= b.hi);
  if (op == ">") return truth(a.lo > b.hi, a.hi <= b.lo);
  if (op == "<=") return truth(a.hi <= b.lo, a.lo > b.hi);
  if (op == ">=") return truth(a.lo >= b.hi, a.hi < b.lo);
  bool same = a.exact() && a == b, apart = a.hi < b.lo || b.hi < a.lo;
  return op == "==" ? truth(same, apart) : truth(apart, same);
}

Range converted(const Range &r, const Type *type) {
  const std::string &name = type->name;
  if (name.find("128") != std::string::npos) return {};
  if (name == "_Bool") return r.exact() ? Range::of(r.lo != 0) : Range{r.holds(0) ? 0 : 1, 1};
  auto has = [&](const char *word) { return name.find(word) != std::string::npos; };
  bool isUnsigned = has("unsigned");
  int bits = has("char") ? 8 : has("short") ? 16 : has("long") ? 64 : 32;
  if (bits == 64) return isUnsigned && r.lo < 0 ? Range{} : r;
  long size = 1L << bits;
  Range all = isUnsigned ? Range{0, size - 1} : Range{-size / 2, size / 2 - 1};
  if (r.lo >= all.lo && r.hi <= all.hi) return r;
  return isUnsigned && r.exact() ? Range::of(((r.lo % size) + size) % size) : all;
}

Value joined(const Value &a, const Value &b, bool widen) {
  Value v;
  v.varied = a.varied && b.varied;
  v.range = hull(a.range, b.range, widen);
  v.anywhere = a.anywhere || b.anywhere;
  if (v.anywhere) return v;
  v.targets = a.targets;
  for (const auto &t : b.targets) {
    auto [mine, isNew] = v.targets.insert(t);
    if (!isNew) mine->second = hull(mine->second, t.second, widen);
  }
  return v;
}

Value moved(const Value &pointer, const Range &leaves) {
  Value v = pointer;
  for (auto &t : v.targets) t.second = arithmetic("+", t.second, leaves);
  return v;
}

Cell joined(const Cell &a, const Cell &b, bool widen) { return {a.assigned || b.assigned, joined(a.value, b.value, widen)}; }

Object repeated(const Cells &cells, long length) {
  Object o;
  o.cells = cells;
  o.length = length;
  return o;
}

static const size_t large = 256; // leaves; beyond that each step would cost more than it can show

Object arrayOf(const Cells &element, long count) {
  long length = 0;
  if (count < 0 || __builtin_mul_overflow(count, static_cast<long>(element.size()), &length)) return repeated(element, -1);
  Cells cells;
  if (length <= static_cast<long>(large))
    for (long i = 0; i < count; ++i) cells.insert(cells.end(), element.begin(), element.end());
  return repeated(cells.empty() ? element : cells, length);
}

Object whole(Cells cells, long period) {
  long length = static_cast<long>(cells.size());
  if (cells.size() <= large || period <= 0 || length % period) return repeated(cells, length);
  size_t n = static_cast<size_t>(period);
  for (size_t i = n; i < cells.size(); ++i) cells[i % n] = joined(cells[i % n], cells[i]);
  cells.resize(n);
  return repeated(cells, length);
}

bool State::include(const State &other, bool widen) {
  if (!other.live) return false;
  if (!live) return *this = other, true;
  bool changed = false;
  reached = std::min(reached, other.reached);
  for (const auto &theirs : other.objects) {
    auto [mine, isNew] = objects.insert(theirs);
    changed |= isNew;
    if (mine->second == theirs.second) continue;
    const Object &a = *mine->second, &b = *theirs.second;
    Object both = a;
    if (a.cells.size() != b.cells.size() || a.length != b.length)
      both = repeated({Cell{}}, -1);
    else
      for (size_t i = 0; i < a.cells.size(); ++i) both.cells[i] = joined(a.cells[i], b.cells[i], widen);
    if (both.cells == a.cells && both.length == a.length) continue;
    mine->second = std::make_shared<Object>(std::move(both));
    changed = true;
  }
  return changed;
}

void State::forget() {
  for (auto &o : objects) o.second = std::make_shared<Object>(repeated(Cells(o.second->cells.size()), o.second->length));
}

} // namespace tlgen
