// Objects, the cells behind pointers, and the merging of paths.
#include "Tracer.h"

#include <algorithm>
#include <numeric>

namespace tlgen::symbols {

bool Cell::same(const Cell &o) const { return kind == o.kind && node == o.node && pointer == o.pointer; }

// Objects

int Tracer::newObject(Object o) {
  objects_.push_back(std::move(o));
  return int(objects_.size()) - 1;
}

int Tracer::object(size_t depth, const void *key, const std::string &name, const Type *type) {
  auto [place, isNew] = ids_.emplace(std::make_pair(depth, key), int(objects_.size()));
  if (isNew) {
    Object o;
    o.depth = depth;
    o.text = name;
    o.type = type;
    newObject(std::move(o));
  }
  return place->second;
}

// A constant of the source; its values are those of its initialiser where that is known.
int Tracer::constant(const Variable *v) {
  auto [place, isNew] = ids_.emplace(std::make_pair(size_t(0), v), int(objects_.size()));
  const int id = place->second;
  if (!isNew) return id;
  Object o;
  o.kind = Object::Constant;
  o.text = v->name;
  o.type = v->type;
  o.variable = v;
  newObject(std::move(o));
  if (v->init) constants_[id] = fill(v->type, v->init);
  return id;
}

// Frees what belongs to frames from depth on.
void Tracer::dropObjects(size_t depth) {
  for (size_t id = 0; id < objects_.size(); ++id)
    if (objects_[id].depth >= depth) free(int(id));
}

// Pointers

PointerRef Tracer::to(int object) const {
  Pointer p;
  p.object = object;
  return std::make_shared<const Pointer>(std::move(p));
}

PointerRef Tracer::choice(Node *condition, const PointerRef &yes, const PointerRef &no) {
  if (condition->isConstant()) return condition->offset ? yes : no;
  if (yes == no) return yes;
  if (!yes->condition && !no->condition && yes->object == no->object) {
    if (yes->object == Pointer::null || sameOffset(*yes, *no)) return yes;
  }
  Pointer p;
  p.condition = condition;
  p.yes = yes;
  p.no = no;
  return std::make_shared<const Pointer>(std::move(p));
}

PointerRef Tracer::moved(const PointerRef &p, long stride, Node *index) {
  if (p->condition) {
    PointerRef no = moved(p->no, stride, index), yes = moved(p->yes, stride, index);
    return choice(p->condition, yes, no);
  }
  if (index->isConstant() && p->indices.empty()) return moved(p, stride * index->offset);
  Pointer m = *p;
  Node *&sum = m.indices[stride];
  sum = sum ? graph_.integerOp("+", sum, index) : index;
  if (sum->isConstant()) {
    m.fixed += stride * sum->offset;
    m.indices.erase(stride);
  }
  return std::make_shared<const Pointer>(std::move(m));
}

PointerRef Tracer::moved(const PointerRef &p, long fixed) {
  if (p->condition) {
    PointerRef no = moved(p->no, fixed), yes = moved(p->yes, fixed);
    return choice(p->condition, yes, no);
  }
  Pointer m = *p;
  m.fixed += fixed;
  return std::make_shared<const Pointer>(std::move(m));
}

bool Tracer::sameOffset(const Pointer &a, const Pointer &b) {
  Node *const one = offset(a), *const other = offset(b);
  return one == other;
}

// How many leaves behind the begin of its object it points.
Node *Tracer::offset(const Pointer &p) {
  Node *sum = graph_.integer(p.fixed);
  for (auto &[stride, index] : p.indices) sum = graph_.integerOp("+", sum, graph_.integerOp("*", graph_.integer(stride), index));
  return sum;
}

// Reading and writing

Cells Tracer::read(const PointerRef &p, long size, const Type *type) {
  if (p->condition) {
    if (!p->yes->condition && p->yes->object == Pointer::null) return read(p->no, size, type); // the other would be undefined
    if (!p->no->condition && p->no->object == Pointer::null) return read(p->yes, size, type);
    Cells yes = read(p->yes, size, type), no = read(p->no, size, type);
    return merged(p->condition, yes, no);
  }
  if (p->object == Pointer::null) return Cells(size_t(size), Cell{Cell::Lost, nullptr, nullptr});
  const Object &o = objects_[size_t(p->object)];
  return o.kind == Object::Storage ? readStored(*p, size) : readInput(*p, size);
}

void Tracer::write(const PointerRef &p, const Cells &cells) {
  if (p->condition) {
    writeWhere(p->condition, *p->yes, cells);
    return writeWhere(graph_.logicalNot(p->condition), *p->no, cells);
  }
  writeWhere(graph_.integer(1), *p, cells);
}

// Writes where the condition holds.
void Tracer::writeWhere(Node *condition, const Pointer &p, const Cells &cells) {
  if (p.condition) {
    writeWhere(graph_.logicalAnd(condition, p.condition), *p.yes, cells);
    return writeWhere(graph_.logicalAnd(condition, graph_.logicalNot(p.condition)), *p.no, cells);
  }
  if (p.object == Pointer::null) return;
  auto found = state_.objects.find(p.object);
  if (found == state_.objects.end()) unsuitable("something that is not a local variable is written");
  Node *begin = offset(p);
  if (begin->op == Node::Affine && !begin->isConstant()) {
    for (size_t i = 0; i < cells.size(); ++i) {
      Node *at = graph_.integerOp("+", begin, graph_.integer(long(i)));
      setElement(p.object, at, condition->isConstant() ? cells[i] : merged(condition, cells[i], element(p.object, at)));
    }
    return;
  }
  Cells all = *found->second;
  for (auto &[here, at] : candidates(p, long(all.size()), long(cells.size())))
    for (size_t i = 0; i < cells.size(); ++i) {
      checkConcrete(p.object, at + long(i));
      Cell &cell = all[size_t(at) + i];
      cell = merged(graph_.logicalAnd(condition, here), cells[i], cell);
    }
  store(p.object, std::move(all));
}

// The offsets where size leaves may lie in an object of that length, each with its condition; a constant one alone is surely meant.
std::vector<std::pair<Node *, long>> Tracer::candidates(const Pointer &p, long length, long size) {
  long fixed = p.fixed, step = 0;
  Node *index = nullptr;
  for (auto &[stride, i] : p.indices) {
    if (i->isConstant()) {
      fixed += stride * i->offset;
      continue;
    }
    index = step ? nullptr : i;
    step = std::gcd(step, stride);
  }
  if (!step) {
    if (fixed < 0 || fixed + size > length) unsuitable("an index lies outside of '" + objects_[size_t(p.object)].text + "'");
    return {{graph_.integer(1), fixed}};
  }
  Range legal = index ? bounds(index) : Range{};
  std::vector<std::pair<Node *, long>> result;
  Node *flat = index ? index : offset(p);
  for (long at = ((fixed % step) + step) % step; at + size <= length; at += step) {
    long number = index ? (at - fixed) / step : at;
    if (legal.holds(number)) result.emplace_back(graph_.compare("==", flat, graph_.integer(number)), at);
  }
  if (result.empty()) unsuitable("an index lies outside of '" + objects_[size_t(p.object)].text + "'");
  return result;
}

Cells Tracer::readStored(const Pointer &p, long size) {
  auto found = state_.objects.find(p.object);
  if (found == state_.objects.end()) return Cells(size_t(size), Cell{Cell::Lost, nullptr, nullptr});
  Cells result;
  Node *begin = offset(p);
  if (begin->op == Node::Affine && !begin->isConstant()) {
    for (long i = 0; i < size; ++i) result.push_back(element(p.object, graph_.integerOp("+", begin, graph_.integer(i))));
    return result;
  }
  const Cells all = *found->second;
  for (auto &[here, at] : candidates(p, long(all.size()), size)) {
    for (long i = 0; i < size; ++i) checkConcrete(p.object, at + i);
    Cells part(all.begin() + at, all.begin() + at + size);
    result = result.empty() ? part : merged(here, part, result);
  }
  return result;
}

Cells Tracer::readInput(const Pointer &p, long size) {
  Cells result;
  const Object o = objects_[size_t(p.object)]; // a copy: reading may make further objects
  auto values = constants_.find(p.object);
  if (values != constants_.end()) { // a number of the table, or one of the pointers in it
    const Cells &all = values->second;
    Node *number = offset(p);
    if (number->op == Node::Affine && !number->isConstant() && (size > 1 || all[0].kind != Cell::Number)) {
      for (long i = 0; i < size; ++i) result.push_back(uniform(all, graph_.integerOp("+", number, graph_.integer(i)), p.object));
      return result;
    }
    auto at = candidates(p, long(all.size()), size);
    bool isNumber = all[size_t(at[0].second)].kind == Cell::Number;
    if (at.size() > 1 && isNumber && size == 1) return {inputLeaf(o, p)};
    for (auto &[here, begin] : at) {
      Cells part(all.begin() + begin, all.begin() + begin + size);
      result = result.empty() ? part : merged(here, part, result);
    }
    return result;
  }
  for (long i = 0; i < size; ++i) {
    Pointer leaf = p;
    leaf.fixed += i;
    result.push_back(inputLeaf(o, leaf));
  }
  return result;
}

// The number at a place of an input, or the pointer there: to an object of its own.
Cell Tracer::inputLeaf(const Object &o, const Pointer &p) {
  if (o.kind == Object::Coordinates) {
    Slot s;
    s.kind = o.slot;
    Node *number = offset(p);
    checkIndex(number, dof_);
    return {Cell::Number, graph_.leaf(graph_.slot(s), {number}), nullptr};
  }
  LeafText leaf = leafText(o, p);
  if (leaf.type->kind != Type::Pointer) return {Cell::Number, memberLeaf(leaf, o), nullptr};
  auto key = std::make_pair(leaf.text, leaf.indices);
  auto known = targets_.find(key);
  if (known == targets_.end()) {
    Object target;
    target.kind = Object::Parameters;
    target.text = leaf.text;
    target.indices = leaf.indices;
    target.type = leaf.type->element;
    target.unbounded = true;
    known = targets_.emplace(key, newObject(std::move(target))).first;
  }
  return {Cell::Address, nullptr, to(known->second)};
}

// What C calls a leaf of an input.
Tracer::LeafText Tracer::leafText(const Object &o, const Pointer &p) {
  LeafText leaf{o.text, o.indices, o.type, 1};
  long fixed = p.fixed;
  std::map<long, Node *> indices = p.indices;
  auto takeIndex = [&](long stride, long count, long bound) {
    long whole = fixed / stride - (fixed % stride < 0);
    fixed -= whole * stride;
    Node *index = graph_.integer(whole);
    for (auto own = indices.begin(); own != indices.end();) {
      if (own->first % stride) {
        ++own;
        continue;
      }
      Node *term = graph_.integerOp("*", graph_.integer(own->first / stride), own->second);
      index = index->isConstant() && !index->offset ? term : graph_.integerOp("+", term, index);
      own = indices.erase(own);
    }
    if (bound >= 0) checkIndex(index, bound);
    leaf.text += "[%]";
    leaf.indices.push_back(index);
    leaf.length *= count;
  };
  if (o.unbounded) takeIndex(leaves(leaf.type), 0, -1);
  for (bool first = !o.unbounded; leaf.type->kind == Type::Array || leaf.type->kind == Type::Struct; first = false) {
    if (leaf.type->kind == Type::Array) {
      long count = leaf.type->count;
      leaf.type = leaf.type->element;
      takeIndex(leaves(leaf.type), count, count);
      continue;
    }
    const Field *field = nullptr;
    long begin = 0, at = 0;
    for (const Field &f : leaf.type->record->fields) {
      long size = leaves(f.type);
      if (at <= fixed && size > 0) field = &f, begin = at;
      at += size;
    }
    if (!field || fixed >= at) unsuitable("an access lies outside of the struct '" + leaf.type->record->spelling + "'");
    fixed -= begin;
    leaf.text += (first && o.kind == Object::Parameters ? "->" : ".") + field->name;
    leaf.type = field->type;
  }
  if (!indices.empty() || fixed != 0) unsuitable("an index of run time runs over several members of '" + leaf.text + "'");
  return leaf;
}

Node *Tracer::memberLeaf(const LeafText &leaf, const Object &o) {
  const std::string prefix = std::string(TRACE_PARAMS) + "->";
  if (leaf.text.compare(0, prefix.size(), prefix) == 0) {
    auto size = options_.sizes.find(leaf.text.substr(prefix.size()));
    if (size != options_.sizes.end()) return graph_.integer(size->second);
  }
  Slot s;
  s.kind = Slot::Member;
  s.text = leaf.text;
  s.integer = leaf.type->kind == Type::Integer;
  s.length = leaf.length;
  s.variable = o.variable;
  return graph_.leaf(graph_.slot(s), leaf.indices);
}

// Paths

void Tracer::take(const Path *path) {
  state_.path = path;
  graph_.guard = path ? path->guard : nullptr;
}

void Tracer::take(State state) {
  state_ = std::move(state);
  take(state_.path);
}

const Path *Tracer::under(Node *condition) {
  if (++choices_ > 2 * options_.maxChoices) unsuitable("the function has too many choices of run time, one after the other");
  const Path *outer = state_.path;
  return &paths_.emplace_back(
      Path{outer, condition, graph_.under(outer ? outer->guard : nullptr, condition), outer ? outer->length + 1 : 1});
}

Cell Tracer::merged(Node *condition, const Cell &yes, const Cell &no) {
  if (condition->isConstant()) return condition->offset ? yes : no;
  if (yes.same(no) || no.kind == Cell::Unset) return yes; // what has no value is not asked for
  if (yes.kind == Cell::Unset) return no;
  if (yes.kind != no.kind || yes.kind == Cell::Lost) return {Cell::Lost, nullptr, nullptr};
  if (yes.kind == Cell::Address) return {Cell::Address, nullptr, choice(condition, yes.pointer, no.pointer)};
  return {Cell::Number, graph_.select(condition, yes.node, no.node), nullptr};
}

Cells Tracer::merged(Node *condition, const Cells &yes, const Cells &no) {
  Cells result;
  for (size_t i = 0; i < yes.size() && i < no.size(); ++i) result.push_back(merged(condition, yes[i], no[i]));
  return result;
}

static const Path *ancestor(const Path *p, size_t length) {
  while (p && p->length > length) p = p->outer;
  return p;
}

static size_t lengthOf(const Path *p) { return p ? p->length : 0; }

// The deepest path that both begin with.
static const Path *common(const Path *a, const Path *b) {
  size_t length = std::min(lengthOf(a), lengthOf(b));
  a = ancestor(a, length);
  b = ancestor(b, length);
  while (a != b) {
    a = a->outer;
    b = b->outer;
  }
  return a;
}

// Where two paths meet: every number is that of the path that was taken.
State Tracer::merged(const State &a, const State &b) {
  const Path *stem = common(a.path, b.path);
  size_t length = lengthOf(stem);
  const Path *one = ancestor(a.path, length + 1), *other = ancestor(b.path, length + 1);
  graph_.guard = stem ? stem->guard : nullptr;
  auto conjunction = [&](const Path *p) {
    Node *all = graph_.integer(1);
    for (; p != stem; p = p->outer) all = graph_.logicalAnd(p->condition, all);
    return all;
  };
  bool opposite = one && other && one->condition == graph_.logicalNot(other->condition);
  Node *condition = opposite ? one->condition : conjunction(a.path);
  State result = a;
  result.path = stem;
  if (!opposite || one != a.path || other != b.path) { // others that began like them are still on their way
    state_.path = stem;
    Node *theirs = conjunction(b.path);
    result.path = under(graph_.logicalOr(conjunction(a.path), theirs));
  }
  for (auto it = result.objects.begin(); it != result.objects.end();) {
    auto theirs = b.objects.find(it->first);
    if (theirs == b.objects.end() || theirs->second->size() != it->second->size()) {
      result.elements.erase(it->first);
      it = result.objects.erase(it); // it lives in one of them only
      continue;
    }
    result.elements.erase(it->first);
    Elements both = mergedElements(condition, a, b, it->first);
    if (!both.empty()) result.elements[it->first] = std::move(both);
    if (theirs->second != it->second) it->second = std::make_shared<const Cells>(merged(condition, *it->second, *theirs->second));
    ++it;
  }
  return result;
}

// All of them, the closest first; none is a state that is not live.
State Tracer::mergeAll(const std::vector<State> &states) {
  std::vector<State> left;
  for (const State &s : states)
    if (s.live) left.push_back(s);
  while (left.size() > 1) {
    size_t first = 0, second = 1, best = 0;
    for (size_t i = 0; i < left.size(); ++i)
      for (size_t k = i + 1; k < left.size(); ++k)
        if (size_t close = lengthOf(common(left[i].path, left[k].path)) + 1; close >= best) first = i, second = k, best = close;
    State both = merged(left[first], left[second]);
    left.erase(left.begin() + long(second));
    left[first] = std::move(both);
  }
  return left.empty() ? State{} : left[0];
}

// Questions about nodes

// Whether a value depends on coordinates, velocities or time.
bool Tracer::isVaried(Node *n) {
  auto [known, isNew] = varied_.emplace(n, true); // what depends on itself is carried by a loop
  if (!isNew) return known->second;
  bool varied = n->op == Node::Carried || n->op == Node::Final || n->op == Node::Read;
  if (n->op == Node::Leaf) varied = n->slot->kind != Slot::Member;
  if (n->op != Node::Leaf)
    for (Node *arg : n->args) varied = isVaried(arg) || varied;
  return varied_[n] = varied;
}

// What a value depends on, in the user's words.
std::string Tracer::dependence(Node *n) const {
  std::vector<const Node *> all = {n};
  std::set<const Node *> seen = {n};
  std::string member;
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i]->op == Node::Leaf) {
      static const std::map<Slot::Kind, std::string> names = {{Slot::Q, "q"}, {Slot::Qd, "qd"}, {Slot::T, "t"}};
      auto name = names.find(all[i]->slot->kind);
      if (name != names.end()) return name->second;
      member = all[i]->slot->text;
    }
    for (const Node *arg : all[i]->args)
      if (seen.insert(arg).second) all.push_back(arg);
  }
  for (size_t at; (at = member.find("[%]")) != std::string::npos;) member.replace(at, 3, "[]");
  return member.empty() ? "values of run time" : "'" + member + "'";
}

void Tracer::checkSize() {
  const bool large = graph_.size() - before_ > options_.maxNodes;
  if (++steps_ <= maxSteps && !large) return;
  std::string why = large ? "the function is too large to be unrolled" : "the function runs too long to be unrolled";
  if (unrolled_.empty()) throw Unsuitable{why, graph_.loc, true};
  throw Unsuitable{why + ", and this loop cannot be kept: " + unrolled_[0].why, unrolled_[0].loc, true};
}

} // namespace tlgen::symbols
