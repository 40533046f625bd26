"""The jet of water of 2/11 and 2/12, from a nozzle at A to its highest point B."""

from exercises.annotations import AnyAxes, Givens, Number, Scalar, Triple
from exercises.tools import Sketch, rate, second_rate
from newton_euler import Frame, Vector, frenet
from newton_euler.kinematics import Frenet


def motion(g: Givens, ground: Frame, v: Vector) -> Frenet:
    """The motion of the water in intrinsic components, at the point where its velocity is v."""
    return frenet(v, ground.vector(0, 0, -g.g))


def proved_radius(g: Givens, v_0: Number, slope: Number, x: Number) -> Number:
    """Proof: radius of curvature of the curve z(x) with this slope at A."""
    z = lambda x: slope * x - g.g / 2 * (1 + slope**2) * (x / v_0) ** 2
    return (1 + rate(z, x) ** 2) ** 1.5 / abs(second_rate(z, x))


def proved_top(g: Givens, v_0: Number, slope: Number) -> Number:
    """Proof: where the curve is level."""
    return slope * v_0**2 / (g.g * (1 + slope**2))


def sketch(g: Givens, ax: AnyAxes, ground: Frame, v: Vector) -> tuple[Sketch, Triple, Scalar]:
    """The path with A and B, and the velocity at A; returns the sketch, A and the range."""
    s = Sketch(ax, ground, plane="xz")
    u, _, w = v.components()
    T = 2 * w / g.g
    times = [T * n / 60 for n in range(69)]
    s.path([(u * t, 0, w * t - g.g / 2 * t**2) for t in times])
    A, B = (0, 0, 0), (u * T / 2, 0, w * T / 4)
    s.vector(A, (u, 0, w), "$v_0$")
    s.rod((-0.06 * u * T, 0, -0.06 * w * T), A)
    for P, name, offset in ((A, "A", (-9, 8)), (B, "B", (0, 10))):
        s.dot(P, name, offset=offset)
    return s, A, u * T
