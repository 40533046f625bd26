"""Many bodies: chains, lattices, crystals, clusters."""

import math
from dataclasses import replace
from itertools import pairwise

from newton_euler import exp, sin, where
from tests.honesty import models
from tests.honesty.cases import Log, by_accelerations, by_rates, held_out


def _states(s, letter, n):
    return [getattr(s, f"{letter}{i}") for i in range(n)]


def _named(letters, n):
    return " ".join(f"{a}{i}" for a in letters for i in range(n))


@held_out("smooth")
def fermi_pasta_ulam(rng):
    """Eight masses and springs that are a little nonlinear, the lowest mode excited."""
    n = 8

    def accelerations(s, p, t):
        x = [0, *_states(s, "x", n), 0]
        pull = [b - a for a, b in pairwise(x)]
        force = [d + p.a * d * d + p.b * d * d * d for d in pull]
        return tuple(b - a for a, b in pairwise(force))

    parameters, mode = rng.parameters(a=(0.0, 0.5), b=(0.0, 1.0)), rng.randint(1, 3)
    start = [rng.uniform(0.3, 1.5) * math.sin(math.pi * mode * (i + 1) / (n + 1)) for i in range(n)]
    T = rng.uniform(5.0, 20.0)
    return by_accelerations(accelerations, parameters, _named("x", n), T, (*start, *[0.0] * n))


@held_out("smooth")
def toda_ring(rng):
    """Toda's ring of six masses with exponential springs."""
    n = 6

    def accelerations(s, p, t):
        x = _states(s, "x", n)
        force = [exp(-p.b * (x[(i + 1) % n] - x[i])) for i in range(n)]
        return tuple(force[i - 1] - force[i] for i in range(n))

    start = rng.values(*[(-0.5, 0.5)] * 2 * n)
    parameters, T = {"b": rng.uniform(0.5, 2.0)}, rng.uniform(5.0, 25.0)
    return by_accelerations(accelerations, parameters, _named("x", n), T, start)


@held_out("units", "chaotic")
def argon_cluster(rng):
    """Three argon atoms in a plane by Lennard-Jones, in metres and kilograms."""
    n = 3

    def accelerations(s, p, t):
        x, y = _states(s, "x", n), _states(s, "y", n)
        ax, ay = [0.0 * v for v in x], [0.0 * v for v in y]
        for i in range(n):
            for j in range(i):
                dx, dy = x[i] - x[j], y[i] - y[j]
                r2 = dx * dx + dy * dy
                q = (p.sig * p.sig / r2) ** 3
                f = 24 * p.eps / p.m * (2 * q * q - q) / r2
                ax[i], ay[i] = ax[i] + f * dx, ay[i] + f * dy
                ax[j], ay[j] = ax[j] - f * dx, ay[j] - f * dy
        return (*ax, *ay)

    d = 3.4e-10 * 2 ** (1 / 6)
    places = (0.0, d, d / 2, 0.0, 0.0, d * 0.87)
    start = [x + d * rng.uniform(-0.05, 0.05) for x in places]
    speeds = rng.values(*[(-60.0, 60.0)] * 6)
    parameters = {"eps": 1.65e-21, "sig": 3.4e-10, "m": 6.63e-26}
    T = rng.uniform(1e-12, 5e-12)
    return by_accelerations(accelerations, parameters, _named("xy", n), T, (*start, *speeds))


@held_out("stiff", "multi-scale")
def almost_rigid_link(rng):
    """A chain of six masses of which two are tied by a spring a hundred thousand times stiffer."""
    n = 6
    stiff = rng.randrange(1, n)
    parameters = {f"k{i}": 1.0 for i in range(n)}
    parameters[f"k{stiff}"] = rng.decades(1e4, 3e5)

    def accelerations(s, p, t):
        x = [0, *_states(s, "x", n)]
        force = [getattr(p, f"k{i}") * (x[i + 1] - x[i]) for i in range(n)] + [0]
        return tuple(force[i + 1] - force[i] for i in range(n))

    start = [rng.uniform(0.5, 1.0)] * n
    T = rng.uniform(0.3, 2.0)
    return by_accelerations(accelerations, parameters, _named("x", n), T, (*start, *[0.0] * n))


@held_out("stiff")
def heated_rod(rng):
    """Ten slices of a rod whose end is heated and cooled in turn."""
    n = 10

    def rates(s, p, t):
        T = [p.A * sin(p.w * t), *_states(s, "T", n)]
        T.append(T[-1])
        return tuple(p.d * (T[i - 1] - 2 * T[i] + T[i + 1]) for i in range(1, n + 1))

    parameters = rng.parameters(d=Log(1.0, 300.0), A=(1.0, 50.0), w=2.0)
    T, start = rng.uniform(0.5, 5.0), tuple(rng.choice((0.0, 20.0)) for _ in range(n))
    return by_rates(rates, parameters, _named("T", n), T, start)


@held_out("smooth")
def kuramoto(rng):
    """Five clocks on a wall, each of its own rate, that pull each other along."""
    n = 5
    parameters = {f"w{i}": rng.uniform(-1.0, 1.0) for i in range(n)}
    parameters["K"] = rng.uniform(0.1, 0.5)

    def rates(s, p, t):
        th = _states(s, "th", n)
        pull = [sum(sin(b - a) for b in th if b is not a) for a in th]
        return tuple(getattr(p, f"w{i}") + p.K * pull[i] for i in range(n))

    T, *start = rng.values((5.0, 20.0), *[(-3.0, 3.0)] * n)
    return by_rates(rates, parameters, _named(["th"], n), T, start)


@held_out("kinked")
def cradle(rng):
    """Three balls in a row that push only when they touch."""

    def accelerations(s, p, t):
        a, b = s.x0 - s.x1, s.x1 - s.x2
        f, h = where(a > 0, p.k * a, 0.0), where(b > 0, p.k * b, 0.0)
        return -p.g * s.x0 - f, -p.g * s.x1 + f - h, -p.g * s.x2 + h

    parameters = rng.parameters(k=Log(50.0, 5e3), g=(1.0, 10.0))
    u, v, T, x, z = rng.values((-0.3, 0.3), (0.0, 0.3), (1.5, 5.0), (0.3, 1.0), (0.001, 0.1))
    return by_accelerations(accelerations, parameters, _named("x", 3), T, (-x, 0.0, z, 0.0, u, v))


@held_out("chaotic", "near-singular")
def small_cluster(rng):
    """Four stars in a plane whose attraction is softened a little."""
    n = 4
    parameters = {"soft": rng.decades(1e-2, 0.2)}
    parameters |= {f"m{i}": rng.uniform(0.5, 1.5) for i in range(n)}

    def accelerations(s, p, t):
        x, y = _states(s, "x", n), _states(s, "y", n)
        m = [getattr(p, f"m{i}") for i in range(n)]
        ax, ay = [], []
        for i in range(n):
            fx, fy = 0, 0
            for j in range(n):
                if i != j:
                    dx, dy = x[j] - x[i], y[j] - y[i]
                    w = m[j] / (dx * dx + dy * dy + p.soft * p.soft) ** 1.5
                    fx, fy = fx + w * dx, fy + w * dy
            ax.append(fx)
            ay.append(fy)
        return (*ax, *ay)

    angles = [2 * math.pi * (i + rng.uniform(-0.2, 0.2)) / n for i in range(n)]
    places = [math.cos(a) for a in angles] + [math.sin(a) for a in angles]
    speeds = [-0.5 * math.sin(a) for a in angles] + [0.5 * math.cos(a) for a in angles]
    T = rng.uniform(0.5, 2.0)
    return by_accelerations(accelerations, parameters, _named("xy", n), T, (*places, *speeds))


@held_out("smooth")
def lattice_of_nine(rng):
    """A lattice of three by three sites with a cubic restoring force, one displaced at first."""
    n = 3

    def accelerations(s, p, cube):
        u = _states(s, "u", n * n)
        at = lambda i, j: u[(i % n) * n + j % n]
        around = lambda i, j: at(i + 1, j) + at(i - 1, j) + at(i, j + 1) + at(i, j - 1)
        force = lambda i, j: around(i, j) - (4 + p.m) * at(i, j) - p.b * cube(at(i, j))
        return tuple(force(i, j) for i in range(n) for j in range(n))

    def by(cube):
        a = lambda s, p, t: accelerations(s, p, cube)
        return by_accelerations(a, parameters, _named("u", n * n), T, start)

    parameters = rng.parameters(m=(-0.5, 1.0), b=(0.5, 2.0))
    start = [0.0] * (2 * n * n)
    start[rng.randrange(n * n)] = rng.uniform(0.5, 1.5)
    T = rng.uniform(2.0, 8.0)
    # heyoka's series have no power of zero
    return replace(by(lambda x: x**3), written_out=by(lambda x: x * x * x).model)


@held_out("tiny")
def kink_along_pendulums(rng):
    """Twelve pendulums in a row, tied by springs, of which the first is turned over."""
    n = 12

    def accelerations(s, p, t):
        a = _states(s, "a", n)
        a = [a[0], *a, a[-1]]
        twist = lambda i: p.k * (a[i - 1] - 2 * a[i] + a[i + 1])
        return tuple(twist(i) - p.g * sin(a[i]) for i in range(1, n + 1))

    parameters = rng.parameters(k=(0.5, 3.0), g=1.0)
    start = [0.0] * (2 * n)
    start[0], start[n] = rng.uniform(1.0, 3.0), rng.uniform(0.0, 5.0)
    T = rng.uniform(2.0, 12.0)
    return by_accelerations(accelerations, parameters, _named("a", n), T, start)


@held_out("mechanics")
def four_spins(rng):
    """Four magnets by Landau and Lifshitz with a little damping, in a ring."""
    n = 4
    parameters = rng.parameters(J=(0.5, 2.0), lam=(0.0, 0.2), B=0.3)

    def cross(a, b):
        return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]

    def rates(s, p, t):
        m = [tuple(getattr(s, f"{c}{i}") for c in "xyz") for i in range(n)]
        out = []
        for i in range(n):
            field = [p.J * (m[i - 1][c] + m[(i + 1) % n][c]) for c in range(3)]
            field[2] = field[2] + p.B
            turn = cross(m[i], field)
            damp = cross(m[i], turn)
            out += [-a - p.lam * b for a, b in zip(turn, damp, strict=True)]
        return tuple(out)

    start = []
    for _ in range(n):
        z, a = rng.uniform(-1.0, 1.0), rng.uniform(0.0, 6.28)
        start += [math.sqrt(1 - z * z) * math.cos(a), math.sqrt(1 - z * z) * math.sin(a), z]
    states = " ".join(f"{c}{i}" for i in range(n) for c in "xyz")
    return by_rates(rates, parameters, states, rng.uniform(3.0, 20.0), start)


@held_out("long")
def two_modes_for_long(rng):
    """Two masses and three springs for a thousand to a hundred thousand swings."""
    parameters = rng.parameters(k=Log(0.1, 10.0), q=Log(1e-3, 1.0))
    T = 6.28 / parameters["k"] ** 0.5 * rng.decades(10.0, 300.0)
    start = rng.either(1.0), 0.0, 0.0, 0.0
    return by_accelerations(models.joined, parameters, "x y", T, start, exact=models.exact_joined)
