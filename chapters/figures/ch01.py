"""The figures of chapter 1: position and displacement, and a merry-go-round for three observers."""

import math

from newton_euler import Frame
from newton_euler.classroom import Slider, interactive_figure
from newton_euler.drawing import Sketch, animate

from .sliding import with_sliders

O = (0, 0, 0)


def curve(t):
    """A place on the curve of figure 1.1."""
    return 0.5 + 0.35 * t, 0.6 + 0.9 * math.sin(0.8 * t), 0.5 + 0.25 * t - 0.06 * t * t


@with_sliders(
    Slider("dt", 1.6, 0.1, 2.4, 0.1, label="Δt", unit="s"),
    alt="A curve C in space and the axes x, y, z of an observer at O. Vectors r lead from O to "
    "the point P at two instants; the displacement between them turns towards the dotted "
    "tangent of the curve at P as the time between the instants gets shorter.",
    size=(6.8, 4.6),
)
def position_and_velocity(ax, dt):
    """Figure 1.1: position at two instants, displacement and tangent."""
    ground = Frame("ground")
    P, later = curve(1.0), curve(1.0 + dt)
    rate = [(b - a) / 1e-6 for a, b in zip(P, curve(1.0 + 1e-6), strict=True)]
    s = Sketch(ax, ground, azimuth=35, elevation=22)
    s.axes(O, ground, length=0.5, labels=["x", "y", "z"])
    s.path([curve(0.1 * n) for n in range(41)])
    s.arrow(O, P, r"$\mathbf{r}(t)$")
    s.arrow(O, later, r"$\mathbf{r}(t+\Delta t)$")
    s.arrow(P, later, r"$\Delta\mathbf{r}$", kind="velocity")
    s.line(*(tuple(p + f * v for p, v in zip(P, rate, strict=True)) for f in (-0.4, 1.2)), "dotted")
    s.label(O, "O")
    s.label(P, "P")
    s.label(curve(4.0), "C", bold=False)


def places(build, observer, times):
    """The nose at many times, as the observer (by its number) sees it."""
    found = []
    for t in times:
        *frames, nose = build(t)
        found.append(tuple(map(float, nose.position(frames[observer]))))
    return found


def three_observers(build):
    """Figure 1.2: the nose of the horse for three observers, from ``build(t)``."""
    times = [2 * math.pi / 0.6 * n / 120 for n in range(121)]
    paths = [places(build, observer, times) for observer in range(3)]

    def draw(axes, t):
        *frames, nose = build(t)
        for ax, n, who in zip(axes, (2, 1, 0), ("rider", "platform", "ground"), strict=True):
            own = Frame("own")  # the observer, at rest in the picture
            place = tuple(map(float, nose.position(frames[n])))
            v = tuple(map(float, nose.velocity(frames[n]).components(frames[n])))
            s = Sketch(ax, own, azimuth=50, elevation=22, arrows=50)
            s.axes(O, own, length=1.2)
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
        "rest. For somebody on the platform it moves up and down on a vertical line. From the "
        "ground it runs round on a wavy ring, with a velocity along that ring.",
        size=(9.6, 3.8),
        panels=(1, 3),
    )


def _surroundings(s, own, n, t):
    """What the observer sees at rest or turning: the horse for the rider, else the platform."""
    if n == 2:
        s.box(O, own, (0.4, 1.3, 0.5))
        return
    platform = own.rotate("platform", "z", 0.6 * t if n == 0 else 0.0)
    s.disk(O, own.k, 3.8, spoke=platform.point("", 3.8, 0, 0))
    s.rod(platform.point("", 3, 0, 0), platform.point("", 3, 0, 2.6))


def merry_go_round_film(build):
    """A film: the merry-go-round, seen from the ground."""
    time = 2 * math.pi / 0.6
    ring = places(build, 0, [time * n / 120 for n in range(121)])

    def draw(t, ax):
        ground, platform, horse, nose = build(t)
        s = Sketch(ax, ground, azimuth=50, elevation=22)
        s.disk(O, ground.k, 3.8, spoke=platform.point("", 3.8, 0, 0))
        s.shaft(O, (0, 0, 2.6))
        s.rod(platform.point("", 3, 0, 0), platform.point("", 3, 0, 2.6))
        s.box(horse.origin, horse, (0.4, 1.3, 0.5))
        s.path(ring)
        s.dot(nose)
        s.vector(nose, nose.velocity(ground), r"$\mathbf{v}$")

    return animate(
        draw,
        [time * n / 30 for n in range(31)],
        alt="The merry-go-round turns once, the horse goes up and down; its nose follows a wavy "
        "ring, and its velocity is tangent to it at every instant.",
    )
