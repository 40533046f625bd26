"""The ball of 2/7 and 2/8, thrown to hit a vertical wall as high as possible."""

from exercises.annotations import AnyAxes, Givens, Number, Path, Scalar
from exercises.tools import Sketch, mp, rate, root
from newton_euler import Frame, kinematics, moving, sqrt
from newton_euler.drawing.page.recorder import Place


def at_wall(g: Givens, u: Scalar) -> tuple[Scalar, Scalar]:
    """Height and slope of the path at the wall, for an initial slope ``u``. With x as the
    independent variable, the slope decreases at the rate g over the square of the forward velocity.
    """
    forward_squared = g.v_0**2 / (1 + u**2)
    return kinematics.from_time(lambda x: -g.g / forward_squared, g.d, v0=u)


def forward(g: Givens, u: Scalar) -> Scalar:
    """The horizontal velocity."""
    return g.v_0 / sqrt(1 + u**2)


def best_slope(g: Givens) -> Scalar:
    """The initial slope of the highest hit: the height is quadratic in it."""
    h, _ = at_wall(g, moving(0 * g.one, rate=g.one))
    return -h.rate / h.acceleration


def proved_angle(g: Givens) -> Number:
    """Proof: the angle at which the height on the wall no longer grows."""
    slope = lambda gam: rate(lambda t: proved_height(g, gam + t))
    return root(slope, 0, mp.pi / 2 - mp.mpf("0.01"))


def proved_height(g: Givens, gam: Number) -> Number:
    return proved_path(g, gam)(g.d / (g.v_0 * mp.cos(gam)))[1]


def proved_path(g: Givens, gam: Number) -> Path:
    """Proof: position of the ball over time."""
    return lambda t: [g.v_0 * mp.cos(gam) * t, g.v_0 * mp.sin(gam) * t - g.g * t**2 / 2]


def draw(g: Givens, ax: AnyAxes) -> tuple[Sketch, Place, Place, Place, Place]:
    """The thrower at O, the wall, the point of impact, and the beginning of the path."""
    s = Sketch(ax, Frame("ground"), plane="xz")
    u = best_slope(g)
    h, _ = at_wall(g, u)
    vx = forward(g, u)
    place = lambda x: (x, 0, u * x - g.g / 2 * (x / vx) ** 2)
    O, hit, foot = (0, 0, 0), (g.d, 0, h), (g.d, 0, 0)
    s.road([(g.d, 0, -0.1 * h), (g.d, 0, 1.3 * h)])
    s.line(O, foot)
    end = 0.5 * g.d
    s.path([place(end * n / 40) for n in range(41)])
    s.dot(hit)
    s.vector(O, (vx, 0, u * vx), "$v_0$")
    s.dimension(O, foot, "d")
    s.dot(O, "O")
    return s, O, foot, hit, (0.4 * g.d, 0, 0.4 * g.d * u)
