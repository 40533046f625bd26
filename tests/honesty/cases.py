"""A case: one motion of a random model, with the data its reference needs."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from random import Random
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np

import newton_euler
from newton_euler import Model
from newton_euler.motion import second_order

FRACTIONS = (0.13, 0.37, 0.71, 1.0)  # of the duration, at which states are compared, the end last
DRAWS = 3  # cases per family and seed
FAMILIES = {}  # by name, filled by the decorator below
HOLDOUT = {}  # held-out families: nobody repairs the engine to suit them


@dataclass(frozen=True)
class Case:
    """A model, its start and its time, as they go into ``integrate``.

    model, t_end, start, t0 : arrays among the parameters or in the start are many motions at once
    name, tags : family/seed/draw, and the subject with what else is special; both are filled in by
        :func:`draw`
    knots : times at which the reference stops to look, where something short happens that long
        steps would pass over; those outside of the motion do not count
    exact : a function ``(mp, s, p, t)`` on mpmath numbers, the states at the time t of the clock,
        which shows t0 at the start, or None; hidden from the engine
    singular_at : the time at which the motion ceases to exist, or None; beyond it the only right
        answer is a refusal
    events : of the engine, whose ``then`` the reference follows as well; ``event_times(mp, s, p)``
        lists the times of a single event where a formula gives them
    written_out : the same model for the reference, where ``model`` is written in a way that the
        reference cannot use: with laws among its parameters, or with powers of zero
    """

    model: object
    t_end: float
    start: tuple
    t0: float = 0.0
    name: str = ""
    tags: tuple = ()
    knots: tuple = ()
    exact: Callable | None = None
    singular_at: float | None = None
    events: tuple = ()
    event_times: Callable | None = field(default=None, repr=False)
    written_out: object = field(default=None, repr=False)

    @property
    def span(self):
        """The time in the form that ``integrate`` takes."""
        return (self.t0, self.t_end) if self.t0 else self.t_end

    @property
    def singular(self):
        """True if no answer exists at the end."""
        return self.singular_at is not None and self.singular_at <= self.t_end

    @property
    def times(self):
        """The times at which states are compared, the end last."""
        return tuple(self.t0 + f * (self.t_end - self.t0) for f in FRACTIONS[:-1]) + (self.t_end,)

    @property
    def count(self):
        """The number of motions."""
        numbers = (*self.start, *self.model.parameters.values())
        return max([1, *(len(x) for x in numbers if getattr(x, "shape", ()))])

    def member(self, k):
        """One of many motions, as a separate case."""
        if self.count == 1:
            return self

        one = lambda x: float(x[k]) if getattr(x, "shape", ()) else x
        parameters = {n: one(x) for n, x in self.model.parameters.items()}
        model, start = replace(self.model, parameters=parameters), tuple(map(one, self.start))
        return replace(self, model=model, start=start, name=f"{self.name}[{k}]")

    def explain(self):
        """The call that reproduces the case, with its numbers."""
        parameters = ", ".join(f"{n}={x!r}" for n, x in self.model.parameters.items())
        of = f"{self.name} with {parameters or 'no parameters'}"
        return f"{of}; t = {self.span!r}; start {self.start!r}"


def by_rates(rates, parameters, states, t_end, start, brings=False, **known):
    """The :class:`Case` of these rates of the states, "x v"; their family names the model.

    brings : True if ``exact`` is a function ``(m, s, p, t)`` of functions of any module m, which
        the model supplies as its own solution as well
    known : what else a Case knows
    """
    return _case(Model, rates, parameters, states, t_end, start, brings, known)


def by_accelerations(accelerations, parameters, coordinates, t_end, start, brings=False, **known):
    """The same by the accelerations of the coordinates "x y", whose rates are dx and dy."""
    return _case(second_order, accelerations, parameters, coordinates, t_end, start, brings, known)


def _case(made, f, parameters, states, t_end, start, brings, known):
    of_family = f.__qualname__.partition(".")[0].strip("_").replace("_", " ")
    own = (lambda s, p, t: known["exact"](newton_euler, s, p, t)) if brings else None
    model = made(of_family, parameters, tuple(states.split()), f, exact=own)
    knots = tuple(known.pop("knots", ()))
    return Case(model, t_end, tuple(start), knots=knots, **known)


def family(subject, *tags, among=FAMILIES):
    """Puts a function ``f(rng)`` that returns a :class:`Case` into :data:`FAMILIES`."""

    def add(f):
        f.tags = (subject, *tags)
        known = {**FAMILIES, **HOLDOUT}.get(f.__name__) or among.setdefault(f.__name__, f)
        # pytest imports a file once more to look for doctests
        if known.__code__.co_filename != f.__code__.co_filename:
            raise ValueError(f"two families have the name {f.__name__!r}")
        return f

    return add


def held_out(subject, *tags):
    """The same for :data:`HOLDOUT`."""
    return family(subject, *tags, among=HOLDOUT)


def draw(name, seed, number):
    """One case of a family, known or held out: always the same one for the same seed and number.

    >>> from tests.honesty import cases, families  # importing families fills the list
    >>> draw = cases.draw
    >>> draw("pendulum", 0, 1).start == draw("pendulum", 0, 1).start != draw("pendulum", 0, 2).start
    True
    """
    made, case = FAMILIES.get(name) or HOLDOUT[name], f"{name}/{seed}/{number}"
    return replace(made(Draws(case)), name=case, tags=made.tags)


class Log(NamedTuple):
    """A range from which a number is drawn log-uniformly."""

    low: float
    high: float


class Draws(Random):
    """Random numbers from ranges: a pair (low, high) is even, ``Log(low, high)`` logarithmic, and a
    number stands for itself.

    >>> Draws(0).parameters(g=9.81, k=(1.0, 2.0))
    {'g': 9.81, 'k': 1.8444218515250481}
    """

    def decades(self, low, high):
        """A log-uniform random number."""
        return math.exp(self.uniform(math.log(low), math.log(high)))

    def either(self, x):
        """x or -x."""
        return self.choice((-x, x))

    def values(self, *ranges):
        """A number from each range, in order."""
        return tuple(
            self.decades(*r) if isinstance(r, Log) else self.uniform(*r) if type(r) is tuple else r
            for r in ranges
        )

    def array(self, n, within):
        """An array of n numbers from one range."""
        return np.array(self.values(*[within] * n))

    def parameters(self, **ranges):
        """A number from each range, by name."""
        return dict(zip(ranges, self.values(*ranges.values()), strict=True))


def around(t, width, count):
    """Times at distances of ``width`` about ``t``, and far from it: a narrow feature may have long
    tails, which a series that starts still farther away would miss.
    """
    steps = [*range(count + 1), *(count * far for far in (2, 4, 8))]
    return tuple(t + width * k for k in sorted({*steps, *(-k for k in steps)}))


def names(keys, values):
    """Values by name, in the form that the functions of a model take."""
    return SimpleNamespace(**dict(zip(keys, values, strict=True)))
