"""2/15: the radius of curvature at the bottom of a loop, from the total acceleration."""

from exercises.tools import mp, on_ground, rate, root, second_rate, size
from newton_euler import Frame, cos, frenet, sin, sqrt


def airplane(g, total):
    """The motion at A, from the magnitude of the acceleration; x forward, y up."""
    ground = Frame("ground")
    upward = sqrt(total**2 - g.v_dot**2)
    return frenet(ground.vector(g.v, 0, 0), ground.vector(g.v_dot, upward, 0))


def solve(g):
    return {"rho": airplane(g, g.n * g.g).radius}


def steps(g):
    a = g.n * g.g
    return {"a": a, "a_n": airplane(g, a).acceleration.y}


def prove(g):
    """The radius for which the acceleration on the circle has this magnitude."""

    def along(rho):
        angle = lambda t: (g.v * t + g.v_dot * t**2 / 2) / rho
        return lambda t: [rho * mp.sin(angle(t)), -rho * mp.cos(angle(t)), 0]

    tight = g.v**2 / (10 * g.n * g.g)
    rho = root(lambda R: size(second_rate(along(R))) - g.n * g.g, tight, 1000 * tight)
    a = second_rate(along(rho))
    up = rate(lambda angle: [mp.sin(angle), -mp.cos(angle), 0], mp.pi / 2)
    return {"rho": rho, "a": size(a), "a_n": sum(x * e for x, e in zip(a, up, strict=True))}


def mistakes(g):
    mi_per_h, ft_per_s = 15, 22  # 15 mi/h are 22 ft/s
    return {
        "all_normal": solve(g.but(v_dot=0 * g.v_dot)),
        "weight_subtracted": solve(g.but(n=g.n - 1)),
        "v_in_mi_h": solve(g.but(v=g.v * mi_per_h / ft_per_s)),
        "v_dot_in_mi_h": solve(g.but(v_dot=g.v_dot * mi_per_h / ft_per_s)),
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    rho = solve(g)["rho"]
    A, C = (0, 0, 0), (0, rho, 0)
    on_loop = lambda angle: (rho * sin(angle), rho * (1 - cos(angle)), 0)
    s.path([on_loop(n / 20) for n in range(-28, 29)], style="dashed")
    outline = [(-0.2, 0.09), (-0.16, 0.03), (0.12, 0.03), (0.19, 0), (0.12, -0.03), (-0.2, -0.03)]
    s.plate([(rho * x, rho * y, 0) for x, y in outline])
    s.vector((0.19 * rho, 0, 0), ground.i, "v")
    s.vector((0.19 * rho, 0.12 * rho, 0), ground.i, r"$\dot v$", kind="acceleration")
    s.dimension(C, A, label=r"$\rho$", offset=0)
    s.dot(A, "A", offset=(0, -18))
    s.dot(C, "C")
