"""The telescoping boom AB of a truck (2/26 to 2/29), at rest or driving; theta decreases.

The functions are those of all four problems; rates that are not given are zero, and theta matters
only where the truck moves.
"""

from exercises.annotations import Answers, AnyAxes, Givens, Scalar, Steps
from exercises.tools import Sketch, Step, at_angle, in_frame, plus, proofs, rate, rot, terms
from newton_euler import Frame, Point, moving, pi

UNITS = {"v_B": "ft/s", "a_B": "ft/s^2"}


def data(g: Givens) -> tuple[Scalar, Scalar, Scalar, Scalar]:
    """The second rates of the length and of theta, and the truck's velocity and acceleration."""
    L_ddot, alpha, v, a = (getattr(g, name, 0) for name in ("L_ddot", "alpha", "v", "a"))
    return L_ddot, -alpha, v, a


def boom(g: Givens, theta: Scalar = 0) -> tuple[Frame, Frame, Point]:
    """Ground, x forward and y up; the boom, with i from A to B; B."""
    L_ddot, alpha, v, a = data(g)
    ground = Frame("ground")
    A = ground.point("A", moving(0, rate=v, acceleration=a), 0, 0)
    theta = getattr(g, "theta", theta)
    arm = ground.rotate("boom", "z", theta, rate=-g.omega, acceleration=alpha, origin=A)
    B = arm.point("B", moving(g.L, rate=g.L_dot, acceleration=L_ddot), 0, 0)
    return ground, arm, B


def solve(g: Givens) -> Answers:
    """The answers, in the axes of the boom."""
    ground, arm, B = boom(g)
    v, a = B.velocity(ground, via=arm), B.acceleration(ground, via=arm)
    return in_frame(arm, {"v_B": v, "a_B": a})


def steps(g: Givens) -> Steps:
    """The rotation of the boom, the motion of B relative to it, then the terms of the answers."""
    ground, arm, B = boom(g)
    omega, alpha = arm.angular_velocity(ground), arm.angular_acceleration(ground)
    yield Step("omega_boom", omega.expressed_in(arm), "rad/s",
               "angular velocity of the boom, along k", "2.8", "2.19")  # fmt: skip
    yield Step("alpha_boom", alpha.expressed_in(arm), "rad/s^2",
               "angular acceleration of the boom", "2.10", "2.26")  # fmt: skip
    yield Step("v_r", B.velocity(arm), "ft/s", "velocity of B in the boom", "2.10", "2.24")
    yield Step("a_r", B.acceleration(arm), "ft/s^2", "acceleration of B in the boom", "2.10",
               "2.25")  # fmt: skip
    for key, value in solve(g).items():
        yield from terms(value, key, UNITS[key], "2.10", {"v_B": "2.24", "a_B": "2.25"}[key])


def prove(g: Givens) -> Answers:
    """B over time, forward and up; along the boom, the answers do not depend on theta."""
    (L_ddot, alpha, v, a), theta = data(g), getattr(g, "theta", 1)
    elevation = lambda t: theta - g.omega * t + alpha * t**2 / 2
    A = lambda t: [v * t + a * t**2 / 2, 0, 0]
    L = lambda t: g.L + g.L_dot * t + L_ddot * t**2 / 2
    B = lambda t: plus(A(t), at_angle(L(t), elevation(t)))
    along_boom = lambda vector, t=0: proofs.times(proofs.transposed(rot("z", elevation(t))), vector)
    in_boom = lambda t: along_boom(proofs.minus(B(t), A(t)), t)
    return {
        "v_B": along_boom(rate(B)),
        "a_B": along_boom(proofs.second_rate(B)),
        "omega_boom": [0, 0, rate(elevation)],
        "alpha_boom": [0, 0, proofs.second_rate(elevation)],
        "v_r": rate(in_boom),
        "a_r": proofs.second_rate(in_boom),
    }


def draw(g: Givens, ax: AnyAxes) -> None:
    """The truck, the boom, omega and the axes of the answers; theta is 35 degrees by default."""
    ground, arm, B = boom(g, theta=7 * pi(g.L) / 36)
    size = g.L
    A, road = ground.point("A", 0, 0, 0), -0.3 * size
    s = Sketch(ax, ground, plane="xy")
    s.road([(-0.55 * size, road, 0), (0.95 * size, road, 0)])
    for x in (-0.35, 0.12):
        s.disk((x * size, road + 0.06 * size, 0), ground.k, 0.06 * size)
    low, high, cab = road + 0.07 * size, road + 0.13 * size, road + 0.23 * size
    outline = [(-0.46, low), (-0.46, high), (0.06, high), (0.06, cab), (0.19, cab), (0.24, high)]
    s.plate([(x * size, y, 0) for x, y in [*outline, (0.24, low)]])
    s.line((-0.12 * size, high, 0), (0, 0, 0), style="solid")
    s.line((-0.02 * size, high, 0), (0, 0, 0), style="solid")
    s.rod(A, B)
    s.hinge(A)
    s.line(A, (0.6 * size, 0, 0))
    s.arc(A, (size, 0, 0), B, label=r"$\theta$")
    s.dimension(A, B, label="L", offset=0.22 * size)
    s.swing(A, B, -ground.k, label=r"$\omega,\ \alpha$" if hasattr(g, "alpha") else r"$\omega$")
    s.vector(B, arm.i, r"$\dot L,\ \ddot L$" if hasattr(g, "L_ddot") else r"$\dot L$")
    s.axes(arm.point("foot", 0.6 * size, 0, 0), arm, length=0.14 * size, labels=["i", "j", ""])
    s.label(A, "A", offset=(-12, -4))
    s.label(B, "B", offset=(-3, 12))
    if hasattr(g, "v"):
        s.vector((0.26 * size, -0.2 * size, 0), (1, 0, 0), "v")
    if hasattr(g, "a"):
        s.vector((0.26 * size, -0.1 * size, 0), (1, 0, 0), "a", kind="acceleration")
