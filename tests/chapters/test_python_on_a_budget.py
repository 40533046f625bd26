"""The Python of the cells: what the primer of chapter 1 explains, and a list of what goes beyond."""

import ast
import tomllib
from collections import Counter
from pathlib import Path

import pytest

from tests.chapters.notebooks import code, each_chapter, number, read

# {chapter: {cell: [what it uses beyond the primer]}}, each explained earlier in the chapter
BEYOND = tomllib.loads((Path(__file__).parent / "python.toml").read_text(encoding="utf-8"))

NODES = {
    ast.GeneratorExp: "generator", ast.DictComp: "dict comprehension", ast.SetComp: "set",
    ast.Set: "set", ast.Starred: "star", ast.While: "while", ast.ClassDef: "class", ast.Try: "try",
    ast.With: "with", ast.IfExp: "conditional expression", ast.NamedExpr: "walrus",
    ast.MatMult: "@", ast.Assert: "assert", ast.Yield: "yield", ast.Global: "global",
    ast.Nonlocal: "nonlocal", ast.AugAssign: "+=", ast.Delete: "del", ast.Slice: "slice",
    ast.Break: "break", ast.Continue: "continue", ast.Raise: "raise", ast.Mod: "%",
    ast.FloorDiv: "//", ast.AnnAssign: "annotation", ast.Match: "match",
}  # fmt: skip
CALLS = {"zip", "enumerate", "map", "filter", "sorted", "reversed", "dict", "set", "isinstance",
         "getattr", "iter", "next", "any", "all", "partial", "type", "list", "tuple"}  # fmt: skip


def beyond(source):
    """What a cell uses beyond the primer, in alphabetical order."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        found |= {name for kind, name in NODES.items() if isinstance(node, kind)}
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            found |= {node.func.id} & CALLS
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.decorator_list:
            found.add("decorator")
        if isinstance(node, ast.ListComp) and len(node.generators) > 1:
            found.add("nested comprehension")
        if isinstance(node, ast.Dict) and None in node.keys:
            found.add("star")
        if isinstance(node, ast.arguments) and (node.vararg or node.kwarg):
            found.add("star")
    return sorted(found)


def seen(notebook):
    """The cells of code that a reader sees."""
    return [c for c in code(notebook) if not c.metadata.get("jupyter", {}).get("source_hidden")]


@each_chapter
def test_a_cell_keeps_to_the_primer_or_is_listed(path):
    found = {cell.id: beyond(cell.source) for cell in seen(read(path))}
    assert {cell: names for cell, names in found.items() if names} == BEYOND.get(number(path), {})


@pytest.mark.parametrize(
    ("source", "names"),
    [
        ("for t in (0.1, 0.2):\n    show('v', f(t)[0], 'm/s')", []),
        ("x = [t**2 for t in times]\nif x[0] > 1: print(f'{x:.3f}')", []),
        ("f = lambda t: 2 * t\nv = at(f, 1.0, rate=3)\na, b = v", []),
        ("x, y = (a - b for a, b in zip(p, q))", ["generator", "zip"]),
        ("point('P', *along(f, t), **{**d})", ["star"]),
        ("x = R @ v if t > 0 else p[:2]", ["@", "conditional expression", "slice"]),
        ("while t < 1:\n    t += 0.1", ["+=", "while"]),
    ],
)
def test_what_goes_beyond_the_primer_is_found(source, names):
    assert beyond(source) == names


def test_lists_of_what_goes_beyond_name_no_cell_twice():
    assert max(Counter(c for cells in BEYOND.values() for c in cells).values(), default=1) == 1
