"""The examples in the docstrings of the grader and of the catalogue run."""

import doctest
import importlib
import re
from pathlib import Path

import pytest

import grader

ROOT = Path(grader.__file__).parents[1]
FILES = [*(ROOT / "grader").rglob("*.py"), *(ROOT / "exercises/catalogue").rglob("*.py")]
MODULES = [
    ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for path in FILES
    if re.search(r"(?m)^ *>>> ", path.read_text(encoding="utf-8"))
]


@pytest.mark.parametrize("name", MODULES)
def test_the_examples_of_a_module_run(name):
    found = doctest.testmod(importlib.import_module(name))
    assert found.attempted > found.failed == 0
