"""The bevel pinion of 4/5 and 4/10, carried round by a cage between two equal bevel gears that face
each other on one axis.

The axes of the gears and of the pinion are successive ones of x, y, z. The first gear is on the
positive side.
"""

from collections.abc import Iterable

from mpmath import matrix

from exercises.annotations import Givens, Number, Orientation, Scalar
from exercises.tools import Sketch, mp, rot, times
from newton_euler import Frame, solve_rates

AXES = "xyz"


def next_axis(axis: str) -> str:
    """The next axis in cyclic order."""
    return AXES[(AXES.index(axis) + 1) % 3]


def coordinates(axis: str, along: Scalar, across: Scalar) -> list[Scalar]:
    """The point at ``along`` on the axis of the gears and ``across`` on that of the pinion."""
    x = [0, 0, 0]
    x[AXES.index(axis)], x[AXES.index(next_axis(axis))] = along, across
    return x


def train(
    axis: str, cage_rate: Scalar, spin: Scalar, names: tuple[str, str] = ("cage", "pinion")
) -> tuple[Frame, Frame, Frame]:
    """Ground, cage and pinion; the pinion turns in the cage about the next axis."""
    ground = Frame("ground")
    cage = ground.rotate(names[0], axis, rate=cage_rate)
    return ground, cage, cage.rotate(names[1], next_axis(axis), rate=spin)


def slip(
    g: Givens, axis: str, cage_rate: Scalar, spin: Scalar, gear_rate: Scalar, side: int
) -> Scalar:
    """Velocity of the pinion's tooth relative to the gear on this side, normal to both axes."""
    ground, _, pinion = train(axis, cage_rate, spin)
    gear = ground.rotate("gear", axis, rate=gear_rate)
    here = coordinates(axis, side * g.r, g.R)
    v, w = (body.point("tooth", *here).velocity(ground) for body in (pinion, gear))
    return getattr(v - w, next_axis(next_axis(axis)))


def meshing_rates(g: Givens, axis: str, first: Scalar, second: Scalar) -> tuple[Scalar, ...]:
    """Rates of cage and pinion in mesh with gears that turn at ``first`` and ``second``."""
    slips = lambda *u: (slip(g, axis, u[0], u[1], first, 1), slip(g, axis, u[0], u[1], second, -1))
    return solve_rates(slips, 2)


def spin_against(g: Givens, axis: str, cage_rate: Scalar, gear_rate: Scalar, side: int) -> Scalar:
    """Rate of the pinion in the cage if it meshes only with the gear on that side."""
    (spin,) = solve_rates(lambda spin: slip(g, axis, cage_rate, spin, gear_rate, side), 1)
    return spin


def rolled(g: Givens, axis: str, first: Number, second: Number) -> tuple[Orientation, Orientation]:
    """Proof: orientations of cage and pinion over time, by equal arcs at both contacts."""

    def angles(t):
        # R (phi - cage) = -r spin on the first side, +r spin on the second
        arcs = matrix([[-g.R, g.r], [-g.R, -g.r]])
        return mp.lu_solve(arcs, matrix([-g.R * first * t, -g.R * second * t]))

    cage = lambda t: rot(axis, angles(t)[0])
    pinion = lambda t: times(cage(t), rot(next_axis(axis), angles(t)[1]))
    return cage, pinion


def section(s: Sketch, g: Givens, axis: str, pinion_sides: Iterable[int]) -> None:
    """Draw the pitch cones of gears and pinions in the plane of their axes."""

    def wheel(corners):
        halves = (1, corners), (0.7, corners[::-1])
        places = [(t * along, t * across) for t, half in halves for along, across in half]
        s.plate([coordinates(axis, *place) for place in places])

    for side in (1, -1):
        wheel([(side * g.r, g.R), (side * g.r, -g.R)])
        for end in (g.R, -g.R):
            s.line((0, 0, 0), coordinates(axis, side * g.r, end))
    for side in pinion_sides:
        wheel([(g.r, side * g.R), (-g.r, side * g.R)])
