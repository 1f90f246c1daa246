// Motion-shape coefficients in loops: which coefficients carried values have, rows, tapes and results.
#include "Jets.h"
#include "Order.h"

#include <algorithm>

namespace tlgen {
namespace {

// An index as factor * iteration + offset of one loop; factor 0 for a constant. False where it is neither.
bool linear(const Node *node, const Loop *loop, long &factor, long &offset) {
  if (node->op != Node::Affine || node->terms.size() > 1) return false;
  if (!node->terms.empty() && node->terms[0].first != loop) return false;
  factor = node->terms.empty() ? 0 : node->terms[0].second;
  offset = node->offset;
  return true;
}

// The columns that a sum of tangents has by themselves: factor * iteration + first..last.
struct Fresh {
  bool any = false, regular = true;
  long factor = 0, first = 0, last = 0;

  void add(const Node *column, const Loop *loop) {
    long f, o;
    regular = regular && linear(column, loop, f, o) && (!any || f == factor);
    if (!regular) return;
    first = any ? std::min(first, o) : o;
    last = any ? std::max(last, o) : o;
    factor = f;
    any = true;
  }
};

} // namespace

void Jets::run(const std::vector<JetOutput> &outputs, const std::vector<Node *> &besides) {
  std::vector<Node *> wanted = besides;
  for (const JetOutput &output : outputs) {
    wanted.push_back(output.index);
    for (const Term &term : output.terms) wanted.push_back(term.value);
  }
  Needed needed(wanted);
  needed_ = &needed;
  outputs_ = &outputs;
  runRegion(nullptr);
  finishLoop(nullptr, 0);
  for (Node *node : besides) keep(value(node));
  closeSums();
  dropUnused();
  if (!analyses_.demand) keepAll();
  separateFills();
  needed_ = nullptr;
}

void Jets::keep(Node *node) {
  if (node->op != Node::Number && node->op != Node::Affine && node->op != Node::Leaf && !isInteger(node)) kept_.insert(node);
}

// Without demand: every coefficient of every value. No result is made of them, so that they may be without a formula.
void Jets::keepAll() {
  const Node *const before = noFormula_;
  for (Node *node : needed_->nodes())
    for (int power = 0; !isInteger(node) && power < powers_; ++power) {
      keep(coefficient(node, power));
      for (auto &[direction, factor] : tangents(node, power)) keep(factor);
    }
  noFormula_ = before;
}

void Jets::runRegion(Loop *loop) {
  for (const Step &step : needed_->steps(loop)) {
    if (step.loop) {
      storeBefore(loop, step.loop);
      runLoop(step.loop);
    } else {
      if (step.node->op == Node::Read) storeWrites(step.node->array, loop);
      value(step.node);
    }
  }
}

// What the inner loop reads that this loop's iterations, or what is outside of all loops, have written.
void Jets::storeBefore(Loop *loop, const Loop *inner) {
  for (const Node *node : needed_->nodes())
    if (node->op == Node::Read && node->loop && node->loop->within(inner)) storeWrites(node->array, loop);
}

// The writes of one loop's iterations (null: outside of all) to an array, once.
void Jets::storeWrites(Array *array, Loop *loop) {
  for (size_t k = 0; k < array->writes.size(); ++k) {
    const Write write = array->writes[k];
    if (write.loop == loop && written_.insert({array, k}).second) finishWrite(array, write);
  }
}

// The loop anew. A coefficient of a carried value is there where it is not zero at first or after an iteration: taken for absent until
// it is seen.
void Jets::runLoop(Loop *loop) {
  Trial &trial = trials_[loop] = Trial();
  trial.present.resize(loop->carried.size());
  for (size_t k = 0; k < loop->carried.size(); ++k) {
    if (!needed_->has(loop, k)) continue;
    for (int p = 0; p < powers_; ++p) note(trial.present[k], loop->carried[k].init, p);
    if (!analyses_.activity) trial.present[k].all(columns_ > 0);
  }
  std::vector<size_t> writes;
  for (const Array &array : graph_.arrays()) writes.push_back(array.writes.size());
  auto stored = stored_;
  auto written = written_;
  auto tapes = tapes_;
  auto taped = taped_;
  size_t updates = updates_.size();
  while (!tryLoop(loop)) {
    size_t k = 0;
    for (const Array &array : graph_.arrays()) const_cast<Array &>(array).writes.resize(k < writes.size() ? writes[k] : 0), ++k;
    stored_ = stored;
    written_ = written;
    tapes_ = tapes;
    taped_ = taped;
    updates_.resize(updates);
  }
}

// Adds to present what the value has in s^power; true where that is something new.
bool Jets::note(Present &present, Node *value, int power) {
  bool found = false;
  if (!coefficient(value, power)->is(0) && !present.c[power]) found = present.c[power] = true;
  const Tangents &t = tangents(value, power);
  if (!t.empty() && !present.t[power]) found = present.t[power] = true;
  if (explicit_)
    for (auto &[direction, factor] : t) found = present.columns[power].insert(direction).second || found;
  return found;
}

void Jets::forget(const Loop *loop) {
  for (auto it = info_.begin(); it != info_.end();) {
    const Node *node = it->first;
    bool inside = (node->loop && node->loop->within(loop)) || (node->op == Node::Final && node->of->within(loop));
    it = inside ? info_.erase(it) : std::next(it);
  }
}

bool Jets::tryLoop(Loop *loop) {
  forget(loop);
  Trial &trial = trials_.at(loop);
  trial.same.clear();
  trial.own.clear();
  trial.ends.clear();
  const size_t count = loop->carried.size();
  Loop *clone = graph_.loop(loop->outer ? clones_.at(loop->outer) : nullptr, loop->trips ? value(loop->trips) : nullptr, loop->down);
  clones_[loop] = clone;
  size_t firstUpdate = updates_.size();
  for (size_t k = 0; k < count; ++k)
    if (needed_->has(loop, k)) startCarried(loop, k);
  if (loop->condition) clone->condition = value(loop->condition);
  runRegion(loop);
  bool complete = true;
  for (size_t k = 0; k < count; ++k)
    for (int p = 0; needed_->has(loop, k) && p < powers_; ++p)
      if (note(trial.present[k], loop->carried[k].out, p)) complete = false;
  if (noteDifferences(loop)) complete = false;
  for (size_t k = 0; complete && k < count; ++k)
    if (needed_->has(loop, k)) finishCarried(loop, k);
  for (size_t k = 0; k < count; ++k) outOf_.erase(loop->carried[k].out);
  if (complete) finishLoop(loop, firstUpdate);
  return complete;
}

// True where something that was taken for the same as something else is not.
bool Jets::noteDifferences(const Loop *loop) {
  Trial &trial = trials_.at(loop);
  auto row = [&](const Place &place) {
    auto end = trial.ends.find(place);
    return end == trial.ends.end() ? tangents(loop->carried[place.carried].out, place.power) : end->second;
  };
  auto end = [&](const Place &place) { return number(loop->carried[place.carried].out, place.power, place.column); };
  auto endsAlike = [&](const Place &a, const Place &b) {
    if (!a.row) {
      Node *const one = end(a), *const other = end(b);
      return one == other;
    }
    const Tangents other = row(b), one = row(a);
    return one == other;
  };
  bool found = false;
  for (auto &[place, other] : trial.same)
    if (!endsAlike(place, other)) found = trial.different.insert({place, other}).second || found;
  return found;
}

void Jets::finishLoop(Loop *loop, size_t firstUpdate) {
  const size_t count = graph_.arrays().size(); // storing makes more of them
  for (size_t k = 0; loop && k < count; ++k) {
    const Array &array = graph_.arrays()[k];
    if (needed_->has(&array)) storeWrites(const_cast<Array *>(&array), loop);
  }
  for (const JetOutput &output : *outputs_)
    if (output.loop == loop) finishOutput(output);
  if (loop) boundUpdates(clones_.at(loop), firstUpdate);
}

// The carried value as an iteration finds it.
void Jets::startCarried(Loop *loop, size_t k) {
  const Carry carry = loop->carried[k];
  const Present &present = trials_.at(loop).present[k];
  Info in;
  for (int p = 0; p < powers_; ++p) {
    Node *init = coefficient(carry.init, p);
    in.c[p] = p == 0 || present.c[p] ? startNumber(loop, {k, p, false, nullptr}, init) : graph_.number(0);
    for (const Direction *d : present.columns[p]) in.t[p][d] = startNumber(loop, {k, p, false, d}, number(carry.init, p, d));
    if (!explicit_ && present.t[p]) startRow(loop, {k, p, true, nullptr}, tangents(carry.init, p), in);
    in.known[p] = true;
  }
  info_[carry.in] = in;
  if (!explicit_ && innermost(loop)) outOf_.emplace(carry.out, std::make_pair(loop, k));
}

Node *Jets::startNumber(Loop *loop, Place place, Node *init) {
  Trial &trial = trials_.at(loop);
  for (auto &[own, in] : trial.own) {
    if (own.row || trial.different.count({place, own}) || in->of->carried[size_t(in->which)].init != init) continue;
    trial.same.insert({place, own});
    return in;
  }
  return trial.own.emplace_back(place, graph_.carry(clones_.at(loop), init)).second;
}

void Jets::startRow(Loop *loop, Place place, const Tangents &init, Info &in) {
  Trial &trial = trials_.at(loop);
  Loop *clone = clones_.at(loop);
  Row *&row = carriedRows_[{clone, {place.carried, place.power}}];
  row = nullptr;
  for (auto &[own, none] : trial.own) {
    if (!own.row || trial.different.count({place, own})) continue;
    if (tangents(loop->carried[own.carried].init, own.power) != init) continue;
    trial.same.insert({place, own});
    row = carriedRows_.at({clone, {own.carried, own.power}});
    break;
  }
  if (!row) {
    trial.own.emplace_back(place, nullptr);
    row = &rows_.emplace_back(Row{int(rows_.size()), "row", 1, clone, false, false});
    if (!init.empty()) updates_.push_back({clone, row, nullptr, false, true, nullptr, nullptr, init});
  }
  in.t[place.power][carriedRow(loop, place.carried, place.power, false)] = graph_.number(1);
}

bool Jets::innermost(const Loop *loop) const {
  for (const Step &step : needed_->steps(loop))
    if (step.loop) return false;
  return true;
}

const Direction *Jets::carriedRow(Loop *loop, size_t k, int power, bool updated) {
  auto row = carriedRows_.find({clones_.at(loop), {k, power}});
  return row == carriedRows_.end() ? nullptr : direction({0, nullptr, row->second, nullptr, nullptr, updated});
}

// Where an end value's tangents are a sum of rows, it becomes the carried row at once, and what else needs it refers to that.
Tangents Jets::keepUpdated(Loop *loop, size_t k, int power, Tangents sum) {
  const Direction *own = carriedRow(loop, k, power, false);
  if (!own) return sum;
  Tangents columns;
  size_t others = 0;
  for (auto &[direction, factor] : sum)
    if (direction->column)
      columns[direction] = factor;
    else if (direction != own || !factor->is(1))
      ++others;
  if (!others) return sum;
  Trial &trial = trials_.at(loop);
  const Place place = {k, power, true, nullptr};
  trial.ends[place] = sum;
  auto same = trial.same.find(place);
  if (same == trial.same.end()) {
    updates_.push_back({clones_.at(loop), own->row, nullptr, false, false, nullptr, nullptr, sum});
  } else {
    auto end = trial.ends.find(same->second);
    if (end == trial.ends.end() || end->second != sum) return sum; // different, or later updated
  }
  columns[carriedRow(loop, k, power, true)] = graph_.number(1);
  return columns;
}

void Jets::finishCarried(Loop *loop, size_t k) {
  const Carry carry = loop->carried[k];
  const Info in = info_[carry.in];
  for (int p = 0; p < powers_; ++p) {
    if (in.c[p]->op == Node::Carried && in.c[p]->of == clones_.at(loop)) graph_.setOut(in.c[p], coefficient(carry.out, p));
    const Tangents out = tangents(carry.out, p);
    if (explicit_) {
      for (auto &[direction, carried] : in.t[p]) graph_.setOut(carried, number(carry.out, p, direction));
    } else if (const Direction *own = carriedRow(loop, k, p, true)) {
      if (!trials_.at(loop).same.count({k, p, true, nullptr}) && !out.count(own))
        updates_.push_back({clones_.at(loop), own->row, nullptr, false, false, nullptr, nullptr, out});
    }
  }
}

void Jets::finishWrite(Array *array, const Write &write) {
  bool several = array->writes.size() > 1 || array->summed;
  Stored &stored = stored_[array];
  stored.loop = write.loop ? clones_.at(write.loop) : nullptr;
  if (array->tape && analyses_.recompute) {
    stored.taped = write.value;
    for (int p = 0; p < powers_; ++p)
      if (!splitTangents(stored, write, p)) storeTangents(stored, array, write, p);
    return;
  }
  for (int p = 0; p < powers_; ++p) {
    Node *c = coefficient(write.value, p);
    if (p == 0 || !c->is(0) || (several && !array->summed)) {
      if (!stored.c[p]) stored.c[p] = newArray(array, array->length);
      if (!c->is(0) || !array->summed) graph_.write(stored.c[p], stored.loop, value(write.index), c);
    }
    storeTangents(stored, array, write, p);
  }
}

Array *Jets::newArray(const Array *like, long length) {
  Array *array = graph_.array(like->name, length);
  array->summed = like->summed;
  if (like->home) array->home = clones_.at(like->home);
  return array;
}

void Jets::storeTangents(Stored &stored, Array *array, const Write &write, int power) {
  const Tangents t = tangents(write.value, power);
  bool several = array->writes.size() > 1 || array->summed;
  Node *index = value(write.index);
  if (t.empty() && (array->summed || !several)) return;
  if (explicit_ && several) {
    if (!stored.wide[power]) stored.wide[power] = newArray(array, array->length * columns_);
    for (long j = 0; j < columns_; ++j) {
      Node *tangent = number(write.value, power, column(graph_.integer(j)));
      if (!tangent->is(0) || !array->summed) graph_.write(stored.wide[power], stored.loop, wideIndex(index, j), tangent);
    }
    return;
  }
  const bool byIteration = !several && stored.loop && index == stored.loop->index;
  bool local = explicit_ || byIteration;
  for (auto &[direction, factor] : t) {
    long f, o;
    local = local && direction->column && (explicit_ || linear(direction->column, stored.loop, f, o));
  }
  if (local) {
    for (auto &[direction, factor] : t) {
      Array *column = newArray(array, array->length);
      graph_.write(column, stored.loop, index, factor);
      stored.columns[power].push_back({direction->column, column});
    }
    return;
  }
  if (byIteration && !stored.loop->outer && splitTangents(stored, write, power)) return;
  if (!stored.rows[power])
    stored.rows[power] = &rows_.emplace_back(Row{int(rows_.size()), array->name, array->length, nullptr, array->summed, false});
  updates_.push_back({stored.loop, stored.rows[power], index, array->summed, false, nullptr, nullptr, t});
}

// The tangents of an array's elements as columns of the iteration's own and as first columns of rows that iterations only add columns
// of their own to. False where they are not of this kind.
bool Jets::splitTangents(Stored &stored, const Write &write, int power) {
  Loop *clone = stored.loop;
  Tangents columns;
  std::vector<Part> parts;
  for (auto &[direction, factor] : tangents(write.value, power)) {
    long f, o;
    if (direction->column) {
      if (!explicit_ && !linear(direction->column, clone, f, o)) return false;
      accumulate(columns, direction, factor);
      continue;
    }
    Tangents own;
    Node *bound = clone->down ? nullptr : ownColumns(direction, clone, own);
    if (!bound) return false;
    parts.push_back({nullptr, direction->row, bound, factor});
    for (auto &[column, first] : own) accumulate(columns, column, graph_.neg(graph_.mul(factor, first)));
  }
  for (auto &[direction, factor] : columns) parts.push_back({direction->column, nullptr, nullptr, factor});
  stored.parts[power] = std::move(parts);
  return true;
}

// The columns that an iteration adds to a carried row, where it does nothing else to it and each iteration has other ones: the row
// keeps what it was, and the result is the end of its columns after an iteration. Null where it is not so.
Node *Jets::ownColumns(const Direction *direction, Loop *clone, Tangents &own) const {
  const Row *row = direction->row;
  if (!analyses_.views || direction->updated || row->carriedBy != clone) return nullptr;
  Fresh all;
  for (const RowUpdate &update : updates_) {
    if (update.row != row) continue;
    if (update.before || !own.empty()) return nullptr;
    bool stays = false;
    for (auto &[other, factor] : update.sum) {
      if (other->column) {
        all.add(other->column, clone);
        own[other] = factor;
      } else if (other->row != row || !factor->is(1)) {
        return nullptr;
      } else {
        stays = true;
      }
    }
    if (!stays) return nullptr;
  }
  if (!all.any || !all.regular || all.factor <= all.last - all.first) return nullptr;
  return graph_.affine(all.last + 1, {{clone, all.factor}});
}

// What the term is the end value of in each iteration; null where it is none.
const Carry *Jets::carriedTo(const JetOutput &output, const Term &term) const {
  if (!output.loop) return nullptr;
  for (const Carry &carry : output.loop->carried)
    if (carry.out == term.value) return &carry;
  return nullptr;
}

// A coefficient, or where a direction is given that of its tangents.
Node *Jets::number(Node *node, int power, const Direction *direction) {
  if (!direction) return coefficient(node, power);
  const Tangents &t = tangents(node, power);
  auto found = t.find(direction);
  return found == t.end() ? graph_.number(0) : found->second;
}

// Sums that iterations carry on, and that the output takes together, are carried as one.
Node *Jets::outputNumber(const JetOutput &output, const Direction *column) {
  Node *sum = graph_.number(0), *start = sum, *change = sum, *rest = sum;
  size_t carried = 0;
  for (const Term &term : output.terms) {
    auto scaled = [&](Node *n) { return graph_.scale(term.factor, n); };
    Node *end = number(term.value, term.power, column);
    sum = graph_.add(sum, scaled(end));
    const Carry *carry = carriedTo(output, term);
    Node *in = carry ? number(carry->in, term.power, column) : nullptr;
    std::vector<Graph::Scaled> parts;
    bool accumulates = in && in->op == Node::Carried && Graph::terms(end, 1, parts) &&
                       std::any_of(parts.begin(), parts.end(), [&](const Graph::Scaled &p) { return p.rest == in && p.factor == 1; });
    if (accumulates) {
      ++carried;
      start = graph_.add(start, scaled(in->of->carried[size_t(in->which)].init));
      change = graph_.add(change, scaled(graph_.sub(end, in)));
    } else {
      rest = graph_.add(rest, scaled(end));
    }
  }
  if (carried < 2) return sum;
  Node *in = graph_.carry(clones_.at(output.loop), start), *out = graph_.add(in, change);
  graph_.setOut(in, out);
  return graph_.add(out, rest);
}

// The same for rows of tangents.
Tangents Jets::outputRow(const JetOutput &output) {
  Tangents sum, change, rest;
  size_t carried = 0;
  for (const Term &term : output.terms) {
    Node *factor = graph_.number(term.factor);
    Tangents end = tangents(term.value, term.power);
    accumulate(sum, factor, end);
    const Carry *carry = carriedTo(output, term);
    const size_t k = carry ? size_t(carry - output.loop->carried.data()) : 0;
    const Direction *own = carry ? carriedRow(output.loop, k, term.power, false) : nullptr;
    if (own) {
      auto raw = trials_.at(output.loop).ends.find({k, term.power, true, nullptr});
      if (raw != trials_.at(output.loop).ends.end()) end = raw->second;
    }
    if (own && end.count(own) && end.at(own)->is(1) && tangents(carry->init, term.power).empty()) {
      ++carried;
      end.erase(own);
      accumulate(change, factor, end);
    } else {
      accumulate(rest, factor, tangents(term.value, term.power));
    }
  }
  if (carried < 2) return sum;
  Loop *clone = clones_.at(output.loop);
  Row *row = &rows_.emplace_back(Row{int(rows_.size()), "row", 1, clone, false, false});
  for (auto &[direction, factor] : change)
    if (direction->column) accumulate(rest, direction, factor);
  change[direction({0, nullptr, row, nullptr, nullptr, false})] = graph_.number(1);
  rest[direction({0, nullptr, row, nullptr, nullptr, true})] = graph_.number(1);
  updates_.push_back({clone, row, nullptr, false, false, nullptr, nullptr, change});
  return rest;
}

void Jets::finishOutput(const JetOutput &output) {
  Loop *clone = output.loop ? clones_.at(output.loop) : nullptr;
  Node *index = value(output.index);
  if (output.scalar) {
    Node *sum = outputNumber(output, nullptr);
    if (!output.scalar->summed || !sum->is(0)) graph_.write(output.scalar, clone, index, sum);
  }
  if (!output.row && !output.matrix) return;
  if (output.row) {
    updates_.push_back(
        {clone, output.row, index, output.row->summed, false, output.upper ? index : nullptr, nullptr, outputRow(output)});
    return;
  }
  for (long j = 0; j < columns_; ++j) {
    if (output.upper && index->isConstant() && j < index->offset) continue;
    Node *sum = outputNumber(output, column(graph_.integer(j)));
    if (output.matrix->summed && sum->is(0)) continue;
    graph_.write(output.matrix, clone, wideIndex(index, j), sum);
  }
}

// Where a loop that counts up only ever reaches columns up to its iteration's own, its updates need not go further.
void Jets::boundUpdates(Loop *clone, size_t firstUpdate) {
  if (clone->down || explicit_) return;
  Fresh fresh;
  for (size_t k = firstUpdate; k < updates_.size(); ++k)
    if (updates_[k].loop == clone)
      for (auto &[direction, factor] : updates_[k].sum)
        if (direction->column) fresh.add(direction->column, clone);
  if (!fresh.any || !fresh.regular || fresh.factor <= 0) return;
  auto fits = [&](const Direction *d) {
    if (d->column || (d->row->carriedBy == clone)) return true;
    long f, o;
    return d->bound && linear(d->bound, clone, f, o) && f == fresh.factor && o <= fresh.last + 1;
  };
  for (size_t k = firstUpdate; k < updates_.size(); ++k) {
    if (updates_[k].loop != clone) continue;
    if (updates_[k].before) return;
    for (auto &[direction, factor] : updates_[k].sum)
      if (!fits(direction)) return;
  }
  Node *bound = graph_.affine(fresh.last + 1, {{clone, fresh.factor}});
  for (size_t k = firstUpdate; k < updates_.size(); ++k)
    if (updates_[k].loop == clone) updates_[k].bound = bound;
  for (auto &[array, stored] : stored_)
    if (stored.loop == clone)
      for (int p = 0; p < powers_; ++p)
        if (stored.rows[p] && array->writes.size() == 1 && !array->summed) stored.bound[p] = bound;
}

} // namespace tlgen
