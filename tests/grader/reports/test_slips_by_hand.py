"""Wrong answers as students make them, in slips_by_hand.yaml, are named in words that say what was
done.
"""

import math
import re
from pathlib import Path

import pytest
import sympy
import yaml

from exercises.catalogue import problem
from exercises.catalogue.variants import draw
from grader.scoring import score_receipt
from newton_euler.answers.receipts import record

ROWS = yaml.safe_load(Path(__file__).with_name("slips_by_hand.yaml").read_text())
NAMES = ["sin", "cos", "atan", "acos", "asin", "sqrt", "exp", "pi"]
NUMBERS = {n: getattr(math, n) for n in (*NAMES, "hypot", "radians", "degrees")}
SYMBOLS = {n: getattr(sympy, n) for n in NAMES}
SILENT = 10  # of all parts: nothing finds them, as a normal of length other than 1, or a guess


def evaluated(p, values, let):
    names = {**(SYMBOLS if p.symbols else NUMBERS), "abs": abs, **values, **p.sympy_symbols()}
    waiting = dict(let)
    while waiting:
        name, text = waiting.popitem()
        try:
            names[name] = eval(str(text), {}, names)
        except NameError:
            waiting = {name: text, **waiting}  # after the others
    return names


def as_written(x):
    if isinstance(x, list):
        return [as_written(y) for y in x]
    return float(f"{x:.5g}") if isinstance(x, float) else x


def handed_in(entry):
    """(answer, what was done, words of the diagnosis, the part as it is scored) of each row."""
    p = problem(entry["problem"])
    values = draw(p, b"by hand") if p.givens else {}
    names = evaluated(p, values, entry.get("let", {}))
    right = p.solve({**p.sympy_symbols(), **values})
    for row in entry["rows"]:
        wrong = {k: x for k, x in row.items() if k != "did" and not k.endswith("says")}
        made = {k: as_written(eval(str(x), {}, names)) for k, x in wrong.items()}
        forms = {a.key: a.form for a in p.answers}
        trees, faults = record(forms, {n: s.unit for n, s in p.symbols.items()}, {**right, **made})
        assert not faults
        for part in score_receipt(p, values, {"answers": trees}).parts:
            if part.key in wrong:
                yield row["did"], row.get(f"{part.key} says", row["says"]), part


@pytest.fixture(scope="module")
def parts():
    return {entry["problem"]: list(handed_in(entry)) for entry in ROWS}


def is_silent(part):
    return all(c.is_observation for c in part.causes)


@pytest.mark.parametrize("name", [entry["problem"] for entry in ROWS])
def test_the_mistake_named_is_the_one_that_was_made(name, parts):
    for did, says, part in parts[name]:
        assert part.verdict == "wrong"
        assert is_silent(part) or re.search(says, part.message), (did, part.message)


def test_few_stay_unnamed(parts):
    every = [part for rows in parts.values() for _, _, part in rows]
    assert len(every) > 100
    assert sum(map(is_silent, every)) <= SILENT
