"""The collar A on a rod OB that turns in a plane about O (2/19, 2/20), r(t) and theta(t) given."""

from collections.abc import Callable
from typing import TypeAlias

from exercises.annotations import Answers, AnyAxes, Functions, Givens, Mistakes, Scalar, Steps
from exercises.tools import Sketch, Step, mp, rate, rot, second_rate, terms, times
from newton_euler import Frame, moving, polar
from newton_euler.kinematics.coordinates import CoordinatePoint

InTime: TypeAlias = Callable[[Givens, Scalar], Scalar]  # a coordinate


def moving_by(r: InTime, theta: InTime) -> Functions:
    """``solve``, ``steps``, ``prove`` and ``draw`` for functions ``r``, ``theta`` of (g, t)."""
    return (
        lambda g: motion(g, r, theta),
        lambda g: steps(g, r, theta),
        lambda g: prove(g, r, theta),
        lambda g, ax: sketch(g, ax, r),
    )


def collar(g: Givens, r: InTime, theta: InTime) -> tuple[Frame, CoordinatePoint]:
    """Ground and collar at the time t_1."""
    ground, t = Frame("ground"), moving(g.t_1, rate=1)
    return ground, polar(ground, "A", r(g, t), theta(g, t))


def motion(g: Givens, r: InTime, theta: InTime) -> Answers:
    """The answers, along e_r, e_theta."""
    ground, A = collar(g, r, theta)
    return {"v": A.velocity(ground), "a": A.acceleration(ground)}


def steps(g: Givens, r: InTime, theta: InTime) -> Steps:
    """The coordinates and their rates, then the terms of the answers."""
    ground, A = collar(g, r, theta)
    distance, angle = A.coordinates
    yield Step("r", distance.value, "m", "distance of the collar from O", "2.6")
    yield Step("r_dot", distance.rate, "m/s", "its rate", "2.6")
    yield Step("r_ddot", distance.acceleration, "m/s^2", "its second rate", "2.6")
    yield Step("theta_dot", angle.rate, "rad/s", "rate of the angle", "2.6")
    yield Step("theta_ddot", angle.acceleration, "rad/s^2", "its second rate", "2.6")
    yield from terms(A.velocity(ground), "v", "m/s", "2.6")
    yield from terms(A.acceleration(ground), "a", "m/s^2", "2.6")


def prove(g: Givens, r: InTime, theta: InTime) -> Answers:
    """The path in fixed axes, differentiated, then resolved along and across the rod."""
    place = lambda t: times(rot("z", theta(g, t)), [r(g, t), 0, 0])
    along_rod = lambda vector: times(rot("z", -theta(g, g.t_1)), vector)
    return {
        "v": along_rod(rate(place, g.t_1)),
        "a": along_rod(second_rate(place, g.t_1)),
        "r": mp.sqrt(sum(x * x for x in place(g.t_1))),
        "r_dot": rate(lambda t: mp.sqrt(sum(x * x for x in place(t))), g.t_1),
    }


def common_mistakes(g: Givens, r: InTime, theta: InTime) -> Mistakes:
    a = motion(g, r, theta)["a"]
    return {
        "no_coriolis": {"a": a.without("coriolis")},
        "no_centripetal": {"a": a.without("centripetal")},
        "second_rates_alone": {"a": a.without("coriolis", "centripetal")},
    }


def sketch(g: Givens, ax: AnyAxes, r: InTime) -> None:
    """The rod at 35 degrees, with the collar at its distance at t_1."""
    ground, size = Frame("ground"), r(g, g.t_1)
    rod = ground.rotate("rod", "z", 0.6)
    O, A, B = (rod.point(name, x, 0, 0) for name, x in (("O", 0), ("A", size), ("B", 1.7 * size)))
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
