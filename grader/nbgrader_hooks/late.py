"""The late policy that ``python -m grader late`` sets: a share of the points for each day begun."""

from math import ceil

from nbgrader.plugins import LateSubmissionPlugin
from traitlets import Float

DAY = 86_400  # seconds


class LatePolicy(LateSubmissionPlugin):
    """Takes ``share_per_day`` of the points for each day begun, at most all of them."""

    share_per_day = Float(0.0, min=0.0, max=1.0).tag(config=True)

    def late_submission_penalty(
        self, student_id: str, score: float, total_seconds_late: float
    ) -> float:
        return score * min(1.0, self.share_per_day * ceil(total_seconds_late / DAY))
