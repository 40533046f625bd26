"""The catalogue of problems: ``problem("4/16")`` is a :class:`Problem`, checked on reading."""

from .model import Answer, CatalogueError, Chapter, Given, Givens, Problem, Symbol
from .reading import chapter, chapters, problem, problems, select
from .units import in_frame

__all__ = [
    "Answer", "CatalogueError", "Chapter", "Given", "Givens", "Problem", "Symbol",
    "chapter", "chapters", "in_frame", "problem", "problems", "select",
]  # fmt: skip
