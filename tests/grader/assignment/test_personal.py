"""The assignment: taken by nbgrader unchanged, with numbers of its own for everyone, and without keys."""

import io
import json
import re
import zipfile

import pytest

from exercises.catalogue import problem
from grader.assignment import notebook as nb
from grader.assignment.fetch import personal_name
from grader.assignment.personal import copy_to_exchange, make_personal_copies
from grader.submission import is_untouched
from newton_euler.scalars import plain
from newton_euler.vectors import Vector
from tests.grader.courses import REPOSITORY, grader, nbgrader, read, run, submit
from tests.grader.nbgrader_hooks.test_preprocessors import work

STUDENTS = ("ada", "ben", "cleo", "dan", "eve", "mallory")


def numbers_of_key(p, values):
    """Every number of the key that could not be there by accident: six digits."""

    def flat(x):
        return [y for part in x for y in flat(part)] if isinstance(x, (Vector, tuple, list)) else [plain(x)]

    return {f"{abs(float(x)):.6g}" for v in p.solve(values).values() for x in flat(v) if len(f"{abs(float(x)):.6g}".strip("0.")) >= 5}


def keys(course, student):
    problems = nb.problems_of(course.released("ch04"))
    values = course.values("ch04", student, problems)
    found = {p.id: numbers_of_key(p, values[p.id]) for p in problems if not p.symbolic}
    return {n for numbers in found.values() for n in numbers}


def formulas(p):
    return {str(f) for v in p.formulas().values() for f in (v if isinstance(v, (Vector, tuple)) else [v]) if len(str(f)) > 8}


def holds_nothing_secret(text, course, student):
    everywhere = re.sub(r"[A-Za-z0-9+/=]{200,}", "", text)  # pictures
    assert not [n for n in keys(course, student) if n in everywhere]
    assert not [n for n in keys(course, "the book") if n in everywhere]
    for p in nb.problems_of(course.released("ch04")):
        if p.symbolic:
            assert not [f for f in formulas(p) if f in everywhere]
        assert not [text for text in p.mistakes.values() if text in everywhere]
    for words in ("def solve", "solve(g", "prove(", "mistakes", course.secret.hex(), ".course_secret", "BEGIN SOLUTION", "HIDDEN TESTS"):
        assert words not in everywhere, words


def test_nbgraders_own_generate_validate_and_release_take_the_notebook_unchanged(ungraded):
    config = ungraded.path / "nbgrader_config.py"
    config.write_text(config.read_text() + f"\nc.Exchange.root = {str(ungraded.path / 'exchange')!r}\n")
    (ungraded.path / "exchange").mkdir(mode=0o777)
    before = read(ungraded.source("ch04"))
    code, out = nbgrader("generate_assignment", "ch04", "--force", cwd=ungraded.path)
    assert code == 0, out
    assert "ERROR" not in out
    released = ungraded.released("ch04")
    assert [c["id"] for c in released["cells"]] == [c["id"] for c in before["cells"]]
    answers = [c for c in released["cells"] if c["metadata"].get("newton_euler", {}).get("role") == "answer"]
    assert [is_untouched(problem(c["metadata"]["newton_euler"]["problem"]), c["source"]) for c in answers] == [True] * len(answers)
    submit(ungraded, "ada", work(ungraded, "ada"))
    code, out = nbgrader("validate", "submitted/ada/ch04/ch04.ipynb", cwd=ungraded.path)
    assert code == 0, out
    assert "Success! Your notebook passes all the tests." in out
    code, out = nbgrader("release_assignment", "ch04", cwd=ungraded.path)
    assert code == 0, out
    assert (ungraded.path / "exchange/mechanics/outbound/ch04/ch04.ipynb").exists()
    assert len(list((ungraded.path / "exchange/mechanics/outbound/.personal/ch04").iterdir())) == len(STUDENTS)


@pytest.mark.slow
def test_validate_tells_a_student_what_cannot_be_read(fresh):
    submit(fresh, "dan", work(fresh, "dan", p4_16="alpha_CD = a_D = None\nv_D = [1, 2]"))
    _, out = nbgrader("validate", "submitted/dan/ch04/ch04.ipynb", cwd=fresh.path)
    assert "expected a vector, three numbers" in out, out


@pytest.mark.parametrize("student", STUDENTS)
def test_what_a_student_fetches_holds_no_key_and_nobody_elses_numbers(course, student):
    text = course.personal_path("ch04", student).read_text()
    holds_nothing_secret(text, course, student)
    own = {c["source"] for c in read(course.personal_path("ch04", student))["cells"]}
    for other in STUDENTS:
        others = {c["source"] for c in read(course.personal_path("ch04", other))["cells"] if c["metadata"]["newton_euler"].get("role") == "givens"}
        symbolic = {nb.givens(p, {}) for p in nb.problems_of(course.released("ch04")) if p.symbolic and not p.givens}
        assert other == student or not own & others - symbolic
    assert not any(c.get("outputs") for c in read(course.personal_path("ch04", student))["cells"])


def test_the_released_notebook_and_the_source_hold_no_key(course):
    for path in (course.source("ch04"), course.path / "release/ch04/ch04.ipynb"):
        text = re.sub("### (BEGIN|END) SOLUTION", "", path.read_text())
        holds_nothing_secret(text, course, "nobody")


@pytest.mark.parametrize("student", ["ada", "ben", "mallory"])
def test_the_feedback_page_holds_no_key_that_the_student_did_not_write(course, student):
    page = (course.path / "feedback" / student / "ch04/ch04.html").read_text()
    written = "".join(c["source"] for c in read(course.path / "submitted" / student / "ch04/ch04.ipynb")["cells"])
    secret = {n for n in keys(course, student) if n not in written and n not in re.sub(r"\d+\.\d{8,}", lambda m: f"{float(m[0]):.6g}", written)}
    plain_page = re.sub(r"[A-Za-z0-9+/=]{200,}", "", page)
    assert not [n for n in secret if n in plain_page]
    for words in ("def solve", "prove(", course.secret.hex(), "<script", "http://", "https://"):
        assert words not in plain_page


def test_statement_numbers_and_grading_agree_for_everyone(course):
    for student in STUDENTS:
        own = read(course.personal_path("ch04", student))
        values = course.values("ch04", student, nb.problems_of(own))
        assert nb.first_differing_problem(own, values) is None
        for cell in own["cells"]:
            ours = cell["metadata"]["newton_euler"]
            if ours.get("role") == "givens":
                space = {}
                exec("from sympy import symbols\n" + cell["source"], space)
                assert {n: space[n] for n in values[ours["problem"]]} == values[ours["problem"]]
            if ours.get("role") == "statement":
                p = problem(ours["problem"])
                for name in p.givens:
                    assert f"{nb.pretty(name)} = {nb.number(values[p.id][name])}" in cell["source"]
                assert len(cell["attachments"]["figure.png"]["image/png"]) > 1000


def test_figures_follow_the_numbers(course):
    def figures(student):
        return {
            c["id"]: c["attachments"]["figure.png"]["image/png"] for c in read(course.personal_path("ch04", student))["cells"] if "attachments" in c
        }

    ada, ben = figures("ada"), figures("ben")
    assert ada["statement-4-16"] != ben["statement-4-16"]
    assert ada["statement-4-2"] == ben["statement-4-2"]  # a formula is asked for: no numbers


def fetch(course, exchange, student, home, *options):
    home.mkdir(exist_ok=True)
    (home / "nbgrader_config.py").write_text(
        (course.path / "student/nbgrader_config.py")
        .read_text()
        .replace("os.path.dirname(os.path.abspath(__file__))", repr(str(course.path / "student")))
    )
    return run(
        "nbgrader",
        "fetch_assignment",
        "ch04",
        f"--Exchange.root={exchange}",
        *options,
        cwd=home,
        USER=student,
        JUPYTERHUB_USER=student,
        PYTHONPATH="",
    )


def test_fetching_brings_the_own_copy_and_never_overwrites_work(ungraded, tmp_path):
    exchange = tmp_path / "exchange"
    outbound = exchange / "mechanics/outbound/ch04"
    outbound.mkdir(parents=True)
    (outbound / "ch04.ipynb").write_text((ungraded.path / "release/ch04/ch04.ipynb").read_text())
    copy_to_exchange(ungraded, "ch04", outbound, {s: ungraded.personal_path("ch04", s) for s in ("ada", "ben")})
    home = tmp_path / "home"
    code, out = fetch(ungraded, exchange, "ada", home)
    assert code == 0, out
    path = home / "ch04/ch04.ipynb"
    assert path.read_text() == ungraded.personal_path("ch04", "ada").read_text()
    path.chmod(0o644)
    path.write_text("my work")
    code, out = fetch(ungraded, exchange, "ada", home)
    assert code != 0
    assert path.read_text() == "my work"
    code, out = fetch(ungraded, exchange, "ada", home, "--replace")
    assert (code, path.read_text()) == (0, "my work")
    path.unlink()
    code, out = fetch(ungraded, exchange, "ada", home, "--replace")
    assert code == 0, out
    assert path.read_text() == ungraded.personal_path("ch04", "ada").read_text()  # not the numbers of the book
    code, out = fetch(ungraded, exchange, "zoe", tmp_path / "zoe")
    assert code != 0
    assert "ch04 has no copy for 'zoe'. Ask the instructor to put you on the roster" in out
    plain = tmp_path / "plain"
    plain.mkdir()
    code, out = run("nbgrader", "fetch_assignment", "ch04", f"--Exchange.root={exchange}", "--course=mechanics", cwd=plain, USER="ada")
    assert code == 0, out
    text = (plain / "ch04/ch04.ipynb").read_text()
    assert "This copy has the numbers of the book" in text
    assert not list((plain / "ch04").glob(".personal*"))


def test_a_late_joiner_gets_a_copy_and_nobody_elses_changes(ungraded, tmp_path):
    before = ungraded.personal_path("ch04", "ada").read_text()
    outbound = tmp_path / "exchange/mechanics/outbound/ch04"
    outbound.mkdir(parents=True)
    config = ungraded.path / "nbgrader_config.py"
    config.write_text(config.read_text() + f"\nc.Exchange.root = {str(tmp_path / 'exchange')!r}\n")
    ungraded.enrol(["zoe"])
    code, out = grader("personal", "ch04", "--course", ungraded.path, "--student", "zoe", "--exchange")
    assert code == 0, out
    assert (outbound.parent / ".personal/ch04" / personal_name("mechanics", "ch04", "zoe") / "ch04.ipynb").exists()
    assert ungraded.personal_path("ch04", "ada").read_text() == before


def test_personal_copies_are_the_same_when_made_again(ungraded):
    before = ungraded.personal_path("ch04", "ada").read_text()
    make_personal_copies(ungraded, "ch04", ["ada"], workers=1)
    assert ungraded.personal_path("ch04", "ada").read_text() == before


@pytest.mark.slow
def test_the_wheel_holds_the_engine_and_no_exercise(tmp_path):
    code, out = run("pip", "wheel", "--no-deps", "--no-build-isolation", "-w", str(tmp_path), str(REPOSITORY), timeout=300)
    if code and "setuptools" in out:
        code, out = run("pip", "wheel", "--no-deps", "-w", str(tmp_path), str(REPOSITORY), timeout=300)
    assert code == 0, out
    (wheel,) = tmp_path.glob("*.whl")
    with zipfile.ZipFile(io.BytesIO(wheel.read_bytes())) as z:
        names = z.namelist()
        everything = "".join(z.read(n).decode("utf-8", "replace") for n in names if n.endswith((".py", ".yaml", ".json", ".ipynb")))
    assert "newton_euler/answers.py" in names
    assert not [n for n in names if n.startswith(("exercises", "grader", "tests", "problems", "book"))]
    assert not [n for n in names if n.endswith(".yaml")]
    assert "no_coriolis:" not in everything
    assert "coriolis_of_horizontal_nozzle" not in everything


def test_receipt_cells_ask_for_what_the_catalogue_asks_for(course):
    for cell in course.released("ch04")["cells"]:
        ours = cell["metadata"]["newton_euler"]
        if ours.get("role") == "receipt":
            assert cell["source"] == nb.receipt_cell(problem(ours["problem"]))
            assert cell["metadata"]["nbgrader"]["points"] == 0
            assert cell["metadata"]["nbgrader"]["locked"]
    assert json.dumps(course.released("ch04"))
