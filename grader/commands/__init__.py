"""The commands of ``python -m grader``, in the order in which ``--help`` lists them."""

from .bank import bank
from .catalogue import preview, problems
from .ci import ci
from .courses import build, due, enrol, hub, late, next_year, share, spec
from .exercises import diagnose, figure, new, prove, solution, solve
from .paper import paper
from .practice import practice, sets
from .results import export, stats
from .work import demo, grade, personal, retry, take_in

COMMANDS = (
    problems, preview, solve, solution, prove, figure, diagnose, new, ci, practice, sets, paper,
    bank, build, spec, next_year, hub, share, enrol, due, late, personal, take_in, grade, retry,
    stats, export, demo,
)  # fmt: skip
