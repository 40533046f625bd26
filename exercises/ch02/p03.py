"""2/3: a parabola with steady horizontal motion."""

from exercises.tools import in_frame, mp, on_ground, rate, root, second_rate
from newton_euler import Frame, moving
from newton_euler.kinematics import at_speed, frenet_along


def parabola(g):
    return lambda x: (x, g.k * x**2, 0)


def point(g):
    ground = Frame("ground")
    return ground, ground.point("P", *parabola(g)(moving(g.x, rate=g.c)))


def solve(g):
    ground, P = point(g)
    return {"a": P.acceleration(ground)}


def steps(g):
    ground, P = point(g)
    return {"v": P.velocity(ground)}


def prove(g):
    """The parabola as the points equally far from focus and directrix."""
    f = 1 / (4 * g.k)

    def place(t):
        x = g.x + g.c * t
        return [x, root(lambda y: mp.hypot(x, y - f) - (y + f), 0, x + f + x * x / f), 0]

    return {"a": second_rate(place), "v": rate(place)}


def mistakes(g):
    ground, P = point(g)
    right = P.acceleration(ground)
    at_c = frenet_along(parabola(g), at_speed(parabola(g), g.x, g.c), ground)
    return in_frame(ground, {
        "no_acceleration": {"a": 0 * right},
        "one_c_lost": {"a": right / g.c},
        "constant_speed": {"a": at_c.acceleration},
    })  # fmt: skip


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    place = parabola(g)
    O, here = (0, 0, 0), place(g.x)
    far = 1.5 * g.x
    s.axes(O, ground, length=1.5 * far, labels=["x", "", ""])
    s.axes(O, ground, length=1.15 * place(far)[1], labels=["", "y", ""])
    s.path([place(far * n / 40) for n in range(-30, 41)])
    s.line((g.x, 0, 0), here)
    s.dimension(O, (g.x, 0, 0), "x")
    s.vector(here, ground.i * g.c, "c")
    s.label(O, "O", offset=(-8, -8))
    s.dot(here, "P", offset=(-8, 8))
