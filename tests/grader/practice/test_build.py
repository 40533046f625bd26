"""What a practice file holds, and what it must not."""

import json
import zipfile
from dataclasses import replace
from types import SimpleNamespace

import pytest

from exercises.catalogue import problem, select, variants
from exercises.catalogue.reading import chapters
from exercises.catalogue.variants import as_points, draw, evaluate
from grader.practice import LeftOut, PracticeError, graded_numbers, write_practice
from grader.practice.build import page_of
from grader.practice.graded import GradedAnswers, same_for_all
from grader.practice.quantities import quantities, wrong_numbers
from grader.practice.twins import sets_of_numbers
from newton_euler import asin
from newton_euler.classroom.practising.files import HELP
from tests.exercises.kinds.thrown import SENSE, SPEED, THROWN, solve
from tests.grader.courses import command, ran
from tests.making import made as made


def members(path):
    with zipfile.ZipFile(path) as archive:
        return {n: archive.read(n) for n in archive.namelist()}


@pytest.mark.parametrize("chapter", chapters())
@pytest.mark.parametrize(
    "first", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(1, 6))]
)
def test_every_problem_can_be_practised(chapter, first):
    for p in select([chapter])[first::6]:
        page, _ = page_of(p.id, 1, "hints", draw=lambda p, v: None)
        (one,) = page["variants"]
        assert [q["key"] for q in page["quantities"] if not q["step"]] == [a.key for a in p.answers]
        assert json.dumps(one, allow_nan=False)


def test_sets_of_numbers_differ_and_keep_away_from_graded_ones():
    page, _ = page_of("4/16", 5, "solution", draw=lambda p, v: None)
    assert len({json.dumps(v["givens"]) for v in page["variants"]}) == 5
    assert len({json.dumps(v["right"]["a_D"]) for v in page["variants"]}) == 5
    p = problem("4/16")
    first = sets_of_numbers(p, 3)
    graded = [first[1]]
    assert graded[0] not in sets_of_numbers(p, 3, graded)
    assert p.book_values not in sets_of_numbers(p, 3, [p.book_values])
    # as that of a released assignment whose problem has since changed
    p = problem("4/16")
    own = {**dict(list(draw(p, b"ada").items())[1:]), "gone": 1.0}
    graded = {**p.book_values, **own}
    near = GradedAnswers(p, [own])
    assert near({n: graded[n] for n in p.units})
    assert not near({n: 1.1 * x for n, x in p.book_values.items()})


@pytest.mark.parametrize("name", ["4/2", "4/10"])
@pytest.mark.parametrize("help", HELP)
def test_what_is_graded_as_a_formula_is_left_out(name, help):
    """Its steps state the formula, and its numbers show whether a guess is the formula."""
    found = page_of(name, 3, help, [], draw=lambda p, v: None)
    assert isinstance(found, LeftOut)
    assert "graded as a formula" in found.why


def class_of(count, p):
    return [draw(p, f"student {n}".encode()) for n in range(count)]


@pytest.mark.parametrize("name", ["4/1", "4/31", "2/12"])
def test_no_practised_answer_is_near_one_of_a_class(name):
    """Even where few numbers vary."""
    p = problem(name)
    sheets = class_of(40, p)
    sets = sets_of_numbers(p, 8, sheets)
    assert len(sets) == 8
    for a in p.answers:
        practised, graded = ([as_points(evaluate(p, values)[0][a.key]) for values in found]
                             for found in (sets, sheets))  # fmt: skip
        assert not any(a.kind.is_right(x, key, a.atol) for x in practised for key in graded)


@pytest.mark.parametrize("name", ["A/7", "5/24", "7/28"])
def test_what_is_the_same_for_everybody_is_left_out_where_it_is_graded(name):
    """In a course, a problem without personal numbers would give away its answer."""
    found = page_of(name, 3, "solution", [], draw=lambda p, v: None)
    assert isinstance(found, LeftOut)
    assert "would give away a graded answer" in found.why
    assert not isinstance(page_of(name, 3, "solution", draw=lambda p, v: None), LeftOut)


def test_a_problem_in_symbols_gives_away_no_formula():
    """What may be asked as a formula is in the file as numbers only."""
    page, _ = page_of("4/2", 3, "solution", draw=lambda p, v: None)
    assert {q["kind"] for q in page["quantities"] if not q["step"]} == {"number"}
    for v in page["variants"]:
        for name in problem("4/2").symbols:
            assert isinstance(v["givens"][name][0], float)
        assert r"\omega" not in v["solution"].rpartition("**")[2]


def test_the_file_holds_no_more_than_the_chosen_help_and_nothing_of_the_course(tmp_path):
    shown = {"check": (False, False), "hints": (True, False), "solution": (True, True)}
    for help, has in shown.items():
        write_practice(tmp_path / help, select(["4/16"]), 2, help)
        page = json.loads(members(tmp_path / help)["4-16.json"])
        steps = [q for q in page["quantities"] if q["step"]]
        assert (bool(steps), any(v["solution"] for v in page["variants"])) == has
    write_practice(tmp_path / "p", select(["4/16", "4/2"]), 2)
    everything = b"".join(members(tmp_path / "p").values())
    for words in (b"def solve", b"exercises", b"secret", str(tmp_path).encode(), b"prove"):
        assert words not in everything
    with pytest.raises(PracticeError, match="one of check, hints, solution"):
        write_practice(tmp_path / "q", select(["4/16"]), help="all")
    with pytest.raises(PracticeError, match="no problem was chosen"):
        write_practice(tmp_path / "q", [])
    assert not (tmp_path / "q").exists()


def test_the_numbers_of_all_students_of_a_course_are_read(course):
    found = graded_numbers(course.path)
    assert set(found) == {"4/1", "4/2", "4/10", "4/16", "4/31"}
    for student in course.roster():
        assert course.values("ch04", student, [problem("4/16")])["4/16"] in found["4/16"]


def test_the_command_writes_a_file_and_says_how_it_is_opened(tmp_path, course):
    path = tmp_path / "ch04.practice"
    options = "-o", path, "--variants", 2, "--course", course.path
    output = ran(command("practice", "4/16", "4/31", "4/2", *options))
    assert "2 problems, at most 2 sets of numbers each" in output
    assert "4/2 left out: it is graded as a formula" in " ".join(output.split())
    assert 'practice("ch04.practice")["4/16"]' in output
    assert "may be graded ones" not in output
    assert "may be graded ones" in ran(command("practice", "4/16", "-o", path, "--variants", 2))


def test_the_measured_shares_are_printed_by_one_command():
    output = ran(command("diagnose", "4/16", "2/18", "--practice", "--draws", 2))
    for row in ("listed mistakes", "slips in steps"):
        (line,) = [x for x in output.splitlines() if row in x]
        assert line.split()[-4:] == ["100.0", "0.0", "0.0", "0.0"]


def test_a_problem_that_lists_no_steps_has_the_terms_of_its_answers(monkeypatch):
    """As one that an instructor adds, whose later answers still follow from the terms."""
    p = problem("4/16")
    monkeypatch.delattr(p.code, "steps")
    page, _ = page_of("4/16", 2, "solution", draw=lambda p, v: None)
    assert {"a_D_coriolis", "v_D_rotation"} <= {q["key"] for q in page["quantities"] if q["step"]}
    assert "a_D_coriolis" in page["variants"][0]["program"]["earlier"]["a_D"]
    assert any(page["labels"][n][0] == "a_D_coriolis" for n, _ in page["variants"][0]["wrong"])


def test_a_mistake_that_has_no_real_answer_is_left_out(monkeypatch):
    """The arc sine of more than 1, for some numbers that a student may have."""
    monkeypatch.setattr(variants, "_compiled", lambda name: None)  # of the problem as it is
    p = problem("4/16")
    wrong = {"no_coriolis": lambda g: {"v_D": [asin(2 * g.b / g.b), 0, 0]}}
    made = replace(p, mistakes={"no_coriolis": "takes a sine above 1"})
    vars(made)["code"] = SimpleNamespace(**{**vars(p.code), "mistakes": lambda g: {
        name: f(g) for name, f in wrong.items()}})  # fmt: skip
    described, right = quantities(made, p.book_values)
    found = wrong_numbers(made, p.book_values, described, right)
    assert found
    assert not [x for x in found if x[1] == "listed"]


def test_what_differs_by_round_off_only_is_the_same_for_everybody(made):
    """Such as 0.1 h/h, whose text has other last digits for some h."""
    answers, givens = (SENSE, SPEED, replace(SPEED, key="fixed")), THROWN
    p = made(lambda g: {**solve(g), "fixed": 0.1 * g.v_0 / g.v_0}, answers=answers, givens=givens)
    sets = [{"v_0": x, "t": 0.1, "g": 9.81} for x in (2.5, 3.1, 4.7, 5.3)]
    assert len({p.solve(values)["fixed"] for values in sets}) > 1
    assert same_for_all(p, sets) == ["sense", "fixed"]
    assert same_for_all(p, sets[:1]) == ["sense", "v", "fixed"]
