"""Euler's equations, rotation about a fixed line and planar motion (8.2, 8.3, 8.5): moments from
angular velocity and acceleration, and the reverse, by an inertia matrix.

The matrix, as by ``body.about(P)``, is about the centre of mass, or a point at rest or at constant
velocity (8.11); for any other see :func:`newton_euler.dynamics.momentum.resultant_moment`. Rates
are those seen from an inertial frame. Units: in SI kg m^2, rad/s, rad/s^2, N m.
"""

from ..algebra.errors import checked
from ..algebra.linear import LinearError, solve_regular
from ..algebra.scalars import ZERO, Scalar, is_numeric, is_zero, max_abs, scalar, to_plain
from ..algebra.vectors import ZERO3, Vector, cross3, named_sum, scale3, sub3
from ..bodies.admissibility import AXES, PRODUCTS, MassError
from ..bodies.inertia import Inertia, axis_index


@checked
def euler_moment(
    inertia: Inertia, omega: Vector, alpha: Vector, turning: Vector | None = None
) -> Vector:
    """The moment M = dH/dt + Omega x H of a rotation, H = I omega (8.12), in any axes.

    turning : Omega, the angular velocity of the frame of ``inertia`` where that is not fixed in the
        body, as one that precesses without spinning; default: omega
    terms : ``relative``, I times the rate of omega seen in that frame; ``rotation``, Omega x H

    >>> from newton_euler import Frame, Inertia
    >>> frame = Frame("frame")
    >>> wheel = Inertia(frame, (2.0, 2.0, 3.0))
    >>> omega = frame.vector(0, 0, 10.0)  # stays along z of a frame that turns about x
    >>> Omega = frame.vector(0.5, 0, 0)
    >>> euler_moment(wheel, omega, Omega.cross(omega), turning=Omega)
    Vector(0, -15.0, 0 in frame)
    """
    frame = inertia.frame
    w, rate = omega.expressed_in(frame).c, alpha.expressed_in(frame).c
    Omega = w
    if turning is not None:
        Omega = turning.expressed_in(frame).c
        # the rate of omega seen in the frame; in the frame of the body it is alpha itself
        rate = sub3(rate, cross3(Omega, w))
    rotation = cross3(Omega, inertia.times3(w))
    return _summed(inertia, "Euler's moment", relative=inertia.times3(rate), rotation=rotation)


@checked
def euler_moments(inertia: Inertia, omega: Vector, alpha: Vector) -> Vector:
    """The moment by Euler's equations (8.13), (8.14): M_x = I_xx alpha_x - (I_yy - I_zz) omega_y
    omega_z and cyclic; :class:`MassError` if the axes are not principal.

    >>> from newton_euler import Frame, Inertia
    >>> body = Frame("body")
    >>> inertia = Inertia(body, (1.0, 2.0, 2.5))
    >>> euler_moments(inertia, body.vector(1.0, 2.0, 3.0), body.vector(0, 0, 4.0))
    Vector(3.0, -4.5, 12.0 in body)
    """
    law = "Euler's equations (8.13) hold along principal axes"
    _check_principal(inertia, AXES, law, "take euler_moment")
    # a structural zero stays one, so that vanishing terms cost nothing in generated code
    I = inertia.moments
    w, a = omega.expressed_in(inertia.frame).c, alpha.expressed_in(inertia.frame).c
    relative = ZERO3 if a is ZERO3 else tuple(x * y for x, y in zip(I, a, strict=True))
    after = (1, 2), (2, 0), (0, 1)
    rotation = w if w is ZERO3 else tuple(-((I[m] - I[k]) * (w[m] * w[k])) for m, k in after)
    name = "Euler's moment, principal axes"
    return _summed(inertia, name, relative=relative, rotation=rotation)


@checked
def angular_acceleration(
    inertia: Inertia, omega: Vector, moment: Vector, turning: Vector | None = None
) -> Vector:
    """The angular acceleration by a moment: alpha = I^-1 (M - Omega x H) + Omega x omega, (8.12)
    solved; rad/s^2, in the frame of ``inertia``.

    moment : of the external forces about the point of ``inertia``, a Vector; about a point B that
        accelerates subtract d x m a_B first (8.9)
    turning : Omega as in :func:`euler_moment`; default: omega, where the last term is zero
    terms : ``moment``, ``gyroscopic``, and with ``turning`` also ``turning``
    Raises :class:`MassError` if the body has no moment of inertia about some axis, as a thin rod.

    >>> from newton_euler import Frame, Inertia
    >>> body = Frame("body")
    >>> inertia = Inertia(body, (1.0, 2.0, 2.5))
    >>> angular_acceleration(inertia, body.vector(1.0, 2.0, 3.0), body.vector(3.0, -4.5, 12.0))
    Vector(0.0, 0.0, 4.0 in body)
    """
    frame = inertia.frame
    w = omega.expressed_in(frame).c
    Omega = w if turning is None else turning.expressed_in(frame).c
    terms = {
        "moment": _divided(inertia, moment.expressed_in(frame).c),
        "gyroscopic": scale3(-1, _divided(inertia, cross3(Omega, inertia.times3(w)))),
    }
    if turning is not None:
        terms["turning"] = cross3(Omega, w)
    return _summed(inertia, "Euler's angular acceleration", **terms)


@checked
def fixed_line_momentum(inertia: Inertia, rate: Scalar, axis: str = "z") -> Vector:
    """The angular momentum of a body that turns at ``rate`` about a line fixed in it and in the
    ground, through the point of ``inertia`` along ``axis`` ("x", "-z" ...) of its frame (8.17),
    (8.16): for z H = (-I_xz, -I_yz, I_zz) omega.

    >>> from newton_euler import Frame, Inertia
    >>> fixed_line_momentum(Inertia(Frame("body"), (3.0, 3.0, 4.0), (0, 0.5, 1.0)), 10.0)
    Vector(-10.0, -5.0, 40.0 in body)
    """
    return Vector(scale3(scalar(rate), inertia.times3(_unit(axis))), inertia.frame)


@checked
def fixed_line_moment(
    inertia: Inertia, rate: Scalar, acceleration: Scalar, axis: str = "z"
) -> Vector:
    """The moment about the point of ``inertia`` of a rotation about a line fixed in body and
    ground, or of planar motion (8.18). For z: M_x = -I_xz alpha + I_yz omega^2, M_y = -I_yz alpha -
    I_xz omega^2, M_z = I_zz alpha.

    rate, acceleration : omega (rad/s) and alpha (rad/s^2) about ``axis`` of the frame of the matrix
    terms : ``relative`` with alpha, ``rotation`` with omega^2

    >>> from newton_euler import Frame, Inertia
    >>> fixed_line_moment(Inertia(Frame("body"), (3.0, 3.0, 4.0), (0, 0.5, 1.0)), 2.0, 3.0)
    Vector(-1.0, -5.5, 12.0 in body)
    """
    e, rate = _unit(axis), scalar(rate)
    column, name = inertia.times3(e), "moment of a body on a fixed line"
    relative = scale3(scalar(acceleration), column)
    rotation = scale3(rate * rate, cross3(e, column))
    return _summed(inertia, name, relative=relative, rotation=rotation)


@checked
def planar_moment(inertia: Inertia, acceleration: Scalar, axis: str = "z") -> Scalar:
    """The moment M_z = I_zz alpha, to which (8.18) reduces for a body with rotational symmetry
    about the axis, or a thin one in the plane (8.19); :class:`MassError` if a product of inertia
    with the axis is left.

    >>> from newton_euler import Frame, Inertia
    >>> planar_moment(Inertia(Frame("body"), (2.0, 3.0, 5.0), (1.0, 0, 0)), 2.0)
    10.0
    """
    n, _ = axis_index(axis)
    law = f"M = I alpha alone (8.19) needs a principal axis along {AXES[n]}"
    _check_principal(inertia, AXES[n], law, "take fixed_line_moment")
    return to_plain(inertia.moments[n] * scalar(acceleration))


def _check_principal(inertia, axes, law, instead):
    """Raises :class:`MassError` for products of inertia with one of the axes."""
    # 1e-12 of the moments: the round-off of a rotation to principal axes
    small = 1e-12 * max((max_abs(x) for x in inertia.moments if is_numeric(x)), default=0.0)
    named = (pair for pair in zip(PRODUCTS, inertia.products, strict=True) if {*pair[0]} & {*axes})
    there = lambda x: not (is_zero(x) or (is_numeric(x) and max_abs(x) <= small))  # noqa: E731
    if left := [f"I_{name} = {x}" for name, x in named if there(x)]:
        raise MassError(
            f"{law}, but the matrix about {inertia.point.name} has {', '.join(left)}; {instead}"
        )


def _divided(inertia, c):
    """I^-1 c; without products each component is one division, as structural zeros drop out."""
    if c is ZERO3:
        return c
    rows = [
        ({k: x for k, x in enumerate(map(scalar, row)) if x is not ZERO}, b)
        for row, b in zip(inertia.matrix, c, strict=True)
    ]
    try:
        found = solve_regular(rows)
    except (LinearError, ZeroDivisionError):
        raise MassError(
            f"the matrix {inertia.matrix} about {inertia.point.name} has no inverse: about some "
            "axis the body has no moment of inertia, as a thin rod about its own; use "
            "equations_of_motion and solve_linear"
        ) from None
    return tuple(found[k] for k in range(3))


def _unit(axis):
    n, sign = axis_index(axis)
    return tuple(sign if n == m else ZERO for m in range(3))


def _summed(inertia, kind, **triples):
    frame = inertia.frame
    terms = {name: Vector(c, frame) for name, c in triples.items()}
    return named_sum(kind, f"about {inertia.point.name}", terms, frame)
