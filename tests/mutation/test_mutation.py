"""The mutation runner finds what a test misses, and does not touch the file."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.mutation.mutants import mutants

MODULE = '''\
"""A module."""


def larger(a, b):
    """The larger of two numbers."""
    if a < b:
        return b
    return a


def unused(a):
    return a + 1
'''
TESTS = """\
from small import larger


def test_the_larger_one_is_taken():
    assert larger(1, 2) == 2 and larger(2, 1) == 2
"""


def changed(text):
    return {str(m) for m in mutants(ast.parse(text))}


@pytest.mark.parametrize(("text", "change"), [
    ("x = a < b", "a < b  ->  a <= b"),
    ("x = a + b", "a + b  ->  a - b"),
    ("x = a and b", "a and b  ->  b"),
    ("x = not a", "not a  ->  a"),
    ("x = -a", "-a  ->  a"),
    ("x = 3", "3  ->  6"),
    ("x = min(a, b)", "min(a, b)  ->  max(a, b)"),
    ("x = abs(a)", "abs(a)  ->  a"),
    ("f()", "f()  ->  pass"),
    ("x = a if b else c", "a if b else c  ->  a if True else c"),
    ("def f():\n    return a", "return a  ->  return None"),
])  # fmt: skip
def test_each_kind_of_mistake_is_made(text, change):
    assert change in changed(text)


def test_one_change_is_made_in_a_copy_and_texts_are_left_as_they_are():
    assert changed('def f(a: int = x) -> 3:\n    """Text."""\n    f"{1 + 2}"\n') == set()
    tree = ast.parse("x = a + b\ny = a + b")
    first = min(mutants(tree), key=lambda m: (m.line, str(m) != "a + b  ->  a - b"))
    assert ast.unparse(first.applied(tree)) == "x = a - b\ny = a + b"
    assert ast.unparse(tree) == "x = a + b\ny = a + b"


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="forks need POSIX")
def test_what_must_be_killed_is_and_what_is_equivalent_survives(tmp_path):
    (tmp_path / "small.py").write_text(MODULE)
    (tmp_path / "test_small.py").write_text(TESTS)
    command = sys.executable, "-m", "tests.mutation", "small.py", "--tests", "test_small.py"
    where = {"cwd": tmp_path, "env": {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}}
    found = subprocess.run(command, capture_output=True, text=True, timeout=300, **where)
    assert found.returncode == 1, found.stderr
    lines = [line for line in found.stdout.splitlines() if line.startswith("small.py:")]
    assert lines == [
        "small.py:6: a < b  ->  a <= b",  # of equal numbers either is the larger
        "small.py:12: return a + 1  ->  return None  (no test runs it)",
        "small.py:12: a + 1  ->  a - 1  (no test runs it)",
        "small.py:12: 1  ->  2  (no test runs it)",
        "small.py:12: 1  ->  0  (no test runs it)",
    ]
    assert (tmp_path / "small.py").read_text() == MODULE
