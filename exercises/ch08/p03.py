"""8/3: a rod between two guides, released from rest."""

from exercises.tools import Sketch, box, let_go, mean, mp, plus, proofs, rot, times
from newton_euler import Frame, bodies, cos, equations_of_motion, moving, pi, sin, solve_linear
from newton_euler.dynamics import ForceSystem, mass_from_weight, resultant_moment, weight


def ladder(g, alpha):
    """Ground, rod, A and B; theta grows as the rod turns counterclockwise."""
    ground = Frame("ground")
    theta = moving(g.theta, rate=0, acceleration=alpha)
    A = ground.point("A", 0, g.L * cos(theta), 0)
    frame = ground.rotate("rod", "z", angle=theta - pi(g.theta) / 2, origin=A)
    AB = bodies.rod(g.L, frame.point("G", g.L / 2, 0, 0), "x", mass=mass_from_weight(g.W, g.g))
    return ground, AB, A, frame.point("B", g.L, 0, 0)


def forces(g, ground, AB, A, B, N_A, N_B):
    return ForceSystem({
        "weight": (weight(AB, ground.j, g.g), AB.centre),
        "A": (N_A * ground.i, A),
        "B": (N_B * ground.j, B),
    })  # fmt: skip


def laws(g, alpha, N_A, N_B):
    ground, AB, A, B = ladder(g, alpha)
    return equations_of_motion(AB, forces(g, ground, AB, A, B, N_A, N_B), ground)


def answers(alpha, N_A, N_B):
    ground = Frame("ground")
    return {"alpha_AB": alpha, "F_A": N_A * ground.i, "F_B": N_B * ground.j}


def solve(g, laws=laws):
    return answers(*solve_linear(lambda alpha, N_A, N_B: laws(g, alpha, N_A, N_B)))


def steps(g):
    ground, AB, _, _ = ladder(g, solve(g)["alpha_AB"])
    return {
        "m": AB.mass,
        "I_G": AB.inertia.moments[2],
        "a_G": AB.centre.acceleration(ground).expressed_in(ground),
    }


def F_A(g, alpha_AB):
    ground, AB, _, _ = ladder(g, alpha_AB)
    return AB.mass * AB.centre.acceleration(ground).dot(ground.i) * ground.i


def F_B(g, alpha_AB):
    ground, AB, _, _ = ladder(g, alpha_AB)
    return (g.W + AB.mass * AB.centre.acceleration(ground).dot(ground.j)) * ground.j


follows = {"F_A": F_A, "F_B": F_B}


def prove(g):
    """By the energy of mass points, then by their momentum."""

    def moved(q, t):
        theta = g.theta + q(t)
        A, turned = [0, g.L * mp.cos(theta), 0], rot("z", theta - mp.pi / 2)
        place = lambda r: plus(A, times(turned, plus(r, [g.L / 2, 0, 0])))
        return [(u, place(r)) for u, r in box(g.L, 0, 0, order=2)]

    def energy(q, t):
        height = sum(u * r[1] for u, r in moved(q, t))
        return proofs.kinetic_energy(g.W / g.g, lambda t: moved(q, t), t) + g.W * height

    alpha = let_go(energy)
    motion = lambda t: moved(lambda t: alpha * t**2 / 2, t)
    F_x, F_y, _ = proofs.force_needed(g.W / g.g, motion)
    return {
        "alpha_AB": alpha,
        "F_A": [F_x, 0, 0],
        "F_B": [0, F_y + g.W, 0],
        "I_G": g.W / g.g * mean(lambda r: r[0] ** 2, box(g.L, 0, 0)),
        "a_G": proofs.second_rate(lambda t: plus(*([u * x for x in r] for u, r in motion(t)))),
    }


def about_A_at_rest(g, alpha, N_A, N_B):
    ground, AB, A, B = ladder(g, alpha)
    system = forces(g, ground, AB, A, B, N_A, N_B)
    needed = resultant_moment(AB, ground, about=A).without("reference")
    return {
        "force": equations_of_motion(AB, system, ground)["force on rod"],
        "moment": system.moment(A) - needed.expressed_in(ground),
    }


def G_falls_straight(g, alpha, N_B):
    force, moment = laws(g, alpha, 0, N_B).values()
    return {"upward": force.y, "moment": moment}


def mistakes(g):
    right = solve(g)
    straight = solve_linear(lambda alpha, N_B: G_falls_straight(g, alpha, N_B))
    level = solve(g.but(theta=pi(g.theta) / 2 - g.theta))
    del level["F_A"]  # with sin(theta) cos(theta)
    static = answers(right["alpha_AB"], 0, g.W)
    return {
        "A_fixed": solve(g, about_A_at_rest),
        "as_in_statics": {"F_A": static["F_A"], "F_B": static["F_B"]},
        "G_falls_straight": answers(straight.alpha, 0, straight.N_B),
        "weight_as_mass": {"alpha_AB": right["alpha_AB"] / g.stated("g")},
        "theta_from_the_level": level,
    }


def draw(g, ax):
    ground, _, A, B = ladder(g, 0)
    s = Sketch(ax, ground, plane="xy")
    w, O = 0.03 * g.L, (0, 0, 0)
    x, y, far = g.L * sin(g.theta), g.L * cos(g.theta), 1.15 * g.L * cos(g.theta)
    s.shaft(O, (0, far, 0))
    s.shaft(O, (max(1.3 * x, 0.5 * g.L), 0, 0))
    for P, (a, b) in (((0, y, 0), (2 * w, 4 * w)), ((x, 0, 0), (4 * w, 2 * w))):
        s.box(P, ground, (a, b, 2 * w))
    s.rod(A, B)
    s.hinge(A)
    s.hinge(B)
    s.arc(A, O, B, label=r"$\theta$")
    s.dimension(A, B, label="L", offset=0.15 * g.L)
    s.label(A, "A", offset=(-18, 0))
    s.label(B, "B", offset=(0, -18))
    s.label(O, "O", offset=(-10, -10))
