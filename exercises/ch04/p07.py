"""4/7: the tip of a rotor blade that flaps harmonically."""

from exercises.devices.moving_frame import seen_in, turning_of
from exercises.tools import Sketch, in_frame, mp, proofs, rate, rot, second_rate, terms, times
from newton_euler import Frame, at, cos, moving, sin


def flapping(g):
    """The angle theta of the blade with its rates."""
    return at(lambda t: g.theta_0 + g.theta_A * sin(g.n * t), g.t)


def shaft_and_tip(g, theta):
    """Ground with Z up; the shaft's frame at the hinge O, x in the plane of the blade; the tip."""
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "z", rate=g.omega)
    return ground, shaft, shaft.point("tip", g.L * cos(theta), 0, g.L * sin(theta))


def motion(g, theta):
    ground, shaft, tip = shaft_and_tip(g, theta)
    return in_frame(shaft, {"v_tip": tip.velocity(ground), "a_tip": tip.acceleration(ground)})


def solve(g):
    return motion(g, flapping(g))


def steps(g):
    theta = flapping(g)
    yield "theta", theta.value
    yield "theta_dot", theta.rate
    yield "theta_ddot", theta.acceleration
    ground, shaft, tip = shaft_and_tip(g, theta)
    yield from turning_of(shaft, ground, shaft, "shaft", "the moving frame, fixed in the shaft,")
    yield from seen_in(shaft, tip, shaft, "m", "the shaft", "O")
    for key, value in solve(g).items():
        yield from terms(value, key, {"v_tip": "m/s"}.get(key, "m/s^2"), "4.8")


def prove(g):
    flapping = lambda t: g.theta_0 + g.theta_A * mp.sin(g.n * t)
    in_shaft = lambda t: [g.L * mp.cos(flapping(t)), 0, g.L * mp.sin(flapping(t))]
    tip = lambda t: times(rot("z", g.omega * t), in_shaft(t))
    theta = lambda t: mp.atan2(in_shaft(t)[2], in_shaft(t)[0])
    turned_back = proofs.transposed(rot("z", g.omega * g.t))
    return {
        "v_tip": times(turned_back, rate(tip, g.t)),
        "a_tip": times(turned_back, second_rate(tip, g.t)),
        "theta_dot": rate(theta, g.t),
        "theta_ddot": second_rate(theta, g.t),
        "v_r": rate(in_shaft, g.t),
        "a_r": second_rate(in_shaft, g.t),
    }


def mistakes(g):
    theta = flapping(g)
    v, a = solve(g).values()
    too_wide, by_turning = 1 / cos(theta.value), ("coriolis", "centripetal")
    steady = moving(theta.value, rate=theta.rate, acceleration=0)
    return {
        "no_coriolis": {"a_tip": a.without("coriolis")},
        "no_turning": {"v_tip": v.without("rotation"), "a_tip": a.without(*by_turning)},
        "constant_flapping_rate": motion(g, moving(theta.value, rate=g.n * g.theta_A)),
        "radius_L": {
            "v_tip": v.reweighted(rotation=too_wide),
            "a_tip": a.reweighted(centripetal=too_wide),
        },
        "no_second_rate": {"a_tip": motion(g, steady)["a_tip"]},
    }


def draw(g, ax):
    ground, shaft, tip = shaft_and_tip(g, g.theta_0 + g.theta_A / 2)
    O, foot = ground.point("O", 0, 0, 0), (0, 0, -0.5 * g.L)

    def at_angle(theta, distance=1.0):
        return (distance * g.L * cos(theta), 0, distance * g.L * sin(theta))

    def swept(start, angle, distance, label):
        s.path([at_angle(start + angle * n / 20, distance) for n in range(21)])
        s.label(at_angle(start + angle / 2, distance), label, offset=ground.i)

    s = Sketch(ax, ground, azimuth=-102, elevation=10)
    s.shaft(foot, O)
    s.rod(O, tip)
    s.hinge(O, shaft.j)
    s.line(O, at_angle(g.theta_0))
    s.line(O, at_angle(g.theta_0 + g.theta_A), style="dotted")
    s.line(O, at_angle(0), style="dotted")
    s.axes(O, shaft, length=0.3 * g.L)
    s.turn((0, 0, -0.3 * g.L), ground.k, label=r"$\omega$")
    swept(0, g.theta_0 + g.theta_A / 2, 0.5, r"$\theta$")
    swept(0, g.theta_0, 0.75, r"$\theta_0$")
    swept(g.theta_0, g.theta_A, 0.95, r"$\theta_A$")
    s.dimension(O, tip, label="L", offset=0.25 * g.L)
    s.label(O, "O")
