"""11/28: a particle in a ring turning freely about its vertical diameter."""

from exercises.devices import spherical_pendulum as pendulum
from exercises.tools import Sketch, mp
from newton_euler import Frame, acos, asin, cos, pi, sin
from newton_euler.dynamics import weight_potential

follows = {"drops": lambda g, theta_min: answers(theta_min)["drops"]}


def cosine(g, share=1):
    """The cosine of the smallest angle, the sine of the angle below the horizontal."""
    return pendulum.sine_of_descent(g.m, g.a, g.omega, g.g, share)


def answers(theta):
    """The opening is at zero."""
    return {"drops": lambda: "yes" if theta <= 0 else "no", "theta_min": theta}


def solve(g):
    return answers(acos(cosine(g)))


def steps(g):
    T_0, H = pendulum.level_motion(g.m, g.a, 0 * g.a, g.omega)
    return {"T_0": T_0, "H": H, "n": T_0 / weight_potential(g.m, g.a, g.g)}


def prove(g):
    """The motion to the lowest point, under the weight and the massless ring's radial force."""
    place, _ = pendulum.other_level(g.g, 0 * g.a, g.a, g.a * g.omega)
    return answers(mp.pi / 2 - pendulum.depth_angle(place))


def mistakes(g):
    T_0, _ = pendulum.level_motion(g.m, g.a, 0 * g.a, g.omega)
    return {
        "driven": {"theta_min": acos(g.m * g.g * g.a / T_0)},
        "no_turning": answers(0 * solve(g)["theta_min"]),
        "from_level": {"theta_min": asin(cosine(g))},
        "no_half": {"theta_min": acos(cosine(g, share=2))},
    }


def draw(g, ax):
    ground, gap, theta = Frame("ground"), 0.15, 1.1  # anywhere
    s = Sketch(ax, ground, plane="xz")
    O, P = (0, 0, 0), (g.a * sin(theta), 0, -g.a * cos(theta))
    s.wire(s.around(O, (g.a * sin(gap), 0, -g.a * cos(gap)), -ground.j, 2 * pi(gap) - 2 * gap))
    s.line((0, 0, -1.3 * g.a), (0, 0, 1.45 * g.a), style="centre")
    s.line(O, P)
    s.dot(P)
    s.dot(O)
    s.arc(O, -ground.k, P, label=r"$\theta$")
    s.arrow(O, (-0.8 * g.a, 0, 0.6 * g.a), label="a")
    s.turn((0, 0, 1.3 * g.a), ground.k, label=r"$\omega$")
    s.label(P, "m", offset=(14, -6), bold=False)
