"""Problems to choose from, in the terminal, and as a page before they are built."""

import json
import re
import stat

import pytest

from exercises.catalogue import problem
from grader.assignment.lines import formatted
from grader.reports import measured, preview, preview_page
from tests.grader.courses import command, ran, refused


def test_the_table_fits_80_columns_and_json_has_the_same(monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    out = ran(command("problems", "ch04", "9/4", "--sort", "minutes", "--reverse"))
    lines = out.splitlines()
    assert max(map(len, lines)) <= 80
    shown = [m[0] for line in lines if (m := re.match(r"\w+/\d+", line))]
    found = json.loads(command("problems", "ch04", "9/4", "--json")[1])
    assert {e["id"] for e in found} == set(shown) == {*(f"4/{n}" for n in range(1, 44)), "9/4"}
    minutes = {e["id"]: e["minutes"] for e in found}
    assert [minutes[i] for i in shown] == sorted(minutes.values(), reverse=True)


@pytest.mark.parametrize(("arguments", "words"), [
    (("--kind", "vektor"), "did you mean vector?"),
    (("--steps", "some"), "write 3, 2-4, 2- or -4"),
    (("--difficulty", "4-2"), "write 3, 2-4, 2- or -4"),
    (("--right", "-50"), "name a --course"),
    (("4/99",), "ch04 has 4/1 to 4/43"),
])  # fmt: skip
def test_a_filter_that_means_nothing_is_refused_in_words(arguments, words):
    assert words in refused(command("problems", *arguments))
    assert command("problems", "4/16", "--search", "nowhere")[1].strip() == "No problem matches."


def test_what_a_course_found_hard_appears_beside_the_estimate(course):
    earned, shares = measured(course), {}
    for path in (course.path / "scores/ch04").glob("*.json"):
        for score in json.loads(path.read_text())["scores"]:
            shares.setdefault(score["problem"], []).append(score["points"] / score["out_of"])
    assert earned == {
        n: (pytest.approx(sum(found) / len(found)), len(found)) for n, found in shares.items()
    }
    out = command("problems", "ch04", "--course", course.path, "--right", "-99", "--sort", "right",
                  "--json")[1]  # fmt: skip
    found = [e["share_of_points"] for e in json.loads(out)]
    assert found == sorted(found)
    assert len(found) == sum(share <= 0.99 for share, _ in earned.values()) > 0


def test_a_preview_holds_all_that_is_asked_and_only_its_owner_reads_it(tmp_path):
    file, page = tmp_path / "hw.yaml", tmp_path / "page.html"
    file.write_text("problems:\n- 4/16: {tolerance: 2%, help: hints}\n")
    assert command("preview", file, "--to", page, "--no-open")[0] == 0
    assert stat.S_IMODE(page.stat().st_mode) == 0o600
    text, p = page.read_text(), problem("4/16")
    shown = "tolerance 2 %", "help: hints", "difficulty 4 of 5", "data:image/png", "student 3"
    assert [words for words in shown if words not in text] == []
    assert formatted(p.solve(p.book_values)["a_D"]) in text
    assert all(f">{name}</th>" in text for name in p.mistakes)
    assert "leaves out the Coriolis term" in text
    assert "<script" not in text
    assert not re.search(r"(src|href)=\"(?!data:)", text)
    assert "no_coriolis, a_D = [0, -7.38, -2.80592]" in command("preview", "4/16", "--text")[1]


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", ["A/7", "5/26", "A/15", "3/27", "2/4", "A/19", "A/24", "4/30"])
def test_every_kind_of_answer_has_a_preview(name):
    found = preview(problem(name))
    assert len(found.sheets) == 4
    assert {m.name for m in found.mistakes} <= set(found.problem.mistakes)
    assert found.title.split()[0] in preview_page([found])
