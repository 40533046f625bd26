"""The catalogue: every problem's text, data and code, checked on reading: ``problem("4/16")`` is a
:class:`Problem`.
"""

from .model import Answer, CatalogueError, Chapter, Given, Givens, Problem, Symbol
from .reading import chapter, chapters, problem, problems, select
from .units import in_frame

__all__ = [
    "Answer", "CatalogueError", "Chapter", "Given", "Givens", "Problem", "Symbol",
    "chapter", "chapters", "in_frame", "problem", "problems", "select",
]  # fmt: skip
