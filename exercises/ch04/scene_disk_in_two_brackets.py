"""4/42, 4/43: a disk in the bracket A, which turns in the bracket B, which turns about the vertical.

At the instant all axes are parallel: z up along the shaft of B, x along the axis of A in B, y along the axis of the disk in A.
The three axes meet at the disk's centre. On the rim, C is at the top and D at the side on +x.
"""

from exercises.answering import in_frame
from exercises.proofs import angular_acceleration, angular_velocity, rate, rot, second_rate, times
from newton_euler import Frame
from newton_euler.drawing import Sketch

PLACES = {"C": (0, 0, 1), "D": (1, 0, 0)}


def disk_in_two_brackets(g):
    """The frames (ground, B, A, disk), all with the origin at the disk's centre."""
    ground = Frame("ground")
    B = ground.rotate("B", "z", rate=g.omega_1)
    A = B.rotate("A", "x", rate=g.omega_2)
    return ground, B, A, A.rotate("disk", "y", rate=g.omega_3)


def rim_point(g, disk, name):
    """The point C or D of the rim, fixed in the disk."""
    return disk.point(name, *(g.r if e else 0 for e in PLACES[name]))


def frames_and_point(g, name):
    """The frames and one point of the rim."""
    frames = disk_in_two_brackets(g)
    return frames, rim_point(g, frames[-1], name)


def answers(frames, S):
    """The answers for the rim point S, along the axes of B; the acceleration has the terms that the disk gives."""
    ground, B, _, disk = frames
    return in_frame(B, {
        "omega_disk": disk.angular_velocity(ground),
        "alpha_disk": disk.angular_acceleration(ground),
        f"v_{S.name}": S.velocity(ground),
        f"a_{S.name}": S.acceleration(ground),
    })  # fmt: skip


def prove_rim(g, name):
    """The same answers, from the orientation of the disk as a function of time."""

    def disk(t):
        return times(rot("z", g.omega_1 * t), rot("x", g.omega_2 * t), rot("y", g.omega_3 * t))

    def place(t):
        return times(disk(t), [g.r * e for e in PLACES[name]])

    return {
        "omega_disk": angular_velocity(disk),
        "alpha_disk": angular_acceleration(disk),
        f"v_{name}": rate(place),
        f"a_{name}": second_rate(place),
    }


def wrong_alphas(alpha):
    """The mistakes of both problems in the angular acceleration."""
    reversed_products = {name: -1 for name in alpha.terms if " x " in name}
    return {
        "alpha_zero": {"alpha_disk": alpha.without(*reversed_products)},
        "products_reversed": {"alpha_disk": alpha.reweighted(**reversed_products)},
    }


def draw_two_brackets(g, ax):
    """The figure of both problems."""
    ground, B, A, disk = disk_in_two_brackets(g)
    s = Sketch(ax, ground, azimuth=50, elevation=20)
    ring, arm, low = 1.3 * g.r, 1.6 * g.r, -1.6 * g.r
    O, foot, top = B.point("", 0, 0, 0), B.point("", 0, 0, 1.6 * low), B.point("", 0, 0, low)
    s.disk(O, disk.j, g.r)
    s.ring(O, A.k, ring)
    for y in (-ring, ring):
        s.rod(O, A.point("", 0, y, 0))
    for x in (-1, 1):
        pin, corner = B.point("", x * arm, 0, 0), B.point("", x * arm, 0, low)
        s.rod(A.point("", x * ring, 0, 0), pin)
        s.rod(pin, corner)
        s.rod(corner, top)
    s.shaft(foot, top)
    s.ground(foot, ground.k)
    s.axes(O, B, length=2 * g.r)
    s.turn(B.point("", 0, 0, 1.3 * low), B.k, label=r"$\omega_1$")
    s.turn(B.point("", arm, 0, 0), B.i, label=r"$\omega_2$")
    s.turn(A.point("", 0, 1.5 * g.r, 0), A.j, label=r"$\omega_3$")
    for name in PLACES:
        s.dot(rim_point(g, disk, name))
        s.label(rim_point(g, disk, name), name)
    s.label(B.point("", arm, 0, low), "B")
    s.label(A.point("", 0.7 * ring, -0.7 * ring, 0), "A")
    s.dimension(O, rim_point(g, disk, "C"), label="r")
