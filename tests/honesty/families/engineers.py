"""Machines as an engineer writes them: ropes, absorbers, kerbs, clutches, tables of a record. Written
by someone who did not write the methods, before any of them was run.
"""

import math
from functools import lru_cache
from itertools import pairwise

from newton_euler import Event, Model, atan, cos, exp, sin, sqrt, table, tanh, where
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, Log, around, by_accelerations, by_rates, family


@lru_cache(maxsize=8)
def _modes(mp, rows, digits):
    """Eigenvalues and eigenvectors of a matrix, and the inverse of these, to ``digits`` digits."""
    rates, shapes = mp.eig(mp.matrix(rows))
    return rates, shapes, shapes**-1


def _linear(mp, matrix, x, t):
    """The solution of x' = A x."""
    rates, shapes, inverse = _modes(mp, tuple(map(tuple, matrix.tolist())), mp.mp.dps)
    modes = zip(inverse * mp.matrix(x), rates, strict=True)
    return tuple(map(mp.re, shapes * mp.matrix([q * mp.exp(r * t) for q, r in modes])))


@family("engineers", "kinked")
def rope_that_becomes_taut(rng):
    """A load is dropped until its rope is taut, with a damper that only pulls."""
    g, L, k, d = 9.81, *rng.values((1.0, 20.0), Log(30.0, 3e4), (0.02, 0.3))
    parameters = {"g": g, "L": L, "k": k, "d": 2 * d * math.sqrt(k)}

    def accelerations(s, p, t):
        pull = p.k * (s.z - p.L) + p.d * s.dz
        return (p.g - where(s.z > p.L, where(pull > 0, pull, 0.0), 0.0),)

    T = math.sqrt(2 * L / g) * rng.uniform(1.2, 4.0)
    return by_accelerations(accelerations, parameters, "z", T, (0.0, 0.0))


@family("engineers", "tables")
def tower_in_an_earthquake(rng):
    """A tower of one mass under a record of accelerations, linear between its 41 values."""
    n, zeta, dt = rng.values((1.0, 30.0), (0.01, 0.1), (0.02, 0.5))
    times = [k * dt for k in range(41)]
    record = [0.0, *(rng.gauss(0.0, 3.0) for _ in range(39)), 0.0]
    ground, parameters = table(times, record), {"k": n * n, "d": 2 * zeta * n}
    a = lambda s, p, t: (-ground(t) - p.k * s.u - p.d * s.du,)

    def exact(mp, s, p, t):
        """From each value of the record to the next (Nigam and Jennings, 1969)."""
        x, v, n, c = s.u, s.du, mp.sqrt(p.k), mp.mpf(p.d) / 2
        for (a, f), (b, g) in pairwise(zip(times, map(mp.mpf, record), strict=True)):
            slope = -(g - f) / (mp.mpf(b) - a) / p.k
            rest, length = (-f - p.d * slope) / p.k, min(mp.mpf(t), b) - a
            x, v = closed_forms.damped(mp, n, c, x - rest, v - slope, length)
            x, v = x + rest + slope * length, v + slope
            if t <= b:
                break
        return x, v

    T = times[-1] * rng.uniform(0.6, 1.0)
    return by_accelerations(a, parameters, "u", T, (0.0, 0.0), exact=exact, knots=times)


@family("engineers", "forced")
def absorber_swept_over_its_resonance(rng):
    """A machine with a tuned absorber as its unbalance speeds up: a force as the speed squared."""
    n, mu, zeta, T = rng.values((5.0, 50.0), (0.02, 0.2), (0.0, 0.1), (10.0, 60.0))
    tuned = n / (1 + mu)
    parameters = {"n": n * n, "mu": mu, "k": tuned**2, "d": 2 * zeta * tuned, "a": 2 * n / T}
    parameters["f"] = rng.uniform(1e-4, 1e-2)

    def accelerations(s, p, t):
        between = p.k * (s.y - s.x) + p.d * (s.dy - s.dx)
        force = p.f * (p.a * t) ** 2 * cos(p.a * t**2 / 2)
        return force - p.n * s.x + p.mu * between, -between

    return by_accelerations(accelerations, parameters, "x y", T, (0.0, 0.0, 0.0, 0.0))


@family("engineers", "stiff")
def stiff_bushings_in_a_soft_car(rng):
    """Body, subframe and wheel: bushings of 1e5 to 1e8 N/m beside a spring of 1e4, all damped."""
    k, b, w = rng.values((1e4, 4e4), Log(1e5, 1e8), (1e5, 3e5))
    parameters = {"k": k, "b": b, "w": w, "c": rng.uniform(500.0, 3000.0)}
    parameters |= {"d": 2e-3 * b / math.sqrt(b / 20.0), "M": 400.0, "m": 20.0, "u": 30.0}

    def accelerations(s, p, t):
        spring = p.k * (s.y - s.x) + p.c * (s.dy - s.dx)
        bush = p.b * (s.z - s.y) + p.d * (s.dz - s.dy)
        return spring / p.M, (bush - spring) / p.m, (-bush - p.w * s.z) / p.u

    def exact(mp, s, p, t):
        p = type(p)(**{n: mp.mpf(x) for n, x in vars(p).items()})
        A = mp.zeros(6)
        for i in range(3):
            A[i, 3 + i] = 1
        for j, (stiff, damp) in enumerate(((p.k, p.c), (p.b, p.d))):
            for mass, i, sign in ((p.M, 0, 1), (p.m, 1, -1)) if j == 0 else (
                (p.m, 1, 1), (p.u, 2, -1)):  # fmt: skip
                A[3 + i, j + 1] += sign * stiff / mass
                A[3 + i, j] -= sign * stiff / mass
                A[3 + i, 4 + j] += sign * damp / mass
                A[3 + i, 3 + j] -= sign * damp / mass
        A[5, 2] -= p.w / p.u
        return _linear(mp, A, [s.x, s.y, s.z, s.dx, s.dy, s.dz], t)

    T, start = rng.uniform(0.2, 2.0), (0.05, 0.05, 0.0, 0.0, 0.0, 0.0)
    return by_accelerations(accelerations, parameters, "x y z", T, start, exact=exact)


@family("engineers", "near-singular")
def hoop_at_its_bifurcation(rng):
    """A bead at the bottom of a turning hoop, close to the rate at which the bead rises."""
    q = rng.values((1.0, 10.0))[0]
    parameters = {"g": q * q, "w": q * (1 + rng.either(rng.decades(1e-5, 1e-2)))}
    parameters["c"] = rng.choice((0.0, 0.01))
    a = lambda s, p, t: ((p.w**2 * cos(s.theta) - p.g) * sin(s.theta) - p.c * s.dtheta,)
    T = rng.uniform(20.0, 200.0) / q
    return by_accelerations(a, parameters, "theta", T, (rng.decades(1e-6, 1e-1), 0.0))


@family("engineers", "near-singular")
def armature_below_its_pull_in(rng):
    """An armature on a spring before a magnet, F/(gap)^4, at most 0.6 of its pull-in force."""
    n, d = rng.values((10.0, 100.0), Log(1e-3, 1e-2))
    # no equilibrium is left, and it is pulled in, if F > n^2 d^5 4^4/5^5
    F = n * n * d**5 * 4**4 / 5**5 * (1 - rng.decades(1e-3, 0.3)) * 0.6
    parameters = {"k": n * n, "F": F, "d": d, "c": 0.1 * n * rng.random()}
    a = lambda s, p, t: (p.F / (p.d - s.x) ** 4 - p.k * s.x - p.c * s.dx,)
    return by_accelerations(a, parameters, "x", rng.uniform(5.0, 30.0) / n, (0.0, 0.0))


@family("engineers", "kinked", "forced")
def aeroplane_in_a_gust(rng):
    """Heave and pitch in a 1 - cos gust of length L, met after a quiet flight."""
    V, L, t1 = rng.values((50.0, 200.0), Log(5.0, 200.0), (1.0, 20.0))
    H = L / V
    parameters = {"q": 2 * math.pi / H, "a": t1, "b": t1 + H, "W": rng.uniform(2.0, 15.0), "V": V}
    parameters |= rng.parameters(Z=(0.5, 2.0), M=(1.0, 10.0), D=(0.5, 3.0))

    def rates(s, p, t):
        inside = where(t > p.a, where(t < p.b, 1.0, 0.0), 0.0)
        gust = inside * p.W / 2 * (1 - cos(p.q * (t - p.a)))
        alpha = s.theta - (s.w - gust) / p.V
        return p.Z * p.V * alpha, s.r, -p.M * alpha - p.D * s.r

    T, knots = t1 + H + rng.uniform(0.5, 5.0), around(t1 + H / 7, H / 3, 4)
    return by_rates(rates, parameters, "w theta r", T, (0.0, 0.0, 0.0), knots=knots)


@family("engineers", "forced")
def car_on_its_tyre_curve(rng):
    """A bicycle model with Pacejka's formula, steered to and fro so hard that the tyres slide."""
    parameters = rng.parameters(
        V=(15.0, 40.0), B=(6.0, 14.0), C=(1.3, 1.8), D=(6.0, 10.0), E=(-1.0, 0.9),
        a=(1.0, 1.4), b=(1.2, 1.7), i=(1.5, 2.5), S=(0.02, 0.12), w=(1.0, 5.0),
    )  # fmt: skip

    def tyre(p, alpha):
        x = p.B * alpha
        return p.D * sin(p.C * atan(x - p.E * (x - atan(x))))

    def rates(s, p, t):
        front = tyre(p, p.S * sin(p.w * t) - atan((s.v + p.a * s.r) / p.V))
        rear = tyre(p, -atan((s.v - p.b * s.r) / p.V))
        share, total = p.b / (p.a + p.b), p.a * p.b / (p.a + p.b)
        lateral = share * front + (1 - share) * rear - p.V * s.r
        u = (p.V * cos(s.psi) - s.v * sin(s.psi), p.V * sin(s.psi) + s.v * cos(s.psi))
        return *u, s.r, lateral, total * (front - rear) / p.i

    return by_rates(rates, parameters, "x y psi v r", rng.uniform(2.0, 10.0), (0.0,) * 5)


@family("engineers", "kinked")
def wheel_over_a_kerb(rng):
    """A wheel of radius R rolls up a kerb: its centre follows a circle about the edge."""
    V, n, R, c = rng.values((1.0, 10.0), (6.0, 15.0), (0.25, 0.4), (2.0, 20.0))
    H = R * rng.uniform(0.05, 0.4)
    parameters = {"k": n * n, "d": 0.6 * n, "R": R, "H": H, "c": c, "r": rng.uniform(0.0, 0.3)}
    parameters["a"] = math.sqrt(R * R - (R - H) ** 2)

    def accelerations(s, p, t):
        far, near = s.x < p.c - p.a, s.x < p.c
        safe = where(near, where(far, p.a, p.c - s.x), 0.0)
        up = sqrt(p.R**2 - safe**2) - p.R + p.H
        height = where(near, where(far, 0.0, up), p.H)
        return -p.r * s.dx, -p.k * (s.z - height) - p.d * s.dz

    T = -math.log1p(-c * parameters["r"] / V / 2) / (parameters["r"] / 2 or 1.0) + 2.0
    return by_accelerations(accelerations, parameters, "x z", T, (0.0, 0.0, V, 0.0))


@family("engineers", "stiff")
def clutch_by_tanh(rng):
    """Two flywheels joined by a clutch whose friction is a steep tanh, until they turn together."""
    parameters = rng.parameters(I=(0.5, 3.0), J=(0.5, 3.0), M=(20.0, 200.0), e=Log(1e-3, 1.0))
    parameters["c"] = rng.uniform(0.0, 0.2)
    start = rng.uniform(100.0, 300.0), rng.uniform(0.0, 50.0)

    def rates(s, p, t):
        moment = p.M * tanh((s.a - s.b) / p.e)
        return -moment / p.I, moment / p.J - p.c * s.b

    slip = (start[0] - start[1]) / parameters["M"]
    return by_rates(rates, parameters, "a b", slip * rng.uniform(0.3, 1.5), start)


@family("engineers", "kinked", "forced")
def screw_with_a_dead_band(rng):
    """A nut driven to and fro as a sine, and a table that it moves beyond a dead band."""
    n, b, w = rng.values((20.0, 100.0), Log(1e-4, 1e-2), (1.0, 10.0))
    parameters = {"k": n * n, "c": 0.2 * n, "r": 0.5, "b": b, "w": w, "A": rng.uniform(0.01, 0.05)}

    def rates(s, p, t):
        off = p.A * sin(p.w * t) - s.x
        lost = where(off > p.b, off - p.b, where(off < -p.b, off + p.b, 0.0))
        return s.v, p.k * lost - (p.c + p.r) * s.v

    return by_rates(rates, parameters, "x v", rng.uniform(6.0, 30.0) / w, (0.0, 0.0))


@family("engineers", "events")
def controller_that_samples(rng):
    """A double integrator under state feedback, whose force is held from one tick to the next."""
    h, z = rng.values((0.02, 0.2), (0.5, 1.0))
    n = rng.uniform(0.2, 0.8) / h
    parameters = {"k": n * n, "d": 2 * z * n, "h": h}
    rates = lambda s, p, t: (s.v, s.u, 0 * s.x, 1 + 0 * s.x)
    model = Model("sampled", parameters, ("x", "v", "u", "clock"), rates)
    held = lambda s, p, t: (s.x, s.v, -p.k * s.x - p.d * s.v, 0 * s.clock)
    tick = Event(lambda s, p, t: s.clock - p.h, 1, then=lambda s, p, t: (model, held(s, p, t)))
    start = rng.uniform(0.1, 2.0), 0.0, 0.0, h * rng.uniform(0.0, 0.9)
    return Case(model, h * rng.uniform(20.0, 80.0), start, events=(tick,))


@family("engineers", "tables", "narrow")
def heads_over_narrow_marks(rng):
    """Three reading heads on a tape that slows down; its narrow marks are a table of position."""
    v, r, c, w = rng.values((0.5, 3.0), (0.02, 0.1), (2.0, 5.0), Log(1e-4, 0.1))
    gaps = 0.0, rng.uniform(0.3, 0.6), rng.uniform(0.7, 1.5)
    places = [-3.0, c, c + w, c + 2 * w, c + 2.5 * w, c + 3 * w, 20.0]
    marks = [0.0, 0.0, rng.uniform(0.5, 1.0) / w, 0.0, rng.uniform(-1.0, -0.5) / w, 0.0, 0.0]
    read = table(places, marks, "linear", "hold")
    parameters = {"r": r, "g1": gaps[1], "g2": gaps[2]}

    def rates(s, p, t):
        return s.v, -p.r * s.v, read(s.x) + 2 * read(s.x - p.g1) - read(s.x - p.g2)

    def exact(mp, s, p, t):
        far, rate = mp.mpf(s.v) / p.r, mp.mpf(p.r)
        x = -far * mp.expm1(-rate * t)

        def until(gap):
            """The integral of the table over the time, of a head that began at ``-gap``."""
            total = mp.mpf(0)
            for (a, f), (b, g) in pairwise(zip(places, marks, strict=True)):
                a, b, f, g = map(mp.mpf, (a, b, f, g))
                k, lo, hi = (g - f) / (b - a), max(a, -gap), min(b, x - gap)
                if hi > lo and (f or g):
                    # dt = dx / (r (far + ... - x)), about the point where the tape stops
                    stop = far - gap
                    log = mp.log((stop - lo) / (stop - hi))
                    total += ((f + k * (stop - a)) * log - k * (hi - lo)) / rate
            return total

        q = mp.mpf(s.q)
        for gap, weight in ((mp.mpf(0), 1), (mp.mpf(p.g1), 2), (mp.mpf(p.g2), -1)):
            q += weight * until(gap)
        return x, s.v * mp.exp(-rate * t), q

    T = rng.uniform(6.0, 8.0) / v
    return by_rates(rates, parameters, "x v q", T, (0.0, v, 0.0), exact=exact)


@family("engineers", "narrow", "events")
def light_gate_on_a_swing(rng):
    """A light gate whose signal is a narrow bell of the position: both edges of each passage."""
    n, X, w = rng.values((0.5, 4.0), (0.5, 2.0), Log(1e-5, 1e-2))
    parameters = {"n": n, "c": X * rng.uniform(-0.8, 0.8), "w": w}
    gate = Event(lambda s, p, t: exp(-(((s.x - p.c) / p.w) ** 2)) - 0.5)
    rates = lambda s, p, t: (s.v, -p.n * p.n * s.x)
    T = rng.uniform(5.0, 40.0) / n
    exact = lambda mp, s, p, t: (s.x * mp.cos(p.n * t), -p.n * s.x * mp.sin(p.n * t))

    def times(mp, s, p):
        half = p.w * mp.sqrt(mp.log(2))
        angles = [mp.acos((p.c + sign * half) / s.x) for sign in (1, -1)]
        turns = range(int(mp.mpf(T) * p.n / (2 * mp.pi)) + 2)
        both = [(2 * mp.pi * k + e * a) / p.n for k in turns for e in (1, -1) for a in angles]
        return sorted(t for t in both if 0 < t <= T)

    known = {"exact": exact, "events": (gate,), "event_times": times}
    return by_rates(rates, parameters, "x v", T, (X, 0.0), **known)


@family("engineers", "smooth")
def rotor_that_lacks_power(rng):
    """An unbalanced motor on springs, which is caught at the resonance or gets through it."""
    parameters = rng.parameters(k=1.0, c=(0.02, 0.1), e=(0.02, 0.1), M=(0.05, 0.4), s=(1.5, 3.0))

    def rates(s, p, t):
        u, e = p.M * (1 - s.w / p.s), p.e
        free = -p.k * s.x - p.c * s.v + e * s.w**2 * cos(s.phi)
        # x'' - e w' sin = free, w' - e x'' sin = u
        turn = (u + e * free * sin(s.phi)) / (1 - (e * sin(s.phi)) ** 2)
        return s.v, free + e * turn * sin(s.phi), s.w, turn

    return by_rates(rates, parameters, "x v phi w", rng.uniform(20.0, 100.0), (0.0, 0.0, 0.0, 0.0))


@family("engineers", "kinked", "forced")
def crane_by_phases(rng):
    """A trolley accelerates, runs and brakes by the clock, while the load is hoisted."""
    L, a, t1, t2, t3 = rng.values((5.0, 20.0), (0.2, 1.0), (2.0, 4.0), (1.0, 8.0), (1.0, 4.0))
    parameters = {"g": 9.81, "L": L, "h": L * rng.uniform(-0.5, 0.5) / (t1 + t2 + t3 + 5), "a": a}
    parameters |= {"t1": t1, "t2": t1 + t2, "t3": t1 + t2 + t3, "b": a * t1 / t3}

    def rates(s, p, t):
        push = where(t < p.t1, p.a, where(t < p.t2, 0.0, where(t < p.t3, -p.b, 0.0)))
        r = p.L - p.h * t
        swing = -(push * cos(s.phi) + p.g * sin(s.phi) - 2 * p.h * s.w) / r
        return s.v, push, s.w, swing

    return by_rates(rates, parameters, "x v phi w", t1 + t2 + t3 + 5.0, (0.0, 0.0, 0.0, 0.0))


@family("engineers", "events")
def cradle_of_two(rng):
    """Two pendulums side by side that knock together, with some loss."""
    n, e = rng.values((2.0, 5.0), (0.6, 0.98))
    parameters = {"n": n * n, "e": e, "m": rng.uniform(0.3, 3.0)}
    a = lambda s, p, t: (-p.n * sin(s.a), -p.n * sin(s.b))
    model = second_order("cradle", parameters, ("a", "b"), a)

    def knocked(s, p, t):
        both, apart = (s.da + p.m * s.db) / (1 + p.m), p.e * (s.da - s.db)
        return s.a, s.a, both - p.m / (1 + p.m) * apart, both + apart / (1 + p.m)

    knock = Event(lambda s, p, t: s.a - s.b, 1, then=lambda s, p, t: (model, knocked(s, p, t)))
    start = -rng.uniform(0.3, 1.5), rng.uniform(0.05, 0.8), 0.0, 0.0
    return Case(model, rng.uniform(4.0, 20.0) / n, start, events=(knock,))


@family("engineers", "narrow")
def plane_in_a_turning_beam(rng):
    """What a narrow radar beam deposits on an aeroplane each time it sweeps past."""
    w, W, v = rng.values(Log(1e-3, 0.1), (0.5, 2.0), (100.0, 300.0))
    parameters = {"w": w, "W": W, "I": W / w}
    x0, y0 = rng.uniform(3e3, 2e4), rng.uniform(-5e3, 5e3)

    def rates(s, p, t):
        # the sine of the angle from the beam, and no echo from behind
        off = (s.y * cos(p.W * t) - s.x * sin(p.W * t)) / sqrt(s.x**2 + s.y**2)
        along = (s.x * cos(p.W * t) + s.y * sin(p.W * t)) / sqrt(s.x**2 + s.y**2)
        return s.u, 0.0 * s.y, 0 * s.u, p.I * exp(-((off / p.w) ** 2)) * (1 + along) / 2

    T, met = rng.uniform(7.0, 20.0), math.atan2(y0, x0)
    hits = [t for k in range(20) if 0 < (t := (met + k * math.pi) / W) < T]
    knots = sorted({u for t in hits for u in around(t, w / W / 2, 12)})
    return by_rates(rates, parameters, "x y u q", T, (x0, y0, -v, 0.0), knots=tuple(knots))
