"""A body about z that spins freely and wobbles, 10/10 to 10/12; proofs by mass points."""

from exercises.devices.steady_precession import needed
from exercises.tools import mp, mpf, vanishing

WOBBLE = 0.1  # rad, the angle of the axis with the angular momentum; any will do


def difference(body, O):
    """Transverse less axial moment of inertia at O: where it vanishes there is no precession."""
    I = body.about(O)
    return I.moment("x") - I.moment("z")


def needed_spin(points):
    """Proof, the spin with which precession at the rate 1 needs no moment; positive if direct."""
    return vanishing(lambda spin: needed(1, points, mpf(WOBBLE), 1, spin), 0, 1)


def neutral_length(points, unit):
    """Proof, the length of the body with which the mass points ``points(length)`` turn about a
    slanting axis without a moment: they do not precess.

    unit : any length; the moment is a sum of squares of the heights and of radii, and so the
        moments at this length and at its double tell it for all
    """
    moment = lambda share: needed(1, points(unit * mp.sqrt(share)), mpf(WOBBLE), 1, 0)
    return unit * mp.sqrt(vanishing(moment, 1, 4))
