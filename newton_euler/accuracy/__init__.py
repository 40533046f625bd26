"""Speed against accuracy: the time that each method takes and the error that it makes, as charts.

``python -m newton_euler.accuracy NAME`` measures and draws one chart, see :mod:`.command`;
``python -m newton_euler.accuracy honesty`` draws whether the methods keep their word, measured by
:mod:`.honesty`.
Times, errors and the chart itself are in :mod:`.measure`. :mod:`.work_precision` measures the
steppers on a scene against the final states of :mod:`.reference`, and :mod:`.comparisons` the
engine against the textbook methods of :mod:`.baselines`. :mod:`.plots` draws methods and models,
:mod:`.regime_maps` maps of parameter space.
"""

from .measure import Measured, chart, front, relative_error, timed

__all__ = ["Measured", "chart", "front", "relative_error", "timed"]
