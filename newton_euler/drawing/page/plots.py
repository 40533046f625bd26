"""Plots on a panel: what a small part of matplotlib's axes draws, by the same names. A panel keeps
the marks of a plot, and the calls that made them, for matplotlib to draw the same.
"""

import math
from dataclasses import dataclass, field
from functools import wraps
from itertools import groupby
from typing import Any, NamedTuple

from ...algebra.errors import NewtonEulerError
from .primitives import BLACK

CYCLE = "#0072B2", "#D55E00", "#008060", "#B0408A", "#8a5a00", "#454a50"
COLOURS = {"k": BLACK, "black": BLACK, "r": CYCLE[1], "b": CYCLE[0], "g": CYCLE[2], "w": "#ffffff",
           "white": "#ffffff"}  # fmt: skip
DASHES = {"-": (), "--": (4, 2), ":": (1, 1.6), "-.": (6, 1.8, 1, 1.8), "": None, "none": None}
MARKERS = "os+x.D^"
GREY = "#555555"
# the other names that matplotlib has for a keyword
_SHORT = {"c": "color", "linestyle": "ls", "linewidth": "lw", "markersize": "ms"}


class NeedsMatplotlib(NewtonEulerError, AttributeError):
    """A panel does not draw this; Matplotlib's axes do."""


class Mark(NamedTuple):
    """Something drawn: a "line", an "area", "dots", a "text" or an "arrow", at places in the units
    of the axes; None stands for the edge of the axes.
    """

    kind: str
    xs: list
    ys: list
    colour: str
    width: float = 1.5
    dashes: tuple = ()
    label: str = ""
    shape: str = ""  # shape of dots, or the text
    size: float = 6
    opacity: float = 1
    filled: bool = True
    # shift of a text, in points to the right and up; of an arrow without a second place, from tail
    # to tip, relative to the width of the axes
    shift: tuple = (0, 0)


@dataclass
class Plot:
    """The marks of one panel, and its axes."""

    marks: list[Mark] = field(default_factory=list)
    calls: list[tuple] = field(default_factory=list)
    settings: dict[str, Any] = field(default_factory=dict)  # xlabel, xlim, xticks, xscale, …
    legend: dict[str, Any] | None = None
    colours: int = 0

    def colour(self, name: str | None) -> str:
        """The colour of this name of Matplotlib; of None that of the next line."""
        if name is None:
            self.colours += 1
            return CYCLE[(self.colours - 1) % len(CYCLE)]
        if not isinstance(name, str):
            raise NeedsMatplotlib("a panel knows a colour by its name")
        if len(name) == 2 and name[0] == "C":
            return CYCLE[int(name[1]) % len(CYCLE)]
        return COLOURS.get(name, name)


def _numbers(values):
    """A number, or several, as a list of floats; a row for each line of a table of columns."""
    if getattr(values, "ndim", 1) > 1:
        raise NeedsMatplotlib("a panel plots one curve at a time")
    return [float(x) for x in values] if hasattr(values, "__len__") else [float(values)]


def _refuse(others):
    """Raise :class:`NeedsMatplotlib` for keyword arguments that are not known here."""
    others.pop("zorder", None)
    if others:
        raise NeedsMatplotlib(f"a panel does not know {', '.join(others)}")


def _style(text):
    """Dashes, marker and colour of a style such as "o--" or "k:"."""
    dashes, left = None, text
    for name in ("--", "-.", "-", ":"):
        if name in left:
            dashes, left = DASHES[name], left.replace(name, "", 1)
            break
    marker = next((c for c in left if c in MARKERS), "")
    colour = next((c for c in left if c in COLOURS), None)
    if len(left) > bool(marker) + bool(colour):
        raise NeedsMatplotlib(f"a panel does not know the style {text!r}")
    return (() if dashes is None and not marker else dashes), marker, colour


def _recorded(method):
    """A method of a panel that keeps its calls; what it does not understand, matplotlib might."""

    @wraps(method)
    def call(self, *args, **named):
        try:
            method(self, *args, **{_SHORT.get(name, name): x for name, x in named.items()})
        except (TypeError, ValueError, LookupError) as error:
            raise NeedsMatplotlib(f"a panel does not draw this {method.__name__}") from error
        self.plotted.calls.append((method.__name__, args, named))

    return call


class Plots:
    """The methods of a panel that plot; a mixin."""

    plotted: Plot

    @_recorded
    def plot(self, *args: Any, **named: Any) -> None:
        """Plot a curve ``plot(x, y, "o--", color=, ls=, lw=, marker=, ms=, mfc=, label=)``."""
        *data, style = args if isinstance(args[-1], str) else (*args, "")
        if not 1 <= len(data) <= 2:
            raise NeedsMatplotlib("a panel plots one curve at a time")
        ys = _numbers(data[-1])
        xs = _numbers(data[0]) if len(data) == 2 else [float(n) for n in range(len(ys))]
        dashes, marker, colour = _style(style)
        dashes = DASHES[named["ls"]] if "ls" in named else dashes
        marker, size = named.pop("marker", marker), named.pop("ms", 6)
        filled = named.pop("mfc", None) != "none"
        if marker and marker not in MARKERS:
            raise NeedsMatplotlib(f"a panel does not know the marker {marker!r}")
        look = self._look(named, colour) | {"shape": marker, "size": size, "filled": filled}
        if dashes is not None:
            self._mark("line", xs, ys, look | {"dashes": dashes})
            look["label"] = ""
        if marker:
            self._mark("dots", xs, ys, look | {"dashes": ()})

    def _look(self, named, colour=None):
        """What a mark looks like, by keywords of matplotlib; others are refused."""
        look = {"width": named.pop("lw", 1.5), "dashes": DASHES[named.pop("ls", "-")]}
        look |= {"label": named.pop("label", ""), "opacity": named.pop("alpha", 1)}
        colour = named.pop("color", colour)
        _refuse(named)
        return look | {"colour": self.plotted.colour(colour)}

    def _mark(self, kind, xs, ys, look):
        self.plotted.marks.append(Mark(kind, xs, ys, **look))

    def loglog(self, *args: Any, **named: Any) -> None:
        """The same as :meth:`plot` with logarithmic scales."""
        self.plot(*args, **named)
        self.set(xscale="log", yscale="log")

    @_recorded
    def axhline(self, y: float = 0, **named: Any) -> None:
        """Draw a level line over all of the width."""
        self._mark("line", [None, None], [float(y)] * 2, self._look(named))

    @_recorded
    def axvline(self, x: float = 0, **named: Any) -> None:
        """Draw an upright line over all of the height."""
        self._mark("line", [float(x)] * 2, [None, None], self._look(named))

    @_recorded
    def fill_between(self, x: Any, y: Any, base: Any = 0.0, **named: Any) -> None:
        """Fill the area between a curve and a level, or another curve, ``where`` so."""
        where = named.pop("where", None)
        named.pop("hatch", None), named.pop("interpolate", None)
        look = self._look(named)
        xs, ys = _numbers(x), _numbers(y)
        lows = _numbers(base) if hasattr(base, "__len__") else [float(base)] * len(xs)
        kept = [True] * len(xs) if where is None else map(bool, where)
        for keep, run in groupby(zip(xs, ys, lows, kept, strict=True), lambda place: place[3]):
            if keep:
                across, upper, lower, _ = map(list, zip(*run, strict=True))
                self._mark("area", across + across[::-1], upper + lower[::-1], look)
                look["label"] = ""

    @_recorded
    def bar(self, x: Any, height: Any, width: float = 0.8, **named: Any) -> None:
        """Draw a bar, or several, with its middle at ``x``."""
        named.pop("hatch", None), named.pop("edgecolor", None)
        look = self._look(named)
        for middle, top in zip(_numbers(x), _numbers(height), strict=True):
            left, right = middle - width / 2, middle + width / 2
            self._mark("area", [left, right, right, left], [0.0, 0.0, top, top], look)
            look["label"] = ""

    @_recorded
    def annotate(self, text: str, xy: Any, xytext: Any = (0, 0), **named: Any) -> None:
        """Write a text, its middle or an end (``ha``) some points from a place."""
        if "arrowprops" in named and not text:
            return self._arrow(xytext, xy, **named["arrowprops"])
        if named.pop("textcoords", None) != "offset points":
            raise NeedsMatplotlib("a panel writes texts at an offset in points")
        return self._write(text, xy, xytext, **named)

    @_recorded
    def text(self, x: float, y: float, text: str, **named: Any) -> None:
        """Write a text at a place, which its middle or an end (``ha``, ``va``) has."""
        self._write(text, (x, y), (0, 0), **named)

    def _write(self, text, xy, offset, **given):
        up = {"bottom": 5, "top": -5, "center": 0, "baseline": 4}[given.pop("va", "baseline")]
        over = {"left": 0.25, "center": 0, "right": -0.25}[given.pop("ha", "left")]
        look = {"width": 1 + (given.pop("weight", "") == "bold"), "shape": str(text)}
        look |= {"colour": BLACK, "size": given.pop("fontsize", 10)}
        _refuse(given)
        x, y = map(float, xy)
        shift = offset[0] + over * look["size"], offset[1] + up
        self._mark("text", [x], [y], look | {"shift": shift})

    def _arrow(self, tail, tip, arrowstyle, color="k"):
        if arrowstyle != "->":
            raise NeedsMatplotlib(f"a panel does not know the arrow {arrowstyle!r}")
        xs, ys = map(_numbers, zip(tail, tip, strict=True))
        self._mark("arrow", xs, ys, {"colour": self.plotted.colour(color)})

    @_recorded
    def quiver(self, *sides: Any, **named: Any) -> None:
        """Draw arrows, ``quiver(x, y, u, v, scale=, width=, color=, pivot=)``: u/scale of the width
        of the axes to the right and v/scale upwards, each with its tail or its middle at (x, y).
        """
        given = {"color": "k", "pivot": "tail", "width": 0.005, **named}
        scale, width = float(given.pop("scale")), 360 * float(given.pop("width"))
        look = {"colour": self.plotted.colour(given.pop("color")), "width": width}
        look["size"] = {"tail": 0.0, "mid": 0.5}[given.pop("pivot")]
        _refuse(given)
        for x, y, u, v in zip(*map(_numbers, sides), strict=True):
            self._mark("arrow", [x], [y], look | {"shift": (u / scale, v / scale)})

    def axis(self, which: str) -> None:
        """``axis("off")``: without a frame and ticks."""
        if which != "off":
            raise NeedsMatplotlib(f"a panel does not know axis({which!r})")
        self.plotted.calls.append(("axis", (which,), {}))
        self.plotted.settings["axis"] = which

    @_recorded
    def legend(self, **named: Any) -> None:
        """Name the curves that have a label; ``loc``, ``ncols``, ``fontsize`` as in matplotlib."""
        self.plotted.legend = {"loc": "best", "fontsize": 10, **named}
        if set(named) - {"loc", "fontsize", "ncols", "ncol", "frameon"}:
            raise NeedsMatplotlib(f"a legend of a panel does not know {', '.join(named)}")

    def set(self, **named: Any) -> None:
        """Set what ``set_…`` sets: xlabel, ylabel, xlim, ylim, xticks, yticks, aspect, title."""
        for name, value in named.items():
            if name == "title":
                self.set_title(value)  # type: ignore[attr-defined]
            elif name in SETTINGS:
                self.plotted.calls.append((f"set_{name}", (value,), {}))
                self.plotted.settings[name] = value
            else:
                raise NeedsMatplotlib(f"a panel does not know {name}")

    def set_xticks(self, ticks: Any, labels: Any = None) -> None:
        """The places of the ticks, and what is written there."""
        self.set(xticks=[float(x) for x in ticks])
        if labels is not None:
            self.set(xticklabels=list(labels))


SETTINGS = {
    "xlabel", "ylabel", "xlim", "ylim", "xticks", "yticks", "xticklabels", "aspect", "xscale",
    "yscale",
}  # fmt: skip


class Scale:
    """From numbers on an axis to parts of its length, 0 to 1; linear or logarithmic."""

    def __init__(self, values: list[float], limits: Any, log: bool):
        self.log = log
        if limits is None:  # the range of the values, with a margin of a twentieth on both sides
            raw = [self._raw(v) for v in values if math.isfinite(v) and (v > 0 or not log)]
            first, last = min(raw, default=self._raw(0.1)), max(raw, default=self._raw(1.0))
            air = 0.05 * (last - first) or (not log and 0.05 * abs(first)) or 0.5
            limits = [10**x if log else x for x in (first - air, last + air)]
        self.low, self.high = map(float, limits)
        self._ends = self._raw(self.low), self._raw(self.high)

    def _raw(self, x):
        return math.log10(max(x, 1e-300)) if self.log else x

    def __call__(self, x: float) -> float:
        first, last = self._ends
        return (self._raw(x) - first) / ((last - first) or 1.0)

    def ticks(self, count: int) -> list[float]:
        """Round numbers on the axis, about ``count``."""
        first, last = self._ends
        if self.log:
            step = max(1, math.ceil((last - first) / max(count, 1)))
            start = math.ceil(first / step - 1e-9) * step
            return [10.0**n for n in range(start, math.floor(last + 1e-9) + 1, step)]
        rough = abs(last - first) / max(count, 1) or 1.0
        power = 10.0 ** math.floor(math.log10(rough))
        step = next(s * power for s in (1, 2, 2.5, 5, 10) if s * power >= rough * (1 - 1e-9))
        low, high = min(first, last), max(first, last)
        start, end = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        return [n * step for n in range(start, end + 1)]

    def text(self, x: float, step: float) -> str:
        """A number of :meth:`ticks` as it is written."""
        if self.log:
            return f"$10^{{{round(math.log10(x))}}}$"
        digits = max(0, math.ceil(-math.log10(abs(step) or 1) - 1e-9))
        if round(step * 10**digits, 6) % 1:
            digits += 1
        return f"{x + 0.0:.{digits}f}".replace("-", "−")
