"""Reads a formula of SymPy or SymEngine as a tree of a few operators (see :mod:`.trees`): other
functions are written out by these, sec x as 1/cos x, and unevaluated parts are evaluated.
"""

from collections.abc import Mapping
from typing import Any

from ..algebra.language import Words
from ..algebra.scalars import FUNCTIONS, clipped, without_rates
from .trees import NODES, Budget, Tree, TreeError, check_size
from .values import read_number, refuse_equation

I_TREE = ["^", -1, 0.5]
_SAME = (*FUNCTIONS, "atan2", "Abs", "Max", "Min", "Mod")  # with the names that SymPy has
_READ = {"Add": "+", "Mul": "*", "Pow": "^", **{name: name for name in _SAME}}


# other functions in terms of those that are read; with SymPy's principal branch
_WRITTEN_OUT = {
    "sec": lambda x: ["/", 1, ["cos", x]],
    "csc": lambda x: ["/", 1, ["sin", x]],
    "cot": lambda x: ["/", ["cos", x], ["sin", x]],
    "asec": lambda x: ["acos", ["/", 1, x]],
    "acsc": lambda x: ["asin", ["/", 1, x]],
    "acot": lambda x: ["atan", ["/", 1, x]],
    "sech": lambda x: ["/", 1, ["cosh", x]],
    "csch": lambda x: ["/", 1, ["sinh", x]],
    "coth": lambda x: ["/", ["cosh", x], ["sinh", x]],
    "asinh": lambda x: ["log", ["+", x, ["sqrt", ["+", ["^", x, 2], 1]]]],
    "acosh": lambda x: ["log", ["+", x, ["sqrt", ["+", ["^", x, 2], -1]]]],
    "atanh": lambda x: ["*", 0.5, ["log", ["/", ["+", 1, x], ["+", 1, ["*", -1, x]]]]],
    "acoth": lambda x: ["*", 0.5, ["log", ["/", ["+", x, 1], ["+", x, -1]]]],
    "sinc": lambda x: ["/", ["sin", x], x],
    "sign": lambda x: ["/", x, ["Abs", x]],
    "Heaviside": lambda x, *_: ["*", 0.5, ["+", 1, ["/", x, ["Abs", x]]]],
}  # fmt: skip
_COMPARISONS = {
    "StrictLessThan": lambda a, b: ["<", a, b],
    "StrictGreaterThan": lambda a, b: ["<", b, a],
    "LessThan": lambda a, b: ["<=", a, b],
    "GreaterThan": lambda a, b: ["<=", b, a],
    "Equality": lambda a, b: ["*", ["<=", a, b], ["<=", b, a]],
    "Unequality": lambda a, b: ["Max", ["<", a, b], ["<", b, a]],
    "And": lambda *args: ["*", *args],
    "Or": lambda *args: ["Max", *args],
    "Not": lambda a: ["+", 1, ["*", -1, a]],
    "ITE": lambda a, b, c: ["where", a, b, c],
}


def read_formula(x: Any, form: Any, symbols: Mapping[str, str], budget: Budget) -> Tree:
    """The tree of a formula: a number, the name of a symbol, or [operator, ...]."""
    tree = _Reader(form, symbols).read(_with_real_symbols(x))
    try:
        check_size(tree, budget)
    except TreeError as error:
        raise form.error("got too much: {error}", error=error) from None
    return tree


def _with_real_symbols(x):
    """The formula with real symbols, even where a student made them without that assumption."""
    x = without_rates(x)
    if str(type(x).__module__).startswith("symengine"):  # SymPy's f(t) has a type without a module
        x = x._sympy_()
    if hasattr(x, "as_expr") and type(x).__name__ == "Poly":
        x = x.as_expr()
    loose = [s for s in getattr(x, "free_symbols", ()) if not s.is_real]
    return x.xreplace({s: type(s)(s.name, real=True) for s in loose}) if loose else x


class _Reader:
    """Reads the parts of one formula."""

    def __init__(self, form, symbols):
        self.form, self.symbols, self.left = form, symbols, NODES

    def read(self, x):
        """The tree of a part."""
        self.left -= 1
        if self.left < 0:
            raise self.form.error(
                "got more than {NODES} operations. Simplify it, or insert fewer results",
                NODES=NODES,
            )
        if not hasattr(x, "args") or isinstance(x, (int, float)):
            return read_number(x, self.form)
        if x.is_Relational:
            refuse_equation(x, self.form)
        if x.is_Symbol:
            return self._symbol(x)
        if x.is_Rational and max(abs(x.p), x.q) < 2**53:  # larger ones are not exact in JSON
            return int(x) if x.is_Integer else ["/", float(x.p), float(x.q)]
        if x.is_Number or not x.args:
            named = {"pi": "pi", "I": I_TREE}
            return named.get(str(x)) or read_number(x, self.form)
        return self._function(x)

    def _symbol(self, x):
        if x.name not in self.symbols:
            text = Words("it contains {name}, but the symbols of the problem are {known}")
            raise self.form.error(text, name=repr(x.name), known=", ".join(self.symbols))
        return x.name

    def _function(self, x):
        name = x.func.__name__
        if name in _READ:
            return [_READ[name], *map(self.read, x.args)]
        if name in _WRITTEN_OUT:
            return _WRITTEN_OUT[name](*map(self.read, x.args))
        if name == "Piecewise":
            return self._piecewise(x.args)
        done = x.doit()
        if done != x:
            return self.read(done)
        refuse_equation(x, self.form)
        known = ", ".join((*_SAME, *_WRITTEN_OUT))
        raise self.form.error(
            "{name} is not among the functions that are read: {known}", name=name, known=known
        )

    def _piecewise(self, cases):
        """The nested cases, built from the last one, which also holds where no condition does."""
        tree = self.read(cases[-1][0])
        for value, condition in reversed(cases[:-1]):
            tree = ["where", self._condition(condition), self.read(value), tree]
        return tree

    def _condition(self, x):
        name = x.func.__name__
        if name in ("BooleanTrue", "BooleanFalse"):
            return int(name == "BooleanTrue")
        if name not in _COMPARISONS:
            raise self.form.error(
                "the condition {x} cannot be read; use <, <=, > and >=", x=clipped(x)
            )
        parts = self.read if x.is_Relational else self._condition
        return _COMPARISONS[name](*map(parts, x.args))
