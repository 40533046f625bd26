"""The table of all charts."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial

from ..algebra.errors import ArgumentError
from ..algebra.late import Figure
from ..scenes import LADDERS, SCENES, ladder
from .charts.comparisons import comparison_caption, draw_comparison, points_table
from .charts.drawn import DrawnChart
from .charts.maps import draw_choices, map_caption, map_table, without_noise
from .charts.methods import draw_methods, methods_caption
from .charts.models import draw_models, measured_models, models_caption
from .measurements.comparisons import COMPARISONS
from .measurements.regime_maps import MAPS
from .measurements.work_precision import LONGEST, NAMES, TOLERANCES, work_precision

MODELS, MAP = "models of ", "map of "
METHOD, MODEL, FORMULA = "Which method?", "Which model?", "Which formula?"
BORDER, FAILURE = "Where does it change?", "When does it fail?"
QUICK, QUICK_LONGEST = (1e-3, 1e-6, 1e-9, 1e-12), 0.02  # seconds
# one or two methods of each kind
QUICK_METHODS = (
    *("exact", "taylor", "dop853", "scipy DOP853"),
    *("verlet", "yoshida6", "lie-poisson2", "lie-poisson6", "auto"),
)
ONLY_SOME = " To be quick, only these methods were measured; quick=False measures all."


@dataclass(frozen=True)
class Chart:
    """An entry of the table: ``kind`` is its heading in a list of all charts, ``question`` as
    :data:`METHOD`; ``make(quick, progress)`` measures, and returns a :class:`.drawn.DrawnChart`.
    """

    name: str
    title: str
    kind: str
    question: str
    make: Callable


KINDS = (
    "scenes that move, by section",
    "models of a scene",
    "comparisons where nothing moves",
    "maps of parameter space",
)


@cache
def charts() -> dict:
    """All charts by name."""
    return {chart.name: chart for chart in _table()}


def _table():
    scenes, models, comparisons, maps = KINDS
    for s in SCENES.values():
        title = f"{s.section:>6}  {s.description}"
        yield Chart(s.name, title, scenes, METHOD, partial(_scene, s.name))
    for name, found in LADDERS.items():
        make = partial(_models, name)
        yield Chart(f"{MODELS}{name}", found.description, models, MODEL, make)
    for c in COMPARISONS.values():
        question = FAILURE if c.fails else FORMULA
        yield Chart(c.name, c.title, comparisons, question, partial(_comparison, c.name))
    for m in MAPS.values():
        question = FAILURE if m.fails else BORDER
        yield Chart(f"{MAP}{m.name}", m.title, maps, question, partial(_map, m.name))


def slug(name: str) -> str:
    """A name as it is in a file's."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def chart_named(name: str) -> Chart:
    """The chart of this name (hyphens may stand for blanks); :class:`ArgumentError` lists all."""
    known = {slug(n): chart for n, chart in charts().items()}
    if not isinstance(name, str) or slug(name) not in known:
        raise ArgumentError(f"there is no chart {name!r}; there are {'; '.join(charts())}")
    return known[slug(name)]


def _scene(name, quick, progress):
    asked = (QUICK, QUICK_METHODS, QUICK_LONGEST) if quick else (TOLERANCES, NAMES, LONGEST)
    found = work_precision(name, *asked, progress)
    figure, title = Figure(), f"methods of integration on {name}, {found.scene.description}"
    draw_methods(found, figure)
    caption = methods_caption(found) + (ONLY_SOME if quick else "")
    return DrawnChart(title, found.points, caption, found.explain(), figure)


def _models(name, quick, progress, tolerance=None):
    rungs, figure = ladder(name), Figure()
    points = measured_models(rungs, progress)
    draw_models(points, rungs, figure, tolerance)
    caption, title = models_caption(points, rungs, tolerance), f"models of {name}"
    table = points_table(points, rungs.of, "operations", "")
    return DrawnChart(title, tuple(points), caption, table, figure)


def _comparison(name, quick, progress):
    comparison, figure = COMPARISONS[name], Figure()
    points = comparison.measure(progress, quick)
    draw_comparison(comparison, points, figure)
    caption = comparison_caption(comparison, points)
    return DrawnChart(comparison.title, tuple(points), caption, points_table(points), figure)


def _map(name, quick, progress):
    chart, figure = MAPS[name], Figure()
    found, smoothed = chart.measure(chart.coarse if quick else None, progress), 0
    if chart.timed:
        found, smoothed = without_noise(chart, found)
    figure.set(layout_engine="constrained", size_inches=(10.0, 5.2))
    draw_choices(chart, found, figure.subplots())
    caption, table = map_caption(chart, found, smoothed), map_table(chart, found)
    return DrawnChart(chart.title, tuple(map(tuple, found)), caption, table, figure)
