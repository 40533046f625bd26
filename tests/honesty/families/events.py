"""Events: many zeros, two that lie close together, ends, bounces."""

import math

from newton_euler import Event, Model, cos, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, family
from tests.honesty.engine import where


@family("events")
def zeros_of_a_spring(rng):
    """A hundred to two thousand passages through a line."""
    w = decades(rng, 0.1, 10.0)
    model = second_order(
        "spring",
        {"k": w * w, "line": rng.uniform(-0.8, 0.8)},
        ("x",),
        lambda s, p, t: (-p.k * s.x,),
    )
    T = 2 * math.pi / w * decades(rng, 50.0, 1e3)

    def exact(mp, s, p, t):
        return closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t)

    return Case(
        model,
        T,
        (1.0, 0.0),
        exact=exact,
        events=(Event(lambda s, p, t: s.x - p.line),),
        event_times=closed_forms.crossings_of_a_spring(T),
    )


@family("events", "long")
def zeros_of_a_pendulum(rng):
    """It passes its lowest place hundreds of times; every one is to be found."""
    k, T = decades(rng, 0.5, 20.0), decades(rng, 100.0, 3000.0)
    model = Model(
        "pendulum", {"k": k}, ("theta", "omega"), lambda s, p, t: (s.omega, -p.k * sin(s.theta))
    )

    def exact(mp, s, p, t):
        return closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    def times(mp, s, p):
        return closed_forms.pendulum_zeros(mp, p.k, s.theta, s.omega, mp.mpf(T))

    event = Event(lambda s, p, t: s.theta, name="lowest place")
    return Case(
        model, T, (rng.uniform(0.2, 2.8), 0.0), exact=exact, events=(event,), event_times=times
    )


@family("events")
def crests_of_a_wave(rng):
    """Short visits to the crest of an oscillation.

    Pairs of zeros that lie close together, or just none.
    """
    w, gap = decades(rng, 0.5, 20.0), decades(rng, 1e-7, 1e-2)
    parameters = {"k": w * w, "line": 1 - gap if rng.random() < 0.7 else 1 + gap}
    model = second_order("crests", parameters, ("x",), lambda s, p, t: (-p.k * s.x,))
    return Case(
        model, rng.uniform(20.0, 120.0) / w, (0.0, w), events=(Event(lambda s, p, t: s.x - p.line),)
    )


@family("events")
def landing(rng):
    """A shot with drag, until it comes down."""
    parameters = {"g": 9.81, "c": decades(rng, 1e-4, 1e-1)}

    def accelerations(s, p, t):
        v = sqrt(s.dx * s.dx + s.dy * s.dy)
        return -p.c * v * s.dx, -p.g - p.c * v * s.dy

    model = second_order("shot", parameters, ("x", "y"), accelerations)
    v, a = decades(rng, 5.0, 300.0), rng.uniform(0.1, 1.4)
    end = Event(lambda s, p, t: s.y, -1, True, name="landing")
    return Case(
        model,
        2.5 * v / 9.81,
        (0.0, rng.choice((0.0, 1.0)), v * math.cos(a), v * math.sin(a)),
        events=(end,),
    )


@family("events")
def bouncing_ball(rng):
    """A ball that loses part of its speed at each impact.

    The end comes before the bounces crowd.
    """
    e, h = rng.uniform(0.5, 0.95), decades(rng, 0.1, 10.0)

    def bounced(s, p, t):
        return 0 * s.h, -p.e * s.v

    def then(s, p, t):
        return model, (0.0, -p.e * s.v)

    model = Model("bouncing ball", {"g": 9.81, "e": e}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    fall = math.sqrt(2 * h / 9.81)
    bounces = rng.randint(1, 7)
    T = fall * (1 + 2 * sum(e**n for n in range(1, bounces))) + 2 * fall * e**bounces * rng.uniform(
        0.2, 0.8
    )
    return Case(
        model,
        T,
        (h, 0.0),
        events=(Event(lambda s, p, t: s.h, -1, then=then, name="impact"),),
        impact=bounced,
    )


@family("events")
def pendulum_at_a_wall(rng):
    """A pendulum that is thrown back by a wall beside it."""

    def turned(s, p, t):
        return s.theta, -p.e * s.omega

    def then(s, p, t):
        return model, (s.theta, -p.e * s.omega)

    parameters = {
        "k": rng.uniform(1.0, 20.0),
        "wall": rng.uniform(-0.5, 0.3),
        "e": rng.uniform(0.8, 1.0),
    }
    model = Model(
        "pendulum at a wall",
        parameters,
        ("theta", "omega"),
        lambda s, p, t: (s.omega, -p.k * sin(s.theta)),
    )
    hit = Event(lambda s, p, t: s.theta - p.wall, -1, then=then, name="wall")
    return Case(
        model,
        rng.uniform(3.0, 15.0) / parameters["k"] ** 0.5,
        (rng.uniform(0.8, 2.0), 0.0),
        events=(hit,),
        impact=turned,
    )


@family("events", "chaotic")
def section_of_poincare(rng):
    """Passages of an axis by a star in a galaxy: a section of Poincare."""
    model = second_order(
        "star",
        {"a": 1.0},
        ("x", "y"),
        lambda s, p, t: (-s.x - 2 * p.a * s.x * s.y, -s.y - p.a * (s.x * s.x - s.y * s.y)),
    )
    section = Event(lambda s, p, t: s.x, 1, name="section")
    return Case(
        model,
        rng.uniform(20.0, 60.0),
        (0.01, rng.uniform(-0.2, 0.3), rng.uniform(0.2, 0.4), rng.uniform(-0.2, 0.2)),
        events=(section,),
    )


@family("events", "forced")
def beats_of_two_tones(rng):
    """Zeros of a function of time and state that oscillates faster than the motion."""
    parameters = {"k": rng.uniform(0.2, 1.0), "w": rng.uniform(10.0, 60.0)}
    model = second_order("slow spring", parameters, ("x",), lambda s, p, t: (-p.k * s.x,))
    return Case(
        model,
        rng.uniform(5.0, 20.0),
        (1.0, 0.0),
        events=(Event(lambda s, p, t: cos(p.w * t) - s.x / 2),),
    )


def _oscillation(rng, start, closed=True, **parameters):
    """A spring, with or without its solution, that starts with x at ``start`` and no speed."""
    w = decades(rng, 0.1, 10.0)

    def solution(s, p, t):
        n = sqrt(p.k)
        return s.x * cos(n * t) + s.dx / n * sin(n * t), s.dx * cos(n * t) - n * s.x * sin(n * t)

    model = second_order(
        "spring",
        {"k": w * w, **parameters},
        ("x",),
        lambda s, p, t: (-p.k * s.x,),
        exact=solution if closed else None,
    )
    return model, w, (start, 0.0)


def _moved(mp, s, p, t):
    return closed_forms.oscillator(mp, mp.sqrt(p.k), s.x, s.dx, t)


@family("events", "closed form")
def thousands_of_zeros_in_one_step(rng):
    """The closed form takes one step for all the time; in it are up to ten thousand zeros."""
    model, w, start = _oscillation(rng, 1.0, line=rng.uniform(-0.99, 0.99))
    T = 2 * math.pi / w * decades(rng, 1e3, 5e3)
    event = Event(lambda s, p, t: s.x - p.line)
    times = closed_forms.crossings_of_a_spring(T)
    return Case(model, T, start, exact=_moved, events=(event,), event_times=times)


@family("events", "closed form")
def grazing_in_one_step(rng):
    """Pairs of zeros so close together that hardly anything lies between them; or none."""
    gap = decades(rng, 1e-10, 1e-3)
    model, w, start = _oscillation(rng, 1.0, line=1 - gap if rng.random() < 0.7 else 1 + gap)
    event = Event(lambda s, p, t: s.x - p.line)
    return Case(model, rng.uniform(60.0, 200.0) / w, start, events=(event,))


@family("events")
def interleaved_events(rng):
    """Three events, of the place, the speed and both, that come in turns."""
    model, w, start = _oscillation(
        rng, 1.0, rng.random() < 0.5, low=rng.uniform(-0.9, 0.9), c=rng.uniform(0.3, 3.0)
    )
    events = (
        Event(lambda s, p, t: s.x - p.low, -1, name="falls"),
        Event(lambda s, p, t: s.dx - sqrt(p.k) * p.low, name="fast"),
        Event(lambda s, p, t: s.x * sqrt(p.k) - p.c * s.dx, 1, name="both"),
    )
    return Case(model, rng.uniform(40.0, 300.0) / w, start, events=events)


@family("events", "kinked")
def zeros_at_a_kink(rng):
    """A function that crosses zero with one slope before and another one after."""
    model, w, start = _oscillation(
        rng, 1.0, rng.random() < 0.5, line=0.0, slope=decades(rng, 1e-3, 1e3)
    )
    T = 2 * math.pi / w * decades(rng, 3.0, 60.0)
    event = Event(lambda s, p, t: where(s.x > 0, s.x, p.slope * s.x))
    times = closed_forms.crossings_of_a_spring(T)
    return Case(model, T, start, exact=_moved, events=(event,), event_times=times)


@family("events", "kinked")
def jumps_through_zero(rng):
    """A function that is never zero, but jumps from one sign to the other."""
    model, w, start = _oscillation(rng, 1.0, rng.random() < 0.5, line=rng.uniform(-0.8, 0.8))
    T = 2 * math.pi / w * decades(rng, 3.0, 30.0)
    event = Event(lambda s, p, t: where(s.x > p.line, 2.0, -1.0))
    times = closed_forms.crossings_of_a_spring(T)
    return Case(model, T, start, exact=_moved, events=(event,), event_times=times)


@family("events")
def ticks_of_a_clock(rng):
    """Zeros of a function of the time alone, hundreds of them while the motion goes slowly."""
    tones = decades(rng, 30.0, 3e3)
    model, w, start = _oscillation(rng, 1.0, rng.random() < 0.5, tones=tones)
    T = rng.uniform(1.0, 6.0) / w

    def times(mp, s, p):
        rate = p.tones * mp.sqrt(p.k)
        return [mp.pi * n / rate for n in range(1, int(rate * T / mp.pi) + 1)]

    event = Event(lambda s, p, t: sin(p.tones * sqrt(p.k) * t))
    return Case(model, T, start, exact=_moved, events=(event,), event_times=times)


@family("events")
def end_after_many_others(rng):
    """Hundreds of events that only tell, and then one that ends the motion."""
    stop = rng.uniform(100.0, 500.0)
    model, w, start = _oscillation(rng, 1.0, rng.random() < 0.5, line=0.3, stop=stop)
    events = (
        Event(lambda s, p, t: s.x - p.line, name="line"),
        Event(lambda s, p, t: sqrt(p.k) * t - p.stop, terminal=True, name="end"),
    )
    return Case(model, 2 * stop / w, start, events=events)


@family("events")
def zeros_in_strange_units(rng):
    """The function in units in which it is huge or tiny."""
    model, w, start = _oscillation(
        rng, 1.0, rng.random() < 0.5, line=rng.uniform(-0.9, 0.9), unit=decades(rng, 1e-200, 1e200)
    )
    T = 2 * math.pi / w * decades(rng, 3.0, 100.0)
    event = Event(lambda s, p, t: p.unit * (s.x - p.line))
    times = closed_forms.crossings_of_a_spring(T)
    return Case(model, T, start, exact=_moved, events=(event,), event_times=times)


@family("events")
def slow_crossing(rng):
    """A decay that comes down to a level at which it has almost no speed left."""
    parameters = {"k": decades(rng, 0.1, 10.0), "level": decades(rng, 1e-5, 0.5)}
    model = Model("decay", parameters, ("x",), lambda s, p, t: (-p.k * s.x,))
    T = rng.uniform(1.1, 2.0) * math.log(1 / parameters["level"]) / parameters["k"]
    event = Event(lambda s, p, t: s.x - p.level, -1, True, name="level")
    return Case(model, T, (1.0,), events=(event,))
