"""Charts of speed against accuracy where nothing is integrated: derivatives, rotations, inertia,
angles, steady precession.

A comparison asks one or more questions; each is answered in several ways over a range of settings,
and the error is drawn against the setting and against the cost. The ways of textbooks and their
errors, against references of 40 digits, are in :mod:`newton_euler.accuracy.baselines`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial

from . import baselines as rivals
from .measure import COLOURS, MARKERS, Measured, chart, log_log, timed

ROUND_OFF = 2.0**-52  # smaller errors are luck, and are drawn there
TITLES = {"fontsize": 10, "loc": "left"}


@dataclass(frozen=True)
class ComparisonPoint(Measured):
    """A point that also says which ``question`` it answers, and the setting as a number ``x``."""

    question: str = ""
    x: float = 0.0


@dataclass(frozen=True)
class Question:
    """What is computed, how, and over which settings.

    what : in words
    across : the letter of the setting and its words with the unit, as ("h", "step h, s")
    settings : numbers
    ways : from the name of a way to a function of the setting
    error : a function of what a way found and of the setting
    worst_only : the setting belongs to the question (an angle), not to the way (a step): only the
        worst error of each way is charted against its cost
    timed_each : the setting changes the cost, so that the time is taken at each one, not only at
        the first
    """

    what: str
    across: tuple
    settings: tuple
    ways: Mapping
    error: Callable
    worst_only: bool = False
    timed_each: bool = False

    def measured(self):
        """The points, one after the other, setting by setting."""
        for n, x in enumerate(self.settings):
            if n == 0 or self.timed_each:
                calls = [partial(way, x) for way in self.ways.values()]
                costs = timed(*calls, runs=3, shortest=1e-3)
            for (method, way), cost in zip(self.ways.items(), costs, strict=True):
                yield ComparisonPoint(
                    method,
                    cost,
                    float(self.error(way(x), x)),
                    f"{self.across[0]} = {x:.3g}",
                    question=self.what,
                    x=x,
                )

    def draw(self, points, left, right):
        """The front of the points, after drawing their errors against the setting (``left``) and
        against the cost (``right``).
        """
        from matplotlib.ticker import LogLocator

        points = [replace(p, error=max(p.error, ROUND_OFF)) for p in points]
        by_way = [[p for p in points if p.method == way] for way in self.ways]
        log_log(left, self.across[1], "relative error")
        left.set_title(self.what, **TITLES)
        for n, own in enumerate(by_way):  # those drawn first are larger, to be seen behind others
            left.plot(
                [p.x for p in own],
                [p.error for p in own],
                marker=MARKERS[n],
                color=COLOURS[n],
                ms=9 - 1.3 * n,
                lw=1,
            )
        best = chart(
            [max(own, key=lambda p: p.error) for own in by_way] if self.worst_only else points,
            right,
        )
        costs = [p.cost for p in points]
        right.set(ylabel="", xlim=(min(costs) / 2, 2 * max(costs)))
        right.set_title(
            "the worst of each, against its cost" if self.worst_only else "against the cost",
            **TITLES,
        )
        right.xaxis.set_major_locator(
            LogLocator(subs=(1, 2, 5) if max(costs) < 10 * min(costs) else (1,))
        )
        return best


@dataclass(frozen=True)
class Comparison:
    """A chart of speed against accuracy: ``name``, ``title`` and ``questions``."""

    name: str
    title: str
    questions: tuple

    def measure(self, progress=lambda fraction, words: None):
        """All answers to all questions: a list of :class:`~newton_euler.accuracy.Measured`, in a
        few seconds.

        progress : is called for each point
        """
        count, points = sum(len(q.settings) * len(q.ways) for q in self.questions), []
        for point in (p for q in self.questions for p in q.measured()):
            points.append(point)
            progress(len(points) / count, f"{point.method}, {point.setting}")
        return points

    def draw(self, points, figure):
        """The fronts of all questions as one list, after drawing two charts in a row for each
        question.
        """
        rows = len(self.questions)
        figure.set(layout_engine="constrained", size_inches=(11.5, 0.6 + 3.6 * rows))
        figure.suptitle(self.title)
        pairs = zip(self.questions, figure.subplots(rows, 2, squeeze=False), strict=True)
        return [
            best
            for q, axes in pairs
            for best in q.draw([p for p in points if p.question == q.what], *axes)
        ]


def _decades(first, last):
    return tuple(10.0**n for n in range(first, last + 1))


STEPS = ("h", "step h, s"), _decades(-14, -1)[::-1]
TURNS = ("n", "number of turns n (cost: of 100)"), (100, 300, 1000, 3000, 10000), rivals.TURNS
LEAST_ANGLES = ("theta", "least angle to the vertical, rad"), _decades(-6, 0)[::-1]
POINTS = ("N", "number of points N"), tuple(10**n for n in range(2, 7))
SMALL_ANGLES = ("angle", "angle, rad"), _decades(-12, 0)[::-1]
ANGLES_NEAR_PI = ("pi - angle", "pi - angle, rad"), SMALL_ANGLES[1]
COEFFICIENTS = ("a", "(I0 - I) cos(theta), kg m^2"), tuple(0.01 * x for x in _decades(-14, 0)[::-1])

COMPARISONS = {
    c.name: c
    for c in (
        Comparison(
            "derivatives",
            "Velocity and acceleration of the end of a boom, from its position as a "
            "function of time",
            # Differences truncate at long steps and cancel at short ones; a complex step cancels in
            # second derivatives only; jets have no step.
            (
                Question(
                    f"velocity at t = {rivals.INSTANT} s",
                    *STEPS,
                    rivals.FIRST_DERIVATIVES,
                    rivals.velocity_error,
                ),
                Question(
                    f"acceleration at t = {rivals.INSTANT} s",
                    *STEPS,
                    rivals.SECOND_DERIVATIVES,
                    rivals.acceleration_error,
                ),
            ),
        ),
        Comparison(
            "rotations",
            "Turns by matrices, Euler angles and quaternions",
            # A product of many matrices drifts away from a rotation; the rates of Euler's angles
            # are unbounded where the axis passes the vertical.
            (
                Question(
                    "attitude after n turns of 0.01 rad", *TURNS, rivals.turn_error, worst_only=True
                ),
                Question(
                    "distance from any rotation, after the same",
                    *TURNS,
                    rivals.drift,
                    worst_only=True,
                ),
                Question(
                    "attitude after 200 Runge-Kutta steps of 0.01 rad",
                    *LEAST_ANGLES,
                    rivals.PASSES,
                    rivals.pass_error,
                    worst_only=True,
                ),
            ),
        ),
        Comparison(
            "inertia",
            "Moments of inertia of a sheet, a triangle with a half disk on its base, about "
            "the apex",
            # One more digit takes 100 times as many points at random and 20 times in a grid, whose
            # cells do not follow the edge.
            (
                Question(
                    "I_xx, I_yy, I_zz",
                    *POINTS,
                    rivals.INERTIAS,
                    rivals.inertia_error,
                    timed_each=True,
                ),
            ),
        ),
        Comparison(
            "angle",
            "The angle of a rotation matrix",
            # The arc cosine of the trace loses half of the digits at 0 and at pi; the quaternion
            # with atan2 loses none.
            (
                Question(
                    "a small angle",
                    *SMALL_ANGLES,
                    rivals.ANGLES,
                    rivals.small_angle_error,
                    worst_only=True,
                ),
                Question(
                    "an angle near pi",
                    *ANGLES_NEAR_PI,
                    rivals.ANGLES_NEAR_PI,
                    rivals.angle_near_pi_error,
                    worst_only=True,
                ),
            ),
        ),
        Comparison(
            "steady precession",
            "Both rates of steady precession, where the quadratic (10.33) becomes linear",
            # The printed root is a difference of nearly equal numbers as (I0 - I) cos(theta) goes
            # to zero.
            (
                Question(
                    "psi', slow and fast",
                    *COEFFICIENTS,
                    rivals.PRECESSIONS,
                    rivals.precession_error,
                    worst_only=True,
                ),
            ),
        ),
    )
}
