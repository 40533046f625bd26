"""Which internals of nbgrader the hooks replace, override and call: none of them is guaranteed, so
pyproject.toml caps nbgrader's version, and these tests say what a new one has changed.
"""

import inspect
import os
import re
from pathlib import Path

import nbgrader
import pytest
from nbgrader import api, utils
from nbgrader.converters import base
from nbgrader.coursedir import CourseDirectory
from nbgrader.exchange import default
from nbgrader.preprocessors import AssignLatePenalties, GetGrades

from grader.course.folder import newest_schema
from grader.nbgrader_hooks import patches

INTERNALS = {  # where it is, and the arguments that it takes
    "replaced": [
        (api, "get_alembic_version", ""),
        (base, "find_all_files", "path exclude"),
        (CourseDirectory, "get_existing_timestamp", "self dest_path"),
    ],
    "overridden": [
        (default.ExchangeCollect, "_path_to_record", "self path"),
        (default.ExchangeCollect, "copy_files", "self"),
        (default.ExchangeCollect, "do_copy", "self src dest log"),
        (default.ExchangeReleaseAssignment, "copy_files", "self"),
        (default.ExchangeReleaseFeedback, "copy_files", "self"),
        (default.ExchangeFetchAssignment, "copy_files", "self"),
        (GetGrades, "_get_comment", "self cell resources"),
    ],
    "called": [
        (default.ExchangeFetchAssignment, "do_copy", "self src dest"),
        (AssignLatePenalties, "init_plugin", "self"),
        (utils, "find_owner", "path"),
        (utils, "notebook_hash", "path unique_key secret notebook_id"),
        (utils, "parse_utc", "ts"),
    ],
}


def changed(owner, name, arguments):
    """A sentence about an internal of nbgrader that is not what the hooks expect, or ""."""
    place = f"{owner.__name__}.{name}"
    if not hasattr(owner, name):
        return f"nbgrader has no {place} any more; see where grader/ uses it"
    found = " ".join(inspect.signature(getattr(owner, name)).parameters)
    return "" if found == arguments else f"{place} of nbgrader takes ({found}), not ({arguments})"


@pytest.mark.parametrize("use", INTERNALS)
def test_nbgrader_has_the_internals_that_the_hooks_use(use):
    assert [why for entry in INTERNALS[use] if (why := changed(*entry))] == []


def test_a_changed_internal_is_named_in_a_sentence():
    assert changed(base, "gone", "path") == (
        "nbgrader has no nbgrader.converters.base.gone any more; see where grader/ uses it"
    )
    assert changed(base, "find_all_files", "path") == (
        "nbgrader.converters.base.find_all_files of nbgrader takes (path exclude), not (path)"
    )


def test_the_newest_schema_is_the_one_that_no_other_builds_on():
    folder = Path(nbgrader.__file__).parent / "alembic/versions"
    texts = "".join(path.read_text() for path in folder.glob("*.py"))
    made, earlier = (
        set(re.findall(rf"^{name} = '(\w+)'", texts, re.M))
        for name in ("revision", "down_revision")
    )
    assert made - earlier == {newest_schema()}


@pytest.fixture
def nbgrader_as_it_was(monkeypatch):
    monkeypatch.setattr(base, "find_all_files", base.find_all_files)
    monkeypatch.setattr(
        CourseDirectory, "get_existing_timestamp", CourseDirectory.get_existing_timestamp
    )


def test_the_replacements_are_where_nbgrader_calls_them(nbgrader_as_it_was, tmp_path):
    patches.read_regular_files_only()
    (tmp_path / "a.csv").write_text("1")
    (tmp_path / "timestamp.txt").write_text("soon")
    (tmp_path / "link.csv").symlink_to("/etc/passwd")
    os.mkfifo(tmp_path / "pipe.csv")
    found = {os.path.basename(f) for f in base.find_all_files(str(tmp_path), ["*.ipynb"])}
    assert found == {"a.csv", "timestamp.txt"}
    assert CourseDirectory().get_existing_timestamp(str(tmp_path)) is None
    patches.copy_only_nbgraders_own_files()
    assert base.find_all_files(str(tmp_path)) == [str(tmp_path / "timestamp.txt")]
