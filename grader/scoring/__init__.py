"""Compares answers with the key: points for each answer, and the known mistake that explains a
wrong one.
"""

from .diagnosis import diagnose
from .score import NO_ANSWER, Part, Score, score_receipt

__all__ = ["NO_ANSWER", "Part", "Score", "diagnose", "score_receipt"]
