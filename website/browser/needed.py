"""Which statements of the cells above another cell needs: those that bind its names, and theirs."""

import ast
import symtable
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

MUTATING = {
    "add", "append", "clear", "discard", "extend", "insert", "pop", "remove", "reverse",
    "setdefault", "sort", "update",
}  # fmt: skip
WHOLE = ast.Assign, ast.AnnAssign, ast.FunctionDef, ast.ClassDef, ast.Import, ast.ImportFrom


@dataclass(frozen=True, eq=False)
class Statement:
    """A statement of a cell at its top level.

    binds, uses : the names that it binds or changes, and those that it needs when it runs
    later : the names that its functions need when they are called
    whole : it binds its names whatever they were before
    """

    node: ast.stmt
    binds: frozenset[str]
    uses: frozenset[str]
    later: frozenset[str]
    whole: bool


@cache
def statements(source: str) -> tuple[Statement, ...]:
    """The statements of a cell; none if it is not Python."""
    try:
        return tuple(_statement(node) for node in ast.parse(source).body)
    except SyntaxError:
        return ()


def _statement(node):
    table = symtable.symtable(ast.unparse(node), "<cell>", "exec")
    symbols = table.get_symbols()
    bound = {s.get_name() for s in symbols if s.is_assigned() or s.is_imported()}
    changed = {*_changed(node)}
    return Statement(
        node,
        frozenset(bound | changed),
        frozenset({s.get_name() for s in symbols if s.is_referenced()} | changed),
        frozenset(name for inner in table.get_children() for name in _free(inner)),
        isinstance(node, WHOLE) and not changed,
    )


def _free(table):
    """The global names of a function or class and of what is within."""
    yield from (s.get_name() for s in table.get_symbols() if s.is_global())
    for inner in table.get_children():
        yield from _free(inner)


def _changed(node):
    """The names of objects that are changed in place."""
    for part in ast.walk(node):
        stored = isinstance(part, (ast.Attribute, ast.Subscript)) and not isinstance(
            part.ctx, ast.Load
        )
        mutated = (
            isinstance(part, ast.Call)
            and isinstance(part.func, ast.Attribute)
            and part.func.attr in MUTATING
        )
        if stored or mutated:
            root = part
            while isinstance(root, (ast.Attribute, ast.Subscript, ast.Call)):
                root = root.func if isinstance(root, ast.Call) else root.value
            if isinstance(root, ast.Name):
                yield root.id


def statements_needed(above: Sequence[str], source: str) -> list[tuple[int, Statement]]:
    """(number of its cell, statement) of those that ``source`` needs of the cells above it, in
    order.

    >>> cells = ["g = 9.81; print(g)", "def fall(t): return g*t**2/2", "t = 3", "t = 2"]
    >>> [ast.unparse(s.node) for _, s in needed(cells, "fall(t)")]
    ['g = 9.81', 'def fall(t):\\n    return g * t ** 2 / 2', 't = 2']
    """
    all_of_them = [(n, s) for n, cell in enumerate(above) for s in statements(cell)]
    target = statements(source)
    kept = {name for s in target for name in s.later}  # what functions need when called
    while True:
        wanted, found = {name for s in target for name in s.uses}, []
        for n, s in reversed(all_of_them):
            if s.binds & (wanted | kept):
                found.append((n, s))
                wanted = (wanted - s.binds if s.whole else wanted) | s.uses
        later = {name for _, s in found for name in s.later}
        if later <= kept:
            return found[::-1]
        kept |= later
