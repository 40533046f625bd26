"""Fixtures shared by the tests of the harness."""

import pytest

import tests.honesty.families
import tests.honesty.holdout  # noqa: F401
from tests.honesty.cases import draw
from tests.honesty.references import reference
from tests.once import common


@pytest.fixture(scope="session")
def cache(tmp_path_factory):
    """The folder of reference solutions for this run."""
    return common(tmp_path_factory) / "references"


@pytest.fixture
def known(cache):
    """A function that draws a case and returns it with its reference."""

    def drawn(name, seed=0, number=0):
        case = draw(name, seed, number)
        return case, reference(case, cache)

    return drawn
