"""What no file of a student may contain: numbers and formulas of the key, texts of mistakes, the
secret.
"""

import re

from exercises.catalogue.variants import flat
from grader.assignment import problems_of
from newton_euler.algebra.scalars import to_plain
from tests.grader.courses import released_sheet

WORDS = (
    "def solve", "solve(g", "prove(", "mistakes", ".course_secret", "BEGIN SOLUTION",
    "HIDDEN TESTS",
)  # fmt: skip


def numbers_of_key(p, values):
    """Every number of the key that could not be there by accident: six digits."""
    numbers = {f"{abs(float(to_plain(x))):.6g}" for v in p.solve(values).values() for x in flat(v)}
    return {n for n in numbers if len(n.strip("0.")) >= 5}


def keys(course, student):
    problems = problems_of(released_sheet(course))
    values = course.values("ch04", student, problems)
    found = {p.id: numbers_of_key(p, values[p.id]) for p in problems if not p.symbolic}
    return {n for numbers in found.values() for n in numbers}


def formulas(p):
    return {str(f) for v in p.formulas().values() for f in flat(v) if len(str(f)) > 8}


def secrets_in(text, course, student):
    """The parts of the key, the mistakes and the secret that a text contains."""
    everywhere = re.sub(r"[A-Za-z0-9+/=]{200,}", "", text)  # pictures
    secret = {*keys(course, student), *keys(course, "the book"), *WORDS, course.secret.hex()}
    for p in problems_of(released_sheet(course)):
        secret |= {*p.mistakes.values(), *(formulas(p) if p.symbolic else ())}
    return sorted(words for words in secret if words in everywhere)
