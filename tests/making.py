"""Problems made from data and functions, for tests of what the catalogue does with them."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from exercises import problem

EMPTY = {
    "id": "7/28", "givens": {}, "symbols": {}, "mistakes": {}, "struck": {}, "checked": {},
    "figure": "", "text": "",
}  # fmt: skip


@pytest.fixture
def made():
    """A function that makes a problem of this code and these data."""

    def make(solve, prove=None, wrong=lambda g: {}, **data):
        p = replace(problem("4/16"), **{**EMPTY, **data})
        vars(p)["code"] = SimpleNamespace(solve=solve, prove=prove or solve, mistakes=wrong)
        return p

    return make
