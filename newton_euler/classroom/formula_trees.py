"""Formulas as nested lists of numbers, symbols and a few operators, which are data and not code:
read from SymPy, evaluated, and checked for their dimension.
"""

from functools import reduce
from operator import add, mul

from ..algebra.errors import NewtonEulerError
from ..algebra.scalars import FUNCTIONS, function, pi
from ..algebra.units import Dimension, DimensionError, UnitError, unit
from .forms import SHAPES, read_number

NAMED = (*FUNCTIONS, "atan2", "Abs")
NODES = 4000  # the largest formula that is read, in operations
DEPTH = 200  # the deepest formula that is evaluated


def read_formula(x, form, symbols, budget):
    """The tree of a SymPy or SymEngine expression: a number, the name of a symbol, or [operator,
    ...].

    budget : a list of one number, the operations that may still be read
    """
    budget[0] -= 1
    if budget[0] < 0:
        fault = f"got more than {NODES} operations. Simplify it, or insert fewer results"
        raise form.error(fault)
    if not hasattr(x, "args") or isinstance(x, (int, float)):
        return read_number(x, form)
    if str(type(x).__module__).startswith("symengine"):  # SymPy's f(t) has a type without a module
        x = x._sympy_()
    if x.is_Symbol:
        if x.name not in symbols:
            known = ", ".join(symbols)
            raise form.error(f"it contains {x.name!r}, but the symbols of the problem are {known}")
        return x.name
    if x.is_Integer:
        return int(x) if abs(int(x)) < 2**53 else float(x)  # larger ones are not exact in JSON
    if x.is_Rational:
        return ["/", float(x.p), float(x.q)]
    if x.is_Number or not x.args:
        return "pi" if str(x) == "pi" else read_number(x, form)
    name = x.func.__name__
    name = {"Add": "+", "Mul": "*", "Pow": "^"}.get(name, name)
    if name not in ("+", "*", "^", *NAMED):
        raise form.error(f"{name} is not among the functions that are read: {', '.join(NAMED)}")
    return [name, *(read_formula(a, form, symbols, budget) for a in x.args)]


class TreeError(NewtonEulerError, ValueError):
    """Data that are not a formula: an unknown operator or symbol, or nested too deep."""


def evaluate(tree, values, depth=0):
    """The value of a formula tree over scalars of any kind; nothing of the tree is run as code.

    values : maps symbols to scalars

    >>> evaluate(["*", "r", ["^", "omega", 2]], {"r": 0.5, "omega": 4.0})
    8.0
    """
    if depth > DEPTH:
        raise TreeError(f"the formula is nested more than {DEPTH} deep")
    if isinstance(tree, bool) or tree is None:
        raise TreeError(f"not a formula: {tree!r}")
    if isinstance(tree, (int, float)):
        return float(tree)  # never a Python integer: 9^9^9 would not end
    if isinstance(tree, str):
        if tree == "pi":
            return pi()
        if tree not in values:
            raise TreeError(f"unknown symbol {tree[:40]!r}")
        return values[tree]
    if not isinstance(tree, list) or not tree or not isinstance(tree[0], str):
        raise TreeError("a formula is a number, a symbol or a list that begins with an operator")
    name, args = tree[0], [evaluate(a, values, depth + 1) for a in tree[1:]]
    if args and name in ("+", "*"):
        return reduce(add if name == "+" else mul, args)
    if len(args) == 2 and name in ("^", "/", "atan2"):
        a, b = args
        return _power(a, b) if name == "^" else a / b if name == "/" else function(name, a, b)
    if len(args) == 1 and (name == "Abs" or name in FUNCTIONS):
        return abs(*args) if name == "Abs" else function(name, *args)
    raise TreeError(f"unknown operator {name[:40]!r} with {len(args)} arguments")


def _power(base, exponent):
    if isinstance(exponent, Dimension):
        if isinstance(base, Dimension) and any(base.powers):
            raise DimensionError(f"a quantity with {base} is raised to a power that is no number")
        return Dimension()
    if isinstance(exponent, float) and exponent.is_integer():
        exponent = int(exponent)
    return base**exponent


def in_words(tree):
    """A tree, or a list of trees, as text for a reader."""
    if not isinstance(tree, list):
        return f"{tree:.6g}" if isinstance(tree, float) else str(tree)
    head, parts = tree[0] if tree else None, [in_words(part) for part in tree]
    if head in ("+", "*", "^", "/"):
        return f"({f' {head} '.join(parts[1:])})"
    if head in NAMED:
        return f"{head}({', '.join(parts[1:])})"
    return f"[{', '.join(parts)}]"


def dimension_hints(tree, form, symbols):
    """Sentences on what is wrong with the dimension of a formula, a list; found from the units of
    the symbols, without the key.
    """
    try:
        asked = unit(form.unit).dimension
        dimensions = {n: unit(u).dimension for n, u in symbols.items()}
    except UnitError:
        return []
    hints, parts = [], tree if SHAPES[form.kind] > 1 else [tree]
    for n, part in enumerate(parts):
        where = f"component {n + 1}" if len(parts) > 1 else "it"
        try:
            got = evaluate(part, dimensions)
        except DimensionError as error:
            hints.append(f"{where} adds unlike quantities ({error})")
            continue
        got = got if isinstance(got, Dimension) else Dimension()
        if got != asked and part != 0:  # 0 has every dimension
            hints.append(f"{where} has {got}, but {form.unit} has {asked}")
    return hints
