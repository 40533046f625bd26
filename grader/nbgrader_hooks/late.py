"""The late policy of ``python -m grader late``: a share of the points per day begun."""

from math import ceil

from nbgrader.plugins import LateSubmissionPlugin
from traitlets import Float

DAY = 86_400  # seconds


class LatePolicy(LateSubmissionPlugin):
    """Subtracts ``share_per_day`` of the points per day begun, at most all of them."""

    share_per_day = Float(0.0, min=0.0, max=1.0).tag(config=True)

    def late_submission_penalty(
        self, student_id: str, score: float, total_seconds_late: float
    ) -> float:
        return score * min(1.0, self.share_per_day * ceil(total_seconds_late / DAY))
