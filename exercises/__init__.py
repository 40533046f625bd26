"""The textbook's problems, ``chNN/pMM.yaml`` and ``pMM.py``. For instructors only."""

from .catalogue import Problem, chapters, problem, problems

__all__ = ["Problem", "chapters", "problem", "problems"]
