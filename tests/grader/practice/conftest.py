"""A practice file of six problems, made once."""

import pytest

from exercises.catalogue import select
from grader.practice import write_practice
from tests.once import once

PROBLEMS = "4/1", "4/2", "4/16", "2/18", "5/16", "8/8"


@pytest.fixture(scope="session")
def practice_file(tmp_path_factory):
    return _written(tmp_path_factory, "some", PROBLEMS, count=3)


@pytest.fixture(scope="session")
def hints_file(tmp_path_factory):
    return _written(tmp_path_factory, "hints", ["4/16"], count=2, help="hints")


@pytest.fixture(scope="session")
def checks_file(tmp_path_factory):
    return _written(tmp_path_factory, "checks", ["4/16"], count=2, help="check")


def _written(tmp_path_factory, name, problems, **options):
    file = f"{name}.practice"
    folder, refused = once(
        tmp_path_factory, name, lambda f: write_practice(f / file, select(problems), **options)
    )
    assert refused == []
    return folder / file
