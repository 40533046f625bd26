"""Maps of parameter space, coloured by the method or the model that holds there, with the thresholds that theory knows drawn over them.

Each is measured when it is drawn: ``MAPS[name].measure()`` returns the choices, ``draw_map(name, ax)`` draws them.

>>> found = MAPS["steady precession"].measure((2, 2))  # at 15 and 45 rad/s, at 45 and 135 degrees from the vertical
>>> found[0].tolist()
['none: it nods', 'slow and fast, of one sense']
>>> found[1, 0]
'slow and fast, of opposite sense'
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

from ..earth import EARTH_RADIUS, EARTH_RATE
from ..gyros import GyroError, least_spin, sleeping_top, steady_precession
from ..motion import Event, integrate
from ..scenes import projectile, top, top_ladder
from ..scenes.free_body import _rates, free_body
from ..taylor import installed
from . import COLOURS


@dataclass(frozen=True)
class Axis:
    """An axis of a map: what it is, with its unit, from ``low`` to ``high``, by powers of ten if ``log``."""

    label: str
    low: float
    high: float
    log: bool = True

    def edges(self, count):
        """The limits of so many cells, an array."""
        import numpy as np

        return np.geomspace(self.low, self.high, count + 1) if self.log else np.linspace(self.low, self.high, count + 1)

    def centres(self, count):
        """Their middles."""
        edges = self.edges(count)
        return (edges[1:] * edges[:-1]) ** 0.5 if self.log else (edges[1:] + edges[:-1]) / 2


@dataclass(frozen=True)
class Curve:
    """What theory says of a border: ``label``, and y as a function of an array of x (nan where there is none); or x where it is upright."""

    label: str
    y: Callable | None = None
    x: float | None = None


@dataclass(frozen=True)
class Map:
    """A map.

    name, title, words : what it shows; the words are for a caption
    x, y : each an :class:`Axis`
    choices : all that may hold somewhere, in the order of the legend
    column : a function of one x and an array of y, which grow, that returns the choice at each
    curves : the borders known in theory
    resolution : cells along x and y that take a few seconds
    """

    name: str
    title: str
    words: str
    x: Axis
    y: Axis
    choices: tuple
    column: Callable
    curves: tuple = ()
    resolution: tuple = (36, 30)

    def measure(self, resolution=None, progress=None):
        """The choices, an array of strings: a row for each y from the lowest, a column for each x.

        resolution : cells along x and y; ``progress`` : a function of the fraction done
        """
        import numpy as np

        across, up = resolution or self.resolution
        columns = []
        for n, x in enumerate(self.x.centres(across).tolist()):
            if progress:
                progress(n / across)
            columns.append(list(self.column(x, self.y.centres(up).tolist())))
        return np.array(columns, dtype=object).T


def draw_map(name, ax, resolution=None, progress=None):
    """Measure the map of this name and draw it on ``ax``, with a legend of colours and of the curves of theory. Returns the choices."""
    import numpy as np
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    chart = MAPS[name]
    found = chart.measure(resolution, progress)
    numbers = np.vectorize(chart.choices.index)(found)
    colours = COLOURS[: len(chart.choices)]
    edges = chart.x.edges(found.shape[1]), chart.y.edges(found.shape[0])
    ax.pcolormesh(*edges, numbers, cmap=ListedColormap(colours), vmin=-0.5, vmax=len(colours) - 0.5, alpha=0.75, linewidth=0, rasterized=True)
    handles = [Patch(color=c, alpha=0.75, label=choice) for c, choice in zip(colours, chart.choices, strict=True) if (found == choice).any()]
    for curve, style in zip(chart.curves, ("-", "--", ":"), strict=False):
        handles.append(_drawn(curve, chart, ax, style))
    ax.set(xlabel=chart.x.label, ylabel=chart.y.label, title=chart.title, xscale="log" if chart.x.log else "linear", xlim=edges[0][[0, -1]])
    ax.set(yscale="log" if chart.y.log else "linear", ylim=edges[1][[0, -1]])
    ax.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.01, 1.0), frameon=False, fontsize=9)
    return found


def _drawn(curve, chart, ax, style):
    looks = {"color": "black", "lw": 1.8, "ls": style, "label": curve.label}
    if curve.y is None:
        return ax.axvline(curve.x, **looks)
    x = chart.x.centres(800)
    return ax.plot(x, curve.y(x), **looks)[0]


# -- methods: the free body


BODY, GROWTH = free_body(1.0, 2.0, 3.0), 1 / math.sqrt(3)  # of a tilt from the intermediate axis, 1/s at 1 rad/s
WANTED = 1e-9  # of the rates at any time, relative to 1 rad/s
DENSE = 100  # instants in a cell at which errors are looked for
STEPWISE, SERIES = "dop853, nothing to compile", "taylor, compilation counted"
CLOSED, DIGITS = "only the exact solution", "only the exact solution in 30 digits"


def tilted(tilt):
    """A spin of 1 rad/s almost about the intermediate axis of :data:`BODY`."""
    return math.sin(tilt) / math.sqrt(2), math.cos(tilt), math.sin(tilt) / math.sqrt(2)


@cache
def compiling():
    """The seconds that heyoka takes to compile a right-hand side of this kind; infinite where it is not installed."""
    integrate(BODY, 1.0, tilted(0.1), 1e-9, "dop853")  # tracing does not count, for any
    if not installed():
        return math.inf
    integrate(BODY, 1.0, tilted(0.1), 1e-9, "taylor")  # imports do not count
    fresh = replace(BODY, rhs=lambda s, p, t: _rates(s, p, t))  # a function of its own, which is not compiled yet
    return integrate(fresh, 1.0, tilted(0.1), 1e-9, "taylor").cost.seconds


def errors_until(times, motion, start):
    """The largest error of a motion until each of the times, by the exact solution."""
    import numpy as np

    exact = BODY.solution(motion.times, start)
    worst = np.maximum.accumulate(np.max([abs(x - w) for x, w in zip(exact, motion.states.values(), strict=True)], axis=0))
    return worst[np.searchsorted(motion.times, times, side="right") - 1]


def _by_series(times, start):
    """For each of the times the seconds that a Taylor series to round-off takes; infinite where it is not right to :data:`WANTED`."""
    import numpy as np

    if not installed():
        return [math.inf] * len(times)
    instants = np.union1d(times, np.geomspace(times[0], times[-1], DENSE * len(times)))
    motion = integrate(BODY, times[-1], start, 1e-15, "taylor", samples=instants)
    right = errors_until(times, motion, start) <= WANTED
    return [compiling() + motion.cost.seconds * t / times[-1] if fine else math.inf for t, fine in zip(times, right.tolist(), strict=True)]


def _stepwise(t, start, rtol):
    """The seconds that DOP853 takes; infinite where it is not right to :data:`WANTED`."""
    motion = integrate(BODY, t, start, rtol, "dop853", samples=DENSE)
    return motion.cost.seconds if errors_until([t], motion, start)[0] <= WANTED else math.inf


def _closed(t, start):
    """True where the exact solution in floats is right to :data:`WANTED`, by that in 30 digits."""
    import mpmath

    with mpmath.workdps(30):
        exact = BODY.solution(mpmath.mpf(t), start)
    return max(abs(a - b) for a, b in zip(BODY.solution(t, start), exact, strict=True)) <= WANTED


def _free_body(tilt, times):
    start, rate, longest = tilted(tilt), 0.0, 2 * compiling()
    for t, series in zip(times, _by_series(times, start), strict=True):
        stepwise = math.inf
        if rate * t < 3 * min(series, longest):  # a second of motion takes no less than before
            tried = (_stepwise(t, start, rtol) for rtol in (1e-10, 1e-12))
            stepwise = next((seconds for seconds in tried if seconds < math.inf), math.inf)
            rate = stepwise / t
        if min(series, stepwise) < math.inf:
            yield STEPWISE if stepwise < series else SERIES
        else:
            yield CLOSED if _closed(t, start) else DIGITS


def _first_turn(tilt):
    """A small tilt a, halved between growing and decaying, reaches a right angle after the quarter period ln(4 sqrt(2)/a)/GROWTH."""
    import numpy as np

    return np.log(4 * math.sqrt(2) / tilt) / GROWTH


def _rounded_off(tilt):
    """Until when an integration is right to WANTED even where the motion is fastest.

    A rounding e of the energy changes the period by 4 e/(GROWTH a^2), a walk of n periods the time of a turnover by n^(3/2) such.
    """
    periods = (WANTED * tilt**2 / (4 * 2.0**-53)) ** (2 / 3)
    return _first_turn(tilt) * (2 + 4 * periods)  # the first turnover is not yet affected


# -- models: the projectile, and the top

G, LATITUDE = 9.82, math.radians(45)
I0, I, MGR, THETA = 0.02, 0.01, 0.5, 0.6
LASTING, ASYMMETRY = 5.0, 1e-3  # s; of the transverse moments
LEAST = least_spin(I0, I, THETA, mgr=MGR, of="omega_z")  # for steady precession


def _holding(ladder, tolerances):
    """The name of the first rung that is within each tolerance."""
    errors = {rung.name: ladder.error(rung, min(tolerances) / 1000) for rung in ladder.rungs}
    for tolerance in tolerances:
        yield next(name for name, error in errors.items() if error <= tolerance)


def shot(flight):
    """The ladder of a shot straight up that is in the air for so many seconds, without drag."""
    return projectile.ladder(G, LATITUDE, drag=0.0, start=(0.0, 0.0, 0.0, 0.0, 0.0, G * flight / 2), t=flight)


def spun(omega_z):
    """The ladder of a top of this rate about its axis, let go at rest 0.6 rad from the vertical."""
    return top_ladder.ladder(I0, I, MGR, omega_z, THETA, precession=0.0, asymmetry=ASYMMETRY, t=LASTING)


def _projectile(flight, tolerances):
    return _holding(shot(flight), tolerances)


def _top(omega_z, tolerances):
    return _holding(spun(omega_z), tolerances)


def _plumb_line(flight):
    """The centrifugal acceleration, left out for T."""
    return EARTH_RATE**2 * EARTH_RADIUS * math.cos(LATITUDE) * flight**2 / 2


def _inverse_square(flight):
    """The weight that is less by 2 g z/R at the height z = g t (T - t)/2, left out for T."""
    return G**2 * flight**4 / (12 * EARTH_RADIUS)


def _nodding(omega_z):
    """The nutation of a fast top let go at rest, 2 I0 mgr sin(theta)/(I omega_z)^2."""
    return 2 * I0 * MGR * math.sin(THETA) / (I * omega_z) ** 2


# -- what a run can tell: the sleeping top

CRITICAL, TILT, FALLEN = sleeping_top(I0, I, MGR, 1.0).critical, 1e-6, 0.1  # rad/s, rad, rad
FALLS, SEEMS, STANDS = "falls, and a run shows it", "falls, but a run does not show it yet", "stands, as the criterion says"
LONGEST = 100.0  # s


def _leaning(s, p, t):
    return s.q1 * s.q1 + s.q2 * s.q2 - math.sin(FALLEN / 2) ** 2


FALL = Event(_leaning, 1, terminal=True, name="falls")


def falling_time(ratio):
    """The seconds in which a top at ``ratio`` times the critical rate gets from a tilt of 1e-6 to 0.1 rad; infinite if not within 100 s."""
    start = (math.cos(TILT / 2), math.sin(TILT / 2), 0.0, 0.0, 0.0, 0.0)
    motion = integrate(top.nonspinning_frame(I0, I, MGR, ratio * CRITICAL), LONGEST, start, 1e-9, events=FALL)
    return motion.events[0].t if motion.events else math.inf


def _sleeping(ratio, times):
    fallen, stable = falling_time(ratio), sleeping_top(I0, I, MGR, ratio * CRITICAL).stable
    for t in times:
        yield FALLS if t >= fallen else STANDS if stable else SEEMS


def _grown(ratio):
    """|z| of I0 z'' - i I omega_z z' - mgr z = 0 from rest is TILT sqrt(mgr/I0)/growth exp(growth t)/2 at last."""
    import numpy as np

    growth = np.sqrt(np.where(ratio < 1, MGR / I0 * (1 - ratio**2), np.nan))
    return np.log(2 * FALLEN / TILT * growth / math.sqrt(MGR / I0)) / growth


# -- where there is a motion at all: steady precession

NONE, BOTH, OPPOSED = "none: it nods", "slow and fast, of one sense", "slow and fast, of opposite sense"


def _steady(omega_z, angles):
    for angle in angles:
        try:
            found = steady_precession(I0, I, math.radians(angle), omega_z=omega_z, mgr=MGR)
        except GyroError:
            yield NONE
        else:
            yield BOTH if found.slow * found.fast > 0 else OPPOSED


def _steepest(omega_z):
    """cos(theta) = (I omega_z)^2/(4 I0 mgr), the double root of (10.33)."""
    import numpy as np

    c = (I * omega_z) ** 2 / (4 * I0 * MGR)
    return np.degrees(np.arccos(np.where(c <= 1, c, np.nan)))


def _names(ladder):
    return tuple(rung.name for rung in ladder.rungs)


def _table():
    yield Map(
        "free body", "Free body near its intermediate axis: the cheapest integration to 1e-9",
        "Moments 1, 2, 3, at 1 rad/s. The exact solution costs least of all and judges the others. Beside the separatrix each turnover multiplies "
        "what was rounded, and before long no integration in floats is right to 1e-9 any more.",
        Axis("tilt from the intermediate axis, rad", 1e-8, 1.0), Axis("time, s", 1.0, 3e4), (STEPWISE, SERIES, CLOSED, DIGITS), _free_body,
        (Curve("first turnover", _first_turn), Curve("round-off grown to 1e-9", _rounded_off)), (24, 24),
    )  # fmt: skip
    yield Map(
        "projectile", "Shot straight up at 45° north: the smallest model",
        "In vacuum, the position over the whole flight, against the inverse square of an Earth that turns.",
        Axis("time of flight, s", 1.0, 1000.0), Axis("error allowed, m", 1e-6, 1e5), _names(shot(1.0)), _projectile,
        (Curve("centrifugal: ω² R T² cos λ/2", _plumb_line), Curve("less weight above: g² T⁴/(12 R)", _inverse_square)), (40, 60),
    )  # fmt: skip
    yield Map(
        "top", "Top let go at 0.6 rad for 5 s: the smallest model",
        "I0 = 0.02, I = 0.01, mgr = 0.5, transverse moments 0.1 % above and below I0; the direction of the axis against the body in three angles.",
        Axis("rate about its axis, rad/s", 10.0, 1000.0), Axis("error allowed, rad", 1e-6, 3.0), _names(spun(200.0)), _top,
        (Curve("nutation 2 I₀ mgr sin θ/(I ω)²", _nodding), Curve("least rate of steady precession", x=LEAST)),
        (36, 60),
    )  # fmt: skip
    yield Map(
        "sleeping top", "Top set upright, tilted by 1e-6 rad: what a run can tell",
        "A tilt of 0.1 rad counts as fallen. Just below the critical rate no run is long enough, and the criterion alone decides.",
        Axis("rate over the critical one, 2 √(I₀ mgr)/I", 0.8, 1.1, log=False), Axis("length of the run, s", 1.0, LONGEST), (FALLS, SEEMS, STANDS),
        _sleeping, (Curve("by its rate of growth", _grown), Curve("(I ω)² = 4 I₀ mgr", x=1.0)), (36, 40),
    )  # fmt: skip
    yield Map(
        "steady precession", "Where a top can precess steadily",
        "I0 = 0.02, I = 0.01, mgr = 0.5; rates of both precessions from (10.33).",
        Axis("rate about its axis, rad/s", 0.0, 60.0, log=False), Axis("angle from the upward vertical, degrees", 0.0, 180.0, log=False),
        (NONE, BOTH, OPPOSED), _steady, (Curve("(I ω)² = 4 I₀ mgr cos θ", _steepest), Curve("sleeping top: (I ω)² = 4 I₀ mgr", x=CRITICAL)), (90, 90),
    )  # fmt: skip


MAPS = {chart.name: chart for chart in _table()}
