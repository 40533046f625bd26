"""Sheets to be printed, each with a student's own numbers and figures, and keys for who marks
them.
"""

from .write import PaperError, Written, write_papers
