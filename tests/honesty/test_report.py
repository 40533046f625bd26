"""report.py: the chart of honesty is drawn of the same numbers as the table."""

import math
from dataclasses import replace

import matplotlib
import pytest

from newton_euler.accuracy.measurements.honesty import FAILED, REFUSED, tallies
from tests.honesty import report
from tests.honesty.judge import Run

matplotlib.use("Agg")
MET = Run(
    *("pendulum/0/0", ("smooth",), "auto", "", 1e-6, "dop853", (), "met"),
    error=1e-7,
    estimate=3e-7,
    seconds=1e-3,
)
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


def test_what_an_answer_says_of_itself_is_what_the_run_says():
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


def test_the_chart_is_written_beside_the_table_unless_there_is_no_run(tmp_path):
    class Found:
        case, runs, changes, dropped, condition = "pendulum/0/0", RUNS, [], "", 1.0

    report.write(tmp_path / "some", [Found], report.table(RUNS))
    assert (tmp_path / "some" / "honesty.png").read_bytes()[1:4] == b"PNG"
    Found.runs = []
    report.write(tmp_path / "none", [Found], [])
    assert not (tmp_path / "none" / "honesty.png").exists()
