"""Grading all submissions of an assignment at once, and writing nbgrader's gradebook."""

from .gradebook import Entry, instructors_cells, save
from .one import grade_one
from .run import grade
from .student import Result
