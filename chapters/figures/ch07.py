"""The figures of chapter 7: angular momentum, moments of inertia, principal axes, other points."""

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from newton_euler import Body, Frame, Vector, composite, particle
from newton_euler.algebra.late import plt
from newton_euler.bodies import plate
from newton_euler.chapters.examples.ch07 import three_rods
from newton_euler.classroom import Slider, interactive_figure, show_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved

from .colours import BLUE, GREEN, ORANGE
from .curves import evenly
from .sliding import with_sliders

O = (0, 0, 0)
Dumbbell: TypeAlias = Callable[[float, float], tuple[Frame, Frame, Body]]  # ground, axle, body
RODS = (((-0.5, 0, 0), (-0.5, 0, 1)), ((-0.5, 0, 0), (0.5, 0, 0)), ((0.5, 0, 0), (0.5, 1, 0)))


def angle_between(v: Vector, w: Vector) -> float:
    """The angle between two Vectors, in degrees."""
    return math.degrees(math.atan2(float(v.cross(w).norm()), float(v.dot(w))))


def draw_dumbbell(s: Sketch, body: Body) -> None:
    """The shaft, the rod and the balls."""
    one, other = (part.centre for part in body.parts)
    s.shaft((0, 0, -0.55), (0, 0, 0.55))
    s.rod(one, other)
    s.sphere(one, 0.06)
    s.sphere(other, 0.06)


def _dumbbell(s, axle, body):
    """Draw the dumbbell, and omega and H at O."""
    draw_dumbbell(s, body)
    s.vector(O, axle.angular_velocity(s.frame), r"$\omega$", kind="rate", size="rad/s")
    s.vector(O, body.angular_momentum(s.frame), r"$\mathbf{H}$", kind="plain", size="kg m²/s")
    s.label(O, "O")


@with_sliders(
    Slider("tilt", 35, 5, 90, 5, label="β", unit="°"),
    Slider("turn", 0, 0, 360, 10, label="turned", unit="°"),
    alt="Two balls at the ends of a light rod that is fixed at a slant to a vertical shaft. "
    "The angular velocity omega points along the shaft; the angular momentum H is at right "
    "angles to the rod, and goes round with it.",
    size=(6.4, 4.8),
)
def turning_dumbbell(ax: AnyAxes, build: Dumbbell, tilt: float, turn: float) -> None:
    """Figure 7.1: omega and H of a dumbbell, from ``build(tilt, turn)``."""
    ground, axle, body = build(math.radians(tilt), math.radians(turn))
    s = Sketch(ax, ground, azimuth=-65, elevation=18, arrows=90)
    _dumbbell(s, axle, body)
    s.arc(O, (0, 0, 1), body.parts[0].centre, r"$\beta$")
    omega, H = axle.angular_velocity(ground), body.angular_momentum(ground)
    ax.set_title(f"angle between ω and H: {angle_between(omega, H):.0f}°", fontsize=11)


def dumbbell_film(build: Dumbbell) -> Animation:
    """A film: H goes round with the rod."""

    def draw(t, ax):
        ground, axle, body = build(math.radians(35), 2.0 * t)
        s = Sketch(ax, ground, azimuth=-65, elevation=18, arrows=90)
        tip = axle.vector(-math.cos(math.radians(35)), 0, math.sin(math.radians(35))) * 0.42
        s.ring((0, 0, float(tip.expressed_in(ground).z)), ground.k, 0.42 * math.cos(0.611))
        _dumbbell(s, axle, body)

    return animate(
        draw,
        evenly(0, math.pi, 25),
        alt="The dumbbell turns about the shaft; omega stays where it is, H runs round on a cone.",
    )


@with_sliders(
    Slider("turn", 30, 0, 360, 5, label="angle", unit="°"),
    alt="Left: a rod with a ball at each end in the plane of x and y, at an angle to x. Right: "
    "I_xx and I_yy against that angle, never negative, and I_xy, positive while the balls "
    "are in the first and third quadrants and negative while they are in the others.",
    size=(8.4, 3.9),
    panels=(1, 2),
)
def two_balls(axes: Sequence[AnyAxes], turn: float) -> None:
    """Figure 7.2: two balls in the plane, and their moments and product of inertia."""
    ground, a = Frame("ground"), math.radians(turn)
    A, B = (math.cos(a), math.sin(a), 0), (-math.cos(a), -math.sin(a), 0)
    s = Sketch(axes[0], ground, plane="xy")
    s.axes(O, ground, length=1.25, labels=["x", "y", ""])
    s.rod(A, B)
    s.line(A, (A[0], 0, 0))
    s.line(A, (0, A[1], 0))
    s.sphere(A, 0.08)
    s.sphere(B, 0.08)
    degrees = range(0, 361, 3)
    for label, f, colour, style in (
        ("$I_{xx}$", lambda a: math.sin(a) ** 2, BLUE, "-"),
        ("$I_{yy}$", lambda a: math.cos(a) ** 2, ORANGE, "--"),
        ("$I_{xy}$", lambda a: math.sin(a) * math.cos(a), GREEN, "-."),
    ):
        _curve(axes[1], degrees, f, turn, style, colour, label)
    axes[1].axhline(0, color="black", lw=0.8)
    axes[1].set(xlabel="angle from x to the rod (°)", xticks=range(0, 361, 90))
    axes[1].set(ylabel="in units of m d²", ylim=(-0.65, 1.1))
    axes[1].legend(frameon=False, ncol=3, loc="lower center", fontsize=9)


def _curve(ax, degrees, f, now, style, colour, label):
    """A function of an angle, with a dot at the angle ``now``."""
    ax.plot(degrees, [f(math.radians(x)) for x in degrees], style, color=colour, label=label)
    ax.plot([now], [f(math.radians(now))], "o", color=colour)


def racket() -> None:
    """Figure 7.3: a racket that hangs from a nail, with its axes, its centre of mass and the hand."""
    page = Frame("page")
    fig, ax = plt.subplots(figsize=(6.4, 3.4))
    s = Sketch(ax, page, plane="xy")
    head = [(0.51 + 0.17 * math.cos(a), 0.13 * math.sin(a), 0) for a in evenly(0, 2 * math.pi, 73)]
    s.path(head)
    for y in evenly(-0.09, 0.09, 7):
        reach = 0.17 * math.sqrt(1 - (y / 0.13) ** 2)
        s.line((0.51 - reach, y, 0), (0.51 + reach, y, 0), style="solid")
    s.rod((0, 0, 0), (0.34, 0, 0))
    s.axes(O, page, length=0.16, labels=["x", "y", ""])
    s.ring(O, page.k, 0.012)  # a dot in a ring: z points at the reader
    s.label(O, "$z$", offset=(-13, 0), bold=False)
    for x, name in ((0.0, "nail"), (0.1, "hand"), (0.32, "G")):
        s.dot((x, 0, 0))
        s.label((x, 0, 0), name, offset=(18 if x < 0.2 else 0, 12), bold=name == "G")
    s.dimension((0, 0, 0), (0.1, 0, 0), "10 cm", offset=-0.06)
    s.dimension((0, 0, 0), (0.32, 0, 0), "32 cm", offset=-0.13)
    show_figure(
        fig,
        alt="A tennis racket from above, its handle along x from a nail at the end of the handle. The hand is "
        "10 cm and the centre of mass G 32 cm from the nail; y lies in the plane of the strings, z "
        "points at the reader.",
    )


@with_sliders(
    Slider("b", 0, 0, 1, 0.05, label="B at", unit="ℓ"),
    alt="Left: a thin rod of length l with the point B on it and the axes x and z. Right: x "
    "squared over the length of the rod, with x measured from B; the shaded area under it is "
    "the moment of inertia, least when B is at the middle.",
    size=(8.4, 3.4),
    panels=(1, 2),
)
def rod_and_point(axes: Sequence[AnyAxes], b: float) -> None:
    """Figure 7.4: the thin rod, the point B on its line, and the integrand of I_yy."""
    ground = Frame("ground")
    B = (b, 0, 0)
    s = Sketch(axes[0], ground, plane="xz")
    s.rod(O, (1, 0, 0))
    s.axes(B, ground, length=0.3, labels=["x", "", "z"])
    s.dot(B, "B")
    s.dimension(O, (1, 0, 0), r"$\ell$", offset=-0.15)
    x = evenly(-b, 1 - b, 101)
    squares = [q * q for q in x]
    axes[1].fill_between(x, squares, color=BLUE, alpha=0.35)
    axes[1].plot(x, squares, color=BLUE)
    moment = ((1 - b) ** 3 + b**3) / 3
    axes[1].set(xlim=(-1.05, 1.05), ylim=(0, 1.1), xlabel="x/ℓ, from B", ylabel="x²/ℓ²")
    axes[1].set_title(rf"area under the curve: $I_{{yy}}/m\ell^2$ = {moment:.4f}", fontsize=11)


@with_sliders(
    Slider("view", 30, 15, 75, 5, label="seen from", unit="°"),
    alt="Three equal rods joined at right angles. Rod 2 lies on the x axis with its middle at "
    "the origin B; rod 1 goes up along z from its end at negative x, rod 3 goes along y from "
    "its end at positive x.",
    size=(6, 4.4),
)
def three_rods_view(ax: AnyAxes, view: float) -> None:
    """Figure 7.5: the three rods, from all sides."""
    ground = Frame("ground")
    s = Sketch(ax, ground, azimuth=view, elevation=22)
    draw_rods(s, ground)
    s.axes(O, ground, length=0.75)
    for place, name in (((-0.5, 0, 0.6), "1"), ((-0.25, 0, 0), "2"), ((0.5, 0.6, 0), "3")):
        s.label(place, name, bold=False)
    s.label(O, "B")


def draw_rods(s: Sketch, frame: Frame) -> None:
    """The three rods, with B at the origin of a frame."""
    for A, B in RODS:
        s.rod(frame.point("", *A), frame.point("", *B))


@with_sliders(
    Slider("turn", 40, 0, 180, 5, label="axis at", unit="°"),
    Slider("b", 0.6, 0.6, 1.2, 0.3, label="b", unit="m"),
    alt="Left: a rectangular plate with its inertia ellipse and an axis through its centre "
    "that carries omega. H is at right angles to the tangent of the ellipse where the axis "
    "meets it. Right: the moment about the axis and the product of inertia against its angle; "
    "the product is zero where the moment is largest or least.",
    size=(8.8, 4.2),
    panels=(1, 2),
)
def plate_and_ellipse(axes: Sequence[AnyAxes], turn: float, b: float) -> None:
    """Figure 7.6: a plate, an axis in its plane, omega and H, and the ellipse of inertia."""
    ground, a = Frame("ground"), 1.2
    I = plate(a, b, ground, "z", mass=12.0).about(ground)
    n = ground.vector(math.cos(math.radians(turn)), math.sin(math.radians(turn)), 0)
    H = I.times(n)
    s = Sketch(axes[0], ground, plane="xy", arrows=80)
    s.plate([(x * a / 2, y * b / 2, 0) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))])
    s.path(_ellipse(I, 0.9))
    s.axes(O, ground, length=1.15, labels=["x", "y", ""])
    s.vector(O, n, r"$\omega$", kind="rate")
    s.vector(O, H, r"$\mathbf{H}$", kind="plain")
    P = tuple(0.9 * math.sqrt(b * b / I.moment(n)) * x for x in n.components())
    along = (ground.k.cross(H) * (0.4 / float(H.norm()))).components()
    s.line(moved(P, -1, along), moved(P, 1, along))
    s.dot(P)
    axes[0].set_title(f"angle between ω and H: {angle_between(n, H):.0f}°", fontsize=11, pad=14)
    _moments_over_angle(axes[1], I, turn)


def _ellipse(I, scale):
    """The points at the distance sqrt(I_xx/I(n)) times ``scale`` in each direction n of the plane."""
    (xx, yy, _), (xy, *_) = I.moments, I.products
    out = []
    for a in evenly(0, 2 * math.pi, 73):
        c, s = math.cos(a), math.sin(a)
        r = scale * math.sqrt(xx / (xx * c * c + yy * s * s - 2 * xy * s * c))
        out.append((r * c, r * s, 0))
    return out


def _moments_over_angle(ax, I, here):
    """The moment about an axis of the plane, and the product with the axis across it."""
    xx, yy, _ = I.moments

    def moment(a):
        return xx * math.cos(a) ** 2 + yy * math.sin(a) ** 2

    def product(a):
        return (yy - xx) * math.sin(a) * math.cos(a)

    degrees = range(0, 181, 2)
    _curve(ax, degrees, moment, here, "-", BLUE, "moment about the axis")
    _curve(ax, degrees, product, here, "--", ORANGE, "product with the axis across")
    ax.axhline(0, color="black", lw=0.8)
    ax.set(xlabel="angle of the axis (°)", xticks=range(0, 181, 45), ylabel="kg m²")
    ax.set(ylim=(-0.9, 2.2))
    ax.legend(frameon=False, fontsize=9, loc="upper right")


def rods_and_axis() -> None:
    """Figure 7.7: the axis of turning goes from x to the three principal axes one after another."""
    ground = Frame("ground")
    I = three_rods(12.0, 1.0, ground).about(ground)
    ends = (1.0, 0, 0), (2.0, 1, -1), (0, 1.0, 1), (1.0, -1, 1)
    stops = [ground.vector(*v).direction() for v in ends]
    way = evenly(0, 3, 121)

    def direction(s):
        k = min(int(s), 2)
        return ((1 - s + k) * stops[k] + (s - k) * stops[k + 1]).direction()

    moments = [I.moment(direction(s)) for s in way]
    apart = [angle_between(direction(s), I.times(direction(s))) for s in way]

    def draw(axes, at):
        n = direction(at)
        s = Sketch(axes[0], ground, azimuth=30, elevation=22, arrows=85)
        draw_rods(s, ground)
        s.axes(O, ground, length=0.75)
        for e, name in zip(stops[1:], ("5", "11", "14"), strict=True):
            s.line(-0.7 * e, 0.7 * e, style="centre")
            s.label(0.76 * e, name, bold=False)
        s.vector(O, n, r"$\omega$", kind="rate")
        s.vector(O, I.times(n), r"$\mathbf{H}$", kind="plain")
        angle = angle_between(n, I.times(n))
        axes[0].set_title(f"angle between ω and H: {angle:.1f}°", fontsize=11)
        axes[1].plot(way, moments, color=BLUE, label="moment (units of $m\\ell^2/12$)")
        axes[1].plot(way, apart, "--", color=ORANGE, label="angle between ω and H (°)")
        axes[1].axvline(at, color="black", lw=0.8)
        axes[1].set(xticks=range(4), ylim=(0, 36))
        axes[1].set_xticklabels(["x", "(2, 1, −1)", "(0, 1, 1)", "(1, −1, 1)"])
        axes[1].legend(frameon=False, fontsize=9, loc="upper right")

    interactive_figure(
        draw,
        Slider("at", 0, 0, 3, 0.1, label="how far it has gone"),
        alt="Left: the three rods with the axes x, y and z, their three principal axes, "
        "dash-dotted and named by their moments, an axis of turning omega, and H. Right: moment "
        "about that axis and angle between omega and H as the axis goes from x to each principal "
        "axis; the angle is zero at these, where the moments are 5, 11 and 14.",
        size=(9.2, 4.4),
        panels=(1, 2),
    )


@with_sliders(
    Slider("blades", 2, 2, 4, 1, label="blades"),
    Slider("turn", 30, 0, 90, 15, label="turned", unit="°"),
    alt="Left: a propeller of straight blades in the plane of x and y. Right: its moment about "
    "x divided by that about z, against the angle by which it is turned: a wave between 0 and "
    "1 for two blades, a straight line at one half for three or more.",
    size=(8.4, 3.9),
    panels=(1, 2),
)
def propeller(axes: Sequence[AnyAxes], blades: float, turn: float) -> None:
    """Figure 7.8: a propeller with n blades, and its moment about a fixed axis in its plane."""
    blades, ground = round(blades), Frame("ground")

    def angles(turned):
        return [turned + 2 * math.pi * n / blades for n in range(blades)]

    def moment(turned):
        return sum(math.sin(a) ** 2 for a in angles(turned)) / blades

    s = Sketch(axes[0], ground, plane="xy")
    s.axes(O, ground, length=1.2, labels=["x", "y", ""])
    for a in angles(math.radians(turn)):
        s.rod(O, (math.cos(a), math.sin(a), 0))
    s.hinge(O)
    _curve(axes[1], range(0, 181, 2), moment, turn, "-", BLUE, "$I_{xx}$")
    axes[1].set(ylim=(-0.05, 1.05), xlabel="turned by (°)", xticks=range(0, 181, 45))
    axes[1].set(ylabel="$I_{xx}/I_{zz}$")


@with_sliders(
    Slider("place", 75, 0, 360, 15, label="particle", unit="°"),
    alt="The outline of a body with a body-fixed point B, the centre of mass G and a particle i. "
    "The vector d_i from B to the particle is the sum of d from B to G and rho_i from G to "
    "the particle.",
    size=(6, 3.8),
)
def vectors_to_particle(ax: AnyAxes, place: float) -> None:
    """Figure 7.9: B, G and a particle, with d, rho_i and d_i."""
    ground = Frame("ground")
    s = Sketch(ax, ground, plane="xy")
    G = (1.3, 0.55, 0)
    a = math.radians(place)
    P = (G[0] + 0.95 * math.cos(a), G[1] + 0.6 * math.sin(a), 0)
    around = evenly(0, 2 * math.pi, 61)
    s.path([(1.05 + 1.5 * math.cos(a), 0.45 + 0.95 * math.sin(a), 0) for a in around])
    s.arrow(O, G, r"$\mathbf{d}$", kind="force")
    s.arrow(G, P, r"$\mathbf{\rho}_i$", kind="velocity")
    s.arrow(O, P, r"$\mathbf{d}_i$")
    for point, name in ((O, "B"), (G, "G"), (P, "i")):
        s.dot(point, name)


def shifted_axis(build: Callable[[], Body]) -> None:
    """Figure 7.10: the moment of the three rods about axes parallel to x, from ``build()``."""
    body = build()
    frame, mass, G = body.frame, float(body.mass), body.centre
    least = float(body.inertia.moments[0])
    far = evenly(0, 0.9, 60)

    def draw(axes, away, turn):
        y, z = away * math.cos(math.radians(turn)), away * math.sin(math.radians(turn))
        P = frame.point("P", 0, 1 / 6 + y, 1 / 6 + z)
        moment = float(body.about(P).moments[0])
        s = Sketch(axes[0], frame, plane="yz")
        draw_rods(s, frame)
        s.axes(O, frame, length=0.45, labels=["", "y", "z"])
        s.ring(G, frame.i, away or 1e-3)
        s.line(G, P)
        for place, name in ((O, "B"), (G, "G"), (P, "P")):
            s.dot(place, name)
        axes[1].plot(far, [least + mass * x * x for x in far], color=BLUE)
        axes[1].plot([away], [moment], "o", color=ORANGE)
        axes[1].axhline(least, color="black", lw=0.8, ls="--", label="about G")
        axes[1].set(xlabel="distance of the axis from G (m)", ylabel="moment (kg m²)")
        axes[1].set(xlim=(0, 0.9), ylim=(0, least + mass * 0.8))
        axes[1].legend(frameon=False, loc="upper left")

    interactive_figure(
        draw,
        Slider("away", 0.4, 0, 0.8, 0.2, label="distance of P from G", unit="m"),
        Slider("turn", 0, 0, 270, 90, label="direction of GP", unit="°"),
        alt="Left: the three rods seen along x, with the centre of mass G, a point P through which "
        "the axis goes, and the circle about G through P. Right: the moment about that axis "
        "against its distance from G, a parabola whose least value is that for the axis through G.",
        size=(8.6, 4),
        panels=(1, 2),
    )


@with_sliders(
    Slider("b", 0, 0, 1, 0.05, label="B at", unit="ℓ"),
    alt="A rod, an axis at right angles to it through a point B of the rod, and a circle about "
    "B whose radius is the radius of gyration; the centre of mass of the rod is always inside.",
    size=(5.6, 4.6),
)
def ring_of_gyration(ax: AnyAxes, b: float) -> None:
    """Figure 7.11: a rod about an axis across it, and the ring of the same mass and moment."""
    ground, k = Frame("ground"), math.sqrt(1 / 12 + (b - 0.5) ** 2)
    s = Sketch(ax, ground, plane="xy")
    s.rod((-b, 0, 0), (1 - b, 0, 0))
    s.ring(O, ground.k, k)
    s.dot(O)
    s.dot((0.5 - b, 0, 0), "G")
    s.label(O, "B")
    s.arrow(O, (0.6 * k, 0.8 * k, 0), "$k$")
    ax.set_title(f"k = {k:.3f} ℓ, G at {abs(b - 0.5):.2f} ℓ", fontsize=11)


@with_sliders(
    Slider("h", 0.2, 0.1, 0.3, 0.01, unit="m"),
    Slider("s", 0.03, 0.01, 0.045, 0.005, unit="m"),
    alt="A flat machine part in the plane of y and z: a rectangle of width 2 r and height h "
    "above the y axis, with a round hole of radius s in its middle, and half a disk of radius "
    "r below. The centre of mass G lies on the z axis.",
    size=(5.6, 5),
)
def machine_part(
    ax: AnyAxes, build: Callable[[float, float, float], Body], h: float, s: float
) -> None:
    """Figure 7.12: the machine part, from ``build(r, h, s)``."""
    r = 0.1
    body = build(r, h, s)
    frame = body.frame
    sketch = Sketch(ax, frame, plane="yz")
    corners = [(0, r, 0), (0, r, h), (0, -r, h), (0, -r, 0)]
    round_end = sketch.around(O, (0, -r, 0), frame.i, math.pi)
    hole = sketch.around((0, 0, h / 2), (0, s, h / 2), frame.i)
    sketch.plate([*corners, *round_end], [hole])
    sketch.axes(O, frame, length=0.16, labels=["", "y", "z"])
    sketch.dot(body.centre, "G")
    sketch.dimension((0, -r, 0), (0, -r, h), "h", offset=0.02)
    sketch.dimension((0, -r, h), (0, 0, h), "r", offset=0.02)
    xx, yy, zz = (1e3 * float(x) for x in body.about(frame).moments)
    moments = rf"$I_{{xx}}$ = {xx:.2f}, $I_{{yy}}$ = {yy:.2f}, $I_{{zz}}$ = {zz:.2f} g m²"
    ax.set_title(moments, fontsize=11)


def particles_along(length: float, count: int, mass: float, frame: Frame, start: float) -> Body:
    """``count`` equal particles, in the middles of equal parts of a rod along x from ``start``."""
    step = length / count
    places = (frame.point("", start + (n + 0.5) * step, 0, 0) for n in range(count))
    parts = [particle(mass / count, place, f"{n}") for n, place in enumerate(places)]
    return composite("particles", parts)
