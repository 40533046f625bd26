"""The error that each number of an answer may have: the rule for right answers in a form that pages
and platforms can state.
"""

from exercises.catalogue.model import Answer
from newton_euler.answers.tolerance import Point

HALVINGS = 60


def margins(answer: Answer, key: Point) -> tuple[float, ...] | None:
    """The largest error of each component alone with which the answer is still right; None for an
    answer that is not judged by its components: a word, a formula, a direction of any length.

    A vector is judged by the size of its whole error, so with every component within its margin it
    may still be wrong, by up to the square root of three times what is accepted.
    """
    kind = answer.kind
    if kind.is_word or kind.is_formula or kind.many:
        return None
    return tuple(_margin(answer, key, n) for n in range(len(key)))


def _margin(answer, key, n):
    """The margin of one component, by bisection from an error that is too large."""

    def is_right(error):
        point = tuple(x + error * (m == n) for m, x in enumerate(key))
        return answer.kind.is_right((point,), (key,), answer.atol, answer.rtol)

    low, high = 0.0, sum(map(abs, key)) + answer.atol
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if is_right(middle) else (low, middle)
    return low
