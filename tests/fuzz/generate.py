"""Random programs over the C that tlgen accepts, the same for the same seed.

Numbers stay near 1 and functions inside their domains, so that every derivative exists at nearly every point and rounding stays small:
each expression carries a rough bound, and is squeezed where that grows.
"""
import random

from tree import Function, Member, Node, Program

LARGEST = 6.0  # bound that an expression may have
VARIABLE = 4.0  # bound that every variable is taken to have

# Functions of math.h inside their domains: text with {a}, {b} for arguments, and a bound from theirs.
SMOOTH = [
    ("sin({a})", 1), ("cos({a})", 1), ("sin({a})", 1), ("cos({a})", 1), ("atan({a})", 1.6), ("tanh({a})", 1), ("asinh({a})", 2.5),
    ("erf({a})", 1), ("erfc(0.5 * {a})", 2), ("exp(sin({a}))", 2.8), ("exp(-{a} * {a})", 1), ("expm1(0.5 * cos({a}))", 1),
    ("exp2(sin({a}))", 2), ("log(1.5 + {a} * {a})", 3), ("log1p({a} * {a})", 3), ("log2(2.0 + sin({a}))", 1.6), ("log10(3.0 + {a} * {a})", 2),
    ("sqrt(1.0 + {a} * {a})", 4), ("cbrt(2.0 + cos({a}))", 1.5), ("tan(0.6 * sin({a}))", 0.7), ("asin(0.8 * sin({a}))", 1),
    ("acos(0.7 * cos({a}))", 2.4), ("atanh(0.6 * sin({a}))", 0.7), ("acosh(1.5 + {a} * {a})", 4), ("sinh(sin({a}))", 1.2),
    ("cosh(0.5 * sin({a}))", 1.2), ("tgamma(2.5 + sin({a}))", 3.4), ("lgamma(3.0 + sin({a}))", 1.8), ("pow({a}, 2)", 9), ("pow({a}, 3.0)", 9),
    ("pow(1.5 + {a} * {a}, 0.5 * sin({b}))", 4), ("pow(2.0, sin({a}))", 2), ("hypot({a}, 1.0 + {b} * {b})", 6), ("hypot({a}, 1.5)", 5),
    ("atan2({a}, 1.5 + {b} * {b})", 1.6), ("atan2(sin({a}), 2.0 + cos({b}))", 1), ("fma({a}, 0.5, {b})", 6), ("ldexp({a}, -1)", 3),
    ("{a} / (1.5 + {b} * {b})", 4), ("{a} / (2.0 + sin({b}))", 4), ("1.0 / (1.0 + {a} * {a})", 1), ("{a} / sqrt(1.0 + {a} * {a})", 1)]
# Functions with a kink or a jump somewhere.
KINKED = [("fabs({a} - 0.37)", 5), ("fmin({a}, {b} + 0.21)", 5), ("fmax({a} - 0.13, sin({b}))", 5), ("fdim({a}, 0.29)", 5),
          ("copysign(1.0 + {a} * {a}, {b} - 0.31)", 6), ("fmod({a} + 2.3, 1.7)", 1.7), ("floor(2.0 * {a}) * sin({b})", 8),
          ("sin({a}) * trunc({b} + 3.1)", 7)]
COMPARE = ["<", ">", "<=", ">="]


class Double:
    """An expression of type double and its bound."""

    def __init__(self, parts, bound, atom=False):
        self.node, self.bound, self.atom = Node("double", parts), bound, atom

    @property
    def safe(self):
        """As an operand of any operator."""
        return self.node if self.atom else Node("double", ["(", self.node, ")"])


class Array:
    """An array of doubles with that many elements; count is how C says so."""

    def __init__(self, text, length, count, writable=True):
        self.text, self.length, self.count, self.writable = text, length, count, writable


class Integer:
    """An integer variable and the values that it may have."""

    def __init__(self, text, low, high):
        self.text, self.low, self.high = text, low, high


class Helper:
    """A helper function that may be called, and how much that costs."""

    def __init__(self, name, kind, cost, takes_p=False):
        self.name, self.kind, self.cost, self.takes_p = name, kind, cost, takes_p


class Scope:
    """What a place in the program can read and write."""

    def __init__(self):
        self.leaves = []  # (text, bound) that can be read
        self.targets = []  # texts of doubles that can be written
        self.arrays, self.integers, self.pairs = [], [], []
        self.has_p = False
        self.loops = 0  # depth
        self.rounds = 1  # of all loops around, multiplied
        self.in_switch = False
        self.result = None  # of a function that may return early: the kind of what it returns

    def inner(self):
        scope = Scope()
        scope.__dict__.update(self.__dict__)
        for name in ("leaves", "targets", "arrays", "integers", "pairs"):
            setattr(scope, name, list(getattr(self, name)))
        return scope


class Generator:
    """Makes one program."""

    def __init__(self, name, seed):
        self.random = random.Random(seed)
        self.serial = 0
        self.helpers = []
        self.cost = 0  # of the function that is being made, in elementary functions
        self.n = self.random.choice([1, 2, 2, 2, 3, 3, 3, 4, 4, 6])
        self.by_member = self.random.random() < 0.5
        self.program = Program(name, "n" if self.by_member else str(self.n))
        self.dof = "p->n" if self.by_member else str(self.n)
        self.make_members()

    # Choices.

    def chance(self, probability):
        return self.random.random() < probability

    def pick(self, *choices):
        return self.random.choice(choices)

    def fresh(self, stem):
        self.serial += 1
        return f"{stem}{self.serial}"

    def literal(self):
        return self.pick("0.5", "0.25", "1.5", "0.3", "0.7", "2.0", "1.1", "0.9", "1.25", "0.8")

    def number(self):
        return round(self.random.uniform(0.3, 1.7), 2)

    def make_members(self):
        members = self.program.members
        members.append(Member("double", "k", [self.number()]))
        if self.by_member:
            members.append(Member("int", "n", [self.n]))
        members.append(Member("int", "rounds", [self.random.randint(2, 3)]))
        members.append(Member("int", "mode", [self.random.randint(1, 2)]))
        members.append(Member("double", "mass", [self.number() for _ in range(6)], True))
        members.append(Member("double", "rest", [round(self.random.uniform(-1, 1), 2) for _ in range(self.random.randint(2, 4))], True))
        self.program.sizes += [name for name in ("rounds", "mode") if self.chance(0.8 if name == "rounds" else 0.2)]
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

    # Expressions.

    def index(self, scope, array):
        """An index that fits the array."""
        fitting = [i for i in scope.integers if 0 <= i.low and i.high < array.length]
        others = [i for i in scope.integers if i.low >= 0]
        if fitting and self.chance(0.7):
            i = self.random.choice(fitting).text
            return f"{array.count} - 1 - {i}" if self.chance(0.15) else i
        if others and self.chance(0.5):
            return f"({self.random.choice(others).text} + {self.random.randint(0, 3)}) % {array.count}"
        return str(self.random.randrange(array.length))

    def element(self, scope, array):
        return f"{array.text}[{self.index(scope, array)}]"

    def leaf(self, scope):
        state = [a for a in scope.arrays if a.text in ("q", "qd")]
        if state and self.chance(0.5):
            return Double([self.element(scope, self.random.choice(state))], 1.0, True)
        choice = self.random.random()
        if choice < 0.5 and scope.leaves:
            text, bound = self.random.choice(scope.leaves)
            return Double([text], bound, True)
        if choice < 0.7 and scope.arrays:
            array = self.random.choice(scope.arrays)
            return Double([self.element(scope, array)], VARIABLE if array.writable else 1.7, True)
        if choice < 0.8 and scope.pairs:
            return Double([f"{self.random.choice(scope.pairs)}.{self.pick('x', 'y')}"], VARIABLE, True)
        if choice < 0.85 and scope.integers:
            i = self.random.choice(scope.integers)
            return Double([self.pick(f"(double){i.text}", f"({i.text} + 1)")], float(i.high + 1), True)
        if scope.leaves and choice < 0.95:
            text, bound = self.random.choice(scope.leaves)
            return Double([text], bound, True)
        if scope.has_p and self.chance(0.5):
            return Double(["p->k"], 1.7, True)
        literal = self.literal()
        return Double([literal], float(literal), True)

    def squeeze(self, e, bound=LARGEST):
        if e.bound <= bound:
            return e
        if self.chance(0.5):
            return Double([self.pick("sin", "cos"), "(", e.node, ")"], 1.0, True)
        factor = 0.5
        while factor * e.bound > bound:
            factor /= 2
        return Double([f"{factor} * ", e.safe], factor * e.bound)

    def math(self, scope, depth, table):
        text, bound = self.random.choice(table)
        names = {"{a}": self.double(scope, depth - 1), "{b}": self.double(scope, depth - 1)}
        parts = []
        while text:
            at = min((text.find(name) for name in names if name in text), default=-1)
            if at < 0:
                parts.append(text)
                break
            parts += [text[:at], names[text[at:at + 3]].safe]
            text = text[at + 3:]
        self.cost += 2
        return Double([part for part in parts if part != ""], bound, False)

    def double(self, scope, depth):
        choice = self.random.random()
        if depth <= 0 or choice < 0.12:
            return self.leaf(scope)
        if choice < 0.3:
            a, b = self.double(scope, depth - 1), self.double(scope, depth - 1)
            return self.squeeze(Double([a.node, " + ", b.safe], a.bound + b.bound))
        if choice < 0.42:
            a, b = self.double(scope, depth - 1), self.double(scope, depth - 1)
            return self.squeeze(Double([a.node, " - ", b.safe], a.bound + b.bound))
        if choice < 0.66:
            a, b = self.double(scope, depth - 1), self.double(scope, depth - 1)
            return self.squeeze(Double([a.safe, " * ", b.safe], a.bound * b.bound))
        if choice < 0.7:
            a = self.double(scope, depth - 1)
            return Double(["-", a.safe], a.bound)
        if choice < 0.86:
            return self.squeeze(self.math(scope, depth, SMOOTH))
        if choice < 0.88:
            return self.squeeze(self.math(scope, depth, KINKED))
        if choice < 0.93:
            a, b = self.double(scope, depth - 1), self.double(scope, depth - 1)
            return Double([self.condition(scope, depth - 1), " ? ", a.safe, " : ", b.safe], max(a.bound, b.bound))
        return self.call(scope, depth) or self.leaf(scope)

    def condition(self, scope, depth):
        choice = self.random.random()
        if choice < 0.2 and scope.integers:
            i = self.random.choice(scope.integers).text
            return Node("condition", [self.pick(f"{i} > 0", f"{i} % 2 == 0", f"{i} == 1", f"{i} < 2")])
        if choice < 0.3 and scope.has_p:
            return Node("condition", [self.pick("p->mode == 1", "p->mode > 0", "p->k > 0.8", "p->rounds < 3")])
        if choice < 0.4 and depth > 0:
            operator = self.pick(" && ", " || ")
            return Node("condition", ["(", self.condition(scope, depth - 1), operator, self.condition(scope, depth - 1), ")"])
        a = self.double(scope, min(depth, 1))
        if self.chance(0.6):
            return Node("condition", [a.safe, f" {self.random.choice(COMPARE)} {self.literal()}"])
        return Node("condition", [a.safe, f" {self.random.choice(COMPARE)} ", self.double(scope, min(depth, 1)).safe])

    def affordable(self, scope, kinds):
        return [h for h in self.helpers if h.kind in kinds and (scope.has_p or not h.takes_p) and h.cost * scope.rounds + self.cost < 150]

    def call(self, scope, depth):
        """A helper that is used for its value."""
        helpers = self.affordable(scope, ("value", "reduce", "decide", "level", "apply"))
        if not helpers:
            return None
        helper = self.random.choice(helpers)
        self.cost += helper.cost * scope.rounds
        p = ", p" if helper.takes_p else ""
        a, b = self.double(scope, depth - 1), self.double(scope, depth - 1)
        if helper.kind == "value":
            return Double([f"{helper.name}(", a.node, ", ", b.node, f"{p})"], VARIABLE, True)
        if helper.kind == "level":
            return Double([f"{helper.name}({self.random.randint(1, 3)}, ", a.node, f"{p})"], VARIABLE, True)
        if helper.kind == "apply":
            return Double([f"{helper.name}({self.pick('sin', 'cos', 'atan')}, ", a.node, ")"], 2.0, True)
        if helper.kind == "decide":
            return Double([f"({helper.name}(", a.node, f"{p}) > 0 ? ", a.safe, " : ", b.safe, ")"], max(a.bound, b.bound), True)
        if not scope.arrays:
            return None
        array = self.random.choice(scope.arrays)
        return Double([f"{helper.name}({array.count}, {array.text}, ", a.node, f"{p})"], VARIABLE, True)

    # Statements. Each method returns a list of them, or None where it does not fit the place.

    @staticmethod
    def statement(*parts, fixed=False):
        return Node("statement", list(parts), fixed)

    def declare(self, scope):
        name = self.fresh("x")
        e = self.double(scope, 3)
        scope.leaves.append((name, VARIABLE))
        scope.targets.append(name)
        return [self.statement(f"double {name} = ", e.node, ";")]

    def target(self, scope):
        choice = self.random.random()
        arrays = [a for a in scope.arrays if a.writable]
        if choice < 0.3 and arrays:
            return self.element(scope, self.random.choice(arrays))
        if choice < 0.4 and scope.pairs:
            return f"{self.random.choice(scope.pairs)}.{self.pick('x', 'y')}"
        return self.random.choice(scope.targets) if scope.targets else None

    def assign(self, scope):
        target = self.target(scope)
        if not target:
            return None
        e = self.double(scope, 3)
        choice = self.random.random()
        if choice < 0.35:
            return [self.statement(f"{target} = ", self.squeeze(e, VARIABLE).node, ";")]
        if choice < 0.85:
            return [self.statement(f"{target} {self.pick('+=', '-=')} ", self.squeeze(e, 1.0 if scope.loops else VARIABLE).node, ";")]
        if choice < 0.93:
            return [self.statement(f"{target} *= ", self.pick("0.5 + 0.4 * ", "1.0 - 0.3 * "), "sin(", e.node, ")", ";")]
        if choice < 0.96:
            return [self.statement(f"{target} /= 1.5 + ", self.squeeze(e, 1.2).safe, " * ", self.squeeze(e, 1.2).safe, ";")]
        simple = [text for text in scope.targets if text.isidentifier()]
        if len(simple) < 2:
            return None
        target, other = self.random.sample(simple, 2)
        if target == other:
            return None
        return [self.statement(f"{target} = {other} = ", self.squeeze(e, VARIABLE).node, ";")]

    def count(self, scope):
        """A number of rounds: text and value."""
        choices = [(self.dof, self.n)] if scope.has_p or not self.by_member else []
        choices += [(str(r), r) for r in (2, 3)]
        if scope.has_p:
            choices.append(("p->rounds", self.rounds))
        choices += [(a.count, a.length) for a in scope.arrays if a.length <= 4]
        return self.random.choice(choices)

    def loop_scope(self, scope, rounds):
        if scope.loops >= 3 or scope.rounds * rounds > 30 or self.cost > 120:
            return None
        inner = scope.inner()
        inner.loops += 1
        inner.rounds *= max(rounds, 1)
        inner.in_switch = False
        return inner

    def counted(self, scope):
        text, rounds = self.count(scope)
        inner = self.loop_scope(scope, rounds)
        if not inner:
            return None
        i = "ijkl"[scope.loops]
        kind = self.random.random()
        low = 0
        if kind < 0.55:
            head = f"for (int {i} = 0; {i} < {text}; {self.pick(i + '++', '++' + i)}) "
        elif kind < 0.7:
            head = f"for (int {i} = {text} - 1; {i} >= 0; {i}--) "
        elif kind < 0.8:
            low = 1
            head = f"for (int {i} = 1; {i} < {text}; {i}++) "
        elif kind < 0.9:
            head = f"for (int {i} = 0; {i} < {text}; {i} += 2) "
        else:
            outer = [j for j in scope.integers if j.text in "ijkl" and 0 <= j.low and j.high <= rounds]
            if not outer:
                return None
            head = f"for (int {i} = {self.random.choice(outer).text}; {i} < {text}; {i}++) "
        inner.integers.append(Integer(i, low, rounds - 1))
        if rounds - 1 < low:
            inner.integers.pop()
        return [self.statement(head, self.block(inner, self.random.randint(1, 3)))]

    def do_loop(self, scope):
        text, rounds = self.count(scope)
        inner = self.loop_scope(scope, rounds)
        if not inner:
            return None
        k = self.fresh("k")
        inner.integers.append(Integer(k, 1, rounds))
        body = self.block(inner, self.random.randint(1, 2))
        if self.chance(0.5):
            return [self.statement(f"int {k} = {text};"), self.statement("do ", body, f" while (--{k} > 0);")]
        body.parts.append(self.statement(f"{k}--;", fixed=True))
        return [self.statement(f"int {k} = {text};"), self.statement(f"while ({k} > 0) ", body)]

    def endless(self, scope):
        text, rounds = self.count(scope)
        inner = self.loop_scope(scope, rounds)
        if not inner:
            return None
        k = self.fresh("k")
        stop = self.statement(f"if ({k}++ >= {text}) break;", fixed=True)
        body = self.block(inner, self.random.randint(1, 2))
        body.parts.insert(0, stop)
        return [self.statement(f"int {k} = 0;"), self.statement("for (;;) ", body)]

    def leave(self, scope):
        """break or continue under a condition."""
        if not scope.loops or scope.in_switch:
            return None
        return [self.statement("if (", self.condition(scope, 1), f") {self.pick('break', 'continue')};")]

    def branch(self, scope):
        parts = ["if (", self.condition(scope, 2), ") ", self.block(scope.inner(), self.random.randint(1, 2))]
        if self.chance(0.3):
            parts += [" else if (", self.condition(scope, 1), ") ", self.block(scope.inner(), 1)]
        if self.chance(0.6):
            parts += [" else ", self.block(scope.inner(), self.random.randint(1, 2))]
        return [self.statement(*parts)]

    def switch(self, scope):
        chosen = [f"{i.text} % 3" for i in scope.integers if i.low >= 0] + (["p->mode"] if scope.has_p else [])
        if not chosen:
            return None
        body = Node("block", [])
        for label in ("case 0", "case 1", "default"):
            inner = scope.inner()
            inner.in_switch = True
            body.parts.append(self.statement(f"{label}: ", self.block(inner, self.random.randint(1, 2)), fixed=True))
            if self.chance(0.7):
                body.parts.append(self.statement("break;"))
        return [self.statement(f"switch ({self.random.choice(chosen)}) ", body)]

    def array(self, scope):
        name = self.fresh("a")
        text, length = self.count(scope)
        if length < 2 or self.chance(0.3):
            length = self.random.randint(2, 4)
            text = str(length)
        constant = text.isdigit()
        array = Array(name, length, text)
        if constant and self.chance(0.5):
            values, given = [], self.random.randint(1, length)
            for i in range(given):
                values += ([", "] if i else []) + [self.squeeze(self.double(scope, 2), VARIABLE).node]
            scope.arrays.append(array)
            return [self.statement(f"double {name}[{length}] = {{", *values, "};")]
        inner = self.loop_scope(scope, length)
        if not inner:
            return None
        i = "ijkl"[scope.loops]
        inner.integers.append(Integer(i, 0, length - 1))
        e = self.squeeze(self.double(inner, 3), VARIABLE)
        scope.arrays.append(array)
        return [self.statement(f"double {name}[{text}];"),
                self.statement(f"for (int {i} = 0; {i} < {text}; {i}++) {name}[{i}] = ", e.node, ";")]

    def running(self, scope):
        """An array that is changed by its own neighbours."""
        arrays = [a for a in scope.arrays if a.writable]
        inner = self.loop_scope(scope, 3)
        if not arrays or not inner:
            return None
        a = self.random.choice(arrays)
        i = "ijkl"[scope.loops]
        if a.length > 1:
            inner.integers.append(Integer(i, 1, a.length - 1))
        e = self.squeeze(self.double(inner, 2), 1.0)
        kind = self.random.random()
        if kind < 0.4:
            return [self.statement(f"for (int {i} = 1; {i} < {a.count}; {i}++) {a.text}[{i}] {self.pick('+=', '-=', '=')} 0.5 * {a.text}[{i} - 1] * ", e.safe, ";")]
        if kind < 0.6:
            return [self.statement(f"for (int {i} = {a.count} - 1; {i} > 0; {i}--) {a.text}[{i}] = {a.text}[{i} - 1];")]
        if kind < 0.8:
            return [self.statement(f"for (int {i} = 1; {i} < {a.count}; {i}++) {a.text}[{i} - 1] -= {a.text}[{i}] * sin(", e.node, ");")]
        k = self.fresh("k")
        return [self.statement(f"for (int {i} = 0, {k} = {a.count} - 1; {i} < {k}; {i}++, {k}--) ", Node("block", [
            self.statement(f"double kept = {a.text}[{i}];"), self.statement(f"{a.text}[{i}] = {a.text}[{k}];"), self.statement(f"{a.text}[{k}] = kept;")]))]

    def walk(self, scope):
        """A sum through a pointer."""
        inner = self.loop_scope(scope, 3)
        if not scope.arrays or not scope.targets or not inner:
            return None
        a, target, w = self.random.choice(scope.arrays), self.random.choice(scope.targets), self.fresh("w")
        e = self.squeeze(self.double(inner, 2), 1.0)
        kind = self.random.random()
        if kind < 0.4:
            return [self.statement(f"for (const double *{w} = {a.text}, *end = {a.text} + {a.count}; {w} < end; {w}++) {target} += 0.5 * *{w} * ", e.safe, ";")]
        if kind < 0.7:
            return [self.statement(f"const double *{w} = {a.text};"), self.statement(f"while ({w} < {a.text} + {a.count}) {target} += 0.5 * *{w}++ * ", e.safe, ";")]
        return [self.statement(f"const double *{w} = {a.text} + {a.count};"), self.statement(f"while ({w} > {a.text}) {target} = 0.5 * {target} + sin(*--{w}) * ", e.safe, ";")]

    def queue(self, scope):
        """An array filled under a running index, and read up to there."""
        inner = self.loop_scope(scope, 3)
        if not inner or not scope.targets:
            return None
        a, k, i = self.fresh("a"), self.fresh("k"), "ijkl"[scope.loops]
        target = self.random.choice(scope.targets)
        inner.integers.append(Integer(i, 0, 2))
        e = self.squeeze(self.double(inner, 2), VARIABLE)
        return [self.statement(f"double {a}[3] = {{0.0}};"), self.statement(f"int {k} = 0;"),
                self.statement(f"for (int {i} = 0; {i} < 3; {i}++) if (", self.condition(inner, 1), f") {a}[{k}++] = ", e.node, ";"),
                self.statement(f"while ({k} > 0) {target} += 0.3 * {a}[--{k}];")]

    def matrix(self, scope):
        inner = self.loop_scope(scope, 9)
        if not inner or not scope.targets:
            return None
        m, i, j = self.fresh("m"), "ijkl"[scope.loops], "ijkl"[scope.loops + 1]
        size = self.random.randint(2, 3)
        target = self.random.choice(scope.targets)
        inner.integers += [Integer(i, 0, size - 1), Integer(j, 0, size - 1)]
        fill, use = self.squeeze(self.double(inner, 3), 2.0), self.squeeze(self.double(inner, 2), 1.0)
        loops = f"for (int {i} = 0; {i} < {size}; {i}++) for (int {j} = {self.pick('0', i)}; {j} < {size}; {j}++) "
        return [self.statement(f"double {m}[{size}][{size}] = {{{{0.0}}}};"), self.statement(loops, f"{m}[{i}][{j}] = ", fill.node, ";"),
                self.statement(loops, f"{target} += 0.2 * {m}[{j}][{i}] * {m}[{i}][{j}] * ", use.safe, ";")]

    def alias(self, scope):
        targets = [t for t in scope.targets if not t.startswith("*")]
        if not targets:
            return None
        name, target = self.fresh("z"), self.random.choice(targets)
        arrays = [a for a in scope.arrays if a.writable]
        place = f"&{target}"
        if arrays and self.chance(0.4):
            place = f"&{self.element(scope, self.random.choice(arrays))}"
        elif len(targets) > 1 and scope.has_p and self.chance(0.3):
            place = f"p->mode > 0 ? &{target} : &{self.random.choice(targets)}"
        scope.targets.append(f"*{name}")
        scope.leaves.append((f"*{name}", VARIABLE))
        return [self.statement(f"double *{name} = {place};")]

    def pair(self, scope):
        name = self.fresh("u")
        helpers = self.affordable(scope, ("pair",))
        if scope.pairs and self.chance(0.4):
            value = [self.random.choice(scope.pairs)]
            if helpers:
                value = [f"{helpers[0].name}({value[0]}, ", self.double(scope, 2).node, ", p)" if helpers[0].takes_p else ")"]
                self.cost += helpers[0].cost * scope.rounds
        else:
            value = ["{", self.squeeze(self.double(scope, 2), VARIABLE).node, ", ", self.squeeze(self.double(scope, 2), VARIABLE).node, "}"]
        scope.pairs.append(name)
        return [self.statement(f"struct pair {name} = ", *value, ";")]

    def change_pair(self, scope):
        helpers = self.affordable(scope, ("spoil",))
        if not scope.pairs:
            return None
        u = self.random.choice(scope.pairs)
        if helpers and self.chance(0.7):
            self.cost += helpers[0].cost * scope.rounds
            return [self.statement(f"{helpers[0].name}(&{u}, ", self.double(scope, 2).node, ", p);" if helpers[0].takes_p else ");")]
        other = self.random.choice(scope.pairs)
        return None if other == u else [self.statement(f"{u} = {other};")]

    def out_call(self, scope):
        """A helper that returns through pointers."""
        helpers = self.affordable(scope, ("out", "inplace"))
        if not helpers:
            return None
        h = self.random.choice(helpers)
        p = ", p" if h.takes_p else ""
        arrays = [a for a in scope.arrays if a.writable]
        if h.kind == "inplace":
            if not arrays:
                return None
            a = self.random.choice(arrays)
            self.cost += h.cost * scope.rounds
            return [self.statement(f"{h.name}({a.count}, {a.text}, ", self.squeeze(self.double(scope, 2), VARIABLE).node, f"{p});")]
        targets = [t for t in scope.targets if not t.startswith("*")]
        if len(targets) < 2:
            return None
        self.cost += h.cost * scope.rounds
        return [self.statement(f"{h.name}(", self.double(scope, 2).node, f", &{self.random.choice(targets)}, &{self.random.choice(targets)}{p});")]

    def copy(self, scope):
        arrays = [a for a in scope.arrays if a.writable and a.count.isdigit()]
        if not arrays:
            return None
        a, name = self.random.choice(arrays), self.fresh("a")
        scope.arrays.append(Array(name, a.length, a.count))
        return [self.statement(f"double {name}[{a.length}];"), self.statement(f"memcpy({name}, {a.text}, sizeof {name});")]

    def newton(self, scope):
        """Rounds whose number depends on the coordinates, or does not."""
        inner = self.loop_scope(scope, 4)
        if not inner or not scope.targets:
            return None
        y, k = self.fresh("y"), self.fresh("k")
        a, target = self.squeeze(self.double(scope, 2), 1.0), self.random.choice(scope.targets)
        kind = self.random.random()
        if kind < 0.3:
            return [self.statement(f"double {y} = 1.2;"),
                    self.statement(f"for (int {k} = 0; {k} < 4; {k}++) {y} = 0.5 * ({y} + (1.0 + ", a.safe, " * ", a.safe, f") / {y});"),
                    self.statement(f"{target} += 0.5 * {y};")]
        if kind < 0.6:
            return [self.statement(f"double {y} = 3.0 + ", a.safe, ";"),
                    self.statement(f"while ({y} > 0.8) ", Node("block", [self.statement(f"{y} *= 0.5;", fixed=True), self.statement(f"{target} += 0.2 * {y} * {y};")]))]
        if kind < 0.8:
            return [self.statement(f"double {y} = 0.5;"), self.statement(f"int {k} = 0;"),
                    self.statement("do ", Node("block", [self.statement(f"{y} -= ({y} + 0.3 * sin({y}) - ", a.safe, f") / (1.0 + 0.3 * cos({y}));")]),
                                   f" while (fabs({y} + 0.3 * sin({y}) - ", a.safe, f") > 1e-3 && ++{k} < 6);"),
                    self.statement(f"{target} -= 0.5 * {y};")]
        term = self.fresh("x")
        return [self.statement(f"double {term} = 1.0, {y} = 1.0;"),
                self.statement(f"for (int {k} = 1; {k} < 8; {k}++) ", Node("block", [
                    self.statement(f"{term} *= ", a.safe, f" / {k};"), self.statement(f"if (fabs({term}) < 1e-2) break;"),
                    self.statement(f"{y} += {term};")])),
                self.statement(f"{target} += 0.3 * {y};")]

    def chain(self, scope):
        """Sums that run along the coordinates, as those of a chain of links."""
        inner = self.loop_scope(scope, self.n)
        arrays = {a.text for a in scope.arrays}
        if not inner or not scope.targets or "q" not in arrays or (self.by_member and not scope.has_p):
            return None
        x, y, target = self.fresh("x"), self.fresh("y"), self.random.choice(scope.targets)
        i, angle, rate = "ijkl"[scope.loops], self.fresh("angle"), "qd" if "qd" in arrays else "q"
        relative = self.chance(0.4)
        inner.integers.append(Integer(i, 0, self.n - 1))
        inner.leaves += [(x, 2.0), (y, 2.0)]
        inner.targets += [x, y]
        weight = self.pick("p->mass[i]", "p->k", "0.7").replace("[i]", f"[{i}]") if scope.has_p else "0.7"
        body = [self.statement(f"{angle} += q[{i}];") if relative else self.statement(f"{angle} = q[{i}];"),
                self.statement(f"{x} += {rate}[{i}] * cos({angle});"), self.statement(f"{y} -= {rate}[{i}] * sin({angle});")]
        if self.chance(0.5):
            body += self.block(inner, 1).parts
        body.append(self.statement(f"{target} += 0.5 * {weight} * ({x} * {x} + {y} * {y});"))
        return [self.statement(f"double {angle} = 0.0, {x} = 0.0, {y} = 0.0;"),
                self.statement(f"for (int {i} = 0; {i} < {self.dof}; {i}++) ", Node("block", body))]

    def whole(self, scope):
        """An integer that follows from others."""
        others = [i.text for i in scope.integers if i.low >= 0] + (["p->mode"] if scope.has_p else [])
        if not others:
            return None
        k, size, i = self.fresh("k"), self.random.randint(2, 4), self.random.choice(others)
        scope.integers.append(Integer(k, 0, size - 1))
        return [self.statement(f"int {k} = {self.pick(f'({i} * 3 + 1)', f'({i} + 5 >> 1)', f'(unsigned)({i} ^ 3)', f'({i} > 1 ? {i} : 7)')} % {size};")]

    def pairs(self, scope):
        """An array of structs, filled and then read through a pointer."""
        inner = self.loop_scope(scope, 4)
        if not inner or not scope.targets:
            return None
        u, w, i, size, target = self.fresh("u"), self.fresh("w"), "ijkl"[scope.loops], self.random.randint(2, 4), self.random.choice(scope.targets)
        inner.integers.append(Integer(i, 0, size - 1))
        x, y = self.squeeze(self.double(inner, 2), 2.0), self.squeeze(self.double(inner, 2), 2.0)
        if self.chance(0.5):
            fill = [self.statement(f"{u}[{i}].x = ", x.node, ";"), self.statement(f"{u}[{i}].y = {u}[{i}].x * ", y.safe, ";")]
        else:
            fill = [self.statement(f"{u}[{i}] = (struct pair){{.y = ", y.node, ", .x = ", x.node, "};")]
        use = f"{target} += 0.2 * {w}->x * cos({w}->y);"
        if self.chance(0.5):
            read = [self.statement(f"for (struct pair *{w} = {u}; {w} < {u} + {size}; {w}++) {use}")]
        else:
            read = [self.statement(f"struct pair *{w} = {u} + {size};"), self.statement(f"while ({w}-- != {u}) {use}")]
        return [self.statement(f"struct pair {u}[{size}];"), self.statement(f"for (int {i} = 0; {i} < {size}; {i}++) ", Node("block", fill))] + read

    def halves(self, scope):
        """A loop whose condition computes."""
        if not scope.targets or not self.loop_scope(scope, 4):
            return None
        y, target, a = self.fresh("y"), self.random.choice(scope.targets), self.squeeze(self.double(scope, 2), 1.0)
        return [self.statement(f"double {y} = 2.5 + ", a.node, ";"), self.statement(f"while (({y} *= 0.6) > 0.3) {target} += 0.2 * sin({y});")]

    def constants(self, scope):
        """A table that belongs to a function."""
        name, size = self.fresh("weight"), self.random.randint(2, 4)
        scope.arrays.append(Array(name, size, str(size), False))
        return [self.statement(f"static const double {name}[] = {{{', '.join(str(self.number()) for _ in range(size))}}};")]

    def early_return(self, scope):
        if scope.result != "double" or scope.loops > 1:
            return None
        return [self.statement("if (", self.condition(scope, 1), ") return ", self.squeeze(self.double(scope, 2), VARIABLE).node, ";")]

    def jump(self, scope):
        """A goto forward, out of a loop."""
        inner = self.loop_scope(scope, 3)
        if not inner or not scope.targets:
            return None
        label, i, target = self.fresh("done"), "ijkl"[scope.loops], self.random.choice(scope.targets)
        inner.integers.append(Integer(i, 0, 2))
        return [self.statement(f"for (int {i} = 0; {i} < 3; {i}++) ", Node("block", [
                    self.statement(f"{target} += ", self.squeeze(self.double(inner, 2), 1.0).node, ";"),
                    self.statement("if (", self.condition(inner, 1), f") goto {label};")])),
                self.statement(f"{target} *= 0.7;"), self.statement(f"{label}: {target} += 0.1;")]

    def block(self, scope, count):
        """A block of about that many statements; scope gets its declarations."""
        choices = [(self.declare, 3), (self.assign, 8), (self.counted, 3), (self.do_loop, 1), (self.endless, 0.6), (self.leave, 0.7), (self.branch, 2.5),
                   (self.switch, 0.8), (self.array, 1.5), (self.running, 1), (self.walk, 0.8), (self.queue, 0.3), (self.matrix, 0.4),
                   (self.alias, 0.5), (self.pair, 0.7), (self.change_pair, 0.7), (self.out_call, 1.5), (self.copy, 0.3), (self.newton, 0.6),
                   (self.chain, 0.6), (self.early_return, 0.6), (self.jump, 0.3),
                   (self.whole, 0.5), (self.pairs, 0.4), (self.halves, 0.3), (self.constants, 0.3)]
        block = Node("block", [])
        methods, weights = zip(*choices)
        known = {name: len(getattr(scope, name)) for name in ("leaves", "arrays", "pairs")}
        for _ in range(count):
            made = None
            while made is None:
                made = self.random.choices(methods, weights)[0](scope)
                if made is None and self.chance(0.3):
                    made = []
            block.parts += made
        block.parts += self.use(scope, known)
        return block

    def use(self, scope, known):
        """A statement that reads what was declared since, mostly."""
        new = [text for text, _ in scope.leaves[known["leaves"]:]] + [self.element(scope, a) for a in scope.arrays[known["arrays"]:]]
        new += [f"{u}.{self.pick('x', 'y')}" for u in scope.pairs[known["pairs"]:]]
        targets = scope.targets[:-len(new)] or scope.targets
        if not new or not targets or self.chance(0.1):
            return []
        sum_of = [Node("double", ["0.4 * ", text, " * ", self.squeeze(self.double(scope, 2), 1.0).safe]) for text in new]
        parts = [part for e in sum_of for part in (e, " + ")][:-1]
        return [self.statement(f"{self.random.choice(targets)} += ", Node("double", parts), ";")]

    # Functions.

    def helper(self, name):
        kind = self.random.choice(["value", "value", "reduce", "out", "inplace", "pair", "spoil", "level", "decide", "apply"])
        takes_p = self.chance(0.3) and kind != "apply"
        p = ", const struct params *p" if takes_p else ""
        scope = self.function_scope(p=takes_p)
        self.cost = 0
        tail, option = None, ""
        if kind in ("value", "decide"):
            names = ["x", "y"][:1 if kind == "decide" else 2]
            head = f"{'int' if kind == 'decide' else 'double'} {name}({', '.join('double ' + v for v in names)}{p})"
            scope.leaves += [(v, VARIABLE) for v in names]
            scope.targets += names
        elif kind == "apply":
            head = f"double {name}(double (*f)(double), double x)"
            scope.leaves.append(("x", VARIABLE))
            scope.targets.append("x")
        elif kind == "level":
            head, option = f"double {name}(int level, double x{p})", f"--recursion {name}:4"
            scope.leaves.append(("x", VARIABLE))
            scope.targets.append("x")
            scope.integers.append(Integer("level", 0, 3))
        elif kind in ("reduce", "inplace"):
            writable = kind == "inplace"
            head = f"{'void' if writable else 'double'} {name}(int count, {'' if writable else 'const '}double *a, double x{p})"
            scope.leaves.append(("x", VARIABLE))
            scope.targets.append("x")
        elif kind == "out":
            head = f"void {name}(double x, double *y, double *z{p})"
            scope.leaves += [("x", VARIABLE), ("*y", VARIABLE), ("*z", VARIABLE)]
            scope.targets += ["x", "*y", "*z"]
        else:
            head = f"{'struct pair' if kind == 'pair' else 'void'} {name}(struct pair {'' if kind == 'pair' else '*'}u, double x{p})"
            member = "u.{}" if kind == "pair" else "u->{}"
            scope.leaves += [("x", VARIABLE)] + [(member.format(v), VARIABLE) for v in "xy"]
            scope.targets += ["x"] + [member.format(v) for v in "xy"]
        if kind in ("value", "level"):
            scope.result = "double"
        body = Node("block", [])
        if kind == "level":
            body.parts.append(self.statement("if (level == 0) return ", self.squeeze(self.double(scope, 2), 1.0).node, ";", fixed=True))
        if kind in ("reduce", "inplace"):
            body.parts.append(self.statement("double sum = 0.0;"))
            scope.targets.append("sum")
            scope.leaves.append(("sum", VARIABLE))
        body.parts += self.block(scope, self.random.randint(1, 3)).parts
        p = ", p" if takes_p else ""
        if kind == "value":
            tail = ["return ", self.squeeze(self.double(scope, 3), VARIABLE).node, ";"]
        elif kind == "apply":
            tail = ["return f(", self.double(scope, 2).node, ");"]
        elif kind == "level":
            tail = ["return 0.5 * ", self.squeeze(self.double(scope, 2), 1.0).safe, f" * {name}(level - 1, ", self.squeeze(self.double(scope, 1), VARIABLE).node,
                    f"{p}) + ", self.squeeze(self.double(scope, 2), 1.0).safe, ";"]
        elif kind == "decide":
            tail = [f"return {self.pick('x > 0.4 ? 1 : -1', '(x > 0.2) - (x < -0.3)')};"]
        elif kind in ("reduce", "inplace"):
            inner = scope.inner()
            inner.leaves.append(("a[i]", VARIABLE))
            inner.loops, inner.rounds = 1, 3
            if kind == "inplace":
                inner.targets += ["a[i]", "a[i]"]
            loop = self.pick("int i = 0; i < count; i++", "int i = count - 1; i >= 0; i--")
            update = self.squeeze(self.double(inner, 3), 1.0)
            body.parts.append(self.statement(f"for ({loop}) ", Node("block", [
                self.statement("sum += a[i] * ", update.safe, ";")] + self.block(inner, 1).parts)))
            tail = ["return sum;"] if kind == "reduce" else ["a[0] += 0.5 * sum;"]
        elif kind == "pair":
            tail = ["return u;"]
        if tail:
            body.parts.append(self.statement(*tail, fixed=kind not in ("inplace",)))
        cost = self.cost * (4 if kind in ("level", "reduce", "inplace") else 1)
        self.program.functions.append(Function(name, head, body, option))
        self.helpers.append(Helper(name, kind, cost, takes_p))

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
        body.parts += self.block(scope, self.random.randint(3, 7)).parts
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
            body.parts.append(self.statement(f"{to}{self.pick('4.0', '7.0')} * {lead} + {self.pick('sin', 'cos')}(q[{self.random.randrange(self.n)}] + ",
                                             self.double(scope, 1).safe, ") * ", self.squeeze(self.double(scope, 3), 1.0).safe, ";", fixed=True))
        head = f"{'void' if has['out'] else 'double'} {name}{self.parameters(**has)}"
        self.program.functions.append(Function(name, head, body, f"--{role} {name}:{rows}", True))

    def make(self):
        for k in range(self.random.choice([0, 1, 1, 2, 2, 3, 4])):
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
