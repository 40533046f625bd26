"""Work from a zip archive of a learning platform: what belongs to whom, and what is left out."""

import json
import stat
import zipfile

import pytest

from grader.course import take_in
from grader.grading import grade
from tests.grader.courses import command, ran, refused, submit
from tests.grader.submissions import work

pytestmark = pytest.mark.integration


@pytest.fixture
def named(ungraded):
    """The demo's course, its students named as in a registrar's list."""
    ungraded.enrol([
        {"id": "ada", "first_name": "Ada", "last_name": "Lovelace", "lms_user_id": "4711"},
        {"id": "ben", "first_name": "Ben", "last_name": "Müller-Lüdenscheidt"},
        {"id": "cleo", "first_name": "Cléo", "last_name": "de Mérode"},
        {"id": "dan", "email": "daniel.g@uni.edu"},
    ])  # fmt: skip
    return ungraded


def archive(path, files):
    """A zip archive of {name: text, bytes or ZipInfo}."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as z:
        for name, content in files.items():
            z.writestr(name, content)
    return path


WORK = {
    "ada": "submissions/lovelaceada_LATE_4711_98765_ch04-1.ipynb",
    "ben": "Ben Müller-Lüdenscheidt_123_assignsubmission_file_/ch04.ipynb",
    "dan": "daniel.g@uni.edu/CH04.IPYNB",
}


def test_the_work_of_those_on_the_roster_is_taken_in_and_no_other(named, tmp_path):
    strangers = dict.fromkeys(("quinnzoe_99_100_ch04_ada.ipynb", "zoe/eve.ipynb"), "[]")
    files = {name: f'"{s}"' for s, name in WORK.items()}
    found = take_in(named, "ch04", archive(tmp_path / "w.zip", files | strangers))
    assert (found.taken, {name for name, _ in found.refused}) == (WORK, {*strangers})
    for student in WORK:
        path = named.path / "submitted" / student / "ch04/ch04.ipynb"
        assert path.read_text() == f'"{student}"'
        assert stat.S_IMODE(path.stat().st_mode) == 0o600
        assert not (path.parent / "timestamp.txt").exists()


def test_what_was_taken_in_is_graded(named, tmp_path):
    files = {f"{s}_1_ch04.ipynb": json.dumps(work(named, s)) for s in ("ada", "ben")}
    path = archive(tmp_path / "w.zip", files)
    out = ran(command("take-in", "ch04", path, "--course", named.path))
    assert "2 taken in, 0 kept as they were, 0 left out" in out
    assert {r.student: r.points for r in grade(named, "ch04")} == {"ada": 11, "ben": 11}


REFUSED = {
    "/etc/ada.ipynb": "leads out of the archive",
    "../../ada.ipynb": "leads out of the archive",
    "a/../../../ben/ch04.ipynb": "leads out of the archive",
    "..\\..\\ada.ipynb": "leads out of the archive",
    "C:/ada.ipynb": "leads out of the archive",
    "ada/solution.py": "not a notebook",
    "__MACOSX/ada/._ch04.ipynb": "not a notebook",
    "ada/.ipynb_checkpoints/ch04-checkpoint.ipynb": "not a notebook",
    "nobody/ch04.ipynb": "fits nobody on the roster",
    "ada/ben/ch04.ipynb": "fits several students: ada, ben",
    "adaptive/ch04.ipynb": "fits nobody on the roster",
}


@pytest.mark.parametrize("name", REFUSED)
def test_names_that_lead_elsewhere_or_fit_nobody_are_left_out_and_reported(named, tmp_path, name):
    before = sorted(p for p in tmp_path.rglob("*") if p.suffix != ".zip")
    path = archive(tmp_path / "w.zip", {name: "{}"})
    out = refused(command("take-in", "ch04", path, "--course", named.path), 1)
    assert REFUSED[name] in out
    after = sorted(p for p in tmp_path.rglob("*") if p.suffix != ".zip")
    assert [p for p in after if p not in before and "gradebook" not in p.name] == []


def test_an_unusable_name_loses_none_of_the_others(named, tmp_path):
    """Python's own zipfile stops at an empty one; matching the names of platforms took minutes."""
    long = f"{'_' * 60_000}.ipynb"
    path = archive(tmp_path / "w.zip", {"ada.ipynb": "{}", long: "{}", "n.txt": ""})
    raw = bytearray(path.read_bytes())
    at = raw.rindex(b"n.txt")
    # in the list of contents its name is turned into its comment
    raw[at - 18 : at - 12] = b"\0\0\0\0\5\0"
    path.write_bytes(raw)
    found = take_in(named, "ch04", path)
    assert {*found.taken} == {"ada"}
    assert found.refused == [
        (long, "its name has more than 500 characters"), ("", "not a notebook"),
    ]  # fmt: skip


@pytest.mark.parametrize(("method", "words"), [
    (zipfile.ZIP_BZIP2, "unusual method"), (zipfile.ZIP_LZMA, "unusual method"),
    (zipfile.ZIP_DEFLATED, "it is damaged"),
])  # fmt: skip
def test_a_bomb_costs_only_itself(named, tmp_path, method, words):
    path = archive(tmp_path / "w.zip", {"ada.ipynb": "{}"})
    with zipfile.ZipFile(path, "a", method) as z:
        z.writestr("ben.ipynb", b"[" * 2**20)
    raw = bytearray(path.read_bytes())
    place = raw.rfind(b"PK\1\2") + 24  # the size that the directory states: a lie
    raw[place : place + 4] = (5).to_bytes(4, "little")
    path.write_bytes(raw)
    found = take_in(named, "ch04", path)
    ((name, why),) = found.refused
    assert (name, words in why, {*found.taken}) == ("ben.ipynb", True, {"ada"})


def test_links_are_left_out_and_the_notebook_of_the_assignment_is_chosen(named, tmp_path):
    info = zipfile.ZipInfo("ada.ipynb")
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    path = archive(tmp_path / "w.zip", {info: "../../../.course_secret"})
    assert take_in(named, "ch04", path).refused == [("ada.ipynb", "a link or a special file")]
    assert not named.submissions("ch04")
    files = {"ben/ch04.ipynb": "{}", "ben/scratch.ipynb": "{}"}
    found = take_in(named, "ch04", archive(tmp_path / "w.zip", files))
    assert found.taken == {"ben": "ben/ch04.ipynb"}
    assert found.refused == [("ben/scratch.ipynb", "ben/ch04.ipynb was taken for ben")]


@pytest.mark.parametrize("packed", ["", "all of them/"])
def test_one_damaged_notebook_loses_none_of_the_others(named, tmp_path, packed):
    files = {f"{packed}{s}.ipynb": json.dumps({"of": s * 99}) for s in ("ada", "ben", "eve")}
    path = archive(tmp_path / "w.zip", files)
    raw = bytearray(path.read_bytes())
    place = raw.find(f"{packed}ben.ipynb".encode()) + len(f"{packed}ben.ipynb")
    raw[place : place + 12] = b"\xff" * 12
    path.write_bytes(raw)
    found = take_in(named, "ch04", path)
    assert set(found.taken) == {"ada", "eve"}
    ((name, why),) = found.refused
    assert (name, "it is damaged" in why) == (f"{packed}ben.ipynb", True)


@pytest.mark.parametrize(("length", "hidden"), [(55, 1), (127, 2)])
def test_what_a_damaged_list_of_contents_hides_is_reported(named, tmp_path, length, hidden):
    path = archive(tmp_path / "w.zip", {f"{s}.ipynb": '"x"' for s in ("ada", "ben", "dan")})
    raw = bytearray(path.read_bytes())
    raw[raw.index(b"PK\x01\x02") + 32] = length  # of the comment on the first entry
    path.write_bytes(raw)
    found = take_in(named, "ch04", path)
    ((name, why),) = found.refused
    assert (name, f"hides {hidden} more" in why, len(found.taken)) == ("w.zip", True, 3 - hidden)


def test_work_that_cannot_be_written_loses_none_of_the_others(named, tmp_path):
    (named.path / "submitted").mkdir(exist_ok=True)
    (named.path / "submitted/ben").write_text("a file where a folder belongs")
    path = archive(tmp_path / "w.zip", {f"{s}.ipynb": "{}" for s in ("ada", "ben", "eve")})
    found = take_in(named, "ch04", path)
    assert set(found.taken) == {"ada", "eve"}
    assert "cannot be written" in found.refused[0][1]


def test_existing_work_is_kept_unless_it_is_to_be_replaced(named, tmp_path):
    submit(named, "ada", "mine")
    (named.path / "submitted/ada/ch04/timestamp.txt").write_text("2026-01-01 10:00:00 UTC")
    path = archive(tmp_path / "w.zip", {"ada.ipynb": "{}"})
    assert take_in(named, "ch04", path).kept == [("ada", "ada.ipynb")]
    assert named.submissions("ch04")["ada"].read_text() == "mine"
    assert take_in(named, "ch04", path, replace=True, times=True).taken == {"ada": "ada.ipynb"}
    assert named.submissions("ch04")["ada"].read_text() == "{}"
    assert "2026-01-01" not in (named.path / "submitted/ada/ch04/timestamp.txt").read_text()


def test_a_name_of_thousands_of_letters_is_shown_by_its_ends(named, tmp_path):
    path = archive(tmp_path / "w.zip", {f"start{'x' * 60_000}end.ipynb": "{}", "ada.ipynb": "{}"})
    code, out = command("take-in", "ch04", path, "--course", named.path)
    assert (code, "start" in out, len(out) < 3000) == (1, True, True)
    assert "end.ipynb" in "".join(out.split())


@pytest.mark.parametrize("content", [b"", b"not a zip", b"PK\3\4 damaged"])
def test_what_is_not_an_archive_is_refused(named, tmp_path, content):
    (tmp_path / "w.zip").write_bytes(content)
    out = refused(command("take-in", "ch04", tmp_path / "w.zip", "--course", named.path))
    assert "is not a zip archive that can be read" in out
