"""Helpers for the notebooks of the chapters: figures with sliders, and error messages as text."""

import textwrap
from collections.abc import Callable
from io import BytesIO
from typing import Any

from ..algebra.errors import ArgumentError, checked


@checked
def interactive_figure(draw: Callable[..., Any], **sliders: tuple[float, ...]) -> None:
    """Show the figure that ``draw`` returns, and a slider for each of its arguments where
    ipywidgets is installed.

    sliders : name=(start, lowest, highest) or (start, lowest, highest, step)

    The picture is an ordinary output, which stays when the page is printed or has no kernel; a
    slider draws it anew in its place.
    """
    from IPython.display import display

    shown = display(_picture(draw(**{name: s[0] for name, s in sliders.items()})), display_id=True)
    try:
        from ipywidgets import FloatSlider, VBox
    except ImportError:
        return
    boxes = {}
    for name, (start, low, high, *step) in sliders.items():
        limits = {"min": low, "max": high, "step": step[0] if step else (high - low) / 50}
        # continuous_update: a drawing takes longer than the mouse to the next value
        boxes[name] = FloatSlider(start, description=name, continuous_update=False, **limits)

    def redraw(_):
        shown.update(_picture(draw(**{name: box.value for name, box in boxes.items()})))

    for box in boxes.values():
        box.observe(redraw, "value")
    display(VBox(list(boxes.values())))


def _picture(figure):
    """The figure as a PNG; it is closed, so that the notebook does not show it a second time."""
    import matplotlib.pyplot as plt
    from IPython.display import Image

    png = BytesIO()
    figure.savefig(png, format="png", dpi=100)
    plt.close(figure)
    return Image(data=png.getvalue(), format="png")


@checked
def error_message(f: Callable[[], object], width: int = 100) -> str:
    """The error that ``f()`` raises, as text of lines not longer than ``width``.

    Raises AssertionError if ``f()`` raises none.

    >>> print(error_message(lambda: 1/0))
    ZeroDivisionError: division by zero
    """
    if width < 1:
        raise ArgumentError(f"the lines have a width of 1 or more, got {width}")
    try:
        result = f()
    except Exception as error:
        return textwrap.fill(f"{type(error).__name__}: {error}", width, subsequent_indent="    ")
    raise AssertionError(f"nothing was refused; the result is {result!r}")
