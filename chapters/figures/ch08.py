"""The figures of chapter 8: the moment that a motion needs, planar motion, forces that are moved."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from newton_euler import Body, Frame, Point, axis_angle
from newton_euler.algebra.late import np, plt
from newton_euler.algebra.linear import Solution
from newton_euler.algebra.scalars import Triple
from newton_euler.chapters.examples.ch08 import rolling_begins, sphere_at
from newton_euler.classroom import Slider, interactive_figure, show_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved
from newton_euler.dynamics import angular_momentum, resultant_moment
from newton_euler.kinematics.rotations import (
    matrix_from_quaternion,
    quaternion,
    quaternion_product,
)

from .ch07 import draw_dumbbell, draw_rods
from .colours import BLUE, GREEN, ORANGE
from .curves import evenly
from .sliding import with_sliders

O = (0, 0, 0)
TurningRods: TypeAlias = Callable[..., tuple[Frame, Body, Point]]  # ground, body, point on the axis


@with_sliders(
    Slider("tilt", 35, 10, 90, 10, label="β", unit="°"),
    Slider("rate", 2.0, 0, 3, 0.5, label="ω", unit="rad/s"),
    Slider("acceleration", 0.0, 0, 6, 3, label="rate of ω", unit="rad/s²"),
    alt="The slanted dumbbell on its vertical shaft, with omega along the shaft, the angular "
    "momentum H at right angles to the rod, and the moment M: at a constant rate it is at "
    "right angles to the plane of shaft and rod, the way the tip of H moves.",
    size=(6.4, 4.6),
)
def dumbbell(
    ax: AnyAxes,
    build: Callable[[float, float, float], tuple[Frame, Frame, Body]],
    tilt: float,
    rate: float,
    acceleration: float,
) -> None:
    """Figure 8.1: omega, H and M of a dumbbell, from ``build(tilt, rate, acceleration)``."""
    ground, axle, body = build(math.radians(tilt), rate, acceleration)
    s = Sketch(ax, ground, azimuth=-28, elevation=22, arrows=115)
    draw_dumbbell(s, body)
    s.vector(O, axle.angular_velocity(ground), r"$\omega$", kind="rate")
    s.vector(O, body.angular_momentum(ground), r"$\mathbf{H}$", kind="plain")
    s.vector(O, resultant_moment(body, ground), r"$\mathbf{M}$", kind="force", size="N m")


@with_sliders(
    Slider("off", 0, -60, 60, 5, label="off the line by", unit="°"),
    alt="Two particles i and j with opposite forces on each other, and the vectors from B to "
    "them. If the forces lie on the line that joins the particles their moments about B "
    "cancel; if they are turned away from it a couple is left.",
    size=(6, 4),
)
def internal_forces(ax: AnyAxes, off: float) -> None:
    """Figure 8.2: two particles that pull at each other, along their line or not."""
    ground = Frame("ground")
    P, Q, F = (1.1, 0.35, 0), (2.0, 1.25, 0), 0.6
    a = math.radians(45 + off)
    push = (F * math.cos(a), F * math.sin(a), 0)
    s = Sketch(ax, ground, plane="xy")
    s.line(P, Q)
    s.arrow(O, P, r"$\mathbf{d}_i$")
    s.arrow(O, Q, r"$\mathbf{d}_j$")
    s.arrow(P, moved(P, 1, push), r"$\mathbf{F}_{ij}$", kind="force")
    s.arrow(Q, moved(Q, -1, push), r"$\mathbf{F}_{ji}$", kind="force")
    for place, name in ((O, "B"), (P, "i"), (Q, "j")):
        s.dot(place, name)
    moment = (P[0] - Q[0]) * push[1] - (P[1] - Q[1]) * push[0]
    ax.set_title(f"sum of both moments about B: {moment:.2f} N m", fontsize=11)


@with_sliders(
    Slider("a", 3.0, 0, 6, 0.5, label="acceleration", unit="m/s²"),
    Slider("tilt", 0, 0, 40, 1, label="leaning forward", unit="°"),
    alt="A pole stands on the foot B on a truck that accelerates to the right. Upright, the foot "
    "must give a moment; leaning forward at the angle whose tangent is a over g it needs none.",
    size=(6.4, 4.2),
)
def pole_on_truck(
    ax: AnyAxes, build: Callable[[float, float], tuple[Frame, Body, Point]], a: float, tilt: float
) -> None:
    """Figure 8.3: a pole on a truck, from ``build(a, tilt)``: ground, pole, foot."""
    ground, pole, foot = build(a, math.radians(tilt))
    mass, up = float(pole.mass), ground.vector(0, 0, 9.81)
    tip = tuple(2 * x for x in (pole.centre - foot).components(ground))
    d = (pole.centre - foot).expressed_in(ground)
    needed = resultant_moment(pole, ground, foot).expressed_in(ground)
    hinge = needed - d.cross(up * -mass)
    s = Sketch(ax, ground, plane="xz")
    s.box((0, 0, -0.25), ground, (2.6, 0.5, 0.3))
    for x in (-0.9, 0.9):
        s.disk((x, 0, -0.5), ground.j, 0.2)
    s.road([(-1.8, 0, -0.7), (1.9, 0, -0.7)])
    s.rod(O, tip)
    s.vector(d.components(ground), up * -mass, "weight", kind="force")
    s.vector((1.35, 0, -0.25), ground.i * a, r"$\mathbf{a}_B$", kind="acceleration", size="m/s²")
    s.label(O, "B")
    s.label(d.components(ground), "G")
    moment = round(float(hinge.y), 9) + 0.0
    ax.set_title(f"moment that the foot must give: {moment:.1f} N m", fontsize=11)


def three_spins(times: Sequence[float], runs: Mapping[str, "np.ndarray"]) -> None:
    """Figure 8.4: omega over time for spins about the three principal axes, disturbed a little."""
    fig, axes = plt.subplots(1, 3, figsize=(9.6, 3.4), sharey=True, layout="constrained")
    looks = ("x", BLUE, "-"), ("y", ORANGE, "--"), ("z", GREEN, "-.")
    for ax, (name, rates) in zip(axes, runs.items(), strict=True):
        for values, (label, colour, style) in zip(np.transpose(rates), looks, strict=True):
            ax.plot(times, values, style, color=colour, label=rf"$\omega_{label}$")
        ax.set(title=name, xlabel="time (s)", ylim=(-6, 6))
    axes[0].set(ylabel="rad/s")
    entries = axes[0].get_legend_handles_labels()
    fig.legend(*entries, frameon=False, ncol=3, loc="outside lower center")
    show_figure(
        fig,
        alt="Three plots of the components of omega over time. About the axes of least and largest "
        "moment the spin stays almost constant. About the axis of the middle moment it reverses "
        "again and again while the other two components become large.",
    )


def attitudes(times: "np.ndarray", rates: "np.ndarray") -> list[tuple[Triple, float]]:
    """The attitude of a body at these times, as (axis, angle), from the components of omega on its
    own axes: in each step it turns about the mean omega.
    """
    q, found = (1.0, 0.0, 0.0, 0.0), []
    means = (rates[1:] + rates[:-1]) / 2
    for step in [np.zeros(3), *(means * np.diff(times)[:, None])]:
        if any(step):
            q = quaternion_product(q, quaternion(step, float(np.linalg.norm(step))))
        found.append(axis_angle(matrix_from_quaternion(q)))
    return found


def flipping_handle(
    times: "np.ndarray", rates: "np.ndarray", bar: float = 0.12, stem: float = 0.08, every: int = 15
) -> Animation:
    """A film: a T-handle spins about its stem, flips over, flips back; ``rates``: its omega."""
    shift = stem / 8  # G is a quarter of the way from the bar to the middle of the stem
    turned = dict(zip(times, attitudes(times, rates), strict=True))

    def draw(t, ax):
        ground = Frame("ground")
        axis, angle = turned[t]
        body = ground.rotate("handle", axis=tuple(axis), angle=angle)
        s = Sketch(ax, ground, azimuth=-60, elevation=22)
        ends = [body.point("", -shift, y, 0) for y in (-bar / 2, bar / 2)]
        s.rod(*ends)
        s.rod(body.point("", -shift, 0, 0), body.point("", stem - shift, 0, 0))
        s.dot(ends[1])
        s.line((-0.09, 0, 0), (0.09, 0, 0), style="centre")
        s.vector(O, ground.i * 0.085, r"$\mathbf{H}$", kind="plain")

    return animate(
        draw,
        times[::every],
        speed=0.25,
        alt="A T-shaped handle spins about its stem, which points along H. Then it turns over, so "
        "that the stem points against H, spins on steadily, and turns over again. Nothing acts on it.",
    )


def turning_rods(
    build: TurningRods, words: str, azimuth: float = -60, acceleration: float = 0.0
) -> None:
    """Figures 8.5 to 8.7: the three rods with omega, H and M, from ``build(rate, acceleration)``:
    ground, body, point; ``words`` names the axis, ``azimuth`` is the direction of view,
    ``acceleration`` the rate of omega at the start.
    """

    def draw(ax, rate, acceleration):
        ground, body, P = build(rate, acceleration)
        frame = body.frame
        s = Sketch(ax, ground, azimuth=azimuth, elevation=22, arrows=110)
        s.axes(P, frame, length=0.35)
        draw_rods(s, frame)
        axis = frame.angular_velocity(ground)
        unit = axis / max(float(axis.norm()), 1e-9)
        line = [(P - frame.origin).expressed_in(ground) + unit * x for x in (-0.8, 0.8)]
        origin = frame.origin.position(ground)
        s.line(*(origin + x for x in line), style="centre")
        s.vector(P, axis, r"$\omega$", kind="rate")
        s.vector(P, angular_momentum(body, ground, P), r"$\mathbf{H}$", kind="plain")
        s.vector(P, resultant_moment(body, ground, P), r"$\mathbf{M}$", kind="force", size="N m")
        s.dot(P)

    interactive_figure(
        draw,
        Slider("rate", 1.0, 0.5, 1.5, 0.25, label="ω", unit="rad/s"),
        Slider("acceleration", acceleration, -1, 1, 0.5, label="rate of ω", unit="rad/s²"),
        alt=f"The three rods turn about {words}, drawn dash-dotted, with the angular velocity "
        "omega, the angular momentum H and the moment M that the motion needs.",
        size=(6.2, 4.4),
    )


@with_sliders(
    Slider("apart", 180, 0, 180, 15, label="weights apart by", unit="°"),
    Slider("rate", 100, 0, 150, 25, label="ω", unit="rad/s"),
    alt="The hub, spokes and rim of a wheel with two small weights at the rim, one before and one behind the "
    "middle plane. Half a turn apart they balance as to force, but leave a moment across the "
    "shaft that grows with the square of the rate.",
    size=(6.2, 4.4),
)
def unbalanced_wheel(
    ax: AnyAxes, build: Callable[[float, float], tuple[Frame, Body]], apart: float, rate: float
) -> None:
    """Figure 8.8: a wheel with two small weights, from ``build(apart, rate)``: ground, body."""
    ground, body = build(math.radians(apart), rate)
    s = Sketch(ax, ground, azimuth=-60, elevation=16, arrows=90)
    s.shaft((0, 0, -0.22), (0, 0, 0.22))
    for z in (-0.07, 0, 0.07):
        s.ring((0, 0, z), ground.k, 0.18)
    for end in s.around(O, (0.18, 0, 0), ground.k)[::10]:
        s.rod(O, end)
    for part in body.parts[1:]:
        s.sphere(part.centre, 0.018)
    s.dot(body.centre)
    s.vector(O, resultant_moment(body, ground), r"$\mathbf{M}$", kind="force", size="N m")
    a = body.centre.acceleration(ground) * float(body.mass)
    ax.set_title(f"resultant force: {float(a.norm()):.1f} N", fontsize=11)


@with_sliders(
    Slider("drum", 20, 0, 80, 5, label="mass of the drum", unit="kg"),
    alt="A load of 10 kg hangs on a rope that is wound on a drum. The tension T is smaller "
    "than the weight mg while the load falls; the heavier the drum, the larger T and the "
    "smaller the acceleration.",
    size=(5, 4.6),
)
def drum_and_load(ax: AnyAxes, solve: Callable[[float], Solution], drum: float) -> None:
    """Figure 8.9: a drum lowers a load on a rope, from ``solve(drum)``: a and T for its mass."""
    found = solve(drum)
    ground, C, r = Frame("ground"), (0, 0, 1.0), 0.3
    s = Sketch(ax, ground, plane="xz")
    s.ground((0, 0, 1.55), -ground.k, size=1.2)
    s.rod((0, 0, 1.55), C)
    wheel = s.pulley(C, ground.j, r)
    s.hinge(C)
    s.cable(wheel, (r, 0, 0.25))
    s.box((r, 0, 0.12), ground, (0.26, 0.26, 0.26))
    s.vector((r, 0, 0.25), ground.k * float(found.T), "$T$", kind="force", size="N")
    s.vector((r, 0, 0.0), ground.k * -98.1, "$mg$", kind="force", size="N")
    s.label(C, "G", offset=(-14, 4))
    ax.set_title(f"acceleration of the load: {float(found.a):.2f} m/s²", fontsize=11)


@with_sliders(
    Slider("t", 0.4, 0, 2, 0.1, label="time", unit="s"),
    Slider("spin", 0.0, -50, 100, 50, label="spin at the start", unit="rad/s"),
    alt="Left: a sphere on level ground with its velocity v and the friction F at its lowest "
    "point. Right: v and minus omega r over time; they approach each other on straight lines "
    "while the sphere slides, and are equal and constant when it rolls.",
    size=(8.8, 3.8),
    panels=(1, 2),
)
def sphere(
    axes: Sequence[AnyAxes], v0: float, mu: float, g: float, radius: float, t: float, spin: float
) -> None:
    """Figure 8.10: the sphere at a time, and its speeds over time."""
    slip0 = v0 + spin * radius
    given = (v0, mu, g, radius, spin, None, 1 if slip0 >= 0 else -1)
    x, v, omega = (float(q) for q in sphere_at(t, *given))
    slip = v + omega * radius
    ground, C = Frame("ground"), (0, radius, 0)
    s = Sketch(axes[0], ground, plane="xy")
    s.road([(-1.6, 0, 0), (1.6, 0, 0)])
    turned = _turned(t, given)
    end = (radius * math.cos(turned), radius + radius * math.sin(turned), 0)
    s.disk(C, ground.k, radius, spoke=end)
    s.vector(C, ground.i * v, f"$v$ = {v:.2f} m/s")
    slips = abs(slip) > 1e-9
    s.vector(O, ground.i * (-math.copysign(2.0, slip) if slips else 0.0), "$F$", kind="force")
    axes[0].set_title(f"{'slides' if slips else 'rolls'}; x = {x:.2f} m", fontsize=11)
    times = 0.0, min(float(rolling_begins(*given).t), 2.0), 2.0  # the lines are straight between
    _, speeds, rates = zip(*(sphere_at(x, *given) for x in times), strict=True)
    axes[1].plot(times, speeds, color=BLUE, label="$v$")
    axes[1].plot(times, [-x * radius for x in rates], "--", color=ORANGE, label=r"$-\omega r$")
    axes[1].axvline(t, color="black", lw=0.8)
    axes[1].axhline(0, color="black", lw=0.5)
    axes[1].set(xlabel="time (s)", ylabel="m/s", xlim=(0, 2), ylim=(-21, 11))
    axes[1].legend(frameon=False, loc="lower right")


def _turned(t, given):
    """The angle by which the sphere has turned at time t."""
    start, begin = given[4], rolling_begins(*given)
    until = min(t, float(begin.t))
    sliding = (start + float(sphere_at(until, *given)[2])) / 2 * until
    return sliding + float(begin.omega) * (t - until)


@with_sliders(
    Slider("b", 0.5, -0.5, 0.5, 0.05, label="pushed at x", unit="m"),
    alt="A rod on ice seen from above, pushed across by a force F. The accelerations of its "
    "points vary linearly along the rod; that of the centre of mass G is the same wherever the "
    "rod is pushed.",
    size=(6.4, 3.6),
)
def pushed_rod(ax: AnyAxes, b: float) -> None:
    """Figure 8.11: a rod on ice that is pushed, and the accelerations of its points."""
    ground, m, length, F = Frame("ground"), 2.0, 1.0, 10.0
    a, alpha = F / m, F * b / (m * length**2 / 12)
    s = Sketch(ax, ground, plane="xy", arrows=90)
    s.rod((-0.5, 0, 0), (0.5, 0, 0))
    for x in evenly(-0.5, 0.5, 9):
        s.vector((x, 0, 0), ground.j * (a + alpha * x), kind="acceleration")
    s.vector((b, -0.32, 0), ground.j * F, "$F$", kind="force")
    s.dot(O, "G", offset=(0, -14))
    rest = "none" if abs(b) < 1e-9 else f"x = {-1 / (12 * b):.3f} m"
    ax.set_title(f"no acceleration at {rest}; at G {a:.1f} m/s²", fontsize=11)


def chatter(times: Sequence[float], slips: Sequence[float], exact: Sequence[float]) -> None:
    """Figure 8.12: the slip of the sphere by equal steps of one rule with sign(slip)."""
    fig, ax = plt.subplots(figsize=(6.4, 3.3))
    ax.plot(times, exact, color="black", label="exact")
    ax.plot(
        times, slips, "o-", ms=3, lw=0.8, color=ORANGE, label="one rule with the sign of the slip"
    )
    ax.set(xlabel="time (s)", ylabel="slip (m/s)", xlim=(0.3, 0.8), ylim=(-1.5, 4))
    ax.legend(frameon=False)
    show_figure(
        fig,
        alt="The slip of the sphere over time. The exact slip falls to zero and stays there; that "
        "computed by equal steps jumps to and fro between positive and negative values for ever.",
    )


def rods_film(build: TurningRods) -> Animation:
    """A film: the three rods turn about x at a constant rate; M goes round with them."""

    def draw(t, ax):
        ground, body, about = build(1.0, 0.0, angle=t)
        frame = body.frame
        s = Sketch(ax, ground, azimuth=-60, elevation=22, arrows=80)
        draw_rods(s, frame)
        s.line((-0.9, 0, 0), (0.9, 0, 0), style="centre")
        s.vector(about, frame.angular_velocity(ground), r"$\omega$", kind="rate")
        s.vector(about, angular_momentum(body, ground, about), r"$\mathbf{H}$", kind="plain")
        s.vector(about, resultant_moment(body, ground, about), r"$\mathbf{M}$", kind="force")

    return animate(
        draw,
        evenly(0, 2 * math.pi, 25),
        alt="The three rods turn about x; H and the moment M go round with them at right angles.",
    )
