"""2/12: the speed of a jet from its curvature."""

from exercises.devices import jet
from exercises.tools import mp, root
from newton_euler import Frame, sqrt

follows = {"rho_top": lambda g, v_0: top(g, v_0)}


def direction(g):
    """The ground, and the unit vector along the nozzle."""
    ground = Frame("ground")
    e = ground.vector(g.c, 0, g.b)
    return ground, e / e.norm()


def normal_acceleration(g):
    """The normal acceleration at the nozzle, independent of the speed."""
    ground, e = direction(g)
    return jet.motion(g, ground, e).acceleration.y


def top(g, v_0):
    """The radius of curvature at the top, where the velocity is horizontal."""
    ground, e = direction(g)
    return jet.motion(g, ground, ground.i * (v_0 * e.x)).radius


def solve(g):
    v_0 = sqrt(g.rho_0 * normal_acceleration(g))
    return {"v_0": v_0, "rho_top": top(g, v_0)}


def steps(g):
    return {"a_n": normal_acceleration(g), "v_top": solve(g)["v_0"] * direction(g)[1].x}


def prove(g):
    """The speed for which the curve z(x) has the given curvature."""
    slope = g.b / g.c
    v_0 = root(lambda v: jet.proved_radius(g, v, slope, 0) - g.rho_0, 1e-2, 1e3)
    rho_top = jet.proved_radius(g, v_0, slope, jet.proved_top(g, v_0, slope))
    on_the_way = {"a_n": v_0**2 / g.rho_0, "v_top": mp.sqrt(g.g * rho_top)}
    return {"v_0": v_0, "rho_top": rho_top} | on_the_way


def mistakes(g):
    _, e = direction(g)
    fast, slow = sqrt(g.g * g.rho_0), sqrt(g.g * g.rho_0 * e.z)
    return {
        "full_g": {"v_0": fast, "rho_top": top(g, fast)},
        "sine": {"v_0": slow, "rho_top": top(g, slow)},
        "nozzle_speed": {"rho_top": solve(g)["v_0"] ** 2 / g.g},
    }


def draw(g, ax):
    ground, e = direction(g)
    s, A, far = jet.sketch(g, ax, ground, e * solve(g)["v_0"])
    back, corner = (-0.2 * far, 0, -0.2 * far * g.b / g.c), (0, 0, -0.2 * far * g.b / g.c)
    s.line(back, A, style="solid")
    s.line(back, corner, style="solid")
    s.line(corner, A, style="solid")
    s.dimension(back, corner, "c", offset=-0.05 * far)
    s.dimension(corner, A, "b", offset=-0.05 * far)
