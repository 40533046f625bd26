"""Students fetch their own copy, with nothing of the grader installed."""

from grader.assignment import copy_to_exchange
from grader.assignment.fetch import who_submits
from tests.grader.courses import nbgrader, ran


def test_a_student_fetches_under_the_name_under_which_nbgrader_submits(monkeypatch):
    monkeypatch.setenv("USER", "somebody")
    monkeypatch.setenv("JUPYTERHUB_USER", "another")
    from nbgrader.utils import get_username

    assert who_submits("*") == who_submits("") == get_username()
    assert who_submits("ada") == "ada"


def fetch(course, exchange, student, home, *options):
    home.mkdir(exist_ok=True)
    config = (course.path / "student/nbgrader_config.py").read_text()
    here = "os.path.dirname(os.path.abspath(__file__))"
    (home / "nbgrader_config.py").write_text(
        config.replace(here, repr(str(course.path / "student")))
        + "\nimport importlib.util\n\nassert not any(map(importlib.util.find_spec, "
        "('grader', 'exercises')))\n"
    )
    given = f"--Exchange.root={exchange}", f"--student={student}", *options
    return nbgrader("fetch_assignment", "ch04", *given, cwd=home, PYTHONPATH="")


def test_fetching_brings_the_students_own_copy_and_never_overwrites_work(ungraded, tmp_path):
    exchange = tmp_path / "exchange"
    outbound = exchange / "mechanics/outbound/ch04"
    outbound.mkdir(parents=True)
    (outbound / "ch04.ipynb").write_text((ungraded.path / "release/ch04/ch04.ipynb").read_text())
    copy_to_exchange(
        ungraded, "ch04", outbound, {s: ungraded.personal_path("ch04", s) for s in ("ada", "ben")}
    )
    home = tmp_path / "home"
    ran(fetch(ungraded, exchange, "ada", home))
    path = home / "ch04/ch04.ipynb"
    assert path.read_text() == ungraded.personal_path("ch04", "ada").read_text()
    path.chmod(0o644)
    path.write_text("my work")
    assert fetch(ungraded, exchange, "ada", home)[0] != 0
    assert path.read_text() == "my work"
    ran(fetch(ungraded, exchange, "ada", home, "--replace"))
    assert path.read_text() == "my work"
    path.unlink()
    ran(fetch(ungraded, exchange, "ada", home, "--replace"))
    # not the numbers of the book
    assert path.read_text() == ungraded.personal_path("ch04", "ada").read_text()
    code, out = fetch(ungraded, exchange, "zoe", tmp_path / "zoe")
    assert code != 0
    assert "ch04 has no copy for 'zoe'. Ask the instructor to put you on the roster" in out
    plain = tmp_path / "plain"
    plain.mkdir()
    given = f"--Exchange.root={exchange}", "--course=mechanics"
    ran(nbgrader("fetch_assignment", "ch04", *given, cwd=plain, USER="ada"))
    assert "This copy has the numbers of the book" in (plain / "ch04/ch04.ipynb").read_text()
    assert not list((plain / "ch04").glob(".personal*"))
