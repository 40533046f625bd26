"""The disk of 4/34 to 4/41, on a horizontal axle in a bracket that turns about the vertical.

Axes of the bracket: z up along its shaft, y along the axle. The disk turns relative to the bracket
at P about +y, the bracket at omega about +z; the disk's centre is on the axle, b from the shaft. On
the rim, A is at the top and B at the side on +x.
"""

from typing import TypeAlias

from exercises.annotations import Answers, Follows, Functions, Givens, Mistakes, Scalar, Steps
from exercises.catalogue.proofs.digits import Number
from exercises.devices.moving_frame import seen_in, turning_of
from exercises.tools import Sketch, acceleration_of, in_frame, mp, plus, proofs, rate, spun, terms
from newton_euler import Frame, Point, Vector
from newton_euler.drawing import AnyAxes

Frames: TypeAlias = tuple[Frame, Frame, Frame]  # ground, bracket, disk

# on the rim: at the top, and at the side on +x; C and D are those of 4/42 and 4/43
PLACES = {"A": (0, 0, 1), "B": (1, 0, 0), "C": (0, 0, 1), "D": (1, 0, 0)}


def data(g: Givens) -> tuple[tuple[Scalar, Scalar], tuple[Scalar, Scalar], Scalar]:
    """(rate, acceleration) of the bracket and of the disk, and the offset b; zero if not given."""
    omega = g.omega_b if hasattr(g, "omega_b") else g.omega
    return (omega, getattr(g, "omega_dot", 0)), (g.P, getattr(g, "P_dot", 0)), getattr(g, "b", 0)


def disk_in_bracket(g: Givens) -> Frames:
    """The frames (ground, bracket, disk); the origin of the disk is its centre."""
    (omega, omega_dot), (P, P_dot), b = data(g)
    ground = Frame("ground")
    bracket = ground.rotate("bracket", "z", rate=omega, acceleration=omega_dot)
    C = bracket.point("C", 0, b, 0)
    return ground, bracket, bracket.rotate("disk", "y", rate=P, acceleration=P_dot, origin=C)


def rim_problem(name: str) -> Functions:
    """``solve``, ``steps``, ``prove`` and ``draw`` of the motion of A or B."""
    return (
        lambda g: rim_motion(disk_in_bracket(g), name, g.r),
        lambda g: rim_steps(g, name),
        lambda g: prove_rim(g, name),
        lambda g, ax: figure(g, ax, name),
    )


def whole_problem(name: str) -> tuple[*Functions, Follows]:
    """The same, and ``follows``, of the motion of the disk and of A or B."""
    return (
        lambda g: all_motion(disk_in_bracket(g), name, g.r),
        lambda g: [*turning_steps(g), *rim_steps(g, name)],
        lambda g: prove_turning(g) | prove_rim(g, name),
        lambda g, ax: figure(g, ax, name, r"\omega_b"),
        {"alpha_disk": alpha_disk} | rim_from_turning(name),
    )


def from_centre(name: str, r: Scalar) -> list[Scalar]:
    """The components from the centre to a point of the rim."""
    return [r if e else 0 for e in PLACES[name]]


def rim_point(disk: Frame, name: str, r: Scalar) -> Point:
    """The point of the rim, fixed in the disk."""
    return disk.point(name, *from_centre(name, r))


def turning(frames: Frames) -> Answers:
    """The disk's angular velocity and acceleration in the ground, along the bracket's axes."""
    ground, bracket, disk = frames
    omega, alpha = disk.angular_velocity(ground), disk.angular_acceleration(ground)
    return in_frame(bracket, {"omega_disk": omega, "alpha_disk": alpha})


def rim_motion(frames: Frames, name: str, r: Scalar) -> Answers:
    """Velocity and acceleration of A or B, along the bracket's axes, via the bracket."""
    ground, bracket, disk = frames
    S = rim_point(disk, name, r)
    v, a = S.velocity(ground, via=bracket), S.acceleration(ground, via=bracket)
    return {f"v_{name}": v, f"a_{name}": a}


def all_motion(frames: Frames, name: str, r: Scalar) -> Answers:
    return turning(frames) | rim_motion(frames, name, r)


def solve_turning(g: Givens) -> Answers:
    return turning(disk_in_bracket(g))


def turning_steps(g: Givens) -> Steps:
    omega, alpha = solve_turning(g).values()
    yield from terms(omega, "omega_disk", "rad/s", "4.9")
    yield from terms(alpha, "alpha_disk", "rad/s^2", "4.9")


def rim_steps(g: Givens, name: str) -> Steps:
    """The motion of A or B relative to the bracket, then the terms of velocity and acceleration."""
    ground, bracket, disk = frames = disk_in_bracket(g)
    length, start = ("mm", "O") if hasattr(g, "b") else ("m", "the disk's centre")
    phrase = "the moving frame, fixed in the bracket,"
    yield from turning_of(bracket, ground, bracket, "bracket", phrase)
    S = rim_point(disk, name, g.r)
    yield from seen_in(bracket, S, bracket, length, "the bracket", start, f"r_{name}")
    v, a = rim_motion(frames, name, g.r).values()
    yield from terms(v, f"v_{name}", f"{length}/s", "4.8")
    yield from terms(a, f"a_{name}", f"{length}/s^2", "4.8")


def alpha_disk(g: Givens, omega_disk: Vector) -> Vector:
    """alpha from omega, along the axes of the bracket, which turn about z."""
    (omega, omega_dot), (_, P_dot), _ = data(g)
    frame = omega_disk.frame
    return frame.vector(0, P_dot, omega_dot) + (omega * frame.k).cross(omega_disk)


def rim_from_turning(name: str) -> Follows:
    """``follows`` of the velocity and the acceleration of A or B, by the disk as a rigid body."""
    r = lambda g, frame: frame.vector(*from_centre(name, g.r))

    def v(g, omega_disk):
        (omega, _), _, b = data(g)
        frame = omega_disk.frame
        return frame.vector(-omega * b, 0, 0) + omega_disk.cross(r(g, frame))

    def a(g, omega_disk, alpha_disk):
        (omega, omega_dot), _, b = data(g)
        frame = omega_disk.frame
        centre = frame.vector(-omega_dot * b, -(omega**2) * b, 0)
        return centre + acceleration_of(omega_disk, alpha_disk, r(g, frame))

    return {f"v_{name}": v, f"a_{name}": a}


def wrong_accelerations_of_B(g: Givens, a: Vector) -> Mistakes:
    """Two mistakes in the acceleration ``a`` of B, in each of its problems."""
    (omega, _), (P, _), _ = data(g)
    mixed = 2 * P * omega * g.r
    return {
        "square_of_the_sum": {"a_B": a - a.frame.i * mixed},
        "coriolis_of_the_top": {"a_B": a + a.frame.j * mixed},
    }


def in_time(g: Givens, t: Number) -> tuple[Number, Number, list[Number]]:
    """Proof: angles of bracket and disk, and the direction of the axle."""
    (omega, omega_dot), (P, P_dot), _ = data(g)
    theta, phi = omega * t + omega_dot * t**2 / 2, P * t + P_dot * t**2 / 2
    return theta, phi, [-mp.sin(theta), mp.cos(theta), 0]


def prove_turning(g: Givens) -> Answers:
    """Proof: angular velocity and acceleration from the disk's orientation over time."""

    def disk(t):
        _, phi, axle = in_time(g, t)
        return spun(axle, [0, 0, 1], phi)

    omega, alpha = proofs.angular_velocity(disk), proofs.angular_acceleration(disk)
    return {"omega_disk": omega, "alpha_disk": alpha}


def prove_rim(g: Givens, name: str) -> Answers:
    """Proof: motion of A or B from its position over time, the rim turning from +z toward +x."""
    start = {"A": 0, "B": mp.pi / 2}[name]
    phi = lambda t: start + in_time(g, t)[1]
    seen = lambda t: [g.r * mp.sin(phi(t)), data(g)[-1], g.r * mp.cos(phi(t))]

    def place(t):
        theta, _, axle = in_time(g, t)
        ahead, out, up = seen(t)
        return plus(proofs.scaled(out, axle), [ahead * mp.cos(theta), ahead * mp.sin(theta), up])

    found = {f"r_{name}": seen(0), "v_r": rate(seen), "a_r": proofs.second_rate(seen)}
    return {f"v_{name}": rate(place), f"a_{name}": proofs.second_rate(place)} | found


def figure(g: Givens, ax: AnyAxes, rim: str = "", omega_name: str = r"\omega") -> None:
    """The figure, with the points ``rim``; rates that grow are labelled with their derivatives."""
    ground, bracket, disk = disk_in_bracket(g)
    s = Sketch(ax, ground, azimuth=50, elevation=18)
    with_rate = lambda name: rf"${name},\ \dot{{{name}}}$" if hasattr(g, "P_dot") else f"${name}$"
    letters = map(with_rate, (omega_name, "P"))
    r = getattr(g, "r", 1.0)
    s.disk(disk.origin, bracket.j, r)
    (_draw_axle if hasattr(g, "b") else _draw_fork)(s, bracket, disk, r, *letters)
    points = [rim_point(disk, name, r) for name in rim]
    for point in points:
        s.dot(point, point.name)
    if hasattr(g, "r"):
        s.dimension(disk.origin, points[0], label="r")


def _draw_fork(s, bracket, disk, r, omega, P):
    """The disk between the arms of a fork, its centre above the shaft."""
    C = disk.origin
    middle = bracket.point("", 0, 0, -1.4 * r)
    foot = bracket.point("", 0, 0, -2.2 * r)
    for y in (-0.7 * r, 0.7 * r):
        end, corner = bracket.point("", 0, y, 0), bracket.point("", 0, y, -1.4 * r)
        s.rod(C, end, corner, middle)
    s.shaft(foot, middle)
    s.ground(foot, bracket.k)
    s.axes(C, bracket, length=1.5 * r)
    s.turn(bracket.point("", 0, 0, -1.9 * r), bracket.k, label=omega)
    s.turn(bracket.point("", 0, r, 0), bracket.j, label=P)


def _draw_axle(s, bracket, disk, r, omega, P):
    """The disk at the end of an axle of length b that projects from the shaft."""
    O, foot = bracket.point("O", 0, 0, 0), bracket.point("", 0, 0, -1.6 * r)
    s.shaft(foot, O)
    s.rod(O, disk.origin)
    s.ground(foot, bracket.k)
    s.axes(O, bracket)
    s.turn(bracket.point("", 0, 0, -r), bracket.k, label=omega)
    s.turn(disk.point("", 0, 0.3 * r, 0), bracket.j, label=P)
    s.dot(disk.origin)
    s.dimension(O, disk.origin, label="b")
    s.label(O, "O")
