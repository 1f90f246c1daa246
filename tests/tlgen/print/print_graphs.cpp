// Makes small graphs by hand and prints them as C functions for test_print.c.
#include "PrintGraph.h"

#include <fstream>

using namespace tlgen;

namespace {

class Function {
public:
  explicit Function(std::string functionName) : name(std::move(functionName)) {
    program.files = {"source.c"};
    program.sources = {{"x = a;", "y = b; /* with a comment */"}};
  }

  Node *at(const Slot *slot, long i) { return graph.leaf(slot, {graph.integer(i)}); }
  Node *x(long i) { return at(q, i); }
  Node *sin(Node *a) { return graph.math("sin", {a}); }
  Node *cos(Node *a) { return graph.math("cos", {a}); }
  void out(long i, Node *value, size_t phase = 0) { store(graph.integer(i), value, nullptr, phase); }
  void store(Node *index, Node *value, Loop *loop, size_t phase = 0) {
    while (outs.size() <= phase) outs.push_back(graph.array("out", 8));
    graph.write(outs[phase], loop, index, value);
  }

  // between: C between the phases.
  std::string text(const std::string &between = "") {
    std::vector<Phase> phases;
    for (const Array *out : outs) phases.push_back({{out}, {}});
    Schedule schedule(graph, phases);
    Sites sites;
    GraphPrinter printer(schedule, program, sites, {"q", "qd", "qdd", "t", "work", "out", "k"});
    for (const Array *out : outs) printer.bind(out, "out[%]");
    std::string body;
    for (size_t i = 0; i < schedule.phases(); ++i) body += (i ? between : "") + printer.phase(i);
    return "static int " + name + "(const tl_real *q, const tl_real *qd, tl_real *qdd, tl_real *out, tl_real *work)\n{\n" +
           "  (void)q, (void)qd, (void)qdd, (void)work;\n" + printer.declarations() + body + printer.returnSite() + "  return 0;\n}\n\n";
  }

  std::string name;
  Program program;
  Graph graph;
  const Slot *q = slot(Slot::Q), *qd = slot(Slot::Qd), *qdd = slot(Slot::Qdd);
  std::vector<Array *> outs; // of each phase

private:
  const Slot *slot(Slot::Kind kind) {
    Slot s;
    s.kind = kind;
    return graph.slot(s);
  }
};

// Sums, differences, products, quotients; values used twice; sines and cosines together, also of arguments that contain some.
std::string straight() {
  Function f("straight");
  Graph &g = f.graph;
  Node *a = f.x(0), *b = f.x(1), *c = f.x(2);
  g.loc = {0, 1, 1};
  Node *d = g.sub(a, b);
  Node *twice = g.mul(d, g.add(a, g.scale(-2, c)));
  g.loc = {0, 2, 1};
  f.out(0, g.sub(twice, g.mul(f.cos(d), f.at(f.qd, 1))));
  f.out(1, g.add(g.div(twice, b), g.mul(f.sin(f.sin(d)), f.sin(a))));
  f.out(2, g.neg(g.sub(g.mul(a, g.sub(b, c)), g.scale(3, g.mul(b, c)))));
  f.out(3, g.scale(-0.1, g.sub(g.neg(g.mul(a, b)), g.math("exp", {g.neg(c)}))));
  f.out(4, g.sub(g.number(1), g.sub(a, g.sub(b, g.neg(g.mul(c, c))))));
  f.out(5, g.mul(g.recip(g.mul(a, a)), g.recip(g.mul(a, a))));
  return f.text();
}

// Carried values that follow from each other; the last iteration's values are used.
std::string fibonacci() {
  Function f("fibonacci");
  Graph &g = f.graph;
  Loop *l = g.loop(nullptr, g.integer(10), false);
  Node *a = g.carry(l, f.x(0)), *b = g.carry(l, f.x(1)), *n = g.carry(l, g.integer(0)), *unused = g.carry(l, f.x(2));
  g.setOut(a, b);
  g.setOut(b, g.add(a, b));
  g.setOut(n, g.integerOp("+", n, l->index));
  g.setOut(unused, g.mul(unused, a));
  f.out(0, g.final(l, 0));
  f.out(1, g.final(l, 1));
  f.out(2, g.convert("tl_real", g.final(l, 2)));
  return f.text();
}

// A swap: neither of the two can be updated first.
std::string swap() {
  Function f("swap");
  Graph &g = f.graph;
  Loop *l = g.loop(nullptr, g.integer(3), false);
  Node *a = g.carry(l, f.x(0)), *b = g.carry(l, f.x(1));
  g.setOut(a, g.scale(2, b));
  g.setOut(b, g.scale(3, a));
  f.out(0, g.final(l, 0));
  f.out(1, g.final(l, 1));
  return f.text();
}

// A prefix sum kept in an array, and a loop back over it: sines and cosines before both.
std::string tape() {
  Function f("tape");
  Graph &g = f.graph;
  Loop *up = g.loop(nullptr, g.integer(5), false);
  Node *angle = g.leaf(f.q, {up->index}), *speed = g.leaf(f.qd, {up->index});
  Node *v = g.carry(up, g.number(0));
  Node *next = g.add(v, g.mul(f.cos(angle), speed));
  g.setOut(v, next);
  Array *kept = g.array("v", 5);
  g.write(kept, up, up->index, next);

  Loop *back = g.loop(nullptr, g.integer(5), true);
  Node *total = g.carry(back, g.number(0));
  Node *more = g.add(total, g.read(kept, back->index));
  g.setOut(total, more);
  Node *again = g.leaf(f.q, {back->index});
  f.store(back->index, g.mul(more, g.sub(f.cos(again), f.sin(again))), back);
  f.out(5, g.mul(g.final(up, 0), g.final(back, 0)));
  return f.text();
}

// Rows that grow with the iteration, summed into one array.
std::string triangle() {
  Function f("triangle");
  Graph &g = f.graph;
  Loop *i = g.loop(nullptr, g.integer(4), false);
  Loop *j = g.loop(i, g.integerOp("+", i->index, g.integer(1)), false);
  Node *product = g.mul(g.leaf(f.q, {i->index}), g.leaf(f.qd, {j->index}));
  Array *sums = g.array("sums", 4);
  sums->summed = true;
  g.write(sums, j, j->index, product);
  Node *row = g.carry(j, g.number(0));
  g.setOut(row, g.add(row, product));
  f.store(g.integerOp("+", i->index, g.integer(4)), g.final(j, 0), i);
  for (long k = 0; k < 4; ++k) f.out(k, g.read(sums, g.integer(k)));
  return f.text();
}

// Newton's iteration for a square root, while it moves.
std::string newton() {
  Function f("newton");
  Graph &g = f.graph;
  Loop *l = g.loop(nullptr, nullptr, false);
  Node *x = g.carry(l, g.number(1)), *step = g.carry(l, g.number(1)), *count = g.carry(l, g.integer(0));
  l->condition = g.compare(">", g.math("fabs", {step}), g.number(1e-9));
  Node *next = g.scale(0.5, g.add(x, g.div(f.x(0), x)));
  g.setOut(x, next);
  g.setOut(step, g.sub(next, x));
  g.setOut(count, g.integerOp("+", count, g.integer(1)));
  f.out(0, g.final(l, 0));
  f.out(1, g.convert("tl_real", g.final(l, 2)));
  return f.text();
}

// A root that is taken where its argument is positive only; an unguarded one and a division, which may fail.
std::string guarded() {
  Function f("guarded");
  Graph &g = f.graph;
  Node *positive = g.compare(">", f.x(0), g.number(0));
  g.guard = g.under(nullptr, positive);
  g.loc = {0, 1, 1};
  Node *root = g.math("sqrt", {f.x(0)});
  g.guard = nullptr;
  Node *other = g.math("sqrt", {f.x(1)});
  g.loc = {0, 2, 1};
  f.out(0, g.select(positive, root, g.number(-1)));
  f.out(1, g.div(other, f.x(2)));
  f.out(2, g.recip(g.add(g.number(1), g.mul(f.x(0), f.x(0)))));
  return f.text();
}

// Two phases: what the second needs of a loop again is what it needs, and values of the first are shared.
std::string phases() {
  Function f("phases");
  Graph &g = f.graph;
  Loop *l = g.loop(nullptr, g.integer(3), false);
  Node *a = g.carry(l, g.number(0)), *b = g.carry(l, g.number(0));
  Node *square = g.mul(g.leaf(f.q, {l->index}), g.leaf(f.q, {l->index}));
  g.setOut(a, g.add(a, square));
  g.setOut(b, g.add(b, g.mul(square, g.leaf(f.qdd, {l->index}))));
  Node *shared = g.math("exp", {f.x(0)});
  f.out(0, g.mul(shared, g.final(l, 0)), 0);
  f.out(1, g.mul(shared, g.final(l, 1)), 1);
  f.out(2, g.final(l, 0), 1);
  return f.text("  for (int i = 0; i < 3; ++i) qdd[i] = out[0] + (double)i;\n");
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  std::ofstream out(argv[1]);
  out << straight() << fibonacci() << swap() << tape() << triangle() << newton() << guarded() << phases();
  return out.flush() ? 0 : 1;
}
