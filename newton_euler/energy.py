"""Kinetic energy and the energy equation (11.12)-(11.14), (11.26)-(11.33), (11.36)-(11.53): the books of a motion must balance.

Velocities are those in an inertial frame. A sum keeps its terms by name: kinetic energy those of translation and rotation, and of each body;
the audit of a motion every potential and every work.
"""

from dataclasses import dataclass, field

from .mass import Body
from .scalars import ZERO, cos, is_numeric, plain, scalar, sin, size, sqrt
from .vectors import _short
from .work import Work, integral


class EnergyError(ValueError):
    """Energies or works that cannot be added up, or an audit that is asked what it cannot tell."""


@dataclass(frozen=True)
class Energy:
    """An amount of energy with its terms by name: ``T.value``, ``T.terms["rotation"]``, ``T.explain()``."""

    value: object
    terms: dict = field(default_factory=dict)
    number: str = ""

    def __float__(self):
        return float(self.value)

    def explain(self, unit="J"):
        """The sum in words: each term, and their sum, with the number of its equation in the book."""
        width = max(map(len, [*self.terms, "sum"]))
        rows = [f"  {name:<{width}}  {_short(x)} {unit}" for name, x in [*self.terms.items(), ("sum", self.value)]]
        return "\n".join([f"energy, equation ({self.number})", *rows])


def _energy(terms, number):
    total = ZERO
    for x in terms.values():
        total = total + x
    return Energy(plain(total), {n: plain(x) for n, x in terms.items()}, number)


def kinetic_energy(bodies, observer):
    """T = m v.v/2 + omega.H/2 of a body (11.45), or of bodies together (11.42), seen from the inertial frame ``observer``; an :class:`Energy`.

    bodies : a :class:`~newton_euler.mass.Body` (a particle too, (11.13)): terms ``translation`` and ``rotation``; or a list of them: a term for each

    >>> from newton_euler import Frame
    >>> from newton_euler.solids import sphere
    >>> ground = Frame("ground")
    >>> ball = ground.rotate("ball", "y", rate=10.0)
    >>> T = kinetic_energy(sphere(0.5, ball, mass=2.0), ground)
    >>> round(T.terms["rotation"], 9)
    10.0
    """
    if not isinstance(bodies, Body):
        parts = list(bodies)
        names = [b.name for b in parts]
        if len(set(names)) < len(names):
            raise EnergyError(f"two bodies have the name {next(n for n in names if names.count(n) > 1)!r}; the terms need names of their own")
        return _energy({b.name: scalar(kinetic_energy(b, observer).value) for b in parts}, "11.42")
    v = bodies.centre.velocity(observer)
    omega = bodies.frame.angular_velocity(observer)
    H = bodies.angular_momentum(observer)
    return _energy({"translation": scalar(v.dot(v)) * bodies.mass / 2, "rotation": scalar(omega.dot(H)) / 2}, "11.45")


def kinetic_energy_about(body, fixed, observer):
    """T = omega.H_B/2 of a body that turns about a fixed point B (11.52), (11.53); an :class:`Energy` with the one term ``rotation``.

    fixed : a Point of the body that is at rest in ``observer``; :class:`EnergyError` if it is seen to move
    """
    v = scalar(fixed.velocity(observer).norm())
    if is_numeric(v) and size(v) > 1e-9 * max(size(scalar(body.centre.velocity(observer).norm())), 1e-300):
        raise EnergyError(f"{fixed.name} moves at {size(v):.3g}: (11.52) needs a fixed point of the body; use kinetic_energy, or name another point")
    omega = body.frame.angular_velocity(observer)
    return _energy({"rotation": scalar(omega.dot(body.about(fixed).times(omega))) / 2}, "11.52")


def plane_kinetic_energy(m, speed, moment_of_inertia, rate):
    """T = m v^2/2 + I_zz omega^2/2 of plane motion (11.51), about G; an :class:`Energy`.

    >>> plane_kinetic_energy(2.0, 3.0, 0.5, 4.0).terms
    {'translation': 9.0, 'rotation': 4.0}
    """
    return _energy({"translation": scalar(m) * speed * speed / 2, "rotation": scalar(moment_of_inertia) * rate * rate / 2}, "11.51")


def gyroscope_energy(I0, I, theta, nutation_rate, precession, spin):
    """T of a symmetric body about its fixed point (11.16): [I0 (theta'^2 + psi'^2 sin^2 theta) + I (phi' + psi' cos theta)^2]/2; an :class:`Energy`.

    I0, I : transverse and axial moments of inertia; theta from the upward vertical

    >>> round(gyroscope_energy(1.5, 1.0, 0.0, 0.0, 2.0, 3.0).value, 9)  # upright, all about one line
    12.5
    """
    across, axial = precession * sin(theta), spin + precession * cos(theta)
    transverse = scalar(I0) * (nutation_rate * nutation_rate + across * across) / 2
    return _energy({"transverse": transverse, "axial": scalar(I) * axial * axial / 2}, "11.53")


def speed_after(speed, work, m):
    """The speed of a particle after the work ``U`` was done on it: v_1 = sqrt(v_0^2 + 2 U/m) (11.12), (11.14).

    Raises :class:`EnergyError` if it does not get there: it would stop on the way.

    >>> round(speed_after(2.0, 2.0*9.81*0.15, 2.0), 3)  # the ball on a cord, 0.15 m lower
    2.635
    """
    U = work.value if isinstance(work, Work) else work
    square = scalar(speed) * speed + 2 * scalar(U) / m
    if is_numeric(square) and min(_each(square)) < 0:
        raise EnergyError(f"it does not get there: the work {plain(U)!r} takes more than the kinetic energy {plain(scalar(m) * speed * speed / 2)!r}")
    return plain(sqrt(square))


def _each(x):
    x = plain(x)
    return x.ravel().tolist() if hasattr(x, "ravel") else [x]


# -- the energy equation


@dataclass(frozen=True)
class Audit:
    """The energy equation of a motion from one instant to another (11.29), (11.48): ``kinetic`` + ``potentials`` = ``works``, changes in J by name.

    ``missing`` is what the books do not account for: the change of T + V less the non-conservative work. ``error`` estimates how far the
    integrals can be off; a motion is accounted for if abs(missing) is within it and the rounding of the energies themselves.
    """

    kinetic: object
    potentials: dict
    works: dict
    missing: object
    error: float
    largest: float

    @property
    def energy(self):
        """The change of E = T + V (11.30), (11.31)."""
        return self.kinetic + sum(self.potentials.values())

    @property
    def heat(self):
        """The change of the internal energy that the non-conservative work turns into, -U^n (11.33)."""
        return -sum(self.works.values())

    def balances(self, rtol=1e-9):
        """True if nothing is missing beyond ``rtol`` of the largest energy of the motion and the estimated error of the integrals."""
        return abs(float(self.missing)) <= rtol * self.largest + 10 * self.error

    def __str__(self):
        rows = [("change of T", self.kinetic), *((f"change of V, {n}", x) for n, x in self.potentials.items())]
        rows += [(f"work, {n}", -x) for n, x in self.works.items()]
        width = max(len(name) for name, _ in [*rows, ("not accounted for", 0)])
        lines = [f"  {name:<{width}}  {float(x):+.6g} J" for name, x in rows]
        return "\n".join(["energy equation (11.29)", *lines, f"  {'not accounted for':<{width}}  {float(self.missing):+.2g} J"])


def audit(kinetic, start, end, potentials=None, powers=None, rtol=1e-10):
    """Account for every joule of a motion from the instant ``start`` to ``end``: change of T + V = work of the other forces; an :class:`Audit`.

    kinetic : function of time, T of the whole system (a number, or an :class:`Energy`)
    potentials : by name, functions of time: V of each conservative force along the motion (11.28)
    powers : by name, functions of time: the power F.v or M.omega of each force or couple that has no potential; forces without work may be left out

    >>> import math
    >>> fall = audit(lambda t: 0.5*2.0*(9.81*t)**2, 0.0, 1.0, potentials={"weight": lambda t: -2.0*9.81*(9.81*t*t/2)})
    >>> fall.balances(), round(fall.kinetic, 4)
    (True, 96.2361)
    """
    potentials, powers = potentials or {}, powers or {}
    both = set(potentials) & set(powers)
    if both:
        raise EnergyError(f"{sorted(both)[0]!r} is given a potential and a power; its work would be counted twice")
    T = [_at(kinetic, t, "the kinetic energy") for t in (start, end)]
    V = {n: [_at(v, t, f"the potential of {n}") for t in (start, end)] for n, v in potentials.items()}
    U = {n: integral(p, start, end, rtol) for n, p in powers.items()}
    changes = {n: plain(b - a) for n, (a, b) in V.items()}
    works = {n: u.value for n, u in U.items()}
    missing = T[1] - T[0] + sum(changes.values()) - sum(works.values())
    largest = max(size(scalar(x)) for x in [*T, *(x for pair in V.values() for x in pair), *works.values()])
    return Audit(plain(T[1] - T[0]), changes, works, plain(missing), sum(u.error for u in U.values()), largest)


def _at(f, t, what):
    if not callable(f):
        raise EnergyError(f"{what} must be a function of time, as in lambda t: ...; got {f!r}")
    x = f(t)
    x = scalar(x.value if isinstance(x, Energy) else x)
    if not is_numeric(x):
        raise EnergyError(f"{what} is {plain(x)!r} at t = {t!r}; an audit needs numbers")
    return x
