"""Plant and vehicles: valves, diodes, pulse-width drives, brakes, contacts. Written by someone who did
not write the methods, before any of them was read or run.
"""

import math
from itertools import pairwise

from newton_euler import atan, cos, exp, sin, sqrt, where
from tests.honesty.cases import Log, by_accelerations, by_rates, family


@family("engineers", "kinked", "forced")
def ship_in_a_following_sea(rng):
    """Roll of a ship whose righting lever waves change; quadratic damping; it may capsize."""
    n, h, q = rng.values((0.3, 1.5), (0.1, 1.2), (0.5, 2.2))
    parameters = {"k": n * n, "h": h, "q": q * n, "c": 0.02 * n, "e": rng.uniform(0.02, 0.5)}
    parameters["s"] = rng.uniform(0.2, 1.5)

    def rates(s, p, t):
        lever = p.k * (1 + p.h * cos(p.q * t)) * sin(s.a) * (1 - p.s * sin(s.a) ** 2)
        return s.w, -lever - p.c * s.w - p.e * (s.w * abs(s.w))

    start = rng.uniform(-0.6, 0.6), 0.0
    return by_rates(rates, parameters, "a w", rng.uniform(10.0, 60.0) / n, start)


@family("engineers", "narrow")
def engine_with_a_peak_of_pressure(rng):
    """A flywheel kicked once a turn by a peak of the crank's angle, a few degrees wide or less."""
    K, w0, loss = rng.values(Log(1e2, 1e7), (5.0, 50.0), (0.03, 0.3))
    turns, a0 = rng.randint(3, 12), rng.uniform(0.5, 5.5)
    load, wide = loss * w0**2 / 2 / (2 * math.pi), 1 / math.sqrt(K)
    kick = load * 2 * math.pi * rng.uniform(0.5, 1.5)
    parameters = {"M": kick / (wide * math.sqrt(2 * math.pi)), "K": K, "a0": a0, "L": load}
    rates = lambda s, p, t: (s.w, p.M * exp(p.K * (cos(s.a - p.a0) - 1)) - p.L)
    # the time of each peak, by the flywheel's energy between the peaks
    knots, t, v2 = [], 0.0, w0**2
    for a in (a0 + 2 * math.pi * n for n in range(turns)):
        way = a if not knots else 2 * math.pi
        met = math.sqrt(v2 - 2 * load * way)
        t, v2 = t + 2 * way / (math.sqrt(v2) + met), met**2 + 2 * kick
        knots += [t + wide / met * k for k in (-24, -12, -6, -4, -3, -2, -1, 0, 1, 2, 3, 4, 6, 12)]
        if v2 < 0.3 * w0**2:
            break
    T = t + rng.uniform(0.2, 0.6) * 2 * math.pi / math.sqrt(v2)
    return by_rates(rates, parameters, "a w", T, (0.0, w0), knots=knots)


@family("engineers", "kinked", "closed form")
def ball_on_a_hertz_contact(rng):
    """A ball flies against an elastic half-space, whose force goes as depth to the power 3/2."""
    v, x, k = rng.values((0.1, 5.0), (1e-3, 1.0), Log(1e3, 1e9))
    rates = lambda s, p, t: (s.v, where(s.x < 0, p.k * abs(s.x) ** 1.5, 0.0))

    def exact(mp, s, p, t):
        """With (depth / deepest)^(5/2) = sin(q)^2 the time is an incomplete beta function of q."""
        v, fifth = -s.v, mp.mpf(1) / 5
        deepest = (5 * v * v / (4 * mp.mpf(p.k))) ** (2 * fifth)
        half = 2 * fifth * mp.beta(2 * fifth, mp.mpf(1) / 2)
        past = (t - s.x / v) * v / deepest
        if past <= 0:
            return s.x - v * t, -v
        if past >= 2 * half:
            return deepest * (past - 2 * half), v
        goal, q = half - abs(past - half), mp.mpf(1)
        for _ in range(200):
            found = 2 * fifth * mp.betainc(2 * fifth, 0.5, 0, mp.sin(q) ** 2)
            new = q - (found - goal) / (4 * fifth * mp.sin(q) ** -fifth)
            new = min(max(new, q / 4), (q + mp.pi / 2) / 2)
            if abs(new - q) < mp.eps * 64 * q:
                break
            q = new
        speed = v * mp.cos(q) * (1 if past > half else -1)
        return -deepest * mp.sin(q) ** (4 * fifth), speed

    contact = 2.94 * (5 * v * v / (4 * k)) ** 0.4 / v
    T = x / v + contact * rng.uniform(0.3, 2.5)
    return by_rates(rates, {"k": k}, "x v", T, (x, -v), exact=exact)


@family("engineers", "kinked", "units")
def surge_tank_after_the_valve_shuts(rng):
    """The water of a tunnel swings into its tank when the turbine is shut; levels above the sea."""
    parameters = rng.parameters(L=(500.0, 8e3), k=(0.2, 3.0), f=(5.0, 60.0), H=(200.0, 2500.0))
    parameters |= rng.parameters(tc=Log(0.1, 60.0), v=(0.5, 3.0), g=9.81)

    def rates(s, p, t):
        out = where(t < p.tc, p.v * (1 - t / p.tc), 0.0)
        return (p.g * (p.H - s.z) - p.k * (s.u * abs(s.u))) / p.L, (s.u - out) / p.f

    v, H = parameters["v"], parameters["H"]
    start = v, H - parameters["k"] * v * v / 9.81
    period = 2 * math.pi * math.sqrt(parameters["L"] * parameters["f"] / 9.81)
    T = parameters["tc"] + period * rng.uniform(0.6, 3.0)
    return by_rates(rates, parameters, "u z", T, start)


@family("engineers", "stiff", "forced")
def rectifier_with_a_diode(rng):
    """A condenser behind a diode by Shockley's law, on the mains."""
    parameters = rng.parameters(V=(2.0, 12.0), q=2 * math.pi * 50, n=(0.03, 0.06), C=(2e-5, 2e-4))
    parameters |= rng.parameters(I=Log(1e-12, 1e-8), R=(5e2, 5e3))

    def rates(s, p, t):
        return ((p.I * (exp((p.V * sin(p.q * t) - s.u) / p.n) - 1) - s.u / p.R) / p.C,)

    return by_rates(rates, parameters, "u", rng.uniform(0.005, 0.05), (0.0,))


@family("engineers", "kinked", "closed form")
def motor_by_pulse_width(rng):
    """A DC motor on pulses that last a thousandth of their period to nearly all of it."""
    R, L, K, J = rng.values((0.5, 3.0), (1e-3, 1e-2), (0.05, 0.3), (1e-4, 1e-2))
    duty = rng.decades(1e-3, 0.95)
    parameters = {"R": R, "L": L, "K": K, "J": J, "c": 1e-4, "V": 24.0}
    parameters |= {"q": 2 * math.pi * rng.decades(50.0, 2e3), "s": math.cos(math.pi * duty)}

    def rates(s, p, t):
        u = where(sin(p.q * t) > p.s, p.V, 0.0)
        return (u - p.R * s.i - p.K * s.w) / p.L, (p.K * s.i - p.c * s.w) / p.J

    def exact(mp, s, p, t):
        """From one switching to the next, by the motor's two eigenvalues."""
        a, b, c, d = (mp.mpf(x) for x in (-p.R / p.L, -p.K / p.L, p.K / p.J, -p.c / p.J))
        mean, root = (a + d) / 2, mp.sqrt(mp.mpc(((a - d) / 2) ** 2 + b * c))
        on = mp.asin(mp.mpf(p.s))
        turns = int(t * p.q / (2 * mp.pi)) + 1
        times = [(x + 2 * mp.pi * k) / p.q for k in range(turns) for x in (on, mp.pi - on)]
        i, w = mp.mpf(s.i), mp.mpf(s.w)
        rest_i, rest_w = p.c * p.V / (p.R * p.c + p.K**2), p.K * p.V / (p.R * p.c + p.K**2)
        for begin, end in pairwise([mp.mpf(0), *(x for x in times if 0 < x < t), mp.mpf(t)]):
            h, u = end - begin, 1 if mp.sin(p.q * (begin + end) / 2) > p.s else 0
            e, ch = mp.exp(mean * h), mp.cosh(root * h).real
            sh = (mp.sinh(root * h) / root).real
            x, y = i - u * rest_i, w - u * rest_w
            i = u * rest_i + e * (x * ch + ((a - mean) * x + b * y) * sh)
            w = u * rest_w + e * (y * ch + (c * x + (d - mean) * y) * sh)
        return i, w

    T = rng.uniform(5.0, 40.0) * 2 * math.pi / parameters["q"]
    return by_rates(rates, parameters, "i w", T, (0.0, rng.uniform(0.0, 50.0)), exact=exact)


@family("engineers", "kinked", "mechanics")
def satellite_that_slews(rng):
    """A satellite turns by its quaternion to a new attitude; its wheels' moment is limited."""
    parameters = rng.parameters(A=(5.0, 10.0), B=(6.0, 11.0), C=(8.0, 14.0), M=Log(0.02, 1.0))
    n = rng.uniform(0.1, 0.6)
    parameters |= {"k": 2 * 8 * n * n, "d": 8 * 1.6 * n}

    def rates(s, p, t):
        wanted = [-p.k * x - p.d * u for x, u in ((s.x, s.u), (s.y, s.v), (s.z, s.w))]
        mx, my, mz = (where(m > p.M, p.M, where(m < -p.M, -p.M, m)) for m in wanted)
        return (
            (s.q * s.u + s.y * s.w - s.z * s.v) / 2,
            (s.q * s.v + s.z * s.u - s.x * s.w) / 2,
            (s.q * s.w + s.x * s.v - s.y * s.u) / 2,
            -(s.x * s.u + s.y * s.v + s.z * s.w) / 2,
            (mx - (p.C - p.B) * s.v * s.w) / p.A,
            (my - (p.A - p.C) * s.w * s.u) / p.B,
            (mz - (p.B - p.A) * s.u * s.v) / p.C,
        )

    half, axis = rng.uniform(0.3, 1.4), [rng.gauss(0, 1) for _ in range(3)]
    size = math.sqrt(sum(x * x for x in axis))
    start = *(math.sin(half) * x / size for x in axis), math.cos(half)
    start += tuple(rng.uniform(-0.05, 0.05) for _ in range(3))
    return by_rates(rates, parameters, "x y z q u v w", rng.uniform(3.0, 25.0) / n, start)


@family("engineers", "kinked", "long")
def ion_engine_that_rests_in_the_shadow(rng):
    """A spiral outwards by a small thrust along the velocity, off in the planet's shadow."""
    r, a = rng.values((1.05, 3.0), Log(1e-5, 1e-2))
    parameters = {"R": 1.0, "a": a, "gm": 1.0}

    def accelerations(s, p, t):
        thrust = where(s.x < 0, where(abs(s.y) < p.R, 0.0, p.a), p.a)
        k, push = p.gm / sqrt(s.x**2 + s.y**2) ** 3, thrust / sqrt(s.dx**2 + s.dy**2)
        return push * s.dx - k * s.x, push * s.dy - k * s.y

    angle = rng.uniform(-1.2, 1.2)
    speed = rng.uniform(1.0, 1.1) / math.sqrt(r)
    start = (r * math.cos(angle), r * math.sin(angle),
             -speed * math.sin(angle), speed * math.cos(angle))  # fmt: skip
    T = rng.uniform(1.2, 12.0) * 2 * math.pi * r**1.5
    return by_accelerations(accelerations, parameters, "x y", T, start)


@family("engineers", "closed form", "scales")
def radiator_that_cools(rng):
    """A body that radiates towards the temperature of its room, 3 to 300 K, and counts its heat."""
    room, c = rng.values((3.0, 300.0), Log(1e-3, 1e4))
    ratio = rng.choice((1 + rng.decades(1e-4, 10.0), rng.uniform(0.1, 0.99)))
    parameters = {"k": 1 / room**3, "a": room, "c": c}

    def rates(s, p, t):
        loss = p.k * (s.T**4 - p.a**4)
        return -loss, p.c * loss

    def exact(mp, s, p, t):
        """log|(T-a)/(T+a)|/4 - atan(T/a)/2 falls as k a^3 t: Newton's method in the logarithm."""
        a, warm = mp.mpf(p.a), p.a < s.T
        now = lambda e: (1 + e) / (1 - e) if warm else (1 - e) / (1 + e)
        y = mp.log(abs(s.T - a) / (s.T + a))
        goal = y / 4 - mp.atan(s.T / a) / 2 - p.k * a**3 * t
        y = 4 * goal + mp.pi / 2
        y = min(y, mp.mpf(-1) / 10**6)
        for _ in range(300):
            e = mp.exp(y)
            ratio = now(e)
            slope = 2 * e / (1 - e) ** 2 if warm else -2 * e / (1 + e) ** 2
            new = y - (y / 4 - mp.atan(ratio) / 2 - goal) / (0.25 - slope / (1 + ratio**2) / 2)
            new = min(new, y / 2)
            if abs(new - y) < mp.eps * 16 * abs(y):
                break
            y = new
        T = a * now(mp.exp(y))
        return T, s.q + p.c * (s.T - T)

    start = room * ratio, 0.0
    return by_rates(rates, parameters, "T q", rng.uniform(0.1, 6.0), start, exact=exact)


@family("engineers", "kinked", "stiff")
def wheel_that_locks(rng):
    """A braked car and the slip of its wheel; the brake's moment rises, then stays constant."""
    parameters = rng.parameters(B=(8.0, 15.0), C=(1.3, 1.7), D=(0.3, 1.1), R=0.3, I=(0.5, 2.0))
    parameters |= rng.parameters(N=(2e3, 5e3), t1=Log(1e-3, 1.0), g=9.81)
    parameters["M"] = parameters["D"] * parameters["N"] * 0.3 * rng.uniform(0.5, 1.3)
    v = rng.uniform(10.0, 40.0)

    def rates(s, p, t):
        moment = p.M * where(t < p.t1, t / p.t1, 1.0)
        grip = p.D * sin(p.C * atan(p.B * (s.v - p.R * s.w) / s.v))
        return -p.g * grip, (p.R * p.N * grip - moment) / p.I, s.v

    T = v / 9.81 / parameters["D"] * rng.uniform(0.1, 0.6)
    return by_rates(rates, parameters, "v w x", T, (v, v / 0.3, 0.0))


@family("engineers", "multi-scale", "forced")
def wind_turbine_by_heiers_curve(rng):
    """Rotor and generator on a stiff shaft, with Heier's power curve, in a wind that varies."""
    parameters = rng.parameters(v=(7.0, 14.0), e=(0.05, 0.25), q=(0.3, 3.0), R=(20.0, 50.0))
    parameters |= rng.parameters(b=(0.0, 8.0), j=Log(3e-3, 0.1), K=Log(10.0, 1e4), c=(0.05, 1.0))
    R, v = parameters["R"], parameters["v"]
    # the moment over the rotor's inertia; the load that balances it at a tip speed ratio of 7
    parameters |= {"s": rng.uniform(0.02, 0.1) / R, "z": 0.02 * v / R**2 / 49}

    def rates(s, p, t):
        wind = p.v * (1 + p.e * sin(p.q * t))
        ratio = s.w * p.R / wind
        i = 1 / (ratio + 0.08 * p.b) - 0.035 / (p.b**3 + 1)
        power = 0.5176 * (116 * i - 0.4 * p.b - 5) * exp(-21 * i) + 0.0068 * ratio
        moment = p.s * wind**2 * power / ratio
        shaft = p.K * s.twist + p.c * (s.w - s.g)
        return moment - shaft * p.j, shaft - p.z * p.R * s.g**2 / p.j, s.w - s.g

    w = v / R * rng.uniform(4.0, 9.0)
    return by_rates(rates, parameters, "w g twist", rng.uniform(5.0, 40.0), (w, w, 0.0))


@family("engineers", "near-singular", "tiny")
def ball_below_a_magnet(rng):
    """A steel ball held below a magnet by its current, which a controller sets; in SI units."""
    d, m = rng.values((2e-3, 2e-2), (5e-3, 0.1))
    current, g = rng.uniform(0.3, 2.0), 9.81
    C, L, R = m * g * d**2 / current**2, rng.uniform(0.02, 0.3), rng.uniform(2.0, 20.0)
    n = math.sqrt(g / d)
    parameters = {"g": g, "C": C / m, "d": d, "L": L, "R": R, "i": current}
    parameters |= {
        "P": current / d * rng.uniform(1.5, 3.0),
        "D": current / d / n * rng.uniform(1, 2),
    }
    parameters["G"] = L * n * rng.uniform(8.0, 30.0)

    def rates(s, p, t):
        wanted = p.i + p.P * (s.x - p.d) + p.D * s.v
        return s.v, p.g - p.C * s.c**2 / s.x**2, (p.R * (wanted - s.c) + p.G * (wanted - s.c)) / p.L

    start = d * (1 + rng.uniform(-0.2, 0.2)), 0.0, current
    return by_rates(rates, parameters, "x v c", rng.uniform(3.0, 40.0) / n, start)
