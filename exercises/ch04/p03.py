"""4/3: the two perpendicular arms of a robot on a turning base."""

from mpmath import mp

from exercises.catalogue import in_frame
from exercises.devices.boom import acceleration_without_cross_product, turning_boom
from exercises.proofs import rot, second_rate, size, times
from newton_euler import moving
from newton_euler.drawing import Sketch


def robot(g):
    """OA along the boom's z axis, AP along its x axis."""
    ground, base, arms = turning_boom(g.omega, moving(g.beta_1, g.b_dot, g.b_ddot))
    return ground, base, arms.point("P", g.l_AP, 0, g.l_OA)


def with_size(a):
    return {"a": a, "acc_mag": a.norm()}


def solve(g):
    ground, base, P = robot(g)
    return in_frame(ground, with_size(P.acceleration(ground, via=base)))


def prove(g):
    def P(t):
        beta = g.beta_1 + g.b_dot * t + g.b_ddot * t**2 / 2
        c, s = mp.cos(beta), mp.sin(beta)
        return times(rot("z", g.omega * t), [g.l_OA * s + g.l_AP * c, 0, g.l_OA * c - g.l_AP * s])

    a = second_rate(P)
    return {"a": a, "acc_mag": size(a)}


def mistakes(g):
    ground, base, P = robot(g)
    wrong = {
        "rates_in_degrees": solve(g.but(omega=g.stated("omega"), b_dot=g.stated("b_dot"), b_ddot=g.stated("b_ddot"))),
        "no_coriolis": with_size(P.acceleration(ground, via=base).without("coriolis")),
        "no_tangential": solve(g.but(b_ddot=0)),
        "beta_the_other_way": solve(g.but(b_dot=-g.b_dot, b_ddot=-g.b_ddot)),
        "no_cross_product": with_size(acceleration_without_cross_product(P, ground)),
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    ground, base, P = robot(g)
    O, A = ground.point("O", 0, 0, 0), P.frame.point("A", 0, 0, g.l_OA)
    up, foot = (0, 0, 0.8 * g.l_OA), (0, 0, -0.5 * g.l_OA)
    x, _, z = A.position(ground)
    level = (x + 0.9 * g.l_AP, 0, z)
    s = Sketch(ax, ground, azimuth=-105, elevation=12)
    s.ground(foot, normal=ground.k)
    s.shaft(foot, O)
    s.rod(O, A)
    s.rod(A, P)
    s.hinge(O, ground.j)
    s.line(O, up)
    s.line(A, level)
    s.arc(O, up, A, label=r"$\beta$")
    s.arc(A, level, P, label=r"$\beta$")
    s.turn((0, 0, -0.25 * g.l_OA), ground.k, label=r"$\omega$")
    s.axes(O, base, labels="xyz")
    s.dimension(O, A, label=r"$l_{OA}$", offset=0.24 * g.l_OA)
    s.dimension(A, P, label=r"$l_{AP}$", offset=-0.12 * g.l_OA)
    for point in (O, A, P):
        s.label(point, point.name)
