"""4/9: a rod with one end on an axis and the other on an ellipse."""

from exercises.tools import Sketch, in_frame, mp, plus, rate, scaled
from newton_euler import Frame, cos, moving, pi, sin, solve_rates, sqrt


def lower_end(g):
    """x and y of the lower end: on the ellipse, at rho^2 = L^2 - z^2 from the centre."""
    rho_squared = g.L**2 - g.z_1**2
    across = g.b**2 - g.a**2
    return g.a * sqrt((g.b**2 - rho_squared) / across), g.b * sqrt((rho_squared - g.a**2) / across)


def ends(g, x_dot, y_dot):
    """Ground, the end A on the z axis, and the end B with these rates of its x and y."""
    ground = Frame("ground")
    x, y = lower_end(g)
    A = ground.point("A", 0, 0, moving(g.z_1, rate=g.z_dot))
    return ground, A, ground.point("B", moving(x, rate=x_dot), moving(y, rate=y_dot), 0)


def rod(g):
    """Ground, the ends A on the z axis and B on the ellipse, and the middle M."""

    # the rod keeps its length, and B moves along the tangent of the ellipse
    def violated(x_dot, y_dot):
        ground, A, B = ends(g, x_dot, y_dot)
        v_A, v_B = A.velocity(ground), B.velocity(ground)
        x, y, _ = B.position(ground)
        return (B - A).dot(v_B - v_A), ground.vector(x / g.a**2, y / g.b**2, 0).dot(v_B)

    ground, A, B = ends(g, *solve_rates(violated, 2))
    return ground, A, B, ground.point("M", *((a + b) / 2 for a, b in zip(A.x, B.x, strict=True)))


def solve(g):
    ground, _, _, M = rod(g)
    return in_frame(ground, {"v_mid": M.velocity(ground)})


def steps(g):
    ground, A, B, _ = rod(g)
    x, y = lower_end(g)
    v_A, v_B = (P.velocity(ground).expressed_in(ground) for P in (A, B))
    return {"rho": sqrt(g.L**2 - g.z_1**2), "x": x, "y": y, "v_A": v_A, "v_B": v_B}


def prove(g):
    def lower(t):
        z = g.z_1 + g.z_dot * t
        # phi: eccentric angle of the lower end
        too_long = lambda phi: (g.a * mp.cos(phi)) ** 2 + (g.b * mp.sin(phi)) ** 2 + z**2 - g.L**2
        phi = mp.findroot(too_long, (mp.mpf(0), mp.pi / 2), solver="anderson", maxsteps=200)
        return [g.a * mp.cos(phi), g.b * mp.sin(phi), mp.mpf(0)]

    middle = lambda t: scaled(mp.mpf(1) / 2, plus(lower(t), [0, 0, g.z_1 + g.z_dot * t]))
    x, y, _ = lower(0)
    found = {"x": x, "y": y, "rho": mp.hypot(x, y), "v_B": rate(lower)}
    return {"v_mid": rate(middle)} | found


def mistakes(g):
    ground, A, B, _ = rod(g)
    v_A, v_B = A.velocity(ground), B.velocity(ground)
    inward = ground.origin - B
    straight = inward * (g.z_1 * g.z_dot / inward.dot(inward))
    wrong = {
        "no_half": {"v_mid": v_A + v_B},
        "upper_end_at_rest": {"v_mid": v_B / 2},
        "lower_end_outward": {"v_mid": (v_A - v_B) / 2},
        "lower_end_straight": {"v_mid": (v_A + straight) / 2},
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    ground, A, B, M = rod(g)
    O = (0, 0, 0)
    quarter = [(g.a * cos(n * pi() / 80), g.b * sin(n * pi() / 80), 0) for n in range(41)]
    s = Sketch(ax, ground, azimuth=18, elevation=25)
    s.axes(O, ground, length=1.2 * g.b)
    s.path(quarter)
    s.rod(A, B)
    s.vector(A, A.velocity(ground), r"$\dot z$")
    s.dimension(O, A, label="$z_1$")
    s.dimension(A, B, label="L", offset=0.2 * g.L)
    s.label(quarter[0], "$a$", offset=(-2, 10))
    s.label(quarter[-1], "$b$", offset=(2, 10))
    s.dot(M, "M", offset=(10, 8))
