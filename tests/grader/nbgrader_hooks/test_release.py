"""nbgrader's own steps take the source notebook; its release makes the personal copies."""

from exercises.catalogue import problem
from grader.submission import is_untouched
from tests.grader.courses import nbgrader, read, submit
from tests.grader.submissions import work

STUDENTS = ("ada", "ben", "cleo", "dan", "eve", "mallory")


def test_nbgraders_own_generate_validate_and_release_take_the_notebook_unchanged(ungraded):
    config = ungraded.path / "nbgrader_config.py"
    config.write_text(
        config.read_text() + f"\nc.Exchange.root = {str(ungraded.path / 'exchange')!r}\n"
    )
    (ungraded.path / "exchange").mkdir(mode=0o777)
    before = read(ungraded.source("ch04"))
    code, out = nbgrader("generate_assignment", "ch04", "--force", cwd=ungraded.path)
    assert code == 0, out
    assert "ERROR" not in out
    released = ungraded.released("ch04")
    assert [c["id"] for c in released["cells"]] == [c["id"] for c in before["cells"]]
    answers = [
        c
        for c in released["cells"]
        if c["metadata"].get("newton_euler", {}).get("role") == "answer"
    ]
    assert [
        is_untouched(problem(c["metadata"]["newton_euler"]["problem"]), c["source"])
        for c in answers
    ] == [True] * len(answers)
    submit(ungraded, "ada", work(ungraded, "ada"))
    code, out = nbgrader("validate", "submitted/ada/ch04/ch04.ipynb", cwd=ungraded.path)
    assert code == 0, out
    assert "Success! Your notebook passes all the tests." in out
    code, out = nbgrader("release_assignment", "ch04", cwd=ungraded.path)
    assert code == 0, out
    assert (ungraded.path / "exchange/mechanics/outbound/ch04/ch04.ipynb").exists()
    assert len(
        list((ungraded.path / "exchange/mechanics/outbound/.personal/ch04").iterdir())
    ) == len(STUDENTS)
