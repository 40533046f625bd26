"""Narrow things that are met in several coordinates, in sums, products and compositions, at an
energy, in the clock of a model, and behind a pole; written before the engine looked for them.
"""

import math

from newton_euler import atan, cos, cosh, exp, sin, sqrt, tanh
from tests.honesty.cases import Log, around, by_accelerations, by_rates, family
from tests.honesty.families.narrow import HUMPS


def _knots(met, width):
    """Times around ``met``, when something that lasts about ``width`` is met."""
    return around(met, width / 2, 22)


@family("narrow")
def patch_in_the_plane(rng):
    """A sledge that crosses a small round patch of mud off its centre."""
    u, v, w, T = rng.values((0.5, 3.0), (-2.0, 2.0), Log(1e-4, 1e-1), (4.0, 8.0))
    hump, met = rng.choice(HUMPS)[0], T * rng.uniform(0.3, 0.7)
    parameters = {"w": w, "x0": u * met, "y0": v * met + w * rng.uniform(-0.7, 0.7)}
    parameters["A"] = math.hypot(u, v) / w * rng.uniform(0.1, 0.5)

    def accelerations(s, p, t):
        far = sqrt((s.x - p.x0) * (s.x - p.x0) + (s.y - p.y0) * (s.y - p.y0) + 1e-4 * p.w * p.w)
        drag = p.A * hump(far / p.w)
        return -drag * s.dx, -drag * s.dy

    knots = _knots(met, w / math.hypot(u, v))
    return by_accelerations(accelerations, parameters, "x y", T, (0.0, 0.0, u, v), knots=knots)


@family("narrow")
def layer_of_wind(rng):
    """A shot that passes a thin layer of wind on its way up and down."""
    g, V, u, w = rng.values((5.0, 15.0), (20.0, 60.0), (5.0, 30.0), Log(1e-3, 1.0))
    hump, c = rng.choice(HUMPS)[0], V * V / 2 / g * rng.uniform(0.2, 0.8)
    parameters = {"g": g, "c": c, "w": w, "A": u * V / w * rng.uniform(0.01, 0.1)}
    a = lambda s, p, t: (p.A * hump((s.y - p.c) / p.w), -p.g)
    half = math.sqrt(V * V - 2 * g * c)
    knots = _knots((V - half) / g, w / half) + _knots((V + half) / g, w / half)
    return by_accelerations(a, parameters, "x y", 2 * V / g, (0.0, 0.0, u, V), knots=knots)


@family("narrow")
def beads_that_pass(rng):
    """Two beads on parallel wires, which attract each other where they are close."""
    u, v, w, T = rng.values((0.5, 2.0), (-2.0, -0.5), Log(1e-4, 1e-1), (3.0, 9.0))
    met = T * rng.uniform(0.3, 0.7)
    parameters = {"D": (u - v) ** 2 * rng.uniform(0.1, 1.0), "w": w, "m": rng.uniform(1.0, 3.0)}
    friction = rng.uniform(0.01, 0.1)
    parameters["c"] = friction

    def accelerations(s, p, t):
        z = (s.x - s.y) / p.w
        f = -p.D / p.w * z * exp(-z * z) * (1 + p.m * (s.dx - s.dy))
        return f - p.c * s.dx, -f / p.m - p.c * s.dy

    gone = -math.expm1(-friction * met) / friction
    start = (0.0, (u - v) * gone, u, v)
    knots = _knots(met, w / (u - v) * math.exp(friction * met))
    return by_accelerations(accelerations, parameters, "x y", T, start, knots=knots)


@family("narrow", "mechanics")
def passage_of_a_small_star(rng):
    """The softened attraction of a small mass, to which a body comes close."""
    v, e, T = rng.values((0.5, 2.0), Log(1e-4, 1e-1), (4.0, 8.0))
    met = T * rng.uniform(0.3, 0.7)
    parameters = {"GM": v * v * e * rng.uniform(0.1, 1.0), "e": e, "x0": v * met}
    parameters["y0"] = e * rng.uniform(0.3, 2.0)

    def accelerations(s, p, t):
        x, y = s.x - p.x0, s.y - p.y0
        r2 = x * x + y * y + p.e * p.e
        pull = p.GM / (r2 * sqrt(r2))
        return -pull * x, -pull * y

    start = 0.0, 0.0, v, 0.0
    return by_accelerations(accelerations, parameters, "x y", T, start, knots=_knots(met, e / v))


@family("narrow")
def row_of_posts(rng):
    """Three posts of different widths, on a path of 10 m."""
    v, widest, parameters, knots = rng.uniform(0.5, 3.0), rng.decades(1e-4, 5e-2), {}, ()
    kinds = [rng.choice(HUMPS)[0] for _ in range(3)]
    for k, c in enumerate(rng.values((2.0, 3.5), (4.0, 6.0), (6.5, 8.0))):
        w, pushed = widest * rng.uniform(0.3, 1.0), v * v * rng.uniform(0.01, 0.1)
        parameters |= {f"w{k}": w, f"c{k}": c, f"A{k}": pushed / w}
        knots += around(c / v, w / v / 2, 60)

    def accelerations(s, p, t):
        values = vars(p)
        z = [(s.x - values[f"c{k}"]) / values[f"w{k}"] for k in range(3)]
        return (sum(-values[f"A{k}"] * z[k] * kinds[k](z[k]) for k in range(3)),)

    T = 10.0 / v
    return by_accelerations(accelerations, parameters, "x", T, (0.0, v), knots=tuple(sorted(knots)))


@family("narrow")
def loss_at_an_energy(rng):
    """An oscillation that decays, faster near one value of its energy."""
    k, c, w = rng.values((0.5, 4.0), (0.02, 0.1), Log(1e-5, 1e-2))
    energy, level = 0.5 * k, 0.5 * k * rng.uniform(0.3, 0.8)
    met, hump = math.log(energy / level) / (2 * c), rng.choice(HUMPS)[0]
    parameters = {"k": k, "c": c, "E": level, "w": level * w}
    parameters["A"] = c * rng.uniform(0.5, 10.0)

    def rates(s, p, t):
        kinetic = s.v * s.v / 2
        loss = p.c + p.A * hump((kinetic + p.k * s.x * s.x / 2 - p.E) / p.w)
        return s.v - loss * s.x, -p.k * s.x - loss * s.v

    return by_rates(rates, parameters, "x v", 2 * met, (1.0, 0.0), knots=_knots(met, w / (2 * c)))


@family("narrow", "forced")
def jump_of_a_phase(rng):
    """A sine whose phase is disturbed for a moment."""
    T, hump = rng.uniform(5.0, 30.0), rng.choice(HUMPS)[0]
    parameters = rng.parameters(k=(0.5, 4.0), F=(0.2, 2.0), q=(0.5, 3.0), B=(0.5, 3.0))
    parameters |= {"w": T * rng.decades(1e-5, 1e-2), "tp": T * rng.uniform(0.2, 0.8)}
    a = lambda s, p, t: (p.F * sin(p.q * t + p.B * hump((t - p.tp) / p.w)) - p.k * s.x,)
    knots = _knots(parameters["tp"], parameters["w"])
    return by_accelerations(a, parameters, "x", T, (0.3, 0.0), knots=knots)


@family("narrow", "forced")
def strokes_of_a_clock(rng):
    """Short strokes, once in each period."""
    n, w, c = rng.values((0.5, 2.0), Log(1e-3, 1e-1), (1.0, 5.0))
    parameters = {"k": rng.uniform(0.5, 4.0), "n": n, "w": w, "c": c, "F": 0.3 / w}
    a = lambda s, p, t: (p.F * exp((cos(p.n * t - p.c) - 1) / (p.w * p.w)) - p.k * sin(s.x),)
    knots = [t for j in range(3) for t in around((c + 2 * math.pi * j) / n, w / n / 2, 22)]
    T = (c + 5 * math.pi) / n
    return by_accelerations(a, parameters, "x", T, (0.3, 0.0), knots=tuple(knots))


@family("narrow", "kinked")
def tent(rng):
    """A brake that grows and falls linearly, by abs."""
    v, w, c = rng.values((0.5, 3.0), Log(1e-4, 2e-1), (3.0, 7.0))
    parameters = {"A": v * rng.uniform(0.1, 0.7) / w, "c": c, "w": w}

    def rates(s, p, t):
        z = (s.x - p.c) / p.w
        return s.v, -p.A * (abs(z + 1) + abs(z - 1) - 2 * abs(z)) / 2 * s.v

    return by_rates(rates, parameters, "x v", 10.0 / v, (0.0, v), knots=_knots(c / v, w / v / 2))


@family("narrow", "forced")
def clock_that_drifts(rng):
    """A blow at a set time of a clock that runs unevenly."""
    T, hump = rng.uniform(5.0, 30.0), rng.choice(HUMPS)[0]
    parameters = rng.parameters(k=(0.5, 4.0), F=(0.2, 2.0), q=(0.2, 1.0), d=(0.1, 0.5))
    met, d, q = T * rng.uniform(0.2, 0.8), parameters["d"], parameters["q"]
    parameters |= {"w": T * rng.decades(1e-5, 1e-2), "tp": met + d / q * math.sin(q * met)}

    def rates(s, p, t):
        z = (s.c - p.tp) / p.w
        return s.v, -p.k * s.x + p.F / p.w * hump(z) * (1 + s.x), 1 + p.d * cos(p.q * t)

    start = 0.3, 0.0, 0.0
    return by_rates(rates, parameters, "x v c", T, start, knots=_knots(met, parameters["w"]))


@family("narrow")
def step_of_a_track(rng):
    """A track that steps up or down at one point, as tanh."""
    v, w, c, g = rng.values((2.0, 5.0), Log(1e-4, 1e-1), (3.0, 7.0), 10.0)
    parameters = {"H": v * v / 2 / g * rng.uniform(-0.8, 0.8), "c": c, "w": w, "g": g}

    def accelerations(s, p, t):
        h = tanh((s.x - p.c) / p.w)
        return (-p.g * p.H / (2 * p.w) * (1 - h * h),)

    T = 10.0 / v
    return by_accelerations(accelerations, parameters, "x", T, (0.0, v), knots=_knots(c / v, w / v))


@family("narrow", "forced")
def stiffening(rng):
    """A spring that is stiffer for a moment, beside a slow change of its stiffness."""
    T = rng.uniform(5.0, 30.0)
    parameters = rng.parameters(k=(0.5, 4.0), B=(0.3, 2.0), q=(0.5, 3.0), d=(0.05, 0.3))
    parameters |= {"w": T * rng.decades(1e-5, 1e-2), "tp": T * rng.uniform(0.2, 0.8)}

    def accelerations(s, p, t):
        rise = cosh((t - p.tp) / p.w * exp(-(((t - p.tp) / (8 * p.w)) ** 2)))
        more = (rise - 1) / (rise * rise)
        return (-(p.k * (1 + p.d * sin(p.q * t)) + p.B / p.w * more) * s.x,)

    knots = around(parameters["tp"], parameters["w"] / 2, 60)
    return by_accelerations(accelerations, parameters, "x", T, (0.3, 0.1), knots=knots)


@family("narrow")
def gate_of_two_steps(rng):
    """A fall through a field between two points, by the difference of two arctangents."""
    g, w, c = rng.values((5.0, 15.0), Log(1e-4, 1e-1), (3.0, 7.0))
    parameters = {"g": g, "c": c, "w": w, "A": g * c / w * rng.uniform(0.02, 0.2)}

    def accelerations(s, p, t):
        z = (s.x - p.c) / p.w
        field = (atan(z + 2) - atan(z - 2)) ** 4
        return (p.g - p.A * field / (1 + s.dx * s.dx / (2 * p.g * p.c)),)

    speed, T = math.sqrt(2 * g * c), math.sqrt(2 * 10.0 / g)
    knots = around(speed / g, w / speed, 40)
    return by_accelerations(accelerations, parameters, "x", T, (0.0, 0.0), knots=knots)


@family("narrow")
def bounce_off_a_pole(rng):
    """An inverse-square repulsion, felt only close to a wall."""
    v, near, c = rng.values((0.5, 3.0), Log(1e-5, 1e-2), (3.0, 7.0))
    parameters = {"B": near * v * v / 2, "c": c, "k": rng.uniform(0.0, 0.02)}
    a = lambda s, p, t: (-p.B / (p.c - s.x) ** 2 - p.k * s.dx,)
    return by_accelerations(a, parameters, "x", 1.7 * c / v, (0.0, v))


@family("narrow", "multi-scale")
def survey_boat_over_a_wreck(rng):
    """A boat far north of its map's origin; its sensor's signal is zero except at one spot."""
    u, v, w, k = rng.values((1.0, 3.0), (0.5, 2.0), Log(0.5, 20.0), 0.05)
    met, north = rng.uniform(300.0, 2000.0), 5.2e6
    parameters = {"u": u, "v": v, "w": w, "x0": u * met, "y0": north + v * met, "k": k}
    parameters["B"] = rng.uniform(1.0, 10.0)

    def rates(s, p, t):
        x, y = s.x - p.x0, s.y - p.y0
        return p.u, p.v, p.B * exp(-(x * x + y * y) / (p.w * p.w)) - p.k * s.q

    T, knots = met + rng.uniform(5.0, 40.0), _knots(met, w / math.hypot(u, v))
    return by_rates(rates, parameters, "x y q", T, (0.0, north, 0.0), knots=knots)


@family("narrow")
def top_of_a_throw_in_a_layer(rng):
    """A stone whose highest point lies in, just below or just above a thin layer of light."""
    g, v, w = rng.values((5.0, 15.0), (5.0, 30.0), Log(1e-8, 1e-3))
    top = v * v / 2 / g
    parameters = {"g": g, "w": w * top, "c": top * (1 + w * rng.uniform(-1.5, 1.0)), "I": 10.0}

    def rates(s, p, t):
        z = (s.y - p.c) / p.w
        return s.v, -p.g, p.I * exp(-z * z)

    knots = _knots(v / g, v / g * math.sqrt(w))
    return by_rates(rates, parameters, "y v dose", 1.9 * v / g, (0.0, v, 0.0), knots=knots)
