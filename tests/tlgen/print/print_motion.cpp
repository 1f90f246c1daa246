// Makes the Lagrangian of the N-pendulum by hand, in loops and unrolled, and prints its motion functions in both forms for
// test_motion.c.
#include "MotionFunctions.h"

#include <fstream>

using namespace tlgen;

namespace {

const Slot *slot(Graph &g, Slot::Kind kind, const std::string &text = "") {
  Slot s;
  s.kind = kind;
  s.text = text;
  return g.slot(s);
}

// One link: velocity and height of the masses so far, and the energy.
struct Chain {
  Node *vx, *vy, *height, *energy;
};

Chain add(Graph &g, const Chain &before, Node *k) {
  Node *angle = g.leaf(slot(g, Slot::Q), {k}), *rate = g.leaf(slot(g, Slot::Qd), {k});
  Node *mass = g.leaf(slot(g, Slot::Member, "p->mass[%]"), {k}), *length = g.leaf(slot(g, Slot::Member, "p->length[%]"), {k});
  Node *gravity = g.leaf(slot(g, Slot::Member, "p->g"));
  Node *s = g.mul(length, g.math("sin", {angle})), *c = g.mul(length, g.math("cos", {angle}));
  Chain after;
  after.vx = g.add(before.vx, g.mul(c, rate));
  after.vy = g.add(before.vy, g.mul(s, rate));
  after.height = g.sub(before.height, c);
  Node *square = g.add(g.mul(after.vx, after.vx), g.mul(after.vy, after.vy));
  Node *energy = g.sub(g.scale(0.5, g.mul(mass, square)), g.mul(g.mul(mass, gravity), after.height));
  after.energy = g.add(before.energy, energy);
  return after;
}

Equations unrolled(Graph &g, long n) {
  Node *zero = g.number(0);
  Chain chain = {zero, zero, zero, zero};
  for (long k = 0; k < n; ++k) chain = add(g, chain, g.integer(k));
  Equations e;
  e.n = n;
  e.lagrangian = chain.energy;
  return e;
}

Equations looped(Graph &g, long n) {
  Loop *loop = g.loop(nullptr, g.integer(n), false);
  Node *zero = g.number(0);
  Chain in = {g.carry(loop, zero), g.carry(loop, zero), g.carry(loop, zero), g.carry(loop, zero)};
  Chain out = add(g, in, loop->index);
  g.setOut(in.vx, out.vx);
  g.setOut(in.vy, out.vy);
  g.setOut(in.height, out.height);
  g.setOut(in.energy, out.energy);
  Equations e;
  e.n = n;
  e.lagrangian = g.final(loop, in.energy->which);
  return e;
}

std::string functions(const std::string &name, long n, bool rows) {
  Program program;
  Record record;
  record.spelling = "struct pendulum";
  Model model;
  model.name = name;
  model.params = &record;
  MotionValues values([=](Graph &g) { return rows ? looped(g, n) : unrolled(g, n); }, rows);
  Sites sites;
  MotionFunctions print(program, model, sites);
  std::string text = "static int " + name + "_fits(const void *params) { return params != 0; }\n\n";
  long workspace = 0;
  for (const char *function : {"energy", "simulate", "residual", "linearise", "tangent", "acceleration", "jacobian", "directional"}) {
    MotionFunction made = print.print(function, values);
    text += "static " + made.definition;
    workspace = std::max(workspace, made.workspace);
  }
  return text + "enum { " + name + "_work = " + std::to_string(workspace) + " };\n\n";
}

} // namespace

int main(int argc, char **argv) {
  if (argc != 2) return 2;
  std::ofstream out(argv[1]);
  out << "_Static_assert(TL_ROW_PAD == " << ROW_PAD << ", \"rows are padded as kernels take them\");\n\n";
  for (long n : {1, 3, 9, 20}) {
    out << functions("registers" + std::to_string(n), n, false);
    out << functions("rows" + std::to_string(n), n, true);
  }
  return out.flush() ? 0 : 1;
}
