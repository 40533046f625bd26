"""Problems made from data and functions, for tests of what the catalogue does with them."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from exercises import problem
from exercises.catalogue import variants
from exercises.catalogue.following import earlier_answers

EMPTY = {
    "id": "7/28", "givens": {}, "symbols": {}, "mistakes": {}, "struck": {}, "checked": {},
    "figure": "", "text": "",
}  # fmt: skip


@pytest.fixture
def made(monkeypatch):
    """A function that makes a problem of this code and these data, found by its number."""

    def make(solve, prove=None, wrong=lambda g: {}, **data):
        p = replace(problem("4/16"), **{**EMPTY, **data})
        vars(p)["code"] = SimpleNamespace(solve=solve, prove=prove or solve, mistakes=wrong)
        monkeypatch.setattr(variants, "problem", lambda _: p)
        forget()
        return p

    yield make
    forget()


def forget():
    """Drop what is kept of problems by their number."""
    variants._compiled.cache_clear()
    earlier_answers.cache_clear()
