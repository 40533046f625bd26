"""Sheets for printing, each with a student's own numbers and figures, and keys for marking."""

from .markup import PaperError
from .write import WrittenPapers, write_papers
