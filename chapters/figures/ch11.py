"""The figures of chapter 11: work as an area, energies as bars beside what moves."""

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import accumulate, pairwise

from newton_euler import Frame, integrate, prepare, sin, work_along
from newton_euler.algebra.late import np, plt
from newton_euler.algebra.ledger import Amount
from newton_euler.classroom import Slider, interactive_figure, show_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved, on_circle, on_plane
from newton_euler.dynamics.energy import gyroscope_energy
from newton_euler.dynamics.work import Field
from newton_euler.kinematics.paths import Path
from newton_euler.scenes.planar.pendulum import physical_pendulum
from newton_euler.scenes.spatial.top import euler

from .colours import BLUE, GREEN, GREY, ORANGE
from .curves import evenly
from .sliding import with_sliders

O = (0, 0, 0)
G_SI = 9.81
COLOURS = BLUE, ORANGE, GREEN, GREY
HATCHES = "", "//", "..", ""
STYLES = "-", "--", ":", "-."


def bars(
    ax: AnyAxes, energies: Mapping[str, float], low: float, high: float, unit: str = "J"
) -> None:
    """Draw energies by name as bars, with their values; ``low`` to ``high`` is the scale."""
    for n, x in enumerate(energies.values()):
        ax.bar(n, x, 0.6, color=COLOURS[n], hatch=HATCHES[n], edgecolor="white")
        up = x >= 0
        ax.annotate(
            f"{x:.2f}".replace("-", "\N{MINUS SIGN}"),
            (n, x), (0, 3 if up else -3), textcoords="offset points", ha="center",
            va="bottom" if up else "top",
        )  # fmt: skip
    ax.set_xticks(range(len(energies)), energies)
    ax.set_ylim(low, high)
    ax.axhline(0, color="black", lw=0.8)
    _name_scale(ax, unit)


def _name_scale(ax, name):
    """Write the name above the scale: labels of the panel on the left may come near its side."""
    ax.set_title(name, loc="left", fontsize=10)


# -- work


def tug(pull: Field, track: Path, winch: tuple[float, float]) -> None:
    """Figure 11.1: a sledge pulled towards a winch, and the work as an area."""
    ground, q = Frame("ground"), evenly(0, 8, 241)
    places = [ground.vector(*track(x)) for x in q]
    s = [*accumulate((float((b - a).norm()) for a, b in pairwise(places)), initial=0.0)]
    around = [(ground.vector(*track(x - 1e-3)), ground.vector(*track(x + 1e-3))) for x in q]
    tangents = [(after - before).direction() for before, after in around]
    forces = [ground.vector(*pull(*place)) for place in places]
    F_t = [F.dot(e) for F, e in zip(forces, tangents, strict=True)]

    def draw(axes, distance):
        n = round(30 * distance)
        A = places[n]
        sketch = Sketch(axes[0], ground, plane="xy")
        sketch.path(places)
        sketch.line(A, (*winch, 0))
        sketch.hinge((*winch, 0))
        sketch.vector(A, forces[n], r"$\mathbf{F}$", kind="force", size="N")
        sketch.vector(A, tangents[n], r"$d\mathbf{r}$")
        for place, name in (((*winch, 0), "W"), (A, "A")):
            sketch.label(place, name)
        _area(axes[1], s, F_t, n)
        U = work_along(pull, track, 0.0, distance).value if distance else 0.0
        axes[1].set_title(f"work so far: {U:.1f} J", fontsize=11)

    interactive_figure(
        draw,
        Slider("distance", 4, 0, 8, 0.25, label="x of the sledge", unit="m"),
        alt="Left: a sledge A on a curved track, pulled by a rope towards the winch W; the force F "
        "points to W and dr along the track. Right: the component of F along the track against "
        "the distance covered, with the area so far filled; beyond the winch it is negative.",
        size=(9, 3.8),
        panels=(1, 2),
    )


def _area(ax, s, F_t, n):
    """Plot F_t against s, filled as far as the place number n."""
    ax.plot(s, F_t, color="black")
    part, force = s[: n + 1], F_t[: n + 1]
    for sign, colour, hatch in ((1, BLUE, ""), (-1, ORANGE, "//")):
        where = [sign * F >= 0 for F in force]
        ax.fill_between(part, force, where=where, color=colour, alpha=0.4, hatch=hatch, lw=0)
    ax.axhline(0, color="black", lw=0.8)
    ax.set(xlabel="s (m)", xlim=(s[0], s[-1]), ylim=(-60, 60))
    _name_scale(ax, "$F_t$ (N)")


@with_sliders(
    Slider("angle", 60, 0, 180, 10, label="angle from r to F", unit="°"),
    alt="A plate turns at omega. A force F acts at its point D and the opposite force at C; r "
    "leads from C to D, and D moves relative to C with the velocity omega cross r, at right "
    "angles to r.",
    size=(6.4, 4.2),
)
def couple(ax: AnyAxes, angle: float) -> None:
    """Figure 11.2: the two forces of a couple, and the velocities of the points they act on."""
    ground = Frame("ground")
    C = ground.point("C", 0.2, 0, 0)
    body = ground.rotate("body", "z", angle=math.radians(25), rate=1.0, origin=C)
    D = body.point("D", 1.0, 0, 0)
    force = math.cos(math.radians(angle)) * body.i + math.sin(math.radians(angle)) * body.j
    sketch = Sketch(ax, ground, plane="xy")
    corners = ((-0.25, -0.3), (1.25, -0.3), (1.25, 0.3), (-0.25, 0.3))
    sketch.plate([body.point("", x, y, 0) for x, y in corners], shade="light")
    sketch.arrow(C, D, r"$\mathbf{r}$")
    sketch.vector(D, force, r"$\mathbf{F}$", kind="force")
    sketch.vector(C, -1.0 * force, r"$-\mathbf{F}$", kind="force")
    sketch.vector(D, 0.6 * body.j, r"$\omega\times\mathbf{r}$")
    sketch.turn(C, ground.k, r"$\omega$", radius=0.16)
    for place, name in ((C, "C"), (D, "D")):
        sketch.label(place, name)
    moment = math.sin(math.radians(angle))
    ax.set_title(f"moment and power: {moment:.2f} of the greatest possible", fontsize=11)


# -- a particle


@with_sliders(
    Slider("way", 30, 0, 100, 2, label="way from A to C", unit="%"),
    alt="Left: a ball on a cord from the nail O swings down from A; at the bottom the cord "
    "catches the pin B, and the ball rises on a smaller circle to C, level with B. Right: bars of "
    "the kinetic energy, the potential energy and their sum, which does not change.",
    size=(8.6, 4.2),
    panels=(1, 2),
)
def pendulum_with_pin(
    axes: Sequence[AnyAxes],
    speed: Callable[[float], float],
    cord: float,
    pin: float,
    angle: float,
    way: float,
) -> None:
    """Figure 11.3: the ball on its two arcs; ``speed`` is a function of the depth."""
    rest = cord - pin
    first = cord * angle / (cord * angle + rest * math.pi / 2)

    def place(way):
        """The place at this share of the way, and the direction of motion."""
        if way < first:
            a = angle * (1 - way / first)
            return (-cord * math.sin(a), -cord * math.cos(a), 0), (math.cos(a), -math.sin(a), 0)
        b = math.pi / 2 * (way - first) / (1 - first)
        return (rest * math.sin(b), -pin - rest * math.cos(b), 0), (math.cos(b), math.sin(b), 0)

    ball, direction = place(way / 100)
    v, B = speed(-ball[1]), (0, -pin, 0)
    sketch = Sketch(axes[0], Frame("ground"), plane="xy")
    sketch.path([place(x)[0] for x in evenly(0, 1, 61)], style="dotted")
    for start, end in [(O, ball)] if way / 100 < first else [(O, B), (B, ball)]:
        sketch.line(start, end, "solid")
    for nail in (O, B):
        sketch.hinge(nail)
    sketch.sphere(ball, 0.03)
    sketch.vector(ball, tuple(v * c for c in direction), r"$\mathbf{v}$")
    axes[0].set_title(f"speed {v:.2f} m/s", fontsize=11)
    for P, name in ((O, "O"), (place(0)[0], "A"), (B, "B"), (place(1)[0], "C")):
        sketch.label(P, name)
    T, V = v * v / 2, G_SI * ball[1]
    bars(axes[1], {"T": T, "V": V, "T + V": T + V}, -11, 9, "J/kg")


@with_sliders(
    Slider("bulge", 0.6, -1, 1, 0.1, label="bulge of the path", unit="m"),
    alt="Left: a path from A to B that bulges up or down in a field of arrows that go round "
    "the origin. Right: two bars. The work of the weight is the same for every bulge; that of "
    "the swirling force changes with it, even its sign.",
    size=(9, 3.9),
    panels=(1, 2),
)
def two_works(axes: Sequence[AnyAxes], forces: Mapping[str, Field], bulge: float) -> None:
    """Figure 11.4: the work of each of two forces on paths from A to B that bulge differently."""
    grid = evenly(-4 / 3, 10 / 3, 15)
    works = {
        name: work_along(F, lambda q: _bulging(q, bulge), 0.0, 1.0).value
        for name, F in forces.items()
    }
    ax = axes[0]
    around = list(forces.values())[1]
    swirl = [(x, y, *around(x, y, 0)[:2]) for x in grid for y in grid]
    ax.quiver(*zip(*swirl, strict=True), color=ORANGE, width=0.007, scale=300, pivot="mid")
    places = [_bulging(q, bulge)[:2] for q in evenly(0, 1, 61)]
    ax.plot(*zip(*places, strict=True), color="black", lw=2)
    for name, (x, y) in {"A": (0, 0), "B": (2, 1)}.items():
        ax.plot(x, y, "ko")
        ax.annotate(name, (x, y), (6, -12), textcoords="offset points", weight="bold")
    ax.set(xlim=(-0.7, 2.7), ylim=(-1.2, 2.2), aspect="equal", xlabel="x (m)", ylabel="y (m)")
    bars(axes[1], works, -32, 32)
    axes[1].set_title("work from A to B", fontsize=11)


def _bulging(q, bulge):
    return 2 * q, q + bulge * sin(math.pi * q), 0


@with_sliders(
    Slider("round_", 60, 0, 360, 5, label="angle from the nearest point", unit="°"),
    alt="Left: a satellite on an ellipse about the Earth, with its velocity and the force "
    "towards the Earth. Right: bars of its kinetic energy, its negative potential energy and "
    "their sum, which stays the same all the way round.",
    size=(9, 4),
    panels=(1, 2),
)
def satellite(
    axes: Sequence[AnyAxes],
    speed: Callable[[float], float],
    mu: float,
    nearest: float,
    farthest: float,
    round_: float,
) -> None:
    """Figure 11.5: a satellite on an ellipse and its energies; ``speed`` of the distance, SI."""
    e = (farthest - nearest) / (farthest + nearest)

    def at(degrees):
        f = math.radians(degrees)
        r = nearest * (1 + e) / (1 + e * math.cos(f))
        place = (1e-6 * r * math.cos(f), 1e-6 * r * math.sin(f), 0)
        return r, place, (-math.sin(f), e + math.cos(f))

    r, P, direction = at(round_)
    v = speed(r)
    sketch = Sketch(axes[0], Frame("space"), plane="xy")
    sketch.path([at(angle)[1] for angle in evenly(0, 360, 121)], style="dotted")
    sketch.sphere(O, 6.4)
    sketch.line(O, P)
    sketch.dot(P)
    size = math.hypot(*direction)
    velocity = tuple(1e-3 * v * c / size for c in (*direction, 0))
    sketch.vector(P, velocity, r"$\mathbf{v}$", size="km/s")
    sketch.vector(P, tuple(-c / r**3 for c in P), r"$\mathbf{F}$", kind="force")
    T, V = 1e-6 * v * v / 2, -1e-6 * mu / r
    bars(axes[1], {"T": T, "V": V, "T + V": T + V}, -70, 60, "MJ/kg")


def _incline(slope):
    """The unit vectors down an incline, and at right angles to it, up."""
    return (math.cos(slope), -math.sin(slope), 0), (math.sin(slope), math.cos(slope), 0)


def sliding_block(m: float, slope: float, mu: float, length: float) -> None:
    """Figure 11.6: a block that slides down against friction, and where the energy goes."""
    down, normal = _incline(slope)
    a = G_SI * (math.sin(slope) - mu * math.cos(slope))
    top = m * G_SI * length * math.sin(slope)

    def draw(axes, s):
        ground, G = Frame("ground"), on_plane(O, s, down, 0.2, normal)
        sketch = Sketch(axes[0], ground, plane="xy")
        sketch.road([moved(O, -0.4, down), moved(O, length + 0.4, down)])
        sketch.box(G, ground.rotate("slope", "-z", slope), (0.6, 0.4, 0.4))
        weight = m * G_SI
        friction = mu * weight * math.cos(slope)
        sketch.vector(G, (0, -weight, 0), r"$m\mathbf{g}$", kind="force")
        sketch.vector(moved(O, s, down), moved(O, -friction, down), "friction", kind="force")
        T, lost = m * a * s, friction * s
        V = top - weight * s * math.sin(slope)
        bars(axes[1], {"T": T, "V": V, "internal": lost, "sum": T + V + lost}, 0, 1.2 * top)

    interactive_figure(
        draw,
        Slider("s", 1, 0, length, 0.2, label="distance", unit="m"),
        alt="Left: a block slides down an incline, with its weight and the friction. Right: bars "
        "of kinetic, potential and internal energy. The potential energy falls, the other two "
        "grow in proportion to the distance, and the sum stays.",
        size=(9, 3.9),
        panels=(1, 2),
    )


def weight_on_spring(m: float, stiffness: float) -> None:
    """Figure 11.7: a weight let go on a spring without load, and its potential energies."""
    lowest = 2 * m * G_SI / stiffness
    x = evenly(-0.1 * lowest, 1.15 * lowest, 121)
    cm = [100 * stretch for stretch in x]
    potentials = {"spring": lambda x: stiffness * x * x / 2, "weight": lambda x: -m * G_SI * x}

    def total(x):
        return sum(V(x) for V in potentials.values())

    def draw(axes, stretch):
        now = 0.01 * stretch
        hung = (0, -0.3 - now, 0)
        ground = Frame("ground")
        sketch = Sketch(axes[0], ground, plane="xy")
        sketch.road([(0.15, 0, 0), (-0.15, 0, 0)])
        sketch.spring(O, hung)
        G = (0, hung[1] - 0.05, 0)
        sketch.box(G, ground, (0.16, 0.1, 0.1))
        sketch.vector(G, (0, -m * G_SI, 0), r"$m\mathbf{g}$", kind="force", size="N")
        sketch.vector(hung, (0, stiffness * now, 0), "spring", kind="force", size="N")
        sketch.dimension((0.22, -0.3, 0), (0.22, hung[1], 0), "x", offset=0.0)
        ax = axes[1]
        for (name, V), colour, style in zip(potentials.items(), COLOURS, STYLES[1:], strict=False):
            ax.plot(cm, [*map(V, x)], color=colour, ls=style, label=f"V of the {name}")
        ax.plot(cm, [*map(total, x)], color="black", label="V, the sum")
        ax.axhline(0, color=GREY, ls="-.", label="E = 0")
        ax.plot([stretch] * 2, [total(now), 0], color=GREEN, lw=5, label="T = E − V")
        ax.set(xlabel="x (cm)", ylabel="J", xlim=(cm[0], cm[-1]))
        ax.legend(frameon=False, fontsize=9, loc="upper left")

    interactive_figure(
        draw,
        Slider("stretch", 12, 0, round(100 * lowest), 1, label="stretch x", unit="cm"),
        alt="Left: a block hangs on a spring, with its weight and the force of the spring. Right: "
        "the potentials of spring and weight against the stretch, and their sum, a parabola. The "
        "kinetic energy is the gap up to the level E = 0, widest at the lowest point of the parabola.",
        size=(9, 4.2),
        panels=(1, 2),
    )


# -- rigid bodies


@with_sliders(
    Slider("turn", 20, 0, 180, 5, label="angle of the body", unit="°"),
    alt="A rigid plate moves and turns. The velocities of its points i and j differ, but their "
    "components along the line from i to j, drawn as shorter arrows, are equal.",
    size=(6.4, 4.4),
)
def pair_in_a_body(ax: AnyAxes, turn: float) -> None:
    """Figure 11.8: the velocities of two points of a rigid body and their parts along the line."""
    ground = Frame("ground")
    body = ground.rotate("body", "z", angle=math.radians(turn), rate=1.0)
    ends = {"i": body.point("i", -0.7, 0, 0), "j": body.point("j", 0.7, 0.2, 0)}
    line = (ends["j"] - ends["i"]).direction()
    drift = ground.vector(0.8, 0.3, 0)
    sketch = Sketch(ax, ground, plane="xy")
    corners = ((-1, -0.5), (1, -0.5), (1, 0.55), (-1, 0.55))
    sketch.plate([body.point("", x, y, 0) for x, y in corners], shade="light")
    sketch.line(ends["i"], ends["j"])
    for name, P in ends.items():
        v = P.velocity(ground) + drift
        along = v.dot(line)
        sketch.vector(P, v, rf"$\mathbf{{v}}_{name}$", size="m/s")
        sketch.vector(P, along * line, "")
        sketch.label(P, name)
    both = f"component from i to j: {along:.3f} m/s for both".replace("-", "\N{MINUS SIGN}")
    ax.set_title(both, fontsize=11)


@with_sliders(
    Slider("turn", 330, 0, 360, 10, label="position of the particle", unit="°"),
    alt="A round body with its centre of mass G. A particle i lies at rho from G and at r from "
    "the origin O; its velocity is that of G plus omega cross rho, which turns with the "
    "particle and cancels over the whole body.",
    size=(6.6, 4.2),
)
def particle_of_a_body(ax: AnyAxes, turn: float) -> None:
    """Figure 11.9: a particle of a rigid body from the centre of mass, and its velocity."""
    ground = Frame("ground")
    G = (1.2, 0.7, 0)
    body = ground.rotate("body", "z", angle=math.radians(turn), origin=ground.point("G", *G))
    P = body.point("i", 0.55, 0, 0)
    v_G = ground.vector(0.7, 0, 0)
    sketch = Sketch(ax, ground, plane="xy")
    sketch.disk(G, ground.k, 0.7)
    sketch.arrow(O, G, r"$\bar{\mathbf{r}}$")
    sketch.arrow(G, P, r"$\rho_i$")
    sketch.arrow(O, P, r"$\mathbf{r}_i$")
    sketch.vector(G, v_G, r"$\bar{\mathbf{v}}$")
    turning = 0.55 * body.j.expressed_in(ground)
    sketch.vector(P, v_G + turning, r"$\mathbf{v}_i$")
    sketch.vector(P, turning, r"$\omega\times\rho_i$")
    for place, name in ((O, "O"), (G, "G")):
        sketch.label(place, name)


@with_sliders(
    Slider("s", 0.4, 0, 1.0, 0.05, label="distance", unit="m"),
    alt="Left: a sphere rolls down an incline, with the velocity of its centre, its weight and "
    "the contact force at C, which is at rest. Right: bars of the energies of translation and "
    "rotation, always as 5 to 2, and of the potential energy.",
    size=(9, 3.9),
    panels=(1, 2),
)
def rolling_sphere(
    axes: Sequence[AnyAxes],
    energy: Callable[[float], Amount],
    speed: Callable[[float], float],
    m: float,
    R: float,
    slope: float,
    s: float,
) -> None:
    """Figure 11.10: a sphere rolls down 1 m; ``energy(v)`` has terms, ``speed`` is that after a
    drop.
    """
    down, normal = _incline(slope)
    weight, drop = m * G_SI, s * math.sin(slope)
    v, C = speed(drop), moved(O, s, down)
    G = moved(C, R, normal)
    sketch = Sketch(axes[0], Frame("ground"), plane="xy")
    sketch.road([moved(O, -0.3, down), moved(O, 1.3, down)])
    sketch.disk(G, (0, 0, 1), R, spoke=on_circle(G, down, moved(O, -1, normal), R, s / R))
    sketch.vector(G, moved(O, v, down), r"$\bar{\mathbf{v}}$")
    axes[0].set_title(f"speed of the centre: {v:.2f} m/s", fontsize=11)
    N, F = weight * math.cos(slope), weight * 2 / 7 * math.sin(slope)
    sketch.vector(G, (0, -weight, 0), r"$m\mathbf{g}$", kind="force")
    sketch.vector(C, on_plane(O, N, normal, -F, down), "contact force", kind="force")
    sketch.label(C, "C")
    T, V = energy(v).terms, weight * (math.sin(slope) - drop)
    values = {"translation": T["translation"], "rotation": T["rotation"], "V": V}
    bars(axes[1], values, 0, 1.2 * weight * math.sin(slope))


def race(
    speeds: Mapping[str, Callable[[float], float]], slope: float, length: float = 2.0
) -> Animation:
    """A film: bodies start together on equal inclines; ``speeds``: by name, after a drop."""
    R = 0.1
    down, normal = _incline(slope)
    end = length * math.sin(slope)
    accelerations = {name: speed(end) ** 2 / (2 * length) for name, speed in speeds.items()}
    time = math.sqrt(2 * length / min(accelerations.values()))

    def draw(t, ax):
        ground = Frame("ground")
        sketch = Sketch(ax, ground, plane="xy")
        for n, (name, a) in enumerate(accelerations.items()):
            s, start = min(a * t * t / 2, length), (0, -0.5 * n, 0)
            top, C = moved(start, -0.15, down), on_plane(start, s, down, R, normal)
            sketch.road([top, moved(start, length + 0.15, down)])
            if name == "block":
                sketch.box(C, ground.rotate("slope", "-z", slope), (2 * R, 2 * R, R))
            else:
                hole = 0.8 * R if name == "hoop" else 0
                sketch.disk(C, (0, 0, 1), R, on_circle(C, normal, down, R, s / R), hole=hole)
            sketch.label(top, name, offset=(-26, 4))

    return animate(
        draw,
        evenly(0, time, 25),
        alt="A block without friction, a sphere, a cylinder and a hoop start together down equal "
        "inclines. The block is first, then the sphere, the cylinder, and last the hoop.",
    )


def top_energies(I0: float, I: float, mgr: float, spin: float) -> None:
    """Figure 11.11: the terms of the energy of a top that is let go with its axis at rest."""
    motion = integrate(euler(I0, I, mgr, spin), 1.0, (0.0, 0.6, 0.0, 0.0, 0.0), samples=201)
    s = motion.states
    axle = spin - s["psi_rate"] * np.cos(s["theta"])
    T = gyroscope_energy(I0, I, s["theta"], s["theta_rate"], s["psi_rate"], axle).terms
    V = mgr * (np.cos(s["theta"]) - math.cos(0.6))  # zero at the start, to make its fall visible
    transverse = T["transverse"]
    curves = {"transverse": transverse, "weight": V, "transverse + weight": transverse + V}
    fig, ax = plt.subplots(figsize=(6.6, 3.4))
    for (name, y), colour, style in zip(curves.items(), COLOURS, STYLES, strict=False):
        ax.plot(motion.times, y, color=colour, ls=style, label=name)
    ax.set(xlabel="t (s)", ylabel="J")
    ax.margins(y=0.25)  # room for the legend
    ax.legend(frameon=False, loc="upper right", ncols=3, fontsize=9)
    show_figure(
        fig,
        alt="Energies of a nodding top against time. The transverse kinetic energy rises from zero "
        "and returns, the potential energy of the weight falls and returns, and their sum is a "
        "straight level line. The axial energy does not change and is not drawn.",
    )


def pendulum_levels(m: float, I: float, l: float) -> None:
    """Figure 11.12: the potential of a pendulum, a level of its energy, and the motion there."""
    swing = prepare(physical_pendulum(m, I, l, G_SI))
    angles = evenly(-180, 180, 181)
    depth = m * G_SI * l

    def draw(axes, omega0):
        E = (I + m * l * l) * omega0**2 / 2 - depth
        top = 2000 if depth < E else 200
        V = [-depth * math.cos(math.radians(x)) for x in angles]
        axes[0].plot(angles, V, color=BLUE, label="V")
        axes[0].axhline(E, color="black", ls="--", label="E")
        look = {"color": GREEN, "alpha": 0.3, "label": "T = E − V"}
        axes[0].fill_between(angles, V, E, where=[x < E for x in V], **look)
        axes[0].set(xlabel="θ (°)", ylabel="J", xlim=(-180, 180), ylim=(-1.3 * depth, 3.6 * depth))
        axes[0].legend(frameon=False, fontsize=9, loc="upper left", ncols=3)
        t = evenly(0, 4, 161)
        theta = [math.degrees(swing(x, (0.0, omega0))[0]) for x in t]
        axes[1].plot(t, theta, color=BLUE)
        axes[1].set(xlabel="t (s)", ylabel="θ (°)", ylim=(-200, top))

    interactive_figure(
        draw,
        Slider("omega0", 5.0, 0.5, 9.0, 0.25, label="ω at the bottom", unit="rad/s"),
        alt="Left: the potential energy of a pendulum against its angle, a valley with hills at "
        "plus and minus 180 degrees, and the level of the energy. Right: the angle against time. "
        "Below the hilltops the pendulum swings, above them it turns over and over.",
        size=(9, 3.9),
        panels=(1, 2),
    )


# -- systems


@with_sliders(
    Slider("t", 20, 0, 100, 5, label="time", unit="% of the film"),
    alt="Left: two carts on a rail, pushed apart by a spring that is fixed to the left one. "
    "Right: bars of the kinetic energies of both and of the spring. The spring's energy goes "
    "to both, three times as much to the light cart as to the heavy one.",
    size=(9, 3.6),
    panels=(1, 2),
)
def two_carts(
    axes: Sequence[AnyAxes],
    carts: Callable[[float], tuple[float, float, Mapping[str, float]]],
    period: float,
    t: float,
) -> None:
    """Figure 11.13: two carts pushed apart by a spring; ``carts(t)`` gives x1, x2 and energies."""
    x1, x2, energies = carts(0.01 * t * period)
    ground = Frame("ground")
    sketch = Sketch(axes[0], ground, plane="xy")
    sketch.road([(-0.9, 0, 0), (0.8, 0, 0)])
    left, right = -0.2 + x1, 0.2 + x2
    free = min(right - left, 0.5)
    sketch.box((left - 0.12, 0.12, 0), ground, (0.24, 0.2, 0.2))
    sketch.box((right + 0.18, 0.12, 0), ground, (0.36, 0.2, 0.2))
    sketch.spring((left, 0.12, 0), (left + free, 0.12, 0))
    sketch.label((left - 0.12, 0.12, 0), "1", offset=(0, 0))
    sketch.label((right + 0.18, 0.12, 0), "2", offset=(0, 0))
    bars(axes[1], energies, 0, 1.25)


@with_sliders(
    Slider("slope", 3, -6, 10, 1, label="slope", unit="%"),
    alt="The power at the wheels of a car against its speed: accelerating, spinning up the "
    "wheels and climbing (negative downhill) grow in proportion to the speed, the air with its "
    "cube; the sum is the heavy line.",
    size=(7, 4.2),
)
def powers_of_a_car(
    ax: AnyAxes, powers: Callable[[float, float, float], Amount], a: float, slope: float
) -> None:
    """Figure 11.14: the power at the wheels against the speed, from ``powers(v, a, slope)``."""
    v = evenly(0.5, 40, 80)
    found = [powers(x, a, math.atan(slope / 100)) for x in v]
    for name, colour, style in zip(found[0].terms, COLOURS, STYLES[1:] + STYLES[:1], strict=True):
        ax.plot(v, [1e-3 * P.terms[name] for P in found], color=colour, ls=style, label=name)
    ax.plot(v, [1e-3 * P.value for P in found], color="black", lw=2.5, label="sum")
    ax.axhline(0, color="black", lw=0.8)
    ax.set(xlabel="v (m/s)", ylabel="kW", xlim=(0, 40), ylim=(-30, 110))
    ax.legend(frameon=False, loc="upper left", ncols=2, fontsize=9)
