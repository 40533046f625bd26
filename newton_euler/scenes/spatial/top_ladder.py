"""The ladder of models of the top: slow and exact steady precession, nutation, and a body with the
moments I0 (1 - asymmetry), I0 (1 + asymmetry), I, in Euler's angles and by the quaternion; angles
3-1-3 and symbols as in :mod:`newton_euler.scenes.spatial.top`. Observed is the axis.
"""

from contextlib import suppress
from operator import attrgetter

from ...algebra.scalars import Scalar, cos, sin
from ...applications.gyroscopes import GyroError, steady_precession
from ...kinematics import rotations
from ...motion.model import Model, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import constant_rate
from ..ladders import Ladder, Rung
from .top import QUATERNION, half_tangent_sides, momentum_difference, nutation, nutation_rates

DIRECTION = "direction of the axis, rad"
RATES = "w_x", "w_y", "w_z"


def top_slow_precession(I: Scalar, mgr: Scalar, omega_z: Scalar, theta: Scalar) -> Model:
    """The Model of steady precession of a fast top, psi' = mgr/(I omega_z), for a theta: state psi.

    >>> top_slow_precession(0.01, 0.5, 100.0, 0.6).derivative((0.0,))
    (0.5,)
    """
    given, neglects = locals(), (NUTATION, NO_TRANSVERSE, ASYMMETRY)
    name, slow = "top, slow precession", lambda p: p.mgr / (p.I * p.omega_z)
    return constant_rate(name, given, slow, "psi", neglects=neglects)


def top_steady_precession(
    I0: Scalar, I: Scalar, mgr: Scalar, omega_z: Scalar, theta: Scalar
) -> Model:
    """The Model of steady precession (10.33) at the slow one of its two rates;
    :class:`~newton_euler.applications.gyroscopes.GyroError` if no rate is real.

    >>> round(top_steady_precession(0.02, 0.01, 0.5, 100.0, 0.0).parameters["rate"], 6)
    0.505103
    """
    rate = steady_precession(I0, I, theta, omega_z=omega_z, mgr=mgr).slow
    given, neglects = {"rate": rate, "theta": theta}, (NUTATION, ASYMMETRY)
    return constant_rate("top, steady precession", given, _steady, "psi", neglects=neglects)


def asymmetric_top_euler_angles(I0: Scalar, I: Scalar, mgr: Scalar, asymmetry: Scalar) -> Model:
    """The Model with unequal moments in Euler angles, singular at theta = 0 and pi: states psi,
    theta, phi, and the body rates w_x, w_y, w_z.
    """
    given, states = locals(), ("psi", "theta", "phi", *RATES)
    return Model("top of unequal moments, Euler's angles", given, states, _euler)


def asymmetric_top_quaternion(I0: Scalar, I: Scalar, mgr: Scalar, asymmetry: Scalar) -> Model:
    """The Model with unequal moments by its quaternion: states q0 ... q3, w_x, w_y, w_z."""
    return Model("top of unequal moments, quaternion", locals(), (*QUATERNION, *RATES), _quaternion)


@scene("10.5", "top", "slow and steady precession, nutation, unequal moments", ladder=True)
def ladder(
    I0: Scalar = 0.02, I: Scalar = 0.01, mgr: Scalar = 0.5, omega_z: Scalar = 150.0,
    theta: Scalar = 0.6, theta_rate: Scalar = 0.0, precession: Scalar = 0.34,
    asymmetry: Scalar = 1e-3, t: Scalar = 1.0,
) -> Ladder:  # fmt: skip
    """The five models, for the direction of the axis, a unit vector, so that errors are angles. A
    top that is too slow has no steady precession, and its ladder no such rung.

    theta, theta_rate, precession : at the start, where psi = phi = 0; omega_z is not zero

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), angle).model.name for angle in (0.01, 1e-7)]
    ['top, slow precession', "top of unequal moments, Euler's angles"]
    """
    body = theta_rate, precession * sin(theta), omega_z
    over = momentum_difference(I0, I, theta, precession, omega_z) or 0
    rungs = [Rung(top_slow_precession(I, mgr, omega_z, theta), (0.0,), _fixed)]
    with suppress(GyroError):  # too slow
        rungs += [Rung(top_steady_precession(I0, I, mgr, omega_z, theta), (0.0,), _fixed)]
    base = nutation(I0, I, mgr, omega_z, over)
    states, neglects = (*base.states, "psi"), (ASYMMETRY,)
    own = base.parameters, states, _axis_rates, base.invariants
    nutating = Model("top, nutation and precession", *own, neglects=neglects)
    uneven, begun = (I0, I, mgr, asymmetry), rotations.quaternion_from_euler(0.0, theta, 0.0)
    rungs += [
        Rung(nutating, (theta, theta_rate, 0.0), _along),
        Rung(asymmetric_top_euler_angles(*uneven), (0.0, theta, 0.0, *body), _along),
        Rung(asymmetric_top_quaternion(*uneven), (*begun, *body), _third),
    ]
    return Ladder("top", DIRECTION, t, tuple(rungs))


def _direction(psi, theta):
    """The unit vector along the axis, in the ground."""
    return sin(theta) * sin(psi), -sin(theta) * cos(psi), cos(theta)


def _fixed(s, p, t):
    return _direction(s.psi, p.theta)


def _along(s, p, t):
    return _direction(s.psi, s.theta)


def _third(s, p, t):
    return tuple(row[2] for row in rotations.matrix_from_quaternion(_q(s)))


_q, _w, _steady = attrgetter(*QUATERNION), attrgetter(*RATES), attrgetter("rate")


def _axis_rates(s, p, t):
    tangent, q, whole, rest = half_tangent_sides(s, p)
    # (p_psi - p_phi cos(theta))/(I0 sin^2(theta)), by the tangent that is there already
    precession = (whole * (1 + tangent**2) + q + rest / tangent) / (4 * p.I0)
    return *nutation_rates(s, p, t), precession


def _body_rates(s, p, vertical):
    """Euler's equations with the moment of the weight, r k x (-mg K)."""
    I_x, I_y, I_z = p.I0 * (1 - p.asymmetry), p.I0 * (1 + p.asymmetry), p.I
    x, y, _ = vertical
    return (
        (p.mgr * y + (I_y - I_z) * (s.w_y * s.w_z)) / I_x,
        (-p.mgr * x + (I_z - I_x) * (s.w_z * s.w_x)) / I_y,
        (I_x - I_y) * (s.w_x * s.w_y) / I_z,
    )


def _euler(s, p, t):
    angles = s.psi, s.theta, s.phi
    turning = rotations.euler_rates(*angles, _w(s))
    return *turning, *_body_rates(s, p, rotations.euler_matrix(*angles)[2])


def _quaternion(s, p, t):
    q = _q(s)
    turning = rotations.quaternion_rate(q, _w(s))
    return *turning, *_body_rates(s, p, rotations.matrix_from_quaternion(q)[2])


NUTATION = Neglected("the nutation", None, DIRECTION)
NO_TRANSVERSE = Neglected("I0 psi' cos(theta) against I omega_z", None, DIRECTION)
ASYMMETRY = Neglected("the difference of the transverse moments", None, DIRECTION)
