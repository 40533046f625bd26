"""Functions ``(s, p, t)`` in pickles: by their name, or if they have none as their traced steps."""

import sys
from collections.abc import Callable, Iterable
from copy import deepcopy
from dataclasses import fields
from functools import reduce
from inspect import Parameter, Signature
from types import FunctionType, MappingProxyType
from typing import Any, Protocol, Self, TypeAlias

from .compile import compiled
from .scalars import NewtonEulerError, Scalar
from .trace import Step, Trace


class Values(Protocol):
    """The states ``s`` or the parameters ``p``, as a formula ``(s, p, t)`` reads them: by name."""

    def __getattr__(self, name: str) -> Scalar: ...


# functions (s, p, t): of one number; of one for each state, in their order
Formula: TypeAlias = Callable[[Values, Values, Scalar], Scalar]
Formulas: TypeAlias = Callable[[Values, Values, Scalar], Iterable[Scalar]]


class Portable:
    """Base of frozen records of functions ``(s, p, t)``; pickles have those by :func:`portable`."""

    def __getstate__(self):
        return self._each(_in_pickle)

    def __copy__(self) -> Self:
        return self._with(lambda x: x)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self._with(lambda x: deepcopy(x, memo))

    def _each(self, change):
        return {f.name: change(getattr(self, f.name)) for f in fields(self)}

    def _with(self, change):
        new = object.__new__(type(self))
        vars(new).update(self._each(change))
        return new


def portable(f: Any) -> Any:
    """The function ``f``, or its traced :class:`Steps` if no other process finds it by its name:
    what it reads besides its arguments is taken as it is now. One that branches on values stays.
    """
    if type(f) is not FunctionType or _has_name(f):
        return f
    try:
        return Steps(f)
    except (NewtonEulerError, TypeError, AttributeError, ArithmeticError):
        return f


class Steps:
    """A function ``(s, p, t)`` by its traced steps: ``formula`` takes the values that it asks for,
    each an ``asked`` pair as ("s", "v"), or ("t", "").
    """

    def __init__(self, f: Formula | Formulas):
        trace = Trace()
        asked: dict[tuple[str, str], Step] = {}
        s, p = (_Asked(of, asked, trace) for of in "sp")
        f(s, p, trace.new("argument", "t"))
        self.asked = [("t", ""), *asked]
        names = [f"{of}_{name}" for of, name in self.asked]

        def formula(*values):
            given = dict(zip(self.asked, values, strict=True))
            return f(_Given("s", given), _Given("p", given), given["t", ""])

        kind = Parameter.POSITIONAL_ONLY
        signature = Signature([Parameter(n, kind) for n in names])
        vars(formula).update(__signature__=signature)
        formula.__name__ = f.__name__
        self.formula = compiled(formula)

    def __call__(self, s: Values, p: Values, t: Scalar) -> Any:
        given = {"s": s, "p": p}
        values = [t if of == "t" else getattr(given[of], name) for of, name in self.asked]
        return self.formula(*values)


class _Asked:
    """Placeholder for states or parameters, which notes which of them a function asks for."""

    def __init__(self, *noted):
        vars(self)[""] = noted  # a name that no state and no parameter has

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        of, asked, trace = vars(self)[""]
        if (of, name) not in asked:
            asked[of, name] = trace.new("argument", f"{of}_{name}")
        return asked[of, name]


class _Given:
    """States or parameters by name, from values by ("s", name)."""

    def __init__(self, of, values):
        vars(self).update({name: x for (kind, name), x in values.items() if kind == of})


def _has_name(f):
    """True for a function that another process finds by its name; not for one of a notebook."""
    if f.__module__ == "__main__" or "<" in f.__qualname__:
        return False
    try:
        return reduce(getattr, f.__qualname__.split("."), sys.modules[f.__module__]) is f
    except (KeyError, AttributeError):
        return False


def _in_pickle(x):
    if isinstance(x, MappingProxyType):
        return MappingProxyType({n: portable(value) for n, value in x.items()})
    return portable(x)
