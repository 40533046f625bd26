"""The figures of chapter 6: forces and the motions that they produce, seen by observers at rest and
by observers who are carried round.
"""

import math
from collections.abc import Callable, Sequence

from newton_euler import Frame, Model, cylindrical, integrate, moving, polar, spherical
from newton_euler.algebra.scalars import Scalar
from newton_euler.applications.earth import (
    coriolis_acceleration,
    earth_frame,
    earth_rate,
    flight_time,
    ground_frame,
    projectile,
    range_error,
)
from newton_euler.classroom import Slider, interactive_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved
from newton_euler.dynamics.newton import acceleration_by, reaction, resultant_force
from newton_euler.kinematics.paths import along
from newton_euler.scenes.particles.low_pressure import air_near_low

from .colours import BLUE, GREEN, GREY, ORANGE
from .curves import evenly, states_over
from .sliding import with_sliders

O = (0, 0, 0)
G = 9.81
OMEGA_E = 0.727e-4


@with_sliders(
    Slider("pull", 120, 60, 240, 10, label="pull", unit="N"),
    alt="Left: a sledge on snow, with a rope that pulls forward and up, its weight, the support "
    "of the snow and friction. Right: the four forces head to tail; the arrow that closes the "
    "chain points forward along the snow.",
    size=(8.4, 4.2),
    panels=(1, 2),
)
def sledge(axes: Sequence[AnyAxes], pull: float) -> None:
    """Figure 6.1: a sledge, the forces on it, and their sum."""
    m, rope, friction = 20.0, math.radians(30), 0.3
    ground = Frame("ground")
    support = m * G - pull * math.sin(rope)
    forces = {
        "pull": ground.vector(pull * math.cos(rope), 0, pull * math.sin(rope)),
        "support": ground.vector(0, 0, support),
        "friction": ground.vector(-friction * support, 0, 0),
        "weight": ground.vector(0, 0, -m * G),
    }
    places = {"pull": (0.6, 0, 0.3), "support": (-0.25, 0, 0), "friction": (-0.6, 0, 0)}
    s = Sketch(axes[0], ground, plane="xz", arrows=105)
    s.ground(O, ground.k, size=1.7)
    s.box((0, 0, 0.25), ground, (1.2, 0.5, 0.5))
    for name, force in forces.items():
        s.vector(places.get(name, (0, 0, 0.25)), force, name, kind="force", size="N")
    s.label((0, 0, 0.25), "G")
    s = Sketch(axes[1], ground, plane="xz", arrows=150)
    total = m * acceleration_by(m, **forces)
    s.sum(O, total, r"$\mathbf{F}^e$", kind="force", size="N")
    axes[1].set_title(f"a = {total.x / m:.2f} m/s²", fontsize=11)


def hammer_film() -> Animation:
    """A film: a hammer thrown, its centre of mass on a parabola."""
    up, ahead, spin, time = 6.0, 3.0, 8.9, 1.2

    def place(t):
        return ahead * t, 0, up * t - G * t * t / 2

    def end(t):
        return moved(place(t), 0.75, (-math.cos(spin * t), 0, math.sin(spin * t)))

    def draw(t, ax):
        ground = Frame("ground")
        past = [q for q in evenly(0, time, 61) if q <= t + 1e-9]
        hammer = ground.rotate("hammer", "y", angle=spin * t, origin=ground.point("G", *place(t)))
        s = Sketch(ax, ground, plane="xz")
        if len(past) > 1:
            s.path([place(q) for q in past])
            s.path([end(q) for q in past], style="dotted")
        s.rod(hammer.point("", -0.75, 0, 0), hammer.point("", 0.1, 0, 0))
        s.box(hammer.point("", 0.15, 0, 0), hammer, (0.16, 0.16, 0.4))
        s.dot(hammer.origin, "G")

    return animate(
        draw,
        evenly(0, time, 31),
        speed=0.3,
        alt="A hammer is thrown and tumbles. Its centre of mass G draws a parabola, the end of its "
        "handle draws loops about it.",
    )


@with_sliders(
    Slider("t", 0.8, 0, 1.8, 0.1, unit="s"),
    alt="Three pictures of a point on a path that winds outward, with the same force F on it. "
    "F is resolved along x and y, along the path and across it, and along the line from the "
    "origin and across it.",
    size=(9.6, 4.0),
    panels=(1, 3),
)
def three_components(axes: Sequence[AnyAxes], t: float) -> None:
    """Figure 6.2: one force, resolved in three ways."""
    ground = Frame("ground")
    r, theta, _ = along(_spiral, t)
    P = polar(ground, "P", r, theta)
    F = resultant_force(1.0, P.acceleration(ground)).expressed_in(ground)
    e_t = P.velocity(ground).expressed_in(ground).direction()
    across = ground.k.cross(e_t)
    e_r = math.cos(theta.value) * ground.i + math.sin(theta.value) * ground.j
    pairs = (
        ("x", ground.i, "y", ground.j),
        ("t", e_t, "n", across),
        ("r", e_r, r"\theta", ground.k.cross(e_r)),
    )
    titles = ("fixed axes, (6.4)", "along the path, (6.5)", "polar, (6.6)")
    for ax, (first, e, second, n), title in zip(axes, pairs, titles, strict=True):
        parts = {f"$F_{{{first}}}$": F.dot(e) * e, f"$F_{{{second}}}$": F.dot(n) * n}
        s = Sketch(ax, ground, plane="xy", arrows=100)
        s.axes(O, ground, length=0.5, labels=["x", "y", ""])
        s.path([_around(O, *_spiral(q)[:2]) for q in evenly(0, 1.8, 41)], style="dashed")
        if first == "r":
            s.line(O, P)
        s.sum(P, acceleration_by(1.0, **parts), kind="force", label="F")
        s.dot(P)
        ax.set_title(title, fontsize=11)


def _spiral(t):
    """Distance, angle and height at the time t."""
    return 0.6 + 0.5 * t, 0.2 + 0.7 * t + 0.1 * t * t, 0


def _around(C, r, angle):
    """The place at the distance r from C, in this direction from x."""
    return C[0] + r * math.cos(angle), C[1] + r * math.sin(angle), 0


@with_sliders(
    Slider("v", 4.8, 0, 6, 0.1, unit="m/s"),
    alt="A mass at the top of a curved guide whose centre of curvature lies below it. Its "
    "weight W points down. The force N of the guide points up at low speed, vanishes at 2.2 "
    "m/s and points down beyond.",
    size=(6.4, 4.4),
)
def guide(ax: AnyAxes, v: float) -> None:
    """Figure 6.3: the mass at the top of a guide."""
    m, rho = 2.0, 0.5
    ground = Frame("ground")
    s = Sketch(ax, ground, plane="xz", arrows=120)
    angles = evenly(-1, 1, 41)
    for r in (rho - 0.035, rho + 0.035):
        s.wire([(r * math.sin(q), 0, r * math.cos(q) - rho) for q in angles])
    s.line((0, 0, -rho), O, style="centre")
    s.dimension((0, 0, -rho), (rho * math.sin(-0.8), 0, rho * math.cos(0.8) - rho), r"$\rho$", 0)
    s.sphere(O, 0.03)
    s.arrow((0.06, 0, 0), (0.24, 0, 0), r"$\hat e_t$")
    s.vector((-0.02, 0, 0), ground.vector(0, 0, -m * G), r"$\mathbf{W}$", kind="force", size="N")
    N = m * (G - v * v / rho)
    s.vector((0.02, 0, 0), ground.vector(0, 0, N), r"$\mathbf{N}$", kind="force", size="N")
    ax.set_title(f"v²/ρ = {v * v / rho:.1f} m/s², g = {G} m/s²", fontsize=11, pad=18)


def _aeroplane(s, frame, size=1.0):
    """An aeroplane seen from its left side, nose along the first axis of ``frame``."""
    body = [(-1, 0.04), (-0.95, 0.3), (-0.82, 0.3), (-0.7, 0.1), (0.5, 0.12), (0.85, 0.02)]
    body += [(0.8, -0.06), (0.4, -0.1), (-0.6, -0.04)]
    s.plate([frame.point("", size * x, 0, size * z) for x, z in body])


@with_sliders(
    Slider("gamma", 0, 0, 80, 5, label="γ", unit="°"),
    alt="An aircraft on a straight path at the angle gamma above the horizontal. The lift L is at "
    "right angles to the path, the thrust T points along it, the drag D against it and the "
    "weight W down.",
    size=(6.4, 4.8),
)
def aircraft_forces(ax: AnyAxes, gamma: float) -> None:
    """Figure 6.4: the forces on an aircraft that climbs steadily."""
    ground, angle = Frame("ground"), math.radians(gamma)
    path = ground.rotate("path", "-y", angle)
    lift = math.cos(angle)
    s = Sketch(ax, ground, plane="xz", arrows=95)
    _aeroplane(s, path)
    s.line(O, (2.2, 0, 0))
    s.line(path.point("", 1, 0, 0), path.point("", 2.2, 0, 0), style="centre")
    if gamma:
        s.arc(O, (2, 0, 0), path.point("", 2, 0, 0), label=r"$\gamma$", radius=1.6)
    s.vector(O, lift * path.k, "L", kind="force", size="W")
    s.vector(path.point("", -1, 0, 0), -0.1 * lift * path.i, "D", kind="force", size="W")
    thrust = 0.1 * lift + math.sin(angle)
    s.vector(path.point("", 0.85, 0, 0), thrust * path.i, "T", kind="force", size="W")
    s.vector(O, -ground.k, "W", kind="force")


def phugoid(
    vertical_flight: Callable[..., Model], lift: Callable[..., Scalar], trim: float
) -> None:
    """Figure 6.5: the path of a glider let go level at a speed that is not the trim speed."""
    glider = vertical_flight(m=300.0, g=G, lift=lift)

    def draw(ax, ratio):
        states = states_over(glider, 60.0, (ratio * trim, 0.0, 0.0, 0.0), 481)
        v, _, x, y = zip(*states, strict=True)
        ax.plot(x, y, color=BLUE)
        ax.plot(x[::16], y[::16], "o", ms=4, color=BLUE)
        ax.set(xlim=(-50, 1950), ylim=(-120, 260), xlabel="x (m)", ylabel="y − start (m)")
        ax.set_aspect("equal")
        ax.set_title(f"start at {ratio * trim:.0f} m/s, slowest {min(v):.1f} m/s", fontsize=11)

    interactive_figure(
        draw,
        Slider("ratio", 1.2, 0.7, 2.1, 0.1, label="speed over trim speed"),
        alt="The path of a glider to scale. At the trim speed it is a level line, near it a shallow "
        "wave, farther away a wave with deep valleys and sharp crests, and above 1.73 times the "
        "trim speed a row of loops.",
        size=(9, 3.2),
    )


@with_sliders(
    Slider("theta", 45, 0, 120, 5, label="θ", unit="°"),
    Slider("phi", 35, -20, 70, 5, label="φ", unit="°"),
    alt="One point over the horizontal plane, twice. Left with the unit vectors e_r, e_theta "
    "and k, e_r horizontal; right with e_R along the line from the origin, e_theta horizontal "
    "and e_phi upward along the meridian.",
    size=(9, 4.6),
    panels=(1, 2),
)
def coordinates_in_space(axes: Sequence[AnyAxes], theta: float, phi: float) -> None:
    """Figure 6.6: cylindrical and spherical unit vectors at one point."""
    ground = Frame("ground")
    th, ph = math.radians(theta), math.radians(phi)
    r, z = math.cos(ph), math.sin(ph)
    of_r, of_R = cylindrical(ground, "P", r, th, z), spherical(ground, "P", 1.0, th, ph)
    points = (
        (of_r, [r"$\hat e_r$", r"$\hat e_\theta$", r"$\hat k$"], "cylindrical, (6.8)"),
        (of_R, [r"$\hat e_R$", r"$\hat e_\theta$", r"$\hat e_\phi$"], "spherical, (6.9)"),
    )
    for ax, (P, labels, title) in zip(axes, points, strict=True):
        s = Sketch(ax, ground, azimuth=25, elevation=22)
        foot = _around(O, r, th)
        s.axes(O, ground, length=1.15)
        s.ring(O, ground.k, 1.0)
        s.line(O, foot)
        s.line(foot, P)
        if P is of_R:
            s.line(O, P, style="solid")
        s.axes(P, P.local, length=0.5, labels=labels)
        if theta:
            s.arc(O, ground.i, foot, label=r"$\theta$")
        if phi and P is of_R:
            s.arc(O, foot, P, label=r"$\phi$")
        s.dot(P)
        ax.set_title(title, fontsize=11)


@with_sliders(
    Slider("turns", 1.0, 0.05, 1, 0.05),
    alt="Left: a ball on an arm climbs a helix about a vertical screw; the resultant force on "
    "it turns towards the screw as the ball speeds up, that of the arm has an upward part, too. "
    "Right: F_r falls in proportion to the turns, the other components stay the same.",
    size=(9, 4.8),
    panels=(1, 2),
)
def screw_jack(axes: Sequence[AnyAxes], turns: float) -> None:
    """Figure 6.7: the ball of the screw-jack, and its force components over the turns."""
    m, a, K, rise = 0.2, 0.1, 10.0, 0.5 / (2 * math.pi)
    ground, theta = Frame("ground"), 2 * math.pi * turns
    angle = moving(theta, math.sqrt(2 * K * theta), K)
    P = cylindrical(ground, "ball", a, angle, angle * rise)
    F = resultant_force(m, P.acceleration(ground))
    arm = reaction(m, P.acceleration(ground), weight=-m * G * ground.k)
    s = Sketch(axes[0], ground, azimuth=-55, elevation=18, arrows=75)
    s.shaft((0, 0, -0.05), (0, 0, 0.6))
    angles = [q / 10 for q in range(int(20 * math.pi) + 1)]
    s.path([(a * math.cos(q), a * math.sin(q), rise * q) for q in angles], style="dashed")
    s.rod((0, 0, float(P.position(ground).z)), P)
    s.sphere(P, 0.014)
    s.vector(P, F, r"$\mathbf{F}^e$", kind="acceleration", size="N")
    s.vector(P, arm, "arm", kind="force", size="N")
    ax = axes[1]
    ax.plot([0, 1], [0, -m * a * 4 * math.pi * K], color=ORANGE, label="$F_r$")
    ax.axhline(m * a * K, color=BLUE, ls="--", label=r"$F_\theta$")
    ax.axhline(m * rise * K, color=GREEN, ls=":", lw=2, label="$F_z$")
    ax.axhline(float(arm.z), color="black", ls="-.", label="arm, upward")
    ax.axvline(turns, color=GREY, lw=0.8)
    ax.set(xlabel="turns", ylabel="component (N)", xlim=(0, 1), ylim=(-2.8, 2.8))
    ax.legend(frameon=False, fontsize=9, loc="lower left")


@with_sliders(
    Slider("a", 3.0, 0, 6, 0.5, label="acceleration", unit="m/s²"),
    alt="A lamp on a cord in a wagon; it leans back as the wagon gains speed. "
    "Left: tension and weight act on it and do not balance while it accelerates to the right. Right: a third arrow, "
    "minus m times the wagon's acceleration, closes the balance.",
    size=(9, 4.2),
    panels=(1, 2),
)
def wagon(axes: Sequence[AnyAxes], a: float) -> None:
    """Figure 6.8: a lamp in a wagon that speeds up, seen by two observers."""
    m, length = 2.0, 1.1
    ground = Frame("ground")
    tension = m * math.hypot(a, G)
    e = ground.vector(a / math.hypot(a, G), 0, G / math.hypot(a, G))
    lamp = moved((0, 0, 2.1), -length, e.components())
    for ax, title in zip(axes, ("seen from the ground", "seen from the wagon"), strict=True):
        s = Sketch(ax, ground, plane="xz", arrows=48)
        _wagon_body(s, ground)
        s.line((0, 0, 2.1), lamp, style="solid")
        s.line((0, 0, 2.1), (0, 0, 0.6))
        s.sphere(lamp, 0.09)
        s.vector(lamp, tension * e, "S", kind="force", size="N")
        s.vector(lamp, -m * G * ground.k, "mg", kind="force", size="N")
        if ax is axes[0]:
            s.vector((-0.6, 0, 2.5), a * ground.i, r"$\mathbf{a}$", "acceleration", size="m/s²")
        else:
            s.vector(lamp, -m * a * ground.i, r"$-m\mathbf{a}_{O_2}$", kind="plain", size="N")
        ax.set_title(title, fontsize=11)


def _wagon_body(s, ground):
    corners = ((-2.5, 0, 0.2), (2.5, 0, 0.2), (2.5, 0, 2.1), (-2.5, 0, 2.1))
    s.wire([*corners, corners[0]])
    s.ground(O, ground.k, size=5.4)
    for x in (-1.8, 1.8):
        s.disk((x, 0, 0.18), ground.j, 0.18)


@with_sliders(
    Slider("r", 100, 60, 140, 10, label="radius", unit="m"),
    alt="A ring that turns clockwise about its centre. At the point A on the right its velocity "
    "points down along the rim, and its acceleration to the centre. A larger ring has a "
    "faster rim; the acceleration stays 9.81 m/s².",
    size=(5.6, 5.2),
)
def station(ax: AnyAxes, r: float) -> None:
    """Figure 6.9: velocity and acceleration at the rim of a station that turns clockwise."""
    ground, omega = Frame("ground"), math.sqrt(G / r)
    s = Sketch(ax, ground, plane="xy", arrows=85)
    _rim(s, O, r, 0.0)
    A = (r, 0, 0)
    s.turn(O, -ground.k, r"$\omega$")
    s.vector(A, -omega * r * ground.j, r"$\mathbf{v}_A$", size="m/s")
    s.vector(A, -omega * omega * r * ground.i, r"$\mathbf{a}_A$", "acceleration", size="m/s²")
    s.dot(A, "A")
    turns = omega * 30 / math.pi
    ax.set_title(f"r = {r} m: ω = {omega:.3f} rad/s, {turns:.1f} turns a minute", fontsize=11)


def _rim(s, C, r, turned):
    """The rim and four spokes of a station about C, turned clockwise."""
    s.ring(C, (0, 0, 1), r)
    for n in range(4):
        spoke = _around(C, r, n * math.pi / 2 - turned + math.pi / 4)
        s.line(C, spoke, style="dotted")


def _flight(r, u):
    """(rate of the station, time of flight) of a throw at u through the axis."""
    omega = math.sqrt(G / r)
    return omega, 2 * r * u / (u * u + omega * omega * r * r)


def _ball(C, r, u, t, turned):
    """The ball at the time t, in a picture that is turned counterclockwise about C."""
    omega = math.sqrt(G / r)
    x, y = r - u * t, -omega * r * t
    c, s = math.cos(turned), math.sin(turned)
    return C[0] + x * c - y * s, C[1] + x * s + y * c, 0


def _throw_scene(s, C, r, u, t, inside):
    """The station about C, thrower, friend and ball at the time t, seen from inside or from the
    stars.
    """
    omega = math.sqrt(G / r)
    turned = 0.0 if inside else omega * t
    _rim(s, C, r, turned)
    for angle, name in ((0.0, "thrower"), (math.pi, "friend")):
        place = _around(C, r, angle - turned)
        s.dot(place)
        inward = math.cos(angle - turned), math.sin(angle - turned)
        s.label(place, name, offset=(-38 * inward[0], 10 - 20 * inward[1]), bold=False)
    s.line(_around(C, r, 0.0), _around(C, r, math.pi))  # the aim
    parts = 20 if inside else 1  # from the stars it is a straight line
    past = evenly(0, t, parts + 1)
    if t:
        s.path([_ball(C, r, u, q, omega * q if inside else 0.0) for q in past])
    s.sphere(_ball(C, r, u, t, omega * t if inside else 0.0), 0.05 * r)


def throw_film() -> Animation:
    """A film: a throw through the axis, from the stars and from the station."""
    r, u = 100.0, 60.0
    _, time = _flight(r, u)

    def draw(t, ax):
        ground = Frame("ground")
        s = Sketch(ax, ground, plane="xy")
        for C, inside, name in (
            (O, False, "from the stars"),
            ((2.9 * r, 0, 0), True, "from inside"),
        ):
            _throw_scene(s, C, r, u, t, inside)
            s.label((C[0], -1.3 * r, 0), name, offset=(0, 0), bold=False)

    return animate(
        draw,
        evenly(0, time, 25),
        speed=time / 5,
        size=(7, 3.3),
        alt="A ball is thrown across a station that turns clockwise, seen twice. From the stars it "
        "flies straight while thrower and friend are carried round; from inside it flies along a "
        "curve and comes down behind the friend.",
    )


@with_sliders(
    Slider("u", 60, 10, 400, 10, label="throw", unit="m/s"),
    Slider("part", 100, 0, 100, 5, label="time", unit="% of the flight"),
    alt="A ball thrown across a station that turns clockwise. Left, seen from the stars: a "
    "straight line to the rim, and the friend has been carried away from its end. Right, seen "
    "from inside: a curve that ends behind the friend.",
    size=(8.6, 4.6),
    panels=(1, 2),
)
def throw(axes: Sequence[AnyAxes], u: float, part: float) -> None:
    """Figure 6.10: the throw with its speed and the time on sliders."""
    r = 100.0
    ground, (_, time) = Frame("ground"), _flight(r, u)
    t = time * part / 100
    observers = (False, "from the stars"), (True, "from inside")
    for ax, (inside, name) in zip(axes, observers, strict=True):
        s = Sketch(ax, ground, plane="xy")
        _throw_scene(s, O, r, u, t, inside)
        ax.set_title(f"{name}, t = {t:.2f} s of {time:.2f} s", fontsize=11)


@with_sliders(
    Slider("latitude", 45, -85, 85, 5, label="λ", unit="°"),
    alt="A circle, the Earth cut along its axis, with a body at B on it. The attraction mg "
    "points to the centre. The support N is the opposite arrow with m a_B added, which points "
    "to the axis: N is shorter and leans from the radius towards the axis.",
    size=(6.2, 5.2),
)
def plumb_line(ax: AnyAxes, latitude: float) -> None:
    """Figure 6.11: why the support does not point away from the centre; drawn too large."""
    share, long = 100 * 0.00344, 0.75
    ground, lam = Frame("ground"), math.radians(latitude)
    B = up = ground.vector(math.cos(lam), 0, math.sin(lam))
    north = ground.vector(-math.sin(lam), 0, math.cos(lam))
    a = -share * math.cos(lam) * ground.i
    s = Sketch(ax, ground, plane="xz")
    s.ring(O, ground.j, 1.0)
    s.line((0, 0, -1.25), (0, 0, 1.25), style="centre")
    s.line((-1, 0, 0), (1, 0, 0), style="dotted")
    s.line(O, B + 0.95 * up)
    if latitude:
        s.arc(O, (1, 0, 0), B, label=r"$\lambda$")
    s.arrow(B, B - long * up, "$mg$", kind="force")
    s.arrow(B, B + long * (up + a), r"$\mathbf{N}$", kind="force")
    s.arrow(B + long * up, B + long * (up + a), r"$m\mathbf{a}_B$", kind="acceleration")
    s.arrow(B, B + 0.35 * north, "north")
    s.dot(B)
    s.label((0, 0, 1.25), "axis", offset=(-18, 0), bold=False)


def _site(latitude):
    return ground_frame(earth_frame(Frame("stars"), OMEGA_E), math.radians(latitude))


@with_sliders(
    Slider("latitude", 45, -90, 90, 5, label="latitude", unit="°"),
    Slider("azimuth", 90, 0, 360, 10, label="velocity, from east to north", unit="°"),
    alt="A horizontal plate with the axes east, north and up. The Earth's angular velocity "
    "leans from north towards up by the latitude. A horizontal velocity and, at right angles "
    "to both, the Coriolis acceleration, to the right of the velocity in the north.",
    size=(6.8, 4.8),
)
def coriolis_on_the_ground(ax: AnyAxes, latitude: float, azimuth: float) -> None:
    """Figure 6.12: the Coriolis acceleration of a horizontal velocity."""
    omega, th = earth_rate(_site(latitude)).components(), math.radians(azimuth)
    ground = Frame("ground")
    omega_e = ground.vector(*(x / OMEGA_E for x in omega))
    v = math.cos(th) * ground.i + math.sin(th) * ground.j
    s = Sketch(ax, ground, azimuth=-65, elevation=28, arrows=95)
    s.plate([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)])
    s.axes(O, ground, length=0.8, labels=["east", "north", "up"])
    s.vector(O, omega_e, r"$\omega_e$", kind="rate")
    s.vector(O, v, r"$\mathbf{v}_r$")
    a = coriolis_acceleration(omega_e, v)
    s.vector(O, a, r"$-2\omega_e\times\mathbf{v}_r$", kind="acceleration")
    right = a.dot(v.cross(ground.k))
    aside = f"to the {'right' if right >= 0 else 'left'}: {abs(right):.2f}"
    ax.set_title(rf"{aside}, up: {a.z:+.2f}, in units of $\omega_e v_r$", fontsize=11)


def _swing_turned(hours, latitude):
    """By how much the swing of Foucault's pendulum has turned, in degrees; negative: clockwise."""
    return -math.degrees(OMEGA_E * math.sin(math.radians(latitude))) * 3600 * hours


def _swing_in_words(hours, latitude):
    turned = _swing_turned(hours, latitude)
    way = "clockwise" if turned < 0 else "counterclockwise"
    return (
        "The floor under a pendulum from above, a ring with the four directions. The line of its "
        f"swing has turned {way} from east by {abs(turned):.0f} degrees in {hours} hours; fainter "
        "lines show it on each hour before."
    )


@with_sliders(
    Slider("hours", 6, 0, 24, 1, label="after", unit="h"),
    Slider("latitude", 49, -90, 90, 1, label="latitude", unit="°"),
    alt=_swing_in_words,
    size=(5.4, 5.2),
)
def foucault(ax: AnyAxes, hours: int, latitude: float) -> None:
    """Figure 6.13: the swings of Foucault's pendulum, hour by hour, on the floor below."""
    angles = evenly(0, 2 * math.pi, 121)
    ring = zip(*((3.2 * math.cos(a), 3.2 * math.sin(a)) for a in angles), strict=True)
    ax.plot(*ring, color=GREY, lw=0.8)
    for hour in range(hours + 1):
        turned = math.radians(_swing_turned(hour, latitude))
        x, y = 3 * math.cos(turned), 3 * math.sin(turned)
        now = hour == hours
        ax.plot([-x, x], [-y, y], color=BLUE, lw=2.5 if now else 0.8, alpha=1 if now else 0.5)
        ax.plot(x, y, "o", color=ORANGE, ms=11 if now else 4)
    for name, x, y in (("E", 3.6, 0), ("N", 0, 3.6), ("W", -3.6, 0), ("S", 0, -3.6)):
        ax.text(x, y, name, ha="center", va="center")
    ax.set(xlim=(-4, 4), ylim=(-4, 4))
    ax.set_aspect("equal")
    ax.axis("off")
    a_hour = abs(_swing_turned(1, latitude))
    ax.set_title(f"{a_hour:.1f}° an hour, {a_hour * hours:.0f}° in {hours} h", fontsize=11)


@with_sliders(
    Slider("azimuth", 90, 0, 360, 10, label="azimuth", unit="°"),
    Slider("latitude", 45, -90, 90, 5, label="latitude", unit="°"),
    alt="A shot seen from above: a dashed straight line for an Earth at rest, and a solid "
    "curve for the turning Earth, its displacement magnified. In the north the curve bends to "
    "the right, in the south to the left.",
    size=(5.8, 5.6),
)
def shot(ax: AnyAxes, azimuth: float, latitude: float) -> None:
    """Figure 6.14: a shot from above, what the rotation does to it magnified."""
    v0, elevation, magnified = 300.0, math.pi / 4, 100
    lam, th = math.radians(latitude), math.radians(azimuth)

    def path(rate):  # east, north
        given = v0, th, elevation, lam, G, rate
        times = evenly(0, flight_time(*given), 60)
        return list(zip(*(projectile(t, *given)[:2] for t in times), strict=True))

    still, there = path(0.0), path(OMEGA_E)
    drawn = [
        [(a + magnified * (b - a)) / 1000 for a, b in zip(*both, strict=True)]
        for both in zip(still, there, strict=True)
    ]
    in_km = ([x / 1000 for x in side] for side in still)
    ax.plot(*in_km, color=GREY, ls="--", label="Earth at rest")
    ax.plot(*drawn, color=BLUE, label="Earth turning, magnified")
    ax.plot(*(side[-1] for side in drawn), "o", color=BLUE)
    ax.plot(*(side[-1] / 1000 for side in still), "o", mfc="none", color=GREY)
    ax.plot(0, 0, "ks")
    ax.set(xlim=(-12.5, 12.5), ylim=(-12.5, 12.5), xlabel="east (km)", ylabel="north (km)")
    ax.set_aspect("equal")
    ax.legend(frameon=False, fontsize=9, loc="lower left")
    east, north = (b[-1] - a[-1] for a, b in zip(still, there, strict=True))
    right = east * math.sin(th) - north * math.cos(th)
    ahead = east * math.cos(th) + north * math.sin(th)
    side, way = "right" if right >= 0 else "left", "farther" if ahead >= 0 else "shorter"
    ax.set_title(f"{abs(right):.1f} m to the {side}, {abs(ahead):.1f} m {way}", fontsize=11)


@with_sliders(
    Slider("v0", 1000, 100, 2000, 100, label="speed of the shot", unit="m/s"),
    alt="The error of the range without rotation against the elevation. To the east it is "
    "negative at low elevations, zero at 60 degrees, and grows steeply beyond; to the west it "
    "has the opposite sign.",
    size=(6.6, 4.0),
)
def range_errors(ax: AnyAxes, v0: float) -> None:
    """Figure 6.15: the error of the range without rotation, against the elevation."""
    elevations = evenly(2, 84, 120)
    east = [100 * range_error(v0, math.radians(x), G, OMEGA_E) for x in elevations]
    ax.plot(elevations, east, color=BLUE, label="to the east")
    ax.plot(elevations, [-x for x in east], color=ORANGE, ls="--", label="to the west")
    ax.axhline(0, color="black", lw=0.8)
    ax.axvline(60, color=GREY, ls=":")
    ax.set(xlim=(0, 90), ylim=(-4, 4), xlabel="elevation (°)", ylabel="error of the range (%)")
    ax.legend(frameon=False, loc="upper center")


PARCELS = 8  # parcels of air on a ring round a low


def _air(latitude, friction, days=2.0, gradient=1e-8):
    """A function: x and y, in 100 km, of air from rest 300 km to the east, at times in s."""
    model = air_near_low(math.radians(latitude), gradient, friction, OMEGA_E)
    motion = integrate(model, days * 86400, (3e5, 0.0, 0.0, 0.0))

    def places(times):
        states = [motion.at(t) for t in times]
        return [[state[n] / 1e5 for state in states] for n in ("x", "y")]

    return places


def _turned(xy, angle):
    c, s = math.cos(angle), math.sin(angle)
    turned = [(c * x - s * y, s * x + c * y) for x, y in zip(*xy, strict=True)]
    return [[*side] for side in zip(*turned, strict=True)]


def low_film() -> Animation:
    """A film: a ring of air round a low at 45 degrees north."""
    place = _air(45, 4e-5)

    def draw(t, ax):
        ground = Frame("ground")
        s = Sketch(ax, ground, plane="xy")
        s.ring(O, ground.k, 3.0)
        s.label(O, "low", offset=(0, 0))
        trail = place(evenly(max(0.0, t - 6 * 3600), t, 10))
        for n in range(PARCELS):
            x, y = _turned(trail, 2 * math.pi * n / PARCELS)
            if t:
                s.path([(a, b, 0) for a, b in zip(x, y, strict=True)])
            s.dot((x[-1], y[-1], 0))

    return animate(
        draw,
        evenly(0, 105e3, 22),
        alt="Eight parcels of air on a ring start towards a low in the middle. Their paths bend to "
        "the right, keep the low on their left, and wind round it counterclockwise.",
    )


@with_sliders(
    Slider("latitude", 45, -75, 75, 5, label="latitude", unit="°"),
    alt="Eight paths of air that starts at rest on a ring round a low. In the north they keep "
    "it on their left and go round it counterclockwise, in the south clockwise, at the equator "
    "they run straight through the middle. With friction they wind inward.",
    size=(9, 4.8),
    panels=(1, 2),
)
def low(axes: Sequence[AnyAxes], latitude: float) -> None:
    """Figure 6.16: the paths of air near a low, without and with friction."""
    for ax, friction in zip(axes, (0.0, 4e-5), strict=True):
        path = _air(latitude, friction)(evenly(0, 2 * 86400, 200))
        around = [_turned(path, 2 * math.pi * n / PARCELS) for n in range(PARCELS)]
        for x, y in around[1:]:
            ax.plot(x, y, color=BLUE, lw=0.6)
        ax.plot(*around[0], color=ORANGE, lw=2)
        for x, y in around:
            ax.plot(x[0], y[0], "o", ms=4, color=BLUE)
            way = x[17] - x[16], y[17] - y[16]
            towards = [[step / math.hypot(*way)] for step in way]
            ax.quiver([x[16]], [y[16]], *towards, scale=18, width=0.009, zorder=3)
        ax.plot(0, 0, "k+", ms=10)
        ax.set(xlim=(-3.3, 3.3), ylim=(-3.3, 3.3), xlabel="east (100 km)")
        ax.set_title("with friction" if friction else "without friction", fontsize=11)
        ax.set_aspect("equal")
    axes[0].set_ylabel("north (100 km)")


@with_sliders(
    Slider("bank", 30, 10, 60, 5, label="σ", unit="°"),
    alt="Left: the axes east, north and up; the heading chi from north to the horizontal part of "
    "the velocity, the path angle gamma from there to the velocity, with the axes of frame 4. "
    "Middle: an aircraft from behind, banked to the right by sigma. Its lift is tilted: the "
    "vertical part carries the weight, the horizontal part pulls to the right. Right: its path "
    "from above, a circle to the right; the scale of its axes follows the radius, which is smaller "
    "for a larger bank.",
    size=(9.6, 4.0),
    panels=(1, 3),
)
def banked(axes: Sequence[AnyAxes], bank: float) -> None:
    """Figure 6.17: heading and path angle, a banked aircraft from behind, its path from above."""
    v = 60.0
    ground, angle = Frame("ground"), math.radians(bank)
    _heading_and_path_angle(axes[0], ground)
    plane = ground.rotate("plane", "y", angle)
    lift = plane.k / math.cos(angle)
    s = Sketch(axes[1], ground, plane="xz", arrows=85)
    s.rod(plane.point("", -1, 0, 0), plane.point("", 1, 0, 0))
    s.rod(O, plane.point("", 0, 0, 0.42))
    s.sphere(O, 0.16)
    s.vector(O, lift, "L", kind="force", size="W")
    s.vector(O, math.tan(angle) * ground.i, r"$L\sin\sigma$", kind="force")
    s.arc(O, (0, 0, 1), plane.point("", 0, 0, 1), label=r"$\sigma$")
    s.vector(O, ground.k, r"$L\cos\sigma$", kind="force", size="W")
    s.vector(O, -ground.k, "W", kind="force")
    axes[1].set_title(rf"from behind, $L\sin\sigma$ = {math.tan(angle):.2f} W", fontsize=11)
    rate = G * math.tan(angle) / v
    turns, r = [rate * t for t in evenly(0, 60, 241)], v / rate / 1000
    east, north = [r * (1 - math.cos(q)) for q in turns], [r * math.sin(q) for q in turns]
    axes[2].plot(east, north, color=BLUE)
    axes[2].plot(east[::40], north[::40], "o", ms=4, color=BLUE)
    axes[2].set(xlim=(-0.2 * r, 2.2 * r), ylim=(-1.2 * r, 1.2 * r))
    axes[2].set(xlabel="x east, y north (km)")
    axes[2].set_aspect("equal")
    axes[2].set_title(f"from above, radius {1000 * r:.0f} m", fontsize=11)


def _heading_and_path_angle(ax, ground):
    """The axes of frame 4 in the ground, with the heading 50 and the path angle 25 degrees."""
    north = ground.rotate("2", "z", math.pi / 2)  # first axis north, second west
    level = north.rotate("3", "-z", math.radians(50))
    path = level.rotate("4", "-y", math.radians(25))
    s = Sketch(ax, ground, azimuth=-75, elevation=30)
    s.axes(O, ground, length=1.1, labels=["east", "north", "up"])
    s.line(O, level.point("", 1.1, 0, 0))
    s.line(level.point("", 1.1, 0, 0), path.point("", 1.1 / math.cos(math.radians(25)), 0, 0))
    s.axes(O, path, length=1.05, labels=["$\\hat\\imath_4$", "$\\hat\\jmath_4$", "$\\hat k_4$"])
    s.arc(O, ground.j, level.i, label=r"$\chi$", radius=0.45)
    s.arc(O, level.i, path.i, label=r"$\gamma$", radius=0.75)
    ax.set_title("heading and path angle", fontsize=11)
