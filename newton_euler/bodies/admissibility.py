"""Which masses and inertia matrices a body can have: positive masses, the triangle inequality,
Schwarz's inequality for the products.
"""

from ..algebra.errors import NewtonEulerError
from ..algebra.scalars import epsilon, is_finite, is_numeric, is_positive, plain, size

AXES = "xyz"
PRODUCTS = ("xy", "yz", "zx")


class MassError(NewtonEulerError, ValueError):
    """Masses, dimensions or moments of inertia that no body has, or a question that needs a mass or
    centre not given.
    """


def positive(x, what):
    """Raises :class:`MassError` unless the number ``x``, which ``what`` names, is positive and
    finite.
    """
    if not is_positive(x) or not is_finite(x):
        raise MassError(
            f"{what} must be positive, got {plain(x)}; to cut something out give it to "
            "composite(..., removed=[...])"
        )


def check(I, tolerance, slack):
    """Raises :class:`MassError` in words if no body can have the inertia ``I``, see
    :meth:`newton_euler.bodies.inertia.Inertia.check`.
    """
    if I.mass is not None and is_numeric(I.mass) and not is_positive(I.mass):
        raise MassError(
            f"the mass is {plain(I.mass)}; it must be positive (a removed part is subtracted: "
            "composite(..., removed=[hole]))"
        )
    if all(is_numeric(x) for x in I.moments + I.products):
        _check_integrals(I, tolerance, slack)
        if I.mass is not None and I.centre is not None and I.centre is not I.point:
            _check_centroidal(I, tolerance, slack)


def _check_integrals(I, tolerance, slack):
    """The integrals of x^2, y^2, z^2 and their bounds on the products; I = tr(J) - J, and J belongs
    to some masses if it is not negative.
    """
    small = tolerance * max(size(x) for x in I.moments + I.products) + slack
    largest = max(slack, *(size(x) for x in I.moments + I.products))
    xx, yy, zz = I.moments
    if not all(is_finite(x) for x in I.moments + I.products):
        raise MassError(f"the inertia matrix {I.matrix} has an entry that is not finite")
    squares = ((yy + zz - xx) / 2, (zz + xx - yy) / 2, (xx + yy - zz) / 2)
    for n, square in enumerate(squares):
        if _below(square, -small):
            a, b, c = (AXES[n], *(axis for axis in AXES if axis != AXES[n]))
            raise MassError(
                f"no body has these moments: I_{a}{a} = {plain(I.moments[n])} is larger "
                f"than I_{b}{b} + I_{c}{c} = "
                f"{plain(I.moments[AXES.index(b)] + I.moments[AXES.index(c)])} (triangle "
                "inequality); "
                "look for a misprint, or for moments about two points"
            )
    for name, product in zip(PRODUCTS, I.products, strict=True):
        a, b = (squares[AXES.index(c)] for c in name)
        if _below(a * b - product * product, -4 * small * largest):
            raise MassError(
                f"no body has the product I_{name} = {plain(product)} with these moments: "
                f"its square is at most {plain(a * b)}, the product of "
                f"the integrals of {name[0]}^2 and {name[1]}^2; is the sign convention or "
                "the unit another?"
            )
    (a, b, c), (ab, bc, ca) = squares, I.products
    determinant = a * b * c + 2 * (ab * bc * ca) - a * bc * bc - b * ca * ca - c * ab * ab
    if _below(determinant, -8 * small * largest * largest):
        raise MassError(
            f"no body has the inertia matrix {I.matrix}: its principal moments break the "
            "triangle inequality (the largest exceeds the sum of "
            "the others); are the signs of the products those of plain integrals, the "
            "minus signs standing in the matrix only?"
        )


def _check_centroidal(I, tolerance, slack):
    try:
        # what is subtracted
        slack += round_off(I.mass, (I.point, I.centre), I.frame) + tolerance * max(
            map(size, I.moments)
        )
        _check_integrals(I.about(I.centre), 4 * tolerance, slack)
    except MassError as problem:
        raise MassError(
            f"about {I.point.name} the moments are smaller than mass and distance of "
            f"{I.centre.name} alone make them: "
            f"about {I.centre.name}, {problem}"
        ) from None


def _below(x, bound):
    return not is_positive(x - bound) and size(x - bound) > 0


def round_off(mass, points, frame):
    """What rounding of the coordinates of points at most does to moments of this mass, roughly: 100
    round-offs of m r^2.
    """
    coordinates = [x for P in points for x in P.position(frame).c]
    return (
        100 * epsilon() * size(mass) * sum(size(x) ** 2 for x in coordinates if is_numeric(x))
        if is_numeric(mass)
        else 0.0
    )
