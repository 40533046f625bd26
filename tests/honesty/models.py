"""Models that several families draw, and their exact solutions as a reference takes them."""

import newton_euler
from newton_euler import Model, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty import closed_forms


def spring(name="spring", closed=False, **parameters):
    """x'' = -k x; ``closed`` : the model supplies its solution."""
    solution = (lambda s, p, t: exact_spring(newton_euler, s, p, t)) if closed else None
    return second_order(name, parameters, ("x",), lambda s, p, t: (-p.k * s.x,), exact=solution)


def exact_spring(m, s, p, t):
    """With the functions of the module m, mpmath or the engine."""
    return closed_forms.oscillator(m, m.sqrt(p.k), s.x, s.dx, t)


def joined(s, p, t):
    """The accelerations of two springs or pendulums, joined by a weaker spring."""
    return -p.k * s.x - p.q * (s.x - s.y), -p.k * s.y - p.q * (s.y - s.x)


def exact_joined(mp, s, p, t):
    w, W = mp.sqrt(p.k), mp.sqrt(p.k + 2 * p.q)
    a, da = closed_forms.oscillator(mp, w, (s.x + s.y) / 2, (s.dx + s.dy) / 2, t)
    b, db = closed_forms.oscillator(mp, W, (s.x - s.y) / 2, (s.dx - s.dy) / 2, t)
    return a + b, a - b, da + db, da - db


def exact_damped(mp, s, p, t):
    """x'' = -k x - 2 c x'."""
    return closed_forms.damped(mp, mp.sqrt(p.k), p.c, s.x, s.dx, t)


def pendulum(k, name="pendulum"):
    """theta'' = -k sin(theta)."""
    rates = lambda s, p, t: (s.omega, -p.k * sin(s.theta))
    return Model(name, {"k": k}, ("theta", "omega"), rates)


def exact_pendulum(mp, s, p, t):
    return closed_forms.pendulum(mp, p.k, s.theta, s.omega, t)


def free_body(A, B, C):
    """Euler's equations without moments."""

    def rates(s, p, t):
        x, y = (p.B - p.C) / p.A * s.y * s.z, (p.C - p.A) / p.B * s.z * s.x
        return x, y, (p.A - p.B) / p.C * s.x * s.y

    return Model("free body", {"A": A, "B": B, "C": C}, ("x", "y", "z"), rates)


def exact_free_body(mp, s, p, t):
    return closed_forms.free_body(mp, (p.A, p.B, p.C), (s.x, s.y, s.z), t)


def by_power(s, p, t):
    """The attraction of a centre, written as a power of the distance in the plane."""
    r3 = (s.x**2 + s.y**2) ** 1.5
    return -p.GM * s.x / r3, -p.GM * s.y / r3


def orbit(name, GM):
    """An orbit about a fixed centre, in its plane."""

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        return -p.GM * s.x / (r2 * sqrt(r2)), -p.GM * s.y / (r2 * sqrt(r2))

    return second_order(name, {"GM": GM}, ("x", "y"), accelerations)


def exact_orbit(mp, s, p, t):
    return closed_forms.kepler(mp, p.GM, (s.x, s.y), (s.dx, s.dy), t)


def exact_growth(mp, s, p, t):
    """x' = r x (K - x)/K."""
    e = mp.exp(-p.r * t)
    return (p.K * s.x / (s.x + (p.K - s.x) * e),)
