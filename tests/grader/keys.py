"""What no file of a student may contain: numbers and formulas of the key, texts of mistakes, the
secret.
"""

import re

from grader.assignment import problems_of
from newton_euler.algebra.scalars import to_plain
from newton_euler.algebra.vectors import Vector
from tests.grader.courses import released_sheet

WORDS = (
    "def solve", "solve(g", "prove(", "mistakes", ".course_secret", "BEGIN SOLUTION",
    "HIDDEN TESTS",
)  # fmt: skip


def numbers_of_key(p, values):
    """Every number of the key that could not be there by accident: six digits."""

    def flat(x):
        return (
            [y for part in x for y in flat(part)]
            if isinstance(x, (Vector, tuple, list))
            else [to_plain(x)]
        )

    return {
        f"{abs(float(x)):.6g}"
        for v in p.solve(values).values()
        for x in flat(v)
        if len(f"{abs(float(x)):.6g}".strip("0.")) >= 5
    }


def keys(course, student):
    problems = problems_of(released_sheet(course))
    values = course.values("ch04", student, problems)
    found = {p.id: numbers_of_key(p, values[p.id]) for p in problems if not p.symbolic}
    return {n for numbers in found.values() for n in numbers}


def formulas(p):
    return {
        str(f)
        for v in p.formulas().values()
        for f in (v if isinstance(v, (Vector, tuple)) else [v])
        if len(str(f)) > 8
    }


def secrets_in(text, course, student):
    """What of the key, the mistakes and the secret stands in a text."""
    everywhere = re.sub(r"[A-Za-z0-9+/=]{200,}", "", text)  # pictures
    secret = {*keys(course, student), *keys(course, "the book"), *WORDS, course.secret.hex()}
    for p in problems_of(released_sheet(course)):
        secret |= {*p.mistakes.values(), *(formulas(p) if p.symbolic else ())}
    return sorted(words for words in secret if words in everywhere)
