"""A body of revolution about z, wobbling freely (10/10 to 10/12); proofs by mass points."""

from collections.abc import Callable

from exercises.annotations import Number, Points, Scalar
from exercises.devices.steady_precession import needed
from exercises.tools import mp, mpf, vanishing
from newton_euler import Body, Point

WOBBLE = 0.1  # rad, from the angular momentum to the axis; any angle will do


def difference(body: Body, O: Point) -> Scalar:
    """Transverse minus axial moment of inertia at O; zero without precession."""
    I = body.about(O)
    return I.moment("x") - I.moment("z")


def needed_spin(points: Points) -> Number:
    """Proof: the spin for which precession at the rate 1 needs no moment; positive if direct."""
    return vanishing(lambda spin: needed(1, points, mpf(WOBBLE), 1, spin), 0, 1)


def neutral_length(points: Callable[[Number], Points], unit: Number) -> Number:
    """Proof: the length at which the mass points ``points(length)`` turn about a slanting axis
    without a moment, hence do not precess.

    unit : any length; the moment is linear in the square of the length, hence known from two
    lengths
    """
    moment = lambda share: needed(1, points(unit * mp.sqrt(share)), mpf(WOBBLE), 1, 0)
    return unit * mp.sqrt(vanishing(moment, 1, 4))
