"""The decorator of a figure with sliders: what it draws is all that is left to write."""

from collections.abc import Callable
from functools import update_wrapper
from typing import Any

from newton_euler.classroom import Slider, interactive_figure


def with_sliders(*sliders: Slider, **options: Any) -> Callable:
    """A decorator of ``draw(ax, *given, **values)``: the function that it makes takes what is
    ``given``, as a mechanism that the notebook builds, and shows an interactive figure.

    Arguments and options are those of :func:`newton_euler.classroom.interactive_figure`. The figure
    keeps them as attributes: ``draw``, ``sliders``, ``options``.

    >>> @with_sliders(Slider("tilt", 30, 0, 90, 5), alt="a boom that is raised")
    ... def crane(ax, build, tilt):
    ...     build(tilt)
    >>> crane.sliders[0].start
    30
    """

    def decorated(draw):
        def figure(*given, **named):
            interactive_figure(
                lambda ax, **values: draw(ax, *given, **named, **values), *sliders, **options
            )

        figure.draw, figure.sliders, figure.options = draw, sliders, options
        return update_wrapper(figure, draw)

    return decorated
