"""Flight in space, in metres, seconds and kilograms, by the clocks of astronomers."""

import math

from newton_euler import Event, Model, cos, exp, log, sin, sqrt, where
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, held_out

GM_SUN, AU, DAY = 1.32712440018e20, 1.495978707e11, 86400.0
GM_EARTH, R_EARTH = 3.986004418e14, 6.371e6


@held_out("near-singular", "chaotic")
def arenstorf(rng):
    """Arenstorf's orbit between Earth and Moon, or one beside it."""

    def accelerations(s, p, t):
        nu = p.one - p.mu
        d1 = ((s.x + p.mu) ** 2 + s.y**2) ** 1.5
        d2 = ((s.x - nu) ** 2 + s.y**2) ** 1.5
        x = s.x + 2 * s.dy - nu * (s.x + p.mu) / d1 - p.mu * (s.x - nu) / d2
        return x, s.y - 2 * s.dx - nu * s.y / d1 - p.mu * s.y / d2

    speed = -2.00158510637908252240537862224 * (1 + rng.choice((0.0, 1e-9, 1e-4)))
    T = 17.0652165601579625588917206249 * rng.uniform(0.2, 0.98)
    parameters = {"mu": 0.012277471, "one": 1.0}
    return by_accelerations(accelerations, parameters, "x y", T, (0.994, 0.0, 0.0, speed))


def _by_cubes(s, p, t):
    r = sqrt(s.x * s.x + s.y * s.y)
    return -p.GM * s.x / r**3, -p.GM * s.y / r**3


@held_out("units", "late")
def comet_by_julian_dates(rng):
    """An ellipse of eccentricity up to 0.99 about the Sun, timed by Julian dates in seconds."""
    begin, e, a = 2451545.0 * DAY, rng.uniform(0.2, 0.99), rng.decades(0.3, 30.0) * AU

    def exact(mp, s, p, t):
        return closed_forms.kepler(mp, p.GM, (s.x, s.y), (s.dx, s.dy), t - begin)

    year = 2 * math.pi * math.sqrt(a**3 / GM_SUN)
    start = a * (1 + e), 0.0, 0.0, math.sqrt(GM_SUN / a * (1 - e) / (1 + e))
    T = begin + round(year * rng.uniform(0.1, 3.0))
    return by_accelerations(_by_cubes, {"GM": GM_SUN}, "x y", T, start, t0=begin, exact=exact)


@held_out("chaotic")
def tumbling_moon(rng):
    """Hyperion: the attitude of an irregular moon on its ellipse."""
    e, shape = rng.values((0.0, 0.3), (0.05, 0.9))

    def rates(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        r3 = r2 * sqrt(r2)
        k, c = sin(s.th), cos(s.th)
        # sin 2(th - f)/2, of the angle f of the orbit
        turn = (k * s.x - c * s.y) * (c * s.x + k * s.y) / r2
        return s.u, s.v, s.w, -p.GM * s.x / r3, -p.GM * s.y / r3, -3 * p.shape * turn * p.GM / r3

    T, th, w = rng.values((5.0, 30.0), (-1.5, 1.5), (0.5, 2.0))
    start = 1 - e, 0.0, th, 0.0, math.sqrt((1 + e) / (1 - e)), w
    return by_rates(rates, {"GM": 1.0, "shape": shape}, "x y th u v w", T, start)


@held_out("kinked", "multi-scale")
def tether(rng):
    """Two satellites tied by an elastic tether, slack or taut, seen from the lower one (Hill)."""
    parameters = rng.parameters(n=1.13e-3, L=1000.0, k=Log(1e-4, 1e-1))

    def accelerations(s, p, t):
        r = sqrt(s.x * s.x + s.y * s.y)
        pull = where(r > p.L, p.k * (r - p.L) / r, 0.0)
        x = 3 * p.n * p.n * s.x + 2 * p.n * s.dy - pull * s.x
        return x, -2 * p.n * s.dx - pull * s.y

    T, *start = rng.values((500.0, 3000.0), (900.0, 990.0), (-100.0, 100.0), (0.0, 1.0), 0.5)
    return by_accelerations(accelerations, parameters, "x y", T, start)


def _rocket(rng):
    """Constant thrust, and the rate at which it burns its mass."""
    q = rng.decades(0.1, 1000.0)
    rates = lambda s, p, t: (s.v, p.u * p.q / s.m - p.g, -p.q)
    return Model("rocket", {"u": 3000.0, "q": q, "g": 9.81}, ("h", "v", "m"), rates), q


@held_out("near-singular")
def rocket_to_its_last_gram(rng):
    """A rocket with constant thrust until barely any mass is left."""

    def exact(mp, s, p, t):
        m = s.m - p.q * t
        # the integral of u log(m0/m)
        climbed = p.u * (t - m / p.q * mp.log(s.m / m))
        return s.h + climbed - p.g * t * t / 2, p.u * mp.log(s.m / m) - p.g * t, m

    model, q = _rocket(rng)
    m = q * rng.uniform(20.0, 200.0)
    return Case(model, m / q * (1 - rng.decades(1e-7, 1e-1)), (0.0, 0.0, m), exact=exact)


@held_out("singular", "no answer")
def rocket_beyond_its_last_gram(rng):
    """A rocket with constant thrust for longer than its mass lasts."""
    model, q = _rocket(rng)
    end = rng.uniform(20.0, 200.0)
    return Case(model, end * rng.choice((1.01, 1.5, 4.0)), (0.0, 0.0, q * end), singular_at=end)


@held_out("units", "long")
def spiral_by_low_thrust(rng):
    """Electric propulsion along the velocity for some revolutions, in metres, with the mass."""

    def rates(s, p, t):
        r = sqrt(s.x**2 + s.y**2)
        speed = sqrt(s.u**2 + s.v**2)
        k, a = -p.GM / r**3, p.F / s.m / speed
        return s.u, s.v, k * s.x + a * s.u, k * s.y + a * s.v, -p.q

    parameters = rng.parameters(GM=GM_EARTH, F=Log(0.05, 2.0), q=5e-6)
    r, T = rng.values((6.7e6, 2e7), (2.0, 9.0))
    n = math.sqrt(GM_EARTH / r**3)
    start = r, 0.0, 0.0, r * n, 1000.0
    return by_rates(rates, parameters, "x y u v m", 2 * math.pi / n * T, start)


@held_out("stiff", "units")
def reentry(rng):
    """A capsule through an exponential atmosphere, with its heat as an integral of v^3."""
    parameters = rng.parameters(GM=GM_EARTH, R=R_EARTH, H=7200.0, B=Log(1e-3, 1e-1), k=1.7e-4)

    def rates(s, p, t):
        r = p.R + s.h
        rho = 1.225 * exp(-s.h / p.H)
        h = s.v * sin(s.gam)
        v = -p.B * rho * s.v * s.v / 2 - p.GM / r**2 * sin(s.gam)
        return h, v, (s.v / r - p.GM / (r**2 * s.v)) * cos(s.gam), p.k * sqrt(rho) * s.v**3

    T, v, angle = rng.values((60.0, 250.0), (7000.0, 11000.0), (2.0, 20.0))
    return by_rates(rates, parameters, "h v gam heat", T, (120e3, v, -angle * math.pi / 180, 0.0))


@held_out("units", "multi-scale")
def inner_planets(rng):
    """The Sun and three planets about their centre of mass, in metres and seconds."""
    gms = (GM_SUN, 3.24859e14, 3.986004418e14, 4.282837e13)
    radii = (1.0821e11, 1.49598e11, 2.27939e11)
    n = len(gms)

    def accelerations(s, p, t):
        x, y = ([getattr(s, f"{a}{i}") for i in range(n)] for a in "xy")
        gm = [getattr(p, f"gm{i}") for i in range(n)]
        ax, ay = [0.0 * v for v in x], [0.0 * v for v in y]
        for i in range(n):
            for j in range(i + 1, n):
                dx, dy = x[j] - x[i], y[j] - y[i]
                d3 = (dx * dx + dy * dy) ** 1.5
                ax[i], ay[i] = ax[i] + gm[j] * dx / d3, ay[i] + gm[j] * dy / d3
                ax[j], ay[j] = ax[j] - gm[i] * dx / d3, ay[j] - gm[i] * dy / d3
        return (*ax, *ay)

    bodies = [(0.0, 0.0, 0.0, 0.0)]
    for r in radii:
        a, v = rng.uniform(0.0, 2 * math.pi), math.sqrt(GM_SUN / r) * rng.uniform(0.95, 1.05)
        bodies.append((r * math.cos(a), r * math.sin(a), -v * math.sin(a), v * math.cos(a)))
    start = tuple(v for column in zip(*bodies, strict=True) for v in column)
    states = " ".join(f"{a}{i}" for a in "xy" for i in range(n))
    parameters = {f"gm{i}": gm for i, gm in enumerate(gms)}
    return by_accelerations(accelerations, parameters, states, rng.decades(1e6, 5e7), start)


@held_out("chaotic")
def figure_eight(rng):
    """Three equal masses on the figure of eight, or beside it."""

    def accelerations(s, p, t):
        def pull(dx, dy):
            r2 = dx * dx + dy * dy
            return dx / (r2 * sqrt(r2)), dy / (r2 * sqrt(r2))

        ab = pull(s.x2 - s.x1, s.y2 - s.y1)
        bc = pull(s.x3 - s.x2, s.y3 - s.y2)
        ca = pull(s.x1 - s.x3, s.y1 - s.y3)
        pairs = (ab, ca), (bc, ab), (ca, bc)
        return tuple(p.G * (to[i] - by[i]) for i in range(2) for to, by in pairs)

    off = rng.choice((0.0, rng.either(rng.decades(1e-6, 1e-2))))
    x, y, u, v = 0.97000436, -0.24308753, 0.93240737, 0.86473146
    start = (x + off, -x, 0.0, y, -y, 0.0, u / 2, u / 2, -u, v / 2, v / 2, -v)
    T, states = rng.uniform(2.0, 13.0), "x1 x2 x3 y1 y2 y3"
    return by_accelerations(accelerations, {"G": 1.0}, states, T, start)


@held_out("forced", "law")
def sitnikov(rng):
    """A small body on the axis of two suns; their distance is a law of time."""
    numbers = rng.parameters(e=(0.0, 0.3), half=0.5, one=1.0)
    distance = lambda s, p, t: p.half * (p.one - p.e * cos(t))
    pulled = lambda s, r: (s.w, -s.z / (s.z * s.z + r * r) ** 1.5)
    rates = lambda s, p, t: pulled(s, p.r)
    written = lambda s, p, t: pulled(s, distance(s, p, t))
    T, z = rng.values((5.0, 40.0), (0.1, 1.2))
    written_out = Model("Sitnikov", numbers, ("z", "w"), written)
    return by_rates(rates, {**numbers, "r": distance}, "z w", T, (z, 0.0), written_out=written_out)


@held_out("near-singular", "units")
def slingshot(rng):
    """A probe past Jupiter, both about the Sun, in metres."""

    def rates(s, p, t):
        r3 = (s.x**2 + s.y**2) ** 1.5
        R3 = (s.X**2 + s.Y**2) ** 1.5
        dx, dy = s.x - s.X, s.y - s.Y
        d3 = (dx**2 + dy**2) ** 1.5
        x, y = -p.GM * s.x / r3 - p.GJ * dx / d3, -p.GM * s.y / r3 - p.GJ * dy / d3
        return s.u, s.v, s.U, s.V, x, y, -p.GM * s.X / R3, -p.GM * s.Y / R3

    R, miss = 7.7834e11, rng.either(rng.decades(3e8, 5e9))
    V = math.sqrt(GM_SUN / R)
    speed, ahead, T = rng.values((6e3, 1e4), (1e10, 3e10), (0.8, 2.5))
    start = (R - ahead, ahead * V / speed + miss, R, 0.0, speed, 0.0, 0.0, V)
    parameters, T = {"GM": GM_SUN, "GJ": 1.26686534e17}, ahead / speed * T
    return by_rates(rates, parameters, "x y X Y u v U V", T, start)


@held_out("mechanics")
def gyrostat(rng):
    """A satellite with a wheel that spins up: quaternion, rates, momentum of the wheel."""
    moments = {"A": (80.0, 120.0), "B": (130.0, 180.0), "C": (190.0, 240.0)}
    parameters = rng.parameters(**moments, M=Log(1e-3, 1e-1))

    def rates(s, p, t):
        w1, w2, w3 = s.w1, s.w2, s.w3
        return (
            -(s.q1 * w1 + s.q2 * w2 + s.q3 * w3) / 2,
            (s.q0 * w1 + s.q2 * w3 - s.q3 * w2) / 2,
            (s.q0 * w2 + s.q3 * w1 - s.q1 * w3) / 2,
            (s.q0 * w3 + s.q1 * w2 - s.q2 * w1) / 2,
            ((p.B - p.C) * w2 * w3 - s.h * w2) / p.A,
            ((p.C - p.A) * w3 * w1 + s.h * w1) / p.B,
            ((p.A - p.B) * w1 * w2 - p.M) / p.C,
            p.M + 0 * s.h,
        )

    start = (1.0, 0.0, 0.0, 0.0, *rng.values(*[(-0.05, 0.05)] * 3), 0.0)
    states = "q0 q1 q2 q3 w1 w2 w3 h"
    return by_rates(rates, parameters, states, rng.uniform(30.0, 600.0), start)


@held_out("events", "kinked")
def lander(rng):
    """A lander that lights its engine below some height, until it touches down."""
    parameters = rng.parameters(g=3.72, F=(5.0, 7.0), light=(600.0, 900.0), u=2200.0)

    def rates(s, p, t):
        push = where(s.h < p.light, p.F, 0.0)
        return s.v, push / s.m - p.g, -push / p.u

    down = Event(lambda s, p, t: s.h, -1, True, name="touch down")
    start = 1500.0, -rng.uniform(30.0, 60.0), 1.0
    return by_rates(rates, parameters, "h v m", 60.0, start, events=(down,))


@held_out("events", "units")
def apsides_and_nodes(rng):
    """Perigees, apogees and ascending nodes of a satellite in metres."""
    e, i, a, turn, T = rng.values((0.01, 0.7), (0.2, 1.4), (1.2e7, 4e7), (0.3, 1.2), (1.0, 3.0))

    def accelerations(s, p, t):
        r3 = (s.x**2 + s.y**2 + s.z**2) ** 1.5
        return -p.GM * s.x / r3, -p.GM * s.y / r3, -p.GM * s.z / r3

    apsis = Event(lambda s, p, t: s.x * s.dx + s.y * s.dy + s.z * s.dz, name="apsis")
    node = Event(lambda s, p, t: s.z, 1, name="node")
    r, v = a * (1 - e), math.sqrt(GM_EARTH / a * (1 + e) / (1 - e))
    c, k, ci, si = math.cos(turn), math.sin(turn), math.cos(i), math.sin(i)
    start = r * c, r * k * ci, r * k * si, -v * k * 0.99, v * c * ci, v * c * si
    T *= 2 * math.pi * math.sqrt(a**3 / GM_EARTH)
    events = apsis, node
    return by_accelerations(accelerations, {"GM": GM_EARTH}, "x y z", T, start, events=events)


@held_out("events", "late")
def eclipses_by_the_clock_of_the_mission(rng):
    """When a satellite enters and leaves the Earth's shadow, from a clock time of 1e5 to 1e7 s."""
    begin, r = float(round(rng.decades(1e5, 1e7))), rng.uniform(7e6, 2e7)
    v = math.sqrt(GM_EARTH / r)
    t_end = begin + round(2 * math.pi * r / v * rng.uniform(0.8, 2.5))
    start = r, 0.0, 0.0, v * rng.uniform(0.98, 1.1)
    edge = Event(lambda s, p, t: s.y - p.R, name="edge")
    other = Event(lambda s, p, t: s.y + p.R, name="other edge")
    model = second_order("eclipses", {"GM": GM_EARTH, "R": R_EARTH}, ("x", "y"), _by_cubes)
    return Case(model, t_end, start, t0=begin, events=(edge, other))


@held_out("near-singular", "multi-scale")
def mass_by_logarithm(rng):
    """A launch in the logarithm of the mass, by Tsiolkovsky, with the losses as states."""
    parameters = rng.parameters(u=3200.0, g=9.81, q=(0.005, 0.02), k=5e-3)

    def rates(s, p, t):
        a = p.u * p.q * exp(-s.l)
        return s.v, a - p.g - p.k * log(1 + s.v * s.v), -p.q * exp(-s.l), p.k * log(1 + s.v * s.v)

    T = rng.uniform(0.3, 0.98) / parameters["q"]
    return by_rates(rates, parameters, "h v l loss", T, (0.0, 0.0, 0.0, 0.0))
