"""Speed against accuracy: the time that each method takes and the error that it makes, as charts.

``python -m newton_euler.accuracy NAME`` measures and draws one chart, see :mod:`.command`;
``python -m newton_euler.accuracy honesty`` draws how honest the methods are about their errors.
:mod:`.measurements` has what is measured: times, errors, fronts, honesty. :mod:`.charts` draws it
and writes the captions. :mod:`.catalogue` is the table of all charts, :mod:`.show` shows one in a
notebook, :mod:`.atlas` writes all of them on a page.
"""

from .charts.axes import chart
from .measurements.measure import Measured, front, relative_error, timed
from .show import compare, show_chart

__all__ = ["Measured", "chart", "compare", "front", "relative_error", "show_chart", "timed"]
