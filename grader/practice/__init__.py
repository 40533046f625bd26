"""The practice file of a chapter: problems with several sets of numbers, keys, steps, wrong models
and worked solutions, for students, who have only the engine.
"""

from .build import HELP, LeftOut, PracticeError, write_practice
from .graded import graded_numbers, rules_of
from .measure import practice_shares
from .public import write_public

__all__ = [
    "HELP", "LeftOut", "PracticeError", "graded_numbers", "practice_shares", "rules_of",
    "write_practice", "write_public",
]  # fmt: skip
