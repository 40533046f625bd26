"""Statistics of parts: difficulty, discrimination, mistakes."""

import csv

import pytest
from rich.console import Console

from grader.reports import part_statistics
from grader.reports.records import PartScore
from grader.reports.statistics import _of_part, mistake_counts, statistics_table
from newton_euler.answers import Cause
from tests.grader.courses import command, ran, refused
from tests.grader.reports.results import MISTAKE, PARTS, graded_course


@pytest.fixture(scope="module")
def graded(tmp_path_factory):
    return graded_course(tmp_path_factory.mktemp("statistics") / "c")


def test_a_part_that_the_strong_can_do_discriminates_and_one_that_nobody_can_do_does_not(graded):
    parts = {(p.problem, p.key): p for p in part_statistics(graded, "ch04")}
    assert list(parts) == list(PARTS)
    assert 0.3 < parts["4/1", "speed"].difficulty < 0.7
    assert parts["4/1", "speed"].discrimination > 0.2
    nobody = parts["4/16", "a_D"]
    assert (nobody.difficulty, nobody.discrimination) == (0, None)
    assert nobody.verdicts == {"wrong": 20}
    assert nobody.mistakes == [(MISTAKE, 10)]


def test_a_mistake_whose_words_or_order_changed_is_counted_as_one_and_two_of_one_text_as_two():
    def entry(diagnosis, *causes):
        causes = tuple(Cause("listed", *c) for c in causes)
        return PartScore("ann", "4/1", "v", 0.0, 1.0, "wrong", "", diagnosis, causes)

    old, new = ("sign", "old words"), ("sign", "new words")
    other, twin = ("axis", "the axis"), ("frame", "the axis")
    found = [
        entry("old words", old),
        entry("new words; or one that the axis", new, other),
        entry("new words", new),
        entry("the axis; or one that old words", other, old),
        entry("the axis", other),
        entry("the axis", twin),
        entry("kept by an older version"),
    ]
    assert mistake_counts(found) == [
        ("new words", 2),
        ("the axis; or one that old words", 2),
        ("the axis", 1),
        ("the axis", 1),
        ("kept by an older version", 1),
    ]


def test_the_correlation_leaves_the_part_itself_out(tmp_path):
    """Otherwise the points of two parts with nothing in common would correlate."""
    import json

    course = graded_course(tmp_path / "c", students=8)
    for n in range(8):
        parts = [
            {"key": k, "points": float(x), "out_of": 1.0, "verdict": "right", "message": ""}
            for k, x in (("a", n % 2), ("b", n // 2 % 2))
        ]
        record = json.dumps({"scores": [{"problem": "4/1", "parts": parts}]})
        course.record_path("ch04", f"s{n:02}").write_text(record)
    assert [p.discrimination for p in part_statistics(course, "ch04")] == pytest.approx([0, 0])


def entry(points, out_of, verdict="", waits=False):
    return PartScore("ann", "4/1", "", points, out_of, verdict, waits=waits)


@pytest.mark.parametrize(("found", "difficulty", "waiting"), [
    ([entry(1, 2), entry(2, 2), entry(0, 2, waits=True)], 0.75, 1),
    ([entry(0, 2, waits=True)] * 2, None, 2),
    ([entry(0, 0, "right"), entry(0, 0, "wrong")], 0.5, 0),
    ([entry(0, 0)], None, 0),
], ids=["one-waits", "all-wait", "no-points", "no-points-nor-verdict"])  # fmt: skip
def test_what_waits_for_a_person_or_has_no_points_is_not_counted_wrong(found, difficulty, waiting):
    part = _of_part("4/1", "", found, {"ann": 3.0})
    assert (part.difficulty, part.waiting) == (difficulty, waiting)
    assert ("–" if difficulty is None else f"{difficulty:.2f}") in drawn(statistics_table([part]))


def drawn(table):
    with (console := Console(width=80)).capture() as output:
        console.print(table)
    return output.get()


def test_stats_prints_a_table_of_80_columns_and_writes_csv_and_picture(graded, tmp_path):
    out = ran(command(
        "stats", "ch04", "--course", graded.path,
        "--csv", tmp_path / "s.csv", "--png", tmp_path / "s.png",
    ))  # fmt: skip
    assert max(map(len, out.splitlines())) <= max(80, len(str(tmp_path)) + 20)
    assert "10× leaves out the" in " ".join(out.split())
    assert (tmp_path / "s.png").read_bytes().startswith(b"\x89PNG")
    with open(tmp_path / "s.csv", newline="", encoding="utf-8-sig") as f:
        rows = list(csv.DictReader(f))
    assert [r["part"] for r in rows if r["students"]] == [k for _, k in PARTS]
    mistakes = [(r["part"], r["mistake"], r["times"]) for r in rows if not r["students"]]
    assert ("a_D", MISTAKE, "10") in mistakes


def test_nothing_graded_and_a_damaged_record_are_reported(graded, tmp_path):
    out = refused(command("stats", "ch05", "--course", graded.path))
    assert "nothing of ch05 has been graded yet; grade first with" in out
    course = graded_course(tmp_path / "c", students=3)
    course.record_path("ch04", "s01").write_text("{")
    out = refused(command("stats", "ch04", "--course", course.path))
    assert "--student s01 --force" in out
