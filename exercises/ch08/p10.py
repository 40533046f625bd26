"""8/10: a car door swinging shut as the car starts."""

from exercises.tools import box, kinetic_energy, mean, mp, on_ground, rate, vanishing
from newton_euler import Frame, bodies, dynamics, integral, moving, pi, solve_linear, sqrt


def door(g, theta, alpha):
    """Ground, hinge and door from above, x out of the car, y forward: the door is a rod."""
    ground = Frame("ground")
    hinge = ground.point("hinge", 0, moving(0 * g.b, rate=0, acceleration=g.a), 0)
    angle = moving(theta, rate=0, acceleration=alpha)  # its rate adds no moment about the hinge
    frame = ground.rotate("door", "-z", angle=angle, origin=hinge)
    body = bodies.rod(g.b, frame.point("G", g.b / 2, 0, 0), "x", mass=g.M, name="door")
    return ground, frame.point("O", 0, 0, 0), body


def moment(g, theta, alpha):
    """The moment that the door needs about the hinge, counterclockwise, by terms."""
    ground, hinge, body = door(g, theta, alpha)
    return dynamics.resultant_moment(body, ground, about=hinge)


def alpha(g, theta):
    """The angular acceleration for zero moment about the hinge."""
    return solve_linear(lambda alpha: moment(g, theta, alpha).z).alpha


def answers(g, alpha):
    """The answers, from the angular acceleration at any angle."""
    speed = lambda theta: sqrt(2 * integral(alpha, 0, theta))
    shut = speed(pi(g.theta) / 2)
    return {"theta_ddot": alpha(g.theta), "theta_dot": speed(g.theta), "omega_shut": shut}


def solve(g):
    return answers(g, lambda theta: alpha(g, theta))


def steps(g):
    _, hinge, body = door(g, g.theta, 0)
    terms = moment(g, g.theta, alpha(g, g.theta)).terms
    return {"I_O": body.about(hinge).moments[2], "M_ref": terms["reference"].z}


def prove(g):
    """In the frame of the car, by the work of the inertial force -M a."""
    points = [(u, x + g.b / 2) for u, (x, _, _) in box(g.b, 0, 0, order=2)]

    def places(angle, forward=0):
        return [(u, [s * mp.cos(angle), forward - s * mp.sin(angle), mp.mpf(0)]) for u, s in points]

    def speed(angle):
        back = mean(lambda r: -r[1], places(angle))
        return mp.sqrt(g.M * g.a * back / kinetic_energy(g.M, lambda t: places(angle + t)))

    omega = speed(g.theta)

    def power(alpha):
        motion = lambda t: places(g.theta + omega * t + alpha * t**2 / 2, g.a * t**2 / 2)
        return rate(lambda t: kinetic_energy(g.M, motion, t))

    return {
        "theta_ddot": vanishing(power, 0, g.a / g.b),
        "theta_dot": omega,
        "omega_shut": speed(mp.pi / 2),
        "I_O": g.M * mean(lambda r: r[0] ** 2 + r[1] ** 2, places(0)),
    }


def mistakes(g):
    right, without_sine = solve(g), answers(g, lambda theta: alpha(g, pi(theta) / 2 - theta))
    return {
        "hinge_not_accelerated": {key: 0 * x for key, x in right.items()},
        "about_G": answers(g, lambda theta: 4 * alpha(g, theta)),
        "arm_b": answers(g, lambda theta: 2 * alpha(g, theta)),
        "sine_for_cosine": {key: without_sine[key] for key in ("theta_ddot", "theta_dot")},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    b, angle = 1.5, 0.65
    nose, tail, left = 1.4, -1.9, -1.7
    car = [(left, tail, 0), (0, tail, 0), (0, 1.0, 0), (-0.25, nose, 0), (left + 0.25, nose, 0),
           (left, 1.0, 0)]  # fmt: skip
    H, out = (0, 0, 0), (1.25 * b, 0, 0)
    end = ground.rotate("door", "-z", angle=angle).point("end", b, 0, 0)
    s.plate(car, shade="light")
    s.line(H, out)
    s.line(H, (0, -b, 0), style="solid")
    s.rod(H, end)
    s.hinge(H)
    s.arc(H, end, out, label=r"$\theta$")
    s.dimension(H, end, label="b", offset=-0.3)
    s.vector((left / 2, nose, 0), (0, 0.7, 0), "a", kind="acceleration")
    s.label(H, "O", offset=(-9, 6))
