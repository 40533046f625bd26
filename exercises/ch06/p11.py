"""6/11: a slider held by a cord in the slot of a turning disk."""

from exercises.tools import on_ground, rot, second_rate, times
from newton_euler import Frame, cos, moving, sin, solve_linear, sqrt
from newton_euler.dynamics import resultant_force
from newton_euler.kinematics import polar


def slider(g):
    """Ground, and A on the x axis of the instant; B is ahead of it, as the disk turns."""
    ground = Frame("ground")
    return ground, polar(ground, "A", g.r, moving(0, g.omega, g.n * g.omega**2))


def solve(g):
    """By the tension, and the force of the side of the slot, toward O."""
    ground, A = slider(g)
    c, s = cos(g.psi), sin(g.psi)
    slot, side = A.local.vector(-c, s, 0), A.local.vector(-s, -c, 0)
    F = resultant_force(g.m, A.acceleration(ground))
    return {"T": solve_linear(lambda T, N: T * slot + N * side - F).T}


def steps(g):
    ground, A = slider(g)
    a = A.acceleration(ground)
    return {"a_A": a, "F": resultant_force(g.m, a)}


def prove(g):
    """m times the acceleration of A on its circle, along the slot."""
    place = lambda t: times(rot("z", g.omega * t + g.n * (g.omega * t) ** 2 / 2), [g.r, 0, 0])
    a = second_rate(place)
    return {"T": -g.m * times(rot("z", g.psi), a)[0], "a_A": a}


def mistakes(g):
    whole = g.m * g.r * g.omega**2
    return {
        "no_side_force": {"T": whole * sqrt(1 + g.n**2)},
        "cord_resolved": {"T": whole / cos(g.psi)},
        "no_euler": {"T": whole * cos(g.psi)},
        "distance_of_slot": {"T": whole * sin(g.psi) * cos(g.psi)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    r, R, half = g.r, 1.6 * g.r, 0.07 * g.r
    disk = ground.rotate("disk", "z", 0)
    A = disk.point("A", r, 0, 0)
    slot = disk.rotate("slot", "-z", g.psi, origin=A)
    # along the slot from A, to just inside the rim
    middle, reach = -r * cos(g.psi), (0.9 * R**2 - (r * sin(g.psi)) ** 2) ** 0.5
    near, far = middle - reach, middle + reach
    hole = [slot.point("", x, y, 0) for x, y in
            ((near, -half), (far, -half), (far, half), (near, half))]  # fmt: skip
    s.plate(s.around((0, 0, 0), (R, 0, 0), ground.k), [hole], shade="light")
    B = slot.point("B", near, 0, 0)
    s.cable(B, A)
    s.box(A, slot, (4 * half, 2 * half, 2 * half))
    s.line((0, 0, 0), A)
    s.swing((0, 0, 0), (-0.45 * R, -0.7 * R, 0), ground.k, label=r"$\omega$")
    s.arc(A, (0, 0, 0), B, label=r"$\psi$", radius=0.35 * r)
    s.dimension((0, 0, 0), A, label="r", offset=-0.3 * r)
    s.dot((0, 0, 0), "O", offset=(-10, 6))
    s.label(A, "A", offset=(14, 4))
    s.dot(B, "B", offset=(0, 14))
