"""A disk that spins in an arm on a shaft through O (9/7, 9/8): H_O, force and couple on it."""

from collections.abc import Sequence
from dataclasses import dataclass

from exercises.annotations import Answers, Follows, Givens, Number, Scalar, Steps
from exercises.devices.rotor import SMALL, state
from exercises.tools import Step, disk, in_frame, plus, proofs, rate, rot, size, times
from newton_euler import Body, Frame, Point, Vector, bodies, dynamics


@dataclass(frozen=True)
class SpinningDisk:
    """The disk, and the frames in which it moves; O is a point of the axis of the shaft."""

    ground: Frame
    arm: Frame
    body: Body
    O: Point


def spinning(
    g: Givens, radius: Scalar, shaft: str, spin: str, C: Sequence[Scalar] = (0, 0, 0)
) -> SpinningDisk:
    """The arm turns about ``shaft`` through O, the disk in it about ``spin`` through C."""
    ground = Frame("ground")
    arm = ground.rotate("arm", shaft, rate=g.omega_1)
    turned = arm.rotate("disk", spin, rate=g.omega_2, origin=arm.point("C", *C))
    body = bodies.disk(radius, turned, spin, mass=g.m)
    return SpinningDisk(ground, arm, body, arm.point("O", 0, 0, 0))


def with_moments_exchanged(d: SpinningDisk, spin: str) -> SpinningDisk:
    """The disk with its axial and diametral moments of inertia exchanged."""
    axial, across = moments(d, spin)
    exchanged = (across if axis == spin else axial for axis in "xyz")
    wrong = Body("disk", d.body.mass, d.body.frame, tuple(exchanged))
    return SpinningDisk(d.ground, d.arm, wrong, d.O)


def moments(d: SpinningDisk, spin: str) -> tuple[Scalar, Scalar]:
    """The axial and the diametral moment of inertia."""
    return tuple(d.body.inertia.moment(axis) for axis in (spin, "x"))


def momentum(d: SpinningDisk) -> Vector:
    """H_O along the axes of the arm."""
    return dynamics.angular_momentum(d.body, d.ground, d.O).expressed_in(d.arm)


def answers(d: SpinningDisk, couple: str) -> Answers:
    """H_O, its rate, and under ``couple`` the moment about O, which equals the rate (8.11)."""
    H = momentum(d)
    found = in_frame(d.arm, {"H_O": H, "Hdot_O": H.rate(d.ground)})
    return {**found, couple: d.arm.vector(*found["Hdot_O"].components())}


def force(d: SpinningDisk) -> Vector:
    """The resultant force on the disk, whose centre of mass is a point of the arm."""
    C = d.body.frame.origin
    return dynamics.resultant_force(d.body.mass, C.acceleration(d.ground)).expressed_in(d.arm)


def balance(d: SpinningDisk) -> str:
    """The answer on the balance, by the offset of the centre of mass and the rate of H_O."""
    omega, H = d.arm.angular_velocity(d.ground), momentum(d)
    G = d.body.centre - d.O
    rests = abs(omega.cross(G)) <= 1e-9 * abs(omega) * abs(G)
    return state(rests, abs(H.rate(d.ground)) <= 1e-9 * abs(omega) * abs(H))


def spin_steps(d: SpinningDisk, spin: str) -> Steps:
    axial, across = moments(d, spin)
    yield Step("I_s", axial, "kg*m^2", "moment of inertia about the axis of the disk", "7.6")
    yield Step("I_d", across, "kg*m^2", "moment of inertia about a diameter", "7.6")
    omega = d.body.frame.angular_velocity(d.ground).expressed_in(d.arm)
    yield Step("omega_disk", omega, "rad/s", "angular velocity of the disk in the inertial frame",
               "4.9", "4.22")  # fmt: skip


def disk_rate(d: SpinningDisk, couple: str) -> Answers:
    """Mistake: H_O differentiated with the angular velocity of the disk."""
    wrong = d.body.frame.angular_velocity(d.ground).expressed_in(d.arm).cross(momentum(d))
    return {"Hdot_O": wrong, couple: wrong}


def no_rotation(d: SpinningDisk, couple: str) -> Answers:
    """Mistake: only the components of H_O, which are constant, differentiated."""
    right = momentum(d).rate(d.ground)
    # not 0, so that zero remains a formula in the symbols
    return dict.fromkeys(("Hdot_O", couple), (right - right.terms["rotation"]).expressed_in(d.arm))


def following(couple: str, shaft: str) -> Follows:
    """``follows`` with the key ``couple``; the arm turns about its axis ``shaft``."""

    def Hdot_O(g, H_O):
        axis = dict(zip("xyz", (H_O.frame.i, H_O.frame.j, H_O.frame.k), strict=True))[shaft]
        return (axis * g.omega_1).cross(H_O)

    return {"Hdot_O": Hdot_O, couple: lambda g, Hdot_O: Hdot_O}


def prove_spinning(
    g: Givens, radius: Number, shaft: str, spin: str, C: Sequence[Number], couple: str
) -> Answers:
    """The answers from the disk's moving mass points, with the force F_A."""
    turned = {"x": lambda x, y, z: [z, x, y], "y": lambda x, y, z: [y, z, x],
              "z": lambda x, y, z: [x, y, z]}[spin]  # fmt: skip
    points = [(share * g.m, turned(*place)) for share, place in disk(radius)]

    def carried(t):
        outer, inner = rot(shaft, g.omega_1 * t), rot(spin, g.omega_2 * t)
        return [(m, times(outer, plus(C, times(inner, p)))) for m, p in points]

    momentum = lambda t: proofs.angular_momentum(1, carried, t=t)
    H, Hdot, force = momentum(0), rate(momentum), proofs.force_needed(1, carried)
    reach = sum(m * (size(C) + size(p)) for m, p in points)
    rests = size(force) < SMALL * g.omega_1**2 * reach
    steady = size(Hdot) < SMALL * g.omega_1 * size(H)

    def about(axis):
        n = "xyz".index(axis)
        return sum(m * (sum(x * x for x in p) - p[n] ** 2) for m, p in points)

    return {
        "H_O": H,
        "Hdot_O": Hdot,
        "F_A": force,
        couple: proofs.moment_needed(1, carried),
        "balance": lambda: state(rests, steady),
        "I_s": about(spin),
        "I_d": about(shaft),
    }
