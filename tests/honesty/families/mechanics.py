"""Mechanics as in the book: bodies, tops, rolling, shots, vehicles."""

import math

from newton_euler import Model, cos, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, either, family


@family("mechanics")
def free_body(rng):
    """Three different moments of inertia."""

    def rates(s, p, t):
        return (
            (p.B - p.C) / p.A * s.y * s.z,
            (p.C - p.A) / p.B * s.z * s.x,
            (p.A - p.B) / p.C * s.x * s.y,
        )

    def exact(mp, s, p, t):
        return closed_forms.free_body(mp, (p.A, p.B, p.C), (s.x, s.y, s.z), t)

    size, spin = decades(rng, 1e-6, 1e6), decades(rng, 0.01, 100.0)
    model = Model(
        "free body",
        {"A": size, "B": size * rng.uniform(1.1, 1.9), "C": size * 2.0},
        ("x", "y", "z"),
        rates,
    )
    return Case(
        model,
        rng.uniform(5.0, 60.0) / spin,
        tuple(spin * rng.uniform(-1.0, 1.0) for _ in range(3)),
        exact=exact,
    )


@family("mechanics")
def heavy_top(rng):
    """Attitude by a quaternion, and rates in the body; its axis from far up to hanging."""
    parameters = {
        "A": rng.uniform(0.5, 1.5),
        "C": rng.uniform(0.5, 1.5),
        "m": rng.uniform(1.0, 6.0),
    }

    def rates(s, p, t):
        # of the vertical in the body
        up = 2 * (s.q1 * s.q3 - s.q0 * s.q2), 2 * (s.q2 * s.q3 + s.q0 * s.q1)
        turn = (
            -(s.q1 * s.x + s.q2 * s.y + s.q3 * s.z) / 2, (s.q0 * s.x + s.q2 * s.z - s.q3 * s.y) / 2,
            (s.q0 * s.y + s.q3 * s.x - s.q1 * s.z) / 2, (s.q0 * s.z + s.q1 * s.y - s.q2 * s.x) / 2,
        )  # fmt: skip
        return (
            *turn,
            ((p.A - p.C) * s.y * s.z + p.m * up[1]) / p.A,
            ((p.C - p.A) * s.z * s.x - p.m * up[0]) / p.A,
            0.0 * s.z,
        )

    model = Model("heavy top", parameters, ("q0", "q1", "q2", "q3", "x", "y", "z"), rates)
    half = rng.uniform(0.05, 1.4)
    start = (
        math.cos(half),
        math.sin(half),
        0.0,
        0.0,
        rng.uniform(-1.0, 1.0),
        rng.uniform(-1.0, 1.0),
        either(rng, rng.uniform(1.0, 15.0)),
    )
    return Case(model, rng.uniform(2.0, 12.0), start)


@family("mechanics")
def shot_in_the_wind(rng):
    """Drag that goes with the square of the speed through a wind that grows with the height."""
    parameters = {
        "g": 9.81,
        "c": decades(rng, 1e-4, 3e-2),
        "w": rng.uniform(-10.0, 10.0),
        "b": rng.uniform(0.0, 0.02),
    }

    def accelerations(s, p, t):
        u = s.dx - p.w - p.b * s.z
        v = sqrt(u * u + s.dy * s.dy + s.dz * s.dz)
        return -p.c * v * u, -p.c * v * s.dy, -p.g - p.c * v * s.dz

    v, a = decades(rng, 10.0, 500.0), rng.uniform(0.2, 1.3)
    start = 0.0, 0.0, 0.0, v * math.cos(a), rng.uniform(-5.0, 5.0), v * math.sin(a)
    return Case(
        second_order("shot in the wind", parameters, ("x", "y", "z"), accelerations),
        rng.uniform(1.0, 20.0),
        start,
    )


@family("mechanics", "multi-scale")
def shot_over_the_turning_earth(rng):
    """Coriolis and centrifugal terms, a thousandth and a millionth of gravity."""
    lat = rng.uniform(-1.4, 1.4)
    parameters = {"g": 9.81, "n": 7.292115e-5, "c": math.cos(lat), "k": math.sin(lat), "R": 6.371e6}

    def accelerations(s, p, t):
        out = p.c * (s.z + p.R) - p.k * s.y
        n = p.n
        return (
            2 * n * (p.k * s.dy - p.c * s.dz) + n * n * s.x,
            -2 * n * p.k * s.dx - n * n * p.k * out,
            2 * n * p.c * s.dx + n * n * p.c * out - p.g,
        )

    start = (
        0.0,
        0.0,
        0.0,
        rng.uniform(-300.0, 300.0),
        rng.uniform(-300.0, 300.0),
        rng.uniform(100.0, 500.0),
    )
    return Case(
        second_order("shot over the Earth", parameters, ("x", "y", "z"), accelerations),
        rng.uniform(10.0, 90.0),
        start,
    )


@family("mechanics")
def pendulum_on_a_cart(rng):
    """Two degrees of freedom through a mass matrix, the cart on a spring."""
    parameters = {
        "M": decades(rng, 0.1, 10.0),
        "m": decades(rng, 0.1, 10.0),
        "L": rng.uniform(0.3, 2.0),
        "k": decades(rng, 1.0, 100.0),
        "g": 9.81,
    }

    def accelerations(s, p, t):
        c, k = cos(s.a), sin(s.a)
        push = p.m * p.L * s.da * s.da * k - p.k * s.x
        d = p.M + p.m * k * k
        x = (push + p.m * p.g * k * c) / d
        return x, -(x * c + p.g * k) / p.L

    start = rng.uniform(-0.5, 0.5), rng.uniform(-1.5, 1.5), 0.0, rng.uniform(-1.0, 1.0)
    return Case(
        second_order("pendulum on a cart", parameters, ("x", "a"), accelerations),
        rng.uniform(2.0, 10.0),
        start,
    )


@family("mechanics")
def rolling_disk(rng):
    """A thin disk that rolls without slipping.

    The angle of its axis, and the rates about its axes (E. J. Routh).
    """
    parameters = {"g": 9.81 / decades(rng, 0.02, 2.0), "A": 0.25, "C": 0.5}  # moments over m R^2

    def rates(s, p, t):
        cot = cos(s.theta) / sin(s.theta)
        fall = (p.A * s.y * s.y * cot - (p.C + 1) * s.y * s.z - p.g * cos(s.theta)) / (p.A + 1)
        return s.x, fall, p.C / p.A * s.z * s.x - s.y * s.x * cot, s.y * s.x / (p.C + 1)

    w = math.sqrt(parameters["g"])
    start = (
        math.pi / 2 + rng.uniform(-0.3, 0.3),
        0.0,
        rng.uniform(-0.5, 0.5) * w,
        either(rng, rng.uniform(1.0, 4.0) * w),
    )
    return Case(
        Model("rolling disk", parameters, ("theta", "x", "y", "z"), rates),
        rng.uniform(1.0, 15.0) / w,
        start,
    )


@family("mechanics")
def bead_on_a_turning_hoop(rng):
    """Below or above the speed at which the lowest place becomes unstable."""
    parameters = {"g": rng.uniform(2.0, 12.0), "n": rng.uniform(0.5, 6.0)}
    model = Model(
        "bead on a hoop",
        parameters,
        ("a", "w"),
        lambda s, p, t: (s.w, (p.n * p.n * cos(s.a) - p.g) * sin(s.a)),
    )
    return Case(model, rng.uniform(3.0, 20.0), (decades(rng, 1e-3, 2.0), 0.0))


@family("mechanics")
def spherical_pendulum(rng):
    """In Cartesian coordinates, the tension from the constraint."""
    parameters = {"g": 9.81, "L2": 1.0}

    def accelerations(s, p, t):
        v2 = s.dx * s.dx + s.dy * s.dy + s.dz * s.dz
        k = (v2 - p.g * s.z) / p.L2
        return -k * s.x, -k * s.y, -k * s.z - p.g

    a = rng.uniform(0.2, 2.0)
    start = math.sin(a), 0.0, -math.cos(a), 0.0, rng.uniform(0.1, 3.0), 0.0
    return Case(
        second_order("spherical pendulum", parameters, ("x", "y", "z"), accelerations),
        rng.uniform(2.0, 8.0),
        start,
    )


@family("mechanics", "closed form")
def pendulum_with_its_period(rng):
    """Small swings, a model that brings its exact solution."""

    def solution(s, p, t):
        n = sqrt(p.g / p.L)
        return s.a * cos(n * t) + s.w / n * sin(n * t), s.w * cos(n * t) - n * s.a * sin(n * t)

    def exact(mp, s, p, t):
        return closed_forms.oscillator(mp, mp.sqrt(p.g / p.L), s.a, s.w, t)

    parameters = {"g": 9.81, "L": decades(rng, 0.01, 100.0)}
    model = Model(
        "small swings",
        parameters,
        ("a", "w"),
        lambda s, p, t: (s.w, -p.g / p.L * s.a),
        exact=solution,
    )
    return Case(
        model,
        rng.uniform(1.0, 100.0),
        (rng.uniform(0.01, 0.2), rng.uniform(-0.1, 0.1)),
        exact=exact,
    )


@family("mechanics")
def car_on_springs(rng):
    """Heave and pitch of a car that drives over waves, its springs a little progressive."""
    parameters = {
        "k": decades(rng, 20.0, 80.0),
        "c": rng.uniform(0.3, 3.0),
        "front": 1.2,
        "rear": 1.5,
        "i": 0.6,
        "h": rng.uniform(0.01, 0.08),
        "w": rng.uniform(2.0, 15.0),
    }
    parameters |= {"q": rng.uniform(0.0, 30.0), "lag": rng.uniform(0.5, 3.0)}

    def accelerations(s, p, t):
        def axle(arm, late):
            d = s.z + arm * s.pitch - p.h * sin(p.w * t - late)
            v = s.dz + arm * s.dpitch - p.h * p.w * cos(p.w * t - late)
            return -p.k * d * (1 + p.q * d * d) - p.c * v

        front, rear = axle(p.front, 0.0), axle(-p.rear, p.lag)
        return front + rear, (p.front * front - p.rear * rear) / p.i

    return Case(
        second_order("car on springs", parameters, ("z", "pitch"), accelerations),
        rng.uniform(2.0, 10.0),
        (0.0, 0.0, 0.0, 0.0),
    )


@family("mechanics")
def mass_on_a_rotating_table(rng):
    """A mass on a rotating table that is let go: it leaves in a spiral, exponentially."""
    parameters = {"n": decades(rng, 0.1, 10.0)}
    model = second_order(
        "mass on a rotating table",
        parameters,
        ("x", "y"),
        lambda s, p, t: (p.n * p.n * s.x + 2 * p.n * s.dy, p.n * p.n * s.y - 2 * p.n * s.dx),
    )

    def exact(mp, s, p, t):
        c, k = mp.cos(p.n * t), mp.sin(p.n * t)
        u, v = s.dx - p.n * s.y, s.dy + p.n * s.x  # in the ground
        X, Y = s.x + u * t, s.y + v * t
        x, y = X * c + Y * k, Y * c - X * k
        return x, y, u * c + v * k + p.n * y, v * c - u * k - p.n * x

    return Case(
        model,
        rng.uniform(2.0, 60.0) / parameters["n"],
        tuple(rng.uniform(-1.0, 1.0) for _ in range(4)),
        exact=exact,
    )
