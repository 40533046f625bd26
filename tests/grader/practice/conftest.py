"""A practice file of six problems, made once."""

import pytest

from exercises.catalogue import select
from grader.practice import write_practice

PROBLEMS = "4/1", "4/2", "4/16", "2/18", "5/16", "8/8"


@pytest.fixture(scope="session")
def practice_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("practice") / "some.practice"
    assert write_practice(path, select(PROBLEMS), count=3) == []
    return path


@pytest.fixture(scope="session")
def hints_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("practice") / "hints.practice"
    write_practice(path, select(["4/16"]), count=2, help="hints")
    return path


@pytest.fixture(scope="session")
def checks_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("practice") / "checks.practice"
    write_practice(path, select(["4/16"]), count=2, help="check")
    return path
