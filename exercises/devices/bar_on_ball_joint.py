"""The bar of 4/12 and 4/13, on a rod that moves about a ball joint at its foot."""

import math
from collections.abc import Callable
from typing import TypeAlias

from exercises.annotations import Answers, AnyAxes, Givens, Mistakes, Scalar, Steps
from exercises.tools import Sketch, Step, in_frame, minus, mp, rate, rot, size, times
from newton_euler import Frame, Point, Vector, solve_rates

Assembly: TypeAlias = tuple[Frame, Frame, Point, Point]  # ground, body, A, D

follows = {"v_D": lambda g, omega: omega.cross(omega.frame.vector(-g.x_A / 2, g.h, -g.z_A / 2))}


def assembly(g: Givens, omega_y: Scalar, omega_z: Scalar) -> Assembly:
    """Ground with y up, the body with its three rates at the instant, and its points A and D."""
    ground = Frame("ground")
    body = ground
    for axis, turning in zip("xyz", (g.omega_x, omega_y, omega_z), strict=True):
        body = body.rotate(f"about {axis}", axis, rate=turning)
    A, D = body.point("A", g.x_A, g.h, g.z_A), body.point("D", -g.x_A / 2, g.h, -g.z_A / 2)
    return ground, body, A, D


def moving_so_that(g: Givens, conditions: Callable[[Vector], tuple[Scalar, Scalar]]) -> Assembly:
    """The assembly with the rates about y and z at which the ``conditions`` on v_A vanish."""

    def violated(omega_y, omega_z):
        ground, _, A, _ = assembly(g, omega_y, omega_z)
        return conditions(A.velocity(ground))

    return assembly(g, *solve_rates(violated, 2))


def joint_motion(g: Givens) -> Assembly:
    """The assembly with the given x and y components of the velocity of A."""
    return moving_so_that(g, lambda v_A: (v_A.x - g.v_Ax, v_A.y - g.v_Ay))


def answers(ground: Frame, body: Frame, A: Point, D: Point) -> Answers:
    """The answers of both problems, for this motion."""
    return in_frame(ground, {"omega": body.angular_velocity(ground), "v_D": D.velocity(ground)})


def solve(g: Givens) -> Answers:
    return answers(*joint_motion(g))


def steps(g: Givens) -> Steps:
    """The components of v_A = omega x r_A, one by one."""
    ground, body, A, D = joint_motion(g)
    omega = body.angular_velocity(ground).expressed_in(ground)
    yield Step("r_A", A.position(body).expressed_in(ground), "in", "position of A from O", "4.4")
    yield Step("omega_z", omega.z, "rad/s", "z component of omega, from v_Ay", "4.4", "4.11")
    yield Step("omega_y", omega.y, "rad/s", "y component of omega, from v_Ax", "4.4", "4.11")
    v_A = A.velocity(ground).expressed_in(ground)
    yield Step("v_A", v_A, "in/s", "velocity of A, with the z component", "4.4", "4.11")
    yield Step("r_D", D.position(body).expressed_in(ground), "in", "position of D from O", "4.4")


def prove(g: Givens) -> Answers:
    """A steady rotation about one axis; two rates follow from numerical velocities."""
    A, D = [g.x_A, g.h, g.z_A], [-g.x_A / 2, g.h, -g.z_A / 2]

    def velocity(r, y, z):
        omega = [g.omega_x, y, z]
        return rate(lambda t: times(rot(omega, size(omega) * t), r))

    start = velocity(A, 0, 0)
    # velocities are linear in the rates
    by_y, by_z = minus(velocity(A, 1, 0), start), minus(velocity(A, 0, 1), start)
    by_both = mp.matrix([[by_y[0], by_z[0]], [by_y[1], by_z[1]]])
    y, z = mp.lu_solve(by_both, mp.matrix([g.v_Ax - start[0], g.v_Ay - start[1]]))
    found = {"omega_y": y, "omega_z": z, "v_A": velocity(A, y, z)}
    return {"omega": [g.omega_x, y, z], "v_D": velocity(D, y, z)} | found


def mistakes(g: Givens) -> Mistakes:
    reverse = solve(g.but(v_Ax=-g.v_Ax, v_Ay=-g.v_Ay))  # r x omega = v_A
    return {
        "r_cross_omega": {"omega": reverse["omega"], "v_D": -reverse["v_D"]},
        "v_Az_zero": answers(*moving_so_that(g, lambda v_A: (v_A.y - g.v_Ay, v_A.z))),
        "positions_from_B": solve(g.but(h=0)),
    }


def draw(g: Givens, ax: AnyAxes) -> None:
    ground, body, A, D = joint_motion(g)
    O, B = body.point("O", 0, 0, 0), body.point("B", 0, g.h, 0)
    corner = ground.point("", g.x_A, g.h, 0)
    to_A = math.degrees(math.atan2(g.x_A, g.z_A))
    s = Sketch(ax, ground, azimuth=min(35, to_A - 15), elevation=25, up="y")  # A apart from OB
    s.ground(O, normal=ground.j)
    s.ball_joint(O)
    s.rod(O, B)
    s.rod(D, A)
    s.axes(O, ground, length=1.4 * g.h)
    s.line(B, corner, style="dashed")
    s.line(corner, A, style="dashed")
    s.dimension(O, B, label="h")
    s.dimension(B, corner, label="$x_A$")
    s.dimension(corner, A, label="$z_A$")
    s.vector(A, A.velocity(ground), r"$\mathbf{v}_A$")
    for P in (O, A, B, D):
        s.label(P, P.name)
