"""report.py: the table, the chart of the same numbers, and the command that makes both."""

import csv
import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from newton_euler.accuracy.measurements.honesty import FAILED, REFUSED, tallies
from tests.honesty import __main__ as command
from tests.honesty import report
from tests.honesty.judge import Run

ASKED = "pendulum/0/0", ("smooth",), "auto", "", 1e-6, "dop853", ()
MET = Run(*ASKED, "met", error=1e-7, estimate=3e-7, seconds=1e-3)
RUNS = [
    MET,
    replace(MET, estimate=5e-8, seconds=1.0),
    replace(MET, outcome="missed", error=1e-3),
    replace(MET, outcome="missed", error=math.inf, estimate=None, way="prepared"),
    replace(MET, method="verlet", outcome="refused", error=math.nan, words="too much"),
    replace(MET, method="verlet", outcome="raw", error=math.nan),
    replace(MET, method="verlet", outcome="timeout", error=math.nan),
    replace(MET, method="exact", outcome="unfit", error=math.nan),
    replace(MET, case="lorenz/0/1"),
]


def test_an_answer_of_the_chart_agrees_with_its_run():
    for a, r in zip(report.answers(RUNS[:4]), RUNS, strict=False):
        assert (a.kept, a.covered, a.silent) == (r.outcome == "met", r.covers, r.silent)
        assert a.effectivity == (r.ratio if r.ratio is None else pytest.approx(r.ratio))


def test_methods_that_a_model_cannot_use_are_not_charted_and_other_outcomes_are_kept_apart():
    found = [(a.method, a.absent) for a in report.answers(RUNS)]
    assert found == [
        *[("auto", "")] * 3,
        ("auto, prepared", ""),
        *[("verlet", REFUSED), ("verlet", FAILED), ("verlet", FAILED)],
        ("auto", ""),
    ]


def test_the_tallies_of_the_chart_are_the_lines_of_the_table():
    lines = {x.row: x for x in report.table(RUNS) if x.rtol is None}
    for t in tallies(report.answers(RUNS)):
        x = lines[t.method]
        same = (t.runs, t.silent, t.refused, t.failed)
        assert same == (x.runs, x.silent, x.refused, x.raw + x.timeout)
        assert [t.met, t.covers, t.ratio] == pytest.approx([x.met, x.covers, x.ratio], nan_ok=True)


def test_the_table_counts_what_it_states(tmp_path):
    base = replace(MET, error=1e-7, unitless=1e-7, inside=5e-6, estimate=1e-6)
    runs = [
        base,
        replace(base, estimate=1e-8),
        replace(base, outcome="missed", error=1e-3, unitless=1e-3, inside=1e-3),
        replace(base, outcome="refused", needless=True),
        replace(base, outcome="raw"),
        replace(base, outcome="timeout"),
    ]
    one, total = report.table(runs)
    assert (one.runs, one.returned, one.met, one.covers) == (6, 3, 2 / 3, 1 / 3)
    assert (one.silent, one.refused, one.needless, one.raw, one.timeout) == (1, 1, 1, 1, 1)
    assert (one.ratio, one.inside) == (pytest.approx(0.1), 2 / 3)
    assert replace(total, rtol=1e-6) == one
    assert not total.reaches_goals
    assert report.line("auto", None, [base]).reaches_goals
    assert [r.error for r in report.worst(runs)] == [1e-3]
    found = SimpleNamespace(case="pendulum/0/0", runs=runs, changes=[], dropped="", condition=1.0)
    report.write(tmp_path, [found], [one, total])
    with open(tmp_path / "table.csv") as file:
        assert [row["silent"] for row in csv.DictReader(file)] == ["1", "1"]
    assert (tmp_path / "honesty.png").read_bytes()[1:4] == b"PNG"
    found.runs = []
    report.write(tmp_path / "none", [found], [])
    assert not (tmp_path / "none" / "honesty.png").exists()


def test_one_command_prints_the_table_and_what_reproduces_the_worst(tmp_path):
    root = Path(__file__).parents[2]
    asked = "--families tiny_spring --draws 1 --jobs 1 --methods auto,dop853 --tolerances 1e-6"
    folders = ["--cache", tmp_path / "cache", "--out", tmp_path / "out"]
    run = subprocess.run(
        [sys.executable, "-m", "tests.honesty", *asked.split(), *folders],
        cwd=root, capture_output=True, text=True, timeout=600, check=True,
        env={**os.environ, "PYTHONPATH": str(root)},
    )  # fmt: skip
    assert "auto, without heyoka" in run.stdout
    assert "1 models of 1 families" in run.stdout
    written = {"changes.csv", "honesty.json", "honesty.png", "runs.csv", "table.csv"}
    assert {f.name for f in (tmp_path / "out").iterdir()} == written
    assert len(list((tmp_path / "cache").iterdir())) == 1
    with open(tmp_path / "out" / "runs.csv") as file:
        rows = [r for r in csv.DictReader(file) if r["method"] == "dop853"]
    assert {(r["case"], r["outcome"]) for r in rows} == {("tiny_spring/0/0", "met")}


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        (["--families", "lorenzz"], "there is no 'lorenzz'. Did you mean 'lorenz'?"),
        (["--case", "xqzwv/0/1"], "there is no 'xqzwv'; --list names them"),
        (["--methods", "xqzwv"], "there is no 'xqzwv'; auto, exact, taylor"),
    ],
)
def test_an_unknown_name_is_answered_with_the_nearest_or_with_where_they_are(asked, words):
    said = CliRunner().invoke(command.main, asked).output
    assert words in said
    assert len(said) < 500
