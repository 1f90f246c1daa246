"""What authors of models write in several statements at a time: sums along a chain, walks through pointers, Newton steps, queues."""
from scope import VARIABLE, Integer
from statements import Statements
from tree import Node


class Idioms(Statements):
    """Makes groups of statements, and blocks of all kinds."""

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
            change = f"{a.text}[{i}] {self.pick('+=', '-=', '=')} 0.5 * {a.text}[{i} - 1] * "
            return [self.statement(f"for (int {i} = 1; {i} < {a.count}; {i}++) {change}", e.safe, ";")]
        if kind < 0.6:
            return [self.statement(f"for (int {i} = {a.count} - 1; {i} > 0; {i}--) {a.text}[{i}] = {a.text}[{i} - 1];")]
        if kind < 0.8:
            return [self.statement(f"for (int {i} = 1; {i} < {a.count}; {i}++) {a.text}[{i} - 1] -= {a.text}[{i}] * sin(", e.node, ");")]
        k = self.fresh("k")
        swap = [f"double kept = {a.text}[{i}];", f"{a.text}[{i}] = {a.text}[{k}];", f"{a.text}[{k}] = kept;"]
        loop = f"for (int {i} = 0, {k} = {a.count} - 1; {i} < {k}; {i}++, {k}--) "
        return [self.statement(loop, Node("block", [self.statement(text) for text in swap]))]

    def walk(self, scope):
        """A sum through a pointer."""
        inner = self.loop_scope(scope, 3)
        if not scope.arrays or not scope.targets or not inner:
            return None
        a, target, w = self.random.choice(scope.arrays), self.random.choice(scope.targets), self.fresh("w")
        e = self.squeeze(self.double(inner, 2), 1.0)
        kind = self.random.random()
        if kind < 0.4:
            head = f"for (const double *{w} = {a.text}, *end = {a.text} + {a.count}; {w} < end; {w}++) "
            return [self.statement(f"{head}{target} += 0.5 * *{w} * ", e.safe, ";")]
        if kind < 0.7:
            loop = f"while ({w} < {a.text} + {a.count}) {target} += 0.5 * *{w}++ * "
            return [self.statement(f"const double *{w} = {a.text};"), self.statement(loop, e.safe, ";")]
        loop = f"while ({w} > {a.text}) {target} = 0.5 * {target} + sin(*--{w}) * "
        return [self.statement(f"const double *{w} = {a.text} + {a.count};"), self.statement(loop, e.safe, ";")]

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
                self.statement(f"for (int {i} = 0; {i} < 3; {i}++) if (", self.settled(inner), f") {a}[{k}++] = ", e.node, ";"),
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

    def newton(self, scope):
        """Rounds whose number depends on the coordinates, or does not."""
        inner = self.loop_scope(scope, 4)
        if not inner or not scope.targets:
            return None
        y, k = self.fresh("y"), self.fresh("k")
        a, target = self.squeeze(self.double(scope, 2), 1.0), self.random.choice(scope.targets)
        kind = self.random.random()
        if kind < 0.7:
            return [self.statement(f"double {y} = 1.2;"),
                    self.statement(f"for (int {k} = 0; {k} < 4; {k}++) {y} = 0.5 * ({y} + (1.0 + ", a.safe, " * ", a.safe, f") / {y});"),
                    self.statement(f"{target} += 0.5 * {y};")]
        if kind < 0.8:
            body = [self.statement(f"{y} *= 0.5;", fixed=True), self.statement(f"{target} += 0.2 * {y} * {y};")]
            return [self.statement(f"double {y} = 3.0 + ", a.safe, ";"), self.statement(f"while ({y} > 0.8) ", Node("block", body))]
        if kind < 0.9:
            step = self.statement(f"{y} -= ({y} + 0.3 * sin({y}) - ", a.safe, f") / (1.0 + 0.3 * cos({y}));")
            until = [f" while (fabs({y} + 0.3 * sin({y}) - ", a.safe, f") > 1e-3 && ++{k} < 6);"]
            return [self.statement(f"double {y} = 0.5;"), self.statement(f"int {k} = 0;"), self.statement("do ", Node("block", [step]), *until),
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

    def pairs(self, scope):
        """An array of structs, filled and then read through a pointer."""
        inner = self.loop_scope(scope, 4)
        if not inner or not scope.targets:
            return None
        u, w, i, size = self.fresh("u"), self.fresh("w"), "ijkl"[scope.loops], self.random.randint(2, 4)
        target = self.random.choice(scope.targets)
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
        loop = f"for (int {i} = 0; {i} < {size}; {i}++) "
        return [self.statement(f"struct pair {u}[{size}];"), self.statement(loop, Node("block", fill))] + read

    def halves(self, scope):
        """A loop whose condition computes."""
        if not scope.targets or not self.loop_scope(scope, 4):
            return None
        y, target, a = self.fresh("y"), self.random.choice(scope.targets), self.squeeze(self.double(scope, 2), 1.0)
        loop = self.statement(f"while (({y} *= 0.6) > 0.3) {target} += 0.2 * sin({y});")
        return [self.statement(f"double {y} = 2.5 + ", a.node, ";"), loop]

    def jump(self, scope):
        """A goto forward, out of a loop."""
        inner = self.loop_scope(scope, 3)
        if not inner or not scope.targets:
            return None
        label, i, target = self.fresh("done"), "ijkl"[scope.loops], self.random.choice(scope.targets)
        inner.integers.append(Integer(i, 0, 2))
        return [self.statement(f"for (int {i} = 0; {i} < 3; {i}++) ", Node("block", [
                    self.statement(f"{target} += ", self.squeeze(self.double(inner, 2), 1.0).node, ";"),
                    self.statement("if (", self.settled(inner), f") goto {label};")])),
                self.statement(f"{target} *= 0.7;"), self.statement(f"{label}: {target} += 0.1;")]

    def block(self, scope, count):
        """A block of about that many statements; scope gets its declarations."""
        choices = [(self.declare, 3), (self.assign, 8), (self.counted, 3), (self.do_loop, 1), (self.endless, 0.6), (self.leave, 0.7),
                   (self.branch, 2.5), (self.switch, 0.8), (self.array, 1.5), (self.running, 1), (self.walk, 0.8), (self.queue, 0.3),
                   (self.matrix, 0.4), (self.alias, 0.5), (self.pair, 0.7), (self.change_pair, 0.7), (self.out_call, 1.5), (self.copy, 0.3),
                   (self.newton, 0.6), (self.chain, 0.6), (self.early_return, 0.6), (self.jump, 0.3), (self.whole, 0.5), (self.pairs, 0.4),
                   (self.halves, 0.1), (self.constants, 0.3)]
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
