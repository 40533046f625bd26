"""A body of revolution about z that spins freely with a slight wobble, 10/10 to 10/12; proofs find
the moment that its mass points need in an explicit steady precession.
"""

from mpmath import mpf

from exercises.proofs import moment_needed, rot, times, vanishing
from newton_euler.applications import free_precession

WOBBLE = 0.1  # rad, the angle of the axis with the angular momentum; any will do


def difference(body, O):
    """The transverse moment of inertia at O less that about the axis: there is no precession where
    it vanishes.
    """
    I = body.about(O)
    return I.moment("x") - I.moment("z")


def sense(body, O):
    """ "direct" or "retrograde"; for numbers."""
    I = body.about(O)
    return free_precession(I.moment("x"), I.moment("z"), WOBBLE, spin=1.0).sense


def moment(points, spin=0):
    """Proof, the moment about the line of nodes that mass points of the mass 1 need to precess at
    the rate 1 with this spin.
    """
    theta = mpf(WOBBLE)

    def motion(t):
        orientation = times(rot("z", t), rot("x", theta), rot("z", spin * t))
        return [(share, times(orientation, place)) for share, place in points]

    return moment_needed(1, motion)[0]


def needed_spin(points):
    """Proof, the spin with which the precession at the rate 1 needs no moment: positive if it is
    direct, and zero if the body can turn about the slanting axis without precession.
    """
    return vanishing(lambda spin: moment(points, spin), 0, 1)
