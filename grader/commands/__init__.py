"""The commands of ``python -m grader``, in the order in which ``--help`` lists them."""

from .courses import build, demo, due, enrol, grade, personal, retry, take_in
from .exercises import diagnose, figure, new, prove, solution, solve
from .practice import practice
from .results import export, stats

COMMANDS = (
    solve, solution, prove, figure, diagnose, new, practice,
    build, enrol, due, personal, take_in, grade, retry, stats, export, demo,
)  # fmt: skip
