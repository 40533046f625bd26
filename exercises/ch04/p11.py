"""4/11: a cone that rolls in the gap between two cones turning in opposite senses."""

from exercises.tools import Sketch, angular_velocity, in_frame, mp, rate, rot, terms, times
from newton_euler import Frame, cos, sin, solve_rates


def cones(g, rate_of_B):
    """Ground; cones A and B on the x axis; unit vectors from the apex along contacts with C."""
    ground = Frame("ground")
    A, B = ground.rotate("A", "x", rate=g.omega), ground.rotate("B", "x", rate=rate_of_B)
    on_A = ground.vector(cos(g.beta_A), sin(g.beta_A), 0)
    return ground, A, B, on_A, ground.vector(-cos(g.beta_B), sin(g.beta_B), 0)


def rolling(g, rate_of_B):
    """omega of C, in the plane of the axes; C rolls on A and B."""
    ground, A, B, on_A, on_B = cones(g, rate_of_B)
    cone_C = lambda x, y: ground.rotate("about x", "x", rate=x).rotate("about y", "y", rate=y)
    velocity = lambda cone, contact: cone.point("", *contact).velocity(ground)

    def slips(*rates):
        C, contacts = cone_C(*rates), ((A, on_A), (B, on_B))
        return tuple((velocity(C, e) - velocity(cone, e)).z for cone, e in contacts)

    return in_frame(ground, {"omega_C": cone_C(*solve_rates(slips, 2)).angular_velocity(ground)})


def solve(g):
    return rolling(g, -g.omega)


def steps(g):
    ground, A, B, on_A, on_B = cones(g, -g.omega)
    yield "v_A", A.point("", *on_A).velocity(ground).expressed_in(ground)
    yield "v_B", B.point("", *on_B).velocity(ground).expressed_in(ground)
    yield from terms(solve(g)["omega_C"], "omega_C", "rad/s", "4.9")


def prove(g):
    """C turns on its axis, which goes round x; equal arcs on C and A, and on C and B."""
    half_gap = (mp.pi - g.beta_A - g.beta_B) / 2
    tilt = g.beta_A + half_gap  # inclination of the axis of C to x
    # pitch radii at the distance 1 from the apex
    a, b, c = mp.sin(g.beta_A), mp.sin(g.beta_B), mp.sin(half_gap)
    # so that (omega - round_x) a = (omega + round_x) b, the arcs laid off in unit time on A and B
    round_x = g.omega * (a - b) / (a + b)
    # like two gears in outer mesh, C turns against A, each about its axis away from the apex
    spin = -(g.omega - round_x) * a / c
    C = lambda t: times(rot("x", round_x * t), rot("z", tilt), rot("x", spin * t))
    on = lambda axis_angle: [mp.cos(axis_angle), mp.sin(axis_angle), 0]
    return {
        "omega_C": angular_velocity(C),
        "v_A": rate(lambda t: times(rot("x", g.omega * t), on(g.beta_A))),
        "v_B": rate(lambda t: times(rot("x", -g.omega * t), on(mp.pi - g.beta_B))),
    }


def mistakes(g):
    ground, A, B, on_A, on_B = cones(g, -g.omega)
    omega_A = A.angular_velocity(ground)
    axis = on_A + on_B
    along = axis * (omega_A.cross(on_A).z / axis.cross(on_A).z)
    wrong = {
        "along_the_axis": {"omega_C": along},
        "same_sense": rolling(g, g.omega),
        "sum_of_A_and_B": {"omega_C": omega_A + B.angular_velocity(ground)},
        "B_at_rest": rolling(g, 0),
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    ground, _, _, on_A, on_B = cones(g, -g.omega)
    O, half_gap, x = ground.point("O", 0, 0, 0), on_A.angle_to(on_B) / 2, ground.i
    s = Sketch(ax, ground, azimuth=20, elevation=15, up="y")
    for axis, half_angle in ((x, g.beta_A), (-x, g.beta_B), ((on_A + on_B).direction(), half_gap)):
        s.cone(O, axis, cos(half_angle), sin(half_angle))
    s.label(x * cos(g.beta_A), "A", offset=(0, -14))
    s.label(ground.vector(-cos(g.beta_B), -sin(g.beta_B), 0) * 0.8, "B", offset=-ground.j)
    s.label((on_A + on_B).direction() * cos(half_gap), "C", offset=ground.j)
    s.line(x * -1.35, x * 1.35, style="centre")
    s.line(O, on_A, style="solid")
    s.line(O, on_B, style="solid")
    s.axes(O, ground)
    s.turn(x * 1.2, x, label=r"$\omega$")
    s.turn(x * -1.2, -x, label=r"$\omega$")
    s.arc(O, x, on_A, label=r"$\beta_A$")
    s.arc(O, -x, on_B, label=r"$\beta_B$")
    s.label(O, "O")
