"""Charts of speed against accuracy: what is measured (:mod:`.measurements`), how it is drawn and
put into words (:mod:`.charts`), and the table of all charts (:mod:`.catalogue`).
"""

from ..algebra.names import guide as _guide
from .charts.axes import chart
from .measurements.measure import Measured, front, relative_error, timed
from .show import compare, show_chart

__all__ = ["Measured", "chart", "compare", "front", "relative_error", "show_chart", "timed"]

_guide(__name__)
