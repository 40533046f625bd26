"""5/25: the degrees of freedom of five masses on four ropes."""

from exercises.devices.atwood import count, draw_machine, miscounts, rope, steps_to_count
from exercises.tools import freedom, mpf, on_ground

MASSES = "m1", "m2", "m3", "m4", "m5"
HEIGHTS = *MASSES, "P2", "P3", "P4"
ROPES = {
    "rope_1": lambda P2, P3: P2[0] + P3[0],  # its pulley is fixed, at the height zero
    "rope_2": lambda P2, m1, m2: rope(P2, m1, m2),
    "rope_3": lambda P3, m3, P4: rope(P3, m3, P4),
    "rope_4": lambda P4, m4, m5: rope(P4, m4, m5),
}


def solve(g):
    return {"dof": count(HEIGHTS, **ROPES)}


def steps(g):
    means = "coordinates: the heights of five masses and of three movable pulleys"
    return steps_to_count(HEIGHTS, ROPES, means)


def prove(g):
    """By the lengths of rope that pass each pulley, from left to right."""

    def heights(over_1, over_2, over_3, over_4):
        P2, P3 = over_1, -over_1
        P4 = P3 - over_3
        masses = [P2 + over_2, P2 - over_2, P3 + over_3, P4 + over_4, P4 - over_4]
        return [P2, P3, P4, *masses]

    return {"dof": freedom(heights, mpf("0.3"), mpf("-0.2"), mpf("0.5"), mpf("0.7"))}


def mistakes(g):
    return miscounts(MASSES, HEIGHTS, ROPES)


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    P2 = ("$P_2$", 0.6, (2.2, "1"), (1.5, "2"))
    P4 = ("$P_4$", 0.6, (1.2, "4"), (1.8, "5"))
    P3 = ("$P_3$", 0.7, (2.6, "3"), (2, P4))
    draw_machine(s, ground, ("$P_1$", 1.3, (2.8, P2), (2.5, P3)))
