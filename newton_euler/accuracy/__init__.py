"""Speed against accuracy: the time that each method takes and the error that it makes, as charts.

``python -m newton_euler.accuracy NAME`` measures and draws one chart, see :mod:`.command`;
``python -m newton_euler.accuracy honesty`` draws whether the methods keep their word, measured by
:mod:`.honesty`.
Times, errors and fronts are in :mod:`.measure`. :mod:`.work_precision` measures the steppers on a
scene against the final states of :mod:`.reference`, :mod:`.comparisons` the engine against the
textbook methods of :mod:`.baselines`, :mod:`.regime_maps` the choices over parameter space.
:mod:`.charts` draws them, writes their captions, and shows them in a notebook.
"""

from .charts.axes import chart
from .charts.show import compare, show_chart
from .measure import Measured, front, relative_error, timed

__all__ = ["Measured", "chart", "compare", "front", "relative_error", "show_chart", "timed"]
