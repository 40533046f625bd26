"""Animations of any motion: a function sketches the scene at one instant, and is called for many,
in one window for all so that nothing jumps.

>>> from math import sin
>>> from newton_euler import Frame
>>> from newton_euler.drawing.animation import animate
>>> from newton_euler.drawing.sketch import Sketch
>>> def swinging(t, ax):
...     ground = Frame("ground")
...     bob = ground.rotate("rod", "x", angle=0.4*sin(3*t)).point("B", 0, 0, -1)
...     Sketch(ax, ground, plane="yz").rod((0, 0, 0), bob)
>>> film = animate(swinging, [0.1*n for n in range(22)], alt="A pendulum swings to and fro.")
>>> film                                                     # Jupyter shows it with a button and a slider
Animation of 22 pictures from t = 0.0 s to t = 2.1 s: A pendulum swings to and fro.

``film.save("pendulum.html")`` or ``film.save("pendulum.gif")`` writes a file. player.html is the
page around the pictures.
"""

import base64
import html
import io
import json
import math
import uuid
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from string import Template

from ..algebra.errors import NewtonEulerError
from .recorder import share_window, sketches_on

MAX_PICTURES = 600
MAX_PIXELS = 300e6  # of all pictures together: some ten megabytes of HTML
# of a picture: drawings have few; the files are a third as large, without a difference that can be
# seen
COLOURS = 128


class AnimationError(NewtonEulerError, ValueError):
    """An animation that cannot be made or saved."""


@dataclass(frozen=True)
class Animation:
    """Pictures of a motion. Jupyter shows it; :meth:`save` writes it to a file.

    pictures : PNG, as bytes
    times : of the pictures, in s
    speed : seconds of the motion shown in one second
    alt : what it shows, in words
    size : width and height on the screen, in pixels of CSS
    """

    pictures: tuple
    times: tuple
    speed: float
    alt: str
    size: tuple

    def __repr__(self):
        return (
            f"Animation of {len(self.pictures)} pictures from {self._labels()[0]} to "
            f"{self._labels()[-1]}{': ' * bool(self.alt)}{self.alt}"
        )

    def _repr_mimebundle_(self, **_):
        """What Jupyter shows: the page, or where HTML cannot be shown, as on paper, the first
        picture.
        """
        return {
            "text/html": self.html(),
            "image/png": base64.b64encode(self.pictures[0]).decode(),
            "text/plain": repr(self),
        }

    def html(self):
        """The body of the page. Without scripts (in a notebook that is not trusted) it shows the
        first picture; for a reader who prefers reduced motion it waits at the first picture until
        it is played.
        """
        return self._page().partition("<body>\n")[2].partition("\n</body>")[0]

    def _page(self):
        pictures = [base64.b64encode(picture).decode() for picture in self.pictures]
        data = {
            "pictures": pictures,
            "times": self.times,
            "labels": self._labels(),
            "speed": self.speed,
        }
        return Template(Path(__file__).with_name("player.html").read_text(encoding="utf-8")).substitute(
            name=f"motion-{uuid.uuid4().hex[:12]}", alt=html.escape(self.alt or repr(self)), data=json.dumps(data), pace=self._pace(),
            first=pictures[0], last=len(pictures) - 1, width=self.size[0], height=self.size[1],
        )  # fmt: skip

    def save(self, path):
        """Write a page (.html), which needs no other file, or a moving picture (.gif)."""
        path = Path(path)
        if path.suffix == ".html":
            path.write_text(self._page(), encoding="utf-8")
        elif path.suffix == ".gif":
            self._save_gif(path)
        else:
            raise AnimationError(f"an animation is saved as .html or .gif; got {path.name!r}")

    def _save_gif(self, path):
        """Write a GIF. It counts time in hundredths of a second, and viewers show nothing shorter
        than two: pictures between are left out.
        """
        from PIL import Image

        shown, starts = [], []
        for picture, t in zip(self.pictures, self.times, strict=True):
            start = round(100 * (t - self.times[0]) / self.speed)
            if not starts or start >= starts[-1] + 2:
                shown.append(Image.open(io.BytesIO(picture)))
                starts.append(start)
        waits = [10 * (b - a) for a, b in pairwise(starts)] or [1000]
        shown[0].save(
            path, save_all=True, append_images=shown[1:], duration=[*waits, waits[-1]], loop=0
        )

    def _pace(self):
        """How fast the animation is shown, in words; nothing if as fast as the motion."""
        if abs(self.speed - 1) < 1e-9:
            return ""
        return (
            f"shown {1 / self.speed:.3g} times slower"
            if self.speed < 1
            else f"shown {self.speed:.3g} times faster"
        )

    def _labels(self):
        """The times in words, with as many decimals as tell them apart."""
        step = min(b - a for a, b in pairwise(self.times))
        decimals = max(0, math.ceil(-math.log10(step) - 1e-9))
        return [f"t = {t:.{decimals}f} s" if decimals < 7 else f"t = {t:.7g} s" for t in self.times]


def animate(
    draw, times, speed=None, size=(5, 4), dpi=100, alt="", progress=lambda done, of_all: None
):
    """An :class:`Animation` of the scene that ``draw(t, ax)`` draws with a Sketch on ``ax`` as it
    is at time t; called once for each.

    times : of the pictures in s, increasing; they need not be evenly spaced
    speed : seconds of the motion shown in one second; by default 1, or such that the film lasts 8 s
        if that is too fast or too slow
    size, dpi : width and height of the picture in inches, and its resolution; 200 is sharper on
        fine screens and four times as much
    alt : what the film shows, in words, for those who cannot see it
    progress : called with (steps done, steps of all) after each step, for a progress bar
    """
    times = _checked_times(times)
    speed = _checked_speed(speed, times[-1] - times[0])
    _check_amount(len(times), size, dpi)
    figures = []
    for t in times:
        figures.append(_figure(draw, t, size, dpi))
        progress(len(figures), 2 * len(times))
    share_window([sketch for figure in figures for ax in figure.axes for sketch in sketches_on(ax)])
    pictures = []
    for picture in _pictures(figures):
        pictures.append(picture)
        progress(len(times) + len(pictures), 2 * len(times))
    return Animation(
        tuple(pictures), times, speed, alt, (round(100 * size[0]), round(100 * size[1]))
    )


def _figure(draw, t, size, dpi):
    """A figure of the scene at time t, not yet drawn."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=dpi)
    ax = figure.add_axes((0.06, 0.06, 0.88, 0.88))
    try:
        draw(t, ax)
    except Exception as error:
        error.add_note(f"This came up while the picture at t = {t:g} s was drawn.")
        raise
    if not sketches_on(ax):
        raise AnimationError(
            "draw(t, ax) is to draw with Sketch(ax, ...) on the axes it is given, and did not "
            f"at t = {t:g} s"
        )
    return figure


def _pictures(figures):
    """Each figure as a PNG, by one renderer, which keeps fonts and formulas; letters are not fitted
    to the grid of pixels, since they would change their shape as they move over it.
    """
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import RendererAgg
    from PIL import Image

    width, height = (int(size) for size in figures[0].bbox.size)
    renderer = RendererAgg(width, height, figures[0].dpi)
    for n, figure in enumerate(figures):
        figures[n] = None  # some hundred figures at once would take a lot of memory
        renderer.clear()
        with rc_context({"text.hinting": "none"}):
            figure.draw(renderer)
        image = Image.frombytes("RGBA", (width, height), bytes(renderer.buffer_rgba())).convert(
            "RGB"
        )
        png = io.BytesIO()
        image.quantize(COLOURS, Image.Quantize.MAXCOVERAGE).save(png, format="png")
        yield png.getvalue()


def _checked_times(times):
    try:
        times = tuple(map(float, times))
    except (TypeError, ValueError):
        raise AnimationError(
            f"the times of an animation are numbers of seconds; got {times!r}"
        ) from None
    if len(times) < 2:
        raise AnimationError(f"an animation needs two times or more, got {len(times)}")
    for a, b in pairwise(times):
        if not (math.isfinite(a) and math.isfinite(b) and a < b):
            raise AnimationError(
                f"the times of an animation are finite and increase; got {a!r} and then {b!r}"
            )
    return times


def _checked_speed(speed, span):
    if speed is None:
        return 1.0 if 1 <= span <= 30 else span / 8
    if not (isinstance(speed, (int, float)) and 0 < speed < math.inf):
        raise AnimationError(
            "speed is how many seconds of the motion are shown in one second, a positive "
            f"number; got {speed!r}"
        )
    return float(speed)


def _check_amount(count, size, dpi):
    if count > MAX_PICTURES:
        raise AnimationError(
            f"{count} pictures are too many for an animation, which takes {MAX_PICTURES} at most: "
            f"give fewer times, as times[::{math.ceil(count / MAX_PICTURES)}]; 25 for each "
            "second of the show look smooth"
        )
    pixels = count * size[0] * size[1] * dpi**2
    if pixels > MAX_PIXELS:
        raise AnimationError(
            f"{count} pictures of {size[0] * dpi:.0f} by {size[1] * dpi:.0f} pixels are "
            "too much for an animation: "
            "give fewer times, a smaller size, or a dpi of "
            f"{math.floor(dpi * math.sqrt(MAX_PIXELS / pixels))} or less"
        )
