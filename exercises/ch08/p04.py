"""8/4: the forces on the connecting rod of an engine at top dead centre."""

from exercises.tools import Sketch, box, minus, mp, plus, proofs, root, scaled, second_rate
from newton_euler import Frame, asin, bodies, equations_of_motion, moving, pi, sin, solve_linear
from newton_euler.dynamics import mass_from_weight, reaction, resultant_force


def engine(g, theta=None):
    """Ground, crank, the connecting rod, B and O."""
    ground = Frame("ground")
    theta = moving(0 * pi(g.l), rate=g.n) if theta is None else theta
    crank = ground.rotate("crank", "z", angle=theta)
    B = crank.point("B", g.b, 0, 0)
    # the rod leans back to the axis of the cylinder
    link = crank.rotate("rod", "-z", angle=theta + asin(g.b / g.l * sin(theta)), origin=B)
    m = mass_from_weight(g.W_R, g.g)
    bar = bodies.rod(g.l, link.point("G", g.l / 2, 0, 0), "x", mass=m, name="rod")
    return ground, bar, B, link.point("O", g.l, 0, 0)


def force_at_O(g, a_O):
    """The force at O along the cylinder, from the motion of the piston."""
    return -resultant_force(mass_from_weight(g.W_P, g.g), a_O)


def solve(g, F_x=None):
    """F_B and F_O; ``F_x``: a wrong component of F_O along the cylinder."""
    ground, bar, B, O = engine(g)
    F_x = force_at_O(g, O.acceleration(ground)).dot(ground.i) if F_x is None else F_x

    def laws(B_x, B_y, O_x, O_y):
        at_B, at_O = ground.vector(B_x, B_y, 0), ground.vector(O_x, O_y, 0)
        of_rod = equations_of_motion(bar, {"B": (at_B, B), "O": (at_O, O)}, ground)
        return {**of_rod, "piston": O_x - F_x}

    found = solve_linear(laws)
    return {f"F_{end}": ground.vector(found[f"{end}_x"], found[f"{end}_y"], 0) for end in "BO"}


def steps(g):
    ground, bar, B, O = engine(g)
    yield "m_P", mass_from_weight(g.W_P, g.g)
    yield "m_R", bar.mass
    yield "omega_BO", bar.frame.angular_velocity(ground).expressed_in(ground)
    for P in (B, O, bar.centre):
        yield f"a_{P.name}", P.acceleration(ground).expressed_in(ground)


def prove(g):
    """The explicit motion: O is where the rod, of fixed length, meets the axis."""
    half = mp.mpf(1) / 2
    B = lambda t: [g.b * mp.cos(g.n * t), g.b * mp.sin(g.n * t), 0]

    def piston(t):
        x, y, _ = B(t)
        return [root(lambda s: (s - x) ** 2 + y**2 - g.l**2, g.l, g.l + 2 * g.b), 0, 0]

    at = lambda share, t: plus(scaled(1 - share, B(t)), scaled(share, piston(t)))
    motion = lambda t: [(u, at(half + x, t)) for u, (x, _, _) in box(1, 0, 0, order=2)]
    a_O = second_rate(piston)
    F_x = -g.W_P / g.g * a_O[0]
    F_y = proofs.moment_needed(g.W_R / g.g, motion, B(0))[2] / g.l
    return {
        "F_B": minus(proofs.force_needed(g.W_R / g.g, motion), [F_x, F_y, 0]),
        "F_O": [F_x, F_y, 0],
        "a_B": second_rate(B),
        "a_O": a_O,
        "a_G": second_rate(lambda t: at(half, t)),
    }


def mistakes(g):
    ground, bar, B, _ = engine(g)
    right, a_B = solve(g), B.acceleration(ground)
    F_O = ground.vector(*right["F_O"].components())
    return {
        "piston_as_B": solve(g, force_at_O(g, a_B).dot(ground.i)),
        "G_as_B": {"F_B": reaction(bar.mass, a_B.expressed_in(ground), O=F_O)},
        "force_on_the_piston": {"F_O": -right["F_O"]},
        "rpm_as_rad": solve(g.but(n=g.stated("n"))),
        "inches": {key: 12 * F for key, F in right.items()},  # 12 in = 1 ft
    }


def draw(g, ax):
    ground, _, B, O = engine(g, 0.7)
    s = Sketch(ax, ground, plane="xy")
    A, w = (0, 0, 0), 0.13 * g.l
    x = O.position(ground).x
    s.line((-0.15 * g.l, 0, 0), (x + 0.55 * g.l, 0, 0), style="centre")
    for side in (1, -1):
        wall = [(x - 0.4 * g.l, side * w, 0), (x + 0.5 * g.l, side * w, 0)]
        s.road(wall[::-side])
    s.box((x + 0.6 * w, 0, -2 * w), ground, (2.4 * w, 2 * w, 2 * w))
    s.rod(A, B, O)
    s.hinge(A)
    s.hinge(B)
    s.hinge(O)
    s.arc(A, O, B, label=r"$\theta$")
    s.swing(A, (-0.5 * g.b, 0.3 * g.b, 0), ground.k, label="n")
    s.dimension(A, B, label="b", offset=0.2 * g.l)
    s.dimension(B, O, label="l", offset=0.25 * g.l)
    s.label(A, "A", offset=(6, -12))
    s.label(B, "B", offset=(4, -17))
    s.label(O, "O", offset=(0, -13))
    s.label((x + 1.4 * w, 0, 0), "P", offset=(0, 9))
