"""Fixtures of the tests of exercises."""

from tests.making import made as made
