// What expressions read, write and are worth.
#include "MemoryCheck.h"
#include "PrintC.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>

namespace tlgen {

// How many numbers and pointers an object of the type holds, -1 where that is not constant or too many to follow.
long MemoryCheck::leaves(const Type *type) {
  const Type *t = type;
  long n = 1;
  for (; t->kind == Type::Array; t = t->element)
    if (t->length || __builtin_mul_overflow(n, t->count, &n)) return -1;
  if (n > maxLeaves) return -1;
  if (t->kind != Type::Struct) return n;
  long size = 0;
  for (const Field &field : t->record->fields) {
    long part = leaves(field.type);
    if (part < 0) return -1;
    size += part;
  }
  return n * size <= maxLeaves ? n * size : -1;
}

// An object with these leaves, or of unknown ones.
Object MemoryCheck::holding(Cells cells, const Type *type) {
  if (leaves(type) < 0) return repeated({Cell{}}, -1);
  return whole(std::move(cells), type->kind == Type::Array ? leaves(type->element) : 0);
}

Cells MemoryCheck::unknown(const Type *type, bool assigned) {
  Cell cell;
  cell.assigned = assigned;
  return Cells(static_cast<size_t>(type->kind == Type::Void ? 1 : std::max(1L, leaves(type))), cell);
}

static bool isAccess(const Expr *e) {
  return e->kind == Expr::Ref || e->kind == Expr::Index || e->kind == Expr::Member || e->kind == Expr::Deref;
}

Cells MemoryCheck::eval(const Expr *e) {
  ++steps_;
  if (isAccess(e)) return load(e);
  Cell cell;
  switch (e->kind) {
  case Expr::Literal:
    errno = 0;
    if (e->type->kind == Type::Integer) cell.value = Value::number(Range::of(std::strtol(e->text.c_str(), nullptr, 10)));
    if (errno) cell.value = {};
    break;
  case Expr::AddressOf:
  case Expr::Decay:
    cell.value = place(e->args[0]).pointer;
    break;
  case Expr::Unary: {
    Value x = value(e->args[0]);
    Range zero = Range::of(0);
    if (e->text == "!") cell.value.range = comparison("==", x.range, zero);
    if (e->text == "-") cell.value.range = tlgen::converted(arithmetic("-", zero, x.range), e->type);
    if (e->text == "+") cell.value.range = x.range;
    if (e->text == "~") cell.value.range = tlgen::converted(arithmetic("-", Range::of(-1), x.range), e->type);
    cell.value.varied = x.varied;
    break;
  }
  case Expr::Binary:
    cell.value = binary(e);
    break;
  case Expr::Conditional:
    return conditional(e);
  case Expr::Call:
    return call(e);
  case Expr::MathCall:
    return mathCall(e);
  case Expr::Cast: {
    if (e->type->kind == Type::Void && isAccess(e->args[0])) return place(e->args[0]), Cells{cell}; // nobody reads it
    Cells inner = eval(e->args[0]);
    if (e->type->kind == Type::Struct) return inner;
    cell.value = converted(inner[0].value, e);
    break;
  }
  case Expr::Assign:
  case Expr::Step:
    return assign(e);
  case Expr::Comma:
    eval(e->args[0]);
    return eval(e->args[1]);
  case Expr::InitList:
    return fill(e->type, e);
  default:
    for (const Expr *arg : e->args)
      if (arg) eval(arg);
    return unknown(e->type);
  }
  return {cell};
}

// The value of an lvalue. A struct may be read before all of it has values.
// Of which a member is read.
static const Record *recordOf(const Expr *member) {
  const Type *base = member->args[0]->type;
  return (member->arrow ? base->element : base)->record;
}

Cells MemoryCheck::load(const Expr *e) {
  Place p = place(e);
  Cells cells = read(p, std::max(1L, leaves(e->type)), e);
  if (e->type->kind == Type::Struct || e->type->kind == Type::Array) return cells;
  demandValue(cells[0], p, e);
  cells[0].assigned = true;
  if (e->type->kind == Type::Real) cells[0].value.range = {};
  if (e->kind == Expr::Member && recordOf(e) == model_.params)
    if (auto size = sizes_.find(e->text); size != sizes_.end()) cells[0].value.range = Range::of(size->second);
  return cells;
}

Value MemoryCheck::converted(const Value &v, const Expr *e) const {
  Value c = v;
  const Type *from = e->args[0]->type;
  bool isInteger = e->type->kind == Type::Integer && from->kind == Type::Integer;
  if (e->type->kind == Type::Pointer) return v;
  c.range = isInteger ? tlgen::converted(v.range, e->type) : Range{};
  return c;
}

// x op y of the type, where a and b are the expressions of x and y.
Value MemoryCheck::operation(const std::string &op, const Expr *a, const Value &x, const Value &y, const Type *type) {
  Value v;
  v.varied = x.varied || y.varied;
  if (type->kind == Type::Pointer) {
    bool first = a->type->kind == Type::Pointer;
    const Value &pointer = first ? x : y;
    Range size = leaves(type->element) < 0 ? Range{} : Range::of(leaves(type->element));
    Range offset = arithmetic("*", first ? y.range : x.range, size);
    return moved(pointer, op == "-" ? arithmetic("-", Range::of(0), offset) : offset);
  }
  if (type->kind == Type::Integer) v.range = tlgen::converted(arithmetic(op, x.range, y.range), type);
  return v;
}

Value MemoryCheck::binary(const Expr *e) {
  if (e->text == "&&" || e->text == "||") return logical(e);
  const Expr *a = e->args[0], *b = e->args[1];
  Value x = value(a), y = value(b);
  bool compares = e->text[0] == '=' || e->text[0] == '!' || ((e->text[0] == '<' || e->text[0] == '>') && e->text[0] != e->text[1]);
  bool pointers = a->type->kind == Type::Pointer && b->type->kind == Type::Pointer;
  if (!compares && !pointers) return operation(e->text, a, x, y, e->type);
  Value v;
  v.varied = x.varied || y.varied;
  if (pointers) { // inside one object
    bool same = !x.anywhere && !y.anywhere && x.targets.size() == 1 && y.targets.size() == 1 &&
                x.targets.begin()->first == y.targets.begin()->first;
    x.range = same ? x.targets.begin()->second : Range{};
    y.range = same ? y.targets.begin()->second : Range{};
  }
  if (compares)
    v.range = comparison(e->text, x.range, y.range);
  else if (leaves(a->type->element) > 0)
    v.range = arithmetic("/", arithmetic("-", x.range, y.range), Range::of(leaves(a->type->element)));
  return v;
}

// The second operand is reached where the first does not settle it.
Value MemoryCheck::logical(const Expr *e) {
  bool isAnd = e->text == "&&";
  Value first = value(e->args[0]);
  bool zero = first.range == Range::of(0), nonzero = !first.range.holds(0);
  if (isAnd ? zero : nonzero) return Value::number(Range::of(!isAnd));
  Mark before = mark();
  State without = state_;
  if (!zero && !nonzero) doubt(first);
  Value second = value(e->args[1]);
  Value v;
  v.range = comparison("!=", second.range, Range::of(0));
  v.varied = second.varied;
  if (zero || nonzero) return v;
  state_.include(without);
  rejoin(before, SIZE_MAX);
  v.varied = first.varied && second.varied;
  v.range = hull(v.range, Range::of(!isAnd));
  return v;
}

Cells MemoryCheck::conditional(const Expr *e) {
  Value condition = value(e->args[0]);
  if (!condition.range.holds(0)) return eval(e->args[1]);
  if (condition.range == Range::of(0)) return eval(e->args[2]);
  Mark before = mark();
  doubt(condition);
  State other = state_;
  Cells result = eval(e->args[1]);
  std::swap(state_, other);
  Cells second = eval(e->args[2]);
  state_.include(other);
  rejoin(before, SIZE_MAX);
  for (size_t i = 0; i < result.size() && i < second.size(); ++i) result[i] = joined(result[i], second[i]);
  return result;
}

Cells MemoryCheck::assign(const Expr *e) {
  const Expr *left = e->args[0];
  if (e->kind == Expr::Assign && e->text == "=") {
    const Expr *right = e->args[1];
    Cells cells =
        e->wholesale && right->kind == Expr::Index ? read(place(right), std::max(1L, leaves(right->type)), right) : eval(right);
    write(place(left), cells, left);
    return cells;
  }
  Value y = e->kind == Expr::Step ? Value::number(Range::of(1)) : value(e->args[1]);
  Place p = place(left);
  Cells old = read(p, 1, left);
  demandValue(old[0], p, left);
  Cell cell;
  cell.value = operation(e->text.substr(0, e->text.size() - 1), left, old[0].value, y, left->type);
  write(p, {cell}, left);
  old[0].assigned = true;
  return e->kind == Expr::Step && !e->prefix ? old : Cells{cell};
}

// It may write where its arguments point.
Cells MemoryCheck::mathCall(const Expr *e) {
  Cell result;
  for (const Expr *arg : e->args) {
    Cell cell = eval(arg)[0];
    result.value.varied |= cell.value.varied;
    if (cell.value.anywhere && arg->type->kind == Type::Pointer) state_.forget();
    if (arg->type->kind == Type::Pointer)
      for (const auto &t : cell.value.targets)
        if (const Object *o = find(t.first)) store(t.first, repeated(Cells(o->cells.size()), o->length));
  }
  return {result};
}

// The leaves of an object that begins with this initialiser; a null one is zero.
Cells MemoryCheck::fill(const Type *type, const Expr *e) {
  if (e && e->kind != Expr::InitList) return eval(e);
  if (leaves(type) < 0) return {Cell{}};
  auto item = [&](size_t i) { return e && i < e->args.size() ? e->args[i] : nullptr; };
  Cells cells;
  auto add = [&](const Type *t, size_t i) {
    Cells part = fill(t, item(i));
    cells.insert(cells.end(), part.begin(), part.end());
  };
  if (type->kind == Type::Array) {
    for (long i = 0; i < type->count; ++i) add(type->element, static_cast<size_t>(i));
  } else if (type->kind == Type::Struct) {
    for (size_t i = 0; i < type->record->fields.size(); ++i) add(type->record->fields[i].type, i);
  } else if (item(0)) {
    return eval(item(0));
  } else {
    cells.push_back({});
    if (type->kind == Type::Integer) cells[0].value = Value::number(Range::of(0));
  }
  return cells.empty() ? Cells(1) : cells;
}

MemoryCheck::Place MemoryCheck::place(const Expr *e) {
  switch (e->kind) {
  case Expr::Ref: {
    const Variable *v = e->var;
    bool fixed = v->scope == Variable::Global || v->isStatic;
    int id = fixed ? constant(v) : object(frames_.size() - 1, v, v->name, v->type);
    return {Value::pointer(id, Range::of(0)), ""};
  }
  case Expr::Index:
    return element(e);
  case Expr::Deref:
    return {value(e->args[0]), ""};
  case Expr::Member:
    return member(e);
  case Expr::Comma:
    eval(e->args[0]);
    return place(e->args[1]);
  default: { // a temporary, or a compound literal
    Cells cells = eval(e);
    int id = object(frames_.size() - 1, e, e->kind == Expr::Call ? e->callee->name + "(..)" : "a temporary", e->type);
    store(id, holding(std::move(cells), e->type));
    return {Value::pointer(id, Range::of(0)), ""};
  }
  }
}

MemoryCheck::Place MemoryCheck::element(const Expr *e) {
  const Expr *base = e->args[0];
  Place p;
  if (base->kind == Expr::Decay)
    p = place(base->args[0]);
  else
    p.pointer = value(base);
  Range index = value(e->args[1]).range;
  long size = leaves(e->type);
  const Type *array = base->kind == Expr::Decay ? base->args[0]->type : nullptr;
  if (p.beyond.empty() && array && !array->length && !index.isWhole() && (index.hi < 0 || index.lo >= array->count)) {
    std::string name =
        p.pointer.targets.empty() ? "" : " in '" + named_[static_cast<size_t>(p.pointer.targets.begin()->first)].name + "'";
    p.beyond = "index " + std::to_string(index.lo) + " of " + std::to_string(array->count) + name;
  }
  p.pointer = moved(p.pointer, size < 0 ? Range{} : arithmetic("*", index, Range::of(size)));
  return p;
}

MemoryCheck::Place MemoryCheck::member(const Expr *e) {
  const Expr *base = e->args[0];
  Place p;
  if (e->arrow)
    p.pointer = value(base);
  else
    p = place(base);
  p.pointer = moved(p.pointer, Range::of(fieldOffset(recordOf(e), e->text)));
  return p;
}

} // namespace tlgen
