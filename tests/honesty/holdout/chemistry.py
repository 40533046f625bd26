"""Chemistry, biology, heat: stiff, growing and decaying things."""

import math

from newton_euler import Model, cos, exp, where
from tests.honesty.cases import Case, Log, by_rates, held_out


@held_out("stiff")
def oregonator(rng):
    """The reaction of Belousov and Zhabotinsky, over a part of its period."""

    def rates(x, p, t):
        a = p.s * (x.b + x.a * (1 - p.q * x.a - x.b))
        return a, (x.c - (1 + x.a) * x.b) / p.s, p.w * (x.a - x.c)

    parameters = {"s": 77.27, "q": 8.375e-6, "w": 0.161}
    T, *start = rng.values((0.2, 4.0), (1.0, 4.0), (1.0, 2.0), (2.0, 3.0))
    return by_rates(rates, parameters, "a b c", T, start)


@held_out("smooth")
def brusselator(rng):
    """The Brusselator below and above the onset of its oscillation."""

    def rates(s, p, t):
        return p.A + s.x * s.x * s.y - (p.B + 1) * s.x, p.B * s.x - s.x * s.x * s.y

    parameters = rng.parameters(A=1.0, B=(1.5, 4.0))
    T, *start = rng.values((5.0, 30.0), (0.5, 2.0), (1.0, 3.0))
    return by_rates(rates, parameters, "x y", T, start)


@held_out("stiff", "tiny")
def flame(rng):
    """A ball of flame, y' = y^2 - y^3, from small until it burns steadily."""
    d = rng.decades(1e-4, 1e-1)
    T = (1 / d) * rng.uniform(0.5, 1.9)
    return by_rates(lambda s, p, t: (p.k * (s.y**2 - s.y**3),), {"k": 1.0}, "y", T, (d,))


@held_out("tiny", "closed form")
def decay_to_nothing(rng):
    """Decay over up to three hundred decades, with a model that brings its solution."""
    k = rng.decades(1e-6, 1e6)
    rates = lambda s, p, t: (-p.k * s.x, 0 * s.total)
    exact = lambda m, s, p, t: (s.x * m.exp(-p.k * t), s.total)
    T, *start = rng.values((20.0, 690.0), Log(1e-9, 1e23), Log(1e-9, 1e23))
    return by_rates(rates, {"k": k}, "x total", T / k, start, exact=exact, brings=True)


@held_out("units", "stiff")
def chain_in_atoms(rng):
    """Three nuclides counted in atoms, half-lives from hours to thousands of years."""
    half = rng.values(Log(1e4, 1e11), Log(1e4, 1e11))
    parameters = {f"k{i}": math.log(2) / h for i, h in enumerate(half)}
    rates = lambda s, p, t: (-p.k0 * s.A, p.k0 * s.A - p.k1 * s.B, p.k1 * s.B)

    def exact(mp, s, p, t):
        a, b = mp.exp(-p.k0 * t), mp.exp(-p.k1 * t)
        B = s.A * p.k0 / (p.k1 - p.k0) * (a - b)
        return s.A * a, B, s.A * (1 - a) - B

    T = min(half) * rng.decades(0.1, 1e3)
    return by_rates(rates, parameters, "A B C", T, (6.022e23, 0.0, 0.0), exact=exact)


@held_out("near-singular", "stiff")
def ignition(rng):
    """A reactor that heats itself by Arrhenius' law, before and after it runs away."""
    parameters = rng.parameters(A=Log(3e6, 1e8), E=8000.0, q=600.0, loss=0.5, T0=300.0)

    def rates(s, p, t):
        r = p.A * s.c * exp(-p.E / s.T)
        return -r, p.q * r - p.loss * (s.T - p.T0)

    T, *start = rng.values((0.1, 1.0), 1.0, (330.0, 420.0))
    return by_rates(rates, parameters, "c T", T, start)


@held_out("units", "stiff")
def enzyme_in_moles(rng):
    """Michaelis and Menten in moles a litre: 1e-9 of the enzyme, 1e-4 of its substrate."""
    parameters = rng.parameters(on=Log(1e5, 1e7), off=(1.0, 100.0), cat=30.0)

    def rates(s, p, t):
        bind = p.on * s.E * s.S - p.off * s.ES
        return -bind + p.cat * s.ES, -bind, bind - p.cat * s.ES, p.cat * s.ES

    T, *start = rng.values(Log(0.03, 3.0), Log(1e-9, 1e-6), Log(1e-6, 1e-3), 0.0, 0.0)
    return by_rates(rates, parameters, "E S ES P", T, start)


@held_out("tiny", "law")
def epidemic(rng):
    """An epidemic from a share of 1e-8 to 1e-4 ill; its contact rate is a law of the season."""
    numbers = rng.parameters(
        b0=(0.3, 0.8), a=(0.0, 0.3), n=0.0172, sig=0.2, gam=(0.1, 0.2), one=1.0
    )

    def flow(s, p, b):
        new = b * s.S * s.I
        return -new, new - p.sig * s.E, p.sig * s.E - p.gam * s.I, p.gam * s.I

    season = lambda s, p, t: p.b0 * (p.one + p.a * cos(p.n * t))
    states = "S", "E", "I", "R"
    by_law, by_hand = (
        lambda s, p, t: flow(s, p, p.beta),
        lambda s, p, t: flow(s, p, season(s, p, t)),
    )
    model = Model("epidemic", {**numbers, "beta": season}, states, by_law)
    written = Model("epidemic", numbers, states, by_hand)
    T, *start = rng.values((50.0, 400.0), 1.0, 0.0, Log(1e-8, 1e-4), 0.0)
    return Case(model, T, tuple(start), written_out=written)


@held_out("kinked", "forced")
def nerve(rng):
    """FitzHugh and Nagumo's nerve at rest, with one rectangular pulse of current."""
    parameters = rng.parameters(I=(0.2, 1.0), t1=(5.0, 15.0), t2=(17.0, 40.0), e=Log(0.02, 0.1))
    parameters |= {"a": 0.7, "b": 0.8, "third": 1 / 3}

    def rates(s, p, t):
        I = where(t > p.t1, where(t < p.t2, p.I, 0.0), 0.0)
        return s.v - p.third * s.v**3 - s.w + I, p.e * (s.v + p.a - p.b * s.w)

    return by_rates(rates, parameters, "v w", rng.uniform(40.0, 100.0), (-1.1994, -0.6243))


@held_out("multi-scale")
def foxes_nearly_extinct(rng):
    """Lotka and Volterra far from their equilibrium: the foxes fall to a billionth."""
    parameters = rng.parameters(a=(0.5, 2.0), b=1.0, c=1.0, d=(0.5, 1.5))
    rates = lambda s, p, t: (p.a * s.x - p.b * s.x * s.y, p.c * s.x * s.y - p.d * s.y)
    T, *start = rng.values((3.0, 30.0), (5.0, 15.0), Log(1e-6, 1.0))
    return by_rates(rates, parameters, "x y", T, start)


@held_out("stiff")
def eight_species(rng):
    """HIRES: growth of a plant in the light, eight species."""

    def rates(s, p, t):
        bind = 280 * s.f * s.h
        return (
            -1.71 * s.a + 0.43 * s.b + 8.32 * s.c + p.in_,
            1.71 * s.a - 8.75 * s.b,
            -10.03 * s.c + 0.43 * s.d + 0.035 * s.e,
            8.32 * s.b + 1.71 * s.c - 1.12 * s.d,
            -1.745 * s.e + 0.43 * s.f + 0.43 * s.g,
            -bind + 0.69 * s.d + 1.71 * s.e - 0.43 * s.f + 0.69 * s.g,
            p.k * bind - 1.81 * s.g,
            -p.k * bind + 1.81 * s.g,
        )

    T, h = rng.values(Log(0.5, 10.0), (0.5, 2.0))
    start = 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0057 * h
    return by_rates(rates, {"k": 1.0, "in_": 0.0007}, "a b c d e f g h", T, start)


@held_out("stiff", "tiny")
def laser(rng):
    """A laser that is switched on: photons grow from 1e-8 to spikes."""
    parameters = rng.parameters(kap=(20.0, 100.0), gam=1.0, P=(2.0, 10.0))
    rates = lambda s, p, t: (p.gam * (p.P - s.N) - s.N * s.n, p.kap * (s.N - 1) * s.n)
    T, n = rng.values((0.5, 3.0), Log(1e-8, 1e-2))
    return by_rates(rates, parameters, "N n", T, (0.0, n))
