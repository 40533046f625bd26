"""The collar A on a rod OB that turns in a plane about O (2/19, 2/20), r(t) and theta(t) given."""

from exercises.tools import Sketch, Step, mp, rate, rot, second_rate, terms, times
from newton_euler import Frame, moving, polar


def moving_by(r, theta):
    """``solve``, ``steps``, ``prove`` and ``draw`` for functions ``r``, ``theta`` of (g, t)."""
    return (
        lambda g: motion(g, r, theta),
        lambda g: steps(g, r, theta),
        lambda g: prove(g, r, theta),
        lambda g, ax: sketch(g, ax, r),
    )


def collar(g, r, theta):
    """Ground and collar at the time t_1."""
    ground, t = Frame("ground"), moving(g.t_1, rate=1)
    return ground, polar(ground, "A", r(g, t), theta(g, t))


def motion(g, r, theta):
    """The answers, along e_r, e_theta."""
    ground, A = collar(g, r, theta)
    return {"v": A.velocity(ground), "a": A.acceleration(ground)}


def steps(g, r, theta):
    """The coordinates and their rates, then the terms of the answers."""
    ground, A = collar(g, r, theta)
    r, theta = A.coordinates
    yield Step("r", r.value, "m", "distance of the collar from O", "2.6")
    yield Step("r_dot", r.rate, "m/s", "its rate", "2.6")
    yield Step("r_ddot", r.acceleration, "m/s^2", "its second rate", "2.6")
    yield Step("theta_dot", theta.rate, "rad/s", "rate of the angle", "2.6")
    yield Step("theta_ddot", theta.acceleration, "rad/s^2", "its second rate", "2.6")
    yield from terms(A.velocity(ground), "v", "m/s", "2.6")
    yield from terms(A.acceleration(ground), "a", "m/s^2", "2.6")


def prove(g, r, theta):
    """The path in fixed axes, differentiated, then resolved along and across the rod."""
    place = lambda t: times(rot("z", theta(g, t)), [r(g, t), 0, 0])
    along_rod = lambda vector: times(rot("z", -theta(g, g.t_1)), vector)
    return {
        "v": along_rod(rate(place, g.t_1)),
        "a": along_rod(second_rate(place, g.t_1)),
        "r": mp.sqrt(sum(x * x for x in place(g.t_1))),
        "r_dot": rate(lambda t: mp.sqrt(sum(x * x for x in place(t))), g.t_1),
    }


def common_mistakes(g, r, theta):
    a = motion(g, r, theta)["a"]
    return {
        "no_coriolis": {"a": a.without("coriolis")},
        "no_centripetal": {"a": a.without("centripetal")},
        "second_rates_alone": {"a": a.without("coriolis", "centripetal")},
    }


def sketch(g, ax, r):
    """The rod at 35 degrees, with the collar at its distance at t_1."""
    ground, size = Frame("ground"), r(g, g.t_1)
    rod = ground.rotate("rod", "z", 0.6)
    O, A, B = (rod.point(*P, 0, 0) for P in (("O", 0), ("A", size), ("B", 1.7 * size)))
    s = Sketch(ax, ground, plane="xy")
    s.line(O, (1.3 * size, 0, 0))
    x, y = 0.13 * size, 0.07 * size
    s.rod(O, rod.point("near end", size - x, 0, 0))
    s.rod(rod.point("far end", size + x, 0, 0), B)
    s.hinge(O)
    corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
    s.plate([rod.point("corner", size + u, v, 0) for u, v in corners])
    s.arc(O, (size, 0, 0), A, label=r"$\theta$")
    s.axes(A, rod, length=0.45 * size, labels=["$e_r$", r"$e_\theta$", ""])
    s.dimension(O, A, label="r", offset=0.18 * size)
    s.label(O, "O", offset=(-10, -8))
    s.label(A, "A", offset=(14, -22))
    s.label(B, "B")
