"""2/11: radii of curvature of a jet at the nozzle and at its highest point."""

from exercises.devices import jet
from exercises.tools import mp
from newton_euler import Frame, cos, pi, sin


def places(g):
    """The motion at the nozzle and at the top, where the velocity is horizontal."""
    ground = Frame("ground")
    v = ground.vector(g.v_0 * sin(g.phi), 0, g.v_0 * cos(g.phi))
    return jet.motion(g, ground, v), jet.motion(g, ground, ground.i * v.x)


def solve(g):
    nozzle, top = places(g)
    return {"rho_0": nozzle.radius, "rho_top": top.radius}


def steps(g):
    nozzle, top = places(g)
    return {"a_n": nozzle.acceleration.y, "v_top": top.speed}


def prove(g):
    slope = mp.cot(g.phi)
    places = 0, jet.proved_top(g, g.v_0, slope)
    rho_0, rho_top = (jet.proved_radius(g, g.v_0, slope, x) for x in places)
    on_the_way = {"a_n": g.v_0**2 / rho_0, "v_top": mp.sqrt(g.g * rho_top)}
    return {"rho_0": rho_0, "rho_top": rho_top} | on_the_way


def mistakes(g):
    return {
        "from_the_horizontal": solve(g.but(phi=pi(g.phi) / 2 - g.phi)),
        "full_g": {"rho_0": g.v_0**2 / g.g},
        "nozzle_speed": {"rho_top": g.v_0**2 / g.g},
    }


def draw(g, ax):
    ground = Frame("ground")
    v = ground.vector(g.v_0 * sin(g.phi), 0, g.v_0 * cos(g.phi))
    s, A, far = jet.sketch(g, ax, ground, v)
    up, ahead = (0, 0, 0.25 * far), (0.2 * far * sin(g.phi), 0, 0.2 * far * cos(g.phi))
    s.line(A, up)
    s.arc(A, up, ahead, label=r"$\phi$")
