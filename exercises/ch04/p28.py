"""4/28: the solar panels of a spinning spacecraft."""

from exercises.devices.moving_frame import seen_in, turning_of
from exercises.tools import Sketch, acceleration_of, in_frame, mp, proofs, rate, rot, terms, times
from newton_euler import Frame, cos, pi, sin


def spacecraft_and_panel(g):
    """Space; the spacecraft spins about z; the panels turn in it about -y, as theta grows."""
    space = Frame("space")
    craft = space.rotate("spacecraft", "z", rate=g.omega)
    panel = craft.rotate("panel", "-y", angle=g.theta_1, rate=g.theta_dot)
    return space, craft, panel, panel.point("A", 0, g.L, g.d)


def answers(space, craft, panel, A):
    return in_frame(craft, {
        "omega_panel": panel.angular_velocity(space),
        "alpha_panel": panel.angular_acceleration(space),
        "v_A": A.velocity(space, via=craft),
        "a_A": A.acceleration(space, via=craft),
    })  # fmt: skip


def solve(g):
    return answers(*spacecraft_and_panel(g))


def place(g, frame):
    """The place of A, on the axes of the spacecraft."""
    return frame.vector(-g.d * sin(g.theta_1), g.L, g.d * cos(g.theta_1))


def a_A(g, omega_panel, alpha_panel):
    return acceleration_of(omega_panel, alpha_panel, place(g, omega_panel.frame))


follows = {
    # constant along the axes of the spacecraft
    "alpha_panel": lambda g, omega_panel: (g.omega * omega_panel.frame.k).cross(omega_panel),
    "v_A": lambda g, omega_panel: omega_panel.cross(place(g, omega_panel.frame)),
    "a_A": a_A,
}


def steps(g):
    space, craft, _, A = spacecraft_and_panel(g)
    omega, alpha, v, a = solve(g).values()
    yield from terms(omega, "omega_panel", "rad/s", "4.9")
    yield from terms(alpha, "alpha_panel", "rad/s^2", "4.9")
    phrase = "the moving frame, fixed in the spacecraft,"
    yield from turning_of(craft, space, craft, "spacecraft", phrase)
    yield from seen_in(craft, A, craft, "ft", "the spacecraft", "the centre of the spacecraft")
    yield from terms(v, "v_A", "ft/s", "4.8")
    yield from terms(a, "a_A", "ft/s^2", "4.8")


def prove(g):
    tilt = lambda t: g.theta_1 + g.theta_dot * t

    # columns: normal to the panel, along y, and from the y axis to A, from +z toward -x
    def panel(t):
        c, s = mp.cos(tilt(t)), mp.sin(tilt(t))
        return times(rot("z", g.omega * t), [[c, 0, -s], [0, 1, 0], [s, 0, c]])

    seen = lambda t: [-g.d * mp.sin(tilt(t)), g.L, g.d * mp.cos(tilt(t))]
    A = lambda t: times(rot("z", g.omega * t), seen(t))
    return {
        "omega_panel": proofs.angular_velocity(panel),
        "alpha_panel": proofs.angular_acceleration(panel),
        "v_A": rate(A),
        "a_A": proofs.second_rate(A),
        "r": seen(0),
        "v_r": rate(seen),
        "a_r": proofs.second_rate(seen),
    }


def mistakes(g):
    frames = _, craft, _, A = spacecraft_and_panel(g)
    solved, exchanged = answers(*frames), solve(g.but(theta_1=pi(g.theta_1) / 2 - g.theta_1))
    alpha, a = solved["alpha_panel"], solved["a_A"]
    return {
        "alpha_zero": {"alpha_panel": alpha.without("spacecraft x panel")},
        "panels_the_other_way": solve(g.but(theta_dot=-g.theta_dot)),
        "no_coriolis": {"a_A": a.without("coriolis")},
        "alpha_x_r_twice": {"a_A": a + alpha.cross(A.position(craft))},
        "theta_from_y": {"v_A": exchanged["v_A"], "a_A": exchanged["a_A"]},
    }


def draw(g, ax):
    space, craft, panel, A = spacecraft_and_panel(g)
    s = Sketch(ax, space, azimuth=35, elevation=20)
    body = 0.35 * g.L
    s.box(craft.point("", 0, 0, 0), craft, (body, body, 1.4 * body))
    for near, far in ((body / 2, g.L), (-body / 2, -g.L)):
        corners = (near, g.d), (far, g.d), (far, -g.d), (near, -g.d)
        s.plate([panel.point("", 0, y, z) for y, z in corners])
    end = craft.point("", 0, g.L, 0)
    up = craft.point("", 0, g.L, 0.45 * g.L)
    s.axes(craft.point("", 0, 0, 0), craft, length=0.7 * g.L)
    s.turn(craft.point("", 0, 0, body), craft.k, label=r"$\omega$")
    s.turn(craft.point("", 0, -1.15 * g.L, 0), -craft.j, label=r"$\dot\theta$")
    s.line(end, up, style="dashed")
    s.arc(end, up, A, label=r"$\theta$")
    s.dimension(end, A, label="d")
    s.dimension(craft.point("", 0, 0, -1.3 * g.d), craft.point("", 0, g.L, -1.3 * g.d), label="L")
    s.dot(A, "A")
