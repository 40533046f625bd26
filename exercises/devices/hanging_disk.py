"""The disk of 10/1 and 10/2 on a light rod AB that hangs from a ball joint at A."""

from exercises.annotations import Answers, AnyAxes, Givens, Mistakes, Scalar, Steps
from exercises.devices import steady_precession
from exercises.tools import Sketch, Step, angular_velocity, mean, mp, plus, proofs, times, vanishing
from newton_euler import Body, Frame, bodies, cos, pi, sin
from newton_euler.applications.gyroscopes import steady_spin


def hanging(g: Givens, psi: Scalar = 0) -> tuple[Frame, Frame, Body, Scalar]:
    """Ground, axes at A that precess without spinning, k from A to B, the disk and theta."""
    theta = pi(g.beta) - g.beta
    ground, axes = steady_precession.frames(theta, psi, name="disk")
    return ground, axes, bodies.disk(g.D / 2, axes.point("B", 0, 0, g.L), "z", mass=g.m), theta


def data(g: Givens) -> tuple[Scalar, Scalar, Scalar]:
    """The transverse and the axial moment of inertia about A, and the moment of the weight."""
    ground, axes, disk, _ = hanging(g)
    I_0, _, I_z = disk.about(axes).moments
    return I_0, I_z, steady_precession.weight_moment(g.m, g.g, ground, axes, g.L)


def spin(g: Givens, transverse: Scalar | None = None, theta: Scalar | None = None) -> Scalar:
    """The spin, with wrong values where a mistake gives them."""
    I_0, I_z, M = data(g)
    transverse = I_0 if transverse is None else transverse
    theta = pi(g.beta) - g.beta if theta is None else theta
    return steady_spin(transverse, I_z, theta, g.psi_dot, moment=M)


def total(g: Givens) -> Scalar:
    """The total rate about AB in steady precession (10.31)."""
    I_0, I_z, M = data(g)
    theta = pi(g.beta) - g.beta
    return (M / (g.psi_dot * sin(theta)) + I_0 * g.psi_dot * cos(theta)) / I_z


def solve(g: Givens) -> Answers:
    return {"phi_dot": total(g) - g.psi_dot * cos(pi(g.beta) - g.beta)}


def steps(g: Givens) -> Steps:
    I_0, I_z, M = data(g)
    yield Step("I", I_z, "kg*m^2", "moment of inertia about AB", "10.5", "10.17")
    yield Step("I_0", I_0, "kg*m^2", "moment of inertia about an axis through A at right "
               "angles to AB", "10.5", "10.17")  # fmt: skip
    yield Step("M", M, "N*m", "moment of the weight about A, in the direction of K x k, where K "
               "points up and k from A to B", "10.6", "10.30")  # fmt: skip
    yield Step("omega_z", total(g), "rad/s", "whole rate about AB, from the equation of steady "
               r"precession with $\theta = 180^\circ - \beta$", "10.6", "10.31")  # fmt: skip


def prove(g: Givens) -> Answers:
    """The spin for which the mass points need exactly the moment of their weights."""
    theta = mp.pi - g.beta
    points = [(share, plus(r, [0, 0, g.L])) for share, r in proofs.disk(g.D / 2, order=2)]
    M = steady_precession.of_weights(g.m, g.g, points, theta)
    lacking = lambda x: steady_precession.needed(g.m, points, theta, g.psi_dot, x) - M
    phi_dot = vanishing(lacking, 0, g.psi_dot)
    omega = angular_velocity(steady_precession.orientation(theta, g.psi_dot, phi_dot))
    along = times(proofs.rot("x", theta), [0, 0, 1])
    return {
        "phi_dot": phi_dot,
        "I": g.m * mean(lambda r: r[0] ** 2 + r[1] ** 2, points),
        "I_0": g.m * mean(lambda r: r[1] ** 2 + r[2] ** 2, points),
        "M": M,
        "omega_z": sum(x * y for x, y in zip(omega, along, strict=True)),
    }


def mistakes(g: Givens) -> Mistakes:
    _, _, disk, _ = hanging(g)
    _, I_z, _ = data(g)
    return {
        "from_below": {"phi_dot": spin(g, theta=g.beta)},
        "fast_spin": {"phi_dot": spin(g, transverse=I_z)},  # leaves only the term of the weight
        "about_B": {"phi_dot": spin(g, transverse=disk.inertia.moments[0])},
        "whole_rate": {"phi_dot": total(g)},
        "rpm": {"phi_dot": spin(g.but(psi_dot=g.stated("psi_dot")))},
    }


def draw(g: Givens, ax: AnyAxes) -> None:
    ground, axes, disk, _ = hanging(g, psi=pi(g.beta) / 2)
    s = Sketch(ax, ground, azimuth=-108, elevation=16)
    A, B, C = axes.origin, disk.centre, (0, 0, -1.1 * g.L)
    s.ground((0, 0, 0.12 * g.L), -ground.k)
    s.rod((0, 0, 0.12 * g.L), A)
    s.line(A, C, style="centre")
    s.rod(A, B)
    s.disk(B, axes.k, g.D / 2)
    s.ball_joint(A)
    s.arc(A, C, B, label=r"$\beta$")
    s.turn((0, 0, -0.58 * g.L), ground.k, label=r"$\dot\psi$")
    s.turn(axes.point("", 0, 0, g.L + 0.6 * g.D), axes.k, label=r"$\dot\phi$")
    s.line(B, axes.point("", 0, 0, g.L + 0.68 * g.D), style="centre")
    s.dimension(A, B, label="L")
    ends = [axes.point("", 0, side * g.D / 2, g.L) for side in (-1, 1)]
    s.dimension(ends[0], ends[1], label="D", offset=axes.k * (0.2 * g.D))
    s.label(A, "A")
    s.dot(B, "B")
    s.label(C, "C")
