"""The symmetric top with a fixed point under gravity (10.5, 10.6): :func:`nutation` for nutation
alone, :func:`attitude` for pictures, :func:`nonspinning_frame` for a fast top, :func:`euler` for
psi and phi off the vertical; and the free symmetric body (10.8).

Symbols as in :mod:`newton_euler.applications.gyroscopes`; the parameter ``omega_z`` is constant.
"""

from dataclasses import replace
from operator import attrgetter

from ...algebra.portable import Values
from ...algebra.scalars import Scalar, Triple, cos, integer_like, sin, sqrt, tan, where
from ...algebra.vectors import dot3
from ...kinematics import rotations
from ...motion.model import Model, comparable
from ..catalogue import scene
from ..closed_forms.elliptic import coupled, unwrapped
from ..closed_forms.harmonic import rotated

QUATERNION = "q0", "q1", "q2", "q3"
_q = attrgetter(*QUATERNION)
SPIN = 8.0  # rad/s
# the top of the scenes, let go at 0.6 rad from the vertical, which nutates
TOP: dict[str, Scalar] = {"I0": 1.0, "I": 1.5, "mgr": 5.0, "omega_z": SPIN}


def tilted(theta: Scalar) -> Triple:
    """The start of :func:`nonspinning_frame` at rest at the angle ``theta`` (rad)."""
    return cos(theta / 2), sin(theta / 2), 0.0, 0.0, 0.0, 0.0


def momentum_difference(
    I0: Scalar, I: Scalar, theta: Scalar, precession: Scalar, omega_z: Scalar
) -> Scalar:
    """p_psi - p_phi = I0 psi' sin^2(theta) - I omega_z (1 - cos(theta)): zero for a top that passes
    through the upright position.

    >>> momentum_difference(0.02, 0.01, 0.0, 3.0, 100.0)
    0.0
    """
    return I0 * precession * sin(theta) ** 2 - 2 * I * omega_z * sin(theta / 2) ** 2


@scene(
    "10.5", "top, nutation", "the angle of a nutating top from the vertical",
    10.0, (0.6, 0.0),
    **TOP, momentum_difference=momentum_difference(1.0, 1.5, 0.6, 0.0, SPIN),
)  # fmt: skip
def nutation(
    I0: Scalar, I: Scalar, mgr: Scalar, omega_z: Scalar, momentum_difference: Scalar
) -> Model:
    """The Model of the nutation alone (10.24), with the cyclic angles eliminated: states theta,
    theta_rate; invariant the energy, less that of spin.

    momentum_difference : from the start, by the function :func:`momentum_difference`; 0 for a
        sleeping top, and then theta = 0 is not a singular place
    I0 theta'' = mgr sin(theta) - d/dtheta (p_psi - p_phi cos(theta))^2/(2 I0 sin^2(theta)), with
    the quotient by half angles as (p tan(theta/2) + q/tan(theta/2))^2/(8 I0), p = p_psi + p_phi, q
    = p_psi - p_phi = momentum_difference. A pendulum has I = 0; ``mgr`` may be of either sign or 0.
    The exact solution is by elliptic functions; it goes through the vertical where q, or p for the
    downward one, is exactly 0, and counts the turns of a pendulum.

    >>> top = nutation(0.02, 0.01, 0.5, 100.0, 0)
    >>> [round(x, 6) for x in top.solution(0.05, (0.0, 0.1))]  # it goes through the upright
    [0.00384, 0.033918]
    """
    given, states = locals(), ("theta", "theta_rate")
    invariants = {"energy": _nutation_energy}
    return Model("top, nutation alone", given, states, nutation_rates, invariants, nutation_exact)


def half_tangent_sides(s: Values, p: Values) -> Triple:
    """tan(theta/2), q, p and q/tan(theta/2), of which the quotient of :func:`nutation` consists."""
    t, q = tan(s.theta / 2), p.momentum_difference
    return t, q, 2 * (p.I * p.omega_z) + q, q / t


def nutation_rates(s: Values, p: Values, t: Scalar) -> Triple:
    """The right-hand side of :func:`nutation`, (10.24)."""
    t, q, whole, rest = half_tangent_sides(s, p)
    slope = (whole * t + rest) * (whole * (1 + t * t) - (q + rest / t)) / (8 * p.I0)
    # sin(theta) from the tangent that is there
    return s.theta_rate, (p.mgr * (2 * t / (1 + t * t)) - slope) / p.I0


def _nutation_energy(s, p, t):
    t, _, whole, rest = half_tangent_sides(s, p)
    return p.I0 * s.theta_rate**2 / 2 + (whole * t + rest) ** 2 / (8 * p.I0) + p.mgr * cos(s.theta)


def nutation_exact(s: Values, p: Values, t: Scalar) -> tuple[Scalar, Scalar]:
    """theta and theta_rate of :func:`nutation` at t after ``s``, by elliptic functions.

    With v = 1 - cos(theta) the energy gives I0 v'^2/2 = F(v), a cubic with the roots v1, v2 and
    -zeta/mgr. The roots of v - v1, v2 - v and zeta + mgr v change at rates that are products of the
    two others. A top that is pulled up is one that is pulled down, seen from below.
    """
    # here: only the exact solution needs this room, which takes 30 ms to load
    from ...applications.nutation import exchanged

    given = s.theta, s.theta_rate, p.I0, p.I, p.mgr, p.omega_z, p.momentum_difference, t
    theta, rate, I0, I, mgr, omega_z, q, t = comparable("top", *given)
    whole, below, start = 2 * (I * omega_z) + q, mgr < 0, (cos(theta / 2), sin(theta / 2))
    (S, C), sides = exchanged(below, start[1], start[0]), exchanged(below, q, whole)
    S1, C1, rate1, phase = _nutation(S, C, where(below, -rate, rate), I0, abs(mgr), *sides, t)
    sine, cosine = exchanged(below, S1, C1)
    phase = where(rate < 0, -phase, phase)
    return 2 * unwrapped(theta / 2, start, (cosine, sine), phase), where(below, -rate1, rate1)


def _nutation(S, C, rate, I0, mgr, q, whole, t):
    """sin and cos of theta/2, theta' and the mean phase (0 unless it turns over); mgr >= 0."""
    from ...applications.nutation import turning_points

    v = 2 * (S * S)
    rest = q * C / (2 * where(abs(q) > 0, S, 1))
    more = whole * S / (2 * where(abs(whole) > 0, C, 1))
    transverse = rest + more, rest - more
    (X, Y), (v1, w2), zeta = turning_points(S, C, rate, I0, mgr, (q, whole), transverse)
    k = 1 / sqrt(2 * I0)
    start = _signed(sqrt(X), S), _signed(sqrt(Y), C), _signed(sqrt(zeta + mgr * v), rate)
    x, y, z, phase = coupled((k, -k, k * mgr), start, -(zeta + mgr * v1) / (2 * I0), t)
    S1, slant = _off(v1, x, S)
    C1, slant2 = _off(w2, y, C)
    return S1, C1, 2 * k * z * (slant * slant2), where(v1 > 0, 0, where(w2 > 0, 0, phase))


def _signed(x, like):
    return where(like < 0, -x, x)


def _off(least, x, like):
    """sqrt((least + x^2)/2), and x over sqrt(least + x^2), which is 1 through the vertical."""
    root = sqrt(least + x * x)
    off = least > 0
    return where(off, _signed(root, like), x) / sqrt(integer_like(2, root)), where(
        off, _signed(x, like) / where(off, root, 1), 1
    )


@scene(
    "10.5", "top, angles", "the nutating top in Euler's angles",
    10.0, (0.0, 0.6, 0.0, 0.0, 0.0), **TOP,
)  # fmt: skip
def euler(I0: Scalar, I: Scalar, mgr: Scalar, omega_z: Scalar) -> Model:
    """The Model of the top in Euler angles (10.25): states psi, theta, phi, psi_rate, theta_rate;
    invariants energy and p_psi. Singular at theta = 0 and pi.

    >>> import math
    >>> top = euler(0.02, 0.01, 0.5, 100.0)
    >>> round(top.derivative((0, math.pi/2, 0, 0.5, 0.0))[4], 12)  # it precesses steadily
    0.0
    """
    parameters, states = locals(), ("psi", "theta", "phi", "psi_rate", "theta_rate")
    invariants = {"energy": _euler_energy, "p_psi": _euler_vertical}
    return Model("top in Euler's angles", parameters, states, _euler_rates, invariants)


def _euler_rates(s, p, t):
    sine, cosine, h = sin(s.theta), cos(s.theta), p.I * p.omega_z
    psi_acceleration = s.theta_rate * (h / p.I0 - 2 * (s.psi_rate * cosine)) / sine
    theta_acceleration = sine * (s.psi_rate**2 * cosine + (p.mgr - h * s.psi_rate) / p.I0)
    spin = p.omega_z - s.psi_rate * cosine
    return s.psi_rate, s.theta_rate, spin, psi_acceleration, theta_acceleration


def _euler_energy(s, p, t):
    transverse = p.I0 * (s.theta_rate**2 + (s.psi_rate * sin(s.theta)) ** 2)
    return (transverse + p.I * p.omega_z**2) / 2 + p.mgr * cos(s.theta)


def _euler_vertical(s, p, t):
    return p.I0 * (s.psi_rate * sin(s.theta) ** 2) + p.I * p.omega_z * cos(s.theta)


@scene("10.5", "top", "a nutating top, in the frame that does not spin", 10.0, tilted(0.6), **TOP)
def nonspinning_frame(I0: Scalar, I: Scalar, mgr: Scalar, omega_z: Scalar) -> Model:
    """The Model of the top in a frame that follows its axis and does not rotate about it, (10.20)
    with Omega_z = 0: it has no singular position and no fast angle.

    states : q0 … q3, the quaternion of the frame, and w_x, w_y, the transverse angular velocity in
        it (rad/s); that of the body: :func:`newton_euler.chapters.examples.ch10.body_quaternion`
    invariants : energy, p_psi and the norm of the quaternion

    >>> # upright: the axis of the tilting moves on
    >>> nonspinning_frame(0.02, 0.01, 0.5, 100.0).derivative((1.0, 0.0, 0.0, 0.0, 0.1, 0.0))[4:]
    (0.0, 5.0)
    """
    given, states = locals(), (*QUATERNION, "w_x", "w_y")
    name = "top in the frame that does not spin"
    return Model(name, given, states, _nonspinning_rates, _NONSPINNING_INVARIANTS)


def _vertical(s):
    """The components of the vertical K in the frame."""
    return rotations.matrix_from_quaternion(_q(s))[2]


def _nonspinning_rates(s, p, t):
    x, y, _ = _vertical(s)
    h = p.I * p.omega_z
    turning = rotations.quaternion_rate(_q(s), (s.w_x, s.w_y, 0))
    return *turning, (p.mgr * y - h * s.w_y) / p.I0, (h * s.w_x - p.mgr * x) / p.I0


def _nonspinning_energy(s, p, t):
    return (p.I0 * (s.w_x**2 + s.w_y**2) + p.I * p.omega_z**2) / 2 + p.mgr * _vertical(s)[2]


_NONSPINNING_INVARIANTS = {
    "energy": _nonspinning_energy,
    "p_psi": lambda s, p, t: dot3(_vertical(s), (p.I0 * s.w_x, p.I0 * s.w_y, p.I * p.omega_z)),
    "norm": lambda s, p, t: s.q0**2 + s.q1**2 + s.q2**2 + s.q3**2,
}


@scene(
    "10.5", "top, attitude", "the nutating top by the quaternion of the body",
    10.0, tilted(0.6), **TOP,
)  # fmt: skip
def attitude(I0: Scalar, I: Scalar, mgr: Scalar, omega_z: Scalar) -> Model:
    """The Model of the top in its own axes, (10.20) with Omega_z = omega_z, for animations: states
    and invariants as for :func:`nonspinning_frame`, but of the body. The start is a *unit*
    quaternion: the rates do not divide by its length.

    >>> attitude(0.02, 0.01, 0.5, 100.0).derivative((1.0, 0.0, 0.0, 0.0, 0.1, 0.0))[4:]
    (0.0, -5.0)
    """
    model = nonspinning_frame(I0, I, mgr, omega_z)
    return replace(model, name="top, attitude", rhs=_attitude_rates)


def _attitude_rates(s, p, t):
    q0, q1, q2, q3 = q = _q(s)
    pull, rate = 2 * p.mgr / p.I0, (p.I - p.I0) / p.I0 * p.omega_z
    turning = rotations.quaternion_rate(q, (s.w_x, s.w_y, p.omega_z))
    x, y = pull * (q1 * q3 - q0 * q2), pull * (q2 * q3 + q0 * q1)
    return *turning, y - rate * s.w_y, rate * s.w_x - x


@scene(
    "10.8", "free symmetric body", "a football, with its attitude",
    10.0, (1.0, 0.0, 0.0, 0.0, 0.8, 0.0), I0=3.0, I=1.0, omega_z=6.0,
)  # fmt: skip
def free(I0: Scalar, I: Scalar, omega_z: Scalar) -> Model:
    """The Model of a symmetric body without moment (10.35), (10.36): :func:`nonspinning_frame` with
    the exact solution; omega_z is not zero. The frame turns about the constant H at the rate H/I0,
    and back about its axis at I omega_z/I0.

    >>> body = free(0.02, 0.01, 100.0)
    >>> # I omega_z/I0 = 50 rad/s
    >>> [round(x, 6) for x in body.solution(0.2, (1.0, 0, 0, 0, 1.0, 0.0))[4:]]
    [-0.839072, -0.544021]
    """
    model = nonspinning_frame(I0, I, 0, omega_z)
    return replace(model, name="free symmetric body", exact=_free_exact)


def _free_exact(s, p, t):
    start, rate = _q(s), p.I * p.omega_z / p.I0
    to_ground = rotations.matrix_from_quaternion(start)
    about = rotations.apply(to_ground, (s.w_x, s.w_y, rate))  # H/I0
    moved = rotations.quaternion(about, sqrt(dot3(about, about)) * t)
    back = rotations.quaternion((0, 0, 1), -rate * t)
    q = rotations.quaternion_product(rotations.quaternion_product(moved, start), back)
    return *q, *rotated(s.w_x, s.w_y, rate * t)
