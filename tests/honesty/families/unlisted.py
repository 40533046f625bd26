"""Cases on no list of faults, written before the methods were read, by someone other than their
author.
"""

import math

from newton_euler import Event, Model, cos, exp, sin, sqrt, tanh, where
from tests.honesty import closed_forms
from tests.honesty.cases import Case, Log, around, by_accelerations, by_rates, family


@family("narrow")
def dose_under_two_beams(rng):
    """The dose at a spot, narrower in one direction, for a body that swings in two."""
    a, b, T, met = rng.values((0.5, 2.0), (0.5, 2.0), (5.0, 15.0), (0.3, 0.7))
    met *= T
    wx, wy = rng.values(Log(1e-5, 1e-1), Log(1e-4, 1.0))
    parameters = {"a": a, "b": b, "wx": wx, "wy": wy, "A": 0.3 / min(wx, wy)}
    parameters |= {"px": math.cos(a * met) + 0.3 * wx, "py": math.sin(b * met) - 0.2 * wy}

    def rates(s, p, t):
        near = exp(-(((s.x - p.px) / p.wx) ** 2)) * exp(-(((s.y - p.py) / p.wy) ** 2))
        return s.u, -p.a * p.a * s.x, s.v, -p.b * p.b * s.y, p.A * near

    times = [n * math.pi + e * math.acos(math.cos(a * met)) for n in range(-1, 30) for e in (1, -1)]
    pace = max(abs(math.sin(a * met)) * a, 0.02)
    knots = [k for t in times for k in around(t / a, wx / pace / 2, 16)]
    start = 1.0, 0.0, 0.0, b, 0.0
    return by_rates(rates, parameters, "x u y v D", T, start, knots=knots)


@family("narrow")
def reaction_at_a_product(rng):
    """A reaction that goes on only while the product of two amounts is near one value."""
    a, b, T, w = rng.values((0.5, 2.0), (0.1, 0.4), (3.0, 6.0), Log(1e-6, 1e-2))
    parameters = {"a": a, "b": b}
    met, rise = T * rng.uniform(0.3, 0.7), a - b
    level = 2 * math.exp(-rise * met)
    parameters |= {"c": level, "w": w * level, "A": rng.uniform(0.2, 2.0) / w}

    def rates(s, p, t):
        return -p.a * s.x, p.b * s.y, p.A / (1 + ((s.x * s.y - p.c) / p.w) ** 2) ** 2 * (1 - s.z)

    knots = around(met, w / rise / 2, 40)
    return by_rates(rates, parameters, "x y z", T, (1.0, 2.0, 0.0), knots=knots)


@family("narrow", "forced")
def stroke_of_a_late_clock(rng):
    """A stroke by a clock that is a state and shows a hundred to a million at the start."""
    begun, T, w, k = rng.values(Log(1e2, 1e6), (5.0, 30.0), Log(1e-4, 1e-1), (0.5, 4.0))
    met = T * rng.uniform(0.2, 0.8)
    parameters = {"k": k, "w": w, "F": rng.uniform(0.2, 2.0) / w, "at": begun + met}

    def rates(s, p, t):
        z = (s.c - p.at) / p.w
        return s.v, -p.k * s.x - p.F * z * exp(-z * z), 1 + 0 * s.x

    start = 0.5, 0.0, begun
    return by_rates(rates, parameters, "x v c", T, start, knots=around(met, w / 2, 24))


@family("narrow", "stiff")
def stiff_with_a_spike(rng):
    """A fast relaxation towards a slow signal, hit by a spike."""
    L, T, w = rng.values(Log(1e3, 1e6), (3.0, 10.0), Log(1e-5, 1e-1))
    at = T * rng.uniform(0.3, 0.7)
    parameters = {"L": L, "w": w, "at": at, "A": rng.uniform(0.2, 2.0) / w}

    def rates(s, p, t):
        z = (t - p.at) / p.w
        hit = p.A * (1 - tanh(z) ** 2)
        return -p.L * (s.y - cos(t)) + hit, hit - 0.3 * s.z

    knots = (*around(at, w / 2, 40), T * 1e-6, T * 1e-4)
    return by_rates(rates, parameters, "y z", T, (0.0, 0.5), knots=knots)


@family("multi-scale", "closed form")
def quake_of_a_star(rng):
    """An oscillation of 1e8 to 1e12 shakes a detector by 1e-12 to 1e-6."""
    w, W, size, small = rng.values((0.5, 2.0), (2.5, 5.0), Log(1e8, 1e12), Log(1e-12, 1e-6))
    parameters = {"k": w * w, "K": W * W, "q": small / size}
    a = lambda s, p, t: (-p.k * s.x, -p.K * s.y + p.q * s.x)

    def exact(mp, s, p, t):
        n, N, f = mp.sqrt(p.k), mp.sqrt(p.K), p.q * s.x
        x, dx = closed_forms.oscillator(mp, n, s.x, s.dx, t)
        y, dy = closed_forms.driven(mp, N, f, n, s.y, s.dy, t)
        return x, y, dx, dy

    start = (size, rng.choice((0.0, small)), 0.0, 0.0)
    return by_accelerations(a, parameters, "x y", rng.uniform(5, 40), start, exact=exact)


@family("kinked", "closed form")
def start_at_a_kink(rng):
    """A mass between two springs starts where one ends and the other begins, at rest or moving."""
    n, N, v, f = rng.values((0.3, 3.0), (0.3, 30.0), (-2.0, 2.0), (-1.0, 1.0))
    v *= rng.choice((0, 1))
    parameters = {"k": n * n, "K": N * N, "f": f}
    a = lambda s, p, t: (where(s.x > 0, -p.k * s.x, -p.K * s.x) + p.f * where(s.x >= 0, 1, 1),)

    def exact(mp, s, p, t):
        x, v = s.x, s.dx
        while True:
            right = v > 0 or (v == 0 and p.f > 0)
            w = mp.sqrt(p.k if right else p.K)
            rest = p.f / w**2
            whole = 2 * mp.pi / w
            if rest and v == 0:
                passed = whole
            else:  # it is back at x = 0 with the opposite speed
                phase = mp.atan2(v / w, -rest)  # of x - rest = R cos(w t - phase)
                passed = 2 * phase / w
                passed = passed + whole if passed <= 0 else passed
            if t <= passed:
                y, u = closed_forms.oscillator(mp, w, x - rest, v, t)
                return y + rest, u
            t, x, v = t - passed, mp.mpf(0), -v

    return by_accelerations(a, parameters, "x", rng.uniform(3.0, 30.0), (0.0, v), exact=exact)


@family("kinked", "closed form")
def root_that_touches_zero(rng):
    """A root whose argument only touches zero, once in each period."""
    q, T = rng.values((0.3, 2.0), (10.0, 40.0))
    rates = lambda s, p, t: (-p.q * s.y, p.q * s.x, sqrt(abs(1 - s.x)), abs(1 - s.y))

    def exact(mp, s, p, t):
        a = p.q * t
        turns = mp.floor(a / (2 * mp.pi))
        z = (1 - mp.cos((a - 2 * mp.pi * turns) / 2) + 2 * turns) * 2 * mp.sqrt(2) / p.q
        return mp.cos(a), mp.sin(a), z, t - (1 - mp.cos(a)) / p.q

    return by_rates(rates, {"q": q}, "x y z u", T / q, (1.0, 0.0, 0.0, 0.0), exact=exact)


@family("events")
def ball_that_begins_on_the_floor(rng):
    """A ball thrown up from the floor, which it meets again and again."""
    e, v = rng.values((0.5, 0.95), Log(0.1, 100.0))
    then = lambda s, p, t: (model, (0.0, -p.e * s.v))
    model = Model("from the floor", {"g": 9.81, "e": e}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    bounces, hit = rng.randint(1, 7), 2 * v / 9.81
    T = hit * (sum(e**n for n in range(bounces)) + e**bounces * rng.uniform(0.2, 0.8))
    floor = Event(lambda s, p, t: s.h, rng.choice((0, -1)), then=then, name="floor")
    return Case(model, T, (0.0, v), events=(floor,))


@family("long", "closed form")
def slow_end_of_a_reaction(rng):
    """A reaction of the second order, until 1e-3 to 1e-12 of its substance is left."""
    k, y, left = rng.values(Log(1e-3, 1e3), Log(1e-3, 1e3), Log(1e3, 1e12))

    def exact(mp, s, p, t):
        n = 1 + p.k * s.y * t
        return s.y / n, s.made + mp.log(n)

    T = left / k / y
    return by_rates(
        lambda s, p, t: (-p.k * s.y**2, p.k * s.y), {"k": k}, "y made", T, (y, 0.0), exact=exact
    )


@family("narrow", "closed form")
def film_that_runs_back(rng):
    """A brake that is met from behind: the time and position in it run backwards."""
    v, w, c, T = rng.values((0.5, 3.0), Log(1e-5, 1e-1), (0.3, 0.7), (5.0, 20.0))
    parameters = {"v": v, "w": w * v * T, "c": c * v * T, "T": T}
    parameters["A"] = rng.uniform(0.1, 2.0) / w / T

    def rates(s, p, t):
        back = p.T - t
        return -p.v, p.A * exp(-(((p.v * back - p.c) / p.w) ** 2)) * s.y, s.y * sin(back)

    knots = around((1 - c) * T, w * T / 2, 24)
    return by_rates(rates, parameters, "x y z", T, (v * T, 1.0, 0.0), knots=knots)


@family("singular", "closed form")
def parameters_at_their_limits(rng):
    """Masses of 1e-150 or 1e150, no damping, no gravity, an all but infinite length."""
    n, size = rng.values((0.3, 3.0), rng.choice((1e-150, 1e-30, 1e30, 1e150)))
    parameters = {"k": n * n * size, "m": size, "c": 0.0, "g": 0.0, "W": rng.choice((1e150, 1e300))}

    def accelerations(s, p, t):
        pull = p.k * s.x * exp(-((s.x / p.W) ** 2)) + p.c * s.dx * sqrt(s.dx * s.dx)
        return (-pull / p.m - p.g * sin(s.x / p.W),)

    exact = lambda mp, s, p, t: closed_forms.oscillator(mp, mp.sqrt(p.k / p.m), s.x, s.dx, t)
    T, start = rng.uniform(5.0, 40.0) / n, (rng.uniform(0.2, 2.0), 0.0)
    return by_accelerations(accelerations, parameters, "x", T, start, exact=exact)


@family("kinked", "closed form")
def spring_of_a_power(rng):
    """A force as a fractional power of the distance, for swings through zero."""
    power, x = rng.choice((0.5, 0.7, 1.5, 2.5, 0.8, 1.2)), rng.uniform(0.3, 2.0)
    a = lambda s, p, t: (-where(s.x > 0, 1, -1) * abs(s.x) ** p.n,)

    def exact(mp, s, p, t):  # x**(n + 1) is 1 - u*u of its first value; time is an integral over u
        b, n = 1 / (p.n + 1), p.n + 1
        pace = s.x * b / mp.sqrt(2 * s.x**n * b)
        passed = lambda u: pace * mp.betainc(b, 0.5, 1 - u * u, 1)
        turn = 4 * passed(1)
        part = t - turn * mp.nint(t / turn)  # from -1/2 to 1/2 of a period
        side = 1 if abs(part) < turn / 4 else -1
        past = part if side > 0 else part - mp.sign(part) * turn / 2  # since it was farthest out
        u = mp.findroot(lambda u: passed(u) - abs(past), (0, 1), solver="anderson")
        size = s.x * (1 - u * u) ** b
        return side * size, -side * mp.sign(past) * u * mp.sqrt(2 * s.x**n * b)

    return by_accelerations(a, {"n": power}, "x", rng.uniform(5.0, 30.0), (x, 0.0), exact=exact)


@family("narrow")
def quotient_of_two_amounts(rng):
    """A valve is open while the ratio of two amounts is within a per cent or less of a value."""
    a, T, w, b = rng.values((0.2, 1.0), (3.0, 8.0), Log(1e-6, 1e-2), (0.5, 2.0))
    met = T * rng.uniform(0.3, 0.7)
    y = lambda t: 1 + b * t
    ratio = math.exp(-a * met) / y(met)
    parameters = {"a": a, "b": b, "r": ratio, "w": w, "A": rng.uniform(0.2, 1.0) / w}

    def rates(s, p, t):
        opened = tanh((s.x / s.y / p.r - 1 + p.w) / (0.2 * p.w))
        closed = tanh((s.x / s.y / p.r - 1 - p.w) / (0.2 * p.w))
        return -p.a * s.x, p.b, p.A * (opened - closed) / 2 * (1 - s.z)

    wide = w / (a + b / y(met))
    knots = around(met, wide / 8, 60)
    return by_rates(rates, parameters, "x y z", T, (1.0, 1.0, 0.0), knots=knots)


@family("narrow", "stiff")
def bow_on_a_string(rng):
    """Friction that peaks at a very small speed, which a string passes at each turn."""
    k, mu, vs, v = rng.values((1.0, 20.0), (0.05, 0.3), Log(1e-4, 1e-2), (0.5, 2.0))
    parameters = {"k": k, "mu": mu, "vs": vs, "d": rng.uniform(0.2, 1.0)}

    def accelerations(s, p, t):
        z = s.dx / p.vs
        return (-p.k * s.x - p.mu * tanh(z) * (1 + p.d * exp(-z * z)),)

    turns = [n * math.pi / math.sqrt(k) for n in range(3)]
    # until it has turned twice
    T, start = turns[-1] + rng.uniform(0.2, 0.8) / math.sqrt(k), v + 2 * mu / math.sqrt(k)
    knots = (x for t in turns for x in around(t, vs / k / v / 2, 40))
    return by_accelerations(accelerations, parameters, "x", T, (-start, 0.0), knots=knots)
