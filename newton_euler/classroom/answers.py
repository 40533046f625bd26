"""Where notebooks of courses released before version 0.3 import ``expect`` and ``receipt`` from;
today: :mod:`newton_euler.classroom`.
"""

from ..answers.receipts import expect, receipt

__all__ = ["expect", "receipt"]
