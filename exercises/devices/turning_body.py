"""Bodies turning about a fixed axis, x, y or z, at the rate omega with alpha: angular momentum and
moment (8/11 and 8/13 to 8/19).

No ground frame is needed: (8.17) and (8.18) are in the axes of the body. The proofs move mass
points on their circles.
"""

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import TypeAlias

from exercises.annotations import Answers, Follows, Givens, Number, Scalar, Solve, Steps, StepsOf
from exercises.catalogue.proofs.digits import Orientation, Path, Points
from exercises.tools import Step, cross, mean, minus, plus, proofs, rate, rot, scaled, terms, times
from newton_euler import Body, Frame
from newton_euler.bodies import Inertia, composite
from newton_euler.dynamics import fixed_line_moment, fixed_line_momentum

UNITS = {
    "SI": {"inertia": "kg*m^2", "moment": "N*m"},
    "US": {"inertia": "slug*ft^2", "moment": "lb*ft"},
}
# an integral over the mass of a body or part, of a function of the place
Summed: TypeAlias = Callable[[Callable[[list[Number]], list[Number]]], list[Number]]
# the other two axes, in their order
ACROSS = {"x": ("y", "z"), "y": ("z", "x"), "z": ("x", "y")}


def about_origin(frame: Frame, parts: Iterable[Body]) -> Inertia:
    """The :class:`Inertia` of the whole about the origin of ``frame``; its terms are the parts."""
    return composite("body", parts).about(frame)


def problem_of(
    inertia: Callable[[Givens], Inertia], axis: str, system: str = "SI", particles: bool = False
) -> tuple[Solve, StepsOf, Follows]:
    """``solve``, ``steps`` and ``follows`` for ``inertia(g)``, an :class:`Inertia`."""
    return (
        lambda g: answers(g, inertia(g), axis),
        lambda g: steps_of(g, inertia(g), axis, system, particles),
        moment_from_momentum(axis),
    )


def answers(g: Givens, inertia: Inertia, axis: str) -> Answers:
    """H_O and M_O from an :class:`Inertia`, right or wrong."""
    return {
        "H_O": fixed_line_momentum(inertia, g.omega, axis),
        "M_O": fixed_line_moment(inertia, g.omega, g.alpha, axis),
    }


def moment_from_momentum(axis: str) -> Follows:
    """``follows``: H/omega has constant components in the body."""

    def M_O(g, H_O):
        e = {"x": H_O.frame.i, "y": H_O.frame.j, "z": H_O.frame.k}[axis]
        return H_O * (g.alpha / g.omega) + (e * g.omega).cross(H_O)

    return {"M_O": M_O}


# -- steps


def products(inertia: Inertia, axis: str) -> dict[str, Scalar]:
    """{name: product of inertia} for those with the coordinate along the axis."""
    xy, yz, zx = inertia.products
    named = {"I_xy": xy, "I_yz": yz, "I_zx": zx}
    return {name: value for name, value in named.items() if axis in name[2:]}


def inertia_steps(
    inertia: Inertia, axis: str, system: str = "SI", particles: bool = False
) -> Steps:
    """The moments of inertia about the axis, of parts and whole, and the products with it."""
    unit, n = UNITS[system]["inertia"], "xyz".index(axis)
    parts = inertia.terms if len(inertia.terms) > 1 and "own" not in inertia.terms else {}
    for name, part in parts.items():
        which = name if name.isupper() else f"the {name}"
        yield Step(f"I_{axis}{axis}_{name.split()[0]}", part.moments[n], unit,
                   f"moment of inertia of {which} about the {axis} axis",
                   *(("7.2", "7.9") if particles else ("7.8", "7.25")))  # fmt: skip
    yield Step(f"I_{axis}{axis}", inertia.moments[n], unit,
               f"moment of inertia of the whole about the {axis} axis", "7.2",
               "7.14" if parts else "7.10")  # fmt: skip
    for name, value in products(inertia, axis).items():
        u, v = name[2], name[3]
        means = f"sum of m*{u}*{v}" if particles else f"integral of {u} {v} over the mass"
        number = "7.9" if particles else "7.10"
        yield Step(name, value, unit, means, "7.2", number, of_givens=True)


def steps_of(
    g: Givens, inertia: Inertia, axis: str, system: str = "SI", particles: bool = False
) -> Steps:
    yield from inertia_steps(inertia, axis, system, particles)
    yield from terms(answers(g, inertia, axis)["M_O"], "M_O", UNITS[system]["moment"], "8.5")


# -- mistakes


def no_rotation(g: Givens, inertia: Inertia, axis: str) -> Answers:
    """The mistake of omitting omega x H."""
    return {"M_O": answers(g, inertia, axis)["M_O"].without("rotation")}


def other_products(
    inertia: Inertia, xy: Scalar | None = None, yz: Scalar | None = None, zx: Scalar | None = None
) -> Inertia:
    """The :class:`Inertia` with the given products replaced."""
    new = [b if a is None else a for a, b in zip((xy, yz, zx), inertia.products, strict=True)]
    return Inertia(inertia.point, inertia.moments, new, frame=inertia.frame, tolerance=None)


def without_products(inertia: Inertia) -> Inertia:
    return other_products(inertia, 0, 0, 0)


def wrong_sign(inertia: Inertia) -> Inertia:
    return other_products(inertia, *(-x for x in inertia.products))


def added_to_moment(inertia: Inertia, axis: str, extra: Scalar) -> Inertia:
    """The :class:`Inertia` with ``extra`` added to the moment about the axis."""
    moments = [x + extra if u == axis else x for u, x in zip("xyz", inertia.moments, strict=True)]
    return Inertia(inertia.point, moments, inertia.products, frame=inertia.frame, tolerance=None)


# -- proofs: a body is a function that integrates f(place) over its mass


def of_points(mass: Number, points: Points, at: Sequence[Number] = (0, 0, 0)) -> Summed:
    """The integral over a mass spread as ``points`` (see :func:`mean`) around the place ``at``."""
    return lambda f: scaled(mass, mean(lambda place: f(plus(place, at)), points))


def of_wire(
    density: Number, place: Path, way: Number, corners: Sequence[Number], names: Iterable[str]
) -> dict[str, Summed]:
    """{name: integral over a piece} of a wire of this mass per length; ``place(s)`` is the position
    at arc length s up to ``way``, ``corners`` are where pieces join.
    """

    def over_piece(start, end):
        return lambda f: scaled(density, proofs.integral(lambda s: f(place(s)), start, end))

    ends = pairwise([0, *corners, way])
    return {name: over_piece(*pair) for name, pair in zip(names, ends, strict=True)}


def prove_momentum(g: Givens, axis: str, **parts: Summed) -> Answers:
    """H_O from the momenta of mass points on their circles, and the steps, as sums."""
    n, across = "xyz".index(axis), ["xyz".index(u) for u in ACROSS[axis]]
    square = lambda place: [sum(place[k] ** 2 for k in across)]
    squares = {f"I_{axis}{axis}_{name}": over(square)[0] for name, over in parts.items()}
    found = {"H_O": _moment(parts, rot_about(axis, g.omega), rate)}
    found[f"I_{axis}{axis}"] = sum(squares.values())
    for k in across:
        pair = axis + "xyz"[k] if (n + 1) % 3 == k else "xyz"[k] + axis
        found[f"I_{pair}"] = _summed(parts, lambda place, k=k: [place[n] * place[k]])[0]
    return found | (squares if len(parts) > 1 else {})


def prove(g: Givens, axis: str, **parts: Summed) -> Answers:
    """The same with the moments of the forces; a start from rest gives the relative term."""
    M_O = _moment(parts, rot_about(axis, g.omega, g.alpha), proofs.second_rate)
    from_rest = _moment(parts, rot_about(axis, 0, g.alpha), proofs.second_rate)
    found = prove_momentum(g, axis, **parts)
    return {
        "H_O": found.pop("H_O"),
        "M_O": M_O,
        **found,
        "M_O_relative": from_rest,
        "M_O_rotation": minus(M_O, from_rest),
    }


def rot_about(axis: str, omega: Number, alpha: Number = 0) -> Orientation:
    """The orientation as a function of time."""
    return lambda t: rot(axis, omega * t + alpha * t * t / 2)


def _moment(parts, orientation, difference):
    """The moment about O of the momenta, or of the forces, of all mass points."""
    change = difference(orientation)
    return _summed(parts, lambda place: cross(place, times(change, place)))


def _summed(parts, f):
    return plus(*(over(f) for over in parts.values()))
