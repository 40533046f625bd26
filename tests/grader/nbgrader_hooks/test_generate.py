"""An assignment that is generated again after students have handed in."""

import copy

import pytest

from grader.grading import grade
from tests.grader.courses import change_source, give, nbgrader, points, refused, submit
from tests.grader.instructors_cells import ESSAY
from tests.grader.submissions import work


def number(cell):
    return cell["metadata"].get("newton_euler", {}).get("problem")


def add(*new):
    return lambda cells: cells.extend(copy.deepcopy(new))


def remove_own(cells):
    cells[:] = [c for c in cells if c["metadata"].get("nbgrader", {}).get("grade_id") != "essay"]


def total(course):
    (result,) = grade(course, "ch04", ["dan"])
    return result.points, result.out_of


@pytest.fixture
def graded(ungraded):
    """A course in which dan has handed in everything right, and is graded."""
    submit(ungraded, "dan", work(ungraded, "dan"))
    assert total(ungraded) == (11, 11)
    return ungraded


def test_a_problem_may_be_deleted_and_come_back_after_the_first_submission(graded):
    kept = {}

    def delete(cells):
        kept["cells"] = [c for c in cells if number(c) == "4/16"]
        cells[:] = [c for c in cells if number(c) != "4/16"]

    change_source(graded, delete)
    assert total(graded) == (8, 8)
    assert "answer-4-16" not in points(graded)["dan"]
    change_source(graded, add(*kept["cells"]))
    assert total(graded) == (11, 11)


def test_a_cell_that_is_added_counts_as_empty_for_those_who_handed_in_before(graded):
    change_source(graded, add(ESSAY))
    (result,) = grade(graded, "ch04", ["dan"])
    assert (result.points, result.out_of, result.waiting) == (11, 14, 0)


def test_points_given_by_hand_come_back_with_their_cell(graded):
    change_source(graded, add(ESSAY))
    total(graded)
    give(graded, "dan", "essay", 1.5, 0.25, "Well put.")
    change_source(graded, remove_own)
    assert total(graded) == (11, 11)
    change_source(graded, add(ESSAY))
    with graded.gradebook() as book:
        grade_ = book.find_grade("essay", "ch04", "ch04", "dan")
        assert (grade_.manual_score, grade_.extra_credit) == (1.5, 0.25)
        assert not grade_.needs_manual_grade
        assert book.find_comment("essay", "ch04", "ch04", "dan").manual_comment == "Well put."
    assert total(graded) == (12.75, 14)


def test_a_failed_release_leaves_the_previous_one(graded):
    before = graded.released_path("ch04").read_bytes()
    graded.source("ch04").write_text("{}")
    out = refused(nbgrader("generate_assignment", "ch04", "--force", cwd=graded.path), None)
    assert "The release that was there is kept" in out
    assert graded.released_path("ch04").read_bytes() == before
    assert total(graded) == (11, 11)
