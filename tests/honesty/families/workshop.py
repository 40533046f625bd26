"""Cases of a workshop: drives, tethers, wells and tables as their users write them. Written by someone
who did not write the methods, before any of them was read or run.
"""

import math
from itertools import pairwise

from newton_euler import Event, Model, atan, cos, exp, sin, table, tanh
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, Log, around, by_accelerations, by_rates, family


def _time_to(speed, length, parts=4000):
    """The time for a length at a speed that depends on the position (midpoint rule)."""
    h = length / parts
    return sum(h / speed((k + 0.5) * h) for k in range(parts))


@family("engineers", "multi-scale")
def tether_that_is_paid_out(rng):
    """A dumbbell in orbit swings about the vertical while its tether runs out, then is stopped."""
    n, t1, b = rng.values((9e-4, 1.2e-3), (1e3, 5e3), Log(1.0, 300.0))
    parameters = {"n": n, "v": rng.uniform(1.0, 8.0), "t1": t1, "b": b}
    start = rng.uniform(-0.5, 0.5), 0.0, rng.uniform(50.0, 500.0)

    def rates(s, p, t):
        pace = p.v * (1 - tanh((t - p.t1) / p.b)) / 2
        swing = -2 * pace / s.l * (s.w + p.n) - 3 * p.n**2 * sin(s.a) * cos(s.a)
        return s.w, swing, pace

    T = t1 + rng.uniform(1e3, 2e4)
    return by_rates(rates, parameters, "a w l", T, start, knots=around(t1, b, 30))


@family("engineers", "events", "tables")
def ball_with_a_table_of_restitution(rng):
    """A ball whose restitution was measured at five speeds; each impact looks it up."""
    g, h = rng.values((1.5, 10.0), (0.5, 5.0))
    top = math.sqrt(2 * g * h)
    losses = sorted(rng.uniform(0.55, 0.98) for _ in range(5))[::-1]
    measured = table([0.0, *(top * x for x in (0.2, 0.45, 0.8, 1.1))], losses, "linear", "hold")
    model = second_order("measured impact", {"g": g}, ("z",), lambda s, p, t: (-p.g,))
    thrown_back = lambda s, p, t: (0 * s.z, -s.dz * measured(-s.dz))
    floor = Event(lambda s, p, t: s.z, -1, then=lambda s, p, t: (model, thrown_back(s, p, t)))
    T = top / g * rng.uniform(1.5, 5.0)
    return Case(model, T, (h, 0.0), events=(floor,))


@family("engineers", "narrow")
def brake_at_the_foot_of_a_valley(rng):
    """A truck rolls down a parabola, by its horizontal position, past a narrow brake."""
    g, k, h = rng.values((5.0, 10.0), (0.05, 0.4), (2.0, 8.0))
    w, c = rng.decades(1e-4, 1e-1), h * rng.uniform(0.2, 0.9)
    pace = lambda s: math.sqrt(g * k * (h * h - (h - s) ** 2) / (1 + (k * (h - s)) ** 2) + 1e-12)
    v = pace(c)
    parameters = {"g": g, "k": k, "w": w, "c": h - c, "A": v * rng.uniform(0.1, 0.6) / w / 1.8}

    def rates(s, p, t):
        # y = k x^2/2, and the brake goes by the distance from c
        brake = p.A * exp(-(((s.x - p.c) / p.w) ** 2)) * s.v
        return s.v, -(p.k**2 * s.x * s.v**2 + p.g * p.k * s.x) / (1 + (p.k * s.x) ** 2) - brake

    v0 = rng.uniform(0.5, 2.0)
    quick = lambda s: math.sqrt(
        (v0**2 * (1 + (k * h) ** 2) + g * k * (h * h - (h - s) ** 2)) / (1 + (k * (h - s)) ** 2)
    )
    met = _time_to(quick, c)
    return by_rates(rates, parameters, "x v", met + h / v * rng.uniform(0.1, 0.4), (h, -v0), knots=around(met, w / quick(c) / 2, 40))  # fmt: skip


@family("engineers", "scales")
def torsion_wire_after_many_turns(rng):
    """A torsion wire at thousands of turns; its drive follows a clock that is a state."""
    w, q, turns = rng.values((0.5, 5.0), (0.2, 0.45), Log(1e2, 1e5))
    parameters = {"k": w * w, "f": w * w * rng.decades(1e-3, 1e-1), "q": w * q}
    parameters["a0"] = 2 * math.pi * round(turns)
    clock = rng.decades(1.0, 1e4)

    def rates(s, p, t):
        return s.v, -p.k * (s.a - p.a0) + p.f * cos(p.q * s.clock), 1.0 + 0.0 * s.a

    def exact(mp, s, p, t):
        w, q, x = mp.sqrt(p.k), mp.mpf(p.q), s.a - mp.mpf(p.a0)
        b = p.f / (w * w - q * q)
        free = closed_forms.oscillator(
            mp, w, x - b * mp.cos(q * s.clock), s.v + b * q * mp.sin(q * s.clock), t
        )
        now = s.clock + t
        return (free[0] + b * mp.cos(q * now) + p.a0, free[1] - b * q * mp.sin(q * now), now)

    start = parameters["a0"] + rng.uniform(0.1, 2.0), 0.0, clock
    return by_rates(rates, parameters, "a v clock", rng.uniform(5.0, 60.0) / w, start, exact=exact)


@family("engineers", "near-singular")
def marble_barely_over_a_hump(rng):
    """A marble comes from afar with barely more, or less, energy than the top of a sech^2 hump."""
    V, w = rng.values((0.5, 5.0), (0.2, 3.0))
    E = V * (1 + rng.either(rng.decades(1e-6, 1e-1)))
    x0 = -w * rng.uniform(2.0, 5.0)
    v0 = math.sqrt(2 * (E - V / math.cosh(x0 / w) ** 2))
    parameters = {"V": V, "w": w}

    def rates(s, p, t):
        h = tanh(s.x / p.w)
        return s.v, 2 * p.V / p.w * h * (1 - h * h)

    def exact(mp, s, p, t):
        """sinh(x/w) is a hyperbolic sine of the time, or a cosine below the top (Poeschl, Teller)."""
        w, V = mp.mpf(p.w), mp.mpf(p.V)
        u, far = mp.sinh(s.x / w), s.v**2 / 2 + V / mp.cosh(s.x / w) ** 2
        k = mp.sqrt(2 * far) / w
        # u'' = k^2 u
        rate = s.v / w * mp.cosh(s.x / w)
        now = u * mp.cosh(k * t) + rate / k * mp.sinh(k * t)
        pace = u * k * mp.sinh(k * t) + rate * mp.cosh(k * t)
        return w * mp.asinh(now), w * pace / mp.sqrt(1 + now * now)

    T = w / math.sqrt(V) * rng.uniform(6.0, 20.0)
    return by_rates(rates, parameters, "x v", T, (x0, v0), exact=exact)


@family("engineers", "narrow")
def trolley_over_a_smooth_step(rng):
    """A trolley on a path of metres over a step whose edge is rounded within 0.1 m or less."""
    w, E, L = rng.values(Log(1e-6, 1e-1), (1.0, 10.0), (1.0, 10.0))
    V = E * rng.choice((-1.0, 1.0)) * rng.uniform(0.1, 0.9)
    parameters = {"F": V / 2 / w, "w": w}
    rates = lambda s, p, t: (s.v, -p.F * (1 - tanh(s.x / p.w) ** 2))

    def exact(mp, s, p, t):
        """The time to a position is a sum of logarithms; the position by Newton's method."""
        w, V = mp.mpf(p.w), 2 * mp.mpf(p.F) * p.w
        before = lambda x: 1 / (1 + mp.exp(2 * x / w))  # (1 - tanh)/2
        E = s.v**2 / 2 + V * (1 - before(s.x))
        u1, u2 = mp.sqrt(2 * E), mp.sqrt(2 * (E - V))

        def since(x):
            u = mp.sqrt(2 * (E - V * (1 - before(x))))
            low = -mp.log1p(mp.exp(2 * x / w))  # log before, and log(1 - before)
            high = -mp.log1p(mp.exp(-2 * x / w))
            one = 2 * mp.log(u + u2) - low
            two = 2 * mp.log(u + u1) - high
            return w / 2 * (one / u2 - two / u1), u

        begun, x = since(s.x)[0], mp.mpf(s.x)
        lo, hi = s.x, s.x + 2 * t * max(u1, u2) + w
        for _ in range(300):
            passed, u = since(x)
            short = t - (passed - begun)
            lo, hi = (x, hi) if short > 0 else (lo, x)
            new = x + u * short
            if not lo < new < hi:
                new = (lo + hi) / 2
            if abs(new - x) < mp.eps * 16 * abs(s.x):
                return new, since(new)[1]
            x = new
        return x, since(x)[1]

    v = math.sqrt(2 * E)
    return by_rates(rates, parameters, "x v", L / v * rng.uniform(1.2, 2.5), (-L, v), exact=exact)


@family("engineers", "narrow")
def ion_through_a_narrow_well(rng):
    """An ion that a sech^2 well on a long path moves forward a little; its passage is counted."""
    w, E, L = rng.values(Log(1e-5, 1e-1), (0.5, 5.0), (1.0, 10.0))
    parameters = {"V": E * rng.uniform(0.5, 50.0), "w": w, "I": 1 / w}

    def rates(s, p, t):
        h = tanh(s.x / p.w)
        return s.v, -2 * p.V / p.w * h * (1 - h * h), p.I * (1 - h * h) * s.v

    def exact(mp, s, p, t):
        w, V = mp.mpf(p.w), mp.mpf(p.V)
        far = mp.sqrt(s.v**2 - 2 * V / mp.cosh(s.x / w) ** 2)
        B, k = mp.sqrt(1 + 2 * V / far**2), far / w
        phase = mp.asinh(mp.sinh(s.x / w) / B) + k * t
        u = B * mp.sinh(phase)
        x = w * mp.asinh(u)
        counted = mp.mpf(p.I) * w * (mp.tanh(x / w) - mp.tanh(s.x / w))
        return x, far * B * mp.cosh(phase) / mp.sqrt(1 + u * u), s.q + counted

    v = math.sqrt(2 * E)
    T = L / v * rng.uniform(1.2, 2.5)
    return by_rates(rates, parameters, "x v q", T, (-L, v, 0.0), exact=exact)


@family("engineers", "stiff")
def stage_that_slips_and_sticks(rng):
    """A stage on a piezo drive that goes slowly forward, fast back; friction by a steep tanh."""
    w, mu = rng.values((20.0, 200.0), (0.5, 3.0))
    parameters = {"w": w, "mu": mu, "V": mu / w * rng.uniform(0.3, 3.0), "c": rng.uniform(0.0, 1.0)}
    parameters["e"] = parameters["V"] * rng.decades(3e-2, 3e-1)

    def rates(s, p, t):
        drive = p.V * (sin(p.w * t) + 0.5 * sin(2 * p.w * t) + sin(3 * p.w * t) * p.c / 3)
        return s.v, p.mu * tanh((drive - s.v) / p.e)

    turns = rng.uniform(2.0, 5.0)
    knots = tuple(2 * math.pi / w * k / 100 for k in range(1, int(100 * turns)))
    return by_rates(rates, parameters, "x v", turns / w * 2 * math.pi, (0.0, 0.0), knots=knots)


@family("engineers", "stiff", "forced")
def gear_train_with_smooth_play(rng):
    """Three wheels with play between their teeth, smoothed by tanh; the motor hums."""
    b, K = rng.values(Log(1e-3, 3e-2), Log(1e2, 1e4))
    parameters = {"b": b, "K": K, "c": 0.02 * math.sqrt(K)}
    parameters |= rng.parameters(M=(0.5, 3.0), w=(1.0, 20.0), J=(0.3, 3.0), r=(0.05, 0.5))
    force = lambda p, x, v: p.K * (x - p.b * tanh(x / p.b)) + p.c * v * tanh(x / p.b) ** 2

    def accelerations(s, p, t):
        f = force(p, s.a - s.u, s.da - s.du)
        h = force(p, s.u - s.z, s.du - s.dz)
        return p.M * cos(p.w * t) - f, (f - h) / p.J, h - p.r * s.dz

    start = tuple(rng.uniform(-b, b) / 2 for _ in range(3)) + (rng.uniform(-1.0, 1.0), 0.0, 0.0)
    return by_accelerations(accelerations, parameters, "a u z", rng.uniform(1.0, 8.0), start)


@family("engineers", "tables", "events")
def rocket_by_its_thrust_table(rng):
    """A rocket: a measured thrust, a mass that burns with it, and a stage dropped at a set time."""
    times = [0.0, 0.1, 0.6, *sorted(rng.uniform(0.8, 3.0) for _ in range(3)), 3.4, 3.5]
    thrust = [0.0, *(rng.uniform(20.0, 60.0) for _ in range(6)), 0.0]
    push = table(times, thrust, "linear", "hold")
    m0, c, t1 = rng.values((1.0, 3.0), (1500.0, 2500.0), (3.6, 5.0))
    parameters = {"g": 9.81, "c": c, "k": rng.uniform(0.0, 0.05)}
    model = Model("thrust table", parameters, ("v", "m"),
                  lambda s, p, t: (push(t) / s.m - p.g, -push(t) / p.c - p.k * s.m))  # fmt: skip
    left = rng.uniform(0.3, 0.8)
    dropped = lambda s, p, t: (s.v, s.m * left)
    cast_off = Event(lambda s, p, t: t - t1, 1, then=lambda s, p, t: (model, dropped(s, p, t)))

    def exact(mp, s, p, t):
        """m' = -f/c - k m is linear, and v = c log(m0/m) - (c k + g) t since v' + c m'/m = -c k - g."""
        m, k = mp.mpf(s.m), mp.mpf(p.k)
        for (a, f), (b, h) in pairwise(
            [*zip(map(mp.mpf, times), thrust, strict=True), (mp.inf, 0)]
        ):
            if a >= t:
                break
            u, slope = min(b, t) - a, (mp.mpf(h) - f) / (b - a) if b < mp.inf else mp.mpf(0)
            forced = mp.quad(
                lambda x, a=a, f=f, s=slope, u=u: (f + s * x) * mp.exp(k * (x - u)), [0, u]
            )
            m = m * mp.exp(-k * u) - forced / p.c
        burnt = mp.log(s.m / m)
        return s.v + p.c * burnt - (p.c * k + p.g) * t, m * (left if t > t1 else 1)

    T = rng.uniform(5.5, 9.0)
    return Case(model, T, (0.0, m0), events=(cast_off,), exact=exact,
                event_times=lambda mp, s, p: [mp.mpf(t1)])  # fmt: skip


@family("engineers", "multi-scale", "mechanics")
def fast_top_that_nutates(rng):
    """Lagrange's top by Euler's angles: hundreds of small loops, from a cusp or from rest."""
    A, C, mgl, spin = rng.values((0.5, 2.0), (0.3, 1.5), (0.5, 5.0), Log(20.0, 400.0))
    theta, rate = rng.values((0.2, 2.5), (-0.3, 0.3))
    L = C * spin
    parameters = {"A": A, "L": L, "G": L * math.cos(theta) + A * rate * math.sin(theta) ** 2}
    parameters |= {"m": mgl, "i": 1 / C}

    def rates(s, p, t):
        turn = (p.G - p.L * cos(s.theta)) / (p.A * sin(s.theta) ** 2)
        lean = turn * sin(s.theta) * (p.A * turn * cos(s.theta) - p.L) + p.m * sin(s.theta)
        return s.w, lean / p.A, turn, p.L * p.i - turn * cos(s.theta)

    T = rng.uniform(20.0, 150.0) * 2 * math.pi * A / L
    return by_rates(rates, parameters, "theta w phi psi", T, (theta, 0.0, 0.0, 0.0))


@family("engineers", "events")
def pendulum_on_a_peg(rng):
    """A pendulum whose string catches on a peg, and is free again as it swings back."""
    g, L = rng.values((2.0, 10.0), (0.5, 3.0))
    parameters = {"g": g, "a": rng.uniform(-0.3, 0.3), "sum": L * (1 + rng.uniform(0.2, 0.8))}
    model = Model("peg", parameters, ("theta", "w", "L"),
                  lambda s, p, t: (s.w, -p.g / s.L * sin(s.theta), 0 * s.L))  # fmt: skip

    def caught(s, p, t):
        """The speed stays, and the radius becomes the other one."""
        return s.theta, s.w * s.L / (p.sum - s.L), p.sum - s.L

    at = lambda s, p, t: s.theta - p.a
    then = lambda s, p, t: (model, caught(s, p, t))
    T = rng.uniform(3.0, 12.0) * math.sqrt(L / g)
    start = rng.uniform(0.6, 1.4), 0.0, L
    return Case(model, T, start, events=(Event(at, 0, then=then),))


@family("engineers", "narrow", "smooth")
def car_through_a_cloud_of_dust(rng):
    """A cloud, by a Lorentzian of the distance from its centre, on a car's curved path."""
    v, R, w = rng.values((5.0, 20.0), (20.0, 100.0), Log(1e-3, 1.0))
    angle, off = rng.uniform(0.3, 2.0), w * rng.uniform(-1.0, 1.0)
    # on a circle about (0, R) from the origin
    parameters = {"R": R, "w": w, "px": (R + off) * math.sin(angle)}
    parameters |= {"py": R - (R + off) * math.cos(angle), "A": v / w * rng.uniform(0.05, 0.5)}

    def rates(s, p, t):
        near = ((s.x - p.px) ** 2 + (s.y - p.py) ** 2) / p.w**2
        return s.v * cos(s.h), s.v * sin(s.h), s.v / p.R, -p.A * s.v / (1 + near) ** 2

    met = R * angle / v
    T, start = met * rng.uniform(1.3, 2.5), (0.0, 0.0, 0.0, v)
    return by_rates(rates, parameters, "x y h v", T, start, knots=around(met, w / v / 2, 40))


@family("engineers", "narrow")
def needle_over_a_ferrite(rng):
    """A compass needle that swings over a narrow attractive mark, by an arctangent's slope."""
    k, w, X = rng.values((1.0, 20.0), Log(1e-4, 1e-1), (0.3, 1.2))
    at = X * rng.uniform(-0.5, 0.5)
    parameters = {"k": k, "w": w, "a": at, "M": k * X * rng.uniform(0.02, 0.3), "c": 0.1}

    def accelerations(s, p, t):
        # a moment that changes its sign at the mark, within w
        return (-p.k * s.x - p.M * atan((s.x - p.a) / p.w) - p.c * s.dx,)

    T = rng.uniform(2.0, 8.0) / math.sqrt(k)
    return by_accelerations(accelerations, parameters, "x", T, (X, 0.0))
