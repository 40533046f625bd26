"""Where notebooks of courses released before version 0.2 import ``expect`` and ``receipt`` from;
today: :mod:`newton_euler.classroom`.
"""

from .classroom import expect, receipt

__all__ = ["expect", "receipt"]
