"""Kinetic energy and the energy equation (11.12)-(11.14), (11.26)-(11.33), (11.36)-(11.53): the
books of a motion must balance.

Velocities are those in an inertial frame. A sum keeps its terms by name, in an
:class:`~newton_euler.dynamics.work.Amount`: kinetic energy those of translation and rotation, or of
each body; the audit of a motion every potential and every work. Units: any consistent ones; in SI J
and W.

    change of T = U                            speed_after(v0, U, m)                       (11.14)
    change of T + V = U of the other forces    audit(kinetic, t0, t1, potentials, powers)  (11.29),
    (11.48) their rates                                kinetic_energy_rate, rigid_power
    (11.36)-(11.40)
"""

from dataclasses import dataclass

from ..algebra.errors import NewtonEulerError
from ..algebra.ledger import summed, value_of
from ..algebra.scalars import (
    anywhere,
    cos,
    is_numeric,
    plain,
    probe,
    scalar,
    short,
    sin,
    size,
    sqrt,
)
from ..bodies.body import Body
from .work import power, work_integral


class EnergyError(NewtonEulerError, ValueError):
    """Energies or works that cannot be added up, or an audit that is asked what it cannot tell."""


# -- kinetic energy


def kinetic_energy(bodies, observer):
    """T = m v.v/2 + omega.H/2 of a body (11.45), or of bodies together (11.42), seen from the
    inertial frame ``observer``; an Amount.

    bodies : a :class:`~newton_euler.bodies.body.Body` (a particle too, (11.13)): terms
        ``translation`` and ``rotation``; or several: a term for each

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import sphere
    >>> ground = Frame("ground")
    >>> ball = ground.rotate("ball", "y", rate=10.0)
    >>> T = kinetic_energy(sphere(0.5, ball, mass=2.0), ground)
    >>> round(T.terms["rotation"], 9)
    10.0
    """
    if not isinstance(bodies, Body):
        return _of_system(list(bodies), observer)
    v, omega = bodies.centre.velocity(observer), bodies.frame.angular_velocity(observer)
    rotation = omega.dot(bodies.angular_momentum(observer))
    return summed(
        {"translation": scalar(v.dot(v)) * bodies.mass / 2, "rotation": scalar(rotation) / 2},
        "kinetic energy",
        "11.45",
    )


def _of_system(bodies, observer):
    names = [b.name for b in bodies]
    if len(set(names)) < len(names):
        raise EnergyError(
            f"two bodies have the name {next(n for n in names if names.count(n) > 1)!r}; the "
            "terms need names of their own"
        )
    return summed({b.name: kinetic_energy(b, observer) for b in bodies}, "kinetic energy", "11.42")


def kinetic_energy_about(body, point, observer):
    """T = omega.H_B/2 of a body whose point B is at rest (11.52), (11.53): fixed, as a pivot, or at
    the instant, as a contact in rolling; an Amount.

    point : a Point that coincides with B now; :class:`EnergyError` if the body moves there
    """
    omega = body.frame.angular_velocity(observer)
    v_G, turning = (
        body.centre.velocity(observer),
        omega.cross((point - body.centre).expressed_in(omega.frame)),
    )
    v, scale = (v_G + turning).norm(), scalar(v_G.norm()) + turning.norm()
    if is_numeric(scale) and anywhere(plain(v) > 1e-9 * plain(scale)):
        raise EnergyError(
            f"the point of {body.name} at {point.name} moves, at {short(v)}: (11.52) needs "
            f"a point of the body that is at rest in {observer.name}; "
            "use kinetic_energy, or name another point"
        )
    return summed(
        {"rotation": scalar(omega.dot(body.about(point).times(omega))) / 2},
        "kinetic energy",
        "11.52",
    )


def plane_kinetic_energy(m, speed, moment_of_inertia, rate):
    """T = m v^2/2 + I_zz omega^2/2 of plane motion (11.51), speed of G and moment of inertia about
    G; an Amount.

    >>> plane_kinetic_energy(2.0, 3.0, 0.5, 4.0).terms
    {'translation': 9.0, 'rotation': 4.0}
    """
    terms = {
        "translation": scalar(m) * speed * speed / 2,
        "rotation": scalar(moment_of_inertia) * rate * rate / 2,
    }
    return summed(terms, "kinetic energy", "11.51")


def gyroscope_energy(I0, I, theta, nutation_rate, precession, spin):
    """T of a symmetric body about its fixed point (11.53), (11.16): [I0 (theta'^2 + psi'^2 sin^2
    theta) + I (phi' + psi' cos theta)^2]/2; an Amount.

    Moments of inertia, angles and rates as in :mod:`newton_euler.applications.gyroscopes`; terms
    ``transverse`` and ``axial``

    >>> gyroscope_energy(1.5, 1.0, 0.0, 0.0, 2.0, 3.0).value  # upright, all about one line
    12.5
    """
    across, axial = scalar(precession) * sin(theta), scalar(spin) + precession * cos(theta)
    transverse = scalar(I0) * (scalar(nutation_rate) * nutation_rate + across * across) / 2
    return summed(
        {"transverse": transverse, "axial": scalar(I) * axial * axial / 2},
        "kinetic energy",
        "11.53",
    )


# -- rates


def kinetic_energy_rate(body, observer):
    """dT/dt of a body from its motion, an Amount in W: m a.v (11.36) and (dH/dt).omega (11.38),
    (11.40) as ``translation`` and ``rotation``.

    It equals the power of the forces and moments, see :func:`rigid_power`.
    """
    v, a = body.centre.velocity(observer), body.centre.acceleration(observer)
    omega, M = body.frame.angular_velocity(observer), body.angular_momentum(observer).rate(observer)
    return summed(
        {"translation": scalar(a.dot(v)) * body.mass, "rotation": M.dot(omega)},
        "rate of kinetic energy",
        "11.36, 11.40",
    )


def rigid_power(body, observer, force, moment):
    """The power of all forces on a rigid body, F.v_G + M.omega, an Amount in W with terms
    ``translation`` and ``rotation`` (11.47).

    force : their resultant; moment : their moment about the centre of mass; Vectors
    """
    parts = {
        "translation": power(force, body.centre, observer),
        "rotation": power(moment, body.frame, observer),
    }
    return summed(parts, "power", "11.47")


# -- the energy equation


def speed_after(speed, work, m):
    """The speed of a particle on which the work U was done: v_1 = sqrt(v_0^2 + 2 U/m) (11.12),
    (11.14).

    work : U, or the loss of potential energy (11.29), or both together; of a body of which T is
        (some m) v^2/2, as in rolling, give that m
    Raises :class:`EnergyError` if it does not get there: it would stop on the way.

    >>> round(speed_after(2.0, 2.0*9.81*0.15, 2.0), 3)  # the ball on a cord, 0.15 m lower
    2.635
    """
    U = value_of(work)
    square = scalar(speed) * speed + 2 * U / m
    if is_numeric(square) and anywhere(plain(square) < 0):
        had = plain(scalar(m) * speed * speed / 2)
        raise EnergyError(
            f"it does not get there: the work {short(plain(U))} takes more than the kinetic "
            f"energy {short(had)}, so it stops before"
        )
    return plain(sqrt(square))


@dataclass(frozen=True, eq=False)
class Audit:
    """The energy equation of a motion from one instant to another (11.29), (11.48): ``kinetic`` +
    ``potentials`` = ``works``, changes in J by name.

    missing : what the books do not account for, the change of T + V less the work of the other
        forces
    error : how far the integrals may be off; largest : the largest of the energies and works, to
        compare with
    """

    kinetic: object
    potentials: dict
    works: dict
    missing: object
    error: float
    largest: float

    @property
    def energy(self):
        """The change of E = T + V (11.30), which is U^n (11.31) and zero for a conservative system
        (11.32), (11.49).
        """
        return plain(scalar(self.kinetic) + value_of(summed(self.potentials)))

    def heat(self, *names):
        """The change of internal energy, -U^n (11.33), by the forces named, as friction and drag;
        by all without a potential if none is.
        """
        unknown = [n for n in names if n not in self.works]
        if unknown:
            raise EnergyError(
                f"no work of {unknown[0]!r} is in this audit; there are "
                f"{', '.join(self.works) or 'none'}"
            )
        return -summed({n: self.works[n] for n in names or self.works})

    def balances(self, rtol=1e-9):
        """True if nothing is missing beyond ``rtol`` of the largest energy of the motion and the
        estimated error of the integrals.
        """
        return (
            size(scalar(_compared(self.missing, "what is missing")))
            <= rtol * self.largest + 10 * self.error
        )

    def __str__(self):
        rows = [
            ("change of T", self.kinetic),
            *((f"change of V, {n}", x) for n, x in self.potentials.items()),
        ]
        rows += [
            *((f"less work, {n}", -x) for n, x in self.works.items()),
            ("not accounted for", self.missing),
        ]
        width = max(len(name) for name, _ in rows)
        return "\n".join(
            ["energy equation (11.29), J", *(f"  {name:<{width}}  {short(x)}" for name, x in rows)]
        )


def audit(kinetic, start, end, potentials=None, powers=None, rtol=1e-10, exact=False, breaks=()):
    """Account for every joule of a motion from the instant ``start`` to ``end``: change of T + V =
    work of the other forces; an :class:`Audit`.

    kinetic : function of time, T of the whole system (a number, or an Amount)
    potentials : by name, functions of time: V of each conservative force along the motion (11.26),
        (11.28)
    powers : by name, functions of time: the power F.v or M.omega of each force or couple that has
        no potential (11.27), friction between two bodies at the velocity of the one relative to the
        other. Forces without work may be left out
    rtol, exact, breaks : of the works, see :func:`newton_euler.dynamics.work.work_integral`;
        ``breaks`` where the motion changes its regime

    >>> fall = audit(lambda t: 0.5*2.0*(9.81*t)**2, 0.0, 1.0, potentials={"weight": lambda t: -2.0*9.81*(9.81*t*t/2)})
    >>> fall.balances(), round(fall.kinetic, 4)
    (True, 96.2361)
    """
    potentials, powers = potentials or {}, powers or {}
    both = sorted(set(potentials) & set(powers))
    if both:
        raise EnergyError(
            f"{both[0]!r} is given a potential and a power; its work would be counted twice"
        )
    T = [_at(kinetic, t, "the kinetic energy") for t in (start, end)]
    V = {
        n: [_at(v, t, f"the potential of {n}") for t in (start, end)] for n, v in potentials.items()
    }
    U = {
        n: work_integral(_power_of(p, n), start, end, rtol, exact, breaks)
        for n, p in powers.items()
    }
    changes, works = (
        {n: plain(b - a) for n, (a, b) in V.items()},
        {n: u.value for n, u in U.items()},
    )
    missing = T[1] - T[0] + value_of(summed(changes)) - value_of(summed(works))
    energies = [*T, *(x for pair in V.values() for x in pair), *works.values()]
    largest = max(size(scalar(_compared(x, "an energy"))) for x in energies)
    return Audit(
        plain(T[1] - T[0]),
        changes,
        works,
        plain(missing),
        sum(u.error for u in U.values()),
        largest,
    )


def _at(f, t, what):
    return value_of(_function(f, what)(t))


def _power_of(p, name):
    _function(p, f"the power of {name}")
    return lambda t: plain(value_of(p(t)))


def _function(f, what):
    if not callable(f):
        raise EnergyError(f"{what} must be a function of time, as in lambda t: ...; got {f!r}")
    return f


def _compared(x, what):
    """A number to compare; of an expression its value at some values of its symbols."""
    value = probe(scalar(x))
    if value is None:
        raise EnergyError(
            f"{what} is {plain(x)!r}; an audit needs numbers, or SymPy expressions and exact=True"
        )
    return value
