"""A model made ready to run: its formulas traced once and kept, with its parameters as numbers beside them.

Models that share a right-hand side (the same scene with other parameters) share the traced text, and what heyoka has compiled from it.
"""

import ast
import math
from functools import cached_property
from inspect import Parameter, Signature

from .hoisting import folded
from .models import Model, ModelError, is_law
from .scalars import ZERO, ScalarError, is_numeric, plain, scalar
from .tracing import compiled

KEPT = 64  # right-hand sides, and functions of the states for each: those made at each call, as a lambda is, would pile up
_known = {}


class Traced:
    """The text of one right-hand side: ``f(t, *states, *free)`` on floats, its ``rhs`` for all other kinds, and which states each rate needs."""

    def __init__(self, model, free):
        self.rhs, self.states = formula(model, free, model.rhs), len(model.states)
        self.f = self.rhs._run["math"]
        self.functions, self.integrators = {}, {}
        self.seconds = 0.0  # spent in integrating it, to decide whether heyoka's compilation pays

    @cached_property
    def needs(self):
        """For each rate the names of the arguments that it depends on."""
        return _dependencies(self.rhs.source)

    @cached_property
    def folded(self):
        """The right-hand side with single numbers in place of what depends on parameters alone, and the formula that gives these."""
        return folded(self.rhs, 1 + self.states)

    @cached_property
    def folded_on_floats(self):
        """Both as functions of floats."""
        return tuple(text._on(math) for text in self.folded)


def prepared(model):
    """The :class:`System` of a model, which keeps it."""
    if not isinstance(model, Model):
        raise ModelError(f"integrate takes a Model, got {model!r}")
    found = vars(model).get("_prepared")
    if found is None:
        found = PreparedModel(model)
        object.__setattr__(model, "_prepared", found)
    return found


class PreparedModel:
    """A model with the numbers of its parameters.

    f : the right-hand side on floats, ``f(t, *states, *p)``; p : the values of the parameters that are arguments of it
    many : True if some parameter is an array
    Raises :class:`ModelError` for a parameter that has no number.
    """

    def __init__(self, model):
        self.model = model
        fixed = tuple((n, x) for n, x in model.parameters.items() if is_law(x) or scalar(x) is ZERO)
        names = [n for n, _ in fixed]
        self.free = tuple(n for n in model.parameters if n not in names)
        self.p = tuple(_number(model, n, model.parameters[n]) for n in self.free)
        self.exact_verified = False  # its exact solution, once that has been tried
        self.many = any(getattr(x, "shape", ()) for x in model.parameters.values())
        self.traced = _cached(_known, (model.rhs, model.states, self.free, fixed), lambda: Traced(model, self.free))
        self.f = self.traced.f

    @cached_property
    def autonomous(self):
        """True if time does not occur in the rates."""
        return all("t" not in needs for needs in self.traced.needs)

    @cached_property
    def constants(self):
        """What the rates need of the parameters, for the first of ``traced.hoisted``; nan if the parameters give no numbers."""
        rest, early = self.traced.folded_on_floats
        try:
            return early(*self.p)
        except (ArithmeticError, ValueError):
            return (math.nan,) * (rest.__code__.co_argcount - 1 - self.traced.states)

    @property
    def folded_rates(self):
        """The right-hand side on floats, ``fast(t, *states, *numbers)``."""
        return self.traced.folded_on_floats[0]

    def rates(self, t, x):
        """The rates of the states."""
        return self.f(t, *x, *self.p)

    def function(self, formula_):
        """A function ``(s, p, t)`` as one of ``(t, *states)``; traced where it can be, else called as it is."""
        text, p = self._text(formula_), self.p
        return self._called(formula_) if text is None else lambda t, *x: text(t, *x, *p)

    def _called(self, formula_):
        model = self.model
        return lambda t, *x: _plain(model._call(formula_, dict(zip(model.states, x, strict=True)), model.parameters, t))

    @cached_property
    def solution(self):
        """The exact solution as a function of ``(t, states)`` on floats alone, which returns a tuple of floats.

        Where the traced text has no value, as for an orbit that is no ellipse, the formula is called, which says why: a :class:`ModelError`.
        """
        formula_, p, model = self.model.exact, self.p, self.model
        text, called = self._text(formula_), self._called(formula_)
        run = (lambda *_: (math.nan,)) if text is None else text._run["math"]

        def at(t, x):
            try:
                found = run(t, *x, *p)
                if math.isfinite(sum(found)):
                    return found
            except (ArithmeticError, ValueError):
                pass  # as below
            try:
                found = tuple(map(float, called(t, *x)))
            except ArithmeticError as error:
                raise ModelError(f"the exact solution of {model.name!r} has no value at t = {t:.6g} after {x}: {error}") from error
            if not math.isfinite(sum(found)):
                raise ModelError(f"the exact solution of {model.name!r} has no value at t = {t:.6g} after {x}")
            return found

        return at

    def solutions(self, times, x):
        """The same at an array of times: an array (states, times)."""
        import numpy as np

        for run in (self.function(self.model.exact), self._called(self.model.exact)):
            found = np.array([np.broadcast_to(row, times.shape) for row in run(times, *x)])
            if np.isfinite(found).all():
                break
        return found

    def _text(self, formula_):
        """The traced text of a function ``(s, p, t)``; None if it branches on values, as is allowed for events."""

        def made():
            try:
                return formula(self.model, self.free, formula_)
            except (TypeError, ModelError):
                return None

        return _cached(self.traced.functions, formula_, made)


def formula(model, free, f):
    """A function ``(s, p, t)`` of the model as traced text with the arguments ``t, *states, *free``."""

    def values(**named):
        parameters = {**model.parameters, **{n: named[n] for n in free}}
        return _plain(model._call(f, {n: named[n] for n in model.states}, parameters, named["t"]))

    values.__name__ = model.name
    values.__signature__ = Signature([Parameter(n, Parameter.POSITIONAL_OR_KEYWORD) for n in ("t", *model.states, *free)])
    return compiled(values)


def _plain(result):
    return tuple(map(plain, result)) if isinstance(result, tuple) else plain(result)


def _cached(cache, key, make):
    """The value of a key in the cache, made if it is not there; of all values the ``KEPT`` that were used last stay."""
    found = cache.pop(key, cache)  # the cache itself stands for what is not in it
    cache[key] = found = make() if found is cache else found
    if len(cache) > KEPT:
        cache.pop(next(iter(cache)), None)
    return found


def _number(model, name, value):
    try:
        if getattr(value, "shape", ()):
            return value
        value = float(value)
    except (TypeError, ValueError, ScalarError) as error:
        raise ModelError(f"the parameter {name} of {model.name!r} has no number: {value!r}; put one in with changed({name}=...)") from error
    if not math.isfinite(value):
        raise ModelError(f"the parameter {name} of {model.name!r} is {value!r}; a motion needs finite numbers")
    return value


def start_state(model, start):
    """The start as a tuple of floats (or arrays) in the order of the states; :class:`ModelError` says what is wrong with it."""
    if type(start) in (tuple, list) and len(start) == len(model.states) and set(map(type, start)) == {float} and math.isfinite(sum(start)):
        return tuple(start)
    if not isinstance(start, dict) and not hasattr(start, "keys") and not hasattr(start, "__iter__"):
        raise ModelError(f"the start of {model.name!r} is a value for each of {', '.join(model.states)}, not {start!r}")
    unknown = [n for n in start if n not in model.states] if hasattr(start, "keys") else []
    if unknown:
        raise ModelError(f"{model.name} has no state {unknown[0]!r}; its states are {', '.join(model.states)}")
    return tuple(_state(model, n, x) for n, x in model._state(start).items())


def _state(model, name, x):
    try:
        if getattr(x, "shape", ()):
            return x
        if isinstance(x, (str, bool)) or not is_numeric(scalar(x)):
            raise TypeError
        x = float(x)
    except TypeError as error:
        raise ModelError(f"the start of {model.name!r} needs a number for {name}, got {x!r}") from error
    if not math.isfinite(x):
        raise ModelError(f"the start of {model.name!r} has {name} = {x!r}; a motion needs finite numbers")
    return x


def _dependencies(source):
    """Which arguments each result of a straight-line text depends on."""
    function = ast.parse(source).body[0]
    known = {a.arg: {a.arg} for a in function.args.args}

    def of(node):
        return set().union(*(known.get(n.id, set()) for n in ast.walk(node) if isinstance(n, ast.Name)))

    for line in function.body[:-1]:
        known[line.targets[0].id] = of(line.value)
    return [of(node) for node in function.body[-1].value.elts]
