"""2/10: a car speeding up in a curve."""

from exercises.tools import at_angle, on_ground, rate, root, second_rate, size
from newton_euler import Frame, moving, polar, sqrt

FOOT = 0.3048  # m, for the mistake of ft/s for mi/h


def speed_rate(g):
    """Half the change of v^2 per length, from v dv = a_t ds."""
    return (g.v_2**2 - g.v_1**2) / (2 * g.L)


def speed(g):
    """Speed after the distance s."""
    return sqrt(g.v_1**2 + 2 * speed_rate(g) * g.s)


def acceleration(g, v, a_t):
    """The acceleration of a point on the circle, along e_r and e_theta."""
    ground = Frame("ground")
    angle = moving(g.s / g.R, rate=v / g.R, acceleration=a_t / g.R)
    return polar(ground, "P", g.R, angle).acceleration(ground)


def solve(g):
    return {"a": acceleration(g, speed(g), speed_rate(g)).norm()}


def steps(g):
    a = acceleration(g, speed(g), speed_rate(g))
    return {"a_t": speed_rate(g), "v": speed(g), "a_n": -a.x}


def prove(g):
    """The time over the stretch from its length and mean speed, then position over time."""
    T = g.L / ((g.v_1 + g.v_2) / 2)
    gone = lambda t: g.v_1 * t + (g.v_2 - g.v_1) / T * t**2 / 2
    when = root(lambda t: gone(t) - g.s, 0, T)
    place = lambda t: at_angle(g.R, gone(when + t) / g.R)
    return {"a": size(second_rate(place)), "a_t": second_rate(gone), "v": size(rate(place))}


def mistakes(g):
    a = acceleration(g, speed(g), speed_rate(g))
    linear = g.v_1 + (g.v_2 - g.v_1) * g.s / g.L
    return {
        "only_normal": {"a": -a.x},
        "only_tangential": {"a": a.y},
        "miles_per_hour": solve(g.but(v_1=FOOT * g.stated("v_1"), v_2=FOOT * g.stated("v_2"))),
        "no_2": {"a": acceleration(g, speed(g), 2 * speed_rate(g)).norm()},
        "linear_in_distance": {"a": acceleration(g, linear, speed_rate(g)).norm()},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    start = 0.15 - g.L / g.R / 2  # so that the stretch lies to the right of O
    axes = lambda distance: ground.rotate("there", "z", angle=start + distance / g.R)
    at = lambda distance, r=1.0: axes(distance).vector(r * g.R, 0, 0).components(ground)
    O, P = (0, 0, 0), at(g.s)
    s.path([at(g.L * n / 60) for n in range(-12, 73)])
    for name, length, r in (("L", g.L, 1.21), ("s", g.s, 1.06)):
        s.path([at(length * n / 60, r) for n in range(61)], style="dotted")
        s.line(at(length), at(length, r + 0.02), style="solid")
        s.label(at(length / 2, r), name, offset=at(length / 2), bold=False)
    s.line(at(0), at(0, 1.23), style="solid")
    local = axes(g.s)
    s.line(O, at(0))
    s.line(O, at(g.L))
    s.dot(P)
    s.vector(P, local.j, "$a_t$", kind="acceleration")
    s.vector(P, -local.i, "$a_n$", kind="acceleration")
    for n, distance in enumerate((0, g.L), 1):
        s.vector(at(distance), axes(distance).j, f"$v_{n}$", kind="velocity")
    s.dimension(O, at(0), "R", offset=0)
    s.label(O, "O")
