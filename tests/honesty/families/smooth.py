"""Smooth models of ordinary size."""

from newton_euler import cos, exp, sin, sqrt, tanh
from tests.honesty import models
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, family


@family("smooth")
def damped_oscillator(rng):
    """A spring with a damper, of any stiffness, for one to twenty swings."""
    w = rng.decades(1e-2, 1e2)
    parameters = {"k": w * w, "c": w * rng.uniform(0.01, 0.3)}
    a = lambda s, p, t: (-p.k * s.x - 2 * p.c * s.dx,)
    T, start = rng.uniform(5.0, 100.0) / w, (rng.either(1.0), rng.uniform(-1.0, 1.0) * w)
    return by_accelerations(a, parameters, "x", T, start, exact=models.exact_damped)


@family("smooth")
def pendulum(rng):
    """A pendulum that swings or turns over."""
    k = rng.decades(0.1, 100.0)
    T, theta, omega = rng.values((3.0, 60.0), (-2.9, 2.9), (-2.9, 2.9))
    start = theta, omega * k**0.5
    return Case(models.pendulum(k), T / k**0.5, start, exact=models.exact_pendulum)


@family("smooth")
def duffing(rng):
    """A spring that stiffens or softens, with a potential well or two."""
    parameters = rng.parameters(a=(-2.0, 2.0), b=(0.2, 2.0), c=(0.0, 0.2))
    a = lambda s, p, t: (-p.a * s.x - p.b * s.x * s.x * s.x - p.c * s.dx,)
    T, *start = rng.values((5.0, 30.0), (-2.0, 2.0), (-2.0, 2.0))
    return by_accelerations(a, parameters, "x", T, start)


@family("smooth")
def predator_and_prey(rng):
    """The equations of Lotka and Volterra; the prey becomes rare and recovers."""
    rates = lambda s, p, t: (s.x * (p.a - p.b * s.y), s.y * (p.c * s.x - p.d))
    parameters = {n: rng.uniform(0.5, 2.0) for n in "abcd"}
    T, *start = rng.values((5.0, 25.0), Log(0.1, 3.0), Log(0.1, 3.0))
    return by_rates(rates, parameters, "x y", T, start)


@family("smooth")
def chain_of_masses(rng):
    """Four masses between walls, their springs not quite linear."""
    n = 4
    parameters = {f"k{i}": rng.decades(0.2, 20.0) for i in range(n + 1)}
    parameters["b"] = rng.uniform(0.0, 0.5)

    def accelerations(s, p, t):
        x = [0.0, s.x0, s.x1, s.x2, s.x3, 0.0]
        k = p.k0, p.k1, p.k2, p.k3, p.k4
        pull = [k[i] * (x[i + 1] - x[i]) * (1 + p.b * (x[i + 1] - x[i]) ** 2) for i in range(n + 1)]
        return tuple(pull[i + 1] - pull[i] for i in range(n))

    T, *start = rng.values((2.0, 30.0), *[(-1.0, 1.0)] * 2 * n)
    return by_accelerations(accelerations, parameters, "x0 x1 x2 x3", T, start)


@family("smooth")
def random_network(rng):
    """Three states that drive each other through saturating couplings, drawn at random."""
    pairs = [(w, i, j) for w in "ab" for i in range(3) for j in range(3)]
    parameters = {f"{w}{i}{j}": rng.gauss(0.0, 1.5) for w, i, j in pairs}
    parameters |= {f"d{i}": rng.uniform(0.1, 1.0) for i in range(3)}

    def rates(s, p, t):
        x = s.x, s.y, s.z
        a, b = ([[getattr(p, f"{w}{i}{j}") for j in range(3)] for i in range(3)] for w in "ab")
        inner = [tanh(sum(a[i][j] * x[j] for j in range(3))) for i in range(3)]
        return tuple(
            sum(b[i][j] * inner[j] for j in range(3)) - getattr(p, f"d{i}") * x[i] for i in range(3)
        )

    T, *start = rng.values((2.0, 20.0), *[(-2.0, 2.0)] * 3)
    return by_rates(rates, parameters, "x y z", T, start)


@family("smooth")
def random_formula(rng):
    """Two coordinates, a random sum of sines, exponentials and roots, a little damping."""
    parameters = {n: rng.uniform(-1.5, 1.5) for n in "abcdef"}
    parameters |= rng.parameters(k=(0.5, 2.0), g=(0.05, 0.3), one=1.0)
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
        forces = ([shapes[n](s.x, s.y, p) for n in own] for own in chosen)
        return tuple(r + sum(own) for r, own in zip(rest, forces, strict=True))

    T, *start = rng.values((5.0, 25.0), *[(-1.5, 1.5)] * 4)
    return by_accelerations(accelerations, parameters, "x y", T, start)


@family("smooth")
def logistic_growth(rng):
    """Logistic growth, from a thousandth of its limit to three times that limit."""
    r, K = rng.values(Log(1e-3, 1e3), Log(1e-2, 1e6))
    rates = lambda s, p, t: (p.r * s.x * (p.K - s.x) / p.K,)
    start = K * rng.decades(1e-3, 3.0)
    T = rng.uniform(1.0, 15.0) / r
    return by_rates(rates, {"r": r, "K": K}, "x", T, (start,), exact=models.exact_growth)
