"""Checks that a body can have given masses, moments (triangle inequality), products (Schwarz's)."""

from collections.abc import Iterable
from math import inf
from typing import Any

from ..algebra.errors import NewtonEulerError
from ..algebra.scalars import (
    Scalar,
    epsilon,
    is_finite,
    is_numeric,
    is_positive,
    max_abs,
    short,
    without_rates,
)
from ..kinematics.frames import Frame, Point

AXES = "xyz"
PRODUCTS = ("xy", "yz", "zx")


class MassError(NewtonEulerError, ValueError):
    """Data that no body has, or a mass or centre that is needed and was not given."""


def positive(x: Scalar, what: str) -> None:
    """Raises :class:`MassError` unless ``x`` is positive and finite; ``what`` is its name."""
    if type(x) is float and 0 < x < inf:
        return
    if not is_positive(x) or not is_finite(x):
        raise MassError(
            f"{what} must be positive, got {x}; to cut something out, use removed= of composite"
        )


def not_negative(x: Scalar, what: str) -> None:
    """Raises :class:`MassError` if the number ``x``, or an element, is negative or not finite."""
    if type(x) is float and 0 <= x < inf:
        return
    x = without_rates(x)
    if is_numeric(x) and not (is_finite(x) and max_abs(x - abs(x)) == 0):
        raise MassError(f"{what} is zero or positive, got {x}")


def triangle_inequality(moments: tuple, tolerance: float) -> None:
    """Raises :class:`MassError` if a moment exceeds the sum of the others, to this tolerance."""
    if not all(map(is_numeric, moments)):
        return
    if all(type(x) is float for x in moments):
        a, b, c = sorted(moments)
        if c <= a + b < inf:  # the usual case
            return
    noise = tolerance * max(map(max_abs, moments))
    for n in range(3):
        others = moments[n - 1] + moments[n - 2]
        if not max_abs(moments[n]) < inf or _below(others - moments[n], -noise):
            _refuse_moment(moments, n)


def _refuse_moment(moments, n):
    u, (v, w) = AXES[n], [axis for axis in AXES if axis != AXES[n]]
    others = moments[AXES.index(v)] + moments[AXES.index(w)]
    raise MassError(
        f"no body has these moments: I_{u}{u} = {short(moments[n])} is larger than "
        f"I_{v}{v} + I_{w}{w} = {short(others)}, by {short(moments[n] - others)} (triangle "
        "inequality); look for a misprint, or for moments about two points"
    )


def check(I: Any, tolerance: float, slack: float) -> None:
    """Raises :class:`MassError` if no body can have ``I``, see :meth:`.inertia.Inertia.check`."""
    if I.mass is not None and is_numeric(I.mass) and not is_positive(I.mass):
        raise MassError(f"the mass must be positive, got {I.mass}; cut out by removed=[hole]")
    if all(map(is_numeric, I.moments + I.products)):
        _check_integrals(I, tolerance, slack)
        if I.mass is not None and I.centre not in (None, I.point):
            _check_about_centre(I, tolerance, slack)


def _check_integrals(I, tolerance, slack):
    """The principal minors of J, I = tr(J) - J, are zero or positive, but for rounding."""
    largest = max(map(max_abs, I.moments + I.products))
    if not all(map(is_finite, I.moments + I.products)):
        raise MassError(f"the inertia matrix {I.matrix} has an entry that is not finite")
    if largest <= slack:  # nothing but round-off, of a particle about its centre
        return
    if not 1e-90 < largest < 1e90 and largest > 1e-300:  # the determinant would leave the floats
        I, slack, largest = I * (1 / largest), slack / largest, 1.0
    small, largest = tolerance * largest + slack, max(slack, largest)
    xx, yy, zz = I.moments
    a, b, c = squares = (yy + zz - xx) / 2, (zz + xx - yy) / 2, (xx + yy - zz) / 2
    for n, square in enumerate(squares):
        if _below(square, -small):
            _refuse_moment(I.moments, n)
    for (u, v), product in zip(PRODUCTS, I.products, strict=True):
        bound = squares[AXES.index(u)] * squares[AXES.index(v)]
        if _below(bound - product * product, -4 * small * largest):
            raise MassError(
                f"no body has the product I_{u}{v} = {product} with these moments: its "
                f"square is at most {bound}, the product of the integrals of {u}^2 and "
                f"{v}^2; check the sign convention and the units"
            )
    ab, bc, ca = I.products
    determinant = a * b * c + 2 * (ab * bc * ca) - a * bc * bc - b * ca * ca - c * ab * ab
    if _below(determinant, -8 * small * largest * largest):
        raise MassError(
            f"no body has the inertia matrix {I.matrix}: its principal moments break the triangle "
            "inequality (the largest exceeds the sum of the others); are the signs of the products "
            "those of plain integrals, the minus signs standing in the matrix only?"
        )


def _check_about_centre(I, tolerance, slack):
    slack += round_off(I.mass, (I.point, I.centre), I.frame)
    slack += tolerance * max(map(max_abs, I.moments))
    try:
        _check_integrals(I.about(I.centre), 4 * tolerance, slack)
    except MassError as problem:
        raise MassError(
            f"about {I.point.name} the moments are smaller than mass and distance of "
            f"{I.centre.name} alone make them: about {I.centre.name}, {problem}"
        ) from None


def _below(x, bound):
    return not is_positive(x - bound) and max_abs(x - bound) > 0


def round_off(mass: Scalar, points: Iterable[Point], frame: Frame) -> float:
    """The rounding of moments of this mass: 100 round-offs of m r^2; 0 for expressions."""
    if not is_numeric(mass):
        return 0.0
    squares = sum(max_abs(x) ** 2 for P in points for x in P.position(frame).c if is_numeric(x))
    return 100 * epsilon() * max_abs(mass) * squares
