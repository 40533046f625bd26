"""The commands of ``python -m grader``, in the order in which ``--help`` lists them."""

from .bank import bank
from .catalogue import preview, problems
from .courses import build, demo, due, enrol, grade, late, personal, retry, spec, take_in
from .exercises import diagnose, figure, new, prove, solution, solve
from .paper import paper
from .practice import practice
from .results import export, stats

COMMANDS = (
    problems, preview, solve, solution, prove, figure, diagnose, new, practice, paper, bank,
    build, spec, enrol, due, late, personal, take_in, grade, retry, stats, export, demo,
)  # fmt: skip
