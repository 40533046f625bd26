"""The textbook's problems: text and data in ``chNN/problems.yaml``, what they compute in ``chNN/pNN.py``. Stays with the instructor."""

from .catalogue import Problem, chapters, problem, problems

__all__ = ["Problem", "chapters", "problem", "problems"]
