"""A plot as SVG: its frame, ticks, marks and legend."""

import math
from collections.abc import Iterator
from html import escape

from .letters import letters, text_at
from .paper import Panel
from .plots import GREY, Mark, Plot, Scale
from .primitives import BLACK, WHITE

SMALL = 9.5  # points, of numbers
LABEL = 10.5
_CORNERS = {"upper left": (0, 1), "upper right": (1, 1), "lower left": (0, 0),
            "lower right": (1, 0), "upper center": (0.5, 1), "lower center": (0.5, 0),
            "center left": (0, 0.5), "center right": (1, 0.5), "center": (0.5, 0.5)}  # fmt: skip


class Drawing:
    """The plot of a panel: its scales, and where its frame is on the page: left, top, width and
    height.
    """

    def __init__(self, panel: Panel):
        self.plot: Plot = panel.plotted
        settings = self.plot.settings
        self.x, self.y = (
            Scale(
                [v for mark in self.plot.marks for v in getattr(mark, f"{name}s") if v is not None],
                settings.get(f"{name}lim"),
                settings.get(f"{name}scale") == "log",
            )
            for name in "xy"
        )
        self.yticks = self._ticks("y", self.y, panel.box()[3] / 30)
        self.wide = max((SMALL * letters(t).width for _, t in self.yticks), default=0.0)
        left, bottom, w, h = panel.box()
        before = 8 + self.wide + (LABEL + 5) * bool(settings.get("ylabel"))
        under = 18 + (LABEL + 4) * bool(settings.get("xlabel"))
        self.w, self.h = max(w - before - 8, 10.0), max(h - under - 4, 10.0)
        self.left, self.top = left + before, panel.figure.height - bottom - h + 4
        if settings.get("aspect") == "equal":
            across, up = abs(self.x.high - self.x.low), abs(self.y.high - self.y.low)
            unit = min(self.w / across, self.h / up)
            self.left += (self.w - unit * across) / 2
            self.top += (self.h - unit * up) / 2
            self.w, self.h = unit * across, unit * up
        self.xticks = self._ticks("x", self.x, self.w / 42)

    def _ticks(self, name, scale, count):
        """Pairs (place, text)."""
        settings = self.plot.settings
        places = settings.get(f"{name}ticks") or scale.ticks(max(2, int(count)))
        texts = settings.get(f"{name}ticklabels")
        if texts is None:
            step = places[1] - places[0] if len(places) > 1 else places[0] if places else 1.0
            texts = [scale.text(x, step) for x in places]
        ticks = zip(places, map(str, texts), strict=False)
        return [(x, text) for x, text in ticks if -1e-9 <= scale(x) <= 1 + 1e-9]

    def at(self, x: float | None, y: float | None) -> tuple[float, float]:
        """A place on the page; None stands for an edge."""
        return (
            self.left + self.w * (self.x(x) if x is not None else 0),
            self.top + self.h * (1 - (self.y(y) if y is not None else 0)),
        )

    def parts(self) -> Iterator[str]:
        """The elements of the plot as SVG, those in front last."""
        frame = f'x="{self.left:.1f}" y="{self.top:.1f}" width="{self.w:.1f}" height="{self.h:.1f}"'
        yield f'<svg {frame} viewBox="{self.left:.1f} {self.top:.1f} {self.w:.1f} {self.h:.1f}">'
        for mark in self.plot.marks:
            if mark.kind in ("line", "area"):
                yield self._curve(mark)
            elif mark.kind == "arrow":
                yield self._arrow(mark)
        yield "</svg>"
        is_framed = self.plot.settings.get("axis") != "off"
        if is_framed:
            yield f'<rect {frame} fill="none" stroke="{BLACK}" stroke-width="0.8"/>'
        for mark in self.plot.marks:
            if mark.kind == "dots":
                yield from self._dots(mark)
            elif mark.kind == "text":
                x, y = self.at(mark.xs[0], mark.ys[0])
                yield self._text(mark, x + mark.shift[0], y - mark.shift[1])
        if is_framed:
            yield from self._axes()
        if self.plot.legend is not None:
            yield from self._legend(**self.plot.legend)

    def _text(self, mark, x, y):
        anchor = "" if abs(mark.shift[0]) < 0.2 * mark.size else (
            ' text-anchor="start"' if mark.shift[0] > 0 else ' text-anchor="end"'
        )  # fmt: skip
        return text_at(mark.shape, x, y, mark.size, bold=mark.width > 1, more=anchor)

    def _curve(self, mark):
        places = [self.at(x, y) for x, y in zip(mark.xs, mark.ys, strict=True)]
        if mark.xs[0] is None:  # from edge to edge
            places[1] = self.left + self.w, places[1][1]
        elif mark.ys[0] is None:
            places[0] = places[0][0], self.top
        d, pen = "", "M"
        for x, y in places:
            if finite := math.isfinite(x) and math.isfinite(y):
                x, y = (max(-2e4, min(2e4, side)) for side in (x, y))  # not far beyond the page
                d += f"{pen}{x:.1f} {y:.1f}"
            pen = "L" if finite else "M"
        return f'<path d="{d}"{_look(mark)}/>'

    def _dots(self, mark):
        for x, y in zip(mark.xs, mark.ys, strict=True):
            x, y = self.at(x, y)
            if -1 <= x - self.left <= self.w + 1 and -1 <= y - self.top <= self.h + 1:
                yield _dot(mark, x, y)

    def _arrow(self, mark):
        """An arrow, whose head is not longer than itself."""
        (x0, y0), (x1, y1) = (self.at(mark.xs[n], mark.ys[n]) for n in (0, -1))
        if len(mark.xs) == 1:
            right, up = (self.w * side for side in mark.shift)
            x0, y0 = x0 - mark.size * right, y0 + mark.size * up
            x1, y1 = x0 + right, y0 - up
        dx, dy, colour = x1 - x0, y1 - y0, escape(mark.colour)
        length = math.hypot(dx, dy)
        if not 0 < length < 2e4:
            return ""
        head = min(5 * mark.width, length)
        ex, ey, wide = dx / length, dy / length, head / 3
        bx, by = x0 + dx - head * ex, y0 + dy - head * ey
        return (
            f'<path d="M{x0:.1f} {y0:.1f}L{bx:.1f} {by:.1f}" stroke="{colour}" '
            f'stroke-width="{mark.width:.1f}"/><path d="M{x0 + dx:.1f} {y0 + dy:.1f}'
            f"L{bx - wide * ey:.1f} {by + wide * ex:.1f}L{bx + wide * ey:.1f} {by - wide * ex:.1f}Z"
            f'" fill="{colour}"/>'
        )

    def _axes(self):
        for x, text in self.xticks:
            x, y = self.at(x, None)[0], self.top + self.h
            yield _tick(x, y, 0, 3.5)
            yield text_at(text, x, y + 11, SMALL)
        for y, text in self.yticks:
            y = self.at(None, y)[1]
            yield _tick(self.left, y, -3.5, 0)
            yield text_at(text, self.left - 6, y, SMALL, more=' text-anchor="end"')
        settings = self.plot.settings
        if settings.get("xlabel"):
            yield text_at(settings["xlabel"], self.left + self.w / 2, self.top + self.h + 25, LABEL)
        if settings.get("ylabel"):
            x, y = self.left - self.wide - 14, self.top + self.h / 2
            turn = f' transform="rotate(-90 {x:.1f} {y:.1f})"'
            yield text_at(settings["ylabel"], x, y, LABEL, more=turn)

    def _legend(self, loc="best", fontsize=10, ncols=None, ncol=None, frameon=True):
        named = [mark for mark in self.plot.marks if mark.label]
        size = float(fontsize)
        columns = ncols or ncol or 1
        rows = -(-len(named) // columns)
        wide = max((size * letters(m.label).width for m in named), default=0.0) + 34
        w, h = wide * columns, rows * 1.35 * size + 4
        x0, y0 = self._place(loc, w, h)
        if frameon and named:
            yield (
                f'<rect x="{x0:.1f}" y="{y0:.1f}" width="{w:.1f}" height="{h:.1f}" fill="{WHITE}" '
                f'fill-opacity="0.8" stroke="{GREY}" stroke-width="0.5"/>'
            )
        for n, mark in enumerate(named):
            column, row = divmod(n, rows)
            x, y = x0 + 4 + wide * column, y0 + 2 + 1.35 * size * (row + 0.5)
            if mark.kind == "line":
                yield f'<path d="M{x:.1f} {y:.1f}h20"{_look(mark)}/>'
            if mark.kind == "area":
                yield f'<path d="M{x:.1f} {y - 4:.1f}h20v8h-20Z"{_look(mark)}/>'
            if mark.shape:
                yield _dot(mark, x + 10, y)
            yield text_at(mark.label, x + 25, y, size, more=' text-anchor="start"')

    def _place(self, loc, w, h):
        """Left and top of a box of this size; at best where the fewest marks are."""
        if loc != "best":
            return self._corner(*_CORNERS[loc], w, h)
        places = [self.at(x, y) for m in self.plot.marks for x, y in zip(m.xs, m.ys, strict=True)]
        corners = [self._corner(*c, w, h) for c in list(_CORNERS.values())[:6]]
        return min(corners, key=lambda c: sum(
            c[0] - 4 < x < c[0] + w + 4 and c[1] - 4 < y < c[1] + h + 4 for x, y in places
        ))  # fmt: skip

    def _corner(self, s, t, w, h):
        return self.left + 5 + s * (self.w - w - 10), self.top + 5 + (1 - t) * (self.h - h - 10)


def _look(mark: Mark) -> str:
    seen = f' opacity="{mark.opacity:g}"' if mark.opacity != 1 else ""
    colour = escape(mark.colour)
    if mark.kind == "area":
        return f' fill="{colour}"{seen}'
    look = f' fill="none" stroke="{colour}" stroke-width="{mark.width:g}"{seen}'
    if mark.dashes:
        dashes = " ".join(f"{x * mark.width:.1f}" for x in mark.dashes)
        look += f' stroke-dasharray="{dashes}" stroke-linecap="butt"'
    return look


def _dot(mark: Mark, x: float, y: float) -> str:
    r, colour = mark.size / 2, escape(mark.colour)
    fill = colour if mark.filled else "none"
    look = f'fill="{fill}" stroke="{colour}" stroke-width="1"'
    if mark.shape in "o.":
        r /= 1 + (mark.shape == ".")
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r:.1f}" {look}/>'
    shapes = {
        "s": f"M{x - r:.1f} {y - r:.1f}h{2 * r:.1f}v{2 * r:.1f}h{-2 * r:.1f}Z",
        "D": f"M{x:.1f} {y - r:.1f}l{r:.1f} {r:.1f}l{-r:.1f} {r:.1f}l{-r:.1f} {-r:.1f}Z",
        "^": f"M{x:.1f} {y - r:.1f}l{r:.1f} {2 * r:.1f}h{-2 * r:.1f}Z",
        "+": f"M{x - r:.1f} {y:.1f}h{2 * r:.1f}M{x:.1f} {y - r:.1f}v{2 * r:.1f}",
        "x": f"M{x - r:.1f} {y - r:.1f}L{x + r:.1f} {y + r:.1f}"
        f"M{x - r:.1f} {y + r:.1f}L{x + r:.1f} {y - r:.1f}",
    }
    return f'<path d="{shapes[mark.shape]}" {look}/>'


def _tick(x, y, dx, dy):
    return f'<path d="M{x:.1f} {y:.1f}l{dx} {dy}" stroke="{BLACK}" stroke-width="0.8"/>'
