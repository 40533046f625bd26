"""2/2: constant speed along a spiral."""

from exercises.devices.plane_curve import at_constant_speed as proved_motion
from exercises.tools import cross, mp, on_ground, size
from newton_euler import Frame, cos, moving, polar, sin
from newton_euler.kinematics import speed_rate


def motion(g, theta, ground=None):
    """Velocity and acceleration along e_r, e_theta, for an angle with its rates."""
    ground = ground or Frame("ground")
    P = polar(ground, "P", g.A * theta, theta)
    return P.velocity(ground), P.acceleration(ground)


def rates(g, theta):
    """theta' from the speed; theta'' makes the acceleration normal to the velocity."""
    v, a = motion(g, moving(theta, rate=g.one))  # per rad and per rad^2
    theta_dot = g.v / v.norm()
    return theta_dot, -(theta_dot**2) * a.dot(v) / v.dot(v)


def at_constant_speed(g, theta, ground=None):
    return motion(g, moving(theta, *rates(g, theta)), ground)


def radius(g, theta_dot, a):
    """The radius of curvature; |v x a| is the speed times the normal acceleration."""
    return g.v**3 / (g.A * theta_dot * (a.y - g.theta * a.x))


def solve(g):
    v, a = at_constant_speed(g, g.theta)
    rho = radius(g, rates(g, g.theta)[0], a)
    return {"a_t": speed_rate(v, a), "a_n": g.v**2 / rho}


def steps(g):
    theta_dot, theta_ddot = rates(g, g.theta)
    a = at_constant_speed(g, g.theta)[1]
    angle = {"thetadot": theta_dot, "thetaddot": theta_ddot}
    return {**angle, "a_r": a.x, "a_theta": a.y, "rho": radius(g, theta_dot, a)}


def prove(g):
    place = lambda theta: [g.A * theta * mp.cos(theta), g.A * theta * mp.sin(theta), 0]
    v, a = proved_motion(place, g.theta, g.v)
    along = sum(x * y for x, y in zip(v, a, strict=True)) / g.v
    across = size(cross(v, a)) / g.v
    return {"a_t": along, "a_n": across, "rho": g.v**2 / across}


def mistakes(g):
    v, a = motion(g, moving(g.theta, rate=rates(g, g.theta)[0]))
    right = at_constant_speed(g, g.theta)[1]
    return {
        "rho_is_r": {"a_n": g.v**2 / (g.A * g.theta)},
        "uniform_angle": {"a_t": speed_rate(v, a)},
        "polar_components": {"a_t": right.y, "a_n": -right.x},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    place = lambda theta: (g.A * theta * cos(theta), g.A * theta * sin(theta), 0)
    theta = 2.3  # on the first turn, with room for labels
    O, P = (0, 0, 0), place(theta)
    s.axes(O, ground, length=3.2 * g.A, labels=["x", "y", ""])
    s.path([place(4.6 * n / 120) for n in range(121)])
    s.arrow(O, P, "r")
    s.arc(O, (1, 0, 0), P, label=r"$\theta$")
    v, _ = at_constant_speed(g, theta, ground)
    s.vector(P, v, "v")
    s.label(O, "O")
    s.dot(P, "P")
