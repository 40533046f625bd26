"""A page as SVG, written from its strokes, with texts in the fonts of the page that shows it."""

from collections.abc import Callable, Iterator
from html import escape
from itertools import groupby
from typing import Any

from ...algebra.errors import checked
from .label_placement import label_shifts
from .letters import letters, text_at
from .paper import LINE, Page
from .plot_writer import Drawing
from .primitives import DASHES, FONT, STYLES, WHITE
from .recorder import laid_out, share_window

FONTS = "var(--sketch-font, 'DejaVu Sans', Verdana, sans-serif)"
# {colour: the one on a dark page}
DARK = {
    "#000000": "#f0f2f4", "#ffffff": "#131416", "#454a50": "#b4bac1", "#aab1b9": "#343a41",
    "#c9ced4": "#3d444c", "#dde1e5": "#4a525b", "#eef0f2": "#59626c", "#8a5a00": "#e0ad50",
    "#0072B2": "#5cb8f0", "#D55E00": "#ff9450", "#008060": "#3fc79c", "#B0408A": "#ec85c8",
    "#6b6f75": "#9aa0a8", "#f1ede4": "#2a2721", "#555555": "#b0b0b0", "#777777": "#9a9a9a",
}  # fmt: skip


@checked
def dark_css(selector: str = "svg.sketch") -> str:
    """The rules of a style sheet that show sketches in dark colours, where ``selector`` holds, as
    ``:root[data-theme=dark] svg.sketch``; of sketches within the page, none that an <img> shows.

    >>> dark_css(".dark svg.sketch")[:46]
    '.dark svg.sketch [fill="#000000"]{fill:#f0f2f4'
    """
    return "".join(
        f'{selector} [{name}="{light}"]{{{name}:{dark}}}'
        for light, dark in DARK.items()
        for name in ("fill", "stroke")
    )


def svg(page: Page, alt: str = "") -> str:
    """The SVG of a page, without Matplotlib and NumPy. Its letters are texts in the fonts of the
    page that shows it, or in those that it gives as ``--sketch-font``; its colours are attributes,
    for which :func:`dark_css` has others.

    alt : what it shows, in words, for those who cannot see it
    """
    width, height = page.width, page.height
    label = f' aria-label="{escape(" ".join(alt.split()))}"' if alt else ""
    kind = "sketch wide" if width > 1.7 * height else "sketch"  # phones scroll a wide one
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" class="{kind}" viewBox="0 0 {width:g} {height:g}"'
        f' width="{width / 0.72:g}" height="{height / 0.72:g}" role="img"{label}'
        f' font-family="{FONTS}" fill-rule="evenodd" stroke-linecap="round"'
        f' stroke-linejoin="round" text-anchor="middle">'
        f'<rect width="{width:g}" height="{height:g}" fill="{WHITE}"/>'
    ]
    for number, panel in enumerate(page.axes):
        alone = [sketch for sketch in panel.sketches if sketch._window is None]
        if alone:
            share_window(alone)
        for sketch in panel.sketches:
            parts += _sketch(sketch, panel, number)
        if panel.plotted.calls:
            parts += Drawing(panel).parts()
        parts += _titles(panel)
    if page.title.strip():
        parts.append(text_at(page.title, width / 2, 12, 11))
    return "".join([*parts, "</svg>"])


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


def _sketch(sketch, panel, number):
    """The strokes and the labels of one sketch."""
    window, page = sketch._window, panel.figure
    canvas, (left, bottom, w, h) = laid_out(sketch, window), panel.box()
    sketch.drawn = canvas
    x0 = left + w / 2 - window.middle[0] / window.pt
    y0 = bottom + h / 2 - window.middle[1] / window.pt
    top = page.height - y0
    shapes = canvas.shapes()
    drawn = [
        (_look(name, stroke), f'<path d="{_path(outlines, x0, top, stroke.closed)}"/>')
        for stroke, outlines in zip(canvas.strokes, shapes, strict=True)
        for name in stroke.styles
    ]
    for look, strokes in groupby(drawn, lambda item: item[0]):
        yield f"<g{look}>{''.join(path for _, path in strokes)}</g>"
    edges = (-x0, -y0), (page.width - x0, page.height - y0)
    before = window.labels.setdefault(number, {})
    for note, (right, up) in label_shifts(canvas, shapes, half_of, edges, before):
        x, y = (side / canvas.pt for side in note.place)
        bold = note.weight == "bold"
        yield text_at(note.text, x0 + x + right, top - y - up, FONT, note.colour, bold)


def _path(outlines, x0, top, closed):
    """Outlines, in points, as the d of a path."""
    end = "Z" if closed else ""
    return "".join(
        "M" + "L".join([f"{x0 + x:.1f} {top - y:.1f}" for x, y in outline]) + end
        for outline in outlines
    )


def _look(name, stroke):
    """The attributes of a stroke in one of its styles."""
    style = STYLES[name]
    width, dashes = style["linewidth"], style["linestyle"]
    fill = style["facecolor"] if stroke.closed else "none"
    look = f' fill="{fill}" stroke="{style["edgecolor"]}" stroke-width="{width}"'
    if stroke.cut or style["capstyle"] == "butt":
        look += ' stroke-linecap="butt"'
    if dashes != DASHES["solid"]:
        look += f' stroke-dasharray="{" ".join(f"{x * width:.2f}" for x in dashes[1])}"'
    return look


def half_of(note: Any) -> tuple[float, float]:
    """Half the width and the height of a label."""
    found = letters(note.text, note.weight == "bold")
    return FONT * found.width / 2, FONT * (found.above + found.below) / 2


def _titles(panel: Any) -> Iterator[str]:
    """The lines of the titles of a panel."""
    left, bottom, w, h = panel.box()
    for place, (text, size) in panel.titles.items():
        x, more = (left + w / 2, "") if place == "center" else (left + 6, ' text-anchor="start"')
        y = panel.figure.height - bottom - h - 4 - size / 2
        for line in reversed(text.split("\n")):
            if line.strip():
                yield text_at(line, x, y, size, more=more)
            y -= LINE * size
