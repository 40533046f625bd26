"""Formulas as people write them: tables by nested conditions, limits, roots, powers, signs."""

import math

from newton_euler import cos, exp, log, sqrt, tanh, where
from tests.honesty.cases import Log, by_accelerations, by_rates, held_out


def _sign(x):
    return where(x > 0, 1.0, where(x < 0, -1.0, 0.0))


@held_out("kinked")
def engine_by_a_table(rng):
    """A car whose torque is a table of five points in the speed, interpolated by nested where."""
    parameters = {f"f{i}": rng.uniform(1.0, 3.0) for i in range(5)}
    parameters |= {"d": rng.uniform(3.0, 8.0), "c": 2e-3}

    def table(v, p):
        u = v / p.d
        first, second = p.f0 + (p.f1 - p.f0) * u, p.f1 + (p.f2 - p.f1) * (u - 1)
        third, last = p.f2 + (p.f3 - p.f2) * (u - 2), p.f3 + (p.f4 - p.f3) * (u - 3)
        return where(u < 1, first, where(u < 2, second, where(u < 3, third, last)))

    rates = lambda s, p, t: (s.v, table(s.v, p) - p.c * s.v**2)
    T = rng.uniform(3.0, 40.0)
    return by_rates(rates, parameters, "x v", T, (0.0, 0.0))


@held_out("kinked")
def gears(rng):
    """Three gears: the force jumps at two speeds."""
    parameters = rng.parameters(F1=(4.0, 6.0), F2=(2.0, 3.5), F3=(1.0, 1.8))
    parameters |= rng.parameters(v1=(5.0, 10.0), v2=(13.0, 20.0), c=Log(1e-5, 1e-3))

    def rates(s, p, t):
        force = where(s.v < p.v1, p.F1, where(s.v < p.v2, p.F2, p.F3))
        return s.v, force - p.c * s.v * abs(s.v)

    T, v = rng.values((2.0, 30.0), (0.0, 3.0))
    return by_rates(rates, parameters, "x v", T, (0.0, v))


@held_out("kinked")
def drag_with_a_crisis(rng):
    """A sphere whose drag stops growing above some speed, by the smaller of two values."""

    def rates(s, p, t):
        drag = where(p.c * s.v * s.v < p.most, p.c * s.v * s.v, p.most) * _sign(s.v)
        return s.v, -p.g - drag

    parameters = rng.parameters(g=9.81, c=(0.01, 0.1), most=(1.0, 8.0))
    v, T = rng.values((5.0, 40.0), (0.5, 2.5))
    return by_rates(rates, parameters, "h v", v / 9.81 * T, (0.0, v))


@held_out("stiff")
def friction_with_a_small_speed(rng):
    """Coulomb's friction as v / sqrt(v^2 + e^2), on a spring: swings, then creep."""
    k, mu, e, T, x = rng.values((1.0, 20.0), (0.05, 0.5), Log(1e-4, 1e-1), (0.5, 3.0), (1.0, 5.0))
    a = lambda s, p, t: (-p.k * s.x - p.mu * s.dx / sqrt(s.dx * s.dx + p.e * p.e),)
    start = x * mu / k * 3, 0.0
    return by_accelerations(a, {"k": k, "mu": mu, "e": e}, "x", T * 2 * math.pi / k**0.5, start)


@held_out("stiff")
def stribeck_belt(rng):
    """A block on a belt with Stribeck's curve times tanh(v/e): it sticks and slips."""
    parameters = rng.parameters(k=(2.0, 20.0), belt=(0.1, 0.5), Fc=(0.5, 1.0), Fs=(1.2, 2.0))
    parameters |= rng.parameters(vs=(0.1, 0.4), e=Log(3e-3, 3e-2), c=0.05)

    def accelerations(s, p, t):
        v = s.dx - p.belt
        curve = p.Fc + (p.Fs - p.Fc) * exp(-((v / p.vs) ** 2))
        return (-p.k * s.x - p.c * s.dx - curve * tanh(v / p.e),)

    T, v = rng.uniform(2.0, 10.0), rng.choice((0.0, parameters["belt"]))
    return by_accelerations(accelerations, parameters, "x", T, (0.0, v))


@held_out("kinked")
def root_spring(rng):
    """A force that goes with the root of the displacement, abs(x)**0.5, and changes its sign."""
    k, x, T = rng.values(Log(0.1, 30.0), (0.3, 2.0), (2.0, 20.0))
    a = lambda s, p, t: (-p.k * _sign(s.x) * abs(s.x) ** 0.5,)

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

    return by_accelerations(a, {"k": k}, "x", T * x**0.25 / k**0.5, (x, 0.0), exact=exact)


@held_out("near-singular")
def root_of_the_distance(rng):
    """A force that goes with the root of the distance, past its centre."""

    def accelerations(s, p, t):
        r = (s.x**2 + s.y**2) ** 0.5
        f = -p.k * r**0.5 / r
        return f * s.x, f * s.y

    k, T, x, v = rng.values(Log(0.1, 30.0), (1.0, 5.0), (0.3, 2.0), Log(1e-2, 0.5))
    return by_accelerations(accelerations, {"k": k}, "x y", T, (x, 0.0, 0.0, v))


@held_out("kinked")
def ball_by_hertz(rng):
    """A bounce on max(d, 0)**1.5 with preload and hysteresis (Hunt and Crossley)."""

    def rates(s, p, t):
        d = where(-s.h > 0.0, -s.h, 0.0)
        return s.v, p.k * ((d + p.d0) ** 1.5 - p.d0**1.5) * (1 - p.a * s.v) - p.g

    parameters = rng.parameters(g=9.81, k=Log(1e3, 1e5), a=(0.0, 0.3), d0=1e-3)
    h, T = rng.values((0.2, 1.0), (1.3, 4.0))
    T *= math.sqrt(2 * h / 9.81)
    return by_rates(rates, parameters, "h v", T, (h, 0.0))


@held_out("mechanics")
def drag_with_a_power(rng):
    """A shot whose drag goes with the speed to a power between 1 and 2."""

    def accelerations(s, p, t):
        v = sqrt(s.dx**2 + s.dy**2)
        d = p.c * v ** (p.n - 1)
        return -d * s.dx, -p.g - d * s.dy

    parameters = rng.parameters(g=9.81, c=Log(1e-3, 1e-1), n=(1.1, 1.9))
    v, a, T = rng.values((10.0, 100.0), (0.2, 1.3), (1.0, 10.0))
    start = 0.0, 0.0, v * math.cos(a), v * math.sin(a)
    return by_accelerations(accelerations, parameters, "x y", T, start)


@held_out("stiff")
def floor_by_softplus(rng):
    """A bounce on log(1 + exp(-h/w)), a floor that is smooth but thin."""
    parameters = rng.parameters(g=9.81, k=Log(1e2, 1e4), w=Log(3e-3, 3e-2), one=1.0)
    rates = lambda s, p, t: (s.v, p.k * p.w * log(p.one + exp(-s.h / p.w)) - p.g)
    h, T = rng.values((0.2, 1.0), (1.3, 6.0))
    return by_rates(rates, parameters, "h v", math.sqrt(2 * h / 9.81) * T, (h, 0.0))


@held_out("kinked", "forced")
def backlash_by_abs(rng):
    """Motor and load with play between them, as (|d + b| - |d - b|)/2."""
    parameters = rng.parameters(k=Log(10.0, 1e3), b=(0.01, 0.1), J=(0.3, 3.0), c=(0.05, 0.5))
    parameters |= rng.parameters(M=(0.5, 2.0), w=(0.5, 3.0))

    def accelerations(s, p, t):
        d = s.a - s.l
        twist = d - (abs(d + p.b) - abs(d - p.b)) / 2
        return p.M * cos(p.w * t) - p.k * twist - p.c * s.da, (p.k * twist - p.c * s.dl) / p.J

    T = rng.uniform(3.0, 8.0)
    return by_accelerations(accelerations, parameters, "a l", T, (0.0, 0.0, 0.0, 0.0))


@held_out("kinked", "forced")
def pulses_by_where(rng):
    """A mass at rest, then two short rectangular pushes, then free: jumps while all is zero."""
    T = rng.uniform(10.0, 40.0)
    parameters = rng.parameters(k=(0.5, 5.0), c=(0.0, 0.2), F=(0.5, 5.0))
    drawn = rng.parameters(t1=(0.1, 0.3), t2=(0.45, 0.7), w=Log(0.015, 0.1))
    parameters |= {n: T * x for n, x in drawn.items()}

    def accelerations(s, p, t):
        first = where(t > p.t1, where(t < p.t1 + p.w, p.F, 0.0), 0.0)
        second = where(t > p.t2, where(t < p.t2 + p.w, -p.F, 0.0), 0.0)
        return (first + second - p.k * s.x - p.c * s.dx,)

    edges = [parameters[n] + k * parameters["w"] for n in ("t1", "t2") for k in (0, 1)]
    knots = tuple(x + d * parameters["w"] for x in edges for d in (-0.3, 0.3))
    return by_accelerations(accelerations, parameters, "x", T, (0.0, 0.0), knots=knots)


@held_out("kinked", "forced")
def cam_of_cosines(rng):
    """A valve on a cam: it rests, is lifted by half a cosine, and rests again (nested where)."""
    parameters = rng.parameters(
        k=Log(20.0, 500.0), c=(0.5, 3.0), h=(0.005, 0.05), t1=(0.5, 1.5), t2=(2.0, 4.0)
    )

    def accelerations(s, p, t):
        u = 2 * math.pi * (t - p.t1) / (p.t2 - p.t1)
        lift = where(t < p.t1, 0.0, where(t > p.t2, 0.0, p.h * (1 - cos(u)) / 2))
        return (p.k * (lift - s.x) - p.c * s.dx,)

    T = rng.uniform(3.0, 7.0)
    return by_accelerations(accelerations, parameters, "x", T, (0.0, 0.0))


@held_out("kinked", "sticking")
def two_tanks(rng):
    """Two tanks through a hole: sign(h1 - h2) sqrt(|h1 - h2|), until they are level."""
    c = rng.decades(1e-3, 1.0)

    def rates(s, p, t):
        d = s.h1 - s.h2
        q = p.c * _sign(d) * sqrt(abs(d))
        return -q, q

    def exact(mp, s, p, t):
        d, mean = s.h1 - s.h2, (s.h1 + s.h2) / 2
        now = mp.sign(d) * max(mp.sqrt(abs(d)) - p.c * t, mp.mpf(0)) ** 2
        return mean + now / 2, mean - now / 2

    h = tuple(k / 64 for k in rng.sample(range(8, 200), 2))
    level = abs(h[0] - h[1]) ** 0.5 / c
    return by_rates(rates, {"c": c}, "h1 h2", level * rng.choice((0.7, 0.97, 1.5)), h, exact=exact)


@held_out("smooth")
def rate_by_logarithms(rng):
    """Gompertz's growth and its logarithm, together."""
    a, K, share, T = rng.values(Log(0.1, 3.0), Log(1e-2, 1e6), Log(1e-6, 3.0), (1.0, 20.0))
    rates = lambda s, p, t: (-p.a * s.x * log(s.x / p.K), -p.a * s.y)

    def exact(mp, s, p, t):
        left = mp.log(s.x / p.K) * mp.exp(-p.a * t)
        return p.K * mp.exp(left), s.y * mp.exp(-p.a * t)

    start = K * share, rng.either(1.0)
    return by_rates(rates, {"a": a, "K": K}, "x y", T / a, start, exact=exact)
