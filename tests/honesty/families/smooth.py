"""Smooth models of ordinary size."""

from newton_euler import Model, cos, exp, sin, sqrt, tanh
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, decades, either, family


@family("smooth")
def damped_oscillator(rng):
    """A spring with a damper, of any stiffness, for one to twenty swings."""
    w = decades(rng, 1e-2, 1e2)
    model = second_order(
        "damped oscillator",
        {"k": w * w, "c": w * rng.uniform(0.01, 0.3)},
        ("x",),
        lambda s, p, t: (-p.k * s.x - 2 * p.c * s.dx,),
    )

    def exact(mp, s, p, t):
        return closed_forms.damped(mp, mp.sqrt(p.k), p.c, s.x, s.dx, t)

    return Case(
        model,
        rng.uniform(5.0, 100.0) / w,
        (either(rng, 1.0), rng.uniform(-1.0, 1.0) * w),
        exact=exact,
    )


@family("smooth")
def pendulum(rng):
    """To and fro or round and round."""
    k = decades(rng, 0.1, 100.0)
    model = Model(
        "pendulum", {"k": k}, ("theta", "omega"), lambda s, p, t: (s.omega, -p.k * sin(s.theta))
    )

    def exact(mp, s, p, t):
        return closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)

    return Case(
        model,
        rng.uniform(3.0, 60.0) / k**0.5,
        (rng.uniform(-2.9, 2.9), rng.uniform(-2.9, 2.9) * k**0.5),
        exact=exact,
    )


@family("smooth")
def duffing(rng):
    """A spring that stiffens or softens, with a potential well or two."""
    parameters = {
        "a": rng.uniform(-2.0, 2.0),
        "b": rng.uniform(0.2, 2.0),
        "c": rng.uniform(0.0, 0.2),
    }
    model = second_order(
        "Duffing",
        parameters,
        ("x",),
        lambda s, p, t: (-p.a * s.x - p.b * s.x * s.x * s.x - p.c * s.dx,),
    )
    return Case(model, rng.uniform(5.0, 30.0), (rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)))


@family("smooth")
def predator_and_prey(rng):
    """Lotka and Volterra's equations; the prey becomes rare and recovers."""
    parameters = {n: rng.uniform(0.5, 2.0) for n in "abcd"}
    model = Model(
        "predator and prey",
        parameters,
        ("x", "y"),
        lambda s, p, t: (s.x * (p.a - p.b * s.y), s.y * (p.c * s.x - p.d)),
    )
    return Case(model, rng.uniform(5.0, 25.0), (decades(rng, 0.1, 3.0), decades(rng, 0.1, 3.0)))


@family("smooth")
def chain_of_masses(rng):
    """Four masses between walls, their springs not quite linear."""
    n = 4
    parameters = {f"k{i}": decades(rng, 0.2, 20.0) for i in range(n + 1)} | {
        "b": rng.uniform(0.0, 0.5)
    }

    def accelerations(s, p, t):
        x = [0.0, s.x0, s.x1, s.x2, s.x3, 0.0]
        k = p.k0, p.k1, p.k2, p.k3, p.k4
        pull = [k[i] * (x[i + 1] - x[i]) * (1 + p.b * (x[i + 1] - x[i]) ** 2) for i in range(n + 1)]
        return tuple(pull[i + 1] - pull[i] for i in range(n))

    model = second_order(
        "chain of masses", parameters, tuple(f"x{i}" for i in range(n)), accelerations
    )
    return Case(model, rng.uniform(2.0, 30.0), tuple(rng.uniform(-1.0, 1.0) for _ in range(2 * n)))


@family("smooth")
def random_network(rng):
    """Three states that drive each other through saturating couplings, drawn at random."""
    parameters = {
        f"{w}{i}{j}": rng.gauss(0.0, 1.5) for w in "ab" for i in range(3) for j in range(3)
    } | {f"d{i}": rng.uniform(0.1, 1.0) for i in range(3)}

    def rates(s, p, t):
        x = s.x, s.y, s.z
        a, b = ([[getattr(p, f"{w}{i}{j}") for j in range(3)] for i in range(3)] for w in "ab")
        inner = [tanh(sum(a[i][j] * x[j] for j in range(3))) for i in range(3)]
        return tuple(
            sum(b[i][j] * inner[j] for j in range(3)) - getattr(p, f"d{i}") * x[i] for i in range(3)
        )

    return Case(
        Model("random network", parameters, ("x", "y", "z"), rates),
        rng.uniform(2.0, 20.0),
        tuple(rng.uniform(-2.0, 2.0) for _ in range(3)),
    )


@family("smooth")
def random_formula(rng):
    """Two coordinates under a force that is a random sum of sines, exponentials and roots, and a
    little damping.
    """
    parameters = {n: rng.uniform(-1.5, 1.5) for n in "abcdef"} | {
        "k": rng.uniform(0.5, 2.0),
        "g": rng.uniform(0.05, 0.3),
        "one": 1.0,
    }
    shapes = (
        lambda x, y, p: p.a * sin(p.b * x + y),
        lambda x, y, p: p.c * x * exp(-p.k * (x * x + y * y)),
        lambda x, y, p: p.d * y / sqrt(p.one + x * x + y * y),
        lambda x, y, p: p.e * cos(x) * sin(p.f * y),
        lambda x, y, p: p.a * tanh(p.e * x * y),
    )
    chosen = [rng.sample(range(len(shapes)), 2) for _ in range(2)]

    def accelerations(s, p, t):
        rest = -p.k * s.x - p.g * s.dx, -p.k * s.y - p.g * s.dy
        return tuple(
            r + sum(shapes[n](s.x, s.y, p) for n in own)
            for r, own in zip(rest, chosen, strict=True)
        )

    model = second_order("random formula", parameters, ("x", "y"), accelerations)
    return Case(model, rng.uniform(5.0, 25.0), tuple(rng.uniform(-1.5, 1.5) for _ in range(4)))


@family("smooth")
def logistic_growth(rng):
    """One state, from well below its limit."""
    model = Model(
        "logistic growth",
        {"r": decades(rng, 1e-3, 1e3), "K": decades(rng, 1e-2, 1e6)},
        ("x",),
        lambda s, p, t: (p.r * s.x * (p.K - s.x) / p.K,),
    )
    start = model.parameters["K"] * decades(rng, 1e-3, 3.0)

    def exact(mp, s, p, t):
        e = mp.exp(-p.r * t)
        return (p.K * s.x / (s.x + (p.K - s.x) * e),)

    return Case(model, rng.uniform(1.0, 15.0) / model.parameters["r"], (start,), exact=exact)
