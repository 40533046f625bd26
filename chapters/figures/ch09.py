"""The figures of chapter 9: rotors in their bearings, the forces that turn with them, and the
weights that balance them.

``build`` is the notebook's function that makes a rotor: it returns the frames ground and shaft, the
bearings A and B, and the body.
"""

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from newton_euler import Body, Frame, Point, Vector, composite, particle
from newton_euler.algebra.late import plt
from newton_euler.algebra.scalars import Triple
from newton_euler.applications.rotors import balancing_masses, reactions
from newton_euler.classroom import Slider, show_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate

from .colours import BLUE, ORANGE
from .curves import evenly
from .sliding import with_sliders

O = (0, 0, 0)
Rotor: TypeAlias = Callable[..., tuple[Frame, Frame, Point, Point, Body]]
PSI = Slider("psi", 40, 0, 360, 10, label="ψ", unit="°")


def in_bearings(ax: AnyAxes, ground: Frame, shaft: Frame, A: Point, B: Point) -> Sketch:
    """A sketch of the shaft from the bearing A, left, to B, right, with its rate omega."""
    s = Sketch(ax, ground, up="y", azimuth=-38, elevation=18, arrows=90)
    a, b = (P.position(shaft).x for P in (A, B))
    s.shaft((a - 0.07, 0, 0), (b + 0.1, 0, 0))
    for P in (A, B):
        s.hinge(P, axis=shaft.i)
        s.label(P, P.name)
    s.turn((b + 0.075, 0, 0), shaft.i, r"$\omega$")
    return s


def bearing_forces(s: Sketch, body: Body, A: Point, B: Point) -> None:
    """The arrows of both bearing forces on a rotor, with their sizes."""
    found = reactions(body, A, B, s.frame)
    for P, force, name in ((A, found.A, "A"), (B, found.B, "B")):
        some = force * (force.norm() > 1e-9)  # less is round-off
        s.vector(P, some, rf"$\mathbf{{{name}}}$", kind="force", size="N")


def wheel(s: Sketch, shaft: Frame, G: Point, normal: Vector, radius: float = 0.1) -> None:
    """A disk with a spoke along z of the shaft, which lies in the planes of all our disks."""
    s.disk(G, normal, radius, spoke=G.position(s.frame) + shaft.k * radius)


@with_sliders(
    PSI,
    alt="A level shaft in the bearings A, on the left, and B, on the right, carries a disk "
    "whose centre G is off the axis. Drawn: the fixed axes Y and Z, the axes x, y, z that turn "
    "with the shaft, the angle psi from Y to y, and the distances a and b of the bearings.",
)
def symbols_of_a_rotor(ax: AnyAxes, build: Rotor, psi: float) -> None:
    """Figure 9.1: the frames, the bearings, the angle psi and the distance of G."""
    ground, shaft, A, B, body = build(psi=math.radians(psi))
    s = in_bearings(ax, ground, shaft, A, B)
    s.disk(body.centre, shaft.i, 0.1)
    s.axes(O, ground, length=0.16, labels=["", "Y", "Z"])
    s.axes(O, shaft, length=0.14, labels=["x", "y", "z"])
    s.arc(O, ground.j * 0.1, shaft.j * 0.1, r"$\psi$", radius=0.07)
    s.dot(body.centre, "G")
    s.dot(O, "O", offset=(-10, -10))
    s.dimension(A, O, "a", offset=-0.17)
    s.dimension(O, B, "b", offset=-0.17)


def lever() -> None:
    """Figure 9.2: side view of the off-centre disk with the forces and m a."""
    ground = Frame("ground")
    fig, ax = plt.subplots(figsize=(6.4, 3))
    s = Sketch(ax, ground, plane="xy")
    A, B, G = (-0.2, 0, 0), (0.3, 0, 0), (0, 0.03, 0)
    s.shaft((-0.26, 0, 0), (0.36, 0, 0))
    s.plate([(-0.006, -0.07, 0), (0.006, -0.07, 0), (0.006, 0.13, 0), (-0.006, 0.13, 0)])
    for P, name, force in ((A, "A", 3), (B, "B", 2)):
        s.hinge(P)
        s.label(P, name, offset=(-12, 8))
        s.vector(P, ground.j * -force, rf"$\mathbf{{{name}}}$", kind="force")
    s.dot(G, "G", offset=(10, 8))
    s.vector(G, ground.j * -5, r"$m\,\bar{\mathbf{a}}$", kind="acceleration")
    s.dimension(A, O, "a", offset=-0.17)
    s.dimension(O, B, "b", offset=-0.17)
    s.dimension((0.08, 0, 0), (0.08, 0.03, 0), "d", offset=-0.04)
    show_figure(
        fig,
        alt="Side view of the shaft at the instant when G is above the axis. The vector m a at G "
        "points down to the axis; the forces A and B of the bearings point down, too, and the one "
        "at the bearing that is nearer to the disk is the larger.",
    )


@with_sliders(
    Slider("psi", 0, 0, 360, 10, label="ψ", unit="°"),
    Slider("omega", 20, 0, 30, 2, label="ω", unit="rad/s"),
    alt="The shaft with a disk whose centre G is off the axis. The force of each bearing on the "
    "shaft points from the axis away from G. Both forces are parallel, turn with the shaft, and the one at the "
    "nearer bearing A is larger.",
)
def turning_forces(ax: AnyAxes, build: Rotor, psi: float, omega: float) -> None:
    """Figure 9.3: the forces on the shaft of an off-centre disk."""
    ground, shaft, A, B, body = build(psi=math.radians(psi), omega=omega)
    s = in_bearings(ax, ground, shaft, A, B)
    wheel(s, shaft, body.centre, shaft.i)
    s.line(O, body.centre, style="solid")
    s.label(body.centre, "G")
    bearing_forces(s, body, A, B)


def off_centre_film(build: Rotor) -> Animation:
    """A film: the forces turn with the off-centre disk."""

    def draw(t, ax):
        ground, shaft, A, B, body = build(psi=20.0 * t)
        s = in_bearings(ax, ground, shaft, A, B)
        wheel(s, shaft, body.centre, shaft.i)
        bearing_forces(s, body, A, B)

    return animate(
        draw,
        evenly(0, math.pi / 10, 19),
        alt="The off-centre disk turns once; the bearing forces keep their size and turn with it, "
        "always away from the centre G of the disk.",
    )


@with_sliders(
    Slider("beta", 30, 0, 90, 5, label="β", unit="°"),
    Slider("psi", 0, 0, 360, 10, label="ψ", unit="°"),
    alt="A disk sits askew on its shaft, with its centre on the axis. The angular momentum H lies between "
    "the shaft and the normal of the disk; its rate is at right angles to both. The bearing "
    "forces are equal and opposite, a couple that turns with the shaft; at 0 and 90 degrees there "
    "is none.",
)
def bent_disk(ax: AnyAxes, build: Rotor, beta: float, psi: float) -> None:
    """Figure 9.4: the bent disk with omega, H, dH/dt and the bearing forces."""
    ground, shaft, A, B, body = build(beta=math.radians(beta), psi=math.radians(psi))
    s = in_bearings(ax, ground, shaft, A, B)
    wheel(s, shaft, body.centre, body.frame.i, 0.12)
    H = body.angular_momentum(ground)
    s.vector(O, H, r"$\mathbf{H}$", kind="velocity")
    rate = H.rate(ground)
    if rate.norm() > 1e-9:  # not at 90°, where rounding leaves a residue
        s.vector(O, rate, r"$\dot{\mathbf{H}}$", kind="rate")
    bearing_forces(s, body, A, B)


def bent_disk_film(build: Rotor) -> Animation:
    """A film: H goes round the shaft on a cone."""

    def draw(t, ax):
        ground, shaft, A, B, body = build(psi=20.0 * t)
        s = in_bearings(ax, ground, shaft, A, B)
        wheel(s, shaft, body.centre, body.frame.i, 0.12)
        s.vector(O, body.angular_momentum(ground), r"$\mathbf{H}$")
        bearing_forces(s, body, A, B)

    return animate(
        draw,
        evenly(0, math.pi / 10, 19),
        alt="The bent disk turns once; its angular momentum H goes round the shaft on a cone, and "
        "the couple of the bearing forces turns with it.",
    )


@with_sliders(
    Slider("m1", 0, 0, 600, 20, label="m₁", unit="g"),
    Slider("angle1", 0, 0, 360, 10, label="angle of m₁", unit="°"),
    Slider("m2", 0, 0, 600, 20, label="m₂", unit="g"),
    Slider("angle2", 0, 0, 360, 10, label="angle of m₂", unit="°"),
    alt="A rotor with two heavy spots and two light rings, on each of which a weight can be placed. "
    "The bearing forces are drawn with their sizes; they vanish when both weights have the right "
    "mass and angle.",
)
def balance_by_hand(
    ax: AnyAxes, build: Rotor, m1: float, angle1: float, m2: float, angle2: float
) -> None:
    """Figure 9.5: two weights on a rotor, moved by the reader until the forces vanish."""
    ground, shaft, A, B, body = build(psi=-0.7)  # its forces lie in the plane of the page
    weights = [
        particle(m / 1000, spot(shaft, x, angle), f"weight {n}")
        for n, m, angle, x in ((1, m1, angle1, -0.1), (2, m2, angle2, 0.2))
        if m
    ]
    s = in_bearings(ax, ground, shaft, A, B)
    draw_masses(s, shaft, body.parts, (-0.1, 0.2), weights)
    bearing_forces(s, composite("all", [body, *weights]), A, B)


def spot(shaft: Frame, x: float, degrees: float) -> Point:
    """A place 0.1 m from the axis, at this angle from y."""
    angle = math.radians(degrees)
    return shaft.point("", x, 0.1 * math.cos(angle), 0.1 * math.sin(angle))


def draw_masses(
    s: Sketch, shaft: Frame, spots: Sequence[Body], planes: Sequence[float], weights: Sequence[Body]
) -> None:
    """The heavy spots as large balls, the balancing weights as small ones on their rings."""
    for x in planes:
        s.ring((x, 0, 0), shaft.i, 0.1)
        s.label((x, -0.1, 0), "ring 1" if x == planes[0] else "ring 2", (0, -33), bold=False)
    for body, name in [(b, b.name) for b in spots] + [(w, w.name[-1]) for w in weights]:
        c = body.centre.position(shaft)
        s.rod(shaft.point("", c.x, 0, 0), body.centre)
        s.sphere(body.centre, 0.036 * body.mass ** (1 / 3))
        s.label(body.centre, name)


@with_sliders(
    Slider("x1", -10, -16, -6, 1, label="plane 1 at x", unit="cm"),
    Slider("x2", 20, 10, 28, 1, label="plane 2 at x", unit="cm"),
    alt="The rotor with its two heavy spots and the two balancing weights, one in each plane, "
    "drawn larger the heavier they are. The weight of a plane that is moved away becomes smaller.",
)
def balancing(ax: AnyAxes, build: Rotor, x1: float, x2: float) -> None:
    """Figure 9.6: where the balancing masses go, for two planes that the reader moves."""
    ground, shaft, A, B, body = build(psi=-0.7)  # its forces lie in the plane of the page
    planes = [(x - 100 * A.position(shaft).x) / 100 for x in (x1, x2)]
    weights = balancing_masses(body, A, B, planes, radius=0.1)
    s = in_bearings(ax, ground, shaft, A, B)
    draw_masses(s, shaft, body.parts, (x1 / 100, x2 / 100), weights)
    ax.set_title(", ".join(f"{w.name}: {1000 * w.mass:.0f} g" for w in weights), fontsize=11)


def balancing_machine() -> None:
    """Figure 9.7: the wheel with the coin on a balancing machine, cut along its shaft."""
    ground = Frame("ground")
    fig, ax = plt.subplots(figsize=(6.4, 3.6))
    s = Sketch(ax, ground, plane="xy")
    s.shaft((-0.36, 0, 0), (0.02, 0, 0))
    s.plate([(-0.01, -0.2, 0), (0.01, -0.2, 0), (0.01, 0.2, 0), (-0.01, 0.2, 0)])
    for y in (-0.2, 0.2):  # the rim, cut
        s.line((-0.08, y, 0), (0.08, y, 0), style="solid")
        for x, name in ((-0.08, "1"), (0.08, "2")):
            s.dot((x, y, 0), name if y > 0 else "", offset=(0, 12))
    s.sphere((0.045, 0.188, 0), 0.011)
    s.label((0.045, 0.188, 0), "coin", offset=(6, -14), bold=False)
    for x, name in ((-0.3, "A"), (-0.1, "B")):
        s.hinge((x, 0, 0))
        s.label((x, 0, 0), name, offset=(0, 14))
    s.dimension((-0.3, 0, 0), O, "30 cm", offset=-0.27)
    s.dimension((-0.1, 0, 0), O, "10 cm", offset=-0.12)
    s.dimension(O, (0.08, 0, 0), "8 cm", offset=-0.27)
    show_figure(
        fig,
        alt="A wheel at the right end of a shaft, cut along the shaft. Its two bearings A and B are "
        "both to the left of it. A coin sticks inside the rim, whose edges are named 1 and 2.",
    )


@with_sliders(
    Slider("psi", 50, 0, 360, 10, label="ψ", unit="°"),
    alt="A level shaft seen from its end and from the side: X points vertically down, the angle "
    "psi leads from X to the x axis of the body, and the weight acts at the centre of mass G, "
    "which is off the axis.",
    size=(8.4, 4.4),
    panels=(1, 2),
)
def general_rotor(axes: Sequence[AnyAxes], build: Rotor, psi: float) -> None:
    """Figure 9.8: an end view of any body on a level shaft, X downward, and a side view."""
    ground, shaft, A, B, body = build(psi=math.radians(psi))
    page = ground.rotate("page", "y", -math.pi / 2)  # its z points up, its x along the shaft
    end = Sketch(axes[0], page, plane="yz")
    side = Sketch(axes[1], page, azimuth=-50, elevation=18)
    G = body.centre
    for s in (end, side):
        s.axes(O, ground, length=0.24, labels=["X", "Y", ""], moved=False)
        s.axes(O, shaft, length=0.22, labels=["x", "y", ""], moved=True)
        s.box(G, shaft, (0.22, 0.14, 0.24))
        s.dot(G, "G")
        s.vector(G, ground.i, r"$m\mathbf{g}$", kind="force")
        s.line(shaft.point("", 0, 0, G.position(shaft).z), G)
    end.arc(O, ground.i * 0.1, shaft.i * 0.1, r"$\psi$")
    end.turn(O, ground.k, r"$\omega$")
    side.shaft(A, shaft.point("", 0, 0, 0.34))
    for P in (A, B):
        side.hinge(P, axis=ground.k)
        side.label(P, P.name)
    for x in axes:
        x.set_title("seen from B along the shaft" if x is axes[0] else "", fontsize=10)


@with_sliders(
    Slider("omega", 12, 0, 20, 0.5, label="ω", unit="rad/s"),
    alt="The tip of the force of bearing A during one turn is a circle about the share of the "
    "weight, which points upward. Its radius grows with the square of the rate; when it "
    "exceeds the share of the weight, the force points downward for a part of the turn.",
    size=(5.6, 5.2),
)
def force_over_a_turn(ax: AnyAxes, build: Rotor, omega: float) -> None:
    """Figure 9.9: the tip of the force of bearing A during one turn."""
    forces = [force_at_A(build, psi, omega) for psi in evenly(0, 2 * math.pi, 37)]
    tips = [(Y, -X) for X, Y, _ in forces]
    weight = force_at_A(build, 0.0, 0.0)
    ax.plot(*zip(*tips, strict=True), color=BLUE, label="tip of the force during one turn")
    ax.plot(weight[1], -weight[0], "s", color=ORANGE, label="share of the weight")
    ax.plot(0, 0, "k+", markersize=12, label="no force")
    ax.annotate("", tips[4], (0, 0), arrowprops={"arrowstyle": "->", "color": "k"})
    ax.set(xlim=(-17, 17), ylim=(-9, 25), aspect="equal")
    ax.set(xlabel="along Y, level (N)", ylabel="upward, −X (N)")
    ax.legend(frameon=False, fontsize=9, loc="upper right")


def force_at_A(build: Rotor, psi: float, omega: float) -> Triple:
    """Components on X, Y, Z of the force of the bearing A, with the weight."""
    ground, _, A, B, body = build(psi=psi, omega=omega)
    return reactions(body, A, B, ground, 9.81 * ground.i).A.components(ground)
