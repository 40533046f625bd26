"""A point in polar coordinates, the magnitude of whose acceleration is asked for: 2/17, 2/22."""

from collections.abc import Callable

from exercises.annotations import Givens, Mistakes, Solve, Steps, StepsOf
from exercises.tools import Step, terms
from newton_euler import Frame, Point, Vector
from newton_euler.algebra import Moving


def problem_of(
    point: Callable[[Givens], tuple[Frame, Moving, Point]],
) -> tuple[Solve, StepsOf, Callable[[Givens], Mistakes]]:
    """``solve``, ``steps`` and ``mistakes``; ``point(g)``: ground, distance and point."""

    def acceleration(g):
        ground, _, P = point(g)
        return P.acceleration(ground)

    return (
        lambda g: {"a": acceleration(g).norm()},
        lambda g: steps(point(g)[1], acceleration(g)),
        lambda g: mistakes(acceleration(g)),
    )


def steps(r: Moving, a: Vector) -> Steps:
    """The rates of the distance r, then the acceleration and its terms."""
    yield Step("r_dot", r.rate, "m/s", "rate of the distance", "2.6")
    yield Step("r_ddot", r.acceleration, "m/s^2", "its second rate", "2.6")
    yield Step("a_P", a, "m/s^2", "acceleration along $e_r$, $e_\\theta$", "2.6", "2.18")
    yield from terms(a, "a_P", "m/s^2", "2.6")


def mistakes(a: Vector) -> Mistakes:
    return {
        "no_coriolis": {"a": a.without("coriolis").norm()},
        "no_r_ddot": {"a": a.without("radial").norm()},
        "centripetal_alone": {"a": a.terms["centripetal"].norm()},
    }
