"""The figures of chapter 3: a path and its triad, cylindrical and spherical axes."""

import math

from newton_euler import Frame, at, cylindrical, spherical
from newton_euler.algebra.scalars import Scalar
from newton_euler.chapters.examples.ch03 import Spring, screw_jack_ball, screw_jack_time
from newton_euler.classroom import Slider
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved
from newton_euler.kinematics import frenet_along
from newton_euler.kinematics.paths import Path, along

from .curves import evenly, second_derivative
from .sliding import with_sliders

O = (0, 0, 0)
TRIAD = [r"$\hat e_t$", r"$\hat e_n$", r"$\hat e_b$"]


def _curve(path, low, high, count=61):
    """Places along ``path`` between two values of its parameter."""
    return [path(q) for q in evenly(low, high, count)]


@with_sliders(
    Slider("q", 0.3, -0.9, 0.9, 0.1),
    alt="A curve in space with fixed axes X, Y, Z. At the point P the position vector r from "
    "the origin, the velocity along the tangent and the acceleration, which points to the "
    "inside of the bend.",
    size=(6.4, 4.6),
)
def space_curve(ax: AnyAxes, path: Path, q: float) -> None:
    """Figure 3.1: a point on a space curve, from ``path(q)``, at constant speed in q."""
    ground = Frame("ground")
    P = ground.point("P", *along(path, at(lambda t: q + t, 0.0)))
    s = Sketch(ax, ground, azimuth=-60, elevation=25)
    s.axes(O, ground, length=0.8, labels="XYZ")
    s.path(_curve(path, -1.0, 1.0))
    s.arrow(O, P, r"$\mathbf{r}$")
    s.vector(P, P.velocity(ground), r"$\mathbf{v}$", size="")
    s.vector(P, P.acceleration(ground), r"$\mathbf{a}$", kind="acceleration")
    s.label(P, "P")


@with_sliders(
    Slider("q", 0.0, -0.4, 0.2, 0.1),
    alt="The unit vectors e_t, e_n, e_b at a point of a space curve, and the circle that fits "
    "the curve best there. It lies in the plane of e_t and e_n; its centre is at the distance "
    "rho along e_n.",
    size=(6.4, 4.8),
)
def triad(ax: AnyAxes, path: Path, q: float) -> None:
    """Figure 3.2: the triad e_t, e_n, e_b and the circle of curvature at a point of ``path``."""
    ground = Frame("ground")
    here = frenet_along(path, at(lambda t: q + t, 0.0), ground)
    P, rho = path(q), here.radius
    centre = moved(P, rho, here.e_n.components(ground))
    s = Sketch(ax, ground, azimuth=-60, elevation=25)
    s.path(_curve(path, -1.0, 1.0))
    s.path([*s.around(centre, P, here.e_b), P], style="dashed")
    s.dot(centre)
    s.line(P, centre)
    s.axes(P, here.frame, length=0.7, labels=TRIAD)
    s.label(P, "P")
    ax.set_title(rf"$\rho$ = {rho:.2f}, $\tau$ = {here.torsion:.2f}", fontsize=11)


@with_sliders(
    Slider("slope", 35, 0, 85, 5, label="slope of the wire", unit="°"),
    alt="A coil spring whose wire keeps its length. The steeper the wire, the smaller the "
    "radius of the coil: the flexure falls towards zero and the torsion grows to a finite limit.",
    size=(5.6, 5.2),
)
def spring(ax: AnyAxes, slope: float) -> None:
    """Figure 3.3: a spring that is drawn out, from flat to nearly straight."""
    ground = Frame("ground")
    wire = Spring.drawn_out(0.2, math.radians(slope))
    s = Sketch(ax, ground, azimuth=-60, elevation=25)
    turns = 1.5 * 2 * math.pi
    for half in range(-1, 4):  # half turns, every other one behind the axis
        first = math.radians(-60) + math.pi * (half - 0.5)
        low, high = max(0.0, first), min(turns, first + math.pi)
        if low < high:
            piece = _curve(wire.path, low, high, 41)
            s.path(piece, style="dashed") if half % 2 else s.wire(piece)
    s.line(O, (0, 0, 1.2 * turns * wire.rise + 0.1), style="centre")
    here = wire.intrinsic(at(lambda t: 1.0 + t, 0.0), ground)
    s.axes(wire.path(1.0), here.frame, length=0.28, labels=TRIAD)
    flexure, torsion = f"$f$ = {wire.flexure:.2f}", rf"$\tau$ = {wire.torsion + 0.0:.2f}"
    ax.set_title(f"{flexure}, {torsion} per metre", fontsize=11)


@with_sliders(
    Slider("turns", 2.0, 0.5, 3.0, 0.5, label="turns of the rope"),
    alt="A rope winds round an upright bollard, the ship's end below and the hand's end above. The "
    "more turns, the larger the ratio of the two pulls.",
    size=(6.4, 4.6),
)
def bollard(ax: AnyAxes, turns: float) -> None:
    """Figure 3.4: a rope round a bollard, between a ship and a hand."""
    ground, radius, rise, start = Frame("ground"), 0.2, 0.012, -math.pi / 2
    s = Sketch(ax, ground, azimuth=-60, elevation=25)
    s.ground((0, 0, 0), ground.k, size=1.3)
    s.cylinder((0, 0, 0), (0, 0, 0.5), radius)
    s.cylinder((0, 0, 0.5), (0, 0, 0.56), 0.25)
    angles = [start + math.pi * n / 40 for n in range(int(80 * turns) + 1)]
    for strand in (-0.005, 0.0, 0.005):  # strands of the rope
        rope = [
            (radius * math.cos(q), radius * math.sin(q), 0.15 + strand + rise * (q - start))
            for q in angles
        ]
        front = [(-0.2 + 0.05 * n, -radius, 0.15 + strand) for n in range(4)]
        s.path(front + rope, on=((0, 0, 0), (0, 0, 0.5)))
    q = angles[-1]
    hand = (rope[-1][0], rope[-1][1], rope[-1][2] - 0.005)
    off = moved(hand, 0.5, (-math.sin(q), math.cos(q), 0))
    s.wire([(-0.6, -radius, 0.15), (-0.2, -radius, 0.15)])
    s.wire([hand, off])
    s.vector((-0.6, -radius, 0.15), (-1, 0, 0), "$T_1$, ship", kind="force")
    s.vector(off, (-0.4 * math.sin(q), 0.4 * math.cos(q), 0), "$T_0$, hand", kind="force")
    ax.set_title(f"$T_1/T_0$ = {math.exp(0.4 * math.pi * turns):.1f}", fontsize=11)


@with_sliders(
    Slider("angle", 40, 5, 60, 5, label="f ds", unit="°"),
    alt="A short piece of cable that bends downward. Its ends are pulled along their tangents "
    "by T and T + dT; since the two pulls are not parallel, they have a resultant along e_n, "
    "which the load p ds balances.",
    size=(6.4, 3.6),
)
def cable_element(ax: AnyAxes, angle: float) -> None:
    """Figure 3.5: an element of a cable with the tensions at its ends."""
    ground = Frame("ground")
    s = Sketch(ax, ground, plane="xy")
    half = math.radians(angle) / 2
    ends = [(math.sin(a), math.cos(a) - 1, 0) for a in (-half, half)]
    angles = evenly(-half, half, 31)
    s.wire([(math.sin(a), math.cos(a) - 1, 0) for a in angles])
    for end, a, sign, label in (
        (ends[0], -half, -1, r"$-T\,\hat{e}_t$"),
        (ends[1], half, 1, r"$(T+dT)(\hat{e}_t+d\hat{e}_t)$"),
    ):
        t = (sign * math.cos(a), -sign * math.sin(a), 0)
        s.vector(end, t, label, kind="force")
    s.vector(O, (0, 2 * math.sin(half), 0), r"$\mathbf{p}\,ds$", kind="force")
    sag = 2 * math.sin(half)
    ax.set_title(rf"$T f ds$ = {2 * half:.3f} $T$; exactly {sag:.3f} $T$", fontsize=11)


@with_sliders(
    Slider("theta", 60, 40, 150, 5, label="θ", unit="°"),
    Slider("z", 0.7, 0.3, 1.0, 0.1, unit="m"),
    alt="Cylindrical coordinates of a point P: r along the ground, the angle theta from X, the "
    "height z. At P the unit vectors e_r outward, e_theta at right angles to it, and k upward; "
    "the first two turn with theta.",
    size=(6.2, 4.6),
)
def cylindrical_axes(ax: AnyAxes, theta: float, z: float) -> None:
    """Figure 3.6: cylindrical coordinates and axes."""
    ground = Frame("ground")
    P = cylindrical(ground, "P", 0.9, math.radians(theta), z)
    x, y, _ = P.position(ground).components(ground)
    foot = (x, y, 0)
    s = Sketch(ax, ground, azimuth=25, elevation=25)
    s.axes(O, ground, length=0.6, labels="XYZ")
    s.arrow(O, P)
    s.line(O, foot, style="solid")
    s.line(foot, P)
    s.label((x / 2, y / 2, 0), "$r$")
    s.label((x, y, z / 2), "$z$")
    s.arc(O, ground.i, foot, label=r"$\theta$")
    axes = P.velocity(ground).frame
    s.axes(P, axes, length=0.4, labels=[r"$\hat e_r$", r"$\hat e_\theta$", r"$\hat k$"])
    s.label(P, "P")


def _jack(ax, ground, A, arrows):
    """A sketch of the screw on its ground and the ball A on its arm."""
    s = Sketch(ax, ground, azimuth=35, elevation=22, arrows=arrows)
    s.ground((0, 0, -0.1), ground.k, size=0.5)
    s.shaft((0, 0, -0.1), (0, 0, 0.45))
    s.rod((0, 0, A.position(ground).components(ground)[2]), A)
    s.sphere(A, 0.015)
    return s


@with_sliders(
    Slider("turns", 0.4, 0.1, 1.0, 0.1, label="turns from rest"),
    alt="An arm with a ball turns about a vertical screw and rises with it. The velocity is "
    "tangent to the helix; the acceleration soon points almost to the axis.",
    size=(6.2, 5.0),
)
def screw_jack(ax: AnyAxes, turns: float) -> None:
    """Figure 3.7: the ball of a screw-jack."""
    b, K, lead = 0.3, 2.0, 0.15
    ground = Frame("ground")
    A = screw_jack_ball(ground, b, K, lead, screw_jack_time(turns, K))
    s = _jack(ax, ground, A, arrows=170)
    s.path(_curve(Spring(b, lead / (2 * math.pi)).path, 0, 2 * math.pi))
    s.vector(A, A.velocity(ground), r"$\mathbf{v}$", size="m/s")
    s.vector(A, A.acceleration(ground), r"$\mathbf{a}$", kind="acceleration", size="m/s²")
    s.axes(O, ground, length=0.4, labels="XYZ")
    s.label(A, "A")


@with_sliders(
    Slider("theta", 60, 45, 110, 5, label="θ", unit="°"),
    Slider("phi", 40, 15, 70, 5, label="φ", unit="°"),
    alt="Spherical coordinates of a point P: the distance R, the azimuth theta from X to the "
    "foot Q, the elevation phi from Q up to P. At P the unit vectors e_R outward, e_theta "
    "along the circle of latitude, e_phi upward along the meridian.",
    size=(6.2, 4.8),
)
def spherical_axes(ax: AnyAxes, theta: float, phi: float) -> None:
    """Figure 3.8: spherical coordinates and axes."""
    ground = Frame("ground")
    P = spherical(ground, "P", 1.0, math.radians(theta), math.radians(phi))
    x, y, _ = P.position(ground).components(ground)
    s = Sketch(ax, ground, azimuth=25, elevation=25)
    s.axes(O, ground, length=0.6, labels="XYZ")
    s.arrow(O, P, "$R$")
    s.line(O, (x, y, 0), style="solid")
    s.line((x, y, 0), P)
    s.arc(O, ground.i, (x, y, 0), label=r"$\theta$", radius=0.2)
    s.arc(O, (x, y, 0), P, label=r"$\phi$", radius=0.45)
    s.dimension(O, (x, y, 0), r"$R\,\cos\phi$", offset=(0, 0, -0.12))
    axes = P.velocity(ground).frame
    s.axes(P, axes, length=0.4, labels=[r"$\hat e_R$", r"$\hat e_\theta$", r"$\hat e_\phi$"])
    s.label(P, "P")
    s.label((x, y, 0), "Q", offset=(7, -7))


@with_sliders(
    Slider("theta", 50, 0, 120, 5, label="θ", unit="°"),
    Slider("phi", 40, 0, 80, 5, label="φ", unit="°"),
    alt="A vector Q of fixed length along X at a point P with its spherical unit vectors, dashed. "
    "The three components of Q along them are laid head to tail. As P moves, the components "
    "change and Q does not.",
    size=(6.4, 4.8),
)
def one_vector(ax: AnyAxes, theta: float, phi: float) -> None:
    """Figure 3.9: one vector and its components along spherical axes."""
    ground = Frame("ground")
    P = spherical(ground, "P", 1.0, math.radians(theta), math.radians(phi))
    axes = P.velocity(ground).frame
    Q = ground.vector(0.8, 0, 0)
    parts = Q.components(axes)
    s = Sketch(ax, ground, azimuth=-50, elevation=25)
    s.axes(O, ground, length=0.6, labels="XYZ")
    s.line(O, P)
    s.axes(P, axes, length=0.6, labels=[r"$\hat e_R$", r"$\hat e_\theta$", r"$\hat e_\phi$"])
    s.dot(P, "P")
    tip = P.position(ground).components(ground)
    for e, x, name in zip((axes.i, axes.j, axes.k), parts, ("R", r"\theta", r"\phi"), strict=True):
        start, tip = tip, moved(tip, 1, (e * x).components(ground))
        if abs(x) > 1e-9:
            s.arrow(start, tip, rf"$Q_{name}$", kind="acceleration")
    s.arrow(P, tip, r"$\mathbf{Q}$", kind="velocity")
    text = ", ".join(f"{round(x, 2) + 0.0:.2f}" for x in parts)
    ax.set_title(rf"$(Q_R,Q_\theta,Q_\phi)$ = ({text}); $|Q|$ = {Q.norm():.2f}", fontsize=11)


def screw_film() -> Animation:
    """A film: the first turn of the screw-jack, from rest."""
    b, K, lead = 0.3, 2.0, 0.15

    def draw(t, ax):
        ground = Frame("ground")
        A = screw_jack_ball(ground, b, K, lead, t)
        s = _jack(ax, ground, A, arrows=150)
        s.vector(A, A.velocity(ground), r"$\mathbf{v}$")
        s.vector(A, A.acceleration(ground), r"$\mathbf{a}$", kind="acceleration")

    return animate(
        draw,
        evenly(0, screw_jack_time(1, K), 41),
        alt="The ball of a screw-jack starts from rest. At first its acceleration points along the "
        "path; within half a turn it swings round almost to the axis.",
    )


def exact_acceleration(path: Path, t: float) -> list[Scalar]:
    """The second derivative of each coordinate of ``path`` at t."""
    return second_derivative(path, t)
