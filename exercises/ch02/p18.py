"""2/18: a rocket on the radar: its heading, a word, and the curvature of its path."""

from exercises.tools import at_angle, cross, on_ground, rate, second_rate, size
from newton_euler import Frame, cos, moving, sin
from newton_euler.kinematics import flexure, polar


def rocket(g):
    """Velocity and acceleration along e_r, e_theta; rho does not depend on r''."""
    ground = Frame("ground")
    theta = moving(0 * g.one, rate=g.theta_dot, acceleration=g.theta_ddot)
    P = polar(ground, "P", moving(g.r, rate=g.r_dot), theta)
    return P.velocity(ground), P.acceleration(ground)


def heading(along, across):
    """The word, from the velocity along the line of sight and across it."""
    if abs(across) > abs(along):
        return "across"
    return "away" if along > 0 else "toward"


def solve(g):
    v, a = rocket(g)
    return {"heading": lambda: heading(v.x, v.y), "rho": 1 / flexure(v, a)}


def steps(g):
    v, a = rocket(g)
    return {"v": v, "a": a}


def prove(g):
    theta = lambda t: g.theta_dot * t + g.theta_ddot * t**2 / 2
    place = lambda t: at_angle(g.r + g.r_dot * t, theta(t))
    v = rate(place)
    rho = size(v) ** 3 / size(cross(v, second_rate(place)))
    return {"heading": lambda: heading(v[0], v[1]), "rho": rho}


def mistakes(g):
    return {
        "rho_is_r": {"rho": g.r},
        "no_r": {"rho": g.r_dot**2 / abs(g.theta_ddot)},
        "negative": {"rho": -solve(g)["rho"]},
        "toward": {"heading": "toward"},
        "across": {"heading": "across"},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    sight = ground.vector(cos(0.7), 0, sin(0.7))
    down = ground.vector(sin(0.7), 0, -cos(0.7))
    rho = solve(g)["rho"]
    P = [g.r * x for x in sight.components()]

    def on_path(angle):
        along, below = rho * sin(angle), rho * (1 - cos(angle))
        return tuple(p + along * x + below * y for p, x, y in
                     zip(P, sight.components(), down.components(), strict=True))  # fmt: skip

    far = 0.5 * g.r / rho
    O = (0, 0, 0)
    s.road([(-0.15 * g.r, 0, 0), (g.r, 0, 0)])
    s.line(O, P)
    s.path([on_path(far * n / 40) for n in range(-16, 25)])
    s.arc(O, (g.r, 0, 0), P, label=r"$\theta$")
    s.dimension(O, P, label="r", offset=-0.08 * g.r)
    s.dot(O, "O", offset=(-12, 10))
    s.dot(P, "P", offset=(-12, 6))
    s.label(O, "radar", offset=(-30, -14), bold=False)
    s.label(P, "rocket", offset=(-14, 22), bold=False)
