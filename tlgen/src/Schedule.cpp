// From values to statements: need, batches, order.
#include "Schedule.h"
#include "Trace.h"

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

namespace tlgen {

// What some outputs need, of each kind in the order of finding: as Needed of Order.h, but with batches, checks and rows, and without
// what earlier phases computed.
struct Schedule::Wanted {
  std::vector<Node *> nodes;
  std::vector<Loop *> loops;
  std::vector<const Array *> arrays;
  std::vector<const Batch *> batches;
  std::vector<const Check *> checks;
  std::vector<const RowUpdate *> updates;
  std::set<const void *> all;
  std::set<std::pair<const Loop *, size_t>> carried;

  template <class T> bool add(std::vector<T> &to, T thing) { return all.insert(thing).second && (to.push_back(thing), true); }
  bool has(const void *thing) const { return all.count(thing) > 0; }
};

namespace {

const Loop *common(const Loop *a, const Loop *b) {
  while (a && !(b && b->within(a))) a = a->outer;
  return a;
}

bool isTrig(const Node *n) { return n->op == Node::Math && (n->text == "sin" || n->text == "cos"); }

// A value of leaves alone, without what loops and arrays leave, that varies in the iterations of at most one loop.
bool isDirect(const Node *n, const Loop *loop, std::unordered_map<const Node *, bool> &known) {
  auto found = known.find(n);
  if (found != known.end()) return found->second;
  bool direct =
      n->op != Node::Carried && n->op != Node::Final && n->op != Node::Read && n->op != Node::Taylor && (!n->loop || n->loop == loop);
  for (auto &term : n->terms) direct &= term.first == loop;
  for (const Node *arg : n->args) direct = direct && isDirect(arg, loop, known);
  return known[n] = direct;
}

const Loop *loopOf(const Node *a, const Node *b) { return !a || (b->loop && b->loop->within(a->loop)) ? b->loop : a->loop; }

const Loop *loopOf(const Check &check) { return loopOf(check.guard ? check.guard->holds : nullptr, check.outside); }

// Of one argument in a loop; all others stand outside.
const Loop *loopOf(const Batch &batch) { return batch.args.size() == 1 ? batch.args[0]->loop : nullptr; }

// Iterations of a loop and those around it; half of the outer ones where they set the number.
long iterations(const Loop *loop) {
  long all = 1;
  for (const Loop *l = loop; l; l = l->outer) {
    if (!l->trips || l->trips->op != Node::Affine) continue;
    double trips = double(l->trips->offset);
    for (auto &[outer, factor] : l->trips->terms)
      if (outer->trips && outer->trips->isConstant()) trips += 0.5 * double(factor * (outer->trips->offset - 1));
    all = long(double(all) * trips);
  }
  return all;
}

// Sums over rows of so many columns, half of them where the columns end or begin by the loop's number.
long vectorsOf(const RowUpdate &u, long columns) {
  const long terms = long(std::count_if(u.sum.begin(), u.sum.end(), [](const auto &part) { return part.first->row; }));
  const bool varying = (u.bound && !u.bound->isConstant()) || (u.from && !u.from->isConstant());
  const long width = padded(columns) / ROW_PAD;
  return terms * (varying ? (width + 1) / 2 : width);
}

std::vector<Node *> nodesOf(const RowUpdate &u) {
  std::vector<Node *> nodes;
  auto add = [&](Node *n) {
    if (n) nodes.push_back(n);
  };
  add(u.index), add(u.from), add(u.bound);
  for (auto &[direction, factor] : u.sum)
    add(factor), add(direction->column), add(direction->index), add(direction->from), add(direction->bound);
  return nodes;
}

// Where an update runs: the iterations of its loop, or before these.
const Loop *blockOf(const RowUpdate &u) { return u.before ? u.loop->outer : u.loop; }

// Sums of squares and positive numbers, exponentials, and roots, whose own condition is stronger.
bool isPositive(const Node *n);

bool isNotNegative(const Node *n) {
  if (n->op == Node::Mul) return n->args[0] == n->args[1] || (isNotNegative(n->args[0]) && isNotNegative(n->args[1]));
  if (n->op == Node::Add) return isNotNegative(n->args[0]) && isNotNegative(n->args[1]);
  return isPositive(n);
}

bool isPositive(const Node *n) {
  if (n->isNumber()) return n->value > 0;
  if (n->op == Node::Mul) return isPositive(n->args[0]) && isPositive(n->args[1]);
  if (n->op == Node::Add)
    return (isPositive(n->args[0]) && isNotNegative(n->args[1])) || (isNotNegative(n->args[0]) && isPositive(n->args[1]));
  return n->op == Node::Math && (n->text == "exp" || n->text == "exp2" || n->text == "cosh" || n->text == "sqrt");
}

// A value of parameters, constants and iteration numbers alone.
bool isPassive(const Node *n, std::unordered_map<const Node *, bool> &known) {
  auto found = known.find(n);
  if (found != known.end()) return found->second;
  bool passive = n->op != Node::Carried && n->op != Node::Final && n->op != Node::Read;
  if (n->op == Node::Leaf) passive = n->slot->kind == Slot::Member;
  for (const Node *arg : n->args) passive = passive && isPassive(arg, known);
  return known[n] = passive;
}

} // namespace

Schedule::Schedule(Graph &graph, std::vector<Phase> phases) : graph_(graph), phases_(std::move(phases)) {
  for (const Phase &phase : phases_) kept_.insert(phase.kept.begin(), phase.kept.end());
  makeChecks();
  makeBatches();
  countUses();
}

Schedule::~Schedule() = default;

// Collects what the outputs of a phase need and no earlier phase computed; of all phases, done or not, where all.
Schedule::Wanted Schedule::need(size_t phase, bool all) {
  Wanted needed;
  std::vector<Node *> open;
  auto node = [&](Node *n) {
    if (n && (all || !doneNodes_.count(n)) && needed.add(needed.nodes, n)) open.push_back(n);
  };
  std::function<void(Loop *)> loop;
  auto carried = [&](Loop *l, size_t which) {
    loop(l);
    if (!needed.carried.insert({l, which}).second) return;
    const Carry &c = l->carried[which];
    node(c.in), node(c.init), node(c.out);
  };
  loop = [&](Loop *l) {
    if (!l || !needed.add(needed.loops, l)) return;
    loop(l->outer);
    node(l->trips), node(l->condition);
  };
  auto array = [&](const Array *a) {
    if ((!all && doneArrays_.count(a)) || !needed.add(needed.arrays, a)) return;
    for (const Write &w : a->writes) loop(w.loop), node(w.index), node(w.value);
  };
  auto batch = [&](const Batch *b) {
    if ((!all && doneBatches_.count(b)) || !needed.add(needed.batches, b)) return;
    for (Node *arg : b->args) node(arg);
    node(b->first);
    if (b->filled) array(b->filled);
  };
  auto drain = [&] {
    while (!open.empty()) {
      Node *n = open.back();
      open.pop_back();
      loop(n->loop);
      auto at = places_.find(n);
      if (at != places_.end())
        batch(at->second.batch);
      else
        for (Node *arg : n->args) node(arg);
      if (n->op == Node::Carried || n->op == Node::Final) carried(n->of, size_t(n->which));
      if (n->op == Node::Read) array(n->array);
    }
  };
  for (size_t k = all ? 0 : phase; k < (all ? phases_.size() : phase + 1); ++k) {
    for (const Array *a : phases_[k].arrays) array(a);
    for (Node *n : phases_[k].kept) node(n);
    for (const RowUpdate &u : phases_[k].updates) {
      needed.add(needed.updates, &u);
      loop(u.loop);
      for (Node *n : nodesOf(u)) node(n);
    }
  }
  drain();
  for (size_t i = 0; i < needed.nodes.size(); ++i) {
    auto at = checksOf_.find(needed.nodes[i]);
    if (at == checksOf_.end()) continue;
    for (size_t k : at->second) {
      const Check *check = &checks_[k];
      if ((!all && doneChecks_.count(check)) || !needed.add(needed.checks, check)) continue;
      node(check->outside);
      if (check->guard) node(check->guard->holds);
    }
    drain();
  }
  return needed;
}

// The values that outputs are computed from, as against those that decide or index only.
std::set<const Node *> Schedule::computing() const {
  std::set<const Node *> found;
  std::vector<const Node *> open;
  auto add = [&](const Node *n) {
    if (found.insert(n).second) open.push_back(n);
  };
  for (const Phase &phase : phases_) {
    for (const Array *a : phase.arrays)
      for (const Write &w : a->writes) add(w.value);
    for (const RowUpdate &u : phase.updates)
      for (auto &[direction, factor] : u.sum) add(factor);
  }
  while (!open.empty()) {
    const Node *n = open.back();
    open.pop_back();
    if (n->op == Node::Carried || n->op == Node::Final) {
      const Carry &c = n->of->carried[size_t(n->which)];
      add(c.init), add(c.out);
    } else if (n->op == Node::Read) {
      for (const Write &w : n->array->writes) add(w.value);
    } else if (n->op == Node::Select) {
      add(n->args[1]), add(n->args[2]);
    } else if (n->op != Node::Compare && n->op != Node::Leaf) {
      for (const Node *arg : n->args) add(arg);
    }
  }
  return found;
}

// Conditions are made after all that needs them is known, so that they are not checked themselves. What parameters alone decide is
// plain arithmetic: nobody needs its derivatives, and a value that does not exist shows in the results.
void Schedule::makeChecks() {
  std::vector<Node *> nodes = need(0, true).nodes;
  std::sort(nodes.begin(), nodes.end(), ById());
  std::set<const Node *> values = computing();
  std::unordered_map<const Node *, bool> passive;
  std::map<std::tuple<const Guard *, Node *, std::string, int, unsigned>, size_t> known;
  for (Node *n : nodes) {
    if ((n->op != Node::Math && n->op != Node::Recip) || !values.count(n) || isPassive(n, passive)) continue;
    if (n->judged) continue;
    if (n->op == Node::Recip && isPositive(n->args[0])) continue;
    graph_.loc = n->loc;
    Node *outside = outsideDomain(graph_, n);
    if (!outside || (outside->isConstant() && !outside->offset)) continue;
    // A value and its derivative fail alike, and are one place of the source.
    auto same = known.emplace(std::make_tuple(n->guard, outside, sourceFunction(n), n->loc.file, n->loc.line), checks_.size());
    checksOf_[n].push_back(same.first->second);
    if (same.second) checks_.push_back({n->guard, outside, n});
  }
}

// Functions of arguments that are known before all loops, together; those whose arguments contain others of these, after them.
void Schedule::batchScalars(const std::vector<Node *> &nodes) {
  std::unordered_map<const Node *, bool> direct;
  std::unordered_map<const Node *, int> depth;
  std::map<int, Batch *> batches;
  std::map<std::pair<int, Node *>, size_t> places;
  const int afterSolution = 1 << 20;
  for (Node *n : nodes) { // arguments come first
    int d = n->op == Node::Leaf && (n->slot->kind == Slot::Qdd || n->slot->kind == Slot::Lambda) ? afterSolution : 0;
    for (const Node *arg : n->args) d = std::max(d, depth[arg]);
    bool taken = isTrig(n) && !n->loop;
    depth[n] = d + taken;
    if (!taken) continue;
    Node *arg = n->args[0];
    bool alone = !isDirect(arg, nullptr, direct);
    if (alone) d = -1 - arg->id;
    Batch *&b = batches[d];
    if (!b) {
      b = &batches_.emplace_back();
      b->id = int(batches_.size());
      b->function = "sincos";
    }
    auto at = places.emplace(std::make_pair(d, arg), b->args.size());
    if (at.second) b->args.push_back(arg);
    places_[n] = {b, graph_.integer(long(at.first->second))};
  }
}

// A function whose argument follows from the loop's number alone: all its values before the loop, in a row that loops of as many
// iterations share.
bool Schedule::batchInLoop(Node *n) {
  Loop *loop = n->loop;
  std::unordered_map<const Node *, bool> direct;
  if (n->args.size() != 1 || !loop->trips || !loop->trips->isConstant() || !isDirect(n->args[0], loop, direct)) return false;
  long trips = loop->trips->offset;
  std::string function = isTrig(n) ? "sincos" : n->text;
  // The same argument in the iterations of a loop that stands for all of that length.
  Loop *&stands = standIns_[trips];
  if (!stands) stands = graph_.loop(nullptr, loop->trips, false);
  Graph::Replacement by{{loop->index, stands->index}};
  Node *arg = graph_.replace(n->args[0], by);
  Batch *&b = rows_[{function, arg}];
  if (!b) {
    b = &batches_.emplace_back();
    b->id = int(batches_.size());
    b->function = function;
    b->loop = graph_.loop(nullptr, loop->trips, false);
    bool inPlace = arg->op == Node::Leaf && (arg->slot->kind == Slot::Q || arg->slot->kind == Slot::Qd) &&
                   arg->args[0]->terms.size() == 1 && arg->args[0]->terms[0].second == 1;
    Graph::Replacement own{{stands->index, b->loop->index}};
    if (inPlace) {
      b->first = graph_.leaf(arg->slot, {graph_.integer(arg->args[0]->offset)});
    } else {
      b->filled = graph_.array("arguments", trips);
      graph_.write(b->filled, b->loop, b->loop->index, graph_.replace(arg, own));
    }
  }
  places_[n] = {b, loop->index};
  return true;
}

void Schedule::makeBatches() {
  std::vector<Node *> nodes = need(0, true).nodes;
  std::sort(nodes.begin(), nodes.end(), ById());
  batchScalars(nodes);
  for (Node *n : nodes)
    if (n->op == Node::Math && n->loop && !batchInLoop(n) && isTrig(n)) batchAlone(n);
}

// sin and cos of one argument in the iterations of a loop.
void Schedule::batchAlone(Node *n) {
  Batch *&b = rows_[{"", n->args[0]}];
  if (!b) {
    b = &batches_.emplace_back();
    b->id = int(batches_.size());
    b->function = "sincos";
    b->args = {n->args[0]};
  }
  places_[n] = {b, graph_.integer(0)};
}

void Schedule::countUses() {
  Wanted needed = need(0, true);
  countOperations(needed);
  for (const Node *n : needed.nodes) {
    if (n->op != Node::Taylor) continue;
    int &order = highest_[{n->text, n->args[0]}];
    order = std::max(order, n->which);
  }
  auto use = [&](const Node *n, const Loop *in) {
    if (!n) return;
    Use &u = uses_[n];
    ++u.count;
    u.deeper |= n->loop != in;
  };
  for (const Node *n : needed.nodes)
    if (!places_.count(n))
      for (const Node *arg : n->args) use(arg, n->loop);
  for (const Batch *b : needed.batches)
    for (const Node *arg : b->args) use(arg, arg->loop);
  for (const Loop *l : needed.loops) use(l->trips, l->outer), use(l->condition, l);
  for (auto &[l, which] : needed.carried) use(l->carried[which].init, l->outer), use(l->carried[which].out, l);
  for (const Array *a : needed.arrays)
    for (const Write &w : a->writes) use(w.index, w.loop), use(w.value, w.loop);
  for (const Check *c : needed.checks) {
    const Loop *in = loopOf(*c);
    use(c->outside, in);
    if (c->guard) use(c->guard->holds, in);
  }
  for (const Node *n : kept_) use(n, n->loop);
  for (const RowUpdate *u : needed.updates)
    for (const Node *n : nodesOf(*u)) use(n, n->loop), use(n, n->loop); // in the midst of a loop over columns: by name
}

void Schedule::countOperations(const Wanted &needed) {
  Operations &o = operations_;
  for (const Node *n : needed.nodes) {
    const long times = iterations(n->loop);
    o.values += isOperation(n);
    if (n->op == Node::Add) o.adds += times;
    if (n->op == Node::Mul && !n->args[0]->is(-1)) o.products += times;
    if (n->loop && (n->op == Node::Add || n->op == Node::Mul)) o.repeated += times;
    if (n->op == Node::Recip) o.reciprocals += times;
    if ((n->op == Node::Math || n->op == Node::Taylor) && !place(n)) o.functions += times;
  }
  for (const Batch *b : needed.batches) o.functions += b->loop ? iterations(b->loop) : long(b->args.size()) * iterations(loopOf(*b));
  for (const Loop *l : needed.loops) o.iterations += iterations(l);
  for (const Phase &phase : phases_)
    for (const RowUpdate &u : phase.updates) {
      const long times = iterations(blockOf(u));
      for (auto &[direction, factor] : u.sum) o.adds += direction->column ? times : 0;
      o.vectors += vectorsOf(u, phase.columns) * times;
    }
}

bool Schedule::isUsedOnce(const Node *node) const {
  auto at = uses_.find(node);
  return at != uses_.end() && at->second.count == 1 && !at->second.deeper;
}

const BatchPlace *Schedule::place(const Node *node) const {
  auto at = places_.find(node);
  return at == places_.end() ? nullptr : &at->second;
}

bool Schedule::carries(const Loop *loop, size_t which) const { return now_->carried.count({loop, which}) > 0; }

std::vector<RowUpdate> Schedule::updates(const Loop *loop, bool before) const {
  std::vector<RowUpdate> found;
  for (const RowUpdate *u : now_->updates)
    if (u->loop == loop && u->before == before) found.push_back(*u);
  return found;
}

// The order of one phase's statements: each after what it depends on, near to what depends on it.
class Schedule::Ordering {
public:
  Ordering(const Schedule &schedule, const Wanted &needed) : schedule_(schedule), needed_(needed) {
    makeEntries();
    linkAll();
  }

  Blocks run() {
    Blocks blocks;
    for (const Loop *block : blocks_) blocks[block];
    for (Entry &e : entries_) // what acts comes first and draws its needs in front of itself
      if (e.item.kind != Item::Value) visit(e, blocks);
    for (Entry &e : entries_) visit(e, blocks);
    return blocks;
  }

private:
  struct Entry {
    Item item;
    const Loop *block;                           // null: outside of loops
    std::vector<std::pair<Entry *, bool>> after; // true: of a read, where a circle means an earlier iteration
    enum { New, Open, Done } state = New;
  };

  Entry *entry(const void *thing, Item item, const Loop *block) {
    Entry *e = &entries_.emplace_back(Entry{item, block, {}});
    if (thing) of_[thing] = e;
    return e;
  }

  void makeEntries() {
    blocks_.push_back(nullptr);
    for (Loop *l : needed_.loops) {
      blocks_.push_back(l);
      if (!l->condition) continue;
      Item item{Item::Condition};
      item.loop = l;
      conditions_[l] = entry(nullptr, item, l);
    }
    for (const RowUpdate *u : needed_.updates) {
      auto &known = rows_[{u->loop, u->before}];
      if (known) continue;
      Item item{u->before ? Item::Start : Item::Rows};
      item.loop = u->loop;
      known = entry(nullptr, item, blockOf(*u));
    }
    for (const Check *c : needed_.checks) {
      Item item{Item::Test};
      item.check = c;
      entry(c, item, loopOf(*c));
    }
    for (Loop *l : needed_.loops) {
      Item item{Item::Repeat};
      item.loop = l;
      entry(l, item, l->outer);
    }
    for (const Array *a : needed_.arrays) {
      if (a->summed) {
        Item item{Item::Clear};
        item.array = const_cast<Array *>(a);
        entry(a, item, a->home);
      }
      for (const Write &w : a->writes) {
        Item item{Item::Leave};
        item.array = const_cast<Array *>(a);
        item.write = &w;
        entry(&w, item, w.loop);
      }
    }
    for (const Batch *b : needed_.batches) {
      Item item{Item::Evaluate};
      item.batch = b;
      entry(b, item, loopOf(*b));
    }
    for (Node *n : needed_.nodes) {
      Item item{Item::Value};
      item.node = n;
      entry(n, item, n->loop);
    }
  }

  Entry *find(const void *thing) const {
    auto at = of_.find(thing);
    return at == of_.end() ? nullptr : at->second; // null: done in an earlier phase
  }

  // The statement of a block that holds the entry.
  Entry *lift(Entry *e, const Loop *block) const {
    while (e->block != block) e = find(e->block);
    return e;
  }

  void link(Entry *from, const void *thing, bool read = false) {
    if (Entry *to = find(thing)) linkEntries(from, to, read);
  }

  void linkEntries(Entry *from, Entry *to, bool read = false) {
    const Loop *block = tlgen::common(from->block, to->block);
    Entry *a = lift(from, block), *b = lift(to, block);
    if (a != b) a->after.push_back({b, read});
  }

  void linkNode(Entry *e, const Node *n) {
    if (const BatchPlace *p = schedule_.place(n)) {
      link(e, p->batch);
      return;
    }
    for (const Node *arg : n->args) link(e, arg);
    if (n->op == Node::Final) link(e, n->of);
    if (n->op != Node::Read) return;
    if (n->array->summed) link(e, n->array);
    for (const Write &w : n->array->writes)
      if (!w.loop || !n->loop || !n->loop->within(w.loop)) link(e, &w, true);
  }

  void linkLoop(Entry *e, const Loop *l) {
    if (l->trips) link(e, l->trips);
    for (size_t k = 0; k < l->carried.size(); ++k) {
      if (!needed_.carried.count({l, k})) continue;
      link(e, l->carried[k].init);
      link(e, l->carried[k].out);
    }
    auto start = rows_.find({l, true});
    if (start != rows_.end() && start->second != e) e->after.push_back({start->second, false});
    auto condition = conditions_.find(l);
    if (condition == conditions_.end()) return;
    link(condition->second, l->condition);
  }

  void linkRows(const RowUpdate &u) {
    Entry *e = rows_.at({u.loop, u.before});
    for (const Node *n : nodesOf(u)) link(e, n);
    for (auto &[direction, factor] : u.sum)
      for (const RowUpdate *other : needed_.updates)
        if (other->row == direction->row && !(e->block && e->block->within(blockOf(*other)) && blockOf(*other)) &&
            other->loop != u.loop)
          linkEntries(e, rows_.at({other->loop, other->before}));
  }

  void linkAll() {
    for (const RowUpdate *u : needed_.updates) linkRows(*u);
    for (Entry &e : entries_) {
      const Item &i = e.item;
      if (i.kind == Item::Value) linkNode(&e, i.node);
      if (i.kind == Item::Repeat) linkLoop(&e, i.loop);
      if (i.kind == Item::Test) {
        link(&e, i.check->outside);
        if (i.check->guard) link(&e, i.check->guard->holds);
      }
      if (i.kind == Item::Leave) {
        if (i.array->summed) link(&e, i.array);
        link(&e, i.write->index), link(&e, i.write->value);
      }
      if (i.kind != Item::Evaluate) continue;
      for (const Node *arg : i.batch->args) link(&e, arg);
      if (i.batch->filled)
        for (const Write &w : i.batch->filled->writes) link(&e, &w);
    }
  }

  static Loc placeOf(const Entry &e) { return e.item.node ? e.item.node->loc : Loc(); }

  // Depth first, without recursion: chains of values are long.
  void visit(Entry &root, Blocks &blocks) {
    if (root.state != Entry::New) return;
    std::vector<std::pair<Entry *, size_t>> path = {{&root, 0}};
    root.state = Entry::Open;
    while (!path.empty()) {
      auto &[e, next] = path.back();
      if (next == e->after.size()) {
        e->state = Entry::Done;
        blocks[e->block].push_back(e->item);
        path.pop_back();
        continue;
      }
      auto [to, read] = e->after[next++];
      if (to->state == Entry::Open && !read) throw Unsuitable{"loops that depend on each other cannot be kept", placeOf(*to)};
      if (to->state != Entry::New) continue;
      to->state = Entry::Open;
      path.push_back({to, 0});
    }
  }

  const Schedule &schedule_;
  const Wanted &needed_;
  std::deque<Entry> entries_;
  std::unordered_map<const void *, Entry *> of_;
  std::unordered_map<const Loop *, Entry *> conditions_;
  std::map<std::pair<const Loop *, bool>, Entry *> rows_; // of a loop, or before it
  std::vector<const Loop *> blocks_;
};

Blocks Schedule::order(size_t phase) {
  now_ = std::make_unique<Wanted>(need(phase, false));
  Blocks blocks = Ordering(*this, *now_).run();
  for (const Node *n : now_->nodes)
    if (!n->loop) doneNodes_.insert(n);
  for (const Array *a : now_->arrays)
    if (!a->home) doneArrays_.insert(a);
  for (const Batch *b : now_->batches)
    if (!loopOf(*b)) doneBatches_.insert(b);
  for (const Check *c : now_->checks)
    if (!loopOf(*c)) doneChecks_.insert(c);
  return blocks;
}

} // namespace tlgen
