"""The hemispherical shell of 5/8 and 7/8: its rim in the (x, y) plane about O, its top on z."""

from collections.abc import Callable

from exercises.annotations import AnyAxes, Givens, Number, Scalar, Triple
from exercises.tools import Sketch, mp
from newton_euler import Frame, cos, integral, pi, sin

SHELL = Frame("shell")


def over_rings(g: Givens, f: Callable[[Scalar], Scalar | Triple]) -> Scalar | Triple:
    """The integral of ``f(phi)``, for the ring at the angle phi from z."""
    return integral(f, 0, pi(g.one) / 2)


def area_of_ring(g: Givens, phi: Scalar, width: Scalar) -> Scalar:
    """Area per dphi, for this width per dphi."""
    return 2 * pi(g.one) * (g.R * sin(phi)) * width


def shadow(g: Givens, s: Number) -> tuple[Number, Number]:
    """Proof: area per ds above the circle of radius s (R/z times that of the plane), and z."""
    z = mp.sqrt(g.R**2 - s**2)
    return 2 * mp.pi * s * g.R / z, z


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, SHELL, azimuth=-60, elevation=20)
    O, end = (0, 0, 0), (-0.6 * g.R, -0.8 * g.R, 0)
    s.hemisphere(O, SHELL.k, g.R, open=True)
    for phi in (0.75, 0.82):
        # slightly outside, to be visible
        s.ring((0, 0, g.R * cos(phi)), SHELL.k, 1.01 * g.R * sin(phi))
    s.axes(O, SHELL, length=1.5 * g.R)
    s.dimension(O, end, label="R", offset=0)
    s.label(O, "O")
