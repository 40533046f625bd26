"""The figures of appendix A: sums and products of vectors, and their derivatives."""

import math
from collections.abc import Callable, Sequence

from newton_euler import Frame
from newton_euler.algebra.late import plt
from newton_euler.algebra.scalars import Triple
from newton_euler.algebra.vectors import cross3, dot3
from newton_euler.classroom import Slider, interactive_figure, show_figure
from newton_euler.drawing import AnyAxes, Sketch
from newton_euler.drawing.page.projection import mean, moved, on_plane, unit3
from newton_euler.kinematics.paths import Path

from .curves import evenly, level_lines
from .sliding import with_sliders

O = (0, 0, 0)


def _in_plane(length, angle):
    """The triple of this length in the plane of x and y, at ``angle`` degrees from x."""
    return length * math.cos(math.radians(angle)), length * math.sin(math.radians(angle)), 0


def _in_space(around, up):
    """The unit triple at ``around`` degrees from x in the plane, and ``up`` degrees above it."""
    a, b = math.radians(around), math.radians(up)
    return math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), math.sin(b)


@with_sliders(
    Slider("theta", 60, 30, 150, 5, label="θ", unit="°"),
    alt="A parallelogram of the vectors P, 3 long, and Q, 4 long, with the angle theta between "
    "them. From the common tail one reaches the opposite corner by P and then Q or by Q and "
    "then P; the diagonal is their sum.",
    size=(6.4, 4.2),
)
def total(ax: AnyAxes, theta: float) -> None:
    """Figure A.1: P and Q head to tail in both orders, and their sum."""
    P, Q = _in_plane(3, 0), _in_plane(4, theta)
    both = moved(P, 1, Q)
    s = Sketch(ax, Frame("ground"), plane="xy")
    s.arrow(O, P, r"$\mathbf{P}$", "velocity")
    s.arrow(P, both, r"$\mathbf{Q}$", "acceleration")
    s.arrow(O, Q, r"$\mathbf{Q}$", "acceleration")
    s.arrow(Q, both, r"$\mathbf{P}$", "velocity")
    s.arrow(O, both, r"$\mathbf{P}+\mathbf{Q}$", "rate")
    s.arc(O, P, Q, r"$\theta$")
    ax.set_title(rf"$|\mathbf{{P}}+\mathbf{{Q}}|$ = {math.hypot(*both):.2f}", fontsize=11)


@with_sliders(
    Slider("around", 55, 30, 150, 5, label="direction in the plane of i and j", unit="°"),
    Slider("up", 35, 0, 65, 5, label="elevation", unit="°"),
    alt="A vector P of length one from the origin of three axes i, j, k. Three arrows along the "
    "axes, of the lengths of its components, lead head to tail from the origin to its tip.",
    size=(4.6, 5.0),
)
def components(ax: AnyAxes, around: float, up: float) -> None:
    """Figure A.2: a vector and its components along the axes."""
    ground, (x, y, z) = Frame("ground"), _in_space(around, up)
    s = Sketch(ax, ground, azimuth=25, elevation=25)
    s.axes(O, ground, length=1.1, labels=[r"$\hat\imath$", r"$\hat\jmath$", r"$\hat k$"])
    legs = (O, (x, 0, 0), (x, y, 0), (x, y, z))
    for tail, tip, name in zip(legs, legs[1:], "xyz", strict=False):
        if math.dist(tail, tip) > 0.02:
            s.arrow(tail, tip, f"$P_{name}$", "acceleration")
    s.arrow(O, (x, y, z), r"$\mathbf{P}$", "velocity")
    lengths = rf"$P_x = {x:.2f},\quad P_y = {y:.2f},\quad P_z = {z:.2f};\quad|\mathbf{{P}}|$ = 1"
    ax.set_title(lengths, fontsize=11)


def kite() -> None:
    """Figure A.3: a kite on a string that is tied to the top of a pole."""
    ground = Frame("ground")
    fig, ax = plt.subplots(figsize=(6, 4.4))
    s = Sketch(ax, ground, azimuth=-60, elevation=14)
    T, K = (0, 0, 2), (30, 10, 42)
    s.rod(O, T)
    s.axes(T, ground, length=14, labels=[r"$\hat\imath$", r"$\hat\jmath$", r"$\hat k$"])
    s.arrow(T, K, "string", "force")
    s.plate([(30, 10, 46), (31, 13, 42), (30, 10, 37), (29, 7, 42)])
    for tail, tip in ((T, (30, 0, 2)), ((30, 0, 2), (30, 10, 2)), ((30, 10, 2), K)):
        s.line(tail, tip)
    for place, name in (((15, 0, 2), "30 m"), ((30, 5, 2), "10 m"), ((30, 10, 20), "40 m")):
        s.label(place, name, offset=(0, -12) if place[2] < 3 else (22, 0), bold=False)
    s.label(T, "T", offset=(-12, 4))
    show_figure(
        fig,
        alt="A kite high above a short pole. The string leads from the top T of the pole to the kite; dashed "
        "lines are its components, 30 m along i, 10 m along j and 40 m along k.",
    )


@with_sliders(
    Slider("theta", 50, 5, 175, 5, label="θ", unit="°"),
    alt="P, 3 long, and Q, 2 long, from one point. A dashed line at right angles to P from the "
    "tip of Q marks the component of Q along P. It is negative where the angle is obtuse.",
    size=(6.4, 3.6),
)
def projection(ax: AnyAxes, theta: float) -> None:
    """Figure A.4: the dot product by the projection of Q on P."""
    P, Q = _in_plane(3, 0), _in_plane(2, theta)
    foot = (Q[0], 0, 0)
    s = Sketch(ax, Frame("ground"), plane="xy")
    s.line((-2.2, 0, 0), (3.2, 0, 0), style="dotted")
    s.arrow(O, P, r"$\mathbf{P}$", "velocity")
    s.arrow(O, Q, r"$\mathbf{Q}$", "acceleration")
    s.line(Q, foot)
    s.dimension(O, foot, r"$|\mathbf{Q}|\cos\theta$", offset=(0, -0.35, 0))
    if theta:
        s.arc(O, P, Q, r"$\theta$")
    of_Q = rf"|\mathbf{{Q}}|\cos\theta = {Q[0] + 0.0:.2f}"
    product = rf"\mathbf{{P}}\cdot\mathbf{{Q}} = {3 * Q[0] + 0.0:.2f}"
    ax.set_title(rf"${of_Q},\quad{product}$", fontsize=11)


@with_sliders(
    Slider("theta", 60, -180, 180, 10, label="from P to Q", unit="°"),
    alt="P and Q in a level plane with their parallelogram. Their cross product stands upright "
    "on it; its length is the area. It points downward once Q lies on the other side of P.",
    size=(6.2, 4.4),
)
def area(ax: AnyAxes, theta: float) -> None:
    """Figure A.5: the cross product and the parallelogram of P and Q."""
    ground = Frame("ground")
    P, Q = _in_plane(1.2, 0), _in_plane(1.0, theta)
    product = round(1.2 * math.sin(math.radians(theta)), 9)
    s = Sketch(ax, ground, azimuth=-65, elevation=20)  # so seen, Q is never below P x Q
    s.axes((-1.1, -1.1, 0), ground, 0.5, [r"$\hat\imath$", r"$\hat\jmath$", r"$\hat k$"])
    if abs(product) > 0.01:
        s.plate([O, P, moved(P, 1, Q), Q], shade="light")
        s.arrow(O, (0, 0, product), r"$\mathbf{P}\times\mathbf{Q}$", "rate")
    s.arrow(O, P, r"$\mathbf{P}$", "velocity")
    s.arrow(O, Q, r"$\mathbf{Q}$", "acceleration")
    if 5 < abs(theta) < 175:
        s.arc(O, P, Q, r"$\theta$")
    ax.set_title(rf"$\mathbf{{P}}\times\mathbf{{Q}} = {product + 0.0:.2f}\,\hat k$", fontsize=11)


@with_sliders(
    Slider("height", 0.8, -0.8, 0.8, 0.1, label="height of the tip of R"),
    alt="A slanted block with the edges P, Q and R from one corner. P and Q span its base. "
    "While the tip of R is above the base the triad is right-handed and the triple product is "
    "the volume; below it the product is minus the volume.",
    size=(6.2, 4.4),
)
def block(ax: AnyAxes, height: float) -> None:
    """Figure A.6: the triple scalar product as a volume with a sign."""
    ground = Frame("ground")
    P, Q, R = (1.2, 0.1, 0), (0.3, 1.0, 0), (0.25, 0.2, height)
    base = [O, P, moved(P, 1, Q), Q]
    lid = [moved(corner, 1, R) for corner in base]
    volume = dot3(P, cross3(Q, R))
    s = Sketch(ax, ground, azimuth=-65, elevation=22)
    s.plate(base, shade="light")
    for corner, above in zip(base, lid, strict=True):
        s.line(corner, above)
    for tail, tip in zip(lid, [*lid[1:], lid[0]], strict=True):
        s.line(tail, tip)
    s.arrow(O, P, r"$\mathbf{P}$", "velocity")
    s.arrow(O, Q, r"$\mathbf{Q}$", "acceleration")
    s.arrow(O, R, r"$\mathbf{R}$", "rate")
    hand = "right-handed" if volume > 0 else "left-handed" if volume < 0 else "in one plane"
    product = rf"$\mathbf{{P}}\cdot\mathbf{{Q}}\times\mathbf{{R}} = {volume + 0.0:.2f}$"
    ax.set_title(f"{product}: {hand}", fontsize=11)


@with_sliders(
    Slider("around", 20, 0, 180, 10, label="R: direction in the plane", unit="°"),
    Slider("up", 40, 20, 70, 10, label="R: elevation", unit="°"),
    alt="P and Q in a plane, their cross product upright on it, and a vector R in any "
    "direction. The double cross product (P x Q) x R lies in the plane of P and Q again, at "
    "right angles to R.",
    size=(6.4, 4.4),
)
def double_cross(ax: AnyAxes, around: float, up: float) -> None:
    """Figure A.7: (P x Q) x R lies in the plane of P and Q."""
    ground = Frame("ground")
    P, Q, R = (1.1, 0, 0), (0.5, 0.9, 0), _in_space(around, up)
    normal = cross3(P, Q)
    double = cross3(normal, R)
    s = Sketch(ax, ground, azimuth=-60, elevation=28)
    s.plate([(-1.1, -1.1, 0), (1.3, -1.1, 0), (1.3, 1.2, 0), (-1.1, 1.2, 0)], shade="light")
    s.arrow(O, P, r"$\mathbf{P}$", "velocity")
    s.arrow(O, Q, r"$\mathbf{Q}$", "velocity")
    s.arrow(O, R, r"$\mathbf{R}$", "acceleration")
    s.arrow(O, normal, r"$\mathbf{P}\times\mathbf{Q}$")
    s.arrow(O, double, r"$(\mathbf{P}\times\mathbf{Q})\times\mathbf{R}$", "rate")


@with_sliders(
    Slider("eye", -30, -45, 135, 5, label="seen from", unit="°"),
    alt="A triangle with the corners A(1,1,1), B(4,5,6) and C(2,3,7) in space. P leads from A "
    "to B, Q from A to C; an arrow at right angles to the triangle shows the direction of the "
    "normal, three times its length.",
    size=(6.2, 5.0),
)
def triangle(ax: AnyAxes, corners: Sequence[Triple], normal: Triple, eye: float) -> None:
    """Figure A.8: a triangle, two of its edges as vectors, and a normal, from a turning eye."""
    A, B, C = corners
    e = unit3(normal)
    ground = Frame("ground")
    s = Sketch(ax, ground, azimuth=eye, elevation=20)
    s.axes(O, ground, length=2.0)
    s.plate(corners, shade="light")
    s.arrow(A, B, r"$\mathbf{P}$", "velocity")
    s.arrow(A, C, r"$\mathbf{Q}$", "acceleration")
    centre = mean(corners)
    s.arrow(centre, moved(centre, 3, e), r"$\hat e$", "rate")
    for place, name in zip(corners, "ABC", strict=True):
        s.label(place, name)


@with_sliders(
    Slider("off", 0, -2.5, 2.5, 0.5, label="X off the plane"),
    alt="A piece of the plane through A, B and C with the normal N at A. The arrow AX to a "
    "point X lies in the plane, and is at right angles to N, only while X is on the plane; "
    "its product with N has one sign on each side.",
    size=(6.2, 4.8),
)
def plane(ax: AnyAxes, corners: Sequence[Triple], normal: Triple, off: float) -> None:
    """Figure A.9: a plane, its normal N at A, and a point X on it or off it."""
    A, B, C = corners
    e, along = unit3(normal), unit3(moved(B, -1, A))
    across = cross3(e, along)
    foot = on_plane(A, 4.5, along, 2, across)
    X = moved(foot, off, e)
    ground = Frame("ground")
    s = Sketch(ax, ground, azimuth=10, elevation=25)
    s.axes(O, ground, length=2.0)
    edge = (-1, -1), (8.5, -1), (8.5, 5), (-1, 5), (-1, -1)
    s.path([on_plane(A, u, along, v, across) for u, v in edge])
    s.arrow(A, moved(A, 3, e), r"$\mathbf{N}$", "rate")
    s.arrow(A, X, "", "velocity")
    s.line(foot, X)
    for place, name in ((A, "A"), (B, "B"), (C, "C"), (X, "X")):
        s.dot(place, name)
    product = off * math.hypot(*normal)
    ax.set_title(
        rf"$\overrightarrow{{AX}}\cdot\mathbf{{N}} = {product + 0.0:.1f}$; "
        rf"X is off the plane by ${off + 0.0:.1f}$",
        fontsize=11,
    )


@with_sliders(
    Slider("step", 0.8, 0.1, 1.2, 0.1, label="Δt"),
    alt="The tip of a vector P moves along a curve. Two arrows start where it is now: the "
    "difference quotient, along the chord to a later tip, and the derivative, along the "
    "tangent. The first turns into the second as the step shrinks.",
    size=(6.4, 4.4),
)
def difference(ax: AnyAxes, vector: Path, rate: Triple, now: float, step: float) -> None:
    """Figure A.10: the difference quotient of ``vector(t)`` and its limit ``rate`` at ``now``."""
    start, later = vector(now), vector(now + step)
    quotient = tuple((b - a) / step for a, b in zip(start, later, strict=True))
    miss = math.dist(quotient, rate)
    s = Sketch(ax, Frame("ground"), plane="xy")
    s.path([vector(n / 30) for n in range(70)])
    s.arrow(O, start, r"$\mathbf{P}(t)$")
    s.arrow(O, later, r"$\mathbf{P}(t+\Delta t)$")
    s.arrow(start, moved(start, 1, quotient), r"$\Delta\mathbf{P}/\Delta t$", "acceleration")
    s.arrow(start, moved(start, 1, rate), r"$d\mathbf{P}/dt$", "velocity")
    s.line(start, later)
    ax.set_title(rf"$\Delta t$ = {step:.1f}: the two differ by {miss:.3f}", fontsize=11)


@with_sliders(
    Slider("theta", 35, 20, 165, 5, label="θ", unit="°"),
    Slider("rate", 0.6, -1, 1, 0.1, label="rate of θ", unit="rad/s"),
    alt="A unit vector e at the angle theta from i, with its tip on a circle. Its rate is an "
    "arrow along the tangent at the tip, as long as the rate of theta, and backward where that "
    "is negative.",
    size=(5.6, 4.6),
)
def turning(ax: AnyAxes, theta: float, rate: float) -> None:
    """Figure A.11: a turning unit vector and its rate."""
    ground = Frame("ground")
    e, across = _in_plane(1, theta), _in_plane(1, theta + 90)
    s = Sketch(ax, ground, plane="xy")
    s.axes(O, ground, length=0.5, labels=[r"$\hat\imath$", r"$\hat\jmath$", ""])
    s.ring(O, ground.k, 1)
    s.arrow(O, e, r"$\hat e$")
    if rate:
        s.arrow(e, moved(e, rate, across), r"$\dot{\hat e}$", "velocity")
    if theta:
        s.arc(O, (1, 0, 0), e, r"$\theta$")
    ax.set_title(rf"$|\dot{{\hat e}}|$ = {abs(rate):.2f}", fontsize=11)


@with_sliders(
    Slider("turn", 30, 0, 180, 5, label="disk has turned by", unit="°"),
    alt="Left: from the ground, an arrow Q painted on a turning disk turns with the axes x, y of "
    "the disk, and its rate is at right angles to it. Right: from the disk, Q stays where it "
    "is, its rate is zero, and the axes X, Y of the ground turn backward.",
    size=(8.0, 4.2),
    panels=(1, 2),
)
def two_observers(axes: Sequence[AnyAxes], turn: float) -> None:
    """Figure A.12: a vector fixed in a turning frame, by two observers."""
    ground = Frame("ground")
    disk = ground.rotate("disk", "z", math.radians(turn))
    back = ground.rotate("ground from the disk", "z", -math.radians(turn))
    fixed, turning = ["X", "Y", ""], ["x", "y", ""]
    for ax, Q, title, own, other, labels in zip(
        axes,
        (disk.vector(0.8, 0.4, 0), ground.vector(0.8, 0.4, 0)),
        ("seen from the ground", "seen from the disk"),
        (fixed, turning),
        (disk, back),
        (turning, fixed),
        strict=True,
    ):
        s = Sketch(ax, ground, plane="xy")
        s.ring(O, ground.k, 1.1)
        s.axes(O, ground, length=0.5, labels=own)
        s.axes(O, other, length=0.5, labels=labels)
        tip = Q.components(ground)
        s.arrow(O, tip, r"$\mathbf{Q}$")
        if other is disk:
            rate = ground.k.cross(Q).components(ground)
            s.arrow(tip, moved(tip, 0.6, rate), r"$d\mathbf{Q}/dt$", "velocity")
        ax.set_title(title, fontsize=11)


def hill(
    height: Callable[[float, float], float], slope: Callable[[float, float], tuple[float, float]]
) -> None:
    """Figure A.13: level lines of ``height(x, y)``, its gradient ``slope(x, y)``, and a walk."""
    xs, ys = evenly(-2, 2, 25), evenly(-1.5, 1.5, 19)
    heights = [height(x, y) for x in xs for y in ys]
    levels = evenly(min(heights), max(heights), 9)[1:-1]
    lines = [
        [(*place, 0) for place in line]
        for level in levels
        for line in level_lines(height, level, xs, ys)
    ]

    def draw(ax, across, way):
        here, e = (across, 0.5, 0), _in_plane(1, way)
        uphill = (*slope(across, 0.5), 0)
        s = Sketch(ax, Frame("ground"), plane="xy")
        for line in lines:
            s.path(line, style="dotted")
        s.arrow(here, moved(here, 0.6, uphill), r"$\nabla f$", "velocity")
        s.arrow(here, moved(here, 0.6, e), r"$\hat e$", "acceleration")
        s.dot(here)
        s.axes((-2, -1.5, 0), s.frame, 0.6, ["x", "y", ""])
        along = rf"$\nabla f\cdot\hat e = {dot3(uphill, e) + 0.0:.2f}$"
        ax.set_title(f"slope along the walk: {along}", fontsize=11)

    interactive_figure(
        draw,
        Slider("across", 0.8, -1.2, 1.2, 0.2, label="x of the walker"),
        Slider("way", 150, 0, 360, 10, label="direction of the walk", unit="°"),
        alt="A map of a hill by its level lines. At the walker an arrow, the gradient, points uphill "
        "at right angles to the level line; a second arrow is the direction of the walk. The slope "
        "along the walk is the component of the gradient along it.",
        size=(6.4, 5.0),
    )
