"""The figures of chapter 5: centres of mass, a shell that bursts, frames fixed in a body, freedom."""

import math
from collections.abc import Callable, Iterable, Sequence

from newton_euler import Body, Frame
from newton_euler.algebra.late import np, plt
from newton_euler.algebra.scalars import Triple
from newton_euler.chapters.examples.ch05 import END, HEAD, BurstingProjectile, hammer
from newton_euler.classroom import Slider, interactive_figure, show_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved
from newton_euler.dynamics import gravity_at_height

from .colours import BLUE, GREY, ORANGE
from .curves import evenly
from .sliding import with_sliders

O = (0, 0, 0)
EARTH = 6.371e6  # m


@with_sliders(
    Slider("pushed", 0.4, 0.0, 1.4, 0.1, label="path of the light one", unit="m"),
    Slider("ratio", 2, 1, 4, 1, label="heavy : light"),
    alt="Two skaters push off from each other with a pole. The forces on them are equal, opposite and "
    "along the line that joins them. If one is heavier, it moves less; the centre of mass G stays.",
    size=(7, 2.6),
)
def two_skaters(ax: AnyAxes, pushed: float, ratio: float) -> None:
    """Figure 5.1: action and reaction, and the centre of mass that does not move."""
    ground = Frame("ground")
    light, heavy = 0.3 + pushed, -(0.3 + pushed) / ratio
    s = Sketch(ax, ground, plane="xz")
    s.ground((0, 0, -0.4), ground.k, size=5.4)
    for x, size in ((light, 0.09), (heavy, 0.09 * ratio ** (1 / 3))):
        for skate in (-0.08, 0.08):
            s.rod((x + skate, 0, -0.38), (x, 0, -0.12))
        s.rod((x, 0, -0.12), (x, 0, 0.12))
        s.sphere((x, 0, 0.12 + size), size)
    s.line((heavy, 0, 0), (light, 0, 0), style="solid")
    s.vector((light, 0, 0), (1, 0, 0), r"$\mathbf{F}_{21}$", kind="force")
    s.vector((heavy, 0, 0), (-1, 0, 0), r"$\mathbf{F}_{12}$", kind="force")
    s.line((0, 0, -0.4), (0, 0, 0.3), style="centre")
    s.label((0, 0, 0.3), "G")


def _hammer(s, t):
    """Draw the hammer of the film at the time t, and return the place of G."""
    (x, z), angle = hammer(t)
    along = math.cos(angle), 0, math.sin(angle)
    G = (x, 0, z)
    A, B = moved(G, HEAD, along), moved(G, END, along)
    s.rod(A, B)
    s.box(A, s.frame.rotate("hammer", "y", angle=-angle), (0.05, 0.03, 0.13))
    return G


def thrown_hammer() -> Animation:
    """A film: a hammer is thrown; its centre of mass flies on a parabola."""
    path = [(1.2 * u, 0, 1.5 + 4.9 * u - 4.905 * u**2) for u in evenly(0, 1, 60)]

    def draw(t, ax):
        s = Sketch(ax, Frame("ground"), plane="xz")
        s.path(path)
        s.dot(_hammer(s, t), "G")

    return animate(
        draw,
        evenly(0, 1, 41),
        alt="A hammer tumbles through the air. Its point G, near the head, flies on a parabola; "
        "head and handle circle round it.",
        size=(4.6, 4.6),
    )


@with_sliders(
    Slider("share", 0.7, 0.0, 1.0, 0.05, label="mark, from head to end"),
    alt="Nine pictures of a hammer that tumbles through the air, and the path of one mark on its "
    "handle through all pictures. Marks near the head or the end move on looped or wavy paths.",
    size=(5.6, 4.8),
)
def marked_hammer(ax: AnyAxes, film: Sequence[Sequence[float]], share: float) -> None:
    """Figure 5.2: the path of a mark on the handle; ``film``: rows of t, x, z, x, z."""
    s = Sketch(ax, Frame("ground"), plane="xz")
    for row in film[::3]:
        _hammer(s, row[0])
    rest = 1 - share
    marks = [(rest * x + share * u, 0, rest * z + share * w) for _, x, z, u, w in film]
    for mark in marks:
        s.dot(mark)
    s.path(marks)
    ax.set_title(f"mark at {share:.2f} of the way from head to end", fontsize=11)


def burst(shell: BurstingProjectile) -> None:
    """Figure 5.3: the three pieces after the burst, each until it lands, and their centre of mass.
    ``shell``: a BurstingProjectile in feet and seconds.
    """
    ground = Frame("ground")
    time, height = shell.top()
    top, total = (shell.v_x * time, 0.0, height), shell.m_A + shell.m_B + shell.m_C
    pieces = {
        "A": (shell.m_A, (0.0, 0.0, shell.v_A)),
        "B": (shell.m_B, shell.v_B(ground).components(ground)),
        "C": (shell.m_C, shell.v_C(ground).components(ground)),
    }

    def flown(v, t):
        return tuple(
            p + u * t - g * t**2 / 2 for p, u, g in zip(top, v, (0, 0, shell.g), strict=True)
        )

    def place(v, t):  # a piece stays where it lands
        landed = (v[2] + math.sqrt(v[2] ** 2 + 2 * shell.g * height)) / shell.g
        return flown(v, min(t, landed))

    def centre(t):
        places = [(m, place(v, t)) for m, v in pieces.values()]
        return tuple(sum(m * p[n] for m, p in places) / total for n in range(3))

    def draw(ax, t):
        s = Sketch(ax, ground, azimuth=-60, elevation=30)
        s.axes(O, ground, length=500, labels="XYZ")
        s.ground((2050, 250, 0), ground.k, size=5400)
        s.path([flown((shell.v_x, 0.0, 0.0), u) for u in evenly(-time, 0, 30)])
        s.path([flown((shell.v_x, 0.0, 0.0), u) for u in evenly(0, time, 30)], style="dotted")
        ways = {name: lambda u, v=v: place(v, u) for name, (_, v) in pieces.items()}
        for name, way in {**ways, "G": centre}.items():
            if t:
                s.path([way(u) for u in evenly(0, t, 31)])
            s.dot(way(t), name, offset=(0, -9) if name in "CG" else (0, 9))

    interactive_figure(
        draw,
        Slider("t", 3.5, 0.0, 7.5, 0.25, label="after the burst", unit="s"),
        alt="A projectile rises along a parabola and bursts at the top into the pieces A, B and C. "
        "A goes up, B sideways, C down to the other side. Their centre of mass G keeps to the dotted "
        "line, which continues the old parabola to the ground, until C has landed.",
        size=(7, 4.2),
    )


@with_sliders(
    Slider("azimuth", 35, 15, 75, 5, label="seen from", unit="°"),
    alt="Three equal rods at right angles: one along x through the origin, one upward from one "
    "end of it, one along y from the other end. The centre of mass G lies near the origin, "
    "outside the rods.",
    size=(5.6, 4.6),
)
def three_rods(
    ax: AnyAxes, body: Body, rods: Iterable[tuple[Triple, Triple]], azimuth: float
) -> None:
    """Figure 5.4: three rods and their centre of mass; ``rods``: pairs of ends."""
    ground = Frame("ground")
    s = Sketch(ax, ground, azimuth=azimuth, elevation=22)
    s.axes(O, ground, length=0.9, labels="xyz")
    for a, b in rods:
        s.rod(a, b)
    s.dot(tuple(body.centre.position(body.frame).components(body.frame)), "G")


@with_sliders(
    Slider("h", 0.4, 0.2, 0.6, 0.05, unit="m"),
    Slider("hole", 0.08, 0.02, 0.09, 0.01, label="s", unit="m"),
    alt="A flat machine part: a rectangle with a half disk on one side and a round hole in the "
    "rectangle. Its centre of mass G lies on the axis of symmetry.",
    size=(5.6, 4.4),
)
def machine_part(
    ax: AnyAxes, build: Callable[[float, float, float], Body], h: float, hole: float
) -> None:
    """Figure 5.5: a sheet with a round end and a hole, from ``build(r, h, s)``; its centre."""
    part = build(0.3, h, hole)
    ground = Frame("ground")
    G = part.centre.position(part.frame).components(part.frame)
    s = Sketch(ax, ground, plane="yz")
    outline = [*s.around(O, (0, 0, 0.3), (-1, 0, 0), math.pi), (0, -h, -0.3), (0, -h, 0.3)]
    s.plate(outline, [s.around((0, -h / 2, 0), (0, -h / 2, hole), (1, 0, 0))])
    s.axes(O, ground, length=0.5, labels=["", "y", "z"])
    s.dot(G, "G")
    ax.set_title(f"G at y = {G[1]:.3f} m", fontsize=11)


@with_sliders(
    Slider("angle", 90, 0, 120, 5, label="turned by", unit="°"),
    Slider("shift", 0.8, 0.0, 0.8, 0.1, label="B shifted by", unit="m"),
    alt="A box with a frame x, y, z fixed in it at B, and the fixed axes X, Y, Z. The position "
    "of a particle from O is the sum of that of B and of d, which keeps its components on the "
    "moving axes.",
    size=(6.4, 4.8),
)
def body_frame(ax: AnyAxes, angle: float, shift: float) -> None:
    """Figure 5.6: a body with a frame fixed in it; a particle at r_B + d."""
    ground = Frame("ground")
    B = ground.point("B", 0.3, 0.8 + shift, 0.45)
    body = ground.rotate("body", axis=(0.3, 0.2, 1.0), angle=math.radians(angle), origin=B)
    P = body.point("P", 0.45, 0.25, 0.3)
    s = Sketch(ax, ground, azimuth=30, elevation=15)
    s.axes(O, ground, length=0.6, labels="XYZ")
    s.box(body.point("", 0.3, 0.15, 0.2), body, (0.6, 0.3, 0.4))
    s.axes(B, body, length=0.5)
    s.arrow(O, B, r"$\mathbf{r}_B$")
    s.arrow(B, P, r"$\mathbf{d}_i$")
    s.arrow(O, P, r"$\mathbf{r}_i$")
    s.dot(P)
    s.label(B, "B")


@with_sliders(
    Slider("angle", 25, 5, 60, 5, label="turned by", unit="°"),
    alt="A plate in two positions, with two frames drawn on it at different places and in "
    "different directions. From the first position to the second both have turned by the same "
    "angle.",
    size=(6.4, 4.4),
)
def two_body_frames(ax: AnyAxes, angle: float) -> None:
    """Figure 5.7: two frames fixed in one body turn by the same angle."""
    ground = Frame("ground")
    s = Sketch(ax, ground, plane="xy")
    for turned in (0.0, math.radians(angle)):
        at_1 = ground.point("O1", 0.3, 0.2, 0) if turned else ground.point("O1", 0, 0, 0)
        one = ground.rotate("1", "z", angle=turned, origin=at_1)
        at_2 = one.point("O2", 0.9, 0.3, 0)
        two = one.rotate("2", "z", angle=0.7, origin=at_2)
        corners = (-0.2, -0.2), (1.3, -0.2), (1.3, 0.7), (-0.2, 0.7)
        s.plate([one.point("", *corner, 0) for corner in corners])
        s.axes(at_1, one, length=0.35, labels=["$x_1$", "$y_1$", ""])
        s.axes(at_2, two, length=0.35, labels=["$x_2$", "$y_2$", ""])
    ax.set_title(f"both frames have turned by {angle:.0f}°", fontsize=11)


def gravity_and_height() -> None:
    """Figure 5.8: how g falls with height."""
    heights = np.geomspace(1e2, 1e8, 100)
    falls = [1 - gravity_at_height(h, EARTH) / gravity_at_height(0.0, EARTH) for h in heights]
    fig, ax = plt.subplots(figsize=(6, 3.4), layout="constrained")
    ax.loglog(heights, falls, color=BLUE, label="1 - (R/(R + h))²")
    ax.loglog(heights, 2 * heights / EARTH, color=ORANGE, ls="--", label="2h/R")
    ax.axhline(1, color=GREY, ls=":")
    ax.set(xlabel="height h (m)", ylabel="loss of g, relative", ylim=(1e-5, 20))
    ax.legend(frameon=False)
    show_figure(
        fig,
        alt="Logarithmic plot of the relative loss of gravity against height. It grows in "
        "proportion to the height, twice the height over the Earth's radius, and bends to one only "
        "at heights of the order of the radius.",
    )


@with_sliders(
    Slider("x", 0.5, -0.8, 0.8, 0.1, unit="m"),
    Slider("theta", 30, -60, 60, 5, label="θ", unit="°"),
    alt="A cart on a rail carries a pendulum. Two numbers, the place x of the cart and the angle "
    "theta of the pendulum, fix where everything is, and each can be changed alone.",
    size=(6.4, 4.0),
)
def pendulum_on_cart(ax: AnyAxes, x: float, theta: float) -> None:
    """Figure 5.9: a cart with a pendulum has two degrees of freedom."""
    ground = Frame("ground")
    cart = ground.point("C", x, 0, 0)
    a = math.radians(theta)
    bob = (x + 0.8 * math.sin(a), 0, -0.8 * math.cos(a))
    s = Sketch(ax, ground, plane="xz")
    s.line((-1.2, 0, 0), (1.2, 0, 0), style="solid")
    s.box(cart, ground, (0.4, 0.2, 0.2))
    s.rod(cart, bob)
    s.sphere(bob, 0.08)
    below = (x, 0, -0.9)
    s.line(cart, below, style="centre")
    if theta:
        s.arc(cart, *((below, bob) if theta > 0 else (bob, below)), r"$\theta$")
    if x:
        s.dimension((0, 0, 0.3), (x, 0, 0.3), "$x$")
