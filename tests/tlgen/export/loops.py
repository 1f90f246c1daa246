#!/usr/bin/env python3
"""Prints each loop of C files that does not count: `for` whose counter is compared with a bound, goes towards it by its third clause, and
is not changed in the body ends by itself; so does none of while, do and goto, and none of EACH macros whose text is a loop like theirs.
    loops.py FILE.."""
import re
import sys
from pathlib import Path

COUNTS = re.compile(r"(?<![\w.>])([A-Za-z_][\w.]*(?:->\w+)*)\s*(?:\+\+|--|[-+*/]=|<<=|>>=)|(?:\+\+|--)([A-Za-z_]\w*)")


def plain(text):
    """Without comments and strings; lines stay."""
    def lines(match):
        return '""' if match[0][0] == '"' else "''" if match[0][0] == "'" else " " + "\n" * match[0].count("\n")
    return re.sub(r"/\*.*?\*/|//[^\n]*|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)*'", lines, text, flags=re.S)


def closing(text, at, pair):
    """The place of the bracket that closes the one at `at`."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] == pair[0]) - (text[i] == pair[1])
        if depth == 0:
            return i
    return len(text)


def body_after(text, at):
    while text[at].isspace():
        at += 1
    if text[at] == "{":
        return text[at:closing(text, at, "{}")]
    inner = re.match(r"(?:for|while|if)\s*\(", text[at:])
    if inner:
        end = closing(text, at + inner.end() - 1, "()") + 1
        return text[at:end] + body_after(text, end)
    return text[at:text.find(";", at)]


def counted(header, body):
    clauses = header.split(";")
    if len(clauses) != 3:
        return False
    condition, step = clauses[1], clauses[2]
    for found in COUNTS.finditer(step):
        name = re.escape(found[1] or found[2])
        compared = rf"(?<![\w.>]){name}(?![\w.])[^<>=!&|]*(?:[<>]=?|!=)|(?:[<>]=?|!=)[^<>=!&|]*(?<![\w.>]){name}(?!\w)"
        changed = rf"(?<![\w.>*]){name}\s*(?:=(?!=)|[-+*/]=)|(?<![\w.>]){name}(?:\+\+|--)|(?:\+\+|--){name}(?!\w)"
        parts = condition.split("&&")
        if "||" not in condition and any(re.search(compared, part) for part in parts) and not re.search(changed, body):
            return True
    return False


def loops(text):
    for match in re.finditer(r"(?<![\w#])(for|while|do|goto)\b", text):
        line = text.count("\n", 0, match.start()) + 1
        if match[1] in ("do", "goto"):
            yield line
            continue
        opened = re.match(r"\s*\(", text[match.end():])
        if not opened:
            continue
        start = match.end() + opened.end() - 1
        end = closing(text, start, "()")
        if match[1] == "while" or not counted(text[start + 1:end], body_after(text, end + 1)):
            yield line


def main():
    for name in sys.argv[1:]:
        text = Path(name).read_text(encoding="utf-8")
        lines = text.splitlines()
        for line in loops(plain(text)):
            print(f"{Path(name).name}: {' '.join(lines[line - 1].split())}")


if __name__ == "__main__":
    main()
