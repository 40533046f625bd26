"""Events: many zeros, two that lie close together, ends, bounces."""

import math

from newton_euler import Event, Model, cos, sin, sqrt, where
from tests.honesty import closed_forms, models
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, family

LINE = Event(lambda s, p, t: s.x - p.line)
LOWEST_PLACE = Event(lambda s, p, t: s.theta, name="lowest place")


def crossings(model, T, event=LINE):
    """A spring let go at 1, each of whose crossings of ``line`` is known."""
    times = closed_forms.crossings_of_a_spring(T)
    known = {"exact": models.exact_spring, "event_times": times}
    return Case(model, T, (1.0, 0.0), events=(event,), **known)


@family("events")
def zeros_of_a_spring(rng):
    """A hundred to two thousand passages through a line."""
    w = rng.decades(0.1, 10.0)
    model = models.spring(k=w * w, line=rng.uniform(-0.8, 0.8))
    return crossings(model, 2 * math.pi / w * rng.decades(50.0, 1e3))


@family("events", "long")
def zeros_of_a_pendulum(rng):
    """A pendulum passes its lowest point hundreds of times; every passage must be found."""
    k, T, theta = rng.values(Log(0.5, 20.0), Log(100.0, 3000.0), (0.2, 2.8))

    def times(mp, s, p):
        return closed_forms.pendulum_zeros(mp, p.k, s.theta, s.omega, mp.mpf(T))

    known = {"exact": models.exact_pendulum, "event_times": times}
    return Case(models.pendulum(k), T, (theta, 0.0), events=(LOWEST_PLACE,), **known)


@family("events")
def crests_of_a_wave(rng):
    """Short visits to a crest: pairs of zeros close together, or barely a miss."""
    w, gap = rng.values(Log(0.5, 20.0), Log(1e-7, 1e-2))
    model = models.spring("crests", k=w * w, line=1 - gap if rng.random() < 0.7 else 1 + gap)
    return Case(model, rng.uniform(20.0, 120.0) / w, (0.0, w), events=(LINE,))


@family("events")
def landing(rng):
    """A shot with drag, until it comes down."""

    def accelerations(s, p, t):
        v = sqrt(s.dx * s.dx + s.dy * s.dy)
        return -p.c * v * s.dx, -p.g - p.c * v * s.dy

    parameters = rng.parameters(g=9.81, c=Log(1e-4, 1e-1))
    v, a = rng.values(Log(5.0, 300.0), (0.1, 1.4))
    start = 0.0, rng.choice((0.0, 1.0)), v * math.cos(a), v * math.sin(a)
    end = Event(lambda s, p, t: s.y, -1, True, name="landing")
    return by_accelerations(accelerations, parameters, "x y", 2.5 * v / 9.81, start, events=(end,))


@family("events")
def bouncing_ball(rng):
    """A ball that loses speed at each impact; the run ends before the impacts accumulate."""
    e, h = rng.values((0.5, 0.95), Log(0.1, 10.0))
    then = lambda s, p, t: (model, (0.0, -p.e * s.v))
    model = Model("bouncing ball", {"g": 9.81, "e": e}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    fall, bounces = math.sqrt(2 * h / 9.81), rng.randint(1, 7)
    T = fall * (1 + 2 * sum(e**n for n in range(1, bounces)))
    T += 2 * fall * e**bounces * rng.uniform(0.2, 0.8)
    impact = Event(lambda s, p, t: s.h, -1, then=then, name="impact")
    return Case(model, T, (h, 0.0), events=(impact,))


@family("events")
def pendulum_at_a_wall(rng):
    """A pendulum that is thrown back by a wall beside it."""
    then = lambda s, p, t: (model, (s.theta, -p.e * s.omega))
    parameters = rng.parameters(k=(1.0, 20.0), wall=(-0.5, 0.3), e=(0.8, 1.0))
    rates = lambda s, p, t: (s.omega, -p.k * sin(s.theta))
    model = Model("pendulum at a wall", parameters, ("theta", "omega"), rates)
    hit = Event(lambda s, p, t: s.theta - p.wall, -1, then=then, name="wall")
    T, theta = rng.values((3.0, 15.0), (0.8, 2.0))
    T /= parameters["k"] ** 0.5
    return Case(model, T, (theta, 0.0), events=(hit,))


@family("events", "chaotic")
def section_of_poincare(rng):
    """Passages of a star in a galaxy through an axis: a Poincaré section."""
    a = lambda s, p, t: (-s.x - 2 * p.a * s.x * s.y, -s.y - p.a * (s.x * s.x - s.y * s.y))
    section = Event(lambda s, p, t: s.x, 1, name="section")
    T, *start = rng.values((20.0, 60.0), 0.01, (-0.2, 0.3), (0.2, 0.4), (-0.2, 0.2))
    return by_accelerations(a, {"a": 1.0}, "x y", T, start, events=(section,))


@family("events", "forced")
def beats_of_two_tones(rng):
    """Zeros of a function of time and state that oscillates faster than the motion."""
    model = models.spring("slow spring", **rng.parameters(k=(0.2, 1.0), w=(10.0, 60.0)))
    event = Event(lambda s, p, t: cos(p.w * t) - s.x / 2)
    return Case(model, rng.uniform(5.0, 20.0), (1.0, 0.0), events=(event,))


def _oscillation(rng, closed, **parameters):
    """A spring, with or without its solution, and its angular frequency."""
    w = rng.decades(0.1, 10.0)
    return models.spring(closed=closed, k=w * w, **parameters), w


@family("events", "closed form")
def thousands_of_zeros_in_one_step(rng):
    """The closed form takes one step for all the time; up to ten thousand zeros lie in it."""
    model, w = _oscillation(rng, True, line=rng.uniform(-0.99, 0.99))
    return crossings(model, 2 * math.pi / w * rng.decades(1e3, 5e3))


@family("events", "closed form")
def grazing_in_one_step(rng):
    """Pairs of zeros with barely anything between them, or none."""
    gap = rng.decades(1e-10, 1e-3)
    model, w = _oscillation(rng, True, line=1 - gap if rng.random() < 0.7 else 1 + gap)
    return Case(model, rng.uniform(60.0, 200.0) / w, (1.0, 0.0), events=(LINE,))


@family("events")
def interleaved_events(rng):
    """Three events that take turns: of the position, of the speed and of both."""
    closed = rng.random() < 0.5
    model, w = _oscillation(rng, closed, **rng.parameters(low=(-0.9, 0.9), c=(0.3, 3.0)))
    events = (
        Event(lambda s, p, t: s.x - p.low, -1, name="falls"),
        Event(lambda s, p, t: s.dx - sqrt(p.k) * p.low, name="fast"),
        Event(lambda s, p, t: s.x * sqrt(p.k) - p.c * s.dx, 1, name="both"),
    )
    return Case(model, rng.uniform(40.0, 300.0) / w, (1.0, 0.0), events=events)


@family("events", "kinked")
def zeros_at_a_kink(rng):
    """A function that crosses zero with one slope before and another one after."""
    closed = rng.random() < 0.5
    model, w = _oscillation(rng, closed, line=0.0, slope=rng.decades(1e-3, 1e3))
    event = Event(lambda s, p, t: where(s.x > 0, s.x, p.slope * s.x))
    return crossings(model, 2 * math.pi / w * rng.decades(3.0, 60.0), event)


@family("events", "kinked")
def jumps_through_zero(rng):
    """A function that is never zero, but jumps from one sign to the other."""
    closed = rng.random() < 0.5
    model, w = _oscillation(rng, closed, line=rng.uniform(-0.8, 0.8))
    event = Event(lambda s, p, t: where(s.x > p.line, 2.0, -1.0))
    return crossings(model, 2 * math.pi / w * rng.decades(3.0, 30.0), event)


@family("events")
def ticks_of_a_clock(rng):
    """Zeros of a function of the time alone, hundreds of them while the motion is slow."""
    tones, closed = rng.decades(30.0, 3e3), rng.random() < 0.5
    model, w = _oscillation(rng, closed, tones=tones)
    T = rng.uniform(1.0, 6.0) / w

    def times(mp, s, p):
        rate = p.tones * mp.sqrt(p.k)
        return [mp.pi * n / rate for n in range(1, int(rate * T / mp.pi) + 1)]

    known = {"exact": models.exact_spring, "event_times": times}
    event = Event(lambda s, p, t: sin(p.tones * sqrt(p.k) * t))
    return Case(model, T, (1.0, 0.0), events=(event,), **known)


@family("events")
def end_after_many_others(rng):
    """Hundreds of events that are only reported, and then one that ends the motion."""
    stop, closed = rng.uniform(100.0, 500.0), rng.random() < 0.5
    model, w = _oscillation(rng, closed, line=0.3, stop=stop)
    end = Event(lambda s, p, t: sqrt(p.k) * t - p.stop, terminal=True, name="end")
    line = Event(lambda s, p, t: s.x - p.line, name="line")
    return Case(model, 2 * stop / w, (1.0, 0.0), events=(line, end))


@family("events")
def zeros_in_strange_units(rng):
    """Zeros of a function in units that make it huge or tiny."""
    closed = rng.random() < 0.5
    model, w = _oscillation(
        rng, closed, line=rng.uniform(-0.9, 0.9), unit=rng.decades(1e-200, 1e200)
    )
    event = Event(lambda s, p, t: p.unit * (s.x - p.line))
    return crossings(model, 2 * math.pi / w * rng.decades(3.0, 100.0), event)


@family("events")
def slow_crossing(rng):
    """A decay that comes down to a level at which it has almost no speed left."""
    parameters = rng.parameters(k=Log(0.1, 10.0), level=Log(1e-5, 0.5))
    T = rng.uniform(1.1, 2.0) * math.log(1 / parameters["level"]) / parameters["k"]
    event = Event(lambda s, p, t: s.x - p.level, -1, True, name="level")
    return by_rates(lambda s, p, t: (-p.k * s.x,), parameters, "x", T, (1.0,), events=(event,))
