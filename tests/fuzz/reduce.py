"""Makes a failing program smaller: statements, functions and parts of expressions go, as long as it still fails."""
from tree import Node


def blocks(node):
    """Every block of a tree, outer ones first."""
    if not isinstance(node, Node):
        return
    if node.kind == "block":
        yield node
    for part in node.parts:
        yield from blocks(part)


def expressions(node):
    """Every place of an expression of type double: the node above and the index of its part."""
    for k, part in enumerate(node.parts):
        if isinstance(part, Node):
            if part.kind == "double":
                yield node, k
            yield from expressions(part)


def without(things, start, count):
    return things[:start] + things[start + count:]


def drop(things, fails, movable=lambda thing: True):
    """Removes runs of things, long ones first, from the list in place where fails() stays true. Returns whether some went."""
    changed, size = False, max(1, len(things) // 2)
    while True:
        start = 0
        while start < len(things):
            kept = list(things)
            if all(movable(thing) for thing in things[start:start + size]):
                things[:] = without(things, start, size)
                if fails():
                    changed = True
                    continue
                things[:] = kept
            start += size
        if size == 1:
            return changed
        size //= 2


def hoist(block, fails):
    """Puts the inside of a compound statement in its place."""
    changed = False
    for k, statement in enumerate(list(block.parts)):
        for inner in [part for part in statement.parts if isinstance(part, Node) and part.kind == "block"]:
            kept = list(block.parts)
            if k >= len(kept) or kept[k] is not statement:
                break
            block.parts[k:k + 1] = inner.parts
            if fails():
                changed = True
                break
            block.parts[:] = kept
    return changed


def simplify(body, fails):
    """Puts a part of an expression, or a number, in its place."""
    changed = False
    for above, k in list(expressions(body)):
        whole = above.parts[k]
        if not isinstance(whole, Node):
            continue
        inner = [part for part in whole.parts if isinstance(part, Node) and part.kind == "double"]
        for smaller in ["1.5"] + inner:
            if str(smaller) == str(whole) or len(str(whole)) <= len(str(smaller)):
                continue
            above.parts[k] = smaller if isinstance(smaller, Node) else Node("double", [smaller])
            if fails():
                changed = True
                break
            above.parts[k] = whole
    return changed


def once(program, fails):
    changed = drop(program.functions, fails)
    for function in program.functions:
        for block in list(blocks(function.body)):
            changed |= drop(block.parts, fails, lambda statement: not statement.fixed)
        for block in list(blocks(function.body)):
            changed |= hoist(block, fails)
    for function in program.functions:
        changed |= simplify(function.body, fails)
    return changed


def reduce(program, still_fails, most=400):
    """The program, changed in place; at most that many trials."""
    trials = 0
    seen = {}

    def fails():
        nonlocal trials
        text = str(program)
        if text not in seen:
            if trials >= most:
                return False
            trials += 1
            seen[text] = still_fails(program)
        return seen[text]

    while once(program, fails):
        pass
    return program
