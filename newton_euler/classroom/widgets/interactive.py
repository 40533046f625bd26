"""Figures that sliders move, with one window and one scale for all values."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from itertools import product
from pathlib import Path
from typing import Any

from ...algebra.errors import ArgumentError, checked_but
from .on_pages import for_site
from .pictures import alt_text, bundle, show
from .sliders import Slider
from .stage import Stage, in_words

MOST_SAMPLES = 90

ROW, VALUE = "newton-euler-slider", "newton-euler-value"  # classes in the page
# the script that names the handles of sliders and their values for a screen reader
NAMED = Path(__file__).with_name("sliders.js")


@checked_but("alt", "title")
def interactive_figure(
    draw: Callable[..., Any],
    *sliders: Slider,
    alt: str | Callable[..., str],
    size: Sequence[float] = (7, 4.6),
    panels: Sequence[int] = (1, 1),
    title: str | Callable[..., str] | None = None,
) -> None:
    """Show what ``draw(ax, **values)`` draws, and a slider for each of its arguments. Without a
    kernel or ipywidgets the first picture stands alone.

    draw : draws by a Sketch on one panel of a page; or by its own plots, whose limits it sets, on
        one matplotlib Axes, which it gets instead if it asks for what a panel does not have
    alt : what can be seen in it, in 8 words or more, to which the sliders' values are added; or a
        function of the values that returns it all
    size : width and height in inches
    panels : rows and columns; with more than one, draw gets an array of axes instead of one
    title : of the whole figure, or a function of the values

    All sketches, on all panels, have one window and one scale for each kind of arrow, found from
    pictures all over the ranges of the sliders before the first is shown.
    """
    names = [slider.name for slider in sliders]
    if not names or len(set(names)) < len(names):
        raise ArgumentError(f"an interactive figure has sliders with different names; got {names}")
    (taker or _show)(MovingFigure(Stage(draw, size, panels), sliders, alt, title))


@dataclass(frozen=True)
class MovingFigure:
    """A figure on its stage; its sliders, words and title as in :func:`interactive_figure`."""

    stage: Stage
    sliders: Sequence[Slider]
    alt: Any
    title: Any

    @property
    def start(self) -> dict[str, float]:
        """The values at the start."""
        return {slider.name: slider.start for slider in self.sliders}

    def rehearse(self) -> None:
        """Find the window and the scale that all pictures share."""
        many = bool(self.stage.sketches(self.start))
        self.stage.rehearse([*_samples(self.sliders, many), self.start])

    def picture(self, values: Mapping[str, float]) -> tuple[bytes, str]:
        """The picture for these values, and what it shows, in words."""
        words = alt_text(_for_values(self.alt, values))
        if not callable(self.alt):  # then only the values change
            words += f" ({', '.join(s.shown(values[s.name]) for s in self.sliders)})"
        return self.stage.picture(values, _for_values(self.title, values), words), words


# what shows figures in place of a notebook, such as a page with sliders of its own
taker: Callable[[MovingFigure], object] | None = None


def _show(figure):
    """Show a figure and its sliders in a notebook."""
    figure.rehearse()

    def picture(values, png=False):
        image, words = figure.picture(values)
        return bundle(image, words, figure.stage.css_size, figure.stage.png() if png else None)

    ends = for_site(figure)
    data, about = picture(figure.start, png=not ends)  # pages have no use for one
    shown = show(({**data, **ends}, about), display_id=True)
    _show_sliders(figure.sliders, figure.start, lambda values: _update(shown, picture, values))


def _for_values(text, values):
    """The text; or what it returns for the values, if it is a function."""
    return text(**values) if callable(text) else text


def _samples(sliders, many):
    """Values of all sliders: a grid over their ranges; for plots, which have no window, its
    corners.
    """
    counts = (17, 9, 4, 3, 2) if many else (2,)
    count = next(n for n in counts if n ** len(sliders) <= MOST_SAMPLES or n == 2)
    for values in product(*(slider.samples(count) for slider in sliders)):
        yield {slider.name: x for slider, x in zip(sliders, values, strict=True)}


def _update(shown, picture, values):
    """Redraw the picture in its place; an error takes its place in words."""
    try:
        data, _ = picture(values)
    except Exception as error:
        text = f"No picture for {in_words(values)}. {type(error).__name__}: {error}"
        data = {"text/html": f"<p>{escape(text)}</p>", "text/plain": text}
    shown.update(data, raw=True)


def _show_sliders(sliders, values, redraw):
    """Show the sliders, where ipywidgets is installed; each calls ``redraw(values)``."""
    try:
        from ipywidgets import VBox
    except ImportError:
        return
    from IPython.display import Javascript, display

    values = dict(values)

    def moved(name, x):
        values[name] = x
        redraw(dict(values))

    display(VBox([_row(slider, moved) for slider in sliders]))
    display(Javascript(NAMED.read_text(encoding="utf-8")))


def _row(slider, moved):
    """A slider with its value beside it."""
    from ipywidgets import FloatSlider, HBox, Label

    low, high = slider.limits
    box = FloatSlider(slider.start, min=low, max=high, step=slider.step, readout=False)
    text = Label(slider.shown(slider.start))
    box.tooltip = slider.label or slider.name
    box.layout.width, text.layout.min_width, text.layout.margin = "20em", "8em", "0 0 0 1em"

    def on_change(change):
        x = slider.nearest(change.new)
        text.value = slider.shown(x)
        moved(slider.name, x)

    box.observe(on_change, "value")
    text.add_class(VALUE)
    return HBox([box, text]).add_class(ROW)
