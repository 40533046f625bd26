"""Figures as SVG, written by the engine alone."""

from collections.abc import Callable
from typing import Any

from ..algebra.errors import checked
from .page.paper import Page
from .page.svg import svg


@checked
def svg_of(
    draw: Callable[..., Any],
    *given: Any,
    size: tuple[float, float] = (5.2, 4.0),
    panels: tuple[int, int] = (1, 1),
    alt: str = "",
    **values: Any,
) -> str:
    """The :func:`svg` of what ``draw(*given, panel, **values)`` draws by sketches.

    given : what comes before the panel, as the numbers ``g`` of a problem's ``draw(g, ax)``
    size, panels : width and height in inches; rows and columns, of which ``draw`` gets all
    alt : what it shows, in words, for those who cannot see it

    Raises :class:`.NeedsMatplotlib` for what a panel cannot draw. Pictures of one moving figure,
    which share a window, are those of :class:`newton_euler.classroom.widgets.stage.Stage`.

    >>> from newton_euler import Frame
    >>> from newton_euler.drawing import Sketch, svg_of
    >>> def figure(ax, h):
    ...     Sketch(ax, Frame("ground")).rod((0, 0, 0), (0, 0, h))
    >>> svg_of(figure, h=2, alt="A rod stands on its end.").startswith("<svg")
    True
    """
    page = Page(size, *panels)
    draw(*given, page.panels(), **values)
    return svg(page, alt)
