"""Random programs over the C that tlgen accepts, the same for the same seed: parameters, helpers, a Lagrangian, forces, constraints."""
import random

from helpers import Helpers
from scope import VARIABLE, Array, Integer, Scope
from tree import Function, Member, Node, Program


class Generator(Helpers):
    """Makes one program."""

    def __init__(self, name, seed):
        self.random = random.Random(seed)
        self.serial = 0
        self.helpers = []
        self.cost = 0  # of the function that is being made, in elementary functions
        self.n = self.random.choice([1, 1, 2, 2, 2, 2, 2, 3, 3, 3, 4, 6])
        self.by_member = self.random.random() < 0.5
        self.program = Program(name, "n" if self.by_member else str(self.n))
        self.dof = "p->n" if self.by_member else str(self.n)
        self.make_members()

    def make_members(self):
        members = self.program.members
        members.append(Member("double", "k", [self.number()]))
        if self.by_member:
            members.append(Member("int", "n", [self.n]))
        members.append(Member("int", "rounds", [self.random.randint(2, 3)]))
        members.append(Member("int", "mode", [self.random.randint(1, 2)]))
        members.append(Member("double", "mass", [self.number() for _ in range(6)], True))
        members.append(Member("double", "rest", [round(self.random.uniform(-1, 1), 2) for _ in range(self.random.randint(2, 4))], True))
        self.program.sizes += [name for name in ("rounds", "mode") if self.chance(0.95 if name == "rounds" else 0.2)]
        self.rounds = members[-4].values[0]
        table = [str(self.number()) for _ in range(self.random.randint(2, 5))]
        self.table = Array("table", len(table), str(len(table)), False)
        self.program.tables.append((f"static const double table[{len(table)}] = {{{', '.join(table)}}};", "table"))

    def function_scope(self, q=False, qd=False, t=False, p=False):
        scope = Scope()
        scope.has_p = p
        scope.arrays.append(self.table)
        if q:
            scope.arrays.append(Array("q", self.n, self.dof, False))
        if qd:
            scope.arrays.append(Array("qd", self.n, self.dof, False))
        if t:
            scope.leaves.append(("t", 1.0))
            scope.targets.append("t")
        if p:
            scope.arrays.append(Array("p->mass", 6, "6", False))
            rest = self.program.members[-1]
            scope.arrays.append(Array("p->rest", len(rest.values), str(len(rest.values)), False))
        return scope

    def parameters(self, **has):
        """The head's parameters, in any order."""
        texts = {"q": "const double *q", "qd": "const double *qd", "t": "double t", "p": "const struct params *p", "out": "double *out"}
        names = [name for name in texts if has.get(name)]
        if self.chance(0.3):
            self.random.shuffle(names)
        return "(" + ", ".join(texts[name] for name in names) + ")"

    def lagrangian(self):
        has = {"q": True, "qd": True, "t": self.chance(0.5), "p": self.by_member or self.chance(0.5), "out": self.chance(0.15)}
        scope = self.function_scope(q=True, qd=True, t=has["t"], p=has["p"])
        self.cost = 0
        scope.result = None if has["out"] else "double"
        scope.leaves.append(("L", VARIABLE))
        scope.targets += ["L", "L"]
        body = Node("block", [self.statement("double L = 0.0;")])
        kinetic = self.statement(f"for (int i = 0; i < {self.dof}; i++) L += {self.pick('4.0', '8.0', '15.0')}",
                                 " * p->mass[i]" if has["p"] and self.chance(0.5) else "", " * qd[i] * qd[i];")
        first = self.chance(0.3)
        if first:
            body.parts.append(kinetic)
            scope.result = None if self.chance(0.5) else scope.result
        else:
            scope.result = None
        body.parts += self.block(scope, self.random.randint(2, 5)).parts
        body.parts.append(self.statement("L += ", self.double(scope, 3).node, ";"))
        i, j = self.random.randrange(self.n), self.random.randrange(self.n)
        body.parts.append(self.statement(f"L += 0.5 * qd[{i}] * qd[{j}] * ", self.squeeze(self.double(scope, 3), 2.0).safe, ";"))
        if not first:
            body.parts.append(kinetic)
        body.parts.append(self.statement("*out = L;" if has["out"] else "return L;", fixed=True))
        head = f"{'void' if has['out'] else 'double'} lagrangian{self.parameters(**has)}"
        self.program.functions.append(Function("lagrangian", head, body, "--lagrangian lagrangian", True))

    def force(self):
        has = {"q": self.chance(0.6), "qd": True, "t": self.chance(0.4), "p": self.by_member or self.chance(0.3), "out": True}
        scope = self.function_scope(q=has["q"], qd=True, t=has["t"], p=has["p"])
        self.cost = 60
        body = self.block(scope, self.random.randint(0, 2))
        inner = scope.inner()
        inner.loops, inner.rounds = 1, self.n
        if self.chance(0.6):
            inner.integers.append(Integer("i", 0, self.n - 1))
            body.parts.append(self.statement(f"for (int i = 0; i < {self.dof}; i++) out[i] = -", self.double(inner, 3).safe, ";"))
        else:
            body.parts.append(self.statement(f"out[{self.random.randrange(self.n)}] = ", self.double(scope, 3).node, ";"))
        self.program.functions.append(Function("force", "void force" + self.parameters(**has), body, "--force force", True))

    def constraint(self, name, role, rows, first):
        """A constraint whose row r surely moves coordinate first + r."""
        speeds = role == "nonholonomic"
        has = {"q": True, "qd": speeds, "t": self.chance(0.4), "p": self.chance(0.4), "out": rows > 1 or self.chance(0.2)}
        scope = self.function_scope(q=True, qd=speeds, t=has["t"], p=has["p"])
        if self.by_member and not has["p"]:
            scope.arrays = [a for a in scope.arrays if a.text not in ("q", "qd")]
            scope.arrays += [Array(v, self.n, str(self.n), False) for v in (["q", "qd"] if speeds else ["q"])]
        self.cost = 60
        if not has["out"]:
            scope.result = "double" if self.chance(0.3) else None
        body = self.block(scope, self.random.randint(0, 2))
        for r in range(rows):
            lead = f"{'qd' if speeds else 'q'}[{first + r}]"
            to = f"out[{r}] = " if has["out"] else "return "
            angle = f"{self.pick('sin', 'cos')}(q[{self.random.randrange(self.n)}] + "
            factor = self.squeeze(self.double(scope, 3), 1.0)
            body.parts.append(self.statement(f"{to}{self.pick('4.0', '7.0')} * {lead} + {angle}", self.double(scope, 1).safe, ") * ", factor.safe,
                                             ";", fixed=True))
        head = f"{'void' if has['out'] else 'double'} {name}{self.parameters(**has)}"
        self.program.functions.append(Function(name, head, body, f"--{role} {name}:{rows}", True))

    def make(self):
        for k in range(self.random.choice([0, 0, 1, 1, 1, 2, 2, 3])):
            self.helper(f"helper{k + 1}")
        self.lagrangian()
        if self.chance(0.35):
            self.force()
        free = self.n - 1
        for name, role in (("phi", "holonomic"), ("psi", "nonholonomic")):
            if free > 0 and self.chance(0.35):
                rows = self.random.randint(1, min(2, free))
                self.constraint(name, role, rows, self.n - 1 - free)
                free -= rows
        return self.program


def generate(name, seed):
    """The program of that seed: a tree.Program."""
    return Generator(name, seed).make()


if __name__ == "__main__":
    import sys
    print(generate("program", sys.argv[1] if len(sys.argv) > 1 else "1"))
