"""4/6: an arm that turns about a vertical rod on a roller going downhill."""

from exercises.devices.moving_frame import turning_of
from exercises.tools import Sketch, at_angle, in_frame, minus, mp, plus, rate, terms
from newton_euler import Frame, cos, moving, pi, sin


def roller_and_rod(g):
    """Ground with x downhill and Z up; axes that move with O without turning; the rod about Z."""
    ground = Frame("ground")
    right, down = g.u * cos(g.incline), g.u * sin(g.incline)
    O = ground.point("O", moving(0, rate=right), 0, moving(0, rate=-down))
    rod = ground.translate("carried", O).rotate("rod", "z", rate=g.omega)
    return ground, rod, rod.point("P", g.b, 0, height(g))


def height(g):
    """Length OA; the answer does not depend on it."""
    return 0.8 * g.b


def solve(g):
    ground, _, P = roller_and_rod(g)
    return in_frame(ground, {"v_P": P.velocity(ground)})


def steps(g):
    ground, rod, _ = roller_and_rod(g)
    yield "v_O", rod.origin.velocity(ground).expressed_in(ground)
    yield from turning_of(rod, ground, ground, "rod", "the moving frame, fixed in the rod,")
    yield "r", rod.vector(g.b, 0, 0).expressed_in(ground)
    yield from terms(solve(g)["v_P"], "v_P", "ft/s", "4.8")


def prove(g):
    A = lambda t: [g.u * t * mp.cos(g.incline), 0, 1 - g.u * t * mp.sin(g.incline)]
    P = lambda t: plus(A(t), at_angle(g.b, g.omega * t))
    return {"v_P": rate(P), "v_O": rate(A), "r": minus(P(0), A(0))}


def mistakes(g):
    return {
        "roller_at_rest": {"v_P": solve(g)["v_P"].without("origin")},
        "sine_and_cosine_exchanged": solve(g.but(incline=pi(g.incline) / 2 - g.incline)),
        "roller_on_level_ground": solve(g.but(incline=0)),
        "clockwise": solve(g.but(omega=-g.omega)),
    }


def draw(g, ax):
    ground, rod, P = roller_and_rod(g)
    O, A, radius = (0, 0, 0), rod.point("A", 0, 0, height(g)), 0.3 * g.b
    along, down = cos(g.incline), sin(g.incline)

    def on_plane(distance):
        return (distance * along - radius * down, 0, -distance * down - radius * along)

    top, foot = on_plane(-0.9 * g.b), on_plane(1.3 * g.b)
    level = (foot[0] - 0.8 * g.b, 0, foot[2])
    s = Sketch(ax, ground, plane="xz")
    s.road([top, foot])
    s.disk(O, ground.j, radius)
    s.rod(O, A, P)
    s.vector(O, rod.origin.velocity(ground), "u")
    s.line(foot, level)
    s.arc(foot, level, top, label=r"$\gamma$")
    s.turn((0, 0, 0.5 * height(g)), ground.k, label=r"$\omega$")
    s.dimension(A, P, label="b")
    s.axes((g.b, 0, 0), ground, length=0.3 * g.b)
    s.dot(O, "O")
    s.label(A, "A")
    s.label(P, "P")
