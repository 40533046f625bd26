"""Inertia matrices by the angular momenta of mass points, without tables or parallel axes."""

from collections.abc import Sequence
from itertools import pairwise

from exercises.annotations import Matrix, Number, Path, Points
from exercises.catalogue.proofs.digits import weighted
from exercises.tools import proofs


def turned(place: Sequence[Number]) -> Matrix:
    """The columns r x (e x r), the angular momenta of a unit mass turning about each axis."""
    axes = [1, 0, 0], [0, 1, 0], [0, 0, 1]
    return proofs.transposed([proofs.cross(place, proofs.cross(e, place)) for e in axes])


def of_points(mass: Number, points: Points, at: Sequence[Number] = (0, 0, 0)) -> Matrix:
    """The matrix at O of a mass spread as ``points`` around the place ``at``."""
    return added((mass, proofs.mean(lambda place: turned(proofs.plus(place, at)), points)))


def added(*weighed: tuple[Number, Matrix]) -> Matrix:
    """The sum of pairs (factor, matrix), each times its factor."""
    factors, matrices = zip(*weighed, strict=True)
    return weighted(factors, matrices)


def along_path(
    density: Number, place: Path, way: Number, corners: Sequence[Number]
) -> list[Matrix]:
    """The matrices at O of the pieces of a wire of this mass per length and of length ``way``;
    ``place(s)`` is the position at arc length s, ``corners`` are where pieces join.
    """
    ends = pairwise([0, *corners, way])
    return [added((density, proofs.integral(lambda s: turned(place(s)), *pair))) for pair in ends]
