"""Regions that a motion crosses within a small part of its path, by an argument that turns
back there; states that are zero until a jump; narrow events and tables. Written before the engine
looked for them.
"""

import math

from newton_euler import Event, cos, exp, sqrt, table, where
from tests.honesty.cases import Log, by_rates, family

WIDTH = Log(1e-6, 1e-1)


def _counted(rng, argument, way, exact, start, T, **parameters):
    """``q`` grows by A while ``argument`` is positive, beside a path known in advance.

    way : the rates of the other states; exact : (mp, s, p, t), these states and the time inside
    """
    parameters |= {"A": rng.uniform(0.5, 2.0) / parameters["w"]}
    q0 = rng.choice((0.0, 1.0))
    rates = lambda s, p, t: (*way(s, p, t), where(argument(s, p, t) > 0, p.A, 0.0))

    def whole(mp, s, p, t):
        *states, inside = exact(mp, s, p, t)
        return *states, s.q + p.A * inside

    states = " ".join((*"xyz"[: len(start)], "q"))
    return by_rates(rates, parameters, states, T, (*start, q0), exact=whole)


def _during(mp, t, begin, end):
    """The part of the time from ``begin`` to ``end`` that has passed at t."""
    return max(min(t, end) - begin, mp.mpf(0))


@family("narrow", "turning", "kinked")
def lamp_between_two_marks(rng):
    """A lamp lit while the product of the distances from two marks is positive."""
    v, w, c = rng.values((0.5, 3.0), WIDTH, (3.0, 7.0))
    inside = lambda s, p, t: (s.x - p.c) * (p.c + p.w - s.x)
    exact = lambda mp, s, p, t: (p.v * t, _during(mp, t, p.c / p.v, (p.c + mp.mpf(p.w)) / p.v))
    way = lambda s, p, t: (p.v,)
    return _counted(rng, inside, way, exact, (0.0,), 10.0 / v, v=v, w=w, c=c)


@family("narrow", "turning", "kinked")
def lamp_by_an_expanded_product(rng):
    """A lamp between two marks, by the product multiplied out, on a path with drag."""
    v, r, w, c = rng.values((1.0, 3.0), (0.05, 0.2), Log(1e-5, 1e-1), (0.5, 3.0))
    inside = lambda s, p, t: p.u * s.x - s.x**2 - p.k

    def exact(mp, s, p, t):
        place, root = s.y / p.r, mp.sqrt(mp.mpf(p.u) ** 2 / 4 - p.k)
        met = lambda x: -mp.log1p(-x / place) / p.r
        x, y = -place * mp.expm1(-p.r * t), s.y * mp.exp(-p.r * t)
        return x, y, _during(mp, t, met(mp.mpf(p.u) / 2 - root), met(mp.mpf(p.u) / 2 + root))

    way = lambda s, p, t: (s.y, -p.r * s.y)
    known = {"u": 2 * c + w, "k": c * (c + w), "r": r, "w": w}
    return _counted(rng, inside, way, exact, (0.0, v), 5.0, **known)


@family("narrow", "turning", "kinked")
def ball_that_touches_a_beam(rng):
    """A ball thrown up, which breaks a beam of light at the top of its path only."""
    g, V, w = rng.values((5.0, 15.0), (20.0, 60.0), Log(1e-10, 1e-3))
    top = V * V / 2 / g

    def exact(mp, s, p, t):
        met, half = s.y / mp.mpf(p.g), mp.sqrt(mp.mpf(s.y) ** 2 / 2 / p.g - p.h) * mp.sqrt(2 / p.g)
        return s.y * t - p.g * t * t / 2, s.y - p.g * t, _during(mp, t, met - half, met + half)

    way = lambda s, p, t: (s.y, -p.g)
    inside, known = lambda s, p, t: s.x - p.h, {"g": g, "h": top * (1 - w), "w": math.sqrt(w)}
    return _counted(rng, inside, way, exact, (0.0, V), 1.9 * V / g, **known)


@family("narrow", "turning", "kinked")
def spring_at_its_widest(rng):
    """A contact at the turning point of an oscillation, touched once in each of a few periods."""
    n, w = rng.values((0.5, 4.0), Log(1e-7, 1e-2))

    def exact(mp, s, p, t):
        half, period = mp.acos(1 - mp.mpf(p.e)) / p.n, 2 * mp.pi / p.n
        turns = mp.floor(p.n * t / (2 * mp.pi))
        rest = t - turns * period
        met = period / 4
        inside = 2 * half * turns + _during(mp, rest, met - half, met + half)
        return mp.sin(p.n * t), p.n * mp.cos(p.n * t), inside

    inside, way = lambda s, p, t: s.x - 1 + p.e, lambda s, p, t: (s.y, -p.n * p.n * s.x)
    known, T = {"n": n, "e": w, "w": math.sqrt(w) / n}, rng.uniform(2.0, 20.0) / n
    return _counted(rng, inside, way, exact, (0.0, n), T, **known)


@family("narrow", "turning", "kinked")
def ships_in_hail(rng):
    """Two ships that are within hail, by the square of their distance along the quay."""
    u, v, w, T = rng.values((0.5, 3.0), (-3.0, -0.5), Log(1e-5, 1e-1), (3.0, 8.0))
    met = T * rng.uniform(0.3, 0.7)

    def exact(mp, s, p, t):
        apart, speed = mp.mpf(s.y), mp.mpf(p.u) - p.v
        inside = _during(mp, t, (apart - p.w) / speed, (apart + p.w) / speed)
        return p.u * t, s.y + p.v * t, inside

    inside, way = lambda s, p, t: p.w**2 - (s.x - s.y) ** 2, lambda s, p, t: (p.u, p.v)
    known = {"u": u, "v": v, "w": w}
    return _counted(rng, inside, way, exact, (0.0, (u - v) * met), T, **known)


@family("narrow", "turning", "kinked")
def product_of_two_currents(rng):
    """One current grows, the other fades; a fuse counts while their product is at its largest."""
    a, b, T, w = rng.values((0.5, 3.0), (0.5, 3.0), (3.0, 8.0), Log(1e-8, 1e-2))

    def exact(mp, s, p, t):
        met = mp.mpf(s.y) / p.b / 2
        half = mp.sqrt(mp.mpf(s.y) ** 2 / 4 * p.a / p.b - p.h) / mp.sqrt(mp.mpf(p.a) * p.b)
        return p.a * t, s.y - p.b * t, _during(mp, t, met - half, met + half)

    y, way = b * T, lambda s, p, t: (p.a, -p.b)
    inside, known = lambda s, p, t: s.x * s.y - p.h, {"a": a, "b": b, "w": T * math.sqrt(w)}
    known["h"] = y * y / 4 * a / b * (1 - w)
    return _counted(rng, inside, way, exact, (0.0, y), T, **known)


@family("narrow", "turning", "kinked", "forced")
def shutter_by_the_clock(rng):
    """A shutter that is open while a product of two times is positive."""
    w, T = rng.values(Log(1e-5, 1e-1), (5.0, 20.0))
    b = T * rng.uniform(0.2, 0.8)
    exact = lambda mp, s, p, t: (
        s.x * mp.exp(-p.r * t),
        _during(mp, t, mp.mpf(p.b), mp.mpf(p.b) + p.w),
    )
    inside, way = lambda s, p, t: (t - p.b) * (p.b + p.w - t), lambda s, p, t: (-p.r * s.x,)
    return _counted(rng, inside, way, exact, (1.0,), T, w=w, b=b, r=0.2)


@family("narrow", "turning", "kinked")
def corner_of_three_walls(rng):
    """A small triangle that a straight path cuts: three conditions, one inside another."""
    u, w, c = rng.values((0.5, 3.0), Log(1e-6, 1e-1), (3.0, 7.0))
    parameters = {"u": u, "w": w, "c": c, "A": u / w}

    def rates(s, p, t):
        inner = where(s.x + s.y < p.w, p.A, 0.0)
        return p.u, -p.u / 2, where(s.x > 0, where(s.y > -p.w, inner, 0.0), 0.0)

    def exact(mp, s, p, t):
        begin = -s.x / mp.mpf(p.u)
        end = min((s.y + mp.mpf(p.w)) * 2 / p.u, (mp.mpf(p.w) - s.x - s.y) * 2 / p.u)
        return s.x + p.u * t, s.y - p.u * t / 2, s.q + p.A * _during(mp, t, begin, max(begin, end))

    start = -c, c / 2 + w * rng.uniform(-0.8, 0.9), rng.choice((0.0, 1.0))
    return by_rates(rates, parameters, "x y q", 10.0 / u, start, exact=exact)


def _mound(rng, shape, area, **more):
    """``q`` is the area of a shape of width w along the path so far."""
    v, w, c = rng.values((0.5, 3.0), more.pop("width", WIDTH), (3.0, 7.0))
    parameters = {"v": v, "w": w, "c": c, "A": v / w}
    rates = lambda s, p, t: (p.v, p.A * shape((s.x - p.c) / p.w))

    def exact(mp, s, p, t):
        return p.v * t, s.q + mp.mpf(p.A) * p.w / p.v * area(mp, (p.v * t - p.c) / mp.mpf(p.w))

    start = 0.0, rng.choice((0.0, 1.0))
    return by_rates(rates, parameters, "x q", 10.0 / v, start, exact=exact)


@family("narrow", "turning", "kinked")
def mound_by_an_absolute_value(rng):
    """A parabola cut off at zero by its own absolute value."""
    half = lambda mp, z: min(max(z, -1), 1)
    area = lambda mp, z: half(mp, z) - half(mp, z) ** 3 / 3 + mp.mpf(2) / 3
    g = lambda z: (1 - z) * (1 + z)
    return _mound(rng, lambda z: (g(z) + abs(g(z))) / 2, area)


@family("narrow", "turning", "kinked")
def dome_by_a_root(rng):
    """A half disc, whose height is a root of what is cut off at zero."""

    def area(mp, z):
        z = min(max(z, mp.mpf(-1)), mp.mpf(1))
        return (z * mp.sqrt(1 - z * z) + mp.asin(z) + mp.pi / 2) / 2

    shape = lambda z: sqrt(where(1 - z * z > 0, 1 - z * z, 0.0))
    return _mound(rng, shape, area, width=Log(1e-5, 1e-1))


@family("narrow", "turning")
def hill_of_a_fourth_power(rng):
    """1/(1 + z**4), smooth, with flanks on both sides."""

    def area(mp, z):
        r = mp.sqrt(2)
        part = mp.log((z * z + r * z + 1) / (z * z - r * z + 1)) / 2
        return (part + mp.atan(r * z + 1) + mp.atan(r * z - 1) + mp.pi) / (2 * r)

    v, w, c = rng.values((0.5, 3.0), Log(1e-4, 1e-1), (3.0, 7.0))
    parameters = {"v": v, "w": w, "c": c}
    rates = lambda s, p, t: (p.v, p.v / p.w / (1 + ((s.x - p.c) / p.w) ** 4))

    def exact(mp, s, p, t):
        low, high = (area(mp, (p.v * x - p.c) / mp.mpf(p.w)) for x in (mp.mpf(0), t))
        return p.v * t, s.q + high - low

    start = 0.0, rng.choice((0.0, 1.0))
    return by_rates(rates, parameters, "x q", 10.0 / v, start, exact=exact)


@family("narrow", "turning")
def flash_of_a_lighthouse(rng):
    """A boat is lit in each turn of the lamp for a short time."""
    n, w = rng.values((2.0, 10.0), Log(1e-4, 1e-1))
    parameters = {"n": n, "w": w, "at": rng.uniform(1.0, 5.0), "A": n / w}
    rates = lambda s, p, t: (p.n, where(cos(s.x - p.at) > p.c, p.A, 0.0))
    parameters["c"] = math.cos(w)

    def exact(mp, s, p, t):
        half = mp.acos(mp.mpf(p.c))
        turns = mp.floor((p.n * t - p.at + mp.pi) / (2 * mp.pi))
        rest = p.n * t - p.at - 2 * mp.pi * turns
        lit = 2 * half * turns + _during(mp, rest, -half, half)
        return p.n * t, s.q + p.A / p.n * lit

    T = (parameters["at"] + rng.uniform(1.0, 20.0)) / n
    return by_rates(rates, parameters, "x q", T, (0.0, rng.choice((0.0, 1.0))), exact=exact)


# -- from nothing


@family("kinked", "turning")
def heater_that_is_switched_on(rng):
    """Nothing is warm before a switch: heat, then a second body, then the angle of a pointer."""
    v, c, a, k = rng.values((0.5, 3.0), (3.0, 7.0), Log(1e-6, 1e3), (0.1, 2.0))
    rates = lambda s, p, t: (p.v, where(s.x > p.c, p.a, 0.0), p.k * s.q, s.r)

    def exact(mp, s, p, t):
        on = max(t - p.c / mp.mpf(p.v), mp.mpf(0))
        return p.v * t, p.a * on, p.k * p.a * on**2 / 2, p.k * p.a * on**3 / 6

    T, start = 10.0 / v, (0.0, 0.0, 0.0, 0.0)
    return by_rates(rates, {"v": v, "c": c, "a": a, "k": k}, "x q r phi", T, start, exact=exact)


@family("kinked", "turning", "forced")
def push_from_rest(rng):
    """A mass at rest at the origin, pushed from some time on by a force that jumps or grows."""
    T, f, r = rng.values((1.0, 1e4), Log(1e-8, 1e4), (0.1, 3.0))
    parameters = {"b": T * rng.uniform(0.2, 0.8), "f": f, "r": r / T, "x": rng.choice((0.0, 1.0))}

    def rates(s, p, t):
        late = where(s.c > p.b, s.c - p.b, 0.0)
        jump = where(s.c > p.b, p.f, 0.0)
        return 1.0 + 0.0 * s.c, s.v, p.x * p.f * late * p.r + (1 - p.x) * jump

    def exact(mp, s, p, t):
        on = max(t - p.b, mp.mpf(0))
        if p.x:
            return t, p.f * p.r * on**3 / 6, p.f * p.r * on**2 / 2
        return t, p.f * on**2 / 2, p.f * on

    return by_rates(rates, parameters, "c y v", T, (0.0, 0.0, 0.0), exact=exact)


# -- events, and tables of positions


def _passed(rng, function, times, width):
    """A straight path of 10 m with an event of width w somewhere on it."""
    v, w, c = rng.values((0.5, 3.0), width, (3.0, 7.0))
    parameters = {"v": v, "w": w, "c": c}
    rates, exact = lambda s, p, t: (p.v + 0.0 * s.x,), lambda mp, s, p, t: (s.x + p.v * t,)
    at = lambda mp, s, p: [(p.c + mp.mpf(p.w) * z) / p.v for z in times(mp)]
    known = {"exact": exact, "events": (Event(function),), "event_times": at}
    return by_rates(rates, parameters, "x", 10.0 / v, (0.0,), **known)


@family("events", "turning", "narrow")
def marks_that_are_close(rng):
    """The passage of two marks close together, written as one function."""
    function = lambda s, p, t: (s.x - p.c) * (p.c + p.w - s.x)
    return _passed(rng, function, lambda mp: (0, 1), Log(1e-5, 1e-1))


@family("events", "turning", "narrow")
def level_of_a_peak(rng):
    """A smooth peak that rises above a level."""
    function = lambda s, p, t: exp(-(((s.x - p.c) / p.w) ** 2)) - 0.5
    times = lambda mp: (-mp.sqrt(mp.log(2)), mp.sqrt(mp.log(2)))
    return _passed(rng, function, times, Log(1e-4, 1e-1))


@family("events", "turning", "narrow")
def level_of_a_resonance(rng):
    """A resonance curve, a quotient, that rises above a level."""
    function = lambda s, p, t: 1 / (1 + ((s.x - p.c) / p.w) ** 2) - 0.25
    times = lambda mp: (-mp.sqrt(3), mp.sqrt(3))
    return _passed(rng, function, times, Log(1e-4, 1e-1))


@family("tables", "turning", "narrow")
def table_with_a_spike(rng):
    """A table of position, flat but for a spike, of five points or of more than a hundred."""
    v, w, c = rng.values((0.5, 3.0), Log(1e-4, 1e-1), (3.0, 7.0))
    high, places = v / w * rng.uniform(0.2, 2.0), [-1.0, c - w, c, c + w, 11.0]
    if rng.random() < 0.5:
        places = sorted({*places, *(0.1 * k - 0.5 for k in range(110))})
    f = table(places, [high if x == c else 0.0 for x in places])
    rates = lambda s, p, t: (p.v, f(s.x))

    def exact(mp, s, p, t):
        k, x = places.index(c), p.v * t
        low, top = mp.mpf(places[k - 1]), mp.mpf(places[k + 1])
        up, down = min(max(x, low), c) - low, min(max(x, c), top) - c
        area = high * (up**2 / (c - low) / 2 + down - down**2 / (top - c) / 2)
        return x, s.q + area / p.v

    start = 0.0, rng.choice((0.0, 1.0))
    return by_rates(rates, {"v": v}, "x q", 10.0 / v, start, exact=exact)
