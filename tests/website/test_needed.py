"""What a cell needs of those above it, on cases written before the method: what is taken must give
the same as running all of them.
"""

import ast

import pytest

from website.browser.needed import statements_needed

# cells above, the cell, and the statements that it needs
CASES = {
    "the last of two bindings": (["a = 1", "a = 2"], "a", "a = 2"),
    "none that comes after": (["a = 1"], "b = a", "a = 1"),
    "imports, and not the others": (["import math\nimport sympy"], "math.pi", "import math"),
    "a name of an import": (["import os.path as p"], "p", "import os.path as p"),
    "a global that a function uses, bound after it": (
        ["def f(): return g", "g = 1"], "f()", "def f():\n    return g|g = 1",
    ),
    "both globals, where a function is called between": (
        ["def f(): return g", "g = 1\nx = f()\ng = 2"], "x", "def f():\n    return g|g = 1|x = f()|g = 2",
    ),
    "no local names": (["t = 1", "def f(t): s = t; return s", "s = 3"], "f(2)", "def f(t):\n    s = t\n    return s"),
    "a default of a parameter": (["k = 2", "f = lambda t, k=k: k * t"], "f(1)", "k = 2|f = lambda t, k=k: k * t"),
    "what a list was filled with": (["x = []", "x.append(1)", "print(x)"], "x", "x = []|x.append(1)"),
    "an item that was set": (["d = {}\nd['a'] = 1\nd['a']"], "d", "d = {}|d['a'] = 1"),
    "a name that is added to": (["n = 1", "n += 1"], "n", "n = 1|n += 1"),
    "a name that a condition may bind": (["n = 1", "if n: m = 2", "m = 1 if n else 0"], "m", "n = 1|m = 1 if n else 0"),
    "a name bound in a loop": (["s = 0", "for i in range(3): s += i"], "s", "s = 0|for i in range(3):\n    s += i"),
    "several names at once": (["a, (b, *c) = 1, (2, 3)"], "c", "a, (b, *c) = (1, (2, 3))"),
    "a comprehension's own name is not it": (["i = 1"], "[i for i in range(2)]", ""),
    "a class and its base": (["class A: pass", "class B(A): k = 1"], "B", "class A:\n    pass|class B(A):\n    k = 1"),
    "a walrus": (["(n := 3)"], "n", "(n := 3)"),
    "a cell without sense": (["a = (", "b = 1"], "b", "b = 1"),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_what_a_cell_needs_of_those_above(case):
    above, source, expected = CASES[case]
    assert "|".join(ast.unparse(s.node) for _, s in statements_needed(above, source)) == expected


@pytest.mark.parametrize("case", [c for c in CASES if c != "a cell without sense"])
def test_what_is_taken_gives_the_same_as_all_of_them(case):
    above, source, _ = CASES[case]
    whole, part = {}, {}
    for cell in above:
        exec(cell, whole)
    for _, statement in statements_needed(above, source):
        exec(ast.unparse(statement.node), part)
    *_, name = source.split(" = ")
    assert plain(eval(name, whole)) == plain(eval(name, part))


def plain(value):
    """A value that can be compared: a function or class of another run is as good."""
    return getattr(value, "__name__", value)
