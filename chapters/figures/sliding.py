"""The decorator of a figure with sliders: what it draws is all that is left to write."""

from collections.abc import Callable
from functools import update_wrapper
from typing import Any, Protocol

from newton_euler.classroom import Slider, interactive_figure


class SliderFigure(Protocol):
    """A function that shows ``draw(ax, *given, **values)`` as an interactive figure, from what is
    ``given``, as a mechanism that the notebook builds.
    """

    draw: Callable[..., None]
    sliders: tuple[Slider, ...]
    options: dict[str, Any]  # those of :func:`newton_euler.classroom.interactive_figure`

    def __call__(self, *given: object, **named: object) -> None: ...


def with_sliders(*sliders: Slider, **options: Any) -> Callable[[Callable[..., None]], SliderFigure]:
    """A decorator of ``draw(ax, *given, **values)``, which makes a :class:`SliderFigure` of it.
    Arguments and options are those of :func:`newton_euler.classroom.interactive_figure`.

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
