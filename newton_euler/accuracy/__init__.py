"""Speed charted against accuracy: measure what a method costs and how far it is off, and show which one to choose.

``python -m newton_euler.accuracy NAME`` measures a scene, the models of one, or a comparison then and there, and draws a chart; ``--help`` says more.
:mod:`.measure` has what all charts share. :mod:`.precision` measures methods of integration on a scene against :mod:`.reference`, :mod:`.comparisons`
the textbook's ways (:mod:`.rivals`) where nothing moves; :mod:`.charts` and :mod:`.maps` draw.
"""

from .measure import Measured, chart, front, relative_error, timed

__all__ = ["Measured", "chart", "front", "relative_error", "timed"]
