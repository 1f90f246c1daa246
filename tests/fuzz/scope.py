"""What a place in a random program can read, write and call."""
from tree import Node

VARIABLE = 4.0  # bound that every variable is taken to have


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
