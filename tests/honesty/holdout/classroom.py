"""Scenes of a first course, in the code of its students."""

import math

from newton_euler import Event, Model, acos, asin, atan2, cos, sin, sqrt, tan, where
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, held_out


@held_out("kinked", "sticking")
def skidding_then_rolling(rng):
    """A bowling ball that skids until it rolls; its two speeds alone, constant from then on."""

    def rates(s, p, t):
        slip = s.v - p.R * s.w
        f = where(slip > 0, -1.0, where(slip < 0, 1.0, 0.0)) * p.mu * p.g
        return f, -2.5 * f / p.R

    def exact(mp, s, p, t):
        slip = s.v - p.R * s.w
        sign, t = mp.sign(slip), min(t, abs(slip) / (mp.mpf(7) / 2 * p.mu * p.g))
        f = -sign * p.mu * p.g
        return s.v + f * t, s.w - mp.mpf(5) / 2 * f / p.R * t

    mu, v, w = rng.values((0.05, 0.3), (4.0, 9.0), (-30.0, 30.0))
    rolls = (v - 0.108 * w) / (3.5 * mu * 9.81)
    T = rolls * rng.choice((0.6, 0.95, 1.4))
    return by_rates(rates, {"mu": mu, "g": 9.81, "R": 0.108}, "v w", T, (v, w), exact=exact)


@held_out("kinked")
def up_and_down_a_rough_plank(rng):
    """A block kicked up a slope too steep for it to stay at rest."""

    def rates(s, p, t):
        a = p.deg * (math.pi / 180)
        return s.v, -p.g * sin(a) - p.mu * p.g * cos(a) * where(s.v > 0, 1, -1)

    def exact(mp, s, p, t):
        a = p.deg * mp.mpf(math.pi / 180)
        up, down = p.g * (mp.sin(a) + p.mu * mp.cos(a)), p.g * (mp.sin(a) - p.mu * mp.cos(a))
        first = min(t, s.v / up)
        then = t - first
        x = s.v * first - up * first**2 / 2 - down * then**2 / 2 + s.x
        return x, s.v - up * first - down * then

    slope, mu, v, T = rng.values((25.0, 60.0), (0.05, 0.4), (1.0, 12.0), (1.5, 5.0))
    parameters = {"g": 9.81, "mu": mu, "deg": slope}
    return by_rates(rates, parameters, "x v", v / 9.81 * T, (0.0, v), exact=exact)


@held_out("kinked")
def bungee_jump(rng):
    """Free fall, then a cord with damping, then flight again; air drag as c v |v|."""
    parameters = rng.parameters(
        m=(50.0, 100.0), g=9.81, L=(10.0, 30.0), k=(50.0, 200.0), b=(0.0, 30.0), c=(0.05, 0.4)
    )

    def rates(s, p, t):
        cord = where(s.y > p.L, p.k * (s.y - p.L) + p.b * s.v, 0.0)
        return s.v, p.g - cord / p.m - p.c / p.m * s.v * abs(s.v)

    T = rng.uniform(4.0, 30.0)
    return by_rates(rates, parameters, "y v", T, (0.0, 0.0))


@held_out("kinked", "forced")
def parachute(rng):
    """A jump from rest; the canopy opens at a given instant and the drag jumps by a hundred."""
    parameters = rng.parameters(g=9.81, c1=(0.002, 0.005), c2=(0.1, 0.6), t1=(3.0, 15.0))

    def rates(s, p, t):
        drag = where(t < p.t1, p.c1, p.c2)
        return -s.v, p.g - drag * s.v * sqrt(s.v * s.v)

    T, h = rng.values((1.0, 20.0), (500.0, 4000.0))
    return by_rates(rates, parameters, "h v", parameters["t1"] + T, (h, 0.0))


@held_out("forced")
def kapitza(rng):
    """An inverted pendulum that stands because its pivot shakes fast."""
    parameters = rng.parameters(g=9.81, L=(0.2, 1.0), a=(0.01, 0.05), W=(50.0, 150.0), c=(0.0, 0.5))

    def accelerations(s, p, t):
        return ((p.g - p.a * p.W * p.W * cos(p.W * t)) / p.L * sin(s.th) - p.c * s.dth,)

    T, th = rng.values((0.5, 2.0), (0.01, 0.5))
    return by_accelerations(accelerations, parameters, "th", T, (rng.either(th), 0.0))


@held_out("events", "equilibrium")
def ladder_leaves_the_wall(rng):
    """A ladder from almost upright at a smooth wall, until it loses contact."""
    tilt, L = rng.values(Log(1e-4, 0.3), (1.0, 6.0))
    parameters = {"g": 9.81, "L": L, "c0": math.cos(tilt)}
    a = lambda s, p, t: (1.5 * p.g / p.L * sin(s.th),)
    free = Event(lambda s, p, t: 3 * cos(s.th) - 2 * p.c0, -1, True, name="leaves the wall")
    T = (math.log(4 / tilt) + 2.0) / math.sqrt(1.5 * 9.81 / L)
    return by_accelerations(a, parameters, "th", T, (tilt, 0.0), events=(free,))


@held_out("forced", "law")
def pendulum_on_a_winch(rng):
    """A pendulum whose length is a law of time, as is the rate of its length."""
    numbers = rng.parameters(g=9.81, L0=(0.5, 2.0), a=(0.05, 0.3), w=(0.5, 6.0))
    rates = lambda s, p, t: (s.om, -(2 * p.dL * s.om + p.g * sin(s.th)) / p.L)

    def written(s, p, t):
        L = p.L0 + p.a * sin(p.w * t)
        return s.om, -(2 * p.a * p.w * cos(p.w * t) * s.om + p.g * sin(s.th)) / L

    laws = {
        "L": lambda s, p, t: p.L0 + p.a * sin(p.w * t),
        "dL": lambda s, p, t: p.a * p.w * cos(p.w * t),
    }
    T, th = rng.values((3.0, 15.0), (0.1, 1.5))
    written_out = Model("winch", numbers, ("th", "om"), written)
    return by_rates(rates, {**numbers, **laws}, "th om", T, (th, 0.0), written_out=written_out)


@held_out("kinked", "law")
def model_rocket(rng):
    """A rocket of a kit: thrust by a table in time, mass that follows it, drag v sqrt(v v)."""
    numbers = rng.parameters(g=9.81, F1=(15.0, 30.0), F2=(4.0, 8.0), ta=(0.2, 0.5), tb=(1.0, 2.0))
    numbers |= rng.parameters(c=Log(1e-5, 1e-3), u=800.0)

    def rates(s, p, t):
        return s.v, (p.thrust - p.c * s.v * sqrt(s.v * s.v)) / s.m - p.g, -p.thrust / p.u

    thrust = lambda s, p, t: where(t < p.ta, p.F1, where(t < p.tb, p.F2, 0.0))

    def written(s, p, t):
        F = thrust(s, p, t)
        return s.v, (F - p.c * s.v * abs(s.v)) / s.m - p.g, -F / p.u

    name, states = "model rocket", ("h", "v", "m")
    model = Model(name, {**numbers, "thrust": thrust}, states, rates)
    T, m = rng.values((0.2, 6.0), (0.2, 0.6))
    written = Model(name, numbers, states, written)
    return Case(model, numbers["tb"] + T, (0.0, 0.0, m), written_out=written)


@held_out("events", "tiny")
def rope_off_a_table(rng):
    """A rope slips off a table: a billionth to a tenth of it hangs at first, then all of it."""
    n = math.sqrt(9.81 / rng.uniform(0.5, 3.0))
    hangs = rng.decades(1e-9, 0.1)
    T = math.acosh(1 / hangs) / n * rng.uniform(0.7, 1.3)

    def exact(mp, s, p, t):
        return s.x * mp.cosh(p.n * t), s.x * p.n * mp.sinh(p.n * t)

    def times(mp, s, p):
        t = mp.acosh(p.L / s.x) / p.n
        return [t] if t <= T else []

    model = second_order("rope", {"n": n, "L": 1.0}, ("x",), lambda s, p, t: (p.n * p.n * s.x,))
    event = Event(lambda s, p, t: s.x - p.L, 1, name="all of it hangs")
    return Case(model, T, (hangs, 0.0), exact=exact, events=(event,), event_times=times)


@held_out("near-singular")
def gimbal_in_degrees(rng):
    """Yaw, pitch and roll, in degrees, of a body that turns steadily past a pitch near 90."""
    parameters = rng.parameters(wx=(-20.0, 20.0), wy=(10.0, 30.0), wz=Log(0.02, 5.0))
    parameters["rad"] = math.pi / 180

    def rates(s, p, t):
        sr, cr = sin(s.roll * p.rad), cos(s.roll * p.rad)
        turn = p.wy * sr + p.wz * cr
        pitch = s.pitch * p.rad
        return turn / cos(pitch), p.wy * cr - p.wz * sr, p.wx + turn * tan(pitch)

    parameters["wx"] *= rng.choice((0.0, 0.01, 1.0))
    T, pitch = rng.values((0.8, 2.5), (0.0, 30.0))
    start = 0.0, pitch, 0.0
    return by_rates(rates, parameters, "yaw pitch roll", 90.0 / parameters["wy"] * T, start)


@held_out("chaotic")
def swinging_atwood(rng):
    """Atwood's machine of which one mass swings."""
    parameters = {"mu": rng.choice((3.0, rng.uniform(1.5, 4.0))), "g": 9.81}

    def accelerations(s, p, t):
        r = (s.r * s.dth * s.dth - p.g * (p.mu - cos(s.th))) / (1 + p.mu)
        return r, -(2 * s.dr * s.dth + p.g * sin(s.th)) / s.r

    T, *start = rng.values((0.5, 2.5), (0.8, 1.5), (1.0, 2.0), 0.0, 0.0)
    return by_accelerations(accelerations, parameters, "r th", T, start)


@held_out("near-singular")
def bead_on_a_cycloid(rng):
    """Huygens' pendulum by its slope, asin(s/4a), from next to the cusp, where asin ends."""
    a, T, near = rng.values(Log(0.05, 5.0), (3.0, 40.0), Log(1e-9, 1e-2))
    rates = lambda s, p, t: (s.v, -p.g * sin(asin(s.s / p.a4)))

    def exact(mp, s, p, t):
        return closed_forms.oscillator(mp, mp.sqrt(p.g / p.a4), s.s, s.v, t)

    parameters, T = {"a4": 4 * a, "g": 9.81}, T * math.sqrt(4 * a / 9.81)
    return by_rates(rates, parameters, "s v", T, (4 * a * (1 - near), 0.0), exact=exact)


@held_out("mechanics")
def dog_and_rabbit(rng):
    """A dog that steers by atan2 towards a rabbit on a circle."""
    parameters = rng.parameters(v=(0.4, 0.9), W=(0.5, 1.5), k=(1.0, 5.0))

    def rates(s, p, t):
        dx, dy = cos(p.W * t) - s.x, sin(p.W * t) - s.y
        heading = atan2(dy, dx)
        return p.v * cos(s.phi), p.v * sin(s.phi), p.k * sin(heading - s.phi)

    T, *start = rng.values((5.0, 30.0), (-3.0, -1.5), (-2.0, 2.0), (-3.0, 3.0))
    return by_rates(rates, parameters, "x y phi", T, start)


@held_out("near-singular")
def angle_by_arccosine(rng):
    """A door by the cosine and sine of its angle; its spring takes acos, near 1 where it turns."""
    k, th, M, T = rng.values((1.0, 10.0), Log(1e-2, 0.3), (0.4, 1.0), (2.0, 25.0))
    rates = lambda s, p, t: (-s.s * s.w, s.c * s.w, p.M - p.k * acos(s.c))
    start = math.cos(th), math.sin(th), 0.0
    return by_rates(rates, {"k": k, "M": k * M}, "c s w", T / k**0.5, start)


@held_out("mechanics", "multi-scale")
def gyro_with_damping(rng):
    """A fast gyro in two gimbals with damping: it nutates fast and drifts slowly."""
    parameters = rng.parameters(
        H=Log(10.0, 300.0), A=(0.5, 1.5), B=(0.5, 1.5), c=Log(1e-3, 3.0), M=(0.1, 3.0)
    )

    def accelerations(s, p, t):
        a = (p.M - p.c * s.da - p.H * cos(s.a) * s.db) / p.A
        return a, (p.H * cos(s.a) * s.da - p.c * s.db) / p.B

    T, *start = rng.values((30.0, 300.0), (-0.5, 0.5), 0.0, (-0.1, 0.1), 0.0)
    return by_accelerations(accelerations, parameters, "a b", T / parameters["H"], start)


@held_out("mechanics", "closed form")
def fall_with_a_terminal_speed(rng):
    """A fall with quadratic drag by the book's formula, whose cosh overflows in a long fall."""

    def solution(m, s, p, t):
        vt = m.sqrt(p.g / p.c)
        before = m.log((vt - s.v) / (vt + s.v)) / 2
        u = before + p.g * t / vt
        fallen = m.log(m.cosh(u)) - m.log(m.cosh(before))
        return s.h - vt * vt / p.g * fallen, -vt * m.tanh(u)

    parameters = rng.parameters(g=9.81, c=Log(1e-4, 1.0))
    scale = math.sqrt(1 / (9.81 * parameters["c"]))
    rates = lambda s, p, t: (s.v, p.c * s.v * s.v - p.g)
    T = scale * rng.choice(rng.values(Log(1e-3, 10.0), Log(10.0, 3000.0)))
    start = rng.uniform(10.0, 1000.0), rng.choice((0.0, -0.5 * 9.81 * scale))
    return by_rates(rates, parameters, "h v", T, start, exact=solution, brings=True)
