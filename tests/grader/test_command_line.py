"""``python -m grader``: its help, its output, and errors in one sentence with exit code 2."""

import json
import shlex
import shutil
import time
import tomllib
from pathlib import Path

import pytest

from exercises.catalogue import problem
from grader.commands import COMMANDS, shared
from tests.exercises.kinds.test_specs import SPEC
from tests.grader.courses import command, ran, refused


@pytest.mark.parametrize("each", COMMANDS, ids=lambda each: each.name)
def test_every_command_has_help(each):
    out = ran(command(each.name, "--help"))
    assert each.name in command("--help")[1]
    assert all(option in out for p in each.params for option in p.opts if option[0] == "-")
    assert command(each.name, "-h") == (0, out)


def test_list_says_how_many_sheets_a_problem_has():
    lines = command("list", "8/5", "5/26")[1].splitlines()
    sheets = {words[0]: words[-1] for words in map(str.split, lines) if words}  # a title may go on
    assert (sheets["8/5"], sheets["5/26"]) == ("2.09e+03", "1")


def test_solve_takes_other_numbers_and_variants():
    solved = lambda *more: json.loads(command("solve", "4/16", "--json", *more)[1])["4/16"]
    book, other = solved(), solved("--given", "omega=0.9")
    assert other["a_D"]["value"] != book["a_D"]["value"]
    expected = problem("4/16").solve({**problem("4/16").book_values, "omega": 0.9})
    assert other["a_D"]["value"] == pytest.approx([float(x) for x in expected["a_D"]])
    one, again, two = (solved("--seed", n) for n in (1, 1, 2))
    assert one == again != two
    assert command("solve", "4/2", "--json", "--given", "tilt=0.5")[1].count("tilt") == 0


def test_prove_ends_with_0_if_all_holds_and_1_if_a_key_is_tampered_with(monkeypatch):
    assert "2 passed, 0 failed" in ran(command("prove", "4/16", "4/2", "--seeds", 2))
    code_of = problem("4/16").code
    original = code_of.solve
    tampered = lambda g: {**original(g), "v_D": original(g)["v_D"] * 1.0001}
    monkeypatch.setattr(code_of, "solve", tampered)
    from exercises.catalogue import variants

    variants._compiled.cache_clear()
    try:
        out = refused(command("prove", "4/16", "--seeds", 1), 1)
    finally:
        variants._compiled.cache_clear()
    assert "0 passed, 1 failed" in out
    assert "v_D: solve in floats and prove differ" in out


def test_prove_warns_of_mistakes_that_give_the_same_wrong_answer():
    out = ran(command("prove", "4/13", "--seeds", 2))
    words = "r_cross_omega and whole_omega_reversed give the same wrong omega"
    assert words in " ".join(out.split())


def test_new_prints_the_paths(tmp_path):
    spec, to = tmp_path / "ch02.yaml", tmp_path / "to"
    spec.write_text(SPEC)
    out = ran(command("new", "ch02", "--spec", spec, "--to", to, "--only", "2/1"))
    assert out.split() == [f"{to}/ch02/p01.yaml", f"{to}/ch02/p01.py"]


def test_figure_writes_pngs_and_contact_sheets(tmp_path):
    from PIL import Image

    ran(command("figure", "4/16", "4/17", "--sheet", "--to", tmp_path))
    assert [path.name for path in tmp_path.iterdir()] == ["ch04_sheet.png"]
    ran(command("figure", "4/16", "--to", tmp_path / "new"))
    assert (tmp_path / "new/4_16.png").read_bytes().startswith(b"\x89PNG")
    with Image.open(tmp_path / "ch04_sheet.png") as sheet:
        width, height = sheet.size
    assert width / height == pytest.approx(2 * 5.2 / 4, rel=0.01)


def test_figure_reports_what_is_hard_to_read(tmp_path, monkeypatch):
    """With 4/16 seen along one of its axes."""
    from newton_euler.drawing import Sketch

    seen = Sketch.__init__
    along_x = lambda self, *scene, **view: seen(self, *scene, **view | {"azimuth": 2})
    monkeypatch.setattr(Sketch, "__init__", along_x)
    out = ran(command("figure", "4/16", "--to", tmp_path))
    assert "4/16: the axes X and Z are seen on one line within" in out


WRONG = tomllib.loads(Path(__file__).with_name("wrong_uses.toml").read_text())


@pytest.mark.parametrize("line", WRONG)
def test_wrong_uses_end_with_2_and_a_sentence(line, tmp_path):
    (tmp_path / "file").write_text("'x")
    out = refused(command(*(a.replace("{tmp}", str(tmp_path)) for a in shlex.split(line))))
    assert " ".join(WRONG[line].split()) in out
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file"]


def test_grade_says_when_there_is_nothing_to_grade(fresh):
    shutil.rmtree(fresh.path / "submitted")
    out = ran(command("grade", "ch04", "--course", fresh.path))
    assert "Collect first: nbgrader collect ch04" in out.replace("\n", " ")


def test_running_without_a_cage_has_a_banner_an_exit_code_and_a_word_in_every_row(fresh):
    code, out = command("grade", "ch04", "--course", fresh.path, "--unsandboxed", "--force")
    assert code == 3
    output = " ".join(out.replace("│", " ").split())
    assert output.count("Students' code runs WITHOUT A CAGE, as you") == 2  # also below the table
    assert "UNSANDBOXED" in out
    rows = [line.split() for line in out.splitlines()]
    students = [row for row in rows if row and row[0] in fresh.roster()]
    assert len(students) == 6
    assert all("unsandboxed" in " ".join(row) for row in students)
    for student in ("ada", "mallory"):
        record = json.loads(fresh.record_path("ch04", student).read_text())
        assert record["sandbox"].startswith("unsandboxed")


def test_the_demo_can_be_run_again_in_its_folder(tmp_path, monkeypatch):
    from grader.demo import run as demo

    def stop(*_, **__):
        raise RuntimeError("far enough")

    monkeypatch.setattr(demo, "nbgrader_api", stop)
    for _ in range(2):
        with pytest.raises(RuntimeError, match="far enough"):
            command("demo", "--course", tmp_path / "d", "--problem", "4/1")
    assert (tmp_path / "d/nbgrader_config.py").read_text().count("Exchange.root") == 1


class Last:
    """Raises when it is deleted, where Python ignores the error."""

    def __del__(self):
        raise KeyboardInterrupt


def drawing():
    with shared.progress_bar() as bar:
        bar.advance(bar.add_task("drawing", total=2))
        Last()
        time.sleep(30)


def test_a_ctrl_c_that_python_ignores_comes_again():
    words = r"drawing: 1 of 2\. Running the command again starts over"
    with pytest.raises(shared.Stopped, match=words):
        drawing()
