"""The textbook's problems: text and data in ``chNN/pMM.yaml``, what they compute in ``pMM.py``
beside it. Stays with the instructor.
"""

from .catalogue import Problem, chapters, problem, problems

__all__ = ["Problem", "chapters", "problem", "problems"]
