"""Charts of speed against accuracy: what a method costs, how large its error is, and so which
method to choose.

``python -m newton_euler.accuracy NAME`` measures and draws one; ``--help`` says more.
:mod:`.measure` has what all charts share. :mod:`newton_euler.accuracy.work_precision` measures
methods of integration on a scene against :mod:`.reference`, :mod:`.comparisons` the engine against
textbook methods (:mod:`newton_euler.accuracy.baselines`) where nothing is integrated;
:mod:`newton_euler.accuracy.plots` and :mod:`newton_euler.accuracy.regime_maps` draw.
"""

from .measure import Measured, chart, front, relative_error, timed

__all__ = ["Measured", "chart", "front", "relative_error", "timed"]
