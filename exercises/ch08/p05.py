"""8/5: a bar leaning on the headboard of an accelerating truck."""

from exercises.tools import box, mp, mpf, on_ground, plus, proofs, rot, times, vanishing
from newton_euler import Frame, bodies, cos, equations_of_motion, moving, sin, solve_linear
from newton_euler.dynamics import ForceSystem, resultant_moment, weight


def limit(g, mu_B, A_at_rest=False):
    """a, and n_A and n_B, the normal forces over the weight, with friction mu n_A forward at A and
    mu_B n_B upward at B, for the unit of mass and of length.

    A_at_rest : the mistake of moments about A as if it were at rest
    """

    def laws(a, n_A, n_B):
        ground = Frame("ground")
        A = ground.point("A", moving(0, rate=0, acceleration=a), 0, 0)
        frame = ground.translate("truck", A).rotate("bar", "z", angle=g.theta)
        bar = bodies.rod(g.one, frame.point("G", g.one / 2, 0, 0), "x", mass=g.one, name="bar")
        N_A, N_B = n_A * g.g, n_B * g.g
        forces = ForceSystem({
            "weight": (weight(bar, ground.j, g.g), bar.centre),
            "A": (ground.vector(g.mu * N_A, N_A, 0), A),
            "B": (ground.vector(-N_B, mu_B * N_B, 0), frame.point("B", g.one, 0, 0)),
        })  # fmt: skip
        equations = equations_of_motion(bar, forces, ground, about=A)
        if not A_at_rest:
            return equations
        needed = resultant_moment(bar, ground, about=A).without("reference")
        moment = forces.moment(A) - needed.expressed_in(ground)
        return {"force": equations["force on bar"], "moment": moment}

    return solve_linear(laws)


def solve(g):
    return {"a_max": limit(g, g.mu).a}


def steps(g):
    found = limit(g, g.mu)
    return {"n_B": found.n_B, "n_A": found.n_A}


def prove(g):
    """The greatest acceleration, over all shares of friction at B, that the bed can give A."""
    length, B = mpf(1), [mp.cos(g.theta), mp.sin(g.theta), 0]
    half = [length / 2, 0, 0]
    points = [(u, times(rot("z", g.theta), plus(half, r))) for u, r in box(length, 0, 0, order=2)]

    def contact(a, share):
        """F_A, N_A and N_B per unit mass."""
        motion = lambda t: [(u, plus([a * t**2 / 2, 0, 0], r)) for u, r in points]
        of_weight = -g.g * sum(u * r[0] for u, r in points)
        arm = B[1] + share * g.mu * B[0]
        N_B = (proofs.moment_needed(1, motion)[2] - of_weight) / arm
        F_x, F_y, _ = proofs.force_needed(1, motion)
        return F_x + N_B, F_y + g.g - share * g.mu * N_B, N_B

    def greatest(share):
        def lack(a):
            F_A, N_A, _ = contact(a, share)
            return F_A - g.mu * N_A

        return vanishing(lack, 0, g.g), share

    a, share = max(greatest(mpf(n) / 8) for n in range(-8, 9))
    _, N_A, N_B = contact(a, share)
    return {"a_max": a, "n_A": N_A / g.g, "n_B": N_B / g.g}


def mistakes(g):
    return {
        "smooth_headboard": {"a_max": limit(g, 0).a},
        "A_at_rest": {"a_max": limit(g, g.mu, A_at_rest=True).a},
        "block": {"a_max": g.mu * g.g},
        "friction_down": {"a_max": limit(g, -g.mu).a},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    x, y = cos(g.theta), sin(g.theta)
    A, B, front = (0, 0, 0), (x, y, 0), x + 0.012
    cab = [(front + 0.06, -0.1, 0), (front + 0.75, -0.1, 0), (front + 0.75, 0.4, 0),
           (front + 0.5, 0.45, 0), (front + 0.4, 0.85, 0), (front + 0.06, 0.85, 0)]  # fmt: skip
    s.plate(cab, shade="light")
    s.box((front + 0.03, 0.5, 0), ground, (0.06, 1.2, 0.1))
    s.box(((front - 0.9) / 2, -0.06, 0), ground, (front + 0.9, 0.1, 0.1))
    for wheel in (-0.5, front + 0.45):
        s.disk((wheel, -0.27, 0), ground.k, 0.16)
    s.road([(-1, -0.43, 0), (front + 0.95, -0.43, 0)])
    s.rod(A, B)
    s.arc(A, (x, 0, 0), B, label=r"$\theta$")
    s.vector((front + 0.75, 0.15, 0), (0.3, 0, 0), "a", kind="acceleration")
    s.label(A, "A", offset=(-8, 8))
    s.label(B, "B", offset=(-9, 4))
