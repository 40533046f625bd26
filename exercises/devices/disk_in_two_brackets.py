"""The disk of 4/42 and 4/43 (the drum of 4/25 turns alike) in the bracket A, which turns in the
bracket B, which turns about the vertical.

At the instant all axes are parallel: z up along the shaft of B, x along the axis of A in B, y along
the axis of the disk in A. The three axes meet at the disk's centre. On the rim, C is at the top and
D at the side on +x.
"""

from typing import TypeAlias

from exercises.annotations import Answers, AnyAxes, Follows, Functions, Givens, Mistakes, Steps
from exercises.catalogue.proofs.digits import Number
from exercises.devices.disk_in_bracket import from_centre, rim_point
from exercises.devices.moving_frame import seen_in
from exercises.tools import Sketch, acceleration_of, in_frame, mp, plus, proofs, rate, scaled, terms
from newton_euler import Frame, Point, Vector

Frames: TypeAlias = tuple[Frame, Frame, Frame, Frame]  # ground, B, A, disk


def disk_in_two_brackets(g: Givens) -> Frames:
    """The frames (ground, B, A, disk), all with the origin at the disk's centre."""
    ground = Frame("ground")
    B = ground.rotate("B", "z", rate=g.omega_1)
    A = B.rotate("A", "x", rate=g.omega_2)
    return ground, B, A, A.rotate("disk", "y", rate=g.omega_3)


def rim_problem(name: str) -> Functions:
    """``solve``, ``steps``, ``prove`` and ``draw`` of the motion of C or D."""
    return (
        lambda g: answers(*frames_and_point(g, name)),
        lambda g: rim_steps(g, name),
        lambda g: prove_rim(g, name),
        lambda g, ax: draw_two_brackets(g, ax, name),
    )


def frames_and_point(g: Givens, name: str) -> tuple[Frames, Point]:
    frames = disk_in_two_brackets(g)
    return frames, rim_point(frames[-1], name, g.r)


def answers(frames: Frames, S: Point) -> Answers:
    """The answers for the rim point S, along the axes of B."""
    ground, B, _, disk = frames
    omega, alpha = disk.angular_velocity(ground), disk.angular_acceleration(ground)
    v, a = S.velocity(ground), S.acceleration(ground)
    turning = {"omega_disk": omega, "alpha_disk": alpha}
    return in_frame(B, {**turning, f"v_{S.name}": v, f"a_{S.name}": a})


def rim_steps(g: Givens, name: str) -> Steps:
    """The rotation of the disk, then the motion of C or D."""
    frames, S = frames_and_point(g, name)
    _, B, _, disk = frames
    omega, alpha, v, a = answers(frames, S).values()
    yield from terms(omega, "omega_disk", "rad/s", "4.9")
    yield from terms(alpha, "alpha_disk", "rad/s^2", "4.9", "4.26")
    start = "the disk's centre, which is at rest; the moving frame is fixed in the disk"
    yield from seen_in(disk, S, B, "m", "the disk", start, f"r_{name}")
    yield from terms(v, f"v_{name}", "m/s", "4.8")
    yield from terms(a, f"a_{name}", "m/s^2", "4.8")


def rim_from_turning(name: str) -> Follows:
    """``follows`` of v and a of C or D: the disk is rigid, its centre at rest."""
    r = lambda g, frame: frame.vector(*from_centre(name, g.r))
    v = lambda g, omega_disk: omega_disk.cross(r(g, omega_disk.frame))

    def a(g, omega_disk, alpha_disk):
        return acceleration_of(omega_disk, alpha_disk, r(g, omega_disk.frame))

    return {f"v_{name}": v, f"a_{name}": a}


def pin_and_axis(gone_round: Number, risen: Number) -> tuple[list[Number], list[Number]]:
    """Proof: the pin of A in B after B has turned, and the disk's axis after A has turned."""
    pin = [mp.cos(gone_round), mp.sin(gone_round), 0]
    level = [-mp.sin(gone_round), mp.cos(gone_round), 0]
    return pin, plus(scaled(mp.cos(risen), level), [0, 0, mp.sin(risen)])


def prove_turning(
    omega_1: Number, omega_2: Number, omega_3: Number
) -> tuple[list[Number], list[Number]]:
    """Proof: the disk's angular velocity and acceleration, from its orientation over time."""

    def disk(t):
        pin, axis = pin_and_axis(omega_1 * t, omega_2 * t)
        return proofs.spun(axis, pin, omega_3 * t)

    return proofs.angular_velocity(disk), proofs.angular_acceleration(disk)


def prove_rim(g: Givens, name: str) -> Answers:
    """Proof: the top of the rim moves toward +x, the side on +x moves down."""

    def place(t):
        pin, axis = pin_and_axis(g.omega_1 * t, g.omega_2 * t)
        c, s, up = g.r * mp.cos(g.omega_3 * t), g.r * mp.sin(g.omega_3 * t), proofs.cross(pin, axis)
        C, D = plus(scaled(c, up), scaled(s, pin)), plus(scaled(c, pin), scaled(-s, up))
        return {"C": C, "D": D}[name]

    omega, alpha = prove_turning(g.omega_1, g.omega_2, g.omega_3)
    return {
        "omega_disk": omega,
        "alpha_disk": alpha,
        f"v_{name}": rate(place),
        f"a_{name}": proofs.second_rate(place),
        f"r_{name}": place(0),
    }


def wrong_alphas(alpha: Vector) -> Mistakes:
    """The mistakes of both problems in the angular acceleration."""
    reversed_products = {name: -1 for name in alpha.terms if " x " in name}
    return {
        "alpha_zero": {"alpha_disk": alpha.without(*reversed_products)},
        "products_reversed": {"alpha_disk": alpha.reweighted(**reversed_products)},
    }


def draw_two_brackets(g: Givens, ax: AnyAxes, name: str) -> None:
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
        s.rod(A.point("", x * ring, 0, 0), pin, corner, top)
    s.shaft(foot, top)
    s.ground(foot, ground.k)
    s.axes(O, B, length=2 * g.r)
    s.turn(B.point("", 0, 0, 1.3 * low), B.k, label=r"$\omega_1$")
    s.turn(B.point("", arm, 0, 0), B.i, label=r"$\omega_2$")
    s.turn(A.point("", 0, 1.5 * g.r, 0), A.j, label=r"$\omega_3$")
    rim = rim_point(disk, name, g.r)
    s.dot(rim, name)
    s.label(B.point("", arm, 0, low), "B")
    s.label(A.point("", 0.7 * ring, -0.7 * ring, 0), "A")
    s.dimension(O, rim, label="r")
