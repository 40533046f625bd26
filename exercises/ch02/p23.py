"""2/23: a pin that moves on a straight line at constant speed, in polar coordinates."""

from exercises.tools import Sketch, mp, rate, second_rate
from newton_euler import Frame, sin
from newton_euler.kinematics import cylindrical_frame, polar_coordinates

follows = {  # both components of the acceleration are zero
    "r_ddot": lambda g, theta_dot: motion(g)[0].x * theta_dot**2,
    "theta_ddot": lambda g, r_dot, theta_dot: -2 * r_dot * theta_dot / motion(g)[0].x,
}


def axes(g):
    """The ground, with x to the right and y up, and the axes e_r, e_theta."""
    ground = Frame("ground")
    return ground, cylindrical_frame(ground, g.theta)


def rates(position, velocity):
    """The four answers, for zero acceleration."""
    r, theta = polar_coordinates(position, velocity, 0 * velocity)
    rates = {"r_dot": r.rate, "theta_dot": theta.rate}
    return rates | {"r_ddot": r.acceleration, "theta_ddot": theta.acceleration}


def motion(g):
    """Position and velocity of A, along e_r, e_theta."""
    ground, local = axes(g)
    return local.vector(g.h / sin(g.theta), 0, 0), ground.vector(g.v, 0, 0).expressed_in(local)


def solve(g):
    return rates(*motion(g))


def steps(g):
    r, v = motion(g)
    return {"r": r.x, "v_A": v}


def prove(g):
    """Distance and direction of A over time."""
    start = g.h / mp.tan(g.theta)
    r = lambda t: mp.hypot(start + g.v * t, g.h)
    theta = lambda t: mp.atan2(g.h, start + g.v * t)
    answers = {"r_dot": rate(r), "theta_dot": rate(theta)}
    return answers | {"r_ddot": second_rate(r), "theta_ddot": second_rate(theta), "r": r(0)}


def mistakes(g):
    right, (r, v) = solve(g), motion(g)
    local = r.frame
    swapped = rates(r, local.vector(-v.y, -v.x, 0))
    up, short = rates(r, local.vector(v.x, -v.y, 0)), rates(local.vector(g.h, 0, 0), v)
    return {
        "second_rates_zero": {"r_ddot": 0 * right["r_ddot"], "theta_ddot": 0 * right["theta_ddot"]},
        "theta_grows": {"theta_dot": up["theta_dot"], "theta_ddot": up["theta_ddot"]},
        # theta'', which has the product of both components, is right
        "sine_for_cosine": {key: swapped[key] for key in ("r_dot", "theta_dot", "r_ddot")},
        "r_is_h": {key: short[key] for key in ("theta_dot", "r_ddot", "theta_ddot")},
    }


def draw(g, ax):
    ground, local = axes(g)
    s = Sketch(ax, ground, plane="xy")
    O, A = ground.point("O", 0, 0, 0), local.point("A", *motion(g)[0].components())
    x, y, _ = A.position(ground)
    left = -1.1 * g.h
    s.line(O, (x + 0.9 * g.h, 0, 0))
    s.rod(O, ground.point("end", 1.35 * x, 1.35 * y, 0))
    s.cylinder((left - 0.7 * g.h, y, 0), (left, y, 0), 0.13 * g.h)
    s.rod((left, y, 0), A)
    s.hinge(O)
    s.vector(A, ground.i, "v")
    s.arc(O, (x + 0.9 * g.h, 0, 0), A, label=r"$\theta$")
    s.dimension(O, A, label="r", offset=-0.25 * g.h)
    s.dimension((-0.3 * g.h, 0, 0), (-0.3 * g.h, y, 0), label="h", offset=0)
    s.line((-0.45 * g.h, 0, 0), O)
    s.label(O, "O", offset=(0, -16))
    s.dot(A, "A", offset=(-14, 10))
