// Objects, the cells behind pointers, and what is found there.
#include "MemoryCheck.h"
#include "PrintC.h"

#include <algorithm>

namespace tlgen {

int MemoryCheck::object(size_t depth, const void *key, const std::string &name, const Type *type) {
  auto [place, isNew] = ids_.emplace(std::make_pair(depth, key), static_cast<int>(named_.size()));
  if (isNew) named_.push_back({depth, name, type});
  return place->second;
}

// A table: it belongs to no frame and is not part of the state.
int MemoryCheck::constant(const Variable *v) {
  int id = object(SIZE_MAX, v, v->name, v->type);
  if (constants_.count(id)) return id;
  constants_[id] = repeated({Cell{}}, -1); // while its own initialiser is run
  if (v->init) constants_[id] = holding(fill(v->type, v->init), v->type);
  return id;
}

const Object *MemoryCheck::find(int id) const {
  auto mine = state_.objects.find(id);
  if (mine != state_.objects.end()) return mine->second.get();
  auto fixed = constants_.find(id);
  return fixed != constants_.end() ? &fixed->second : nullptr;
}

// The objects and offsets where size leaves may lie; false, with a message where that is sure, where none is inside its object. Without
// parts it is anywhere.
bool MemoryCheck::inside(const Place &p, long size, const Expr *e, std::vector<std::pair<int, Range>> &parts) {
  std::string beyond = p.beyond;
  bool good = beyond.empty() && (p.pointer.anywhere || p.pointer.targets.empty());
  for (const auto &t : p.pointer.targets) {
    const Object *o = find(t.first);
    if (!p.beyond.empty()) continue;
    if (p.pointer.anywhere || !o || o->cells.empty()) {
      good = true;
      parts.clear();
      break;
    }
    Range legal{0, o->length < 0 ? LONG_MAX : o->length - size};
    Range offset{std::max(t.second.lo, legal.lo), std::min(t.second.hi, legal.hi)};
    if (offset.lo <= offset.hi) {
      parts.emplace_back(t.first, offset);
      good = true;
    } else if (beyond.empty()) {
      long first = t.second.lo, unit = o->length % size || first % size ? 1 : size;
      std::string count = o->length < 0 ? "" : " of " + std::to_string(o->length / unit);
      beyond = "index " + std::to_string(first / unit) + count + " in '" + named_[static_cast<size_t>(t.first)].name + "'";
    }
  }
  visit("index-range", e, e->loc, "", beyond, !good);
  return good;
}

Cells MemoryCheck::read(const Place &p, long size, const Expr *e) {
  std::vector<std::pair<int, Range>> parts;
  Cells cells;
  inside(p, size, e, parts);
  for (const auto &part : parts) {
    const Object &o = *find(part.first);
    long period = static_cast<long>(o.cells.size());
    Range at = part.second;
    if (o.isSummary() && (at.hi < 0 || at.hi - at.lo >= period)) at = {0, period - 1};
    for (long begin = at.lo; begin <= at.hi; ++begin) {
      steps_ += size / 16;
      for (long i = 0; i < size; ++i) {
        const Cell &cell = o.cells[static_cast<size_t>((begin + i) % period)];
        size_t k = static_cast<size_t>(i);
        if (k < cells.size())
          cells[k] = joined(cells[k], cell);
        else
          cells.push_back(cell);
      }
    }
  }
  cells.resize(static_cast<size_t>(size));
  return cells;
}

// Only what is written at one known place is known afterwards.
void MemoryCheck::write(const Place &p, const Cells &cells, const Expr *e) {
  std::vector<std::pair<int, Range>> parts;
  long size = static_cast<long>(cells.size());
  if (!inside(p, size, e, parts)) return;
  if (parts.empty()) return state_.forget();
  for (const auto &part : parts) {
    if (!state_.objects.count(part.first)) continue; // a constant; Activity refuses it
    Object o = *find(part.first);
    long period = static_cast<long>(o.cells.size());
    Range at = part.second;
    if (o.isSummary() && at.hi - at.lo >= period) at = {0, period - 1};
    bool sure = parts.size() == 1 && p.pointer.targets.begin()->second.exact() && !o.isSummary();
    for (long begin = at.lo; begin <= at.hi; ++begin)
      for (long i = 0; i < size; ++i) {
        Cell &cell = o.cells[static_cast<size_t>((begin + i) % period)];
        const Cell &now = cells[static_cast<size_t>(i)];
        cell = sure ? now : joined(cell, now);
      }
    store(part.first, std::move(o));
  }
}

// The name of what is read: v, v[1], s.m[0][1].
std::string MemoryCheck::leafName(int id, const Range &offset) const {
  const Named &object = named_[static_cast<size_t>(id)];
  std::string name = object.name;
  const Type *type = object.type;
  long at = offset.lo;
  if (!offset.exact()) return name;
  if (type->kind == Type::Pointer && object.depth == 0) return name + "[" + std::to_string(at) + "]";
  while (leaves(type) > at && (type->kind == Type::Array || type->kind == Type::Struct)) {
    if (type->kind == Type::Array) {
      type = type->element;
      name += "[" + std::to_string(at / leaves(type)) + "]";
      at %= leaves(type);
      continue;
    }
    const Field *field = nullptr;
    for (const Field &f : type->record->fields)
      if (fieldOffset(type->record, f.name) <= at && elements(f.type) > 0) field = &f;
    if (!field) break;
    at -= fieldOffset(type->record, field->name);
    type = field->type;
    name += "." + field->name;
  }
  return name;
}

// A number or pointer is read: at fault is the function that it belongs to, where it reads it or gives its address away.
void MemoryCheck::demandValue(const Cell &cell, const Place &p, const Expr *e) {
  if (p.pointer.anywhere || p.pointer.targets.empty()) return;
  const auto &first = *p.pointer.targets.begin();
  size_t depth = named_[static_cast<size_t>(first.first)].depth;
  depth = std::max<size_t>(depth, 1); // of the model function, what it is given too
  const Loc &loc = depth >= frames_.size() - 1 ? e->loc : frames_[depth].call;
  std::string name = leafName(first.first, first.second);
  visit("uninitialized", nullptr, loc, named_[static_cast<size_t>(first.first)].name, "'" + name + "'", !cell.assigned);
}

void MemoryCheck::visit(const char *id, const Expr *access, const Loc &loc, const std::string &name, const std::string &what,
                        bool fault) {
  if (over() || !state_.live) return;
  auto key = std::make_tuple(access, loc.file, loc.line, loc.column, name);
  auto [place, isNew] = findings_.try_emplace(key);
  Finding &f = place->second;
  if (isNew) f = {id, loc, "", false, true, Reached::Perhaps};
  if (!fault) {
    f.always = false;
    return;
  }
  if (f.what.empty() || (!f.sure && state_.reached == Reached::Surely)) f.what = what;
  f.sure |= state_.reached == Reached::Surely;
  f.reached = std::max(f.reached, state_.reached);
}

} // namespace tlgen
