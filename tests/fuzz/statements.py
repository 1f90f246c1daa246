"""Random statements: declarations, assignments, loops, decisions, calls. Each method returns a list of them, or None where it does not
fit the place."""
from expressions import Expressions
from scope import VARIABLE, Array, Integer
from tree import Node


class Statements(Expressions):
    """Makes statements; block is that of Idioms."""

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
            e = self.squeeze(e, VARIABLE)
            return None if str(e.node) == target else [self.statement(f"{target} = ", e.node, ";")]
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
        return [self.statement("if (", self.settled(scope), f") {self.pick('break', 'continue')};")]

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

    def early_return(self, scope):
        if scope.result != "double" or scope.loops > 1:
            return None
        return [self.statement("if (", self.condition(scope, 1), ") return ", self.squeeze(self.double(scope, 2), VARIABLE).node, ";")]

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

    def whole(self, scope):
        """An integer that follows from others."""
        others = [i.text for i in scope.integers if i.low >= 0] + (["p->mode"] if scope.has_p else [])
        if not others:
            return None
        k, size, i = self.fresh("k"), self.random.randint(2, 4), self.random.choice(others)
        scope.integers.append(Integer(k, 0, size - 1))
        value = self.pick(f"({i} * 3 + 1)", f"({i} + 5 >> 1)", f"(unsigned)({i} ^ 3)", f"({i} > 1 ? {i} : 7)")
        return [self.statement(f"int {k} = {value} % {size};")]

    def constants(self, scope):
        """A table that belongs to a function."""
        name, size = self.fresh("weight"), self.random.randint(2, 4)
        scope.arrays.append(Array(name, size, str(size), False))
        return [self.statement(f"static const double {name}[] = {{{', '.join(str(self.number()) for _ in range(size))}}};")]

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
        to = f", &{self.random.choice(targets)}, &{self.random.choice(targets)}"
        return [self.statement(f"{h.name}(", self.double(scope, 2).node, f"{to}{p});")]

    def copy(self, scope):
        arrays = [a for a in scope.arrays if a.writable and a.count.isdigit()]
        if not arrays:
            return None
        a, name = self.random.choice(arrays), self.fresh("a")
        scope.arrays.append(Array(name, a.length, a.count))
        return [self.statement(f"double {name}[{a.length}];"), self.statement(f"memcpy({name}, {a.text}, sizeof {name});")]
