"""10/14: a spinning disk falling over on a cross shaft, and its bearing forces."""

from exercises.tools import minus, mp, mpf, on_ground, plus, proofs, rot, scaled, times
from newton_euler import ForceSystem, Frame, particle, pi, solve_linear, sqrt
from newton_euler.bodies import disk
from newton_euler.dynamics import resultant_force, resultant_moment, weight

follows = {"F_B": lambda g, F_A: F_A.frame.vector(*needed(g, *fall(g))[0]) - F_A}


def scene(g, rate=0, acceleration=0, spin=0, mass=1):
    """Ground with x along the shaft and z up, and the disk; z of its frame is from O to it."""
    ground = Frame("ground")
    level = pi(g.r) / 2
    shafts = ground.rotate("shafts", "-x", angle=level, rate=rate, acceleration=acceleration)
    turned = shafts.rotate("disk", "z", rate=spin, origin=shafts.point("C", 0, 0, g.b))
    return ground, disk(g.r, turned, "z", mass=mass)


def as_particle(g):
    ground, body = scene(g, mass=g.m)
    return ground, particle(g.m, body.frame.point("G", 0, 0, 0))


def about_shaft(g, body):
    return body.about(body.frame.point("O", 0, 0, -g.b)).moment("x")


def fall(g, scene=lambda g: scene(g, mass=g.m)):
    """theta_dot and theta_ddot, by work and moment of the weight, independent of the spin."""
    ground, body = scene(g)
    I_0, arm = about_shaft(g, body), body.centre.position(ground).y
    return sqrt(2 * g.m * g.g * arm / I_0), g.m * g.g * arm / I_0


def needed(g, rate, acceleration):
    """The force without the weight, and the moment about O, that the bearings must exert."""
    ground, body = scene(g, rate, acceleration, g.P, g.m)
    force = resultant_force(g.m, body.centre.acceleration(ground)).expressed_in(ground)
    moment = resultant_moment(body, ground, about=ground.point("O", 0, 0, 0))
    return force - weight(g.m, ground.k, g.g), moment.expressed_in(ground)


def bearings(g, force, moment):
    ground = force.frame
    O, A, B = (ground.point("", x, 0, 0) for x in (0, -g.c / 2, g.c / 2))

    def balance(A_y, A_z, B_y, B_z):
        at_A, at_B = ground.vector(0, A_y, A_z), ground.vector(0, B_y, B_z)
        forces = ForceSystem({"A": (at_A, A), "B": (at_B, B)})
        off, turning = forces.force - force, forces.moment(O) - moment
        return {"y": off.y, "z": off.z, "about y": turning.y, "about z": turning.z}

    s = solve_linear(balance)
    return {"F_A": ground.vector(0, s.A_y, s.A_z), "F_B": ground.vector(0, s.B_y, s.B_z)}


def solve(g):
    return bearings(g, *needed(g, *fall(g)))


def steps(g):
    rate, acceleration = fall(g)
    force, moment = needed(g, rate, acceleration)
    motion = {"theta_dot": rate, "theta_ddot": acceleration}
    return {"I_0": about_shaft(g, scene(g, mass=g.m)[1]), **motion, "R_AB": force, "M_z": moment.z}


def prove(g):
    """The fall by integrating the moment of the weights; each force by moments about the other."""
    plate = proofs.disk(g.r, order=2)

    def body(theta, spin):
        outer, inner = rot([-1, 0, 0], theta), rot("z", spin)
        return [(u, times(outer, plus(times(inner, p), [0, 0, g.b]))) for u, p in plate]

    downward = lambda moment: -moment[0]  # about -x, in which theta grows

    def of_weights(theta, about=(0, 0, 0)):
        arm = minus(proofs.mean(lambda p: p, body(theta, 0)), about)
        return proofs.cross(arm, [0, 0, -g.m * g.g])

    def moment(theta, rate, acceleration, about=(0, 0, 0)):
        motion = lambda t: body(theta + rate * t + acceleration * t**2 / 2, g.P * t)
        return proofs.moment_needed(g.m, motion, about)

    level, any_angle, unit = mp.pi / 2, mpf("0.7"), g.g / g.b
    inertia = downward(moment(any_angle, 0, unit)) / unit  # the same at all angles and rates
    at_angles = proofs.box(level, 0, 0, order=20)
    work = level * proofs.mean(lambda p: downward(of_weights(p[0] + level / 2)), at_angles)
    rate = mp.sqrt(2 * work / inertia)
    lacking = lambda a: downward(minus(moment(level, rate, a), of_weights(level)))
    acceleration = proofs.vanishing(lacking, 0, unit)

    def force_across(x):
        """The force at distance c from the point x of the shaft, by the moment about x."""
        about = (x, 0, 0)
        _, M_y, M_z = minus(moment(level, rate, acceleration, about), of_weights(level, about))
        return scaled(-1 / (2 * x), [0, M_z, -M_y])

    F_A, F_B = force_across(g.c / 2), force_across(-g.c / 2)
    return {
        "F_A": F_A,
        "F_B": F_B,
        "I_0": inertia,
        "theta_dot": rate,
        "theta_ddot": acceleration,
        "R_AB": plus(F_A, F_B),
        "M_z": moment(level, rate, acceleration)[2],
    }


def mistakes(g):
    force, moment = needed(g, *fall(g))
    ground = force.frame
    return {
        "no_gyroscopic_couple": bearings(g, force, moment * 0),
        "no_centripetal": bearings(g, ground.vector(0, 0, force.z), moment),
        "whole_weight": bearings(g, ground.vector(0, force.y, g.m * g.g), moment),
        "as_particle": bearings(g, *needed(g, *fall(g, as_particle))),
        "other_sense": solve(g.but(P=-g.P)),
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=-35, elevation=18)
    b, c, r, theta = 1.0, 1.8, 0.55, 0.8  # theta: anywhere
    shafts = ground.rotate("shafts", "-x", angle=theta)
    A, B, O = (-c / 2, 0, 0), (c / 2, 0, 0), (0, 0, 0)
    C = shafts.point("C", 0, 0, b)
    s.shaft((-0.7 * c, 0, 0), (0.7 * c, 0, 0))
    for end, name in ((A, "A"), (B, "B")):
        s.hinge(end, axis=ground.i)
        s.label(end, name, offset=(0, -14))
    s.rod(O, shafts.point("", 0, 0, 1.45 * b))
    s.disk(C, shafts.k, r)
    s.turn(shafts.point("", 0, 0, 1.25 * b), shafts.k, label="P")
    s.line(O, (0, 0, 1.2 * b))
    s.arc(O, ground.k, C, label=r"$\theta$")
    s.axes((-1.1 * c, 0, 0), ground, length=0.5 * b)
    s.label(O, "O", offset=(0, -14))
    s.dimension(C, shafts.point("", r, 0, b), label="r", offset=0)
    s.dimension(O, C, label="b", offset=0.3 * b)
    s.dimension((-c / 2, 0, -0.35 * b), (c / 2, 0, -0.35 * b), label="c", offset=0)
