"""Charts of speed against accuracy, by ``python -m newton_euler.accuracy NAME`` (:mod:`.command`).
:mod:`.measurements` has what is measured; :mod:`.charts` draws it and writes the captions.
:mod:`.catalogue` is the table of all charts; :mod:`.show` shows one in a notebook, :mod:`.atlas`
all of them on a page.
"""

from .charts.axes import chart
from .measurements.measure import Measured, front, relative_error, timed
from .show import compare, show_chart

__all__ = ["Measured", "chart", "compare", "front", "relative_error", "show_chart", "timed"]
