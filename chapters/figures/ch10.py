"""The figures of chapter 10: Euler's angles, tops that precess and nutate, rolling cones, and the
instruments that use them.

``build`` is the notebook's function that makes a body with a fixed point: it returns the ground and
the frame of the body, whose parent is the frame {i, j, k} that does not spin.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TypeAlias

from newton_euler import Frame, Point, Vector, euler_frame
from newton_euler.algebra.late import np, plt
from newton_euler.algebra.scalars import Triple
from newton_euler.applications.gyroscopes import (
    free_precession,
    gyro_momentum,
    least_spin,
    steady_precession,
)
from newton_euler.applications.nutation import nutation
from newton_euler.classroom import Slider, show_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.primitives import Kind
from newton_euler.scenes.spatial.gyrocompass import gyrocompass
from newton_euler.scenes.spatial.top import euler

from .colours import BLUE, ORANGE
from .curves import evenly, states_over
from .sliding import with_sliders

O = (0, 0, 0)
Top: TypeAlias = Callable[..., tuple[Frame, Frame]]


def sketch(
    ax: AnyAxes, ground: Frame, azimuth: float = 30, elevation: float = 20, arrows: float = 80
) -> Sketch:
    return Sketch(ax, ground, azimuth=azimuth, elevation=elevation, arrows=arrows)


def axes_of(body: Frame) -> Frame:
    """The frame {i, j, k} of a body, which does not spin."""
    assert body.parent is not None
    return body.parent


def draw_top(s: Sketch, body: Frame, length: float = 0.75, radius: float = 0.32) -> None:
    """A cone that stands on its apex, with a radius painted on its base, and its axle."""
    middle = body.point("", 0, 0, length)
    s.cone(O, body.k, length, radius)
    s.line(middle, body.point("", radius, 0, length), style="solid")
    s.rod(middle, body.point("", 0, 0, length + 0.25))


def _line_at_rest_in_words(spin, precession):
    lies = "lies between" if spin > 0 else "lies outside the angle between"
    line = f"{lies} the vertical and the axis of the top" if spin else "is the vertical"
    return (
        "A top stands on its fixed point B. A dash-dotted line through B along the angular "
        f"velocity omega {line}; the velocities of two points of the rim are drawn, at right "
        "angles to the plane of these lines."
    )


@with_sliders(
    Slider("spin", 6, -8, 8, 1, label="spin", unit="rad/s"),
    Slider("precession", 4, 0.5, 6, 0.5, label="precession", unit="rad/s"),
    alt=_line_at_rest_in_words,
)
def points_at_rest(ax: AnyAxes, build: Top, spin: float, precession: float) -> None:
    """Figure 10.1: the velocities of some points of a top, and the line of those at rest."""
    ground, body = build(precession=precession, spin=spin)
    omega = body.angular_velocity(ground)
    line = omega.expressed_in(ground) * (1 / omega.norm())
    line = line * math.copysign(1, line.z)  # its upper half is drawn
    s = sketch(ax, ground)
    draw_top(s, body)
    s.line(line * -0.2, line * 1.1, style="centre")
    s.vector(O, omega, r"$\omega$", kind="rate", size="rad/s")
    for x in (-0.32, 0.32):
        P = body.point("P", 0, x, 0.75)
        s.vector(P, P.velocity(ground), size="m/s")
    s.dot(O, "B")
    s.axes(O, ground, length=0.5, labels=["", "", "Z"])


@with_sliders(
    Slider("psi", 40, 0, 170, 5, label="ψ", unit="°"),
    Slider("theta", 50, 0, 170, 5, label="θ", unit="°"),
    Slider("phi", 35, 0, 170, 5, label="φ", unit="°"),
    alt="Fixed axes X, Y, Z, the axes x, y, z that precess and nutate, and the axes x', y' of the body, all with "
    "one origin. The angle psi leads in the level plane from X to the line of nodes x, theta "
    "from Z to z, and phi in the plane of the disk from x to x'.",
    size=(7, 5),
)
def eulers_angles(ax: AnyAxes, psi: float, theta: float, phi: float) -> None:
    """Figure 10.2: the three angles, with the axes of all frames."""
    ground = Frame("ground")
    psi, theta, phi = (math.radians(x) for x in (psi, theta, phi))
    body = euler_frame(ground, "body", psi, theta, phi)
    between = axes_of(body)
    s = sketch(ax, ground)
    s.disk(O, body.k, 0.6)
    s.axes(O, ground, length=1, labels="XYZ")
    s.axes(O, between, length=0.9, labels="xyz")
    s.axes(O, body, length=0.75, labels=["x'", "y'", ""])
    s.line(between.i * -1, between.i * 1.2, style="centre")
    s.arc(O, ground.i, between.i, r"$\psi$", radius=0.5)
    s.arc(O, ground.k, between.k, r"$\theta$", radius=0.5)
    s.arc(O, between.i, body.i, r"$\phi$", radius=0.6)


def angles_film() -> Animation:
    """A film: first precession alone, then nutation, then spin."""

    def draw(t, ax):
        ends = (1.2, 0.9, 2 * math.pi)
        angles = (min(max(t - n, 0), 1) * end for n, end in enumerate(ends))
        ground = Frame("ground")
        body = euler_frame(ground, "body", *angles)
        s = sketch(ax, ground)
        s.axes(O, ground, length=0.9, labels="XYZ")
        draw_top(s, body, 0.6, 0.4)
        nodes = axes_of(body).i
        s.line(nodes * -0.8, nodes * 0.8, style="centre")

    return animate(
        draw,
        evenly(0, 3, 25),
        alt="A top turns first about the vertical, then tips about the level line of nodes, then spins "
        "about its own axis: psi, theta and phi one after the other.",
    )


@with_sliders(
    Slider("theta", 120, 90, 160, 10, label="θ", unit="°"),
    Slider("phi", 0, 0, 360, 30, label="φ", unit="°"),
    Slider("spin", -1.5, -2, 2, 0.5, label="spin", unit="rad/s"),
    alt="A thin bar hangs from a ball joint B. Its angular velocity omega has a component along "
    "the bar, its angular momentum H has none: H is at right angles to the bar, however the "
    "bar is turned about itself.",
)
def pendulum(
    ax: AnyAxes,
    momentum: Callable[[float, float, float], tuple[Frame, Frame, Vector]],
    theta: float,
    phi: float,
    spin: float,
) -> None:
    """Figure 10.3: the bar on a ball joint with omega and H, from ``momentum(theta, phi, …)``."""
    ground, bar, H = momentum(math.radians(theta), math.radians(phi), spin)
    s = sketch(ax, ground, arrows=130)
    tip = bar.point("", 0, 0, 1)
    s.rod(O, tip)
    s.ball_joint(O)
    s.label(O, "B")
    s.axes(O, ground, length=0.5, labels=["", "", "Z"])
    s.axes(O, bar, length=0.4, labels=["x'", "y'", "z'"])
    s.vector(O, bar.angular_velocity(ground), r"$\omega$", kind="rate")
    s.vector(O, H, r"$\mathbf{H}_B$", size="kg m²/s")


@with_sliders(
    Slider("spin", 6, -6, 8, 1, label="spin", unit="rad/s"),
    Slider("precession", 4, 0, 5, 0.5, label="precession", unit="rad/s"),
    alt="A top with the axes x, y, z that do not spin: x level, z along the axis of the top. "
    "Drawn: the angular velocity Omega of these axes along Z, omega of the body, which has the "
    "spin in addition, and the angular momentum H, all in the plane of y and z.",
)
def spinning_top(
    ax: AnyAxes, build: Top, I0: float, I: float, spin: float, precession: float
) -> None:
    """Figure 10.4: a top with Omega, omega and H; small, so that the arrows are long beside it."""
    ground, body = build(precession=precession, spin=spin)
    s = sketch(ax, ground, azimuth=-15, arrows=260)
    draw_top(s, body, 0.3, 0.14)
    s.axes(O, ground, length=0.5, labels=["", "", "Z"])
    s.axes(O, axes_of(body), length=0.5)
    s.vector(O, axes_of(body).angular_velocity(ground), r"$\Omega$", kind="rate")
    s.vector(O, body.angular_velocity(ground), r"$\omega$", kind="rate", size="rad/s")
    s.vector(O, gyro_momentum(body, ground, I0, I), r"$\mathbf{H}_B$")


TOP = {"I0": 0.02, "I": 0.01, "mgr": 0.5, "omega_z": 30.0}


def nutating(precession: float, time: float, pictures: int) -> list[Triple]:
    """Euler's angles of the top, let go at 0.6 rad with this rate of precession."""
    states = states_over(euler(**TOP), time, (0.0, 0.6, 0.0, precession, 0.0), pictures)
    return [state[:3] for state in states]


def path_of_axis(precession: float, time: float, pictures: int) -> list[Triple]:
    """The path of the tip of its axis, 1 m from the fixed point."""
    return [
        (math.sin(theta) * math.sin(psi), -math.sin(theta) * math.cos(psi), math.cos(theta))
        for psi, theta, _ in nutating(precession, time, pictures)
    ]


@with_sliders(
    Slider("precession", 0, -2, 4, 0.25, label="precession at the start", unit="rad/s"),
    alt="The path of a top's axis on a sphere about the fixed point. Let go without "
    "precession it has cusps at the top of each nod; with a start against the precession it has "
    "loops, with a slow start along it waves. The pole and the start of the path are marked.",
    size=(6.4, 4.8),
)
def nutation_paths(ax: AnyAxes, precession: float) -> None:
    """Figure 10.5: the path of the axis on a sphere, for each start."""
    s = sketch(ax, Frame("ground"), azimuth=-60, elevation=50)
    s.sphere(O, 1)
    path = path_of_axis(precession, 3.0, 200)
    s.path(path, on=O)
    s.dot((0, 0, 1), "pole")
    s.dot(path[0], "start")
    limits = nutation(**TOP, theta=0.6, theta_rate=0.0, precession=precession)
    low, high = math.degrees(limits.theta_min), math.degrees(limits.theta_max)
    ax.set_title(f"{limits.kind}: θ from {low:.1f}° to {high:.1f}°", fontsize=11)


def top_film() -> Animation:
    """A film: a top let go at rest, in space, with its path."""
    time, pictures = 1.2, 28
    times = evenly(0.0, time, pictures)
    angles = dict(zip(times, nutating(0.0, time, pictures), strict=True))
    path = path_of_axis(0.0, time, 200)

    def draw(t, ax):
        ground = Frame("ground")
        body = euler_frame(ground, "top", *angles[t])
        s = sketch(ax, ground, azimuth=-60, elevation=28)
        s.ground(O, ground.k, size=0.8)
        draw_top(s, body)
        s.path(path)
        s.line(O, ground.k * 1.05, style="centre")

    return animate(
        draw,
        times,
        speed=0.15,
        alt="A top that is let go with its axis at rest: it dips, gathers precession, rises again and stops for an instant, in "
        "a chain of arcs with cusps, while it spins.",
    )


@with_sliders(
    Slider("theta", 50, 10, 80, 10, label="θ", unit="°"),
    Slider("spin", 60, 20, 100, 10, label="spin", unit="rad/s"),
    alt="A top that precesses steadily. The angular momentum H lies near its axis; the moment "
    "of the weight is level and at right angles to it, and so the tip of H moves sideways, "
    "round the vertical, and not down.",
)
def steady_top(ax: AnyAxes, build: Top, I0: float, I: float, theta: float, spin: float) -> None:
    """Figure 10.6: H, its rate and the moment in a steady precession."""
    theta = math.radians(theta)
    rate = steady_precession(I0, I, theta, spin=spin, mgr=0.5).slow
    ground, body = build(theta=theta, precession=rate, spin=spin)
    H = gyro_momentum(body, ground, I0, I)
    s = sketch(ax, ground, arrows=130)
    draw_top(s, body)
    s.vector(O, H, r"$\mathbf{H}_B$")
    s.vector(O, H.rate(ground), r"$\mathbf{M}_B=\dot{\mathbf{H}}_B$", "force", size="N m")
    s.vector(body.point("G", 0, 0, 0.55), ground.k * -1, r"$m\mathbf{g}$", kind="force")
    s.turn(ground.k * 0.9, ground.k * rate, rf"$\dot\psi$ = {rate:.2f} rad/s")
    s.line(O, ground.k, style="centre")


def both_rates(I0: float, I: float, theta: float, mgr: float) -> None:
    """Figure 10.7: slow and fast precession against the spin, with the approximations."""
    least = least_spin(I0, I, theta, mgr=mgr)
    spins = least * np.geomspace(1.0001, 12, 120)
    found = [steady_precession(I0, I, theta, spin=x, mgr=mgr) for x in spins]
    fig, ax = plt.subplots(figsize=(6.2, 3.6))
    ax.loglog(spins, [f.fast for f in found], color=ORANGE, ls="--", label="fast precession")
    ax.loglog(spins, [f.slow for f in found], color=BLUE, label="slow precession")
    ax.loglog(spins, mgr / (I * spins), "k:", label="(10.34)")
    ax.loglog(spins, I * spins / ((I0 - I) * math.cos(theta)), "k:")
    ax.set(xlabel="spin (rad/s)", ylabel="precession (rad/s)")
    ax.axvline(least, color="#777777", lw=0.8)
    ax.legend(frameon=False)
    show_figure(
        fig,
        alt="The two rates of steady precession against the spin, on logarithmic scales. They begin "
        "together at the least spin and part: the fast one grows with the spin, the slow one falls "
        "with it; both approach the straight lines of the approximation for a fast spin.",
    )


@with_sliders(
    Slider("omega", 5.0, 0, 7, 0.25, label="ω", unit="rad/s"),
    alt="Left, a rod hinged to a vertical shaft, swung out by the angle theta. Right, the "
    "effective potential against theta: one valley at zero below the critical rate, two "
    "valleys beside a hill above it; a dot marks the angle of the rod.",
    size=(8.4, 4),
    panels=(1, 2),
)
def hanging_rod(axes: Sequence[AnyAxes], angle: Callable[[float], float], omega: float) -> None:
    """Figure 10.8: the rod on its shaft at ``angle(omega)``, and its effective potential."""
    w0 = math.sqrt(1.5 * 9.81)
    left, right = axes
    ground = Frame("ground")
    s = Sketch(left, ground, plane="xz")
    s.shaft((0, 0, 0.35), (0, 0, -1.1))
    theta = angle(omega)
    end = (math.sin(theta), 0, -math.cos(theta))
    s.rod(O, end)
    s.hinge(O)
    s.turn((0, 0, 0.25), ground.k, r"$\omega$")
    s.arc(O, (0, 0, -1), end, r"$\theta$", radius=0.5)

    def potential(angle):
        return -math.cos(angle) - (omega / w0 * math.sin(angle)) ** 2 / 2

    degrees = range(-90, 91)
    right.plot(degrees, [potential(math.radians(x)) for x in degrees], color=BLUE)
    right.plot(math.degrees(theta), potential(theta), "o", color=ORANGE)
    right.set(xlim=(-90, 90), ylim=(-1.9, 0.1), xlabel="θ (°)")
    right.set(ylabel="effective potential / (mgL/2)")


def draw_cones(s: Sketch, ratio: float, theta: float, psi: float) -> None:
    """Body cone and space cone of a free symmetric body with I/I0 = ratio, at these angles."""
    ground, phi = s.frame, psi * (1 - ratio) * math.cos(theta) / ratio  # the cones roll
    body = euler_frame(ground, "body", psi, theta, phi)
    found = free_precession(1.0, ratio, theta, 1.0) if ratio != 1 else None
    tilt = found.body_cone if found else theta
    space = abs(theta - tilt)
    if space > 0.01:
        s.cone(O, ground.k, math.cos(space), math.sin(space), open=True)
    s.cone(O, body.k, math.cos(tilt), math.sin(tilt), open=True)
    s.line(O, body.point("", math.sin(tilt), 0, math.cos(tilt)), style="solid")
    omega = axes_of(body).vector(0, math.sin(tilt), math.cos(tilt))
    s.vector(O, omega * 1.3, r"$\omega$", kind="rate")
    s.line(O, ground.k * 1.3, style="centre")
    s.line(O, body.k * 1.3, style="centre")
    s.label(ground.k * 1.35, r"$\mathbf{H}$", bold=False)
    s.label(body.k * 1.35, "z", bold=False)


@with_sliders(
    Slider("ratio", 0.4, 0.2, 1.9, 0.1, label="I/I₀"),
    Slider("theta", 35, 20, 45, 5, label="θ", unit="°"),
    Slider("precession", 60, 0, 360, 10, label="precession ψ", unit="°"),
    alt="Two cones with one apex: the space cone about the fixed angular momentum H, the body "
    "cone about the axis z of the body. They touch along the angular velocity omega. For a "
    "slender body the body cone rolls on the outside of the space cone.",
    size=(6.4, 4.8),
)
def cones(ax: AnyAxes, ratio: float, theta: float, precession: float) -> None:
    """Figure 10.9: the body cone rolls on the space cone."""
    s = sketch(ax, Frame("ground"), elevation=32)
    draw_cones(s, ratio, math.radians(theta), math.radians(precession))
    sense = "direct" if ratio < 1 else "retrograde" if ratio > 1 else "a fixed axis"
    ax.set_title(sense, fontsize=11)


def cones_film(ratio: float, theta: float) -> Animation:
    """A film: the body cone rolls once round, for this I/I0."""

    def draw(t, ax):
        s = sketch(ax, Frame("ground"), elevation=32)
        draw_cones(s, ratio, theta, 2 * math.pi * t / 4)

    return animate(
        draw,
        evenly(0, 4, 21),
        alt=f"For I/I0 = {ratio:g} the body cone rolls without slipping on the space cone, once "
        "round the angular momentum H; a line painted on it shows its spin.",
    )


@with_sliders(
    Slider("spin", 100, -100, 100, 20, label="spin", unit="rad/s"),
    Slider("precession", 2, -4, 4, 0.5, label="precession", unit="rad/s"),
    alt="A wheel with a level axle. The spin points along the axle, the precession upward, and "
    "the moment that the wheel needs along the third, level direction: precession cross spin.",
)
def three_at_right_angles(ax: AnyAxes, build: Top, spin: float, precession: float) -> None:
    """Figure 10.10: spin, precession and moment for theta = 90 degrees."""
    ground, body = build(theta=math.pi / 2, precession=precession, spin=spin)
    between = axes_of(body)
    s = sketch(ax, ground, azimuth=70)
    s.disk(O, body.k, 0.5, spoke=body.point("", 0.5, 0, 0))
    s.rod(between.point("", 0, 0, -0.4), between.point("", 0, 0, 0.5))
    s.vector(O, between.k * spin, r"$\dot\phi\,\hat k$", kind="rate")
    s.vector(O, between.j * precession * 20, r"$\dot\psi\,\hat\jmath$", kind="rate")
    s.vector(O, between.i * (0.01 * spin * precession), r"$\mathbf{M}$", "force", size="N m")


@with_sliders(
    Slider("angle", 0, 0, 330, 30, label="the dark particle is past the top by", unit="°"),
    alt="A wheel with a level axle that turns to the left under a moment. The forces on the particles of its "
    "rim are largest at the top and at the bottom, to opposite sides; their velocities along the "
    "axle are largest a quarter of a turn later, at the sides, where no force acts.",
    size=(7.6, 4.2),
    panels=(1, 2),
)
def rim(
    axes: Sequence[AnyAxes],
    build: Callable[[], tuple[Frame, Iterable[tuple[float, Point, Vector, Vector]]]],
    angle: float,
) -> None:
    """Figure 10.11: forces and velocities along the axle of the particles of a rim."""
    ground, particles = build()
    kinds: tuple[Kind, Kind] = "force", "velocity"
    for panel, kind in zip(axes, kinds, strict=True):
        s = Sketch(panel, ground, azimuth=25, elevation=15, arrows=70)
        s.disk(O, (0, 1, 0), 0.3)
        for past_the_top, P, force, velocity in particles:
            place = P.position(ground)
            s.vector(place, force if kind == "force" else velocity, kind=kind)
            if round(past_the_top) == angle:
                s.dot(place)
        panel.set_title(f"{kind} along the axle", fontsize=11)


@with_sliders(
    Slider("rotor", 500, 0, 1200, 100, label="rotor", unit="rad/s"),
    alt="A car from behind in a turn to the left, with its rotor on a level axle. The level forces of the "
    "road act to the left, below G. Without the rotor nearly the whole weight is "
    "on the outer wheels, on the right; with the rotor at 1000 rad/s both sides carry half.",
    size=(6.2, 4.4),
)
def car(ax: AnyAxes, loads: Callable[[float], tuple[float, float]], rotor: float) -> None:
    """Figure 10.12: a car in a left turn from behind, its rotor, and the forces of the road."""
    ground = Frame("ground")
    s = Sketch(ax, ground, plane="yz", arrows=90)
    inner, outer = loads(rotor)
    s.box((0, 0, 3.7), ground, (8, 5.8, 3.4))
    near = 5  # in front of the box, to be visible
    corners = (-0.5, 2.7), (0.5, 2.7), (0.5, 5.3), (-0.5, 5.3)
    s.plate([(near, y, z) for y, z in corners], shade="dark")
    s.line((near, -1.6, 4), (near, 1.6, 4), style="centre")
    ax.set_title(f"rotor {rotor:.0f} rad/s", fontsize=11)
    level = 3000 / 32.2 * 100**2 / 500
    for y, load, name in ((2.5, outer, "outer"), (-2.5, inner, "inner")):
        wheel = (-0.4, 0), (0.4, 0), (0.4, 2), (-0.4, 2)
        s.plate([(0, y + w, z) for w, z in wheel], shade="dark")
        s.vector((0, y, 0), ground.k * load, kind="force")
        s.label((0, y + 0.2, -0.7), f"{name} {load:.0f} lb")
        s.vector((0, y, 0), ground.j * (-level * load / 3000), "$F_H$", kind="force")
    s.dot((near + 1, 0, 4), "G", offset=(-9, 9))
    s.road([(0, -4.5, 0), (0, 4.5, 0)])


@with_sliders(
    Slider("latitude", 45, 0, 85, 5, label="latitude", unit="°"),
    alt="The azimuth of a gyrocompass against time swings to and fro about north like a "
    "pendulum, with a period of about twenty seconds at 45 degrees; nearer to the pole it "
    "swings more slowly.",
    size=(6.4, 3.6),
)
def compass_swings(
    ax: AnyAxes, I0: float, I: float, omega_z: float, earth_rate: float, latitude: float
) -> None:
    """Figure 10.13: azimuth of a gyrocompass against time, for a latitude."""
    model = gyrocompass(I0, I, omega_z, earth_rate, math.radians(latitude))
    azimuths = [math.degrees(x) for x, _ in states_over(model, 120.0, (1.0, 0.0), 400)]
    ax.plot(evenly(0, 120, 400), azimuths, color=BLUE)
    ax.axhline(0, color="#777777", lw=0.8)
    ax.set(xlim=(0, 120), ylim=(-70, 70), xlabel="time (s)", ylabel="axis east of north (°)")
