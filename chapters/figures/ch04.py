"""The figures of chapter 4: frames, turns, angular velocities and the terms of an acceleration."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TypeAlias

from newton_euler import Frame, Point, axis_angle, euler_frame, rotation_matrix
from newton_euler.algebra.late import np, plt
from newton_euler.algebra.scalars import Scalar
from newton_euler.classroom import Slider, show_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.paper import Panels
from newton_euler.drawing.page.projection import moved
from newton_euler.kinematics.paths import Path
from newton_euler.kinematics.rotations import apply

from .colours import BLUE, GREY, ORANGE
from .curves import evenly
from .curves import second_derivative as second_derivative  # for the notebook
from .sliding import with_sliders

O = (0, 0, 0)
Cone: TypeAlias = Callable[..., tuple[Frame, Frame, Frame, Frame]]  # ground, carriage, axle, cone
Crane: TypeAlias = Callable[..., tuple[Frame, Frame, Frame, Point]]  # ground, column, boom, A


@with_sliders(
    Slider("theta", 50, 0, 120, 5, label="θ", unit="°"),
    alt="A rod turns about its end B in a horizontal plane; a bead A slides outward along it. "
    "Drawn: the fixed axes X, Y, Z at O, the moving axes x, y, z at B, the vector r from B to "
    "A, the relative velocity v_r along the rod, and the angular velocity omega.",
    size=(6.4, 4.2),
)
def moving_frame(ax: AnyAxes, theta: float) -> None:
    """Figure 4.2: a bead on a turning rod, with B, r, v_r and omega."""
    ground = Frame("ground")
    B = ground.point("B", 0.25, 0.15, 0)
    rod = ground.rotate("rod", "z", angle=math.radians(theta), origin=B)
    A = rod.point("A", 0.8, 0, 0)
    s = Sketch(ax, ground, azimuth=25, elevation=30)
    s.axes(O, ground, length=0.45, labels="XYZ")
    s.axes(B, rod, length=0.35)
    s.rod(B, rod.point("", 1.2, 0, 0))
    s.sphere(A, 0.045)
    s.arrow(B, A, r"$\mathbf{r}$")
    s.vector(A, rod.i, r"$\mathbf{v}_r$")
    s.turn(B, ground.k, r"$\omega$", radius=0.2)
    for point, name in ((O, "O"), (B, "B"), (A, "A")):
        s.label(point, name)


def _one_turn(psi, theta, phi):
    """Frames ground and body of figure 4.3, and the axis and the angle of the one turn."""
    ground = Frame("ground")
    body = euler_frame(ground, "body", *map(math.radians, (psi, theta, phi)))
    return ground, body, *axis_angle(body.rotation(ground))


def _one_turn_in_words(**angles):
    turned = _one_turn(**angles)[3] > 1e-9
    arcs = (
        "Three arcs lead from X to x, Y to y and Z to z, all on circles about one dash-dotted line, "
        "the axis of the single turn that replaces the three."
    )
    return "Fixed axes X, Y, Z and axes x, y, z with one origin. " + (
        arcs if turned else "The second lie on the first: nothing is turned."
    )


@with_sliders(
    Slider("psi", 40, -180, 180, 5, label="ψ", unit="°"),
    Slider("theta", 60, 0, 180, 5, label="θ", unit="°"),
    Slider("phi", 30, -180, 180, 5, label="φ", unit="°"),
    alt=_one_turn_in_words,
    size=(6.6, 4.8),
)
def eulers_theorem(ax: AnyAxes, psi: float, theta: float, phi: float) -> None:
    """Figure 4.3: three turns and the one turn that does the same."""
    ground, body, axis, angle = _one_turn(psi, theta, phi)
    s = Sketch(ax, ground, azimuth=35, elevation=25)
    s.axes(O, ground, length=1.0, labels="XYZ")
    s.axes(O, body, length=1.0)
    if angle <= 1e-9:
        ax.set_title("not turned", fontsize=11)
        return
    for start in (ground.i, ground.j, ground.k):
        s.path([apply(rotation_matrix(axis, a), start) for a in evenly(0, angle, 41)])
    end = tuple(1.3 * x for x in axis)
    s.line(tuple(-x for x in end), end, style="centre")
    s.turn(end, axis, label=r"$\theta_e$")
    about = ", ".join(f"{round(float(x), 2) + 0.0:.2f}" for x in axis)
    ax.set_title(f"one turn: {math.degrees(angle):.0f}° about ({about})", fontsize=11)


def _orders_in_words(a, b):
    same = a % 360 == 0 or b % 360 == 0 or (a == b == 180)
    return (
        "Six pictures of a brick with its axes x, y, z. Upper row: at the start, turned by "
        f"{a} degrees about the fixed axis X, then by {b} about the fixed axis Y. Lower row: first "
        f"about Y, then about X. The two bricks at the right lie {'alike' if same else 'differently'}."
    )


@with_sliders(
    Slider("a", 90, 0, 180, 5, label="about X", unit="°"),
    Slider("b", 90, 0, 180, 5, label="about Y", unit="°"),
    alt=_orders_in_words,
    size=(8.4, 5.2),
    panels=(2, 3),
)
def two_orders(axes: Panels, a: float, b: float) -> None:
    """Figure 4.4: a brick turned about X and Y in both orders."""
    ground = Frame("ground")
    a, b = math.radians(a), math.radians(b)
    # turns about fixed axes: the later one is nearer to the ground in the chain
    frames = {
        "turned about X": ground.rotate("1", "x", a),
        "then about Y": ground.rotate("2", "y", b).rotate("3", "x", a),
        "turned about Y": ground.rotate("1", "y", b),
        "then about X": ground.rotate("2", "x", a).rotate("3", "y", b),
    }
    turned = list(frames.items())
    pictures = [("start", ground), *turned[:2], ("start", ground), *turned[2:]]
    for ax, (title, frame) in zip(axes.flat, pictures, strict=True):
        s = Sketch(ax, ground, azimuth=35, elevation=22)
        s.box(O, frame, (1.6, 0.9, 0.35))
        s.axes(O, frame, length=1.25)
        ax.set_title(title, fontsize=10)


def shrinking_gap(gap: Callable[[float], float]) -> None:
    """Figure 4.5: the gap between the two orders, ``gap(angle)``, against the angle."""
    angles = np.geomspace(1e-3, math.pi / 2, 25)
    fig, ax = plt.subplots(figsize=(6, 3.4))
    gaps = [gap(a) for a in angles]
    ax.loglog(angles, gaps, "o", color=BLUE, label="gap between the orders")
    ax.loglog(angles, angles, color=GREY, ls=":", label="the angle itself")
    ax.loglog(angles, angles**2, color=ORANGE, label="square of the angle")
    ax.set(xlabel="angle of both turns (rad)", ylabel="gap (rad)")
    ax.legend(frameon=False)
    show_figure(
        fig,
        alt="Logarithmic plot of the gap between the two orders against the angle of both turns. "
        "The points follow the line of the angle squared, two decades down for each decade of "
        "angle, far below the line of the angle itself.",
    )


@with_sliders(
    Slider("turn", 40, 2, 60, 2, label="Δθ", unit="°"),
    alt="The vector r at the angle beta from the axis e is turned by Delta theta: its tip "
    "moves along a circle of radius r sin beta. The chord Delta r and the tangent, Delta theta times "
    "e cross r, differ less and less as the angle shrinks.",
    size=(6.4, 4.4),
)
def small_turn(ax: AnyAxes, turn: float) -> None:
    """Figure 4.6: a small turn moves the tip of r by the cross product."""
    ground = Frame("ground")
    r, angle = (0.75, 0, 0.8), math.radians(turn)
    turned = apply(rotation_matrix((0, 0, 1), angle), r)
    tangent = (r[0], r[1] + 0.75 * angle, r[2])
    s = Sketch(ax, ground, azimuth=-70, elevation=25)
    s.line((0, 0, -0.1), (0, 0, 1.02), style="centre")
    s.ring((0, 0, 0.8), ground.k, 0.75)
    s.arrow(O, r, r"$\mathbf{r}$")
    s.arrow(O, turned, r"$\mathbf{r}+\Delta\mathbf{r}$")
    s.line((0, 0, 0.8), r)
    s.line((0, 0, 0.8), turned)
    s.arrow(r, turned, r"$\Delta\mathbf{r}$", kind="velocity")
    s.arrow(r, tangent, r"$\Delta\theta\,\hat{e}\times\mathbf{r}$", "rate")
    s.arc(O, (0, 0, 1), r, label=r"$\beta$")
    s.arc((0, 0, 0.8), r, turned, label=r"$\Delta\theta$")
    s.label((0, 0, 1.02), r"$\hat{e}$")
    miss = math.dist(turned, tangent)
    ax.set_title(f"the two differ by {miss / (0.75 * angle):.1%} of their length", fontsize=11)


@with_sliders(
    Slider("r", 0.3, 0.1, 0.6, 0.05, unit="m"),
    Slider("azimuth", 0, 0, 360, 5, label="azimuth", unit="°"),
    alt="A cone lies on a plane with its apex at O and rolls round the vertical axis Z. The "
    "velocity of the highest point P is twice that of the centre B, in the same direction; "
    "omega lies along the line of contact OC, alpha lies in the plane at right angles to it.",
)
def rolling_cone(ax: AnyAxes, build: Cone, r: float, azimuth: float) -> None:
    """Figure 4.7: the cone, from ``build(h, r, nu, azimuth)``, its frames."""
    h, nu = 0.4, 0.6
    ground, carriage, axle, cone = build(h, r, nu, math.radians(azimuth))
    round_Z = float(-carriage.angular_velocity(ground).z)
    spun = math.radians(azimuth) * float(cone.angular_velocity(axle).x) / round_Z
    B, C, P = (axle.point(name, h, 0, z) for name, z in (("B", 0), ("C", -r), ("P", r)))
    v_P = cone.point("P", h, 0, r).velocity(ground)
    s = Sketch(ax, ground, azimuth=-65, elevation=25)
    s.ground(axle.point("", h / 2, 0, -r / 2), ground.k, size=1.15 * math.hypot(h, r))
    s.cone(O, cone.i, length=h, radius=r)
    s.line(B, axle.point("", h, r * math.sin(spun), -r * math.cos(spun)), style="solid")
    s.axes(O, ground, length=0.75, labels="XYZ")
    s.vector(P, v_P, label=r"$\mathbf{v}_P$", size="m/s")
    s.vector(B, B.velocity(ground), label=r"$\mathbf{v}_B$")
    s.vector(O, cone.angular_velocity(ground), r"$\omega$", kind="rate", size="rad/s")
    alpha = cone.angular_acceleration(ground)
    s.vector(O, alpha, r"$\alpha$", kind="acceleration", size="rad/s²")
    for place, name in ((O, "O"), (B, "B"), (C, "C"), (P, "P")):
        s.label(place, name)


def cone_film(build: Cone) -> Animation:
    """A film: the cone rolls once round Z."""
    h, r, nu = 0.4, 0.3, 0.6
    time = 2 * math.pi * h**2 / (nu * math.hypot(h, r))

    def draw(t, ax):
        azimuth = 2 * math.pi * t / time
        ground, carriage, axle, cone = build(h, r, nu, azimuth)
        spun = azimuth * float(cone.angular_velocity(axle).x / -carriage.angular_velocity(ground).z)
        s = Sketch(ax, ground, azimuth=-65, elevation=25)
        s.ground(O, ground.k, size=1.1)
        s.cone(O, cone.i, length=h, radius=r)
        for n in range(3):
            angle = spun + n * 2 * math.pi / 3
            rim = axle.point("", h, r * math.sin(angle), -r * math.cos(angle))
            s.line(axle.point("", h, 0, 0), rim, style="solid")
        s.axes(O, ground, length=0.75, labels="XYZ")
        s.vector(O, cone.angular_velocity(ground), r"$\omega$", kind="rate")

    return animate(
        draw,
        evenly(0, time, 41),
        alt="The cone rolls once round the vertical axis; omega turns with the line of contact.",
    )


@with_sliders(
    Slider("turn", 30, 1, 45, 1, label="Δθ", unit="°"),
    alt="Two unit vectors at right angles, before and after a small turn about the third. The "
    "change of the first points along the second, and that of the second against the first; "
    "each is as long as the angle in radians, nearly.",
    size=(5.6, 4.6),
)
def turning_unit_vector(ax: AnyAxes, turn: float) -> None:
    """Figure 4.8: two unit vectors of a frame that turns about the third."""
    ground = Frame("ground")
    angle = math.radians(turn)
    after = ground.rotate("after", "z", angle)
    s = Sketch(ax, ground, plane="xy")
    for e, new, name, change in (
        (ground.i, after.i, r"\imath", r"\Delta\theta\,\hat\jmath"),
        (ground.j, after.j, r"\jmath", r"-\Delta\theta\,\hat\imath"),
    ):
        s.arrow(O, e, rf"$\hat{name}$")
        s.arrow(O, new, rf"$\hat{name}'$")
        s.arrow(e, new, rf"$\approx {change}$", kind="velocity")
    s.arc(O, ground.i, after.i, label=r"$\Delta\theta$")
    s.path(s.around(O, ground.i, ground.k, math.pi / 2 + angle))
    chord = 2 * math.sin(angle / 2)
    ax.set_title(rf"$|\Delta\hat\imath|$ = {chord:.3f}, $\Delta\theta$ = {angle:.3f}", fontsize=11)


@with_sliders(
    Slider("tilt", 30, -10, 70, 5, label="boom raised", unit="°"),
    Slider("speed", 0.8, -1.2, 1.2, 0.1, label="speed outward", unit="m/s"),
    alt="A crane: a vertical column turns about Z and carries a boom on a hinge B; a trolley A "
    "runs out along the boom. Velocity and acceleration of A, seen from the ground, are drawn "
    "as arrows with their magnitudes.",
)
def crane(ax: AnyAxes, build: Crane, tilt: float, speed: float) -> None:
    """Figure 4.1: the crane, from ``build(tilt=…)``: ground, column, boom, A."""
    ground, column, boom, A = build(tilt=tilt, speed=speed)
    B, foot = boom.origin, column.point("", 0, 0, 0)
    s = Sketch(ax, ground, azimuth=20, elevation=18, arrows=80)
    s.ground(foot, ground.k, size=2.4)
    _column_and_boom(s, column, boom, A)
    s.axes(foot, ground, length=1.1, labels="XYZ")
    s.axes(B, boom, length=0.8)
    s.vector(A, A.velocity(ground), label=r"$\mathbf{v}_A$", size="m/s")
    s.vector(A, A.acceleration(ground), r"$\mathbf{a}_A$", kind="acceleration", size="m/s²")
    s.turn(column.point("", 0, 0, 0.55), ground.k, label=r"$\omega$")
    s.label(B, "B")
    s.label(A, "A")


def _column_and_boom(s, column, boom, A):
    """The crane's column, its arm to the hinge B, the boom, and on it the trolley A with its load."""
    top, B = column.point("", 0, 0, 1.0), boom.origin
    s.shaft(column.point("", 0, 0, 0), top)
    s.rod(top, B, boom.point("", 0, 3.6, 0))
    s.hinge(B, column.i)
    x, y, z = A.position(s.frame).components(s.frame)
    s.box(A, boom, (0.16, 0.3, 0.16))
    s.line(A, (x, y, z - 0.7), style="solid")
    s.box((x, y, z - 0.82), s.frame, (0.3, 0.3, 0.24))


def two_sources() -> None:
    """Figure 4.9: where the two halves of the Coriolis term come from, seen along omega."""
    ground = Frame("ground")
    angle, r, dr = math.radians(28), 1.0, 0.45
    later = ground.rotate("later", "z", angle)
    fig, axes = plt.subplots(1, 2, figsize=(8.4, 4))
    titles = "the relative velocity is turned", "a place that moves faster"
    for ax, title in zip(axes, titles, strict=True):
        s = Sketch(ax, ground, plane="xy")
        s.line(O, (1.75, 0, 0))
        s.line(O, later.point("", 1.75, 0, 0))
        s.arc(O, ground.i, later.i, label=r"$\omega\,\Delta t$")
        s.label(O, "B")
        A, A_later = (r, 0, 0), later.point("", r + dr, 0, 0)
        s.label(A, "A")
        if ax is axes[0]:
            before = (r + 0.5, 0, 0)
            after = moved(A, 0.5, later.i.components(ground))
            s.arrow(A, before, r"$\mathbf{v}_r$", kind="velocity")
            s.arrow(A, after, kind="velocity")
            s.arrow(before, after, r"$\omega\times\mathbf{v}_r\,\Delta t$", "acceleration")
        else:
            as_before, faster = (later.point("", r + dr, 0.5 * x, 0) for x in (r, r + dr))
            s.dot(A)
            s.dot(A_later)
            s.arrow(A, (r, 0.5 * r, 0), r"$\omega r$", kind="velocity")
            s.arrow(A_later, as_before, kind="velocity")
            s.arrow(as_before, faster, r"$\omega\,v_r\,\Delta t$", kind="acceleration")
        ax.set_title(title, fontsize=11)
    show_figure(
        fig,
        alt="A rod through B seen along omega at two instants. Left: the relative velocity, "
        "carried round with the rod, changes by omega cross v_r times Delta t. Right: the point has moved "
        "outward, to where the rod itself is faster by omega v_r Delta t.",
    )


@with_sliders(
    Slider("tilt", 30, -10, 70, 5, label="boom raised", unit="°"),
    Slider("speed", 0.8, -1.2, 1.2, 0.1, label="speed outward", unit="m/s"),
    alt="The crane with its column, boom and axes. At the trolley A the five terms of its "
    "acceleration are laid head to tail, with their names; the sum closes the chain.",
    size=(7.5, 5.5),
)
def acceleration_terms(ax: AnyAxes, build: Crane, tilt: float, speed: float) -> None:
    """Figure 4.10: the terms of the crane's acceleration, head to tail."""
    ground, column, boom, A = build(tilt=tilt, speed=speed)
    s = Sketch(ax, ground, azimuth=20, elevation=18, arrows=260)
    s.axes(O, ground, length=1.1, labels="XYZ")
    _column_and_boom(s, column, boom, A)
    s.sum(A, A.acceleration(ground), r"$\mathbf{a}_A$", size="m/s²")


@with_sliders(
    Slider("turn", 25, 1, 60, 1, label="turn of frame 2", unit="°"),
    alt="The angular velocity of frame 3 in frame 2 lies in a plane that turns with frame 2. "
    "Its tip moves along a circle, in the direction of omega 2/1 cross omega 3/2.",
    size=(6.4, 4.2),
)
def carried_round(ax: AnyAxes, turn: float) -> None:
    """Figure 4.11: omega_3/2 is carried round by frame 2; its change is the cross product."""
    ground = Frame("ground")
    w21, w32 = 0.8, 1.0
    before = ground.rotate("2", "z", 0.0)
    after = ground.rotate("2'", "z", math.radians(turn))
    one, two = (tuple(w32 * x for x in frame.i.components(ground)) for frame in (before, after))
    s = Sketch(ax, ground, azimuth=-80, elevation=30)
    s.arrow(O, (0, 0, w21), r"$\omega_{2/1}$", kind="rate")
    s.arrow(O, one, r"$\omega_{3/2}$", kind="rate")
    s.arrow(O, two, r"$\omega_{3/2}$ later", kind="rate")
    s.arrow(one, two, r"$\Delta\omega_{3/2}$", kind="acceleration")
    change = r"$\Delta\omega_{3/2}\approx\omega_{2/1}\times\omega_{3/2}\,\Delta t$"
    ax.set_title(change, fontsize=11)
    s.ring(O, ground.k, w32)
    s.arc(O, one, two, label=r"$\omega_{2/1}\Delta t$")


@with_sliders(
    Slider("phi", 30, 0, 90, 5, label="φ", unit="°"),
    Slider("p", 4.0, -6, 6, 0.5, unit="rad/s"),
    alt="A shaft OB is fixed to a vertical shaft at the angle phi above the horizontal. A disk "
    "at B turns about OB at the rate p while everything turns about Z at omega. The velocity "
    "and the acceleration of the rim point A are drawn with their magnitudes.",
    size=(7, 4.8),
)
def disk_on_shaft(
    ax: AnyAxes,
    build: Callable[..., tuple[Frame, Frame, Frame, Frame, Point]],
    phi: float,
    p: float,
) -> None:
    """Figure 4.12: the disk on the inclined shaft, from ``build(phi, R, r, omega, p, …)``."""
    ground, _, spindle, disk, A = build(math.radians(phi), 0.5, 0.2, 1.2, p, 0.5, 1.0)
    B, foot = disk.origin, ground.point("", 0, 0, -0.3)
    s = Sketch(ax, ground, azimuth=35, elevation=15)
    s.ground(foot, ground.k, size=0.35)
    s.shaft(foot, ground.point("", 0, 0, 0.15))
    s.rod(O, B)
    s.disk(B, normal=disk.j, radius=0.2, spoke=A)
    s.axes(O, ground, length=0.42, labels="XYZ")
    s.turn(ground.point("", 0, 0, -0.16), ground.k, label=r"$\omega$")
    s.turn(spindle.point("", 0, 0.32, 0), disk.j, label="$p$")
    s.arc(O, ground.point("", 0, 0.5, 0), B, label=r"$\phi$")
    s.vector(A, A.velocity(ground), label=r"$\mathbf{v}_A$", size="m/s")
    s.vector(A, A.acceleration(ground), r"$\mathbf{a}_A$", kind="acceleration", size="m/s²")
    for place, name in ((O, "O"), (B, "B"), (A, "A")):
        s.label(place, name)


def step_sizes(steps: Sequence[float], errors: Mapping[str, Sequence[float]], floor: float) -> None:
    """Figure 4.13: the error of each quotient against its step; ``floor``: that of (4.18)."""
    fig, ax = plt.subplots(figsize=(6.4, 3.8))
    looks = (BLUE, "o"), (ORANGE, "s")
    for (name, found), (colour, marker) in zip(errors.items(), looks, strict=True):
        ax.loglog(steps, found, color=colour, marker=marker, ms=5, label=name)
    ax.axhline(1e-3, color="#777777", ls=":", label="good enough for a sensor")
    ax.axhline(floor, color="black", ls="--", label="(4.18), no step")
    ax.set(xlabel="step h (s)", ylabel="relative error of the acceleration")
    ax.legend(frameon=False, fontsize=9, loc=(0.02, 0.1))
    best = {name: min(zip(found, steps, strict=True)) for name, found in errors.items()}
    text = "; ".join(f"{name} {error:.0e} at h = {h:.0e} s" for name, (error, h) in best.items())
    show_figure(
        fig,
        alt="Error of an acceleration by finite differences against the step, on logarithmic "
        f"scales: each curve falls and rises again. Least errors: {text}. The formula (4.18) has "
        f"{floor:.0e}; a good sensor 1e-3.",
    )


def central(path: Path, t: float, h: float) -> list[Scalar]:
    """The second central difference of each coordinate of ``path`` at t, with the step h."""
    around = zip(path(t - h), path(t), path(t + h), strict=True)
    return [(a - 2 * b + c) / h**2 for a, b, c in around]


def five_points(path: Path, t: float, h: float) -> list[Scalar]:
    """The second difference of each coordinate over five points: an error of the order h**4."""
    around = zip(*(path(t + n * h) for n in (-2, -1, 0, 1, 2)), strict=True)
    return [(-a + 16 * b - 30 * c + 16 * d - e) / (12 * h**2) for a, b, c, d, e in around]
