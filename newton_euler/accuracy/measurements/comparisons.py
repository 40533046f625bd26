"""Comparisons of methods where nothing is integrated, by :mod:`.baselines`."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from timeit import Timer
from typing import Any

from ...algebra.errors import ArgumentError
from ...algebra.scalars import sqrt
from . import baselines
from .measure import Measured, Progress, of_repeats, silent, timings


@dataclass(frozen=True, eq=False)
class Question:
    """What is computed, by which methods, over which settings.

    across : the letter of the setting and its words with the unit, as ("h", "step h, s")
    methods : from the name of a method to a function of the setting
    error : a function of the result of a method and of the setting
    worst_only : the setting belongs to the question (an angle), not the method (a step): only the
        worst error of each method is charted against its cost
    timed_each : the setting changes the cost, so the time is taken at each, not only at the first
    """

    what: str
    across: tuple
    settings: tuple
    methods: Mapping
    error: Callable
    worst_only: bool = False
    timed_each: bool = False

    def measured(self, settings: Sequence[float]) -> "Iterator[ComparisonPoint]":
        """The points, one after the other, setting by setting."""
        for n, x in enumerate(settings):
            if n == 0 or self.timed_each:
                calls = [partial(method, x) for method in self.methods.values()]
                costs = timings(calls)
            for (name, method), repeats in zip(self.methods.items(), costs, strict=True):
                error, setting = float(self.error(method(x), x)), f"{self.across[0]} = {x:.3g}"
                point = ComparisonPoint(name, 0.0, error, setting, question=self, x=x)
                yield replace(point, **of_repeats(repeats))


@dataclass(frozen=True)
class ComparisonPoint(Measured):
    """A point with the ``question`` that it answers, and the setting as a number ``x``."""

    question: Question | None = field(default=None, repr=False)
    x: float = 0.0


@dataclass(frozen=True)
class Comparison:
    """A comparison of methods; ``fails``: it shows that one breaks down, not which is cheapest."""

    name: str
    title: str
    questions: tuple
    fails: bool = False

    def measure(self, progress: Progress = silent, quick: bool = False) -> list[ComparisonPoint]:
        """The answers to all questions, a list of :class:`ComparisonPoint`, in a few seconds;
        ``quick``: without the last setting, which takes longest where it changes the cost.
        """
        asked = [(q, q.settings[: -1 if quick else None]) for q in self.questions]
        count, points = sum(len(settings) * len(q.methods) for q, settings in asked), []
        for q, settings in asked:
            for point in q.measured(settings):
                points.append(point)
                progress(len(points) / count, f"{point.method}, {point.setting}")
        return points


def measured_ways(ways: Mapping[str, Callable[[], Any]], exact: Any) -> list[Measured]:
    """The times of several ways, {name: function}, and distances from the ``exact`` result."""
    prepared = {name: Timer(way).timeit(1) for name, way in ways.items()}
    costs = map(of_repeats, timings(list(ways.values())))
    return [
        Measured(name, error=_distance(way(), exact), prepared=prepared[name] - c["cost"], **c)
        for (name, way), c in zip(ways.items(), costs, strict=True)
    ]


def _distance(result, exact):
    values, exact = _numbers(result), _numbers(exact)
    if len(values) != len(exact):
        raise ArgumentError(f"a way returns {len(values)} numbers, exact has {len(exact)}")
    apart = sqrt(sum((a - b) ** 2 for a, b in zip(values, exact, strict=True)))
    size = sqrt(sum(b**2 for b in exact))
    return float(apart / size if size else apart)


def _numbers(x):
    return tuple(x) if hasattr(x, "__iter__") else (x,)


def _decades(first, last):
    """The powers of ten between these exponents, from the largest to the smallest."""
    return tuple(10.0**n for n in range(last, first - 1, -1))


_STEPS = ("h", "step h, s"), _decades(-14, -1)
_TURNS = ("n", "number of turns n (cost: of 100)"), (100, 300, 1000, 3000, 10000), baselines.TURNS
_ANGLES = _decades(-12, 0)
_worst = partial(Question, worst_only=True)

_COMPARISONS = (
    # Differences truncate at long steps and cancel at short ones; a complex step cancels in second
    # derivatives only; jets have no step.
    Comparison(
        "derivatives",
        "Velocity and acceleration of the end of a boom, from its position as a function of time",
        (
            Question(f"velocity at t = {baselines.INSTANT} s", *_STEPS,
                     *baselines.VELOCITIES),
            Question(f"acceleration at t = {baselines.INSTANT} s", *_STEPS,
                     *baselines.ACCELERATIONS),
        ),
    ),
    # A product of many matrices drifts away from a rotation; the rates of Euler's angles are
    # unbounded where the axis passes the vertical.
    Comparison(
        "rotations", "Turns by matrices, Euler angles and quaternions",
        (
            _worst("attitude after n turns of 0.01 rad", *_TURNS, baselines.turn_error),
            _worst("distance from any rotation, after the same", *_TURNS, baselines.drift),
            _worst("attitude after 200 Runge-Kutta steps of 0.01 rad",
                   ("theta", "least angle to the vertical, rad"), _decades(-6, 0),
                   *baselines.PASSES),
        ),
        fails=True,
    ),
    # One more digit takes 100 times as many points at random and 20 times in a grid, whose cells do
    # not follow the edge.
    Comparison(
        "inertia",
        "Moments of inertia of a sheet, a triangle with a half disk on its base, about the apex",
        (
            Question("I_xx, I_yy, I_zz", ("N", "number of points N"),
                     tuple(10**n for n in range(2, 7)),
                     *baselines.INERTIAS, timed_each=True),
        ),
    ),
    # The arc cosine of the trace loses half of the digits at 0 and at pi; the quaternion with atan2
    # loses none.
    Comparison(
        "angle", "The angle of a rotation matrix",
        (
            _worst("a small angle", ("angle", "angle, rad"), _ANGLES,
                   *baselines.ANGLES),
            _worst("an angle near pi", ("pi - angle", "pi - angle, rad"), _ANGLES,
                   *baselines.ANGLES_NEAR_PI),
        ),
        fails=True,
    ),
    # The printed root is a difference of nearly equal numbers as (I0 - I) cos(theta) goes to zero.
    Comparison(
        "steady precession",
        "Both rates of steady precession, where the quadratic (10.33) becomes linear",
        (
            _worst("psi', slow and fast", ("a", "(I0 - I) cos(theta), kg m^2"),
                   tuple(0.01 * x for x in _decades(-14, 0)),
                   *baselines.PRECESSIONS),
        ),
        fails=True,
    ),
)  # fmt: skip
COMPARISONS = {comparison.name: comparison for comparison in _COMPARISONS}
