"""Reads a typed answer: numbers, lists, arithmetic with given names. Nothing is run as code."""

import ast
import math
from collections.abc import Mapping
from typing import Any

from ...algebra.language import Words, _
from ...algebra.scalars import FUNCTIONS
from ...answers.forms import AnswerError
from ...answers.trees import Tree, TreeError, evaluate

LONGEST = 500  # letters: what nests deeper than this allows would exhaust a browser's stack
# what phones and other texts write for the signs of a formula
_WRITTEN = str.maketrans(
    {"\N{MINUS SIGN}": "-", "×": "*", "·": "*", "⋅": "*", "÷": "/", "^": "**", "\xa0": " "}
)
_NOT_REAL = Words("it is not a real number")
_WHY = {ZeroDivisionError: Words("it divides by zero"), OverflowError: Words("it is too large")}
_SIGNS = Words("only numbers, lists, + - * / ** and functions such as sqrt, sin, cos are read")


def typed(text: str, names: Mapping[str, float], words: tuple[str, ...] = ()) -> Any:
    """The value of a text such as ``[2*b, -0.5, sqrt(3)*pi]``; one of the ``words`` is itself; an
    empty text None. Raises :class:`AnswerError`.

    >>> typed("[2*b, 1e3]", {"b": 8.0})
    [16.0, 1000.0]
    """
    text = text.strip()
    if not text:
        return None
    if words:
        return text.strip("'\"")
    try:
        return _value(typed_tree(text, names), names)
    except AnswerError:
        raise
    except (ArithmeticError, ValueError, TypeError, RecursionError) as error:
        why = next((words for kind, words in _WHY.items() if isinstance(error, kind)), _NOT_REAL)
        raise AnswerError("{text} has no value: {why}", text=repr(text[:60]), why=why) from error


def typed_tree(text: str, names: Mapping[str, float]) -> Tree:
    """The formula tree of a text; of a list a tuple of them. Raises :class:`AnswerError`.

    >>> typed_tree("2*b - 1", {"b": 8.0})
    ['+', ['*', 2.0, 'b'], -1.0]
    """
    if len(text) > LONGEST:
        raise AnswerError(
            "{text} … has more than {most} characters", text=repr(text[:30]), most=LONGEST
        )
    try:
        return _tree(ast.parse(text.strip().translate(_WRITTEN), mode="eval").body, names)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        if isinstance(error, AnswerError):
            raise
        raise AnswerError(
            "{text} is neither a number nor a list such as [1.0, 0, -2.5]", text=repr(text[:60])
        ) from None


def _tree(node, names):
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        return float(node.value)
    if isinstance(node, (ast.List, ast.Tuple)):
        return tuple(_tree(x, names) for x in node.elts)
    if isinstance(node, ast.Name):
        if node.id in names or node.id == "pi":
            return node.id
        raise AnswerError(
            _("{name} is not one of the given names: {names}", name=node.id, names=", ".join(names))
            if names
            else _("{name} is not a given name: there are none", name=node.id)
        )
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
        x = _tree(node.operand, names)
        return x if isinstance(node.op, ast.UAdd) else _negative(x)
    if isinstance(node, ast.BinOp) and type(node.op) in _BETWEEN:
        return _BETWEEN[type(node.op)](_tree(node.left, names), _tree(node.right, names))
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        name, arguments = node.func.id, [_tree(x, names) for x in node.args]
        if name == "radians" and len(arguments) == 1:
            return ["*", *arguments, ["/", "pi", 180.0]]
        if len(arguments) == (2 if name == "atan2" else 1) and name in (*FUNCTIONS, "atan2"):
            return [name, *arguments]
    raise AnswerError(_SIGNS)


def _negative(x):
    return -x if isinstance(x, float) else _product(-1.0, x)


def _product(a, b):
    """The product of two trees, of all their factors in a row."""
    first, second = (x[1:] if isinstance(x, list) and x[0] == "*" else [x] for x in (a, b))
    return ["*", *first, *second]


_BETWEEN: dict[type, Any] = {
    ast.Add: lambda a, b: ["+", a, b], ast.Sub: lambda a, b: ["+", a, _negative(b)],
    ast.Mult: _product, ast.Div: lambda a, b: ["/", a, b],
    ast.Pow: lambda a, b: ["^", a, b],
}  # fmt: skip


def _value(tree, names):
    if isinstance(tree, tuple):
        return [_value(part, names) for part in tree]
    try:
        x = evaluate(tree, names)
    except TreeError:  # a list within a formula
        raise AnswerError(_SIGNS) from None
    if isinstance(x, complex):
        raise ValueError
    if not math.isfinite(x):
        raise OverflowError
    return float(x)
