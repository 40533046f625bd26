"""Maps of parameter space: the method to use, or the least model, with theoretical borders.

>>> found = MAPS["steady precession"].measure((2, 2))  # at 15 and 45 rad/s, at 45 and 135 degrees
>>> found.tolist()[0], found[1, 0]
(['none: it nutates', 'slow and fast, of one sense'], 'slow and fast, of opposite sense')
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache

from ...algebra.late import np
from ...algebra.scalars import Triple
from ...applications.earth import EARTH_RADIUS, EARTH_RATE
from ...applications.gyroscopes import GyroError, least_spin, sleeping_top, steady_precession
from ...motion.events import Event
from ...motion.integration import integrate
from ...motion.methods.taylor import installed
from ...motion.solution import AccuracyError, Motion
from ...scenes.ladders import Ladder
from ...scenes.particles import projectile
from ...scenes.spatial import top, top_ladder
from ...scenes.spatial.free_body import free_body


@dataclass(frozen=True)
class Axis:
    """An axis of a map, from ``low`` to ``high``: in powers of ten if the ``scale`` is "log"."""

    label: str
    low: float
    high: float
    scale: str = "log"

    def edges(self, count: int) -> "np.ndarray":
        """The limits of ``count`` cells, an array."""
        space = np.geomspace if self.scale == "log" else np.linspace
        return space(self.low, self.high, count + 1)

    def centres(self, count: int) -> "np.ndarray":
        """The middles of ``count`` cells, an array."""
        return self.edges(2 * count)[1::2]


@dataclass(frozen=True)
class Curve:
    """A theoretical border: y as a function of an array of x (nan for none); or an upright x."""

    label: str
    y: Callable | None = None
    x: float | None = None


@dataclass(frozen=True)
class Map:
    """A map of parameter space; ``words`` are for its caption.

    x, y : each an :class:`Axis`
    choices : in the order of the legend
    column : a function of one x and an increasing list of y that returns the choice at each
    curves : theoretical borders
    resolution, coarse : cells along x and y, for a chart and for one within a few seconds
    timed : the choices depend on times, which vary from run to run
    fails : it shows where a run cannot decide
    """

    name: str
    title: str
    words: str
    x: Axis
    y: Axis
    choices: tuple
    column: Callable
    curves: tuple
    resolution: tuple
    coarse: tuple = (18, 15)
    timed: bool = False
    fails: bool = False

    def measure(
        self,
        resolution: tuple[int, int] | None = None,
        progress: Callable[[float], object] = lambda fraction: None,
    ) -> "np.ndarray":
        """The choices as an array: a row for each y from the lowest, a column for each x."""
        across, up = resolution or self.resolution
        columns = []
        for n, x in enumerate(self.x.centres(across).tolist()):
            progress(n / across)
            columns.append(list(self.column(x, self.y.centres(up).tolist())))
        return np.array(columns, dtype=object).T


# -- methods: the free body

# growth of a tilt from the intermediate axis, 1/s at 1 rad/s
BODY, GROWTH = free_body(1.0, 2.0, 3.0), 1 / math.sqrt(3)
WANTED = 1e-9  # error of the rates at any time, relative to 1 rad/s
DENSE = 100  # instants in a cell at which errors are looked for
DOP853, TAYLOR = "dop853, nothing to compile", "taylor, compilation counted"
EXACT, EXACT_30 = "only the exact solution", "only the exact solution in 30 digits"


def start_at(tilt: float) -> tuple[float, float, float]:
    """Rates of a spin of 1 rad/s that is tilted from the intermediate axis of :data:`BODY`."""
    return math.sin(tilt) / math.sqrt(2), math.cos(tilt), math.sin(tilt) / math.sqrt(2)


@cache
def compile_time() -> float:
    """The seconds that heyoka takes to compile such a right-hand side; inf without heyoka."""
    integrate(BODY, 1.0, start_at(0.1), 1e-9, "dop853")  # tracing does not count for any method
    if not installed():
        return math.inf
    integrate(BODY, 1.0, start_at(0.1), 1e-9, "taylor")  # imports do not count
    # a formula that is not compiled yet
    fresh = replace(BODY, rhs=lambda s, p, t: [1.0625 * rate for rate in BODY.rhs(s, p, t)])
    return integrate(fresh, 1.0, start_at(0.1), 1e-9, "taylor").cost.seconds


def errors_until(times: Sequence[float], motion: Motion, start: Triple) -> "np.ndarray":
    """The largest error of a motion until each of the times, by the exact solution."""
    exact, states = BODY.solution(motion.times, start), list(motion.states.values())
    worst = np.maximum.accumulate(abs(np.array(exact) - states).max(axis=0))
    return worst[np.searchsorted(motion.times, times, side="right") - 1]


def _as_accurate_as_it_gets(t, start, rtol, method, samples):
    """The motion of the body, even where the tolerance cannot be met: the map judges it."""
    try:
        return integrate(BODY, t, start, rtol, method, samples=samples)
    except AccuracyError as refused:
        return refused.reached


def _taylor_seconds(times, start):
    """By time, the seconds of a Taylor series with its compilation; inf where not to WANTED."""
    if not installed():
        return [math.inf] * len(times)
    end = times[-1]
    instants = np.union1d(times, np.geomspace(times[0], end, DENSE * len(times)))
    motion = _as_accurate_as_it_gets(end, start, 1e-15, "taylor", instants)
    seconds = compile_time() + motion.cost.seconds * np.array(times) / end
    right = errors_until(times, motion, start) <= WANTED
    return np.where(right, seconds, math.inf).tolist()


def _dop853_seconds(t, start):
    """The seconds of DOP853 at the first tolerance that keeps the error below WANTED; or inf."""
    for rtol in (1e-10, 1e-12):
        motion = _as_accurate_as_it_gets(t, start, rtol, "dop853", DENSE)
        if errors_until([t], motion, start)[0] <= WANTED:
            return motion.cost.seconds
    return math.inf


def _exact_holds(t, start):
    """True if the exact solution in floats differs from that in 30 digits by at most WANTED."""
    import mpmath

    with mpmath.workdps(30):
        exact = BODY.solution(mpmath.mpf(t), start)
    return max(abs(a - b) for a, b in zip(BODY.solution(t, start), exact, strict=True)) <= WANTED


def _free_body(tilt, times):
    start, rate, longest = start_at(tilt), 0.0, 2 * compile_time()
    for t, taylor in zip(times, _taylor_seconds(times, start), strict=True):
        dop853 = math.inf
        # not measured where it would be slower anyway: a second of motion takes no less than before
        if rate * t < 3 * min(taylor, longest):
            dop853 = _dop853_seconds(t, start)
            rate = dop853 / t
        if dop853 == taylor == math.inf:
            yield EXACT if _exact_holds(t, start) else EXACT_30
        else:
            yield DOP853 if dop853 < taylor else TAYLOR


def _first_turnover(tilt):
    """The quarter period after which a small tilt, half growing, reaches a right angle."""
    return np.log(4 * math.sqrt(2) / tilt) / GROWTH


def _roundoff_time(tilt):
    """The time until which an integration has errors below WANTED even where the motion is fastest:
    a round-off e of the energy changes the period by 4 e/(GROWTH a^2), and after a random walk of n
    periods the time of a turnover by n^(3/2) times that.
    """
    # e = 2^-53, solved for n
    periods = (WANTED * tilt**2 / (4 * 2.0**-53)) ** (2 / 3)
    return _first_turnover(tilt) * (2 + 4 * periods)  # the first turnover is not yet affected


# -- models: the projectile, and the top

G, LATITUDE = 9.82, math.radians(45)
I0, I, MGR, THETA = 0.02, 0.01, 0.5, 0.6


def shot(flight: float) -> Ladder:
    """The ladder of a vertical shot without drag that is in the air for ``flight`` seconds."""
    start = (0.0, 0.0, 0.0, 0.0, 0.0, G * flight / 2)
    return projectile.ladder(G, LATITUDE, drag=0.0, start=start, t=flight)


def released_top(omega_z: float) -> Ladder:
    """The ladder of a top of this spin, released from rest 0.6 rad from the vertical, for 5 s."""
    return top_ladder.ladder(I0, I, MGR, omega_z, THETA, precession=0.0, asymmetry=1e-3, t=5.0)


def _smallest_rung(ladder_at):
    """The column of a map: the first rung of ``ladder_at(x)`` within each tolerance."""

    def column(x, tolerances):
        ladder = ladder_at(x)
        errors = {rung.name: ladder.error(rung, min(tolerances) / 1000) for rung in ladder.rungs}
        return [next(name for name in errors if errors[name] <= y) for y in tolerances]

    return column


def rung_names(ladder: Ladder) -> tuple[str, ...]:
    """The names of the rungs of a ladder, a tuple."""
    return tuple(rung.name for rung in ladder.rungs)


# -- what a run shows: the sleeping top

CRITICAL, TILT, FALLEN = sleeping_top(I0, I, MGR, 1.0).critical, 1e-6, 0.1  # rad/s, rad, rad
FALLS, UNDECIDED = "unstable, falls in the run", "unstable, but does not fall in the run"
STANDS, LONGEST = "stable, by the criterion", 100.0  # s
# a tilt of FALLEN, by the quaternion: sin(tilt/2)^2 = q1^2 + q2^2
FALL = Event(lambda s, p, t: s.q1**2 + s.q2**2 - math.sin(FALLEN / 2) ** 2, 1, terminal=True)


def falling_time(ratio: float) -> float:
    """The seconds in which a top at ``ratio`` of the critical rate falls to 0.1 rad; or inf."""
    start = (math.cos(TILT / 2), math.sin(TILT / 2), 0.0, 0.0, 0.0, 0.0)
    model = top.nonspinning_frame(I0, I, MGR, ratio * CRITICAL)
    motion = integrate(model, LONGEST, start, 1e-9, events=FALL)
    assert isinstance(motion, Motion)
    return motion.events[0].t if motion.events else math.inf


def _sleeping(ratio, times):
    other = STANDS if sleeping_top(I0, I, MGR, ratio * CRITICAL).stable else UNDECIDED
    fallen = falling_time(ratio)
    return [FALLS if t >= fallen else other for t in times]


def _theoretical_falling_time(ratio):
    """That time by the growth of I0 z'' - i I omega_z z' - mgr z = 0 from rest: |z| tends to TILT
    sqrt(mgr/I0)/growth exp(growth t)/2.
    """
    growth = np.sqrt(np.where(ratio < 1, 1 - ratio**2, np.nan))  # growth rate over sqrt(mgr/I0)
    return np.log(2 * FALLEN / TILT * growth) / growth / math.sqrt(MGR / I0)


# -- existence: steady precession

NONE = "none: it nutates"
BOTH, OPPOSED = "slow and fast, of one sense", "slow and fast, of opposite sense"


def _steady(omega_z, angles):
    for angle in angles:
        try:
            found = steady_precession(I0, I, math.radians(angle), omega_z=omega_z, mgr=MGR)
        except GyroError:
            yield NONE
        else:
            yield BOTH if found.slow * found.fast > 0 else OPPOSED


def _limit_angle(omega_z):
    """cos(theta) = (I omega_z)^2/(4 I0 mgr), the double root of (10.33)."""
    c = (I * omega_z) ** 2 / (4 * I0 * MGR)
    return np.degrees(np.arccos(np.where(c <= 1, c, np.nan)))


_MAPS = (
    Map(
        "free body", "Free body near its intermediate axis: the cheapest integration to 1e-9",
        "Moments 1, 2, 3, at 1 rad/s, against the exact solution, which costs least. Next to the "
        "separatrix each turnover multiplies the round-off: no integration stays right for long.",
        Axis("tilt from the intermediate axis, rad", 1e-8, 1.0), Axis("time, s", 1.0, 3e4),
        (DOP853, TAYLOR, EXACT, EXACT_30), _free_body,
        (Curve("first turnover", _first_turnover),
         Curve("round-off grown to 1e-9", _roundoff_time)), (24, 24), (14, 14), timed=True,
    ),
    Map(
        "projectile", "Shot straight up at 45° north: the smallest model",
        "In vacuum, the position over the whole flight, on an Earth that turns.",
        Axis("time of flight, s", 1.0, 1000.0), Axis("error allowed, m", 1e-6, 1e5),
        rung_names(shot(1.0)), _smallest_rung(shot),
        # in the time T; the gravity deficit is 2 g z/R at the height z = g t (T - t)/2
        (Curve("centrifugal: ω² R T² cos λ/2",
               lambda T: EARTH_RATE**2 * EARTH_RADIUS * math.cos(LATITUDE) * T**2 / 2),
         Curve("less weight above: g² T⁴/(12 R)", lambda T: G**2 * T**4 / (12 * EARTH_RADIUS))),
        (40, 60), (20, 30),
    ),
    Map(
        "top", "Top released at 0.6 rad for 5 s: the smallest model",
        "I0 = 0.02, I = 0.01, mgr = 0.5, transverse moments 0.1 % above and below I0; the "
        "direction of the axis.",
        Axis("rate about its axis, rad/s", 10.0, 1000.0), Axis("error allowed, rad", 1e-6, 3.0),
        rung_names(released_top(200.0)), _smallest_rung(released_top),
        (Curve("nutation 2 I₀ mgr sin θ/(I ω)²",  # of a fast top released from rest
               lambda omega_z: 2 * I0 * MGR * math.sin(THETA) / (I * omega_z) ** 2),
         Curve("least rate of steady precession",
               x=least_spin(I0, I, THETA, mgr=MGR, of="omega_z"))), (36, 60), (18, 30),
    ),
    Map(
        "sleeping top", "Top set upright, tilted by 1e-6 rad: what a run shows",
        "A tilt of 0.1 rad counts as fallen. Just below the critical rate no run is long enough.",
        Axis("rate over the critical one, 2 √(I₀ mgr)/I", 0.8, 1.1, "linear"),
        Axis("length of the run, s", 1.0, LONGEST), (FALLS, UNDECIDED, STANDS), _sleeping,
        (Curve("by its rate of growth", _theoretical_falling_time),
         Curve("(I ω)² = 4 I₀ mgr", x=1.0)), (36, 40), (7, 12), fails=True,
    ),
    Map(
        "steady precession", "Where a top can precess steadily",
        "I0 = 0.02, I = 0.01, mgr = 0.5; rates of both precessions from (10.33).",
        Axis("rate about its axis, rad/s", 0.0, 60.0, "linear"),
        Axis("angle from the upward vertical, degrees", 0.0, 180.0, "linear"),
        (NONE, BOTH, OPPOSED), _steady,
        (Curve("(I ω)² = 4 I₀ mgr cos θ", _limit_angle),
         Curve("sleeping top: (I ω)² = 4 I₀ mgr", x=CRITICAL)), (90, 90), (60, 60),
    ),
)  # fmt: skip
MAPS = {chart.name: chart for chart in _MAPS}
