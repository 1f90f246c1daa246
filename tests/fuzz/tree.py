"""Programs as trees: what can be printed as C, and taken apart by the reduction."""


class Node:
    """An expression, statement or block: text and further nodes, in order.

    kind     "double", "condition", "integer" (expressions); "statement"; "block"
    fixed    the reduction leaves it where it is, as what ends a loop
    """

    def __init__(self, kind, parts, fixed=False):
        self.kind = kind
        self.parts = parts
        self.fixed = fixed

    def __str__(self):
        return "".join(str(part) for part in self.parts)


def lines(node, indent):
    """A statement or block as lines of C."""
    space = "  " * indent
    if node.kind == "block":
        return [line for part in node.parts for line in lines(part, indent)]
    out, current = [], space
    for part in node.parts:
        if isinstance(part, Node) and part.kind == "block":
            out.append(current + "{")
            out += lines(part, indent + 1)
            current = space + "}"
        else:
            current += str(part)
    return out + [current]


class Function:
    """A function: its head, its body, the option that tlgen needs for it, and whether that gives it a role."""

    def __init__(self, name, head, body, option="", role=False):
        self.name, self.head, self.body, self.option, self.role = name, head, body, option, role

    def __str__(self):
        return "\n".join([f"static {self.head}", "{"] + lines(self.body, 1) + ["}", ""])


class Member:
    """A member of the parameter struct and its numbers."""

    def __init__(self, type_name, name, values, array=False):
        self.type_name, self.name, self.values, self.array = type_name, name, values, array

    @property
    def declaration(self):
        return f"{self.type_name} {self.name}" + (f"[{len(self.values)}]" if self.array else "") + ";"


class Program:
    """A model: parameters, constant tables, helpers, and the functions with a role."""

    def __init__(self, name, dof):
        self.name, self.dof = name, dof
        self.members, self.tables, self.functions = [], [], []
        self.sizes = ["n"]  # integer members that motion functions know
        self.purpose = "A random program."

    def body(self):
        return "\n".join(str(function) for function in self.functions)

    def used_members(self):
        """Those that the functions name, and the number of coordinates."""
        text = self.body()
        if "const struct params *p" not in text:
            return []
        used = [m for m in self.members if f"p->{m.name}" in text or m.name == self.dof]
        return used or self.members[:1]

    def options(self):
        """The arguments of tlgen, but for files."""
        return f"--dof {self.dof} " + " ".join(function.option for function in self.functions if function.option)

    def params(self):
        """The numbers of the parameter struct, as the test programs of tlgen take them; none where no function with a role has it."""
        if not any(function.role and "struct params" in function.head for function in self.functions):
            return ""
        return " ".join(f"{m.name}=" + ",".join(repr(v) for v in m.values) for m in self.used_members())

    def motion(self):
        """The arguments of tlgen for motion functions: sizes, and members to differentiate by."""
        taken = self.used_members() if self.params() else []
        sizes = [f"--size {m.name}={m.values[0]}" for m in taken if m.name in self.sizes]
        by = [m.name for m in taken if m.type_name == "double"]
        return " ".join(sizes + ([f"--parameter {','.join(by)}"] if by else []))

    def __str__(self):
        text = self.body()
        comments = [self.purpose, f"tlgen: {self.options()}", f"motion: {self.motion()}", f"params: {self.params()}"]
        out = [f"/* {comment} */" for comment in comments] + ["#include <math.h>"]
        if "memcpy" in text:
            out.append("#include <string.h>")
        out.append("")
        if "struct pair" in text:
            out.append("struct pair { double x, y; };")
        if self.used_members():
            out.append("struct params { " + " ".join(m.declaration for m in self.used_members()) + " };")
        out += [table for table, name in self.tables if name in text]
        return "\n".join(out + ["", text])
