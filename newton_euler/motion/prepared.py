"""A model prepared for integration: its formulas traced once and kept, with the numbers of its
parameters. Models that share a right-hand side share the traced text, and what heyoka made of it.
"""

import math
from collections.abc import Callable
from contextlib import suppress
from functools import cache, cached_property
from typing import Any

from ..algebra.compile import Compiled, Recording, recorded
from ..algebra.late import np
from ..algebra.partial_evaluation import folded
from ..algebra.reads import reads_nothing
from ..algebra.scalars import ZERO, clipped, scalar
from .analytic import clocked, depends, hazards, inner, kinks, surprises
from .crossings import choices, compiled_choices
from .methods.base import Floats, rows_of
from .model import Model, ModelError, cached, current, finite_number, is_law, shared
from .narrow_arguments import Arguments, narrow_arguments
from .verified import Verified

_TRACED: dict = {}


class Traced:
    """The text ``rhs`` of one right-hand side, ``(t, *states, *free)``, and what follows from it.

    arguments : the number of its leading arguments that are not parameters
    functions, texts : other functions of the states, or None, by function; texts by content
    integrators : those of heyoka
    seconds : time spent on integrating it, which decides whether heyoka's compilation pays off
    depends, inner, kinks, clocked, surprises, hazards, choices, compiled_choices, narrow : what the
        functions of the same names find, of :mod:`.analytic` and others
    """

    def __init__(self, rhs: Compiled, arguments: int):
        self.rhs, self.arguments = rhs, arguments
        self.functions: dict = {}
        self.texts: dict = {}
        self.integrators: dict = {}
        self.seconds = 0.0
        self.in_events: dict = {}

    @cached_property
    def folded(self) -> tuple[Compiled, Compiled]:
        """The right-hand side with constants for terms of parameters alone, and their formula."""
        return folded(self.rhs, self.arguments)

    inner, kinks, clocked = cached_property(inner), cached_property(kinks), cached_property(clocked)
    surprises, hazards = cached_property(surprises), cached_property(hazards)
    choices, narrow = cached_property(choices), cached_property(narrow_arguments)
    compiled_choices, depends = cached_property(compiled_choices), cached_property(depends)


def text_once(recording: Recording, texts: dict) -> Callable[[], Compiled]:
    """A function that returns the text of a traced function, written when first needed."""
    return cache(lambda: shared(recording, texts))


def prepared_model(model: Model) -> "PreparedModel":
    """The :class:`PreparedModel` of a model, kept in it until something that it reads changes."""
    if not isinstance(model, Model):
        raise ModelError(f"integrate takes a Model(name, parameters, states, rhs), got {model!r}")
    found = vars(model).get("_prepared")
    if found is None or not found.holds():
        found = PreparedModel(model)
        object.__setattr__(model, "_prepared", found)
    return found


class PreparedModel:
    """A model with the numbers of its parameters, and its functions with what they read at this
    moment: they are traced now, except those that read nothing, which are traced when needed.

    f : the right-hand side on floats, ``f(t, *states, *p)``
    free, p : the names and the values of the parameters that are arguments of it
    many : True if some parameter is an array
    Raises :class:`ModelError` for a parameter that is not a number.
    """

    def __init__(self, model: Model):
        self.model, values = model, model.parameters
        fixed = {n: x for n, x in values.items() if is_law(x) or scalar(x) is ZERO}
        self.free = tuple(n for n in values if n not in fixed)
        self.p = tuple(_parameter(model, n, values[n]) for n in self.free)
        self.verified = Verified()
        self.many = any(getattr(x, "shape", ()) for x in self.p)
        self._fixed = tuple(fixed.items())
        self._laws = tuple([x for x in fixed.values() if callable(x)])
        reads, rhs = model._rhs_text(self.free, self._fixed, self._laws)
        self._take(rhs)
        # key by identity: faster than looking for an equal function
        self._now, self._reads = {}, (reads,) if reads.checks or not reads.known else ()
        for f in self._functions:
            if self._laws or not reads_nothing(f):
                reads, self._now[id(f)] = self._recorded(f)
                self._reads += (reads,)

    def _take(self, rhs):
        """Use this text as the right-hand side."""
        self.traced = cached(_TRACED, rhs, lambda: Traced(rhs, 1 + len(self.model.states)))
        self.f = rhs.on_floats

    def __reduce__(self):
        """The model, and the texts of its functions as they were when this was made."""
        texts = [
            (n, self._now[id(f)] and self._now[id(f)]())
            for n, f in enumerate(self._functions)
            if id(f) in self._now
        ]
        return _snapshot, (self.model, self.traced.rhs, texts)

    @property
    def _functions(self):
        exact = self.model.exact
        return *((exact,) if exact else ()), *self.model.invariants.values()

    def holds(self) -> bool:
        """True if all that the functions of the model read is unchanged."""
        # not a generator: this is part of the shortest run
        for reads in self._reads:  # noqa: SIM110
            if not reads.hold():
                return False
        return True

    @cached_property
    def autonomous(self) -> bool:
        """True if time does not occur in the rates."""
        return all("t" not in needs for needs in self.traced.rhs.dependencies)

    @cached_property
    def constants(self) -> Floats:
        """The constants of the folded right-hand side, a tuple; nan where they have no value."""
        early = self.traced.folded[1]
        try:
            return early.on_floats(*self.p)
        except (ArithmeticError, ValueError):
            return (math.nan,) * len(early.leaves)

    @property
    def folded_rates(self) -> Callable[..., Floats]:
        """The right-hand side on floats, ``folded_rates(t, *states, *constants)``."""
        return self.traced.folded[0].on_floats

    def rates(self, t: float, x: Floats) -> Floats:
        """The rates of the states."""
        return self.f(t, *x, *self.p)

    def function(self, f: Callable[..., Any]) -> Callable[..., Any]:
        """A function ``f(s, p, t)`` as one of ``(t, *states)``; traced if possible."""
        text, p = self._text(f), self.p
        return (lambda t, *x: text(t, *x, *p)) if text else self.untraced(f)

    def untraced(self, f: Callable[..., Any]) -> Callable[..., Any]:
        """A function ``f(s, p, t)`` as one of ``(t, *states)``, without tracing."""
        return lambda t, *x: self.model._value(f, x, t)

    def values(self, f: Callable[..., Any], times: "np.ndarray", x: Any) -> "np.ndarray":
        """The values of ``f(s, p, t)`` at an array of times; one by one if it branches."""
        g = self.function(f)
        with suppress(TypeError, ValueError):
            return np.broadcast_to(g(times, *x), times.shape)
        return np.array([g(*at) for at in zip(times.tolist(), *x.tolist(), strict=True)])

    def narrow_of(self, f: Callable[..., Any]) -> Arguments | None:
        """The narrow arguments in a function of an event; None if it has none, or is not traced."""
        text, of = self._text(f), self.traced
        traced = text and Traced(text, of.arguments)
        return text and cached(of.in_events, text, lambda: narrow_arguments(traced, of_event=True))

    def _text(self, f):
        """The traced text of ``f(s, p, t)``; None if it branches on values, as of an event."""
        own = id(f) in self._now  # else it is traced at each use, as that of an event
        traced = self._now[id(f)] if own else self._recorded(f)[1]
        return traced and traced()

    def _recorded(self, f):
        """What a function reads, and its :func:`text_once` or None; see :func:`current`."""
        known = self.traced

        def recording():
            try:
                return text_once(recorded(self.model._formula(f, self.free)), known.texts)
            except (TypeError, ModelError):
                return None

        return current(known.functions, (f, *self._fixed), (f, *self._laws), recording)

    @cached_property
    def exact_on_floats(self) -> Callable[..., Floats] | None:
        """The exact solution on floats, ``(t, *states, *p)``; None if not traceable."""
        text = self._text(self.model.exact)
        return text and text.on_floats

    @cached_property
    def solution(self) -> Callable[[float, Floats], Floats]:
        """The exact solution as a function of ``(t, states)`` on floats, which returns a tuple.

        Where the traced text has no value, as for an orbit that is not an ellipse, the formula
        itself is called; :class:`ModelError` if it has no value either.
        """
        assert self.model.exact is not None
        p, untraced = self.p, self.untraced(self.model.exact)
        run = self.exact_on_floats or (lambda *_: (math.nan,))

        def at(t, x):
            try:
                found = run(t, *x, *p)
                # one test for all values
                if math.isfinite(sum(found)):
                    return found
            except (ArithmeticError, ValueError):
                pass  # the formula itself may have a value
            why = ""
            try:
                found = tuple(map(float, untraced(t, *x)))
                if math.isfinite(sum(found)):
                    return found
            except ArithmeticError as error:
                why = f": {error}"
            raise ModelError(
                f"the exact solution of {self.model.name!r} has no value at t = {t:.6g} after {x}"
                + why
            )

        return at

    def solutions(self, times: "np.ndarray", x: Floats) -> "np.ndarray":
        """The exact solution at an array of times, an array (states, times)."""
        exact = self.model.exact
        assert exact is not None
        for run in (self.function(exact), self.untraced(exact)):
            found = rows_of(run(times, *x), len(times))
            if np.isfinite(found).all():
                break
        return found


def _snapshot(model, rhs, texts):
    """The :class:`PreparedModel` that was pickled."""
    system = PreparedModel(model)
    system._take(shared(rhs))
    for n, text in texts:
        now = text and text_once(text, system.traced.texts)
        system._now[id(system._functions[n])] = now
    return system


def _parameter(model, name, x):
    if (type(x) is float and -math.inf < x < math.inf) or getattr(x, "shape", ()):
        return x  # before the messages are written: the text of an array takes milliseconds
    what = f"the parameter {name} of {model.name!r}"
    return finite_number(
        x, f"{what} is", f"{what} has no number: {clipped(x)}; put one in with changed({name}=...)"
    )
