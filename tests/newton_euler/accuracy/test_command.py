"""The command: its list of charts, what it measures, prints and writes."""

import csv
import re
import subprocess
import sys
from pathlib import Path

import pytest

from newton_euler.accuracy.catalogue import charts
from newton_euler.accuracy.command import main
from newton_euler.accuracy.measurements import honesty as measuring
from newton_euler.accuracy.measurements.comparisons import COMPARISONS
from newton_euler.accuracy.measurements.honesty import COLUMNS
from newton_euler.accuracy.measurements.regime_maps import MAPS
from newton_euler.scenes import LADDERS, SCENES

ROOT = Path(__file__).parents[3]


def run(*arguments):
    """The exit code of the command."""
    with pytest.raises(SystemExit) as end:
        main(arguments, prog_name="python -m newton_euler.accuracy")
    return end.value.code


def test_the_command_lists_and_explains_all_charts_and_refuses_unknown_names(capsys, tmp_path):
    assert run("--list") == 0
    output = capsys.readouterr().out
    names = list(charts())
    assert len({re.sub("[^a-z]", "", n.lower()) for n in names}) == len(names)
    made = [f"models of {n}" for n in LADDERS] + [f"map of {n}" for n in MAPS]
    assert set(names) == {*SCENES, *COMPARISONS, *made}
    assert all(f"  {name} " in output for name in names)
    assert run("honesty", "--help") == 0
    output = capsys.readouterr().out
    assert all(word in output for word in ("met %", "covers %", "est/true", "ring", "cross"))
    assert run("--list") == 0
    assert "honesty --help" in capsys.readouterr().out
    assert run("top", "topp", "--out", str(tmp_path)) == 2
    output = capsys.readouterr()
    assert "no chart 'topp'. Did you mean 'top'?" in output.err
    assert "models of projectile" in output.err
    assert not list(tmp_path.iterdir())
    assert run("pendulum of Foucault", "--models") == 2
    assert "no chart 'pendulum of Foucault'" in capsys.readouterr().err


@pytest.mark.parametrize(("name", "file", "words"), [
    ("Sphere-on-an-incline", "sphere-on-an-incline.svg", "time"),
    ("models of projectile", "models-of-projectile.svg", "operations"),
    ("map of steady precession", "map-of-steady-precession.svg", "none: it nutates"),
])  # fmt: skip
def test_the_command_measures_prints_and_writes(name, file, words, capsys, tmp_path):
    assert run(name, "--quick", "--format", "svg", "--out", str(tmp_path / "new")) == 0
    output = capsys.readouterr()
    assert f"written: {tmp_path / 'new' / file}" in output.out
    assert words in output.out
    assert not output.err  # progress is for terminals
    assert (tmp_path / "new" / file).read_text().lstrip().startswith("<?xml")


def test_the_module_runs_as_a_program():
    program = sys.executable, "-W", "error", "-m", "newton_euler.accuracy", "--help"
    output = subprocess.run(program, cwd=ROOT, check=True, capture_output=True, text=True)
    assert "models of projectile" in output.stdout
    assert not output.stderr


@pytest.mark.parametrize("package", ["click", "rich"])
def test_without_click_or_rich_it_says_what_to_install(package):
    program = (
        f"import runpy, sys; sys.modules[{package!r}] = None; "
        "runpy.run_module('newton_euler.accuracy', run_name='__main__')"
    )
    run = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 1
    assert run.stderr == (
        f"python -m newton_euler.accuracy needs the package {package}: pip install click rich\n"
    )


SCENE = "sphere on an incline"


def test_the_command_measures_prints_and_writes_picture_and_runs(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(measuring, "timed_run", lambda run, method: (run(), (1e-3,), 1e-3))
    path = tmp_path / "new" / "picture.svg"
    options = "--scene", "Sphere-on-an-incline", "--methods", "exact, auto", "--quick"
    assert run("honesty", *options, "--out", str(path)) == 0
    output = capsys.readouterr()
    assert f"written: {path} and {path.with_suffix('.csv')}" in output.out
    assert {line.split()[0] for line in output.out.splitlines()[1:3]} == {"exact", "auto"}
    assert not output.err  # progress is for terminals
    assert path.read_text(encoding="utf-8").lstrip().startswith("<?xml")
    with open(path.with_suffix(".csv"), newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == COLUMNS
    assert {(r["problem"], r["absent"]) for r in rows} == {(SCENE, "")}
    asked = [float(r["asked"]) for r in rows if r["method"] == "exact"]
    assert asked == [1e-3, 1e-5, 1e-7, 1e-9, 1e-11]
    assert all(float(r["error"]) < 1e-14 for r in rows if r["method"] == "exact")


@pytest.mark.parametrize(("options", "words"), [
    (("--scene", "topp"), "there is no 'topp'; there are planet; "),
    (("--methods", "dop"), "there is no 'dop'; there are exact; taylor"),
    (("--out", "honesty.txt"), "a picture ends in .png, .svg or .pdf, got 'honesty.txt'"),
    (("--scene", SCENE, "--methods", "lie-poisson4"), "none of these methods can be used"),
])  # fmt: skip
def test_what_does_not_exist_is_refused_with_what_does(options, words, capsys):
    assert run("honesty", *options) == 2
    assert words in capsys.readouterr().err
