"""2/17: a pin carried along a cam by a turning arm."""

from exercises.devices import polar_motion
from exercises.tools import Sketch, at_angle, minus, plus, rot, second_rate, size, times
from newton_euler import Frame, cos, moving, pi, polar


def pin(g):
    ground, theta = Frame("ground"), moving(g.theta, rate=g.omega)
    r = g.b - g.c * cos(theta)
    return ground, r, polar(ground, "P", r, theta)


solve, steps, mistakes = polar_motion.problem_of(pin)


def prove(g):
    """The limacon as the sum of two cranks: b at omega and c/2 at 2 omega."""
    angle = lambda t: g.theta + g.omega * t
    back = lambda t: plus(at_angle(g.c / 2, 2 * angle(t)), [g.c / 2, 0, 0])
    place = lambda t: minus(at_angle(g.b, angle(t)), back(t))
    a = second_rate(place)
    return {"a": size(a), "a_P": times(rot("z", -g.theta), a)}


def draw(g, ax):
    ground, _, P = pin(g)
    s = Sketch(ax, ground, plane="xy")
    O, size = (0, 0, 0), g.b + g.c

    def on_cam(angle):
        there, _, edge = pin(g.but(theta=angle))
        return edge.position(there).components()

    s.plate([on_cam(pi(g.b) * n / 30) for n in range(60)])
    s.line(O, (size, 0, 0))
    end = P.position(ground) * 1.5
    s.rod(O, end)
    s.hinge(O)
    s.arc(O, (size, 0, 0), P, label=r"$\theta$")
    s.swing(O, end, ground.k, label=r"$\omega$")
    s.dimension(O, P, label="r", offset=0.12 * size)
    s.label(O, "O", offset=(-10, -10))
    s.dot(P, "P", offset=(10, -8))
