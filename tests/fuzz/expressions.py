"""Random expressions. Each carries a rough bound and is squeezed where that grows, and every function is used inside its domain."""
from scope import VARIABLE, Double
from tree import Node

LARGEST = 6.0  # bound that an expression may have

# Functions of math.h inside their domains: text with {a}, {b} for arguments, and a bound from theirs.
SMOOTH = [
    ("sin({a})", 1), ("cos({a})", 1), ("sin({a})", 1), ("cos({a})", 1), ("atan({a})", 1.6), ("tanh({a})", 1), ("asinh({a})", 2.5),
    ("erf({a})", 1), ("erfc(0.5 * {a})", 2), ("exp(sin({a}))", 2.8), ("exp(-{a} * {a})", 1), ("expm1(0.5 * cos({a}))", 1),
    ("exp2(sin({a}))", 2), ("log(1.5 + {a} * {a})", 3), ("log1p({a} * {a})", 3), ("log2(2.0 + sin({a}))", 1.6),
    ("log10(3.0 + {a} * {a})", 2),
    ("sqrt(1.0 + {a} * {a})", 4), ("cbrt(2.0 + cos({a}))", 1.5), ("tan(0.6 * sin({a}))", 0.7), ("asin(0.8 * sin({a}))", 1),
    ("acos(0.7 * cos({a}))", 2.4), ("atanh(0.6 * sin({a}))", 0.7), ("acosh(1.5 + {a} * {a})", 4), ("sinh(sin({a}))", 1.2),
    ("cosh(0.5 * sin({a}))", 1.2), ("pow({a}, 2)", 9),
    ("pow({a}, 3.0)", 9),
    ("pow(1.5 + {a} * {a}, 0.5 * sin({b}))", 4), ("pow(2.0, sin({a}))", 2), ("hypot({a}, 1.0 + {b} * {b})", 6), ("hypot({a}, 1.5)", 5),
    ("atan2({a}, 1.5 + {b} * {b})", 1.6), ("atan2(sin({a}), 2.0 + cos({b}))", 1), ("fma({a}, 0.5, {b})", 6), ("ldexp({a}, -1)", 3),
    ("{a} / (1.5 + {b} * {b})", 4), ("{a} / (2.0 + sin({b}))", 4), ("1.0 / (1.0 + {a} * {a})", 1), ("{a} / sqrt(1.0 + {a} * {a})", 1)]
# Functions whose derivatives are no formulas of others: motion functions cannot have them.
SPECIAL = [("tgamma(2.5 + sin({a}))", 3.4), ("lgamma(3.0 + sin({a}))", 1.8)]
# Functions with a kink or a jump somewhere.
KINKED = [("fabs({a} - 0.37)", 5), ("fmin({a}, {b} + 0.21)", 5), ("fmax({a} - 0.13, sin({b}))", 5), ("fdim({a}, 0.29)", 5),
          ("copysign(1.0 + {a} * {a}, {b} - 0.31)", 6), ("fmod({a} + 2.3, 1.7)", 1.7), ("floor(2.0 * {a}) * sin({b})", 8),
          ("sin({a}) * trunc({b} + 3.1)", 7)]
COMPARE = ["<", ">", "<=", ">="]


class Expressions:
    """Makes expressions of what a scope has; random, n, dof, helpers and cost are those of the program."""

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
        depth -= self.chance(0.3)
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
            return self.squeeze(self.math(scope, depth, SPECIAL if self.chance(0.003) else SMOOTH))
        if choice < 0.88:
            return self.squeeze(self.math(scope, depth, KINKED))
        if choice < 0.93:
            a, b = self.double(scope, depth - 1), self.double(scope, depth - 1)
            return Double([self.condition(scope, depth - 1), " ? ", a.safe, " : ", b.safe], max(a.bound, b.bound))
        return self.call(scope, depth) or self.leaf(scope)

    def settled(self, scope):
        """A condition that does not depend on the coordinates; mostly: loops that those end have no motion functions."""
        settled = [f"{i.text} {test}" for i in scope.integers for test in ("> 1", "% 2 == 1", "== 0")] + (["p->mode == 2"] if scope.has_p else [])
        return Node("condition", [self.random.choice(settled)]) if settled and self.chance(0.8) else self.condition(scope, 1)

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
