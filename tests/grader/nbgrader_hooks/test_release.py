"""nbgrader's own steps accept the source notebook; its release makes the personal copies."""

import shutil

import pytest

from exercises.catalogue import problem
from grader.assignment.notebook import starter
from grader.course import Course
from grader.submission.rebuild import is_untouched
from tests.grader.courses import append_config, command, nbgrader, ran, read, released_sheet, submit
from tests.grader.submissions import work


def test_nbgraders_own_generate_validate_and_release_take_the_notebook_unchanged(ungraded):
    append_config(ungraded, f"c.Exchange.root = {str(ungraded.path / 'exchange')!r}")
    (ungraded.path / "exchange").mkdir(mode=0o777)
    before = read(ungraded.source("ch04"))
    out = ran(nbgrader("generate_assignment", "ch04", "--force", cwd=ungraded.path))
    assert "ERROR" not in out
    released = released_sheet(ungraded)
    assert [c["id"] for c in released["cells"]] == [c["id"] for c in before["cells"]]
    for c in released["cells"]:
        own = c["metadata"].get("newton_euler", {})
        if own.get("role") == "answer":
            assert is_untouched(c, starter(problem(own["problem"])))
    submit(ungraded, "ada", work(ungraded, "ada"))
    out = ran(nbgrader("validate", "submitted/ada/ch04/ch04.ipynb", cwd=ungraded.path))
    assert "Success! Your notebook passes all the tests." in out
    ran(nbgrader("release_assignment", "ch04", cwd=ungraded.path))
    outbound = ungraded.path / "exchange/mechanics/outbound"
    assert (outbound / "ch04/ch04.ipynb").exists()
    assert len(list((outbound / ".personal/ch04").iterdir())) == 6


@pytest.mark.integration
def test_a_course_in_a_folder_of_any_name_is_fetched_from_after_it_was_moved(tmp_path):
    """Built, released, moved and renamed; a student fetches, submits, and is collected."""
    roster, exchange = tmp_path / "roster.csv", tmp_path / "exchange"
    roster.write_text("id\nada\n")
    place, moved = tmp_path / "Méca 2026", tmp_path / "elsewhere" / "Mécanique (old)"
    ran(command(
        "build", "ch04", "--course", place, "--students", roster, "--problem", "4/1",
        "--exchange", exchange,
    ))  # fmt: skip
    for step in ("generate_assignment", "release_assignment"):
        ran(nbgrader(step, "ch04", cwd=place, PYTHONPATH=""))
    moved.parent.mkdir()
    place.rename(moved)
    home = tmp_path / "home"
    home.mkdir()
    for file in (moved / "student").iterdir():
        shutil.copy(file, home)
    for step in ("fetch_assignment", "submit"):
        ran(nbgrader(step, "ch04", "--student=ada", cwd=home, PYTHONPATH=""))
    assert "The copy of **ada**" in (home / "ch04/ch04.ipynb").read_text()
    ran(nbgrader("collect", "ch04", cwd=moved, PYTHONPATH=""))
    assert list(Course(moved).submissions("ch04")) == ["ada"]
    ran(command("personal", "ch04", "--course", moved, "--exchange"))
