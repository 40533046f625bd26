"""Only the regular files of a submission are read, within limits."""

import json
import os
import stat

import pytest

from grader.course import files, load_json, read_json, write_notebook
from grader.course.files import NotTaken, copy_regular, read_regular, write_text

LIMITS = (1000, 10_000)


@pytest.fixture
def submission(tmp_path):
    """A submission with everything in it that must not be followed, and one file that is fine."""
    (tmp_path / "secret").write_text("the secret")
    (tmp_path / "outside").mkdir()
    (tmp_path / "outside/neighbour.ipynb").write_text("the neighbour's work")
    own = tmp_path / "own"
    (own / "data").mkdir(parents=True)
    (own / "ch04.ipynb").write_text("{}")
    (own / "data/table.csv").write_text("1,2")
    (own / "link.txt").symlink_to(tmp_path / "secret")
    (own / "folder").symlink_to(tmp_path / "outside")
    os.mkfifo(own / "pipe")
    (own / "zero").symlink_to("/dev/zero")
    (own / "large").write_bytes(b"x" * 1001)
    return own


def test_only_regular_files_of_the_submission_itself_are_copied(submission, tmp_path):
    left_out = copy_regular(submission, tmp_path / "copy", *LIMITS)
    copied = [p for p in (tmp_path / "copy").rglob("*") if p.is_file()]
    assert {p.name for p in copied} == {"ch04.ipynb", "table.csv"}
    assert {stat.S_IMODE(p.stat().st_mode) for p in copied} == {0o600}
    assert set(left_out) == {"link.txt", "folder", "pipe", "zero", "large"}
    assert "a link" in left_out["link.txt"]
    assert left_out["pipe"] == "it is not a regular file"
    assert not (tmp_path / "copy/folder").exists()


def test_many_deep_and_large_files_have_limits(tmp_path):
    deep = tmp_path / "own" / "/".join("d" * 50)
    deep.mkdir(parents=True)
    (deep / "file").write_text("x")
    for n in range(1100):
        (tmp_path / "own" / f"f{n}").write_text("x" * 9)
    copy_regular(tmp_path / "own", tmp_path / "copy", *LIMITS)
    assert len([p for p in (tmp_path / "copy").rglob("*") if p.is_file()]) == 1000
    (tmp_path / "large").mkdir()
    for n in range(20):
        (tmp_path / "large" / f"f{n}").write_bytes(b"x" * 900)
    copy_regular(tmp_path / "large", tmp_path / "some", *LIMITS)
    assert sum(p.stat().st_size for p in (tmp_path / "some").iterdir()) <= 10_000


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can give files away")
def test_a_hard_link_to_someone_elses_file_is_not_read(tmp_path):
    own = tmp_path / "own"
    own.mkdir()
    (tmp_path / "neighbours").write_text("x")
    os.chown(tmp_path / "neighbours", 4711, 4711)
    os.link(tmp_path / "neighbours", own / "ch04.ipynb")
    left_out = copy_regular(own, tmp_path / "copy", *LIMITS)
    assert left_out == {"ch04.ipynb": "its owner is not that of its folder"}


def test_a_folder_a_missing_file_and_a_device_are_not_read(tmp_path):
    for path in (tmp_path, tmp_path / "missing", "/dev/zero"):
        with pytest.raises(NotTaken):
            read_regular(path, 10)


def test_what_is_written_is_private_and_whole_or_not_at_all(tmp_path):
    (tmp_path / "kept.txt").write_text("before")
    with pytest.raises(UnicodeEncodeError):
        write_text(tmp_path / "kept.txt", "half a character: \ud800")
    assert [p.name for p in tmp_path.iterdir()] == ["kept.txt"]
    assert (tmp_path / "kept.txt").read_text() == "before"
    path = tmp_path / "file"
    path.write_text("old")
    path.chmod(0o666)
    (tmp_path / ".file.partial").symlink_to(tmp_path / "elsewhere")
    write_text(path, "new")
    assert (path.read_text(), stat.S_IMODE(path.stat().st_mode)) == ("new", 0o600)
    assert not (tmp_path / "elsewhere").exists()


TEXTS = {
    "plain": b'{"a": [1, 2.5, "\xc3\xa9"], "a": [2]}',
    "a byte-order mark": b'\xef\xbb\xbf{"a": 1}',
    "no number": b"[NaN]",
    "a large number": b"[123456789012345678901234567890e0]",
    "deep": b"[" * 900 + b"]" * 900,
}
BROKEN = {"empty": b"", "not JSON": b"# work", "cut": b'{"a"', "not UTF-8": b'["\xff"]'}


@pytest.fixture(params=["with orjson", "without"])
def library(request, monkeypatch):
    if request.param == "without":
        monkeypatch.setattr(files, "orjson", None)
    else:
        pytest.importorskip("orjson")


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_json_is_read_as_by_the_standard_library(library, text):
    assert repr(load_json(text)) == repr(json.loads(text.decode("utf-8-sig")))


def test_half_characters_are_replaced_in_names_too(library, tmp_path):
    """No file can hold them: one in the name of an attached picture stopped grading."""
    found = load_json(b'{"\\ud800": ["\\ud83d\\ude00", NaN, "\\\\udead"]}')
    assert repr(found) == "{'?': ['😀', nan, '\\\\udead']}"
    write_notebook(tmp_path / "a.ipynb", found)


@pytest.mark.parametrize("text", [*BROKEN.values(), b"[" * 100_000], ids=[*BROKEN, "too deep"])
def test_what_is_not_json_is_refused(library, text):
    with pytest.raises((ValueError, RecursionError)):
        load_json(text)


def test_a_notebook_is_written_and_read_back_readable_by_its_owner_alone(library, tmp_path):
    path = tmp_path / "new" / "a.ipynb"
    notebook = {"cells": [{"source": "v = 'é'\nω"}], "nbformat": 4, "metadata": {"large": 10**30}}
    write_notebook(path, notebook)
    read = read_json(path)
    assert read["cells"] == notebook["cells"]
    assert float(read["metadata"]["large"]) == 1e30  # an integer for the standard library only
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
