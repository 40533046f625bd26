"""The commands of ``python -m grader``, in the order in which ``--help`` lists them."""

from .courses import build, demo, due, enrol, grade, late, personal, retry, take_in
from .exercises import diagnose, figure, list_problems, new, prove, solution, solve
from .paper import paper
from .practice import practice
from .results import export, stats

COMMANDS = (
    list_problems, solve, solution, prove, figure, diagnose, new, practice, paper,
    build, enrol, due, late, personal, take_in, grade, retry, stats, export, demo,
)  # fmt: skip
