"""Speed charted against accuracy where nothing is integrated: derivatives, rotations, inertia, angles, steady precession.

Each comparison asks one question of several ways to its answer, over a range of what can be set, and draws the error against what was set and
against what it cost. The naive ways are those of textbooks; :mod:`newton_euler.accuracy.rivals` holds them. References have 40 digits, by mpmath.
``python -m newton_euler.accuracy NAME`` draws one.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from . import rivals
from .measure import COLOURS, MARKERS, Measured, chart, timed

ROUND_OFF = 2.0**-52  # smaller errors are luck, and are drawn there
TITLES = {"fontsize": 10, "loc": "left"}


@dataclass(frozen=True)
class Tried(Measured):
    """A point that also says which ``question`` it answers, and the number ``x`` that was set."""

    question: str = ""
    x: float = 0.0


@dataclass(frozen=True)
class Question:
    """What is asked, of whom, and over what.

    what : in words
    across : the letter and the words, with the unit, for what is set, as ("h", "step h, s")
    settings : the numbers set
    ways : from the name of a method to a function of the number set
    error : a function of what a way found and of the number set
    posed : the number belongs to the question (an angle), not to the answer (a step): then the worst answers are charted against their cost
    laborious : the number set changes the cost, so that each is timed; otherwise the first one stands for all
    """

    what: str
    across: tuple
    settings: tuple
    ways: Mapping
    error: Callable
    posed: bool = False
    laborious: bool = False

    def measured(self):
        """One point after the other, from the first number set to the last, all ways in turns."""
        for n, x in enumerate(self.settings):
            if n == 0 or self.laborious:
                costs = timed(*(lambda way=way: way(x) for way in self.ways.values()), runs=3, shortest=1e-3)  # noqa: B023 (called at once)
            for (method, way), cost in zip(self.ways.items(), costs, strict=True):
                setting = f"{self.across[0]} = {x:.3g}"
                yield Tried(method, cost, float(self.error(way(x), x)), setting, question=self.what, x=x)


@dataclass(frozen=True)
class Comparison:
    """A chart of speed against accuracy: ``name``, ``title``, what it shows in ``words``, and its ``questions``."""

    name: str
    title: str
    words: str
    questions: tuple

    def measure(self, progress=None):
        """Ask all questions of all ways: a list of :class:`~newton_euler.accuracy.Measured`, in a few seconds.

        progress : a function ``(fraction, words)``, called for each point
        """
        count = sum(len(q.settings) * len(q.ways) for q in self.questions)
        points = []
        for point in (p for q in self.questions for p in q.measured()):
            points.append(point)
            if progress:
                progress(len(points) / count, f"{point.method}, {point.setting}")
        return points

    def draw(self, points, figure):
        """A row for each question: its errors against what was set, and against what they cost. Returns the fronts, as one list."""
        from matplotlib.ticker import LogLocator, NullFormatter

        figure.set_layout_engine("constrained")
        figure.set_size_inches(11.5, 0.6 + 3.6 * len(self.questions))
        figure.suptitle(self.title)
        best = []
        for question, (left, right) in zip(self.questions, figure.subplots(len(self.questions), 2, squeeze=False), strict=True):
            own = [replace(p, error=max(p.error, ROUND_OFF)) for p in points if p.question == question.what]
            _draw_across(question, own, left)
            best += chart(_worst(own) if question.posed else own, right)
            right.set_title("the worst of each, against its cost" if question.posed else "against the cost", **TITLES)
            right.set(ylabel="", xlim=_roomy([p.cost for p in own]))
            right.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if max(right.get_xlim()) < 40 * min(right.get_xlim()) else (1,)))
            right.xaxis.set_minor_formatter(NullFormatter())
        return best


def _worst(points):
    """The point of largest error of each method."""
    return [max((p for p in points if p.method == method), key=lambda p: p.error) for method in dict.fromkeys(p.method for p in points)]


def _roomy(costs):
    return min(costs) / 2, max(costs) * 2


def _draw_across(question, points, ax):
    for n, method in enumerate(question.ways):
        own = [p for p in points if p.method == method]
        size = 9 - 1.3 * n  # those drawn first show behind others
        ax.plot([p.x for p in own], [p.error for p in own], marker=MARKERS[n], color=COLOURS[n], ms=size, lw=1)
    ax.set(xscale="log", yscale="log", xlabel=question.across[1], ylabel="relative error")
    ax.set_title(question.what, **TITLES)
    ax.grid(True, color="#dddddd", lw=0.6)
    ax.set_axisbelow(True)


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
            "Velocity and acceleration of the end of a boom, from its position as a function of time",
            "Differences truncate where the step is long and cancel where it is short: of 16 digits the best central first difference keeps 10, the "
            "best second one 7. The complex step does not cancel in a first derivative, but does in a second. The engine's numbers carry their rates "
            "along: there is no step and nothing is lost, and traced they cost less than a difference.",
            (
                Question(f"velocity at t = {rivals.INSTANT} s", *STEPS, rivals.FIRST_DERIVATIVES, rivals.velocity_error),
                Question(f"acceleration at t = {rivals.INSTANT} s", *STEPS, rivals.SECOND_DERIVATIVES, rivals.acceleration_error),
            ),
        ),
        Comparison(
            "rotations",
            "Turns by matrices, Euler angles and quaternions",
            "A product of many matrices drifts away from a rotation, and its attitude with it; a quaternion is a rotation again once its length "
            "is divided out. The rates of Euler's angles grow without bound where the body's axis passes the vertical, and an error as large "
            "as a step is left behind; the rate of a quaternion knows no such place.",
            (
                Question("attitude after n turns of 0.01 rad", *TURNS, rivals.turn_error, posed=True),
                Question("distance from any rotation, after the same", *TURNS, rivals.drift, posed=True),
                Question("attitude after 200 Runge-Kutta steps of 0.01 rad", *LEAST_ANGLES, rivals.PASSES, rivals.pass_error, posed=True),
            ),
        ),
        Comparison(
            "inertia",
            "Moments of inertia of a sheet, a triangle with a half disk on its base, about the apex",
            "For one more digit a hundred times as many points are needed at random, and twenty times in a grid, whose cells do not follow the edge. "
            "Quadrature in coordinates that do is right to round-off, and so is the sum of closed forms, at a fraction of the cost.",
            (Question("I_xx, I_yy, I_zz", *POINTS, rivals.INERTIAS, rivals.inertia_error, laborious=True),),
        ),
        Comparison(
            "angle",
            "The angle of a rotation matrix",
            "The arc cosine of the trace loses half of the digits at 0 and at pi: it sees no angle below 1e-8 rad. By way of the quaternion and "
            "atan2, as the engine and SciPy go, none is lost.",
            (
                Question("a small angle", *SMALL_ANGLES, rivals.ANGLES, rivals.small_angle_error, posed=True),
                Question("an angle near pi", *ANGLES_NEAR_PI, rivals.ANGLES_NEAR_PI, rivals.angle_near_pi_error, posed=True),
            ),
        ),
        Comparison(
            "steady precession",
            "Both rates of steady precession, where the quadratic (10.33) becomes linear",
            "The printed root is a difference of nearly equal numbers as (I0 - I) cos(theta) goes to zero, and has hardly a digit left at 1e-16. "
            "Taken from the sum of equal signs and from the product of the roots, both rates are right to round-off; so are the eigenvalues of "
            "a balanced companion matrix, by which NumPy finds roots, for more time.",
            (Question("psi', slow and fast", *COEFFICIENTS, rivals.PRECESSIONS, rivals.precession_error, posed=True),),
        ),
    )
}
