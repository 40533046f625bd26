"""Formulas as nested lists of numbers, symbols and a few operators, which are data and not code:
read out of the JSON of a receipt, evaluated, and checked for their size and their dimension. The
bounds of reading count operations, not seconds, to be the same on every machine. Anything but an
answer raises :class:`TreeError`.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from operator import add, mul
from typing import Any, TypeAlias

from ..algebra.language import _
from ..algebra.late import np
from ..algebra.scalars import FUNCTIONS, ScalarError, function, is_numeric, pi, where
from ..algebra.units import Dimension, DimensionError, UnitError, unit
from .messages import SpokenError
from .tolerance import ONE_VECTOR, Points

Tree: TypeAlias = Any  # a number, the name of a symbol, or [operator, tree, ...], as JSON has it
NAMED = (*FUNCTIONS, "atan2", "Abs", "Max", "Min", "Mod", "where")
NODES = 5000  # the largest receipt that is read, in operations of all its formulas
DEPTH = 200  # the deepest formula
NOISE = 1e-9  # relative: an imaginary part so small is round-off
Budget = list[int]  # a list of one number: the operations that may still be read


class TreeError(SpokenError):
    """Data that are not a formula: an unknown operator or symbol, or nested too deep."""


def check_size(tree: Tree, budget: Budget) -> None:
    """Raise :class:`TreeError` if a tree is nested too deep, or has more operations than are left;
    without recursion, since JSON may be nested deeper than Python can follow.
    """
    waiting = [(tree, 0)]
    while waiting:
        part, depth = waiting.pop()
        budget[0] -= 1
        if budget[0] < 0:
            raise TreeError(
                "the formulas have more than {NODES} operations. Simplify them, or insert "
                "fewer results",
                NODES=NODES,
            )
        if depth > DEPTH:
            raise TreeError("the formula is nested more than {DEPTH} deep", DEPTH=DEPTH)
        if isinstance(part, list):
            # a long list only as far as shows that it is too long
            inner = part[isinstance(part[0], str) if part else 0 : budget[0] + 2]
            waiting += [(x, depth + 1) for x in inner]


def evaluate(tree: Tree, values: Mapping[str, Any], depth: int = 0) -> Any:
    """The value of a formula tree over scalars of any kind, ``values`` {symbol: scalar}; nothing of
    it is run as code.

    >>> evaluate(["*", "r", ["^", "omega", 2]], {"r": 0.5, "omega": 4.0})
    8.0
    """
    if depth > DEPTH:
        raise TreeError("the formula is nested more than {DEPTH} deep", DEPTH=DEPTH)
    if isinstance(tree, bool) or tree is None:
        raise TreeError("not a formula: {tree}", tree=repr(tree))
    if isinstance(tree, (int, float)):
        return float(tree)  # never a Python integer: 9^9^9 would not end
    if isinstance(tree, str):
        if tree == "pi":
            return pi()
        if tree not in values:
            raise TreeError("unknown symbol {tree}", tree=repr(tree[:40]))
        return values[tree]
    if not isinstance(tree, list) or not tree or not isinstance(tree[0], str):
        raise TreeError("a formula is a number, a symbol or a list that begins with an operator")
    name, args = tree[0], [evaluate(a, values, depth + 1) for a in tree[1:]]
    if args and name in ("+", "*"):
        return reduce(add if name == "+" else mul, args)
    if len(args) == 2 and name in ("^", "/", "atan2"):
        a, b = args
        return _power(a, b) if name == "^" else a / b if name == "/" else function(name, a, b)
    if args and name in _OF_NUMBERS:
        return reduce(_OF_NUMBERS[name], args)
    if len(args) == 2 and name in _COMPARED:
        return _compared(name, *args)
    if len(args) == 3 and name == "where":
        return _chosen(*args)
    if len(args) == 1 and (name == "Abs" or name in FUNCTIONS):
        return abs(*args) if name == "Abs" else function(name, *args)
    raise TreeError(
        "unknown operator {name} with {args} arguments", name=repr(name[:40]), args=len(args)
    )


_COMPARED = {"<": lambda a, b: a < b, "<=": lambda a, b: a <= b}


def _compared(name, a, b):
    """1.0 where the comparison holds, else 0.0; of dimensions, a pure number."""
    if not (is_numeric(a) and is_numeric(b)):
        _alike(a, b)
        return Dimension()
    return where(_COMPARED[name](a, b), 1.0, 0.0)


def _chosen(condition, a, b):
    if not (is_numeric(a) and is_numeric(b)):
        return _alike(a, b)
    return where(condition > 0.5, a, b)


def _alike(a, b):
    """The dimension of both, or an error; a zero has every dimension."""
    if not isinstance(a, Dimension) and not isinstance(b, Dimension):
        raise TreeError("cases are chosen for numbers, not for symbols")
    zeros = [isinstance(x, (int, float)) and x == 0 for x in (a, b)]
    return b if zeros[0] else a if zeros[1] else a + b


_OF_NUMBERS: dict[str, Callable] = {
    "Max": lambda a, b: _chosen(_compared("<", a, b), b, a),
    "Min": lambda a, b: _chosen(_compared("<", a, b), a, b),
    "Mod": lambda a, b: _alike(a, b) if Dimension in (type(a), type(b)) else a % b,
}


def _power(base, exponent):
    if isinstance(exponent, Dimension):
        if isinstance(base, Dimension) and any(base.powers):
            raise DimensionError(
                _("a quantity in {base} is raised to a power that is not a number", base=base)
            )
        return Dimension()
    if isinstance(exponent, float) and exponent.is_integer():
        exponent = int(exponent)
    return base**exponent


def in_words(tree: Tree) -> str:
    """A tree, a list of trees, or components in several frames, as text for a reader."""
    if isinstance(tree, dict):
        each = (_("{value} in {frame}", value=in_words(x), frame=f) for f, x in tree.items())
        return ", ".join(each)
    if not isinstance(tree, list):
        return f"{tree:.6g}" if isinstance(tree, float) else str(tree)
    head, parts = tree[0] if tree else None, [in_words(part) for part in tree]
    if head in ("+", "*", "^", "/"):
        return f"({f' {head} '.join(parts[1:])})"
    if head == "<" or head == "<=":
        return f" {head} ".join(parts[1:])
    if head in NAMED:
        return f"{head}({', '.join(parts[1:])})"
    return f"[{', '.join(parts)}]"


def dimension_hints(tree: Tree, form: Any, symbols: Mapping[str, str]) -> list[str]:
    """Sentences on what is wrong with the dimension of a formula, a list; found from the units of
    the symbols, without the key.
    """
    try:
        asked = unit(form.unit).dimension
        dimensions = {n: unit(u).dimension for n, u in symbols.items()}
    except UnitError:
        return []
    if isinstance(tree, dict):  # the dimensions are those of any frame
        tree = next(iter(tree.values()))
    hints, parts = [], form.kind.parts(tree)
    for n, part in enumerate(parts):
        where = _("component {n}", n=n + 1) if len(parts) > 1 else _("it")
        try:
            got = evaluate(part, dimensions)
        except DimensionError as error:
            hints.append(_("{where} adds unlike quantities ({error})", where=where, error=error))
            continue
        except ScalarError:  # no real value, and so no dimension
            continue
        got = got if isinstance(got, Dimension) else Dimension()
        if got != asked and part != 0:  # 0 has every dimension
            wanted = _("a pure number") if asked == Dimension() else form.unit
            hints.append(
                _("{where} is in {got}; {wanted} is asked for", where=where, got=got, wanted=wanted)
                if got != Dimension()
                else _("{where} has no unit; {wanted} is asked for", where=where, wanted=wanted)
            )
    return hints


def numbers(trees: Sequence[Any]) -> Points:
    """One point of finite floats, from ints and floats."""
    return (tuple(_finite(t) for t in trees),)


def _finite(x):
    if isinstance(x, int) and x.bit_length() > 1000:
        raise TreeError("a number is too large")
    if not math.isfinite(x):
        raise TreeError("got {x}, which is not a number", x=x)
    return float(x)


def formula_values(trees: Sequence[Any], symbols: Mapping[str, Any], budget: Budget) -> Points:
    """The values of formula trees at each of the points, ``symbols``: {name: array}."""
    for part in trees:
        check_size(part, budget)
    count = max((len(v) for v in symbols.values()), default=1)
    try:
        with np.errstate(all="ignore"):
            rows = [_values(t, symbols, count) for t in trees]
    except TreeError:
        raise
    # numbers, arrays and complex ones meet in every operation here, and each library refuses some
    # of them with errors of its own: the fault is always the formula's
    except Exception as error:
        raise TreeError("the formula has no value: {error}", error=error) from error
    return tuple(zip(*rows, strict=True))


def _values(tree, symbols, count):
    """The values of a formula, by complex numbers where it is not real, as in log(-x)^2."""
    found = _real(evaluate(tree, symbols), count)
    if not any(map(math.isnan, found)):
        return found
    wide = evaluate(tree, {n: np.asarray(x, dtype=complex) for n, x in symbols.items()})
    wide = np.broadcast_to(np.asarray(wide), (count,))
    real = np.abs(wide.imag) <= NOISE * np.abs(wide)
    return np.where(np.isnan(found) & real, wide.real, found).tolist()


def _real(x, count):
    x = np.asarray(x)
    x = x if x.shape == (count,) else np.broadcast_to(x, (count,))
    if x.dtype.kind == "c":  # NumPy would drop the imaginary part with a warning
        if not (np.abs(x.imag) <= NOISE * np.abs(x).max()).all():
            raise TreeError("it gives complex numbers: a root of a negative number")
        x = x.real
    return x.astype(float).tolist()


def are_one_vector(first: Points, *others: Points) -> bool:
    """True if answers have the same magnitude at each point, as a vector has in all frames."""
    sizes, *rest = [[math.hypot(*point) for point in points] for points in (first, *others)]
    pairs = (pair for other in rest for pair in zip(sizes, other, strict=True))
    return all(abs(a - b) <= ONE_VECTOR * a for a, b in pairs)
