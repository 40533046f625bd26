"""The figures of chapter 2: motion in a plane, its components, and frames that turn."""

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from newton_euler import Frame, Point, cos, frenet, moving, sin
from newton_euler.algebra.scalars import Scalar, Triple
from newton_euler.algebra.vectors import named_sum
from newton_euler.classroom import Slider, interactive_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved
from newton_euler.kinematics.paths import along
from newton_euler.scenes.closed_forms.harmonic import rotated

from .curves import evenly, parts
from .sliding import with_sliders

O = (0, 0, 0)
Jet: TypeAlias = Callable[[Scalar, float, float, float], Triple]  # (t, speed, elevation, g)
Truck: TypeAlias = Callable[..., tuple[Frame, Frame, Point]]  # ground, turntable, car on it
FEET = math.radians(35), 25.0, 32.2  # the jet of sections 2.2 and 2.4


def wave(t: Scalar) -> Triple:
    return 1.2 * t, 0.8 * sin(1.6 * t), 0


def wave_path() -> list[Triple]:
    return [parts(wave(t)) for t in evenly(0, 4.1, 83)]


STRAIGHT, INNER, LANE = 84.39, 36.50, 1.22  # m, of a standard track
SPEEDS = 100 / 10.7, 100 / 9.8, 100 / 10.5, 100 / 12.03  # m/s, one for each hundred metres


def _bend(centre, radius, start, angle=math.pi):
    """Places on a bend about (centre, 0), from the direction ``start`` through ``angle``."""
    angles = evenly(start, start + angle, 41)
    return [(centre + radius * math.cos(u), radius * math.sin(u), 0) for u in angles]


def _oval(radius):
    """The outline of a lane with bends of this radius."""
    x = STRAIGHT / 2
    right, left = _bend(x, radius, -math.pi / 2), _bend(-x, radius, math.pi / 2)
    return [*right, *left, right[0]]


def _runner(ground, rho, first, run):
    """The runner after ``run`` metres, as a Point of ``ground``: two bends, two straights."""
    v = SPEEDS[min(int(run // 100), 3)]
    x = STRAIGHT / 2
    second = first + STRAIGHT
    if run < first or second < run < 400 - STRAIGHT:
        centre, angle = (x, math.pi / 2 - (first - run) / rho) if run < first else (
            -x, math.pi / 2 + (run - second) / rho)  # fmt: skip
        u = moving(angle, rate=v / rho)
        return ground.point("P", centre + rho * cos(u), rho * sin(u), 0), True
    back = run <= second
    place = x - (run - first) if back else x - (400 - run)
    return ground.point("P", moving(place, rate=-v if back else v), rho if back else -rho, 0), False


@with_sliders(
    Slider("run", 60, 0, 400, 10, label="run", unit="m"),
    alt="A running track from above with a runner P in the outermost lane. The position r leads to "
    "him from the middle of the field; the velocity v lies along the lane. In a bend the "
    "acceleration a points to the middle of the bend; on a straight it is zero.",
    size=(7.4, 4.6),
)
def lap(ax: AnyAxes, rho: float, first: float, run: float) -> None:
    """Figure 2.1: a runner in a lane with bends of the radius ``rho``, the first ``first`` m long."""
    ground = Frame("ground")
    P, in_bend = _runner(ground, rho, first, run)
    s = Sketch(ax, ground, plane="xy")
    s.path(_oval(INNER))
    s.path(_oval(INNER + 8 * LANE))
    s.path(_oval(rho), style="dotted")
    finish = STRAIGHT / 2
    s.line((finish, -INNER, 0), (finish, -INNER - 8 * LANE, 0), style="solid")
    s.label((finish, -INNER - 8 * LANE, 0), "finish", offset=(8, -8), bold=False)
    s.axes(O, ground, length=14, labels=["x", "y", ""])
    s.dot(P)
    s.arrow(O, P, r"$\mathbf{r}$")
    s.vector(P, P.velocity(ground), r"$\mathbf{v}$", size="m/s")
    if in_bend:
        s.vector(P, P.acceleration(ground), r"$\mathbf{a}$", kind="acceleration", size="m/s²")
    s.label(O, "O", offset=(-9, -9))
    s.label(P, "P")


@with_sliders(
    Slider("dt", 0.8, 0.05, 1.0, 0.05, label="Δt", unit="s"),
    alt="Left: two positions on the wave and the displacement between them; as the time shrinks "
    "it turns into the dotted tangent. Right: the two velocities drawn from one point and their "
    "difference, which tends to the dotted direction of the acceleration, straight down.",
    size=(8.6, 4),
    panels=(1, 2),
)
def two_limits(axes: Sequence[AnyAxes], dt: float) -> None:
    """Figure 2.2: displacement and change of velocity in a time that shrinks."""
    ground = Frame("ground")
    t = 0.7
    now, then = (ground.point("", *along(wave, time)) for time in (t, t + dt))
    P, Q = (parts(X.position(ground)) for X in (now, then))
    v, w = (parts(X.velocity(ground)) for X in (now, then))
    left, right = (Sketch(ax, ground, plane="xy") for ax in axes)
    left.path(wave_path()[:44])
    left.arrow(O, P, r"$\mathbf{r}(t)$")
    left.arrow(O, Q, r"$\mathbf{r}(t+\Delta t)$")
    left.arrow(P, Q, r"$\Delta\mathbf{r}$", kind="velocity")
    left.line(moved(P, -0.3, v), moved(P, 0.8, v), style="dotted")
    left.label(O, "O")
    start = (0.6, 0.3, 0)
    tip, later = moved(start, 1, v), moved(start, 1, w)
    right.arrow(start, tip, r"$\mathbf{v}(t)$", kind="velocity")
    right.arrow(start, later, r"$\mathbf{v}(t+\Delta t)$", kind="velocity")
    right.arrow(tip, later, r"$\Delta\mathbf{v}$", kind="acceleration")
    right.line(tip, moved(tip, 0.6, parts(now.acceleration(ground))), style="dotted")
    axes[0].set_title("positions", fontsize=11)
    axes[1].set_title("velocities", fontsize=11)


def flight(jet: Jet, elevation: float) -> tuple[float, list[Triple]]:
    """Time of flight and the places of the jet from ``jet(t, speed, elevation, g)``."""
    _, speed, g = FEET
    time = 2 * speed * math.sin(elevation) / g
    return time, [parts(jet(t, speed, elevation, g)) for t in evenly(0, time, 41)]


@with_sliders(
    Slider("elevation", 35, 10, 80, 5, label="γ₀", unit="°"),
    Slider("percent", 25, 0, 100, 5, label="of the flight", unit="%"),
    alt="A jet of water leaves a nozzle at the ground, up to the right at the angle gamma_0, and "
    "comes down on a parabola. The velocity of a particle is tangent to it; the acceleration "
    "has the same length and points straight down at every place.",
    size=(7.4, 4.4),
)
def jet(ax: AnyAxes, build: Jet, elevation: float, percent: float) -> None:
    """Figure 2.3: the jet, from ``build(t, speed, elevation, g)``, its path."""
    _, speed, g = FEET
    ground, up = Frame("ground"), math.radians(elevation)
    time, places = flight(build, up)
    t = time * percent / 100
    P = ground.point("P", *along(lambda t: build(t, speed, up, g), t))
    s = Sketch(ax, ground, plane="xy")
    s.road([(-1.5, 0, 0), (21, 0, 0)])
    s.axes(O, ground, length=3, labels=["x", "y", ""])
    s.rod((-1.4 * math.cos(up), -1.4 * math.sin(up), 0), O)
    s.path(places)
    s.dot(P)
    s.vector(P, P.velocity(ground), r"$\mathbf{v}$", size="ft/s")
    s.vector(P, P.acceleration(ground), r"$\mathbf{a}$", kind="acceleration", size="ft/s²")
    s.arc(O, (1, 0, 0), (math.cos(up), math.sin(up), 0), r"$\gamma_0$", radius=2)
    ax.set_title(f"range {places[-1][0]:.2f} ft, flight {time:.2f} s", fontsize=11)


@with_sliders(
    Slider("turn", 35, -45, 45, 2, label="Δγ", unit="°"),
    alt="The unit tangent e_t at the angle gamma from i, and again after a turn by Delta gamma. "
    "Its change points along the unit normal e_n, to the left for a turn to the left and to the "
    "right for a turn to the right, and is nearly as long as the angle.",
    size=(5.6, 4.6),
)
def turning_tangent(ax: AnyAxes, turn: float) -> None:
    """Figure 2.4: the unit tangent before and after a small turn, to the left or the right."""
    ground = Frame("ground")
    gamma, angle = math.radians(25), math.radians(turn)
    e_t, after = ((math.cos(x), math.sin(x), 0) for x in (gamma, gamma + angle))
    side = math.copysign(1.0, angle)
    e_n = (-side * e_t[1], side * e_t[0], 0)
    s = Sketch(ax, ground, plane="xy")
    s.line(O, (1.1, 0, 0), style="solid")
    s.label((1.1, 0, 0), r"$\hat\imath$", offset=(-4, -13), bold=False)
    s.arrow(O, e_t, r"$\hat{e}_t$")
    s.arrow(O, after, r"$\hat{e}_t$ later")
    s.arrow(O, e_n, r"$\hat{e}_n$")
    s.arrow(e_t, after, r"$\Delta\hat{e}_t$", kind="velocity")
    s.arc(O, (1, 0, 0), e_t, r"$\gamma$", radius=0.35)
    s.arc(O, e_t, after, r"$\Delta\gamma$", radius=0.6)
    length = 2 * math.sin(abs(angle) / 2)
    ax.set_title(rf"$|\Delta\hat{{e}}_t|$ = {length:.3f}, |Δγ| = {abs(angle):.3f}", fontsize=11)


@with_sliders(
    Slider("percent", 30, 0, 100, 5, label="of the flight", unit="%"),
    alt="The parabola of the jet with a particle on it. A dashed arc of the circle of curvature "
    "follows the jet closely near the particle; its centre lies below. The circle is smallest "
    "when the particle is at the top. Tangential and normal acceleration are drawn.",
    size=(6.4, 6),
)
def curvature_of_the_jet(ax: AnyAxes, build: Jet, percent: float) -> None:
    """Figure 2.5: the jet and its circle of curvature, from ``build(t, speed, elevation, g)``."""
    up, speed, g = FEET
    ground = Frame("ground")
    time, places = flight(build, up)
    P = ground.point("P", *along(lambda t: build(t, speed, up, g), time * percent / 100))
    here = frenet(P.velocity(ground), P.acceleration(ground))
    place, out = parts(P.position(ground)), parts(here.to_center.components(ground))
    centre = moved(place, 1, out)
    s = Sketch(ax, ground, plane="xy", arrows=90)
    s.path(places)
    start = moved(centre, 1, (*rotated(out[0], out[1], math.pi + 0.5), 0))
    s.path(s.around(centre, start, (0, 0, -1), 1.0), style="dashed")
    s.line(place, centre)
    s.dot(centre)
    s.dot(P)
    s.sum(P, here.acceleration, r"$\mathbf{a}$", size="ft/s²")
    s.label(centre, "centre", bold=False)
    ax.set_title(f"ρ = {here.radius:.2f} ft, v = {here.speed:.2f} ft/s", fontsize=11)


@with_sliders(
    Slider("v", 18, 6, 30, 0.5, unit="m/s"),
    alt="A car on a circular road seen from above. Its acceleration of 2 m/s² along the road and "
    "the normal acceleration towards the centre, which grows with the square of the speed, make "
    "the total acceleration, obliquely forward and inward.",
    size=(6.8, 4.8),
)
def car_in_a_curve(ax: AnyAxes, v: float) -> None:
    """Figure 2.6: a car in a curve and the two components of its acceleration."""
    rho, rate = 250.0, 2.0
    ground = Frame("ground")
    car = ground.rotate("car", "z", 0.2)  # its y axis points forward
    here = (rho * math.cos(0.2), rho * math.sin(0.2), 0)
    inward = frenet(car.j * v, car.j * rate - car.i * (v**2 / rho)).acceleration
    s = Sketch(ax, ground, plane="xy", arrows=240)
    for r in (rho - 12, rho + 12):
        s.path(_bend(0, r, -0.1, 0.6))
    inner = tuple(0.75 * x for x in here)
    s.line(inner, here)
    s.label(inner, "to the centre", bold=False)
    s.box(here, car, (8, 16, 1))
    s.sum(here, inward, r"$\mathbf{a}$", size="m/s²")
    ax.set_title(f"v = {v:.1f} m/s = {3.6 * v:.0f} km/h", fontsize=11)


@with_sliders(
    Slider("t", 1.2, 0.3, 1.9, 0.1, unit="s"),
    Slider("turn", 30, 2, 45, 1, label="Δθ", unit="°"),
    alt="Left: a point of the wave at the distance r and the angle theta, with the unit vectors "
    "e_r away from O and e_theta at right angles; the parts of the velocity along them add up "
    "to v. Right: e_r turned by Delta theta changes along e_theta, e_theta against e_r.",
    size=(8.8, 4.2),
    panels=(1, 2),
)
def polar_axes(axes: Sequence[AnyAxes], t: float, turn: float) -> None:
    """Figure 2.7: polar components of a velocity; the turning of their unit vectors."""
    ground = Frame("ground")
    P = ground.point("P", *along(wave, t))
    place = parts(P.position(ground))
    theta = math.atan2(place[1], place[0])
    _velocity_in_polar_axes(Sketch(axes[0], ground, plane="xy"), ground, P, theta)
    _turning_pair(Sketch(axes[1], ground, plane="xy"), theta, math.radians(turn))
    axes[0].set_title("the velocity and its two parts", fontsize=11)
    axes[1].set_title("the unit vectors turn by Δθ", fontsize=11)


def _velocity_in_polar_axes(s, ground, P, theta):
    place, local = parts(P.position(ground)), ground.rotate("polar", "z", theta)
    v_r, v_theta, _ = parts(P.velocity(ground).components(local))
    s.path(wave_path()[:50])
    s.line(O, (1.0, 0, 0), style="solid")
    s.arrow(O, place, r"$r\,\hat{e}_r$")
    s.arc(O, (1, 0, 0), place, r"$\theta$", radius=0.4)
    s.dot(P)
    s.vector(P, local.i * v_r, r"$\dot r\,\hat{e}_r$")
    s.vector(P, local.j * v_theta, r"$r\dot\theta\,\hat{e}_\theta$")
    s.vector(P, P.velocity(ground), r"$\mathbf{v}$", kind="rate")
    s.label(O, "O")


def _turning_pair(s, theta, turn):
    centre = (1.7, -0.6, 0)
    for start, name, change in (
        (theta, r"\hat{e}_r", r"\Delta\theta\,\hat{e}_\theta"),
        (theta + math.pi / 2, r"\hat{e}_\theta", r"-\Delta\theta\,\hat{e}_r"),
    ):
        now, later = (
            moved(centre, 1.3, (math.cos(x), math.sin(x), 0)) for x in (start, start + turn)
        )
        s.arrow(centre, now, rf"${name}$")
        s.arrow(centre, later, rf"${name}$ later")
        s.arrow(now, later, rf"$\approx{change}$", kind="velocity")


BOOM = (
    Slider("length_rate", 0.5, -1, 1, 0.1, label="extends at", unit="ft/s"),
    Slider("rate", -0.075, -0.1, 0.1, 0.025, label="raised at", unit="rad/s"),
)


def _boom_in_words(length_rate, rate):
    out, up, turned = (round(x, 6) for x in (length_rate, rate, length_rate * rate))
    v = {"outward": out > 0, "inward": out < 0, "up": up > 0, "down": up < 0}
    a = {"back along the boom": up != 0, "up": turned > 0, "down": turned < 0}
    velocity, acceleration = (
        f"points {' and '.join(ways)}" if ways else "is zero"
        for ways in ([way for way, holds in found.items() if holds] for found in (v, a))
    )
    return (
        "A telescoping boom leans up to the right from its pivot O on a parked truck. The velocity "
        f"of its end P {velocity}; the acceleration {acceleration}."
    )


@with_sliders(*BOOM, alt=_boom_in_words, size=(7.4, 4.8))
def boom(
    ax: AnyAxes, build: Callable[[Frame, float, float], Point], length_rate: float, rate: float
) -> None:
    """Figure 2.8: the boom, from ``build(ground, length_rate, rate)``, its end P."""
    ground = Frame("ground")
    P = build(ground, length_rate, rate)
    s = Sketch(ax, ground, plane="xy", arrows=100)
    s.road([(-9, -6, 0), (24, -6, 0)])
    s.box((-1.5, -2.6, 0), ground, (11, 3.6, 1))
    for x in (-5, 2):
        s.disk((x, -5, 0), ground.k, 1.0)
    joint = tuple(0.6 * x for x in parts(P.position(ground)))
    s.shaft(O, joint)
    s.rod(joint, P)
    s.hinge(O)
    s.label(O, "O")
    s.label(P, "P")
    s.vector(P, P.velocity(ground), r"$\mathbf{v}_P$", size="ft/s")
    s.vector(P, P.acceleration(ground), r"$\mathbf{a}_P$", kind="acceleration", size="ft/s²")
    s.arc(O, (1, 0, 0), P, r"$\theta$", radius=4)


@with_sliders(
    *BOOM,
    alt="The outer part of the boom with the terms of the acceleration of its end laid head to "
    "tail: Coriolis across the boom and centripetal along it towards the pivot; the others are "
    "zero. The sum closes the chain.",
    size=(7.4, 4.8),
)
def boom_terms(ax: AnyAxes, length_rate: float, rate: float) -> None:
    """Figure 2.13: the terms of the acceleration of the end of the boom."""
    ground = Frame("ground")
    frame = ground.rotate("boom", "z", angle=math.radians(30), rate=rate)
    P = frame.point("P", moving(20.0, rate=length_rate), 0, 0)
    s = Sketch(ax, ground, plane="xy", arrows=170)
    inner, joint = frame.point("", 16, 0, 0), frame.point("", 17.5, 0, 0)
    s.shaft(inner, joint)
    s.rod(joint, P)
    s.axes(inner, frame, length=1, labels=[r"$\hat\imath$", r"$\hat\jmath$", ""])
    terms = P.acceleration(ground).terms
    two = {name: terms[name] for name in ("coriolis", "centripetal")}  # the others are zero
    s.sum(P, named_sum("acceleration", "P", two, frame), r"$\mathbf{a}_P$")


@with_sliders(
    Slider("first", 50, 0, 90, 5, label="arm 1", unit="°"),
    Slider("second", 40, -60, 90, 5, label="arm 2", unit="°"),
    alt="Two arms, the second hinged to the end of the first, before and after both have been "
    "turned. In the left picture the first arm was turned first, in the right one the second. "
    "The final positions are the same.",
    size=(8.6, 4.4),
    panels=(1, 2),
)
def two_turns(axes: Sequence[AnyAxes], first: float, second: float) -> None:
    """Figure 2.9: two turns in the plane, made in both orders."""
    a, b = math.radians(first), math.radians(second)
    for ax, middle in zip(axes, ((a, 0.0), (0.0, b)), strict=True):
        ground = Frame("ground")
        s = Sketch(ax, ground, plane="xy")
        s.line((-0.2, 0, 0), (1.9, 0, 0))
        for angles, made in ((middle, s.line), ((a, b), s.rod)):
            one = ground.rotate("1", "z", angles[0])
            end = one.point("", 1.0, 0, 0)
            two = one.rotate("2", "z", angles[1], origin=end)
            made(O, end)
            made(end, two.point("", 0.8, 0, 0))
            s.hinge(end)
        s.hinge(O)
    axes[0].set_title("arm 1 first (dashed: in between)", fontsize=11)
    axes[1].set_title("arm 2 first (dashed: in between)", fontsize=11)


def ferris_wheel() -> Animation:
    """A film: a wheel with a cabin that stays level, and one that is bolted to it."""

    def draw(t, ax):
        ground = Frame("ground")
        wheel = ground.rotate("wheel", "z", 0.1 * t)
        rim, bolted = wheel.point("", 20, 0, 0), wheel.point("", -20, 0, 0)
        cabin = wheel.rotate("cabin", "z", -0.1 * t, origin=rim)
        s = Sketch(ax, ground, plane="xy")
        s.ring(O, ground.k, 20)
        for n in range(6):
            angle = n * math.pi / 3
            s.line(O, wheel.point("", 20 * math.cos(angle), 20 * math.sin(angle), 0), "solid")
        s.box(cabin.point("", 0, -3, 0), cabin, (9, 5, 1))
        s.box(wheel.point("", -20, -3, 0), wheel, (9, 5, 1))
        for P in (O, rim, bolted):
            s.hinge(P)
        s.label(cabin.point("", 0, -3, 0), "level", offset=(0, 0), bold=False)
        s.label(wheel.point("", -20, -3, 0), "bolted", offset=(0, 0), bold=False)

    return animate(
        draw,
        evenly(0, 20 * math.pi, 25),
        size=(4.6, 4.6),
        alt="A Ferris wheel turns once; one cabin stays level all the way round, the other is bolted "
        "to the wheel and turns over with it.",
    )


@with_sliders(
    Slider("direction", 30, 0, 90, 5, label="Q from î", unit="°"),
    Slider("turn", 35, 2, 50, 1, label="Δθ", unit="°"),
    alt="Fixed axes I, J and the axes i, j of a frame that has turned by Delta theta, with a "
    "vector Q that is fixed in it, before and after. Its change Delta Q is a chord, nearly the "
    "same as the arrow Delta theta k cross Q along the tangent.",
    size=(6, 4.8),
)
def seen_from_two_frames(ax: AnyAxes, direction: float, turn: float) -> None:
    """Figure 2.10: a vector fixed in a turning frame."""
    ground = Frame("ground")
    angle = math.radians(turn)
    before, after = (ground.rotate("", "z", 0.3 + x) for x in (0.0, angle))
    c, d = math.cos(math.radians(direction)), math.sin(math.radians(direction))
    Q, later = (parts(f.vector(c, d, 0).components(ground)) for f in (before, after))
    s = Sketch(ax, ground, plane="xy")
    s.axes(O, ground, length=0.7, labels=[r"$\hat I$", r"$\hat J$", ""])
    s.axes(O, after, length=0.7, labels=[r"$\hat\imath$", r"$\hat\jmath$", ""])
    s.arrow(O, Q, r"$\mathbf{Q}$")
    s.arrow(O, later, r"$\mathbf{Q}$ later")
    s.arrow(Q, later, r"$\Delta\mathbf{Q}$", kind="velocity")
    tip = Q[0] - angle * Q[1], Q[1] + angle * Q[0], 0
    s.arrow(Q, tip, kind="rate")
    s.label(tip, r"$\Delta\theta\,\hat k\times$Q")


@with_sliders(
    Slider("angle", 35, 0, 180, 5, label="table turned", unit="°"),
    Slider("out", 1.2, -1.2, 1.4, 0.1, label="car on track", unit="m"),
    alt="A truck seen from above carries a turntable with the centre B; a car A runs on a "
    "straight track of the turntable. Vectors r_B, r and r_A form a triangle. The relative "
    "velocity lies along the track; the velocity of the place under A points elsewhere.",
    size=(7.4, 4.8),
)
def relative_position(ax: AnyAxes, build: Truck, angle: float, out: float) -> None:
    """Figure 2.11: the truck with its turntable, from ``build(angle=…, out=…)``."""
    ground, table, A = build(angle=math.radians(angle), out=out)
    B = table.origin
    s = Sketch(ax, ground, plane="xy", arrows=120)
    _truck_and_table(s, ground, table)
    s.axes(O, ground, length=0.7, labels="XY ")
    s.axes(B, table, length=0.7, labels="xy ")
    s.arrow(O, B, r"$\mathbf{r}_B$")
    s.arrow(B, A, r"$\mathbf{r}$")
    s.arrow(O, A, r"$\mathbf{r}_A$")
    terms = A.velocity(ground).terms
    s.vector(A, terms["relative"], r"$\mathbf{v}_r$", size="m/s")
    s.vector(A, terms["origin"] + terms["rotation"], r"$\mathbf{v}_B+\omega\times\mathbf{r}$")
    for point, name in ((O, "O"), (B, "B"), (A, "A")):
        s.label(point, name)


@with_sliders(
    Slider("rate", 1.0, -1.2, 1.2, 0.1, label="ω", unit="rad/s"),
    Slider("out_rate", 0.8, -1, 1, 0.1, label="along the track", unit="m/s"),
    alt="The five terms of the acceleration of the car as arrows laid head to tail from A, each "
    "with its name, and the sum as the broad arrow that closes the chain.",
    size=(7.4, 5.2),
)
def five_terms(ax: AnyAxes, build: Truck, rate: float, out_rate: float) -> None:
    """Figure 2.12: the terms of the acceleration of the car, head to tail."""
    ground, table, A = build(rate=rate, out_rate=out_rate)
    s = Sketch(ax, ground, plane="xy", arrows=190)
    _truck_and_table(s, ground, table)
    s.axes(table.origin, table, length=0.7, labels="xy ")
    s.label(table.origin, "B")
    s.dot(A, "A")
    s.sum(A, A.acceleration(ground), r"$\mathbf{a}_A$", size="m/s²")


def _truck_and_table(s, ground, table):
    B = table.origin
    place = parts(B.position(ground))
    s.box((place[0], place[1], -0.5), ground, (4.4, 3.4, 0.2))
    s.box((place[0] + 2.85, place[1], -0.5), ground, (1.1, 2.8, 0.2))  # its cab, in front
    s.disk(B, ground.k, 1.55)
    s.line(table.point("", -1.45, 0.5, 0), table.point("", 1.45, 0.5, 0), style="solid")


def two_cars(build: Callable[[float], tuple[Frame, Frame, Point]]) -> None:
    """Figure 2.14: both cars from the ground and from car B, from ``build(t)``."""
    road, curve, seen = [], [], []
    for t in evenly(-1.5, 1.5, 31):
        ground, B, A = build(t)
        road.append(parts(A.position(ground)))
        curve.append(parts(B.origin.position(ground)))
        seen.append(parts(A.position(B)))

    def draw(axes, t):
        ground, B, A = build(t)
        left = Sketch(axes[0], ground, plane="xy")
        left.path(road, style="dashed")
        left.path(curve, style="dashed")
        _car(left, A, ground, "A")
        _car(left, B.origin, B, "B", along_y=True)
        left.vector(A, A.velocity(ground), r"$\mathbf{v}_A$", size="m/s")
        left.vector(B.origin, B.origin.velocity(ground), r"$\mathbf{v}_B$", size="m/s")
        _seen_by_B(axes[1], seen, B, A)
        axes[0].set_title("seen from the ground", fontsize=11)
        axes[1].set_title("seen from car B", fontsize=11)

    interactive_figure(
        draw,
        Slider("t", 0.0, -1.5, 1.5, 0.1, unit="s"),
        alt="Left: car A drives to the right on a straight road, car B upward through a curve to its "
        "left. Right: the same motion seen from car B, which rests; car A comes from the left and "
        "falls back on a curved path. The velocity that B sees points to the right and backwards.",
        size=(9, 4.6),
        panels=(1, 2),
    )


def _car(s, P, frame, name, along_y=False):
    s.box(P, frame, (4, 9, 1) if along_y else (9, 4, 1))
    s.label(P, name, offset=(9, -13))


def _seen_by_B(ax, seen, B, A):
    own = Frame("axes of B")  # at rest in this picture
    place = parts(A.position(B))
    sine, cosine = (float(x) for x in B.rotation(B.parent)[1][:2])
    s = Sketch(ax, own, plane="xy")
    s.path(seen, style="dashed")
    s.box(O, own, (4, 9, 1))
    s.box(place, own.rotate("A", "z", -math.atan2(sine, cosine)), (9, 4, 1))
    s.vector(place, parts(A.velocity(B).components(B)), r"$\mathbf{v}_r$", size="m/s")
    s.label(O, "B", offset=(9, -13))
    s.label(place, "A", offset=(9, -13))
