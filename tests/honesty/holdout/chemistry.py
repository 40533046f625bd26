"""Chemistry, biology, heat: stiff, growing and decaying things."""

import math

from newton_euler import Model, cos, exp, where
from tests.honesty.cases import Branches, Case, decades, held_out


@held_out("stiff")
def oregonator(rng):
    """The reaction of Belousov and Zhabotinsky, a part of its period."""
    parameters = {"s": 77.27, "q": 8.375e-6, "w": 0.161}

    def rates(x, p, t):
        return (
            p.s * (x.b + x.a * (1 - p.q * x.a - x.b)),
            (x.c - (1 + x.a) * x.b) / p.s,
            p.w * (x.a - x.c),
        )

    return Case(
        Model("Oregonator", parameters, ("a", "b", "c"), rates),
        rng.uniform(0.2, 4.0),
        (rng.uniform(1.0, 4.0), rng.uniform(1.0, 2.0), rng.uniform(2.0, 3.0)),
    )


@held_out("smooth")
def brusselator(rng):
    """Below and above the onset of its oscillation."""
    parameters = {"A": 1.0, "B": rng.uniform(1.5, 4.0)}
    model = Model(
        "Brusselator",
        parameters,
        ("x", "y"),
        lambda s, p, t: (
            p.A + s.x * s.x * s.y - (p.B + 1) * s.x,
            p.B * s.x - s.x * s.x * s.y,
        ),
    )
    return Case(model, rng.uniform(5.0, 30.0), (rng.uniform(0.5, 2.0), rng.uniform(1.0, 3.0)))


@held_out("stiff", "tiny")
def flame(rng):
    """A ball of flame, y' = y^2 - y^3, from small until it burns steadily."""
    d = decades(rng, 1e-4, 1e-1)
    return Case(
        Model("flame", {"k": 1.0}, ("y",), lambda s, p, t: (p.k * (s.y**2 - s.y**3),)),
        (1 / d) * rng.uniform(0.5, 1.9),
        (d,),
    )


@held_out("tiny", "closed form")
def decay_to_nothing(rng):
    """Decay over up to three hundred decades, with a model that knows it."""

    def exact(mp, s, p, t):
        return s.x * mp.exp(-p.k * t), s.total

    parameters = {"k": decades(rng, 1e-6, 1e6)}
    model = Model(
        "decay",
        parameters,
        ("x", "total"),
        lambda s, p, t: (-p.k * s.x, 0 * s.total),
        exact=lambda s, p, t: (s.x * exp(-p.k * t), s.total),
    )
    return Case(
        model,
        rng.uniform(20.0, 690.0) / parameters["k"],
        (decades(rng, 1e-9, 1e23), decades(rng, 1e-9, 1e23)),
        exact=exact,
    )


@held_out("units", "stiff")
def chain_in_atoms(rng):
    """Three nuclides counted in atoms, half-lives from hours to thousands of years."""
    half = [decades(rng, 1e4, 1e11) for _ in range(2)]
    parameters = {f"k{i}": math.log(2) / h for i, h in enumerate(half)}
    model = Model(
        "nuclides",
        parameters,
        ("A", "B", "C"),
        lambda s, p, t: (-p.k0 * s.A, p.k0 * s.A - p.k1 * s.B, p.k1 * s.B),
    )

    def exact(mp, s, p, t):
        a, b = mp.exp(-p.k0 * t), mp.exp(-p.k1 * t)
        B = s.A * p.k0 / (p.k1 - p.k0) * (a - b)
        return s.A * a, B, s.A * (1 - a) - B

    return Case(model, min(half) * decades(rng, 0.1, 1e3), (6.022e23, 0.0, 0.0), exact=exact)


@held_out("near-singular", "stiff")
def ignition(rng):
    """A reactor that heats itself by Arrhenius' law, before and after it runs away."""
    parameters = {"A": decades(rng, 3e6, 1e8), "E": 8000.0, "q": 600.0, "loss": 0.5, "T0": 300.0}

    def rates(s, p, t):
        r = p.A * s.c * exp(-p.E / s.T)
        return -r, p.q * r - p.loss * (s.T - p.T0)

    return Case(
        Model("reactor", parameters, ("c", "T"), rates),
        rng.uniform(0.1, 1.0),
        (1.0, rng.uniform(330.0, 420.0)),
    )


@held_out("units", "stiff")
def enzyme_in_moles(rng):
    """Michaelis and Menten in moles a litre: 1e-9 of the enzyme, 1e-4 of what it works on."""
    parameters = {"on": decades(rng, 1e5, 1e7), "off": rng.uniform(1.0, 100.0), "cat": 30.0}

    def rates(s, p, t):
        bind = p.on * s.E * s.S - p.off * s.ES
        return -bind + p.cat * s.ES, -bind, bind - p.cat * s.ES, p.cat * s.ES

    return Case(
        Model("enzyme", parameters, ("E", "S", "ES", "P"), rates),
        decades(rng, 0.03, 3.0),
        (decades(rng, 1e-9, 1e-6), decades(rng, 1e-6, 1e-3), 0.0, 0.0),
    )


@held_out("tiny", "law")
def epidemic(rng):
    """From one in a hundred million to the peak; the contacts are a law of the season."""
    numbers = {"b0": rng.uniform(0.3, 0.8), "a": rng.uniform(0.0, 0.3), "n": 0.0172}
    numbers |= {"sig": 0.2, "gam": rng.uniform(0.1, 0.2), "one": 1.0}

    def flow(s, p, b):
        new = b * s.S * s.I
        return -new, new - p.sig * s.E, p.sig * s.E - p.gam * s.I, p.gam * s.I

    def season(s, p, t):
        return p.b0 * (p.one + p.a * cos(p.n * t))

    states = "S", "E", "I", "R"
    return Case(
        Model("epidemic", {**numbers, "beta": season}, states, lambda s, p, t: flow(s, p, p.beta)),
        rng.uniform(50.0, 400.0),
        (1.0, 0.0, decades(rng, 1e-8, 1e-4), 0.0),
        written_out=Model("epidemic", numbers, states, lambda s, p, t: flow(s, p, season(s, p, t))),
    )


@held_out("kinked", "forced")
def nerve(rng):
    """FitzHugh and Nagumo's nerve at rest, with one rectangular pulse of current."""
    parameters = {
        "I": rng.uniform(0.2, 1.0),
        "t1": rng.uniform(5.0, 15.0),
        "t2": rng.uniform(17.0, 40.0),
        "e": decades(rng, 0.02, 0.1),
        "a": 0.7,
        "b": 0.8,
        "third": 1 / 3,
    }

    def currents(s, p, I):
        return s.v - p.third * s.v**3 - s.w + I, p.e * (s.v + p.a - p.b * s.w)

    branches = Branches(
        (lambda s, p, t: t - p.t1, lambda s, p, t: t - p.t2),
        lambda s, p, t, b: currents(s, p, p.I * (b[0] - b[1]) / 2),
    )
    return Case(
        Model(
            "nerve",
            parameters,
            ("v", "w"),
            lambda s, p, t: currents(s, p, where(t > p.t1, where(t < p.t2, p.I, 0.0), 0.0)),
        ),
        rng.uniform(40.0, 100.0),
        (-1.1994, -0.6243),
        branches=branches,
    )


@held_out("multi-scale")
def foxes_nearly_extinct(rng):
    """Lotka and Volterra far from their equilibrium: foxes come down to a billionth."""
    parameters = {"a": rng.uniform(0.5, 2.0), "b": 1.0, "c": 1.0, "d": rng.uniform(0.5, 1.5)}
    model = Model(
        "foxes",
        parameters,
        ("x", "y"),
        lambda s, p, t: (p.a * s.x - p.b * s.x * s.y, p.c * s.x * s.y - p.d * s.y),
    )
    return Case(model, rng.uniform(3.0, 30.0), (rng.uniform(5.0, 15.0), decades(rng, 1e-6, 1.0)))


@held_out("stiff")
def eight_species(rng):
    """HIRES: growth of a plant in the light, eight species."""
    parameters = {"k": 1.0, "in_": 0.0007}

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

    return Case(
        Model("HIRES", parameters, tuple("abcdefgh"), rates),
        decades(rng, 0.5, 10.0),
        (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0057 * rng.uniform(0.5, 2.0)),
    )


@held_out("stiff", "tiny")
def laser(rng):
    """A laser that is switched on: photons grow from 1e-8 to spikes."""
    parameters = {"kap": rng.uniform(20.0, 100.0), "gam": 1.0, "P": rng.uniform(2.0, 10.0)}
    model = Model(
        "laser",
        parameters,
        ("N", "n"),
        lambda s, p, t: (p.gam * (p.P - s.N) - s.N * s.n, p.kap * (s.N - 1) * s.n),
    )
    return Case(model, rng.uniform(0.5, 3.0), (0.0, decades(rng, 1e-8, 1e-2)))
