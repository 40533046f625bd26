"""5/24: the degrees of freedom of a double Atwood machine."""

from exercises.devices.atwood import count, draw_machine, miscounts, rope, steps_to_count
from exercises.tools import freedom, mpf, on_ground

MASSES = "m1", "m2", "m3"
HEIGHTS = *MASSES, "P2"
ROPES = {
    "rope_1": lambda m1, P2: m1[0] + P2[0],  # its pulley is fixed, at the height zero
    "rope_2": lambda P2, m2, m3: rope(P2, m2, m3),
}


def solve(g):
    return {"dof": count(HEIGHTS, **ROPES)}


def steps(g):
    means = "coordinates: the heights of three masses and of the movable pulley"
    return steps_to_count(HEIGHTS, ROPES, means)


def prove(g):
    """By the lengths of rope that pass each pulley, from left to right."""

    def heights(over_1, over_2):
        P2 = -over_1
        return [over_1, P2, P2 + over_2, P2 - over_2]

    return {"dof": freedom(heights, mpf("0.3"), mpf("-0.2"))}


def mistakes(g):
    return miscounts(MASSES, HEIGHTS, ROPES)


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    movable = ("$P_2$", 0.6, (2, "2"), (1.4, "3"))
    draw_machine(s, ground, ("$P_1$", 0.8, (3, "1"), (2.2, movable)))
