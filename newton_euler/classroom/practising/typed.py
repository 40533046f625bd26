"""Reads a typed answer: numbers, lists, arithmetic with given names. Nothing is run as code."""

import ast
import math
import operator
from collections.abc import Mapping
from typing import Any

from ...algebra.scalars import FUNCTIONS, function
from ...answers.forms import AnswerError

_OPERATORS: dict[type, Any] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
    ast.Div: operator.truediv, ast.Pow: operator.pow, ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}  # fmt: skip


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
        return _value(ast.parse(text.replace("^", "**"), mode="eval").body, names)
    except SyntaxError:
        raise AnswerError(f"{text[:60]!r} is no number, and no list as [1.0, 0, -2.5]") from None
    except (ArithmeticError, ValueError, TypeError, RecursionError) as error:
        raise AnswerError(f"{text[:60]!r} has no value: {error}") from error


def _value(node, names):
    if isinstance(node, ast.Constant) and type(node.value) in (int, float):
        return float(node.value)  # never a Python integer: 9**9**9 would not end
    if isinstance(node, (ast.List, ast.Tuple)):
        return [_value(x, names) for x in node.elts]
    if isinstance(node, ast.Name):
        if node.id in names or node.id == "pi":
            return float(names.get(node.id, math.pi))
        raise AnswerError(f"{node.id} is none of the given names: {', '.join(names) or 'none'}")
    if isinstance(node, ast.UnaryOp) and type(node.op) in _OPERATORS:
        return _OPERATORS[type(node.op)](_value(node.operand, names))
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        return _OPERATORS[type(node.op)](_value(node.left, names), _value(node.right, names))
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        arguments = [_value(x, names) for x in node.args]
        if node.func.id == "radians" and len(arguments) == 1:
            return math.radians(arguments[0])
        if node.func.id in FUNCTIONS and len(arguments) == 1:
            return function(node.func.id, arguments[0])
        if node.func.id == "atan2" and len(arguments) == 2:
            return math.atan2(*arguments)
    raise AnswerError("only numbers, lists, + - * / ** and functions as sqrt, sin, cos are read")
