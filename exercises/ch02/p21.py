"""2/21: a rocket that climbs vertically, seen by a radar: from one component to the whole."""

from exercises.tools import Sketch, mp, rate, root, second_rate
from newton_euler import Frame, moving, polar


def rocket(g):
    """Ground with y up, and rocket; r' and theta'' enter only components that are not used."""
    ground = Frame("ground")
    r, theta = moving(g.r, acceleration=g.r_ddot), moving(g.theta, rate=g.theta_dot)
    return ground, polar(ground, "P", r, theta)


def measured(g):
    """The measured components: velocity across the line of sight, acceleration along it."""
    ground, P = rocket(g)
    return P.velocity(ground).y, P.acceleration(ground).x


def solve(g):
    ground, P = rocket(g)
    along, across, _ = ground.j.components(P.local)
    v_theta, a_r = measured(g)
    return {"v": v_theta / across, "a": a_r / along}


def steps(g):
    v_theta, a_r = measured(g)
    return {"v_theta": v_theta, "a_r": a_r}


def prove(g):
    """The vertical climb over time that gives the radar's readings."""
    away, up = g.r * mp.cos(g.theta), g.r * mp.sin(g.theta)
    height = lambda v, a: lambda t: up + v * t + a * t**2 / 2
    elevation = lambda y: lambda t: mp.atan2(y(t), away)
    distance = lambda y: lambda t: mp.hypot(away, y(t))
    fast = 100 * g.r * g.theta_dot
    v = root(lambda v: rate(elevation(height(v, 0))) - g.theta_dot, 0, fast)
    a = root(lambda a: second_rate(distance(height(v, a))) - g.r_ddot, -fast, fast)
    return {"v": v, "a": a, "v_theta": v * mp.cos(g.theta), "a_r": a * mp.sin(g.theta)}


def mistakes(g):
    right, (v_theta, _) = solve(g), measured(g)
    ground, P = rocket(g)
    a_r = P.acceleration(ground).without("centripetal").x
    along, across, _ = ground.j.components(P.local)
    return {
        "transverse_alone": {"v": v_theta},
        "r_ddot_alone": {"a": g.r_ddot},
        "no_centripetal": {"a": a_r / along},
        "sine_for_cosine": {"v": right["v"] * across / along, "a": right["a"] * along / across},
    }


def draw(g, ax):
    ground, P = rocket(g)
    s = Sketch(ax, ground, plane="xy")
    O, (x, y, _) = (0, 0, 0), P.position(ground)
    s.road([(-0.15 * g.r, 0, 0), (x + 0.3 * g.r, 0, 0)])
    s.line((x, 0, 0), (x, 1.2 * y, 0))
    s.line(O, P, style="solid")
    wide, high = 0.02 * g.r, 0.07 * g.r
    sides = [(-wide, -high), (wide, -high), (wide, high / 2), (0, high), (-wide, high / 2)]
    s.plate([(x + u, y + w, 0) for u, w in sides])
    s.arc(O, (x, 0, 0), P, label=r"$\theta$")
    s.label((0.6 * x, 0.6 * y, 0), "$r$", offset=ground.vector(-y, x, 0), bold=False)
    s.swing(O, (0.4 * x, 0.4 * y, 0), ground.k, label=r"$\dot\theta$")
    s.dot(O, "O", offset=(-12, 10))
    s.label(P, "P", offset=(16, 0))
