"""Rates that read data by :func:`newton_euler.table`."""

from itertools import pairwise

from newton_euler import table
from tests.honesty.cases import Log, by_accelerations, by_rates, family


def _places(rng, count, end):
    inner = sorted(rng.uniform(0.02, 0.98) for _ in range(count - 2))
    return [0.0, *(end * x for x in inner), end]


def _cubic(mp, f, a, h):
    """The coefficients, the constant first, of the cubic that f is from a to a + h."""
    places = [h * k / 5 for k in range(1, 5)]
    powers = mp.matrix([[u**k for k in range(4)] for u in places])
    return mp.lu_solve(powers, mp.matrix([f(a + u) for u in places]))


@family("tables", "forced")
def pushed_by_a_table(rng):
    """A mass in oil, pushed by a force that is a table of time, of any kind, read late or slowly."""
    T, count = rng.uniform(1.0, 20.0), rng.choice((3, 10, 60))
    f = table(_places(rng, count, T), [rng.gauss(0, 3) for _ in range(count)],
              rng.choice(("linear", "cubic", "natural", "previous")), "hold")  # fmt: skip
    parameters = rng.parameters(c=Log(0.05, 5.0), late=(0.0, 0.3 * T), pace=(0.4, 1.0))
    rates = lambda s, p, t: (f(p.pace * t - p.late) - p.c * s.v,)

    def exact(mp, s, p, t):
        joints = [(x + mp.mpf(p.late)) / p.pace for x in f.places]
        cuts, v = [mp.mpf(0), *(x for x in joints if 0 < x < t), t], s.v
        for a, b in pairwise(cuts):
            b0, b1, b2, b3 = _cubic(mp, lambda x: f(p.pace * x - p.late), a, (b - a) or 1)
            d3 = b3 / p.c  # a particular solution, a cubic in u = t - a
            d2 = (b2 - 3 * d3) / p.c
            d1 = (b1 - 2 * d2) / p.c
            d0, u = (b0 - d1) / p.c, b - a
            v = (v - d0) * mp.exp(-p.c * u) + d0 + u * (d1 + u * (d2 + u * d3))
        return (v,)

    return by_rates(rates, parameters, "v", T, (rng.gauss(0, 3),), exact=exact)


@family("tables", "kinked")
def swing_on_a_table(rng):
    """A mass on a spring whose force is measured: a table of five positions, linear between."""
    xs = [-4.0, -1.0, rng.uniform(-0.9, -0.1), rng.uniform(0.1, 2.0), 4.0]
    forces = [-x * rng.uniform(0.5, 8.0) for x in xs]
    f = table(xs, forces)
    a = lambda s, p, t: (f(s.x) - p.c * s.dx,)
    parameters, start = rng.parameters(c=(0.02, 0.3)), (rng.either(rng.uniform(0.2, 1.5)), 0.0)
    return by_accelerations(a, parameters, "x", rng.uniform(2.0, 30.0), start)
