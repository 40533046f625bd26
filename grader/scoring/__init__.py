"""Compares answers with the key: points for each answer, and the known mistake that explains a
wrong one.
"""

from newton_euler.answers import NO_ANSWER

from .score import Part, Score, score_receipt
from .sheet import ScoreError

__all__ = ["NO_ANSWER", "Part", "Score", "ScoreError", "score_receipt"]
