"""Tops and gyroscopes (chapter 10): a body of revolution that turns about a point of its axis.

Moments of inertia about that point: ``I0`` about a transverse axis, ``I`` about the axis of
symmetry k (10.17). Euler angles 3-1-3: ``theta`` is the angle from the axis of precession K
(upward, where there is gravity) to k; ``precession`` psi' the rate of the plane of K and k about K;
``spin`` phi' that of the body about k relative to that plane; ``omega_z`` = phi' + psi' cos(theta)
its whole rate about k (10.26). Moments are about the line of nodes i = K x k/sin(theta): gravity's
is mgr sin(theta) (10.30), ``mgr`` weight times distance of G from the fixed point, positive if G
lies on the side of k; any other is given as ``moment``. Angles in rad, rates in rad/s.
"""

import math
from dataclasses import dataclass
from typing import Literal

from ..algebra.errors import NewtonEulerError, checked
from ..algebra.scalars import (
    ZERO,
    Scalar,
    anywhere,
    atan,
    cos,
    epsilon,
    is_comparable,
    is_numeric,
    is_zero,
    scalar,
    short,
    sin,
    sqrt,
    tan,
    to_plain,
    vanishes,
    where,
)
from ..algebra.vectors import FrameError, Vector, named_sum
from ..bodies.admissibility import not_negative
from ..bodies.inertia import Inertia
from ..kinematics.frames import Frame, Point


class GyroError(NewtonEulerError, ValueError):
    """A motion that the gyroscope cannot have, or data that do not determine one."""


# -- the axis of zero velocity


@dataclass(frozen=True)
class InstantaneousAxis:
    """The line of the points of a body that are at rest, or move along it only: through ``point``
    along the unit vector ``direction`` (10.1); ``slide`` is the velocity along it, m/s.
    """

    point: Point
    direction: Vector
    slide: Scalar


@checked
def instantaneous_axis(body: Frame, observer: Frame) -> InstantaneousAxis:
    """The instantaneous axis of the body with the frame ``body``, seen from ``observer`` (10.1); of
    the screw if no point is at rest. Its ``point`` is that nearest to the body's origin. Raises
    :class:`GyroError` if the body does not turn.

    >>> from newton_euler import Frame, moving
    >>> ground = Frame("ground")
    >>> C = ground.point("C", moving(0.0, rate=2.0), 0.5, 0)
    >>> wheel = ground.rotate("wheel", "-z", rate=4.0, origin=C)  # rolls to the right
    >>> instantaneous_axis(wheel, ground).point.position(ground).components()
    (0.0, 0.0, 0)
    """
    w = body.angular_velocity(observer)
    rate = scalar(w.norm())
    if is_zero(rate):
        raise GyroError(
            f"{body.name} does not turn in {observer.name}: it has no instantaneous axis"
        )
    B = body.point("B", 0, 0, 0)
    v = B.velocity(observer).expressed_in(body)
    arm = w.cross(v) / (rate * rate)  # v + w x arm is the part of v along w
    direction = Vector(tuple(x / rate for x in w.c), body)
    return InstantaneousAxis(body.point("on the axis", *arm.c), direction, direction.dot(v))


# -- moment from motion


@checked
def gyro_momentum(body: Frame, ground: Frame, I0: Scalar, I: Scalar) -> Vector:
    """The angular momentum H about the fixed point or G (10.21), with its rate, in the frame {i, j,
    k}, the ``parent`` of ``body``, which :func:`newton_euler.euler_frame` makes.

    >>> from newton_euler import Frame, euler_frame, moving
    >>> ground = Frame("ground")
    >>> top = euler_frame(ground, "top", 0.0, 0.0, moving(0.0, rate=100.0))
    >>> gyro_momentum(top, ground, 0.02, 0.01).z
    1.0
    """
    inertia = _inertia(body, I0, I)
    f = inertia.frame
    # (10.18), without the rotation by the angle of spin, which would cost digits
    omega = f.angular_velocity(ground) + body.angular_velocity(f).expressed_in(f)
    return inertia.times(omega)


@checked
def gyro_moment(body: Frame, ground: Frame, I0: Scalar, I: Scalar) -> Vector:
    """The moment for a motion, about the fixed point or G, in {i, j, k} (10.20)-(10.25), (10.27);
    ``body`` as for :func:`gyro_momentum`, by angles that have both rates.

    terms : ``acceleration``, the rate of H seen in {i, j, k}; ``precession`` Omega x [I] Omega;
        ``gyroscopic`` Omega x I phi' k

    >>> from newton_euler import Frame, euler_frame, moving, pi
    >>> ground = Frame("ground")
    >>> level = euler_frame(ground, "rotor", moving(0.0, rate=2.0), pi()/2, moving(0.0, rate=100.0))
    >>> round(gyro_moment(level, ground, 0.02, 0.01).x, 12)  # I psi' phi' (10.37)
    2.0
    """
    inertia = _inertia(body, I0, I)
    f = inertia.frame
    Omega, spin = f.angular_velocity(ground), body.angular_velocity(f).expressed_in(f)
    terms = {
        "acceleration": gyro_momentum(body, ground, I0, I).rate(f),
        "precession": Omega.cross(inertia.times(Omega)),
        "gyroscopic": Omega.cross(inertia.times(spin)),
    }
    return named_sum("gyroscopic moment", f"on {body.name}", terms, f)


def _inertia(body, I0, I):
    if body.parent is None or body.axis != 2:
        raise FrameError(f"make {body.name} by euler_frame(ground, {body.name!r}, psi, theta, phi)")
    _check_moments(I0, I)
    return Inertia(body.parent.origin, (I0, I0, I), frame=body.parent, tolerance=None)


def _check_moments(I0, I):
    """Raises :class:`GyroError` unless I0 > 0 and 0 <= I <= 2 I0; expressions pass."""
    I0, I = scalar(I0), scalar(I)
    if not is_numeric(I0):
        return
    if anywhere(to_plain(I0) <= 0):
        raise GyroError(f"the transverse moment I0 must be positive, got {I0!r}")
    # a disk has I = 2 I0, up to round-off
    excess = to_plain(I - 2 * I0 - 1e-9 * I0)
    if is_numeric(I) and (anywhere(to_plain(I) < 0) or anywhere(excess > 0)):
        raise GyroError(f"no body has I = {I!r} and I0 = {I0!r}: 0 < I < 2 I0; exchanged?")


def check_top(I0: Scalar, I: Scalar, spin: Scalar | None, omega_z: Scalar | None) -> None:
    """Raises :class:`GyroError` unless I0 and I are possible and one rate is given."""
    _check_moments(I0, I)
    if (spin is None) == (omega_z is None):
        raise GyroError("give either spin = phi' or omega_z = phi' + psi' cos(theta)")


@checked
def normal_moment(precession: Vector, spin: Vector, I: Scalar) -> Vector:
    """The moment I psi' x phi' on a spin axis that precesses at right angles (10.38).

    precession, spin : Vectors, rad/s, at right angles (:class:`GyroError` otherwise)

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> normal_moment(ground.vector(0, 2.0, 0), ground.vector(0, 0, 100.0), 0.01)
    Vector(2.0, 0, 0 in ground)
    """
    along, product = scalar(precession.dot(spin)), scalar(precession.norm()) * spin.norm()
    numbers = is_numeric(along) and is_numeric(product)
    if numbers and anywhere(abs(to_plain(along)) > 1e-9 * to_plain(product)):
        raise GyroError(
            f"precession {precession} and spin {spin} are not at right angles; use gyro_moment"
        )
    not_negative(I, "the moment of inertia")
    return precession.cross(spin) * I


# -- steady precession


@checked
def steady_moment(I0: Scalar, I: Scalar, theta: Scalar, precession: Scalar, spin: Scalar) -> Scalar:
    """The moment about the line of nodes in a steady precession (10.29), (10.32), (10.37).

    >>> steady_moment(0.02, 0.01, 0.5, 0.0, 100.0)
    0.0
    """
    _check_moments(I0, I)
    return to_plain(precession * sin(theta) * (I * spin - (I0 - I) * precession * cos(theta)))


@checked
def steady_spin(
    I0: Scalar,
    I: Scalar,
    theta: Scalar,
    precession: Scalar,
    mgr: Scalar = None,
    moment: Scalar = None,
) -> Scalar:
    """The spin phi' of a steady precession with this rate, (10.31), (10.32) solved for it; for
    ``mgr`` or ``moment``, mgr=0 torque-free (10.35). Raises :class:`GyroError` without either.

    >>> steady_spin(0.02, 0.01, 0.0, 2.0, mgr=2.0)
    102.0
    """
    _check_moments(I0, I)
    c = _over_sine(theta, mgr, moment)
    for name, x in (("precession", precession), ("I", I)):
        if vanishes(x):
            raise GyroError(f"the {name} is zero, and then the moment does not depend on the spin")
    return to_plain((c / precession + (I0 - I) * precession * cos(theta)) / I)


@dataclass(frozen=True)
class SteadyPrecession:
    """The two steady precessions at an angle, by :func:`steady_precession`.

    slow, fast : the rates psi', rad/s; ``fast`` is infinite where there is no second one
    discriminant : (I phi')^2 - 4 mgr (I0 - I) cos(theta), or (I omega_z)^2 - 4 mgr I0 cos(theta)
    stiffness : for each of the two, see :func:`nutation_stiffness`
    """

    slow: Scalar
    fast: Scalar
    discriminant: Scalar
    stiffness: tuple


@checked
def steady_precession(
    I0: Scalar,
    I: Scalar,
    theta: Scalar,
    spin: Scalar = None,
    omega_z: Scalar = None,
    mgr: Scalar = None,
    moment: Scalar = None,
) -> SteadyPrecession:
    """Both rates of steady precession at the angle theta (10.31)-(10.33), for ``spin`` or
    ``omega_z``, and ``mgr`` or ``moment``.

    With a = (I0 - I) cos(theta), h = I phi' (or a = I0 cos(theta), h = I omega_z) and c = mgr or
    moment/sin(theta) they solve a psi'^2 - h psi' + c = 0: c/q and q/a with q = (h + sgn(h)
    sqrt(h^2 - 4 a c))/2, right to round-off also as a -> 0, where the printed root (10.33) is 0/0.
    An expression for h is taken as not zero. Raises :class:`GyroError` where no rate is real
    (arrays: at any instant), with the least spin needed.

    >>> import math
    >>> level = steady_precession(0.02, 0.01, math.pi/2, spin=100.0, mgr=0.5)
    >>> level.slow == 0.5/(0.01*100.0)
    True
    """
    a, h, c = _quadratic(I0, I, theta, spin, omega_z, _over_sine(theta, mgr, moment))
    D = _discriminant(a, h, c, I, "spin" if omega_z is None else "omega_z")
    # the root without cancellation, as in Numerical Recipes (Press et al.), section 5.6
    # takes the sign of h, +1 for zero; an expression is taken as different from zero
    sense = where(to_plain(h) < 0, -1, 1) if is_numeric(h) else h / sqrt(h * h)
    q = (h + sense * sqrt(D)) / 2
    if is_numeric(q) and is_numeric(c) and anywhere(where(to_plain(q) == 0, abs(c), 0) > 0):
        raise GyroError("no steady precession is possible: without spin a body can hold no moment")
    slow, fast = _quotient(c, q, 0), _quotient(q, a, math.inf)
    stiffness = tuple(_stiffness(I0, I, theta, psi, spin, omega_z) for psi in (slow, fast))
    return SteadyPrecession(to_plain(slow), to_plain(fast), to_plain(D), stiffness)


def _stiffness(I0, I, theta, psi, spin, omega_z):
    """The nutation stiffness about the rate psi', infinite where this is."""
    psi = to_plain(psi)
    none = is_numeric(psi) and psi == math.inf
    psi = where(none, 0, psi)
    whole = spin + psi * cos(theta) if omega_z is None else omega_z
    return where(none, math.inf, nutation_stiffness(I0, I, theta, psi, whole))


def _over_sine(theta, mgr, moment):
    """c: the moment divided by sin(theta), which is finite for gravity at theta = 0."""
    if (mgr is None) == (moment is None):
        raise GyroError("give one of mgr and moment, the moment about the line of nodes")
    if moment is None:
        return scalar(mgr)
    s = sin(theta)
    # sin(pi) in floats is 1.2e-16, half an epsilon
    if vanishes(s, 4 * epsilon(s)):
        raise GyroError(f"no line of nodes at theta = {theta!r} to have a moment about: give mgr")
    return scalar(moment) / s


def _quadratic(I0, I, theta, spin, omega_z, c):
    check_top(I0, I, spin, omega_z)
    I0, I = scalar(I0), scalar(I)
    if omega_z is None:
        return (I0 - I) * cos(theta), I * spin, c
    return I0 * cos(theta), I * omega_z, c


def _discriminant(a, h, c, I, what):
    """h^2 - 4 a c, zero within its rounding; raises :class:`GyroError` where it is negative."""
    first, second = h * h, 4 * (a * c)
    D = first - second
    if not is_numeric(D):
        return D
    # round-off of the two products: at the least spin the difference is nothing else
    slack = 8 * epsilon(D) * (abs(first) + abs(second))
    D = where(to_plain(D) < 0, where(to_plain(D + slack) >= 0, 0 * D, D), D)
    if anywhere(to_plain(D) < 0):
        needed = "without I no spin helps"
        if not is_zero(I):
            needed = f"{what} must be at least {short(_least_rate(a, c, I))} rad/s in size"
        raise GyroError(
            f"no steady precession is possible at this angle: the discriminant is {short(D)}, "
            f"negative; {needed}"
        )
    return D


def _quotient(n, d, otherwise):
    """n/d, or ``otherwise`` where d is zero."""
    if not is_numeric(d):
        return n / d
    none = to_plain(d) == 0
    return where(none, otherwise, n / where(none, 1, to_plain(d)))


@checked
def least_spin(
    I0: Scalar,
    I: Scalar,
    theta: Scalar,
    mgr: Scalar = None,
    moment: Scalar = None,
    of: Literal["spin", "omega_z"] = "spin",
) -> Scalar:
    """The least spin phi' (of="spin") or whole rate (of="omega_z"), in size, for steady precession
    at theta: 2 sqrt((I0 - I) cos(theta) mgr)/I, or with I0 for I0 - I, where the discriminant of
    (10.33) is 0; zero where every spin is enough. An expression is taken to be real.

    >>> round(least_spin(0.02, 0.01, 0.0, mgr=0.5), 4), least_spin(0.02, 0.01, 2.0, mgr=0.5)
    (14.1421, 0.0)
    """
    rates = {"spin": None, "omega_z": None, of: 1}
    a, _, c = _quadratic(I0, I, theta, **rates, c=_over_sine(theta, mgr, moment))
    return to_plain(_least_rate(a, c, I))


def _least_rate(a, c, I):
    product = a * c
    if is_comparable(product):
        product = where(to_plain(product) <= 0, abs(0 * product), product)
    return 2 * sqrt(product) / I


@checked
def nutation_stiffness(
    I0: Scalar, I: Scalar, theta: Scalar, precession: Scalar, omega_z: Scalar
) -> Scalar:
    """The square of the angular frequency (rad/s)^2 of small nutations about a steady precession
    under gravity; stable where it is positive: psi'^2 sin^2(theta) + (I omega_z/I0 - 2 psi'
    cos(theta))^2, the curvature of the effective potential over I0. Not for other moments than
    gravity's, or a precession that is enforced.

    >>> nutation_stiffness(0.02, 0.01, 0.0, 0.0, 100.0)
    2500.0
    """
    _check_moments(I0, I)
    across, rest = precession * sin(theta), I * omega_z / I0 - 2 * (precession * cos(theta))
    return to_plain(across * across + rest * rest)


@dataclass(frozen=True)
class FastSpin:
    """The leading terms (10.34) for a fast spin, and their relative errors, signed."""

    slow: Scalar
    fast: Scalar
    slow_error: Scalar
    fast_error: Scalar


@checked
def fast_spin(
    I0: Scalar, I: Scalar, theta: Scalar, spin: Scalar, mgr: Scalar = None, moment: Scalar = None
) -> FastSpin:
    """The approximate precession rates for a fast spin: mgr/(I phi') and I phi'/((I0 - I)
    cos(theta)) (10.34).

    Relative errors -2 eps/(1 + s) and 4 eps/(1 + s)^2, eps = mgr (I0 - I) cos(theta)/(I phi')^2, s
    = sqrt(1 - 4 eps); :class:`GyroError` where no precession is real, or the spin is zero.

    >>> found = fast_spin(0.02, 0.01, 1.0, 100.0, mgr=0.5)
    >>> round(found.slow, 6), round(found.slow_error, 6)
    (0.5, -0.002709)
    """
    a, h, c = _quadratic(I0, I, theta, spin, None, _over_sine(theta, mgr, moment))
    if vanishes(h):
        raise GyroError(
            "approximations for a fast spin, but spin or I is zero: use steady_precession"
        )
    eps = c / h * (a / h)
    # the errors by 1 + s: 1 - s would cancel for a fast spin, where s is nearly 1
    once = 1 + sqrt(_discriminant(a, h, c, I, "spin")) / sqrt(h * h)
    found = c / h, _quotient(h, a, math.inf), -2 * eps / once, 4 * eps / (once * once)
    return FastSpin(*map(to_plain, found))


# -- without a moment


@dataclass(frozen=True)
class FreePrecession:
    """The steady precession of a symmetric body without moment about H = H K, at the ``rate`` psi'.

    sense : "direct" if that of the spin, else "retrograde"; None for expressions
    body_cone, space_cone : half-angles (rad) of the cones of the instantaneous axis about k and K
    """

    rate: Scalar
    sense: str | None
    body_cone: Scalar
    space_cone: Scalar


@checked
def free_precession(I0: Scalar, I: Scalar, theta: Scalar, spin: Scalar) -> FreePrecession:
    """The steady precession without moment (10.35), (10.36): psi' = I phi'/((I0 - I) cos(theta)).
    Raises :class:`GyroError` if I = I0 or theta = pi/2, where the body turns about K as a whole;
    near there psi' = I omega_z/(I0 cos(theta)).

    >>> football = free_precession(3.0, 1.0, 0.5, 10.0)
    >>> round(football.rate, 4), football.sense
    (5.6975, 'direct')
    """
    _check_moments(I0, I)
    apart, c = scalar(I0) - I, cos(theta)
    if is_numeric(apart) and is_zero(apart):
        raise GyroError("with I = I0 there is no precession: the body turns about a fixed axis")
    if vanishes(c, 4 * epsilon(c)) and not is_zero(spin):
        raise GyroError(f"theta = {theta!r} is pi/2: H has no axial component, spin must be zero")
    sense = where(to_plain(apart) > 0, "direct", "retrograde") if is_numeric(apart) else None
    tilt = atan(I * tan(theta) / I0)
    gap = theta - tilt
    size = abs(gap) if is_numeric(gap) else sqrt(gap * gap)
    return FreePrecession(to_plain(I * spin / (apart * c)), sense, to_plain(tilt), to_plain(size))


# -- the sleeping top


@dataclass(frozen=True)
class SleepingTop:
    """The stability of an upright top, by :func:`sleeping_top`.

    critical, margin : the least whole rate omega_z, rad/s, and (omega_z/critical)^2, infinite if it
        is stable without spin
    stable, growth : True or False, None for expressions; the rate at which a small tilt grows, 1/s
    """

    critical: Scalar
    margin: Scalar
    stable: bool | None
    growth: Scalar


@checked
def sleeping_top(I0: Scalar, I: Scalar, mgr: Scalar, omega_z: Scalar) -> SleepingTop:
    """The stability of a top that spins upright (theta = 0): stable if (I omega_z)^2 >= 4 I0 mgr,
    also at the threshold, where the effective potential is of fourth order. A small tilt z = x + i
    y obeys I0 z'' - i I omega_z z' - mgr z = 0. A body that hangs has mgr < 0 and is always stable.

    >>> top = sleeping_top(0.02, 0.01, 0.5, 30.0)
    >>> top.critical, top.margin, top.stable
    (20.0, 2.25, True)
    """
    critical = least_spin(I0, I, ZERO, mgr=mgr, of="omega_z")
    h, c = I * omega_z, I0 * mgr
    D = h * h - 4 * c
    if not is_numeric(D):
        return SleepingTop(critical, to_plain(h * h / (4 * c)), None, to_plain(sqrt(-D) / (2 * I0)))
    hangs = to_plain(c) <= 0
    margin = where(hangs, math.inf, h * h / where(hangs, 1, 4 * to_plain(c)))
    unstable = to_plain(D) < 0
    growth = sqrt(where(unstable, -D, 0 * D)) / (2 * I0)
    stable = where(to_plain(D) >= 0, True, False)
    return SleepingTop(critical, to_plain(margin), stable, to_plain(growth))
