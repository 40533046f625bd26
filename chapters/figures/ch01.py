"""The figures of chapter 1: position and displacement, a merry-go-round for three observers, and
the clocks that flew round the Earth.
"""

import math
from collections.abc import Callable
from typing import TypeAlias

from newton_euler import Frame, Point
from newton_euler.algebra.scalars import Triple
from newton_euler.classroom import Slider, interactive_figure
from newton_euler.drawing import Animation, AnyAxes, Sketch, animate
from newton_euler.drawing.page.projection import moved

from .curves import evenly, parts
from .sliding import with_sliders

O = (0, 0, 0)
TURN = 2 * math.pi / 0.6  # s, of the merry-go-round
# ground, platform, horse and its nose at a time
MerryGoRound: TypeAlias = Callable[[float], tuple[Frame, Frame, Frame, Point]]


def curve(t: float) -> Triple:
    """A place on the curve of figure 1.1."""
    return 0.5 + 0.35 * t, 0.6 + 0.9 * math.sin(0.8 * t), 0.5 + 0.25 * t - 0.06 * t * t


@with_sliders(
    Slider("dt", 1.6, 0.1, 2.4, 0.1, label="Δt", unit="s"),
    alt="A curve C in space and the axes x, y, z of an observer at O. Vectors r lead from O to "
    "the point P at two instants; the displacement between them turns towards the dotted "
    "tangent of the curve at P as the time between the instants gets shorter.",
    size=(6.8, 4.6),
)
def position_and_velocity(ax: AnyAxes, dt: float) -> None:
    """Figure 1.1: position at two instants, displacement and tangent."""
    ground = Frame("ground")
    P, later = curve(1.0), curve(1.0 + dt)
    rate = tuple((b - a) / 1e-6 for a, b in zip(P, curve(1.0 + 1e-6), strict=True))
    s = Sketch(ax, ground, azimuth=35, elevation=22)
    s.axes(O, ground, length=0.5, labels=["x", "y", "z"])
    s.path([curve(t) for t in evenly(0, 4, 41)])
    s.arrow(O, P, r"$\mathbf{r}(t)$")
    s.arrow(O, later, r"$\mathbf{r}(t+\Delta t)$")
    s.arrow(P, later, r"$\Delta\mathbf{r}$", kind="velocity")
    s.line(moved(P, -0.4, rate), moved(P, 1.2, rate), "dotted")
    s.label(O, "O")
    s.label(P, "P")
    s.label(curve(4.0), "C", bold=False)


def places(build: MerryGoRound, observer: int) -> list[Triple]:
    """The nose during one turn, as the observer (by its number) sees it."""
    found = []
    for t in evenly(0, TURN, 121):
        *frames, nose = build(t)
        found.append(parts(nose.position(frames[observer])))
    return found


def three_observers(build: MerryGoRound) -> None:
    """Figure 1.2: the nose of the horse for three observers, from ``build(t)``."""
    paths = [places(build, observer) for observer in range(3)]

    def draw(axes, t):
        *frames, nose = build(t)
        for ax, n, who in zip(axes, (2, 1, 0), ("rider", "platform", "ground"), strict=True):
            own = Frame("own")  # the observer, at rest in the picture
            place = parts(nose.position(frames[n]))
            v = parts(nose.velocity(frames[n]).components(frames[n]))
            s = Sketch(ax, own, azimuth=50, elevation=24, arrows=60)
            s.axes(O, own, length=1.0)
            _surroundings(s, own, n, t)
            if n < 2:  # for the rider the nose has no path
                s.path(paths[n])
            s.dot(place)
            s.vector(place, v, r"$\mathbf{v}$", size="m/s")
            ax.set_title(f"seen by the {who}" if n == 2 else f"seen from the {who}", fontsize=11)

    interactive_figure(
        draw,
        Slider("t", 0.3, 0, 10.4, 0.1, unit="s"),
        alt="Three pictures of the nose of a merry-go-round horse. For the rider it is a point at "
        "rest, at the head of the horse. For someone on the platform it moves up and down on a vertical line. From the "
        "ground it runs round on a wavy ring, with a velocity along that ring.",
        size=(9.6, 3.0),
        panels=(1, 3),
    )


def _surroundings(s, own, n, t):
    """Draw the horse and, except for the rider, the platform, as observer number ``n`` sees them."""
    if n == 2:
        _horse(s, own)
        return
    platform = own.rotate("platform", "z", 0.6 * t if n == 0 else 0.0)
    pole = platform.point("pole", 3, 0, 1.5 + 0.4 * math.sin(3.0 * t))
    s.disk(O, own.k, 3.3, spoke=platform.point("", 3.3, 0, 0))
    s.rod(platform.point("", 3, 0, 0), platform.point("", 3, 0, 2.6))
    _horse(s, platform.translate("horse", pole))


# the outline of the horse, ahead and up from the pole; the first place is its nose
HORSE = (
    (1.0, 0.3), (0.95, 0.42), (0.62, 0.62), (0.55, 0.74), (0.5, 0.62), (0.25, 0.2), (-0.45, 0.2),
    (-0.75, -0.2), (-0.62, 0.02), (-0.6, -0.6), (-0.48, -0.6), (-0.4, -0.15), (0.3, -0.15),
    (0.38, -0.6), (0.5, -0.6), (0.5, 0.0), (0.62, 0.35), (0.9, 0.22),
)  # fmt: skip


def _horse(s, frame):
    s.plate([frame.point("", 0, ahead, up) for ahead, up in HORSE], thickness=0.2, shade="dark")


def merry_go_round_film(build: MerryGoRound) -> Animation:
    """A film: the merry-go-round, seen from the ground."""
    ring = places(build, 0)

    def draw(t, ax):
        ground, platform, horse, nose = build(t)
        s = Sketch(ax, ground, azimuth=50, elevation=22)
        s.disk(O, ground.k, 3.8, spoke=platform.point("", 3.8, 0, 0))
        s.shaft(O, (0, 0, 2.6))
        s.rod(platform.point("", 3, 0, 0), platform.point("", 3, 0, 2.6))
        _horse(s, horse)
        s.path(ring)
        s.dot(nose)
        s.vector(nose, nose.velocity(ground), r"$\mathbf{v}$")

    return animate(
        draw,
        evenly(0, TURN, 31),
        alt="The merry-go-round turns once, the horse goes up and down; its nose follows a wavy "
        "ring, and its velocity is tangent to it at every instant.",
    )


def _clocks_in_words(speed):
    if not speed:
        seen = "all three move eastward, equally fast"
    elif speed < 390:
        seen = (
            "all three move eastward: the one that flies east fastest, then the clock on the "
            "ground, and the one that flies west slowest"
        )
    else:
        seen = (
            "the one that flies east moves eastward faster than the clock on the ground; the one "
            f"that flies west {'nearly stands still' if speed <= 410 else 'moves slowly westward'}"
        )
    return (
        "The Earth seen from above the North Pole, with a clock on the ground and two airliners at "
        f"{speed:g} m/s over the ground. Seen from the stars {seen}."
    )


@with_sliders(
    Slider("speed", 220, 0, 470, 10, label="ground speed", unit="m/s"),
    alt=_clocks_in_words,
    size=(6.4, 5.2),
)
def clocks(
    ax: AnyAxes, build: Callable[[float], tuple[Frame, Frame, Point, Point, Point]], speed: float
) -> None:
    """Figure 1.3: the velocities of three clocks, seen from the stars, from ``build(speed)``."""
    stars, _, *three = build(speed)
    s = Sketch(ax, stars, azimuth=-90, elevation=90)
    s.disk(O, stars.k, 6.371e6 * 0.87)
    s.turn(O, stars.k, r"$\omega$", radius=1.5e6)
    names = "on the ground", "flies east", "flies west"
    for name, angle, clock in zip(names, (1.6, 3.7, 5.8), three, strict=True):
        here = stars.rotate("here", "z", angle)  # drawn apart, though they start together
        place, v = clock.position(stars), clock.velocity(stars)
        at = here.vector(*parts(place.components(stars))).expressed_in(stars)
        along = here.vector(*parts(v.components(stars))).expressed_in(stars)
        P = stars.point(name, at.x, at.y, 0)
        s.dot(P)
        s.vector(P, along, name, size="m/s")
