"""Formulas as people write them: tables by nested conditions, limits, roots, powers, signs."""

import math

from newton_euler import Model, cos, exp, log, sqrt, tanh, where
from newton_euler.motion import second_order
from tests.honesty.cases import Branches, Case, decades, either, held_out


def _sign(x):
    return where(x > 0, 1.0, where(x < 0, -1.0, 0.0))


def _smaller(a, b):
    return where(a < b, a, b)


def _larger(a, b):
    return where(a > b, a, b)


@held_out("kinked")
def engine_by_a_table(rng):
    """A car whose torque is a table of five points in the speed, interpolated by nested where."""
    f = [rng.uniform(1.0, 3.0) for _ in range(5)]
    parameters = {f"f{i}": x for i, x in enumerate(f)} | {"d": rng.uniform(3.0, 8.0), "c": 2e-3}

    def table(v, p):
        u = v / p.d
        return where(
            u < 1,
            p.f0 + (p.f1 - p.f0) * u,
            where(
                u < 2,
                p.f1 + (p.f2 - p.f1) * (u - 1),
                where(u < 3, p.f2 + (p.f3 - p.f2) * (u - 2), p.f3 + (p.f4 - p.f3) * (u - 3)),
            ),
        )

    def pieces(s, p, t, b):
        u = s.v / p.d
        force = p.f0 + (p.f1 - p.f0) * u
        force += (1 + b[0]) / 2 * (p.f2 - 2 * p.f1 + p.f0) * (u - 1)
        force += (1 + b[1]) / 2 * (p.f3 - 2 * p.f2 + p.f1) * (u - 2)
        force += (1 + b[2]) / 2 * (p.f4 - 2 * p.f3 + p.f2) * (u - 3)
        return s.v, force - p.c * s.v * s.v

    switches = tuple(lambda s, p, t, n=n: s.v - n * p.d for n in (1, 2, 3))
    return Case(
        Model(
            "engine", parameters, ("x", "v"), lambda s, p, t: (s.v, table(s.v, p) - p.c * s.v**2)
        ),
        rng.uniform(3.0, 40.0),
        (0.0, 0.0),
        branches=Branches(switches, pieces),
    )


@held_out("kinked")
def gears(rng):
    """Three gears: the force jumps at two speeds."""
    parameters = {
        "F1": rng.uniform(4.0, 6.0),
        "F2": rng.uniform(2.0, 3.5),
        "F3": rng.uniform(1.0, 1.8),
        "v1": rng.uniform(5.0, 10.0),
        "v2": rng.uniform(13.0, 20.0),
        "c": decades(rng, 1e-5, 1e-3),
    }

    def rates(s, p, t):
        force = where(s.v < p.v1, p.F1, where(s.v < p.v2, p.F2, p.F3))
        return s.v, force - p.c * s.v * abs(s.v)

    def pieces(s, p, t, b):
        force = (p.F1 * (1 - b[0]) + (1 + b[0]) * (p.F2 * (1 - b[1]) + p.F3 * (1 + b[1])) / 2) / 2
        return s.v, force - p.c * s.v * s.v * b[2]

    switches = (
        lambda s, p, t: s.v - p.v1,
        lambda s, p, t: s.v - p.v2,
        lambda s, p, t: s.v,
    )
    return Case(
        Model("gears", parameters, ("x", "v"), rates),
        rng.uniform(2.0, 30.0),
        (0.0, rng.uniform(0.0, 3.0)),
        branches=Branches(switches, pieces),
    )


@held_out("kinked")
def drag_with_a_crisis(rng):
    """A sphere whose drag stops growing above some speed, by the smaller of two."""
    parameters = {"g": 9.81, "c": rng.uniform(0.01, 0.1), "most": rng.uniform(1.0, 8.0)}

    def rates(s, p, t):
        drag = _smaller(p.c * s.v * s.v, p.most) * _sign(s.v)
        return s.v, -p.g - drag

    def pieces(s, p, t, b):
        drag = ((1 - b[0]) * p.c * s.v * s.v + (1 + b[0]) * p.most) / 2
        return s.v, -p.g - b[1] * drag

    switches = lambda s, p, t: p.c * s.v * s.v - p.most, lambda s, p, t: s.v
    v = rng.uniform(5.0, 40.0)
    return Case(
        Model("sphere", parameters, ("h", "v"), rates),
        v / 9.81 * rng.uniform(0.5, 2.5),
        (0.0, v),
        branches=Branches(switches, pieces),
    )


@held_out("stiff")
def friction_with_a_small_speed(rng):
    """Coulomb's friction as v / sqrt(v^2 + e^2) under a spring: swings, then creeping."""
    k, mu = rng.uniform(1.0, 20.0), rng.uniform(0.05, 0.5)
    parameters = {"k": k, "mu": mu, "e": decades(rng, 1e-4, 1e-1)}

    def accelerations(s, p, t):
        return (-p.k * s.x - p.mu * s.dx / sqrt(s.dx * s.dx + p.e * p.e),)

    return Case(
        second_order("regularised friction", parameters, ("x",), accelerations),
        rng.uniform(0.5, 3.0) * 2 * math.pi / k**0.5,
        (rng.uniform(1.0, 5.0) * mu / k * 3, 0.0),
    )


@held_out("stiff")
def stribeck_belt(rng):
    """A block on a belt with Stribeck's curve times tanh(v/e): it sticks and slips."""
    parameters = {
        "k": rng.uniform(2.0, 20.0),
        "belt": rng.uniform(0.1, 0.5),
        "Fc": rng.uniform(0.5, 1.0),
        "Fs": rng.uniform(1.2, 2.0),
        "vs": rng.uniform(0.1, 0.4),
        "e": decades(rng, 3e-3, 3e-2),
        "c": 0.05,
    }

    def accelerations(s, p, t):
        v = s.dx - p.belt
        curve = p.Fc + (p.Fs - p.Fc) * exp(-((v / p.vs) ** 2))
        return (-p.k * s.x - p.c * s.dx - curve * tanh(v / p.e),)

    return Case(
        second_order("belt", parameters, ("x",), accelerations),
        rng.uniform(2.0, 10.0),
        (0.0, rng.choice((0.0, parameters["belt"]))),
    )


@held_out("kinked")
def root_spring(rng):
    """A force that goes with the root of the displacement, abs(x)**0.5, and changes its sign."""
    k, x = decades(rng, 0.1, 30.0), rng.uniform(0.3, 2.0)

    def exact(mp, s, p, t):
        # x = A sin(phi)^(4/3), v = V cos(phi), so that dt = 4 A/(3 V) sin(phi)^(1/3) dphi
        A, V = s.x, mp.sqrt(4 * p.k / mp.mpf(3) * mp.sqrt(s.x) ** 3)

        def passed(phi):
            z = mp.sin(phi)
            return A / V * mp.cbrt(z) ** 4 * mp.hyp2f1(0.5, mp.mpf(2) / 3, mp.mpf(5) / 3, z * z)

        quarter = passed(mp.pi / 2)
        turn = mp.floor((t + quarter) / (2 * quarter))
        since = t + quarter - 2 * quarter * turn
        back, goal = since > quarter, min(since, 2 * quarter - since)
        low, high = mp.mpf(0), mp.pi / 2
        phi = high * mp.sqrt(goal / quarter)
        for _ in range(300):  # Newton's method, kept between the bounds
            lacks = passed(phi) - goal
            low, high = (phi, high) if lacks < 0 else (low, phi)
            new = phi - lacks * 3 * V / (4 * A * mp.cbrt(mp.sin(phi))) if phi else phi
            new = new if low < new < high else (low + high) / 2
            if abs(new - phi) < 8 * mp.eps:
                break
            phi = new
        side = -1 if turn % 2 else 1
        return side * A * mp.cbrt(mp.sin(phi)) ** 4, side * V * mp.cos(phi) * (-1 if back else 1)

    return Case(
        second_order(
            "root spring", {"k": k}, ("x",), lambda s, p, t: (-p.k * _sign(s.x) * abs(s.x) ** 0.5,)
        ),
        rng.uniform(2.0, 20.0) * x**0.25 / k**0.5,
        (x, 0.0),
        exact=exact,
    )


@held_out("near-singular")
def root_of_the_distance(rng):
    """A force that goes with the root of the distance, past its centre."""

    def accelerations(s, p, t):
        r = (s.x**2 + s.y**2) ** 0.5
        f = -p.k * r**0.5 / r
        return f * s.x, f * s.y

    return Case(
        second_order("root force", {"k": decades(rng, 0.1, 30.0)}, ("x", "y"), accelerations),
        rng.uniform(1.0, 5.0),
        (rng.uniform(0.3, 2.0), 0.0, 0.0, decades(rng, 1e-2, 0.5)),
    )


@held_out("kinked")
def ball_by_hertz(rng):
    """A ball that bounces on a contact force max(d, 0)**1.5 with preload, and with hysteresis as
    Hunt and Crossley have it.
    """
    parameters = {"g": 9.81, "k": decades(rng, 1e3, 1e5), "a": rng.uniform(0.0, 0.3), "d0": 1e-3}

    def rates(s, p, t):
        d = _larger(-s.h, 0.0)
        return s.v, p.k * ((d + p.d0) ** 1.5 - p.d0**1.5) * (1 - p.a * s.v) - p.g

    def pieces(s, p, t, b):
        d = -s.h * (1 - b[0]) / 2
        return s.v, p.k * ((d + p.d0) ** 1.5 - p.d0**1.5) * (1 - p.a * s.v) - p.g

    h = rng.uniform(0.2, 1.0)
    return Case(
        Model("Hertz", parameters, ("h", "v"), rates),
        math.sqrt(2 * h / 9.81) * rng.uniform(1.3, 4.0),
        (h, 0.0),
        branches=Branches((lambda s, p, t: s.h,), pieces),
    )


@held_out("mechanics")
def drag_with_a_power(rng):
    """A shot whose drag goes with the speed to a power between 1 and 2."""
    parameters = {"g": 9.81, "c": decades(rng, 1e-3, 1e-1), "n": rng.uniform(1.1, 1.9)}

    def accelerations(s, p, t):
        v = sqrt(s.dx**2 + s.dy**2)
        d = p.c * v ** (p.n - 1)
        return -d * s.dx, -p.g - d * s.dy

    v, a = rng.uniform(10.0, 100.0), rng.uniform(0.2, 1.3)
    return Case(
        second_order("power of the speed", parameters, ("x", "y"), accelerations),
        rng.uniform(1.0, 10.0),
        (0.0, 0.0, v * math.cos(a), v * math.sin(a)),
    )


@held_out("stiff")
def floor_by_softplus(rng):
    """A bounce on log(1 + exp(-h/w)), a floor that is smooth but thin."""
    parameters = {"g": 9.81, "k": decades(rng, 1e2, 1e4), "w": decades(rng, 3e-3, 3e-2), "one": 1.0}

    def rates(s, p, t):
        return s.v, p.k * p.w * log(p.one + exp(-s.h / p.w)) - p.g

    h = rng.uniform(0.2, 1.0)
    return Case(
        Model("softplus", parameters, ("h", "v"), rates),
        math.sqrt(2 * h / 9.81) * rng.uniform(1.3, 6.0),
        (h, 0.0),
    )


@held_out("kinked", "forced")
def backlash_by_abs(rng):
    """Motor and load with play between them, as (|d + b| - |d - b|)/2."""
    parameters = {
        "k": decades(rng, 10.0, 1e3),
        "b": rng.uniform(0.01, 0.1),
        "J": rng.uniform(0.3, 3.0),
        "c": rng.uniform(0.05, 0.5),
        "M": rng.uniform(0.5, 2.0),
        "w": rng.uniform(0.5, 3.0),
    }

    def accelerations(s, p, t):
        d = s.a - s.l
        twist = d - (abs(d + p.b) - abs(d - p.b)) / 2
        return p.M * cos(p.w * t) - p.k * twist - p.c * s.da, (p.k * twist - p.c * s.dl) / p.J

    def pieces(s, p, t, b):
        d = s.a - s.l
        twist = d - (b[0] * (d + p.b) - b[1] * (d - p.b)) / 2
        return (
            s.da,
            s.dl,
            p.M * cos(p.w * t) - p.k * twist - p.c * s.da,
            (p.k * twist - p.c * s.dl) / p.J,
        )

    switches = lambda s, p, t: s.a - s.l + p.b, lambda s, p, t: s.a - s.l - p.b
    return Case(
        second_order("backlash", parameters, ("a", "l"), accelerations),
        rng.uniform(3.0, 8.0),
        (0.0, 0.0, 0.0, 0.0),
        branches=Branches(switches, pieces),
    )


@held_out("kinked", "forced")
def pulses_by_where(rng):
    """At rest, then two short rectangular pushes, then free: jumps while all is zero."""
    T = rng.uniform(10.0, 40.0)
    parameters = {
        "k": rng.uniform(0.5, 5.0),
        "c": rng.uniform(0.0, 0.2),
        "F": rng.uniform(0.5, 5.0),
        "t1": T * rng.uniform(0.1, 0.3),
        "t2": T * rng.uniform(0.45, 0.7),
        "w": T * decades(rng, 0.015, 0.1),
    }

    def accelerations(s, p, t):
        first = where(t > p.t1, where(t < p.t1 + p.w, p.F, 0.0), 0.0)
        second = where(t > p.t2, where(t < p.t2 + p.w, -p.F, 0.0), 0.0)
        return (first + second - p.k * s.x - p.c * s.dx,)

    def pieces(s, p, t, b):
        push = (b[0] - b[1] - b[2] + b[3]) / 2 * p.F
        return s.dx, push - p.k * s.x - p.c * s.dx

    switches = (
        lambda s, p, t: t - p.t1,
        lambda s, p, t: t - p.t1 - p.w,
        lambda s, p, t: t - p.t2,
        lambda s, p, t: t - p.t2 - p.w,
    )
    edges = [parameters[n] + k * parameters["w"] for n in ("t1", "t2") for k in (0, 1)]
    knots = tuple(x + d * parameters["w"] for x in edges for d in (-0.3, 0.3))
    return Case(
        second_order("two pushes", parameters, ("x",), accelerations),
        T,
        (0.0, 0.0),
        branches=Branches(switches, pieces),
        knots=knots,
    )


@held_out("kinked", "forced")
def cam_of_cosines(rng):
    """A valve on a cam: it rests, is lifted by half a cosine, and rests again (nested where)."""
    parameters = {
        "k": decades(rng, 20.0, 500.0),
        "c": rng.uniform(0.5, 3.0),
        "h": rng.uniform(0.005, 0.05),
        "t1": rng.uniform(0.5, 1.5),
        "t2": rng.uniform(2.0, 4.0),
    }

    def accelerations(s, p, t):
        u = 2 * math.pi * (t - p.t1) / (p.t2 - p.t1)
        lift = where(t < p.t1, 0.0, where(t > p.t2, 0.0, p.h * (1 - cos(u)) / 2))
        return (p.k * (lift - s.x) - p.c * s.dx,)

    def pieces(s, p, t, b):
        u = 2 * math.pi * (t - p.t1) / (p.t2 - p.t1)
        lift = (1 + b[0]) * (1 - b[1]) / 4 * p.h * (1 - cos(u)) / 2
        return s.dx, p.k * (lift - s.x) - p.c * s.dx

    switches = lambda s, p, t: t - p.t1, lambda s, p, t: t - p.t2
    return Case(
        second_order("cam", parameters, ("x",), accelerations),
        rng.uniform(3.0, 7.0),
        (0.0, 0.0),
        branches=Branches(switches, pieces),
    )


@held_out("kinked", "sticking")
def two_tanks(rng):
    """Two tanks through a hole: sign(h1 - h2) sqrt(|h1 - h2|), until they are level."""
    parameters = {"c": decades(rng, 1e-3, 1.0)}

    def rates(s, p, t):
        d = s.h1 - s.h2
        q = p.c * _sign(d) * sqrt(abs(d))
        return -q, q

    def exact(mp, s, p, t):
        d, mean = s.h1 - s.h2, (s.h1 + s.h2) / 2
        now = mp.sign(d) * max(mp.sqrt(abs(d)) - p.c * t, mp.mpf(0)) ** 2
        return mean + now / 2, mean - now / 2

    h = [k / 64 for k in rng.sample(range(8, 200), 2)]
    level = abs(h[0] - h[1]) ** 0.5 / parameters["c"]
    return Case(
        Model("two tanks", parameters, ("h1", "h2"), rates),
        level * rng.choice((0.7, 0.97, 1.5)),
        tuple(h),
        exact=exact,
    )


@held_out("smooth")
def rate_by_logarithms(rng):
    """Gompertz's growth and its logarithm side by side."""
    parameters = {"a": decades(rng, 0.1, 3.0), "K": decades(rng, 1e-2, 1e6)}
    share = decades(rng, 1e-6, 3.0)

    def exact(mp, s, p, t):
        left = mp.log(s.x / p.K) * mp.exp(-p.a * t)
        return p.K * mp.exp(left), s.y * mp.exp(-p.a * t)

    model = Model(
        "Gompertz",
        parameters,
        ("x", "y"),
        lambda s, p, t: (-p.a * s.x * log(s.x / p.K), -p.a * s.y),
    )
    return Case(
        model,
        rng.uniform(1.0, 20.0) / parameters["a"],
        (parameters["K"] * share, either(rng, 1.0)),
        exact=exact,
    )
