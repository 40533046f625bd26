"""A plate between the x axis and y = height(x), by vertical strips (5/1, 5/16, 7/1, 7/16)."""

from collections.abc import Callable
from typing import TypeAlias

from exercises.annotations import Answers, Givens, Scalar, Solve, Steps, StepsOf, Triple
from exercises.tools import Step
from newton_euler import Frame, integral

PLATE = Frame("plate")
Height: TypeAlias = Callable[[Scalar], Scalar]  # y at the place x


def over_strips(end: Scalar, height: Height, f: Callable[[Scalar, Scalar], Scalar]) -> Scalar:
    """The integral of f(x, y) dx from O to ``end``, y being the height at x."""
    return integral(lambda x: f(x, height(x)), 0, end)


def area(end: Scalar, height: Height) -> Scalar:
    return over_strips(end, height, lambda x, y: y)


def first_moments(end: Scalar, height: Height) -> tuple[Scalar, Scalar]:
    """The integrals of x and of y over the area."""
    return (
        over_strips(end, height, lambda x, y: x * y),
        over_strips(end, height, lambda x, y: y * y / 2),
    )


def centre_of(
    end: Callable[[Givens], Scalar], height: Callable[[Givens], Height]
) -> tuple[Callable[[Givens], Triple], Solve, StepsOf]:
    """The area with its first moments, ``solve`` and ``steps``, for functions of g."""
    moments = lambda g: (area(end(g), height(g)), *first_moments(end(g), height(g)))
    return moments, lambda g: centre(*moments(g)), lambda g: steps_to_centre(end(g), height(g))


def moments_of_inertia(
    mass: Scalar, area: Scalar, end: Scalar, height: Height
) -> tuple[Triple, Triple]:
    """(I_xx, I_yy, I_zz), (I_xy, I_yz, I_zx) at O, for this mass per area."""
    of_strips = (lambda x, y: x**2 * y), (lambda x, y: y**3 / 3), (lambda x, y: x * y**2 / 2)
    xx, yy, xy = (mass / area * over_strips(end, height, f) for f in of_strips)
    return (yy, xx, xx + yy), (xy, 0, 0)


def centre(area: Scalar, first_x: Scalar, first_y: Scalar) -> Answers:
    """The answer of chapter 5, from the area and its first moments."""
    return {"d": PLATE.vector(first_x / area, first_y / area, 0)}


def steps_to_centre(end: Scalar, height: Height) -> Steps:
    first_x, first_y = first_moments(end, height)
    yield Step("area", area(end, height), "m^2", "area of the plate, the integral of y dx", "5.4")
    yield Step("Q_x", first_x, "m^3", "integral of x y dx", "5.4", "5.13")
    yield Step("Q_y", first_y, "m^3", "integral of y/2 y dx, strips having their centre at y/2",
               "5.4", "5.13")  # fmt: skip


def steps_to_inertia(end: Scalar, height: Height, mass: Scalar) -> Steps:
    """The steps to the inertia matrix at O of a plate of this mass."""
    A = area(end, height)
    (I_xx, I_yy, I_zz), (I_xy, _, _) = moments_of_inertia(mass, A, end, height)
    yield Step("area", A, "m^2", "area of the plate, the integral of y dx", "7.3")
    yield Step("sigma", mass / A, "kg/m^2", "mass per unit area", "7.3")
    yield Step("I_xx", I_xx, "kg*m^2", "integral of y^2 dm, of each strip y^2/3 dm", "7.2", "7.10")
    yield Step("I_yy", I_yy, "kg*m^2", "integral of x^2 dm", "7.2", "7.10")
    yield Step("I_xy", I_xy, "kg*m^2", "integral of x y dm, of each strip x y/2 dm", "7.2", "7.10")
    means = "moment of inertia about z, the plate being flat"
    yield Step("I_zz", I_zz, "kg*m^2", means, "7.2", "7.10")
