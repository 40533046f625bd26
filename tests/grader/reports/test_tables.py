"""Tables of results: they fit into 80 columns, sum up, and say what matters about each row."""

import io

from rich.console import Console

from grader.course.take_in import TakeInResult
from grader.reports import diagnosis_table, gradebook_table, taken_in_table
from tests.grader.reports.results import MISTAKE, result


def printed(table, width=80):
    console = Console(width=width, record=True, file=io.StringIO())
    console.print(table)
    return console.export_text()


CLASS = [
    result("a.very.long.student.name.of.a.registrar@university.example.edu", 4),
    result("ben", 2, waiting=3, penalty=0.5, extra=1),
    result("cleo", 0, sandbox="unsandboxed: this machine refuses user namespaces"),
    result("dan", 0, problem="expected the notebook ch04.ipynb", scores={}),
]


def test_the_table_fits_into_80_columns_and_sums_up():
    text = printed(gradebook_table(CLASS))
    assert max(map(len, text.splitlines())) <= 80
    together = "".join(text.split())
    for words in ("a.very.long.student", MISTAKE, "3 to grade by hand", "0.5 off for lateness"):
        assert "…" not in text
        for word in words.split():
            assert word[:10] in together
    assert "2/4" in text
    lines = [" ".join(line.split()) for line in printed(gradebook_table(CLASS)).splitlines()]
    assert "mean 2 50" in lines
    assert "median 2 50" in lines
    assert any(line.startswith("all 6 6 0 0 3 graded, 1 not") for line in lines), lines


def test_rows_without_a_cage_say_so_and_names_print_no_codes():
    asked = "unsandboxed: asked for"
    # ben handed in nothing that ran, but ada's code ran before
    results = [result("ada", 4, sandbox=asked, note=asked), result("ben", 4)]
    text = printed(gradebook_table(results))
    assert text.count("unsandboxed") == 2
    assert "asked for" not in text
    assert "unsandboxed" not in printed(gradebook_table([result("ada", 4)]))
    hostile = "\x1b[2J[/red]\r\nada 100"
    results = [result(hostile, 1), result("ben", 1)]
    taken = TakeInResult({"ada": hostile}, [("ben", hostile)], [(hostile, "no")])
    for table in (gradebook_table(results), diagnosis_table(results), taken_in_table(taken)):
        text = printed(table)
        assert "\x1b" not in text
        assert "\r" not in text
        assert "[/red]" in text
        assert not any(line.lstrip().startswith("ada 100") for line in text.splitlines())
