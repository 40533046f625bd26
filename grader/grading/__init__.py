"""Grades all submissions of an assignment at once and writes nbgrader's gradebook."""

from .gradebook import save_results, saved_points
from .run import Result, grade

__all__ = ["Result", "grade", "save_results", "saved_points"]
