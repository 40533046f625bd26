"""Kinetic energy and the energy equation (11.12)-(11.14), (11.26)-(11.33), (11.36)-(11.53).

Velocities are those in an inertial frame. A sum keeps its terms by name, in an
:class:`~newton_euler.algebra.ledger.Amount`. Units: any consistent ones; in SI J and W.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from ..algebra.errors import Accuracy, NewtonEulerError, Tolerance, checked, checked_but
from ..algebra.ledger import Amount, in_columns, summed, value_of
from ..algebra.scalars import Scalar, anywhere, cos, is_numeric, scalar, short, sin, sqrt, to_plain
from ..algebra.vectors import Vector
from ..bodies.admissibility import not_negative
from ..bodies.body import Body
from ..kinematics.frames import Frame, Point
from .work import magnitude, power, work_integral


class EnergyError(NewtonEulerError, ValueError):
    """Energies or works that cannot be added up or compared."""


@checked
def kinetic_energy(bodies: Body | Iterable[Body], observer: Frame) -> Amount:
    """The kinetic energy T = m v.v/2 + omega.H/2 of a body (11.45), or of several together (11.42),
    seen from the inertial frame ``observer``.

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
        each = [(body, kinetic_energy(body, observer)) for body in bodies]
        return summed([(body.name, T) for body, T in each], "kinetic energy", "11.42")
    v, omega = bodies.centre.velocity(observer), bodies.frame.angular_velocity(observer)
    terms = {
        "translation": scalar(v.dot(v)) * bodies.mass / 2,
        "rotation": scalar(omega.dot(bodies.angular_momentum(observer))) / 2,
    }
    return summed(terms, "kinetic energy", "11.45")


@checked
def kinetic_energy_about(body: Body, point: Point, observer: Frame) -> Amount:
    """The kinetic energy T = omega.H_B/2 of a body that turns about its point B, at ``point`` and
    at rest now (11.52), (11.53); :class:`EnergyError` if it moves.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import rod
    >>> ground = Frame("ground")
    >>> arm = ground.rotate("arm", "z", rate=2.0)
    >>> bar = rod(3.0, arm.point("G", 1.5, 0, 0), "x", mass=1.0)
    >>> kinetic_energy_about(bar, arm.origin, ground).value
    6.0
    """
    omega = body.frame.angular_velocity(observer)
    v_G = body.centre.velocity(observer)
    relative = omega.cross((point - body.centre).expressed_in(omega.frame))
    v, scale = (v_G + relative).norm(), scalar(v_G.norm()) + relative.norm()
    # v_G + omega x r of a point at rest is a difference of equals: round-off of its two parts
    if is_numeric(scale) and anywhere(to_plain(v) > 1e-9 * to_plain(scale)):
        raise EnergyError(
            f"the point of {body.name} at {point.name} moves, at {short(v)}: (11.52) needs a point "
            f"of the body that is at rest in {observer.name}; use kinetic_energy"
        )
    rotation = scalar(omega.dot(body.about(point).times(omega))) / 2
    return summed({"rotation": rotation}, "kinetic energy", "11.52")


@checked
def plane_kinetic_energy(
    m: Scalar, speed: Scalar, moment_of_inertia: Scalar, rate: Scalar
) -> Amount:
    """The kinetic energy T = m v^2/2 + I_zz omega^2/2 of plane motion (11.51); I_zz about G.

    >>> plane_kinetic_energy(2.0, 3.0, 0.5, 4.0).terms
    {'translation': 9.0, 'rotation': 4.0}
    """
    not_negative(m, "the mass")
    not_negative(moment_of_inertia, "the moment of inertia")
    terms = {
        "translation": scalar(m) * speed * speed / 2,
        "rotation": scalar(moment_of_inertia) * rate * rate / 2,
    }
    return summed(terms, "kinetic energy", "11.51")


@checked
def gyroscope_energy(
    I0: Scalar, I: Scalar, theta: Scalar, nutation_rate: Scalar, precession: Scalar, spin: Scalar
) -> Amount:
    """The kinetic energy of a symmetric body about its fixed point (11.53), (11.16), with terms
    ``transverse``, ``axial``: [I0 (theta'^2 + psi'^2 sin^2 theta) + I (phi' + psi' cos theta)^2]/2.
    Arguments as in :mod:`newton_euler.applications.gyroscopes`.

    >>> gyroscope_energy(1.5, 1.0, 0.0, 0.0, 2.0, 3.0).value  # upright, all about one line
    12.5
    """
    not_negative(I0, "the transverse moment of inertia")
    not_negative(I, "the axial moment of inertia")
    across, axial = scalar(precession) * sin(theta), scalar(spin) + precession * cos(theta)
    terms = {
        "transverse": scalar(I0) * (scalar(nutation_rate) * nutation_rate + across * across) / 2,
        "axial": scalar(I) * axial * axial / 2,
    }
    return summed(terms, "kinetic energy", "11.53")


@checked
def kinetic_energy_rate(body: Body, observer: Frame) -> Amount:
    """The rate dT/dt of a body from its motion, in W: the terms ``translation``, m a.v (11.36), and
    ``rotation``, (dH/dt).omega (11.38), (11.40); the power of the forces, see :func:`rigid_power`.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import rod
    >>> ground = Frame("ground")
    >>> arm = ground.rotate("arm", "z", rate=2.0, acceleration=5.0)
    >>> kinetic_energy_rate(rod(1.0, arm.point("G", 0, 0, 0), "x", mass=12.0), ground).value
    10.0
    """
    centre, omega = body.centre, body.frame.angular_velocity(observer)
    translation = scalar(centre.acceleration(observer).dot(centre.velocity(observer))) * body.mass
    rotation = body.angular_momentum(observer).rate(observer).dot(omega)
    terms = {"translation": translation, "rotation": rotation}
    return summed(terms, "rate of kinetic energy", "11.36, 11.40")


@checked
def rigid_power(body: Body, observer: Frame, force: Vector, moment: Vector) -> Amount:
    """The power of all forces on a rigid body, F.v_G + M.omega, in W, with the terms
    ``translation`` and ``rotation`` (11.47).

    force, moment : their resultant, and their moment about the centre of mass

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import sphere
    >>> ground = Frame("ground")
    >>> ball = sphere(0.5, ground.rotate("ball", "z", rate=4.0), mass=2.0)
    >>> rigid_power(ball, ground, 3.0*ground.i, -1.0*ground.k).terms
    {'translation': 0, 'rotation': -4.0}
    """
    of_force, of_moment = power(force, body.centre, observer), power(moment, body.frame, observer)
    return summed({"translation": of_force, "rotation": of_moment}, "power", "11.47")


@checked
def speed_after(speed: Scalar, work: Amount | Scalar, m: Scalar) -> Scalar:
    """The speed of a particle after the work U: v_1 = sqrt(v_0^2 + 2 U/m) (11.12), (11.14).

    work : U, or the loss of potential energy (11.29), or the sum of both
    m : the mass; of a body with T = (some m) v^2/2, as in rolling, that m
    Raises :class:`EnergyError` if the kinetic energy is less than the work against the motion.

    >>> round(speed_after(2.0, 2.0*9.81*0.15, 2.0), 3)  # the ball on a cord, 0.15 m lower
    2.635
    """
    U = value_of(work)
    square = scalar(speed) * speed + 2 * U / m
    if is_numeric(square) and anywhere(to_plain(square) < 0):
        raise EnergyError(
            f"it does not get there: the work {short(to_plain(U))} takes more than the kinetic "
            f"energy {short(to_plain(scalar(m) * speed * speed / 2))}, so it stops before"
        )
    return to_plain(sqrt(square))


@dataclass(frozen=True, eq=False)
class Audit:
    """The energy balance of a motion between two instants (11.29), (11.48): ``kinetic`` +
    ``potentials`` = ``works``, changes in J by name.

    residual, error : the change of T + V less the other works; the error of the integrals
    largest : the largest of the energies and works, to compare with
    """

    kinetic: Scalar
    potentials: dict[str, Scalar]
    works: dict[str, Scalar]
    residual: Scalar
    error: float
    largest: float

    @property
    def energy(self) -> Scalar:
        """The change of E = T + V (11.30): U^n (11.31); zero if conservative (11.32), (11.49)."""
        return to_plain(scalar(self.kinetic) + value_of(summed(self.potentials)))

    @checked
    def heat(self, *names: str) -> Scalar:
        """The internal energy gained, -U^n (11.33), by these forces, or all without potential."""
        if unknown := [n for n in names if n not in self.works]:
            raise EnergyError(
                f"no work of {unknown[0]!r} is in this audit; it has {', '.join(self.works)}"
            )
        return -summed({n: self.works[n] for n in names or self.works})

    @checked
    def balances(self, rtol: Tolerance = 1e-9) -> bool:
        """True if the residual is within ``rtol`` of the largest energy and ten times ``error``."""
        # ten times: the estimates of quadrature can be too small; products of numbers below 1e-300
        # underflow and have few digits or none
        return magnitude(self.residual) <= rtol * self.largest + 10 * self.error + 1e-300

    def __str__(self):
        changes = {
            "change of T": self.kinetic,
            **{f"change of V, {n}": x for n, x in self.potentials.items()},
            **{f"less work, {n}": -x for n, x in self.works.items()},
            "residual": 0.0 if self.balances() else self.residual,
        }
        rows = [(name, short(x)) for name, x in changes.items()]
        return in_columns("energy equation (11.29), J", rows)


InTime: TypeAlias = Callable[[Scalar], Scalar | Amount]  # takes the time


@checked_but("kinetic")
def audit(
    kinetic: InTime,
    start: Scalar,
    end: Scalar,
    potentials: dict[str, InTime] | None = None,
    powers: dict[str, InTime] | None = None,
    rtol: Accuracy = 1e-10,
    exact: bool = False,
    breaks: Sequence[Scalar] = (),
) -> Audit:
    """The energy balance of a motion from the instant ``start`` to ``end``: change of T + V = work
    of the other forces (11.29), (11.48).

    kinetic : function of time, T of the whole system (a number, or an Amount)
    potentials : by name, functions of time: V of each conservative force along the motion (11.26),
        (11.28)
    powers : by name, functions of time: the power F.v or M.omega of each force or couple that has
        no potential (11.27); of friction between two bodies with their relative velocity
    rtol, exact, breaks : of the works, see :func:`newton_euler.dynamics.work.work_integral`;
        ``breaks`` where the motion changes its regime

    >>> weight = {"weight": lambda t: -2.0*9.81*(9.81*t*t/2)}
    >>> fall = audit(lambda t: 0.5*2.0*(9.81*t)**2, 0.0, 1.0, potentials=weight)
    >>> fall.balances(), round(fall.kinetic, 4)
    (True, 96.2361)
    """
    potentials, powers = potentials or {}, powers or {}
    T = _at_both(kinetic, "the kinetic energy", start, end)
    V = {n: _at_both(v, f"the potential of {n}", start, end) for n, v in potentials.items()}
    U = {
        n: work_integral(_function(p, f"the power of {n}"), start, end, rtol, exact, breaks)
        for n, p in powers.items()
    }
    changes, change = {n: to_plain(b - a) for n, (a, b) in V.items()}, T[1] - T[0]
    works = {n: u.value for n, u in U.items()}
    residual = change + value_of(summed(changes)) - value_of(summed(works))
    energies = [*T, *(x for pair in V.values() for x in pair), *works.values()]
    error, largest = sum(u.error for u in U.values()), max(map(magnitude, energies))
    return Audit(to_plain(change), changes, works, to_plain(residual), error, largest)


def _at_both(f, what, start, end):
    of_time = _function(f, what)
    return of_time(start), of_time(end)  # map would end at a StopIteration of the caller


def _function(f, what):
    if not callable(f):
        raise EnergyError(f"{what} must be a function of time, as in lambda t: ...; got {f!r}")
    return lambda t: value_of(f(t))
