"""A student's answer: how it is read, compared with the right one, and explained where it is wrong.

It holds no key. Notebooks of courses released before version 0.2 import ``expect`` and ``receipt``
from here; today they are in :mod:`newton_euler.classroom`.
"""

from .diagnosis import causes
from .receipts import expect, receipt
from .verdicts import NO_ANSWER, Judged, explain, judge
