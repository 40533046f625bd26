"""One chart in a notebook: one of the table by name, or a comparison of one's own."""

from collections.abc import Mapping, Sequence

from ..algebra.errors import ArgumentError, checked
from ..algebra.late import Figure
from ..algebra.scalars import Scalar
from .catalogue import MODEL, chart_named
from .charts.axes import chart
from .charts.comparisons import points_table, ways_caption
from .charts.drawn import DrawnChart
from .measurements.comparisons import measured_ways
from .measurements.measure import Call, silent


@checked
def show_chart(name: str, quick: bool = True, tolerance: float | None = None) -> DrawnChart:
    """Measure, draw and display the chart of this name; it has ``points`` and a ``caption``.

    name : as ``python -m newton_euler.accuracy --list`` prints it: "top", "models of top"
    quick : fewer tolerances and methods, coarse maps: a few seconds
    tolerance : of "models of ...", in the unit of the error; default in the middle of the errors

    >>> shot = show_chart("models of projectile", tolerance=1.0)  # doctest: +SKIP
    >>> shot.points[0].error > 1.0  # of the flat Earth, in metres  # doctest: +SKIP
    True
    """
    entry = chart_named(name)
    if tolerance is not None and not (entry.question == MODEL and tolerance > 0):
        raise ArgumentError(
            f"a tolerance is positive, for 'models of ...'; got {tolerance!r} for {name!r}"
        )
    more = {} if tolerance is None else {"tolerance": float(tolerance)}
    found = entry.make(quick, silent, **more)
    found.show()
    return found


@checked
def compare(
    ways: Mapping[str, Call], exact: Scalar | Sequence[Scalar], title: str = "ways to one result"
) -> DrawnChart:
    """Measure, draw and display cost and error of several ways to one result; the chart.

    ways : {name: a function without arguments}, which returns one number or several
    exact : the result in 20 digits (``mpmath.mpf``) or exact; errors are relative distances from it

    >>> import math, mpmath
    >>> ways = {"product": lambda: 1.1 * 1.1, "power": lambda: math.pow(1.1, 2)}
    >>> found = compare(ways, mpmath.mpf("1.21"), "the square of 1.1")  # doctest: +SKIP
    """
    points = measured_ways(ways, exact)
    figure = Figure(layout="constrained", figsize=(8.0, 4.2))
    ax = figure.subplots()
    chart(points, ax)
    ax.set_title(title, fontsize=11)
    found = DrawnChart(title, tuple(points), ways_caption(points), points_table(points), figure)
    found.show()
    return found
