"""Whether an answer is right, and which mistake explains a wrong one."""

from .diagnosis import causes
from .verdicts import NO_ANSWER, Judged, explain, judge
