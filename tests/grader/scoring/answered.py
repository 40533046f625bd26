"""A student's answers in chapter 4 as a receipt holds them, and their scores."""

from exercises.catalogue import problems
from exercises.catalogue.variants import draw
from grader.scoring.score import score_receipt
from newton_euler.answers.receipts import record

CH04 = problems("ch04")
VALUES = {p.id: draw(p, b"tests of score") for p in CH04}


def trees(p, answers):
    """Answers as a receipt holds them."""
    forms = {a.key: a.form for a in p.answers}
    found, faults = record(forms, {n: s.unit for n, s in p.symbols.items()}, answers)
    assert not faults, faults
    return found


def right_trees(p, values):
    """The right answers for these numbers, as a receipt holds them."""
    return trees(p, p.solve({**p.sympy_symbols(), **values}))


def plain(components):
    """An answer as it is handed in: a number, or a list of them."""
    return list(map(float, components)) if len(components) > 1 else float(components[0])


def key(p):
    """The right answers for the student's numbers."""
    return right_trees(p, VALUES[p.id])


def texts(part):
    """The words of each cause that a part names."""
    return [cause.text for cause in part.causes]


def judged(p, answers, values=None):
    """{key: Part} of these answers."""
    values = VALUES[p.id] if values is None else values
    score = score_receipt(p, values, {"answers": answers})
    return {part.key: part for part in score.parts}
