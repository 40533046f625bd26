"""11/8: a particle on a light frame, swinging down and stretching a spring."""

from exercises.devices.spring_to_pin import pull
from exercises.tools import Sketch, minus, mp, plus, size, speed_along
from newton_euler import Frame, cos, sin
from newton_euler.dynamics import speed_after, spring_between, spring_potential, weight_potential


def ends(g):
    """The ground with z up, C, and B at both thetas, from the upward vertical toward x."""
    ground = Frame("ground")
    frames = [ground.rotate("frame", "y", angle=theta) for theta in (g.theta_0, g.theta_1)]
    return ground, ground.point("C", 0, 0, g.d), [f.point("B", 0, 0, g.b) for f in frames]


def lengths(g):
    """The lengths of the spring, at the release and at theta_1."""
    _, C, places = ends(g)
    return [(B - C).norm() for B in places]


def drop(g):
    ground, _, (first, last) = ends(g)
    return (first - last).expressed_in(ground).z


def energies(g):
    """The loss of potential energy of the weight, and the gain of the spring's."""
    _, C, (_, B) = ends(g)
    return weight_potential(g.m, drop(g), g.g), spring_between(g.k, lengths(g)[0], C, B)


def speed(g, U):
    return {"v": speed_after(0, U, g.m)}


def solve(g):
    lost, taken = energies(g)
    return speed(g, lost - taken)


def steps(g):
    lost, taken = energies(g)
    first, last = lengths(g)
    return {"h": drop(g), "U_w": lost, "l_0": first, "l_1": last, "x": last - first, "V_s": taken}


def prove(g):
    """The forces of weight and spring, integrated along the circle of B."""
    circle = lambda theta: [g.b * mp.sin(theta), 0, g.b * mp.cos(theta)]
    C = [0, 0, g.d]
    start, end = circle(g.theta_0), circle(g.theta_1)
    first, last = size(minus(start, C)), size(minus(end, C))
    spring = pull(g.k, first, C)
    force = lambda place: plus([0, 0, -g.m * g.g], spring(place))
    v = speed_along(g.m, force, circle, g.theta_0, g.theta_1)
    return {"v": v, "h": start[2] - end[2], "l_0": first, "l_1": last, "x": last - first}


def mistakes(g):
    lost, taken = energies(g)
    turned = g.theta_1 - g.theta_0
    moved = spring_potential(g.k, 2 * g.b * sin(turned / 2))
    from_top = weight_potential(g.m, g.b * (1 - cos(turned)), g.g)
    return {
        "distance_moved": speed(g, lost - moved),
        "drop_from_the_top": speed(g, from_top - taken),
        "spring_helps": speed(g, lost + taken),
        "no_half": speed(g, lost - 2 * taken),
    }


def draw(g, ax):
    ground, C, (B, last) = ends(g)
    O = ground.origin
    s = Sketch(ax, ground, plane="xz")
    s.ground((0, 0, g.d), normal=-ground.k)
    s.rod(O, B)
    s.line(O, last)
    s.spring(C, B)
    s.line(O, C, style="centre")
    s.hinge(O)
    s.sphere(B, 0.06 * g.b)
    s.dot(last)
    s.arc(O, C, last, label=r"$\theta$")
    s.dimension(O, last, label="b", offset=-0.2 * g.b)
    s.dimension(O, C, label="d", offset=0.2 * g.b)
    s.label(O, "O", offset=(14, 12))
    s.dot(C, "C", offset=(-14, -10))
    s.label(B, "B", offset=(16, 14))
    s.label(B, "m", offset=(24, -4), bold=False)
