"""3/6: a point on a sphere, in spherical, cylindrical and rectangular components."""

from exercises.tools import cross, mp, on_ground, rate, rot, second_rate, times, transposed
from newton_euler import Frame, cylindrical, moving, pi, spherical, sqrt


def given(g, name):
    """A coordinate with its rates."""
    return moving(*(getattr(g, name + end) for end in ("", "_dot", "_ddot")))


def by_height(g, r):
    return cylindrical(Frame("ground"), "P", r, given(g, "theta"), given(g, "z"))


def distance_from_axis(g):
    return sqrt(g.R**2 - given(g, "z") ** 2)


def height_above(g):
    """z above x and y: from z^2 = R^2 - 2 half, z z' = -half' and z z'' + z'^2 = -half''."""
    x, y = given(g, "x"), given(g, "y")
    half = (x**2 + y**2) / 2
    z = sqrt(g.R**2 - g.x**2 - g.y**2)
    z_rate = -half.rate / z
    return moving(z, rate=z_rate, acceleration=-(half.acceleration + z_rate**2) / z)


def motion(system, P, ground=None):
    ground = ground or P.ground
    return {f"v_{system}": P.velocity(ground), f"a_{system}": P.acceleration(ground)}


def rectangular(g, z):
    ground = Frame("ground")
    return motion("rect", ground.point("P", given(g, "x"), given(g, "y"), z), ground)


def solve(g):
    P = spherical(Frame("ground"), "P", g.R, given(g, "theta"), given(g, "phi"))
    return {
        **motion("sph", P),
        **motion("cyl", by_height(g, distance_from_axis(g))),
        **rectangular(g, height_above(g)),
    }


def steps(g):
    r, z = distance_from_axis(g), height_above(g)
    return {"r_dot": r.rate, "r_ddot": r.acceleration, "z_rate": z.rate}


def prove(g):
    """OP by rotation matrices, differentiated in fixed axes; elevation from z, or from x and y."""
    later = lambda q, q_dot, q_ddot: lambda t: q + q_dot * t + q_ddot * t**2 / 2
    theta = later(g.theta, g.theta_dot, g.theta_ddot)
    phi = later(g.phi, g.phi_dot, g.phi_ddot)
    z = later(g.z, g.z_dot, g.z_ddot)
    raised = lambda up: lambda t: times(rot("z", theta(t)), rot("y", -up(t)), [g.R, 0, 0])

    def along(axes, place):
        return [times(transposed(axes), v) for v in (rate(place), second_rate(place))]

    e_theta = [-mp.sin(g.theta), mp.cos(g.theta), 0]
    e_R = [x / g.R for x in raised(phi)(0)]
    spherical_axes = transposed([e_R, e_theta, cross(e_R, e_theta)])
    v_sph, a_sph = along(spherical_axes, raised(phi))
    v_cyl, a_cyl = along(rot("z", g.theta), raised(lambda t: mp.asin(z(t) / g.R)))
    x, y = later(g.x, g.x_dot, g.x_ddot), later(g.y, g.y_dot, g.y_ddot)
    above = lambda t: g.R * mp.sin(mp.acos(mp.hypot(x(t), y(t)) / g.R))
    v_z, a_z = rate(above), second_rate(above)
    return {
        "v_sph": v_sph,
        "a_sph": a_sph,
        "v_cyl": v_cyl,
        "a_cyl": a_cyl,
        "v_rect": [g.x_dot, g.y_dot, v_z],
        "a_rect": [g.x_ddot, g.y_ddot, a_z],
        "r_dot": v_cyl[0],
        "r_ddot": second_rate(lambda t: g.R * mp.cos(mp.asin(z(t) / g.R))),
        "z_rate": v_z,
    }


def mistakes(g):
    _, a_sph, *_, a = solve(g).values()
    z = height_above(g)
    other = pi(g.one) / 2 - g.phi  # with sine and cosine exchanged, at the same rates
    phi = moving(other, rate=g.phi_dot, acceleration=g.phi_ddot)
    exchanged = spherical(Frame("ground"), "P", g.R, given(g, "theta"), phi)
    return {
        "phi_from_the_vertical": motion("sph", exchanged),
        "r_constant": motion("cyl", by_height(g, distance_from_axis(g).value)),
        "z_not_eliminated": rectangular(g, given(g, "z")),
        "z_rate_not_differentiated": {"a_rect": a + a.frame.k * (z.rate**2 / z.value)},
        "no_radial_acceleration": {"a_sph": a_sph - a_sph.x * a_sph.frame.i},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=35, elevation=22)
    O = (0, 0, 0)
    P = spherical(ground, "P", g.R, 1.0, 0.75)
    Q = ground.point("Q", *P.position(ground).components(ground)[:2], 0)
    for axis in (ground.i, ground.j, ground.k):
        s.ring(O, axis, g.R)
    s.axes(O, ground, length=1.4 * g.R)
    s.line(O, P, style="solid")
    s.line(O, Q)
    s.line(Q, P)
    s.arc(O, ground.i, Q, r"$\theta$")
    s.arc(O, Q, P, r"$\phi$")
    s.dot(P)
    s.dimension(O, P, label="R", offset=0.1 * g.R)
    for A, name in ((O, "O"), (P, "P"), (Q, "Q")):
        s.label(A, name)
