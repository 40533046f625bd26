"""Six figures as those of chapter 4, for the tests of what sliders do: each a function that draws,
its sliders, and options of interactive_figure.
"""

from math import cos, hypot, radians, sin

from newton_euler import Frame, atan, moving, sqrt
from newton_euler.classroom import Slider
from newton_euler.drawing import Sketch
from newton_euler.kinematics.rotations import apply, axis_angle, euler_frame, rotation_matrix

GROUND = Frame("ground")
O = (0, 0, 0)
ANGLE = {"unit": "°"}


def cone(ax, r, gone):
    """A cone that rolls on a table, its tip at rest."""
    h, slant, gone = 0.4, hypot(0.4, r), radians(gone)
    carriage = GROUND.rotate("carriage", "z", angle=-gone, rate=-0.6 * slant / h**2)
    axle = carriage.rotate("axle", "-y", angle=atan(r / h))
    rolling = axle.rotate("cone", "x", rate=0.6 * slant**2 / h**2 / r)
    B, P = rolling.point("B", h, 0, 0), rolling.point("P", h, 0, r)
    s = Sketch(ax, GROUND, azimuth=-65, elevation=25)
    s.ground(axle.point("", h / 2, 0, -r / 2), GROUND.k, size=1.15 * hypot(h, r))
    s.cone(O, rolling.i, length=h, radius=r)
    s.axes(O, GROUND, length=0.75, labels="XYZ")
    s.vector(P, P.velocity(GROUND), "$v_P$", size="m/s")
    s.vector(B, B.velocity(GROUND), "$v_B$", size="m/s")
    s.vector(O, rolling.angular_velocity(GROUND), r"$\omega$", kind="rate")
    s.vector(O, rolling.angular_acceleration(GROUND), r"$\alpha$", kind="acceleration")
    for place, name in ((O, "O"), (B, "B"), (P, "P")):
        s.label(place, name)


def boom_of(tilt):
    """The boom of a crane and its tip."""
    column = GROUND.rotate("column", "z", rate=0.6, acceleration=0.2)
    hinge = column.point("B", 0, 0.5, 1.0)
    boom = column.rotate("boom", "x", angle=moving(radians(tilt), 0.4, -0.1), origin=hinge)
    return boom, boom.point("P", 0, moving(3.0, 0.8, 0.3), 0)


def crane(ax, tilt):
    """A crane that turns while its boom rises and its carriage runs out."""
    boom, P = boom_of(tilt)
    s = Sketch(ax, GROUND, azimuth=20, elevation=18)
    s.ground(O, GROUND.k, size=2.4)
    s.shaft(O, (0, 0, 1))
    s.rod((0, 0, 1), boom.origin)
    s.rod(boom.origin, P)
    s.hinge(boom.origin, GROUND.i)
    s.axes(O, GROUND, length=1.1, labels="XYZ")
    s.vector(P, P.velocity(GROUND), "$v_P$", size="m/s")
    s.vector(P, P.acceleration(GROUND), "$a_P$", kind="acceleration")
    s.turn((0, 0, 0.55), GROUND.k, r"$\omega$")
    s.label(boom.origin, "B")
    s.label(P, "P")


def disk(ax, phi, p):
    """A disk that spins on a spindle that turns about the vertical."""
    column = GROUND.rotate("column", "z", rate=1.2, acceleration=0.5)
    spindle = column.rotate("spindle", "x", angle=radians(phi))
    B = spindle.point("B", 0, 0.5, 0)
    turning = spindle.rotate("disk", "y", rate=p, acceleration=1.0, origin=B)
    A = turning.point("A", 0, 0, 0.2)
    s = Sketch(ax, GROUND, azimuth=35, elevation=15)
    s.ground((0, 0, -0.3), GROUND.k, size=0.35)
    s.shaft((0, 0, -0.3), (0, 0, 0.15))
    s.rod(O, B)
    s.disk(B, normal=turning.j, radius=0.2, spoke=A)
    s.axes(O, GROUND, length=0.42, labels="XYZ")
    s.turn((0, 0, -0.16), GROUND.k, r"$\omega$")
    s.turn(spindle.point("", 0, 0.32, 0), p * turning.j, "$p$")
    s.arc(O, (0, 0.5, 0), B, r"$\phi$") if phi else None
    s.vector(A, A.velocity(GROUND), "$v_A$", size="m/s")
    s.vector(A, A.acceleration(GROUND), "$a_A$", kind="acceleration")
    for place, name in ((O, "O"), (B, "B"), (A, "A")):
        s.label(place, name)


def euler(ax, psi, theta, phi):
    """Three turns, and the one that replaces them."""
    body = euler_frame(GROUND, "body", *map(radians, (psi, theta, phi)))
    axis, angle = axis_angle(body.rotation(GROUND))
    s = Sketch(ax, GROUND, azimuth=35, elevation=25)
    s.axes(O, GROUND, length=1.0, labels="XYZ")
    s.axes(O, body, length=1.0)
    for start in (GROUND.i, GROUND.j, GROUND.k):
        s.path([apply(rotation_matrix(axis, angle * n / 40), start) for n in range(41)])
    end = tuple(1.3 * x for x in axis)
    s.line(tuple(-x for x in end), end, style="centre")
    s.vector(O, GROUND.vector(*axis), kind="rate")
    s.turn(end, axis, r"$\theta$")
    ax.set_title(f"three turns are one by {angle * 57.3:.0f}°", fontsize=11)


def orders(axes, a, b):
    """Two turns in both orders."""
    a, b = radians(a), radians(b)
    x_first = [GROUND, GROUND.rotate("1", "x", a), GROUND.rotate("2", "y", b).rotate("3", "x", a)]
    y_first = [GROUND, GROUND.rotate("1", "y", b), GROUND.rotate("2", "x", a).rotate("3", "y", b)]
    for ax, frame in zip(axes.flat, x_first + y_first, strict=True):
        s = Sketch(ax, GROUND, azimuth=35, elevation=22)
        s.box(O, frame, (1.6, 0.9, 0.35))
        s.axes(O, frame, length=1.25)
        ax.set_title("turned", fontsize=10)


def ledger(ax, tilt):
    """The terms of the acceleration of the crane's carriage, head to tail."""
    boom, P = boom_of(tilt)
    s = Sketch(ax, GROUND, azimuth=20, elevation=18, arrows=160)
    s.rod(boom.origin, P)
    s.axes(boom.origin, boom, length=0.6)
    s.sum(P, P.acceleration(GROUND), "$a_P$", size="m/s²")


def curve(ax, a):
    """A plot that is no sketch."""
    t = [n / 50 for n in range(200)]
    ax.plot(t, [cos(a * x) * sqrt(4 - x) + sin(x) for x in t])
    ax.set(xlim=(0, 4), ylim=(-3, 3), xlabel="t in s", ylabel="x in m")


FIGURES = {
    "cone": (
        cone,
        [Slider("r", 0.3, 0.1, 0.6, 0.02, unit="m"), Slider("gone", 0, 0, 360, 5, **ANGLE)],
        {},
    ),
    "crane": (crane, [Slider("tilt", 30, -30, 85, 5, label="θ", **ANGLE)], {}),
    "disk": (
        disk,
        [Slider("phi", 30, 0, 90, 5, label="φ", **ANGLE), Slider("p", 4.0, -6, 6, 0.5)],
        {"size": (7, 4.8)},
    ),
    "euler": (
        euler,
        [
            Slider("psi", 40, -180, 180, 5, label="ψ", **ANGLE),
            Slider("theta", 60, 0, 180, 5, label="θ", **ANGLE),
            Slider("phi", 30, -180, 180, 5, label="φ", **ANGLE),
        ],
        {"size": (6.6, 4.8)},
    ),
    "orders": (
        orders,
        [Slider("a", 90, 0, 180, 5, **ANGLE), Slider("b", 90, 0, 180, 5, **ANGLE)],
        {"size": (8.4, 5.2), "panels": (2, 3), "title": lambda a, b: f"{a}° and {b}°"},
    ),
    "ledger": (ledger, [Slider("tilt", 30, -30, 85, 5, label="θ", **ANGLE)], {}),
}
