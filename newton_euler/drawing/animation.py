"""Animations: a function draws the scene at one time, and is called for many times. All pictures
have the same scale and the same limits.

>>> from math import sin
>>> from newton_euler import Frame
>>> from newton_euler.drawing import Sketch, animate
>>> def swinging(t, ax):
...     ground = Frame("ground")
...     bob = ground.rotate("rod", "x", angle=0.4*sin(3*t)).point("B", 0, 0, -1)
...     Sketch(ax, ground, plane="yz").rod((0, 0, 0), bob)
>>> animate(swinging, [0.1*n for n in range(22)], alt="A pendulum.")  # for Jupyter
Animation of 22 pictures from t = 0.0 s to t = 2.1 s: A pendulum.
"""

import base64
import html
import io
import json
import math
import uuid
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from string import Template

from ..algebra.errors import NewtonEulerError, checked
from ..algebra.late import is_here
from ..algebra.places import add_place
from ..algebra.scalars import clipped
from .page.paper import Page
from .page.recorder import share_window, sketches_on
from .page.svg import svg

MAX_PICTURES = 600
MAX_PIXELS = 300e6  # the most in all pictures together: about ten megabytes of HTML
# palette of a picture; measured: a third of the file with all colours, and no visible difference
COLOURS = 128


class AnimationError(NewtonEulerError, ValueError):
    """An animation cannot be made or saved."""


@dataclass(frozen=True)
class Animation:
    """The pictures of a motion. Jupyter shows them; :meth:`save` writes them to a file.

    pictures, times : PNG files, or SVG where there is no Matplotlib, as bytes; in s
    speed : seconds of the motion shown in one second
    alt, size : what it shows, in words; width and height on the screen, in CSS pixels
    """

    pictures: tuple[bytes, ...]
    times: tuple[float, ...]
    speed: float
    alt: str
    size: tuple[int, int]
    kind: str = "image/png"

    def __repr__(self):
        first, *_, last = self._labels()
        text = f"Animation of {len(self.pictures)} pictures from {first} to {last}"
        return f"{text}: {self.alt}" if self.alt else text

    def _repr_mimebundle_(self, **_):
        """What Jupyter shows: the page; or in print the first picture with its alt text."""
        first = base64.b64encode(self.pictures[0]).decode()
        about = {"alt": self.alt or repr(self), "width": self.size[0], "height": self.size[1]}
        data = {"text/html": self.html(), self.kind: first, "text/plain": repr(self)}
        return data, {self.kind: about}

    def html(self) -> str:
        """The body of the page, which shows the first picture until it is played."""
        return self._page().partition("<body>\n")[2].partition("\n</body>")[0]

    def _page(self):
        coded = (base64.b64encode(picture).decode() for picture in self.pictures)
        pictures = [f"data:{self.kind};base64,{code}" for code in coded]
        times, labels = self.times, self._labels()
        data = {"pictures": pictures, "times": times, "labels": labels, "speed": self.speed}
        page = Template(Path(__file__).with_name("player.html").read_text(encoding="utf-8"))
        return page.substitute(
            name=f"motion-{uuid.uuid4().hex[:12]}", alt=html.escape(self.alt or repr(self)),
            data=json.dumps(data), pace=self._pace(), first=pictures[0],
            last=len(pictures) - 1, width=self.size[0], height=self.size[1],
        )  # fmt: skip

    def save(self, path: str | Path) -> None:
        """Write a page (.html), which needs no other file, or an animated picture (.gif)."""
        if not isinstance(path, (str, Path)):
            raise AnimationError(f"an animation is saved to a path; got {clipped(path)}")
        path = Path(path)
        if path.suffix == ".html":
            path.write_text(self._page(), encoding="utf-8")
        elif path.suffix == ".gif":
            self._save_gif(path)
        else:
            raise AnimationError(f"an animation is saved as .html or .gif; got {path.name!r}")

    def _save_gif(self, path):
        """Write a GIF without pictures within 0.02 s: viewers would show them longer."""
        if self.kind != "image/png":
            raise AnimationError("a GIF needs pictures by Matplotlib, which is not here")
        from PIL import Image

        shown, starts = [], []
        for picture, t in zip(self.pictures, self.times, strict=True):
            start = round(100 * (t - self.times[0]) / self.speed)
            if not starts or start >= starts[-1] + 2:
                shown.append(Image.open(io.BytesIO(picture)))
                starts.append(start)
        waits = [10 * (b - a) for a, b in pairwise(starts)] or [1000]
        waits += waits[-1:]
        shown[0].save(path, save_all=True, append_images=shown[1:], duration=waits, loop=0)

    def _pace(self):
        """How fast the animation is shown, in words; empty if as fast as the motion."""
        if abs(self.speed - 1) < 1e-9:
            return ""
        ratio = max(self.speed, 1 / self.speed)
        return f"shown {ratio:.3g} times {'slower' if self.speed < 1 else 'faster'}"

    def _labels(self):
        """The times as text, with the fewest decimals that keep them different."""
        step = min(b - a for a, b in pairwise(self.times))
        decimals = max(0, math.ceil(-math.log10(step) - 1e-9))
        return [f"t = {t:.{decimals}f} s" if decimals < 7 else f"t = {t:.7g} s" for t in self.times]


@checked
def animate(
    draw: Callable[..., object],
    times: Iterable[float],
    speed: float | None = None,
    size: Sequence[float] = (5, 4),
    alt: str = "",
) -> Animation:
    """An :class:`Animation` of the scene that ``draw(t, ax)`` draws with a Sketch on ``ax``; it is
    called for each of the times. Raises :class:`AnimationError` for too many pixels.

    times : of the pictures in s, increasing; they need not be evenly spaced
    speed : seconds of the motion shown in one second; by default 1, but for a motion shorter than 1
        s or longer than 30 s such that the animation lasts 8 s
    size : width and height of the picture in inches, of 100 pixels
    alt : what the animation shows, in words, for those who cannot see it
    """
    instants = _checked_times(times)
    span, page = instants[-1] - instants[0], Page(size)
    if speed is None:
        speed = 1.0 if 1 <= span <= 30 else span / 8
    if not 0 < speed < math.inf:
        raise AnimationError(f"speed, seconds of motion in one second, is positive; got {speed!r}")
    _check_amount(len(instants), page)
    kind, blank, drawn = "image/png", _figure, _pictures
    if not is_here("matplotlib"):
        kind, blank = "image/svg+xml", Page.empty
        drawn = lambda pages: (svg(page).encode() for page in pages)  # noqa: E731
    figures = [blank(page) for _ in instants]
    for figure, t in zip(figures, instants, strict=True):
        _draw(draw, t, figure.axes[0])
    share_window([sketch for figure in figures for ax in figure.axes for sketch in sketches_on(ax)])
    width, height = (round(100 * side / 72) for side in (page.width, page.height))
    return Animation(tuple(drawn(figures)), instants, float(speed), alt, (width, height), kind)


def _figure(page):
    """An empty figure of Matplotlib, of the size of a page."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(page.width / 72, page.height / 72), dpi=100)
    figure.add_axes((0.06, 0.06, 0.88, 0.88))
    return figure


def _draw(draw, t, ax):
    """The scene at time t, recorded."""
    try:
        draw(t, ax)
    except Exception as error:
        add_place(error, f"This came up while the picture at t = {t:g} s was drawn.")
        raise
    if not sketches_on(ax):
        raise AnimationError(f"draw(t, ax) draws with Sketch(ax, ...), and did not at t = {t:g} s")


def _pictures(figures):
    """Each figure as a PNG, by one renderer; unhinted letters keep their shape as they move."""
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import RendererAgg
    from PIL import Image

    width, height = (int(size) for size in figures[0].bbox.size)
    renderer = RendererAgg(width, height, figures[0].dpi)
    for n, figure in enumerate(figures):
        figures[n] = None  # frees memory: there can be hundreds
        renderer.clear()
        with rc_context({"text.hinting": "none"}):
            figure.draw(renderer)
        image = Image.frombytes("RGBA", (width, height), bytes(renderer.buffer_rgba()))
        png = io.BytesIO()
        # maximum coverage keeps the few colours of a drawing; it takes RGB only
        image.convert("RGB").quantize(COLOURS, Image.Quantize.MAXCOVERAGE).save(png, format="png")
        yield png.getvalue()


def _checked_times(times):
    times = tuple(map(float, times))
    if len(times) < 2:
        raise AnimationError(f"an animation needs two times or more, got {len(times)}")
    for a, b in pairwise(times):
        if not -math.inf < a < b < math.inf:
            raise AnimationError(f"times are finite and increase; got {a!r} and then {b!r}")
    return times


def _check_amount(count, page):
    if count > MAX_PICTURES:
        raise AnimationError(
            f"{count} pictures are too many for an animation, {MAX_PICTURES} at most: give fewer "
            f"times, as times[::{math.ceil(count / MAX_PICTURES)}]"
        )
    width, height = 100 * page.width / 72, 100 * page.height / 72
    if count * width * height > MAX_PIXELS:
        raise AnimationError(
            f"{count} pictures of {width:.0f} by {height:.0f} pixels are too much for an "
            "animation: give fewer times or a smaller size"
        )
