"""Random helper functions of every kind: by value, through pointers, over arrays, on structs, recursive, and taking a function."""
from idioms import Idioms
from scope import VARIABLE, Helper, Integer
from tree import Function, Node

# Head, with {name} and {p} for a last parameter that hands on the parameter struct; the doubles that the body reads and writes.
HEADS = {
    "value": ("double {name}(double x, double y{p})", ["x", "y"]),
    "decide": ("int {name}(double x{p})", ["x"]),
    "apply": ("double {name}(double (*f)(double), double x)", ["x"]),
    "level": ("double {name}(int level, double x{p})", ["x"]),
    "reduce": ("double {name}(int count, const double *a, double x{p})", ["x", "sum"]),
    "inplace": ("void {name}(int count, double *a, double x{p})", ["x", "sum"]),
    "out": ("void {name}(double x, double *y, double *z{p})", ["x", "*y", "*z"]),
    "pair": ("struct pair {name}(struct pair u, double x{p})", ["x", "u.x", "u.y"]),
    "spoil": ("void {name}(struct pair *u, double x{p})", ["x", "u->x", "u->y"]),
}
REPEATED = ("level", "reduce", "inplace")  # what they do, they do several times


class Helpers(Idioms):
    """Makes helper functions."""

    def start_of(self, kind, scope):
        """What stands before all else."""
        if kind == "level":
            scope.integers.append(Integer("level", 0, 3))
            return [self.statement("if (level == 0) return ", self.squeeze(self.double(scope, 2), 1.0).node, ";", fixed=True)]
        return [self.statement("double sum = 0.0;")] if "sum" in HEADS[kind][1] else []

    def over_array(self, kind, scope):
        """The loop over the array's elements."""
        inner = scope.inner()
        inner.leaves.append(("a[i]", VARIABLE))
        inner.loops, inner.rounds = 1, 3
        if kind == "inplace":
            inner.targets += ["a[i]", "a[i]"]
        loop = self.pick("int i = 0; i < count; i++", "int i = count - 1; i >= 0; i--")
        update = self.statement("sum += a[i] * ", self.squeeze(self.double(inner, 3), 1.0).safe, ";")
        return [self.statement(f"for ({loop}) ", Node("block", [update] + self.block(inner, 1).parts))]

    def end_of(self, kind, name, p, scope):
        """The last statements, with what the function returns."""
        if kind == "value":
            parts = ["return ", self.squeeze(self.double(scope, 3), VARIABLE).node, ";"]
        elif kind == "apply":
            parts = ["return f(", self.double(scope, 2).node, ");"]
        elif kind == "level":
            factor, term = self.squeeze(self.double(scope, 2), 1.0), self.squeeze(self.double(scope, 2), 1.0)
            below = self.squeeze(self.double(scope, 1), VARIABLE)
            parts = ["return 0.5 * ", factor.safe, f" * {name}(level - 1, ", below.node, f"{p}) + ", term.safe, ";"]
        elif kind == "decide":
            parts = [f"return {self.pick('x > 0.4 ? 1 : -1', '(x > 0.2) - (x < -0.3)')};"]
        elif kind == "reduce":
            parts = ["return sum;"]
        elif kind == "inplace":
            return self.over_array(kind, scope) + [self.statement("a[0] += 0.5 * sum;")]
        elif kind == "pair":
            parts = ["return u;"]
        else:
            return []
        end = [self.statement(*parts, fixed=True)]
        return self.over_array(kind, scope) + end if kind == "reduce" else end

    def helper(self, name):
        """Makes one and adds it to the program and to what can be called."""
        kind = self.random.choice(["value"] + list(HEADS))
        head, doubles = HEADS[kind]
        takes_p = self.chance(0.3) and "{p}" in head
        scope = self.function_scope(p=takes_p)
        scope.result = "double" if kind in ("value", "level") else None
        scope.leaves += [(text, VARIABLE) for text in doubles]
        scope.targets += doubles
        self.cost = 0
        parts = self.start_of(kind, scope) + self.block(scope, self.random.randint(1, 3)).parts
        parts += self.end_of(kind, name, ", p" if takes_p else "", scope)
        head = head.format(name=name, p=", const struct params *p" if takes_p else "")
        option = f"--recursion {name}:4" if kind == "level" else ""
        self.program.functions.append(Function(name, head, Node("block", parts), option))
        self.helpers.append(Helper(name, kind, self.cost * (4 if kind in REPEATED else 1), takes_p))
