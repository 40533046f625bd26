"""Proofs run with their fifty digits."""

import pytest
from mpmath import mp

from exercises.catalogue.proofs import DIGITS


@pytest.fixture(autouse=True)
def fifty_digits():
    with mp.workdps(DIGITS):
        yield
