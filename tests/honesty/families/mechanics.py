"""Mechanics as in the book: bodies, tops, rolling, shots, vehicles."""

import math

from newton_euler import cos, sin, sqrt
from tests.honesty import closed_forms, models
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, family


@family("mechanics")
def free_body(rng):
    """A free body with three different moments of inertia."""
    size, spin = rng.values(Log(1e-6, 1e6), Log(0.01, 100.0))
    model = models.free_body(size, size * rng.uniform(1.1, 1.9), size * 2.0)
    T, start = rng.uniform(5.0, 60.0) / spin, tuple(spin * rng.uniform(-1.0, 1.0) for _ in range(3))
    return Case(model, T, start, exact=models.exact_free_body)


@family("mechanics")
def heavy_top(rng):
    """A heavy top by a quaternion and its body rates; its axis from high up to hanging."""

    def rates(s, p, t):
        # of the vertical in the body
        up = 2 * (s.q1 * s.q3 - s.q0 * s.q2), 2 * (s.q2 * s.q3 + s.q0 * s.q1)
        turn = (
            -(s.q1 * s.x + s.q2 * s.y + s.q3 * s.z) / 2, (s.q0 * s.x + s.q2 * s.z - s.q3 * s.y) / 2,
            (s.q0 * s.y + s.q3 * s.x - s.q1 * s.z) / 2, (s.q0 * s.z + s.q1 * s.y - s.q2 * s.x) / 2,
        )  # fmt: skip
        x = ((p.A - p.C) * s.y * s.z + p.m * up[1]) / p.A
        y = ((p.C - p.A) * s.z * s.x - p.m * up[0]) / p.A
        return *turn, x, y, 0.0 * s.z

    parameters = rng.parameters(A=(0.5, 1.5), C=(0.5, 1.5), m=(1.0, 6.0))
    half, x, y, spin = rng.values((0.05, 1.4), (-1.0, 1.0), (-1.0, 1.0), (1.0, 15.0))
    start = math.cos(half), math.sin(half), 0.0, 0.0, x, y, rng.either(spin)
    return by_rates(rates, parameters, "q0 q1 q2 q3 x y z", rng.uniform(2.0, 12.0), start)


@family("mechanics")
def shot_in_the_wind(rng):
    """A shot with drag as its airspeed squared, in a wind that grows with the height."""
    parameters = rng.parameters(g=9.81, c=Log(1e-4, 3e-2), w=(-10.0, 10.0), b=(0.0, 0.02))

    def accelerations(s, p, t):
        u = s.dx - p.w - p.b * s.z
        v = sqrt(u * u + s.dy * s.dy + s.dz * s.dz)
        return -p.c * v * u, -p.c * v * s.dy, -p.g - p.c * v * s.dz

    v, a, across, T = rng.values(Log(10.0, 500.0), (0.2, 1.3), (-5.0, 5.0), (1.0, 20.0))
    start = 0.0, 0.0, 0.0, v * math.cos(a), across, v * math.sin(a)
    return by_accelerations(accelerations, parameters, "x y z", T, start)


@family("mechanics", "multi-scale")
def shot_over_the_turning_earth(rng):
    """A shot with Coriolis and centrifugal terms, each at most some thousandths of gravity."""
    lat = rng.uniform(-1.4, 1.4)
    parameters = {"g": 9.81, "n": 7.292115e-5, "c": math.cos(lat), "k": math.sin(lat), "R": 6.371e6}

    def accelerations(s, p, t):
        out = p.c * (s.z + p.R) - p.k * s.y
        n = p.n
        x = 2 * n * (p.k * s.dy - p.c * s.dz) + n * n * s.x
        y, z = -2 * n * p.k * s.dx - n * n * p.k * out, 2 * n * p.c * s.dx + n * n * p.c * out - p.g
        return x, y, z

    start = 0.0, 0.0, 0.0, *rng.values((-300.0, 300.0), (-300.0, 300.0), (100.0, 500.0))
    return by_accelerations(accelerations, parameters, "x y z", rng.uniform(10.0, 90.0), start)


@family("mechanics")
def pendulum_on_a_cart(rng):
    """A pendulum on a cart on a spring: two degrees of freedom, by a mass matrix."""
    parameters = rng.parameters(
        M=Log(0.1, 10.0), m=Log(0.1, 10.0), L=(0.3, 2.0), k=Log(1.0, 100.0), g=9.81
    )

    def accelerations(s, p, t):
        c, k = cos(s.a), sin(s.a)
        push = p.m * p.L * s.da * s.da * k - p.k * s.x
        d = p.M + p.m * k * k
        x = (push + p.m * p.g * k * c) / d
        return x, -(x * c + p.g * k) / p.L

    start = rng.values((-0.5, 0.5), (-1.5, 1.5), 0.0, (-1.0, 1.0))
    return by_accelerations(accelerations, parameters, "x a", rng.uniform(2.0, 10.0), start)


@family("mechanics")
def rolling_disk(rng):
    """A rolling disk: the angle of its axis, and the rates about its axes (E. J. Routh)."""
    parameters = {"g": 9.81 / rng.decades(0.02, 2.0), "A": 0.25, "C": 0.5}  # moments over m R^2

    def rates(s, p, t):
        cot = cos(s.theta) / sin(s.theta)
        fall = (p.A * s.y * s.y * cot - (p.C + 1) * s.y * s.z - p.g * cos(s.theta)) / (p.A + 1)
        return s.x, fall, p.C / p.A * s.z * s.x - s.y * s.x * cot, s.y * s.x / (p.C + 1)

    w = math.sqrt(parameters["g"])
    theta, y, z = rng.values((-0.3, 0.3), (-0.5, 0.5), (1.0, 4.0))
    start = math.pi / 2 + theta, 0.0, y * w, rng.either(z * w)
    return by_rates(rates, parameters, "theta x y z", rng.uniform(1.0, 15.0) / w, start)


@family("mechanics")
def bead_on_a_turning_hoop(rng):
    """A bead on a hoop below or above the rate at which the bottom becomes unstable."""
    parameters = rng.parameters(g=(2.0, 12.0), n=(0.5, 6.0))
    rates = lambda s, p, t: (s.w, (p.n * p.n * cos(s.a) - p.g) * sin(s.a))
    T, a = rng.values((3.0, 20.0), Log(1e-3, 2.0))
    return by_rates(rates, parameters, "a w", T, (a, 0.0))


@family("mechanics")
def spherical_pendulum(rng):
    """A spherical pendulum in Cartesian coordinates, the tension from the constraint."""

    def accelerations(s, p, t):
        v2 = s.dx * s.dx + s.dy * s.dy + s.dz * s.dz
        k = (v2 - p.g * s.z) / p.L2
        return -k * s.x, -k * s.y, -k * s.z - p.g

    a, v, T = rng.values((0.2, 2.0), (0.1, 3.0), (2.0, 8.0))
    start = math.sin(a), 0.0, -math.cos(a), 0.0, v, 0.0
    parameters = {"g": 9.81, "L2": 1.0}
    return by_accelerations(accelerations, parameters, "x y z", T, start)


@family("mechanics", "closed form")
def pendulum_with_its_period(rng):
    """Small swings of a pendulum, whose model brings its exact solution."""

    def exact(m, s, p, t):
        return closed_forms.oscillator(m, m.sqrt(p.g / p.L), s.a, s.w, t)

    parameters = rng.parameters(g=9.81, L=Log(0.01, 100.0))
    rates = lambda s, p, t: (s.w, -p.g / p.L * s.a)
    T, *start = rng.values((1.0, 100.0), (0.01, 0.2), (-0.1, 0.1))
    return by_rates(rates, parameters, "a w", T, start, exact=exact, brings=True)


@family("mechanics")
def car_on_springs(rng):
    """Heave and pitch of a car that drives over waves, its springs a little progressive."""
    parameters = rng.parameters(
        k=Log(20.0, 80.0), c=(0.3, 3.0), front=1.2, rear=1.5, i=0.6,
        h=(0.01, 0.08), w=(2.0, 15.0), q=(0.0, 30.0), lag=(0.5, 3.0),
    )  # fmt: skip

    def accelerations(s, p, t):
        def axle(arm, late):
            d = s.z + arm * s.pitch - p.h * sin(p.w * t - late)
            v = s.dz + arm * s.dpitch - p.h * p.w * cos(p.w * t - late)
            return -p.k * d * (1 + p.q * d * d) - p.c * v

        front, rear = axle(p.front, 0.0), axle(-p.rear, p.lag)
        return front + rear, (p.front * front - p.rear * rear) / p.i

    T = rng.uniform(2.0, 10.0)
    return by_accelerations(accelerations, parameters, "z pitch", T, (0.0, 0.0, 0.0, 0.0))


@family("mechanics")
def mass_on_a_rotating_table(rng):
    """A mass let go on a rotating table: a spiral on the table, a straight line on the ground."""
    n = rng.decades(0.1, 10.0)
    a = lambda s, p, t: (p.n * p.n * s.x + 2 * p.n * s.dy, p.n * p.n * s.y - 2 * p.n * s.dx)

    def exact(mp, s, p, t):
        c, k = mp.cos(p.n * t), mp.sin(p.n * t)
        u, v = s.dx - p.n * s.y, s.dy + p.n * s.x  # in the ground's frame
        X, Y = s.x + u * t, s.y + v * t
        x, y = X * c + Y * k, Y * c - X * k
        return x, y, u * c + v * k + p.n * y, v * c - u * k - p.n * x

    T, *start = rng.values((2.0, 60.0), *[(-1.0, 1.0)] * 4)
    return by_accelerations(a, {"n": n}, "x y", T / n, start, exact=exact)
