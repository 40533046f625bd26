"""The mutants of a module: its syntax tree with one small change each, like a programmer's slip."""

import ast
from collections.abc import Iterator
from copy import deepcopy
from typing import NamedTuple

OPPOSITES = (ast.Eq, ast.NotEq), (ast.Is, ast.IsNot), (ast.In, ast.NotIn)
COMPARISONS = {a: (b,) for pair in OPPOSITES for a, b in (pair, pair[::-1])}
COMPARISONS |= {ast.Lt: (ast.LtE, ast.Gt), ast.LtE: (ast.Lt, ast.GtE)}
COMPARISONS |= {ast.Gt: (ast.GtE, ast.Lt), ast.GtE: (ast.Gt, ast.LtE)}
OPERATORS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult}
NAMES = {"min": "max", "max": "min", "any": "all", "all": "any"}
DROPPED = ast.Expr, ast.Assign, ast.AugAssign, ast.Raise, ast.Continue, ast.Break
FUNCTIONS = ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda


class Mutant(NamedTuple):
    """One change: ``old`` becomes ``new``, nodes of the syntax tree.

    lines : of the statement that contains it, without those of inner statements
    always : True if that runs when the module is imported, or its result is kept from call to call
    """

    old: ast.AST
    new: ast.AST
    lines: range
    always: bool

    @property
    def line(self) -> int:
        """The number of the line of the change."""
        return self.old.lineno

    def __str__(self):
        return f"{_text(self.old)}  ->  {_text(self.new)}"

    def applied(self, tree: ast.AST) -> ast.AST:
        """A copy of the tree with this change."""
        # deepcopy takes what the memo holds for the copy of the old node
        return ast.fix_missing_locations(deepcopy(tree, {id(self.old): self.new}))


def _text(node):
    text = " ".join(ast.unparse(node).split())
    return text if len(text) <= 60 else text[:57] + "..."


def mutants(tree: ast.AST) -> list[Mutant]:
    """All mutants of a module, in the order of its lines."""
    found = [
        Mutant(node, ast.copy_location(new, node), _lines(statement), always)
        for node, statement, always in _places(tree, None, True)
        for new in _changes(node)
    ]
    return sorted(found, key=lambda m: (m.line, m.old.col_offset))


def _places(node, statement, always) -> Iterator[tuple]:
    """The nodes below, each with its statement and whether that always runs; no annotations."""
    for field, value in ast.iter_fields(node):
        if field in ("annotation", "returns", "decorator_list"):
            continue
        # a body runs when the function is called, its defaults when it is defined
        inner = always
        if field == "body" and isinstance(node, FUNCTIONS):
            names = [ast.unparse(d) for d in getattr(node, "decorator_list", ())]
            inner = any("cache" in name for name in names)  # it ran for another test
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST) and not _is_left(child):
                within = child if isinstance(child, ast.stmt) else statement
                if within is not None:
                    yield child, within, inner
                yield from _places(child, within, inner)


def _is_left(node):
    """True for what is left unchanged: texts, and strict= of zip, which is only a guard."""
    guard = isinstance(node, ast.keyword) and node.arg == "strict"
    return guard or isinstance(node, (ast.JoinedStr, ast.Import, ast.ImportFrom))


def _lines(statement):
    """The lines of a statement, without those of the statements in it."""
    body = getattr(statement, "body", None)
    last = body[0].lineno - 1 if body else statement.end_lineno
    return range(statement.lineno, max(last, statement.lineno) + 1)


def _changes(node) -> Iterator[ast.AST]:
    """What may replace a node."""
    if isinstance(node, ast.Compare):
        for n, op in enumerate(node.ops):
            for new in COMPARISONS[type(op)]:
                ops = [*node.ops[:n], new(), *node.ops[n + 1 :]]
                yield ast.Compare(node.left, ops, node.comparators)
    elif isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
        yield ast.BinOp(node.left, OPERATORS[type(node.op)](), node.right)
    elif isinstance(node, ast.BoolOp):
        yield ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
        for n in range(len(node.values)):
            rest = [*node.values[:n], *node.values[n + 1 :]]
            yield rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)):
        yield node.operand
    elif isinstance(node, ast.Constant):
        yield from map(ast.Constant, _constants(node.value))
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        name = node.func.id
        if name in NAMES:
            yield ast.Call(ast.Name(NAMES[name], ast.Load()), node.args, node.keywords)
        elif name == "abs":
            yield node.args[0]
    elif isinstance(node, ast.Return) and not _is_nothing(node.value):
        yield ast.Return(ast.Constant(None))
    elif isinstance(node, DROPPED) and not (
        isinstance(node, ast.Expr) and isinstance(node.value, (ast.Constant, ast.JoinedStr))
    ):
        yield ast.Pass()
    if isinstance(node, (ast.If, ast.IfExp)):
        for value in (True, False):
            yield type(node)(ast.Constant(value), node.body, node.orelse)


def _is_nothing(node):
    # False is changed to True, which tests more than None
    return node is None or (isinstance(node, ast.Constant) and node.value in (None, False))


def _constants(value):
    if isinstance(value, bool):
        return (not value,)
    if isinstance(value, (int, float)):
        new = (2 * value, value + 1, 0 * value)
        return tuple(dict.fromkeys(x for x in new if x != value))
    return ()
