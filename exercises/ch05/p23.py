"""5/23: the degrees of freedom of a ladder against a wall. The length is only drawn."""

from exercises.tools import Sketch, freedom, mp, mpf
from newton_euler import Frame, cos, dynamics

# the lower end, at x and y, is on the floor; it and the slope locate the ladder
floor = lambda ladder: ladder[1]
# the upper end of the ladder, of unit length, is at the wall x = 0
wall = lambda ladder: ladder[0] + cos(ladder[2])


def count(**constraints):
    return dynamics.degrees_of_freedom({"ladder": "body in plane"}, constraints)


def solve(g):
    return {"dof": count(floor=floor, wall=wall)}


def steps(g):
    return {"coordinates": count().unknowns, "constraints": 2}


def prove(g):
    """By the angle from the wall, which locates both ends."""
    return {"dof": freedom(lambda q: [mp.sin(q), 0, 0, mp.cos(q)], mpf("0.4"))}


def mistakes(g):
    return {
        "free": {"dof": count()},
        "one_contact": {"dof": count(floor=floor)},
        "held": {"dof": count(floor=floor, wall=wall, friction=lambda ladder: ladder[0] + 0.5)},
    }


def draw(g, ax):
    s = Sketch(ax, Frame("ground"), plane="xz")
    A, B = (0.5 * g.L, 0, 0), (0, 0, 0.75**0.5 * g.L)
    # down the wall, then along the floor: the hatching is on the right
    s.road([(0, 0, 1.1 * g.L), (0, 0, 0), (0.9 * g.L, 0, 0)])
    s.rod(A, B)
    s.dimension(A, B, label="L", offset=-0.1 * g.L)
    s.label((0.85 * g.L, 0, 0), "floor", offset=(0, 10), bold=False)
    s.label((0, 0, 1.05 * g.L), "wall", offset=(20, 0), bold=False)
