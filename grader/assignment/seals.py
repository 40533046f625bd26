"""Seals of the right answers in a student's own copy, at the instructor's choice."""

from newton_euler.answers.seals import seal

from ..scoring.numbers import numbers_of
from .cells import Notebook, SheetValues, own_metadata
from .sheet import tasks


def with_seals(notebook: Notebook, values: SheetValues, unless_set: bool = True) -> Notebook:
    """A student's copy with seals of the right answers in its cells of numbers, for problems with
    help level "check" or more; ``unless_set``: and those without a level.
    """
    cells = []
    asked = {
        name: task
        for name, task in tasks(notebook).items()
        if (unless_set if task.help is None else task.help != "none")
    }
    for cell in notebook["cells"]:
        own = own_metadata(cell)
        number = own.get("problem")
        if own.get("role") == "givens" and number in values and number in asked:
            p, forms = asked[number].exercise, asked[number].asked
            numbers = numbers_of(p, values[number])
            # no seal for answers whose form on the sheet is not today's
            same = [a for a in p.answers if forms is None or forms.get(a.key) == str(a.form)]
            seals = {a.key: _seal(a, numbers) for a in same}
            names = "".join(f", {n}={n}" for n in p.givens)
            line = f'given("{p.id}", sealed={seals!r}{names})'
            cell = {**cell, "source": f"{cell['source']}\n{line}"}
        cells.append(cell)
    return {**notebook, "cells": cells}


def _seal(answer, numbers):
    key = numbers.key[answer.key]
    if answer.kind.is_word:
        return seal(answer.kind, key[0][0])
    if not answer.kind.is_formula:
        return seal(answer.kind, key[0], rtol=answer.rtol)
    n = next(n for n, point in enumerate(key) if all(x == x for x in point))
    at = {name: float(points[n]) for name, points in numbers.symbols.items()}
    return seal(answer.kind, key[n], at)
