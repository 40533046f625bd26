"""Sheets to be printed, each with a student's own numbers and figures, and keys for who marks
them.
"""

from .markup import PaperError
from .write import Written, write_papers
