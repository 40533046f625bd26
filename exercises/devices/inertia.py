"""Inertia matrices of bodies that are put together of parts, from which others may be cut out, or
integrated; and proofs that know neither a table of solids nor the parallel axis theorem: the
angular momenta of mass points in a body that turns.
"""

from itertools import pairwise

from exercises.catalogue.proofs.digits import weighted
from exercises.tools import Step, proofs
from newton_euler.bodies import Body, Inertia


def matrix(frame, moments, products=(0, 0, 0)):
    """The answer from (I_xx, I_yy, I_zz) and (I_xy, I_yz, I_zx), right or wrong ones."""
    return {"I_O": Inertia(frame, moments, products, tolerance=None).matrix}


def together(frame, parts, removed=()):
    """The :class:`Inertia` of all parts at the origin of ``frame``."""
    return sum(part.about(frame) for part in (*parts, *(-hole for hole in removed)))


def answer(I):
    """The answer from an :class:`Inertia`."""
    return {"I_O": I.matrix}


def untransferred(frame, part):
    """The part moved to O: for the mistake of no parallel axis term."""
    return Body(part.name, part.mass, frame.origin, part.inertia.moments, frame)


def wrong_sign(frame, I):
    """The mistake of the products with a plus sign in the matrix."""
    return matrix(frame, I.moments, [-x for x in I.products])


def no_products(frame, I):
    """The mistake of no products of inertia."""
    return matrix(frame, I.moments)


def steps_of(frame, parts, removed=(), *, mass, length, inertia, at_O=()):
    """The mass of each part, its inertia matrix about its own centre of mass, the place of that,
    and its inertia matrix at O; the units of mass, length and inertia, and the names of the parts
    whose centre of mass is O. Steps are named after the first words of the parts.
    """
    for part in (*parts, *removed):
        key, cut_out = part.name.split()[0], ", to be subtracted" if part in removed else ""
        yield Step(f"m_{key}", part.mass, mass, f"mass of the {part.name}{cut_out}", "7.10")
        own = part.about(part.centre, frame).matrix
        if part.name in at_O:
            yield Step(f"I_{key}", own, inertia,
                       f"inertia matrix of the {part.name} at O, its centre of mass",
                       "7.10")  # fmt: skip
            continue
        yield Step(f"I_G_{key}", own, inertia,
                   f"inertia matrix of the {part.name} about its own centre of mass",
                   "7.10")  # fmt: skip
        yield Step(f"d_{key}", part.centre.position(frame), length,
                   f"centre of mass of the {part.name}, from O", "7.8")  # fmt: skip
        yield Step(f"I_{key}", part.about(frame).matrix, inertia,
                   f"inertia matrix of the {part.name} at O", "7.8", "7.25")  # fmt: skip


def turned(place):
    """Proof: columns r x (e x r), the angular momenta of a unit mass turning about each axis."""
    axes = [1, 0, 0], [0, 1, 0], [0, 0, 1]
    return proofs.transposed([proofs.cross(place, proofs.cross(e, place)) for e in axes])


def of_points(mass, points, at=(0, 0, 0)):
    """Proof, the matrix at O of this mass, spread as ``points`` about the place ``at``."""
    return added((mass, proofs.mean(lambda place: turned(proofs.plus(place, at)), points)))


def added(*weighed):
    """Proof, the sum of pairs (factor, matrix), each times its factor."""
    factors, matrices = zip(*weighed, strict=True)
    return weighted(factors, matrices)


def raised(points, length):
    """Proof, mass points that are spread along z too, over this length about where they are."""
    along = proofs.box(0, 0, length, order=2)
    return [(u * v, proofs.plus(p, q)) for u, p in points for v, q in along]


def along_path(density, place, way, corners):
    """Proof, the matrices at O of the pieces of a wire of this mass per length; ``place(s)`` is the
    place after the way s on it, and ``corners`` are the ways to the ends of the pieces before the
    last.
    """
    ends = pairwise([0, *corners, way])
    return [added((density, proofs.integral(lambda s: turned(place(s)), *pair))) for pair in ends]
