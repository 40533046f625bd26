"""From the answer cells to messages for the student."""

import pytest

from grader.grading import grade
from tests.grader.courses import submit
from tests.grader.submissions import work

ANSWERS = {  # the cell of 4/16 (alpha_CD, v_D, a_D) or 4/1: the messages about it
    "wrong shape": (
        "v_D = [1, 2]",
        "v_D",
        "expected a vector, three numbers as in [1.0, 0, -2.5], in mm/s; got 2 numbers: [1, 2]",
    ),
    "wrong kind": (
        "v_D = 'fast'",
        "v_D",
        "expected a vector, three numbers as in [1.0, 0, -2.5], in mm/s; got the text "
        "'fast'; write it without quotation marks",
    ),
    "nan": (
        "import numpy as np\nv_D = np.array([1, 0, 2]) * np.nan",
        "v_D",
        "got nan, which comes from a division by zero or the root of a negative number",
    ),
    "still a symbol": ("import sympy\nv_D = [sympy.Symbol('q'), 0, 0]", "v_D", "q still contains q; put in the numbers"),
    "a dict": ("v_D = {'x': 1}", "v_D", "got a dict, which has no order"),
    "a lambda": ("v_D = lambda t: t", "v_D", "expected a vector"),
}  # fmt: skip


@pytest.mark.parametrize("how", ANSWERS)
def test_an_answer_that_cannot_be_read_is_explained_and_the_rest_counts(fresh, how):
    text, key, words = ANSWERS[how]
    cells = work(fresh, "dan")["cells"]
    right = next(c["source"] for c in cells if c["id"] == "answer-4-16")
    submit(fresh, "dan", work(fresh, "dan", p4_16=f"{right}\n{text}"))
    (result,) = grade(fresh, "ch04", ["dan"], workers=1)
    part = next(p for p in result.scores["4/16"].parts if p.key == key)
    assert part.verdict == "unreadable"
    assert words in part.message
    assert result.points == 10


def test_the_right_vector_in_another_frame_is_recognised(fresh):
    from exercises.catalogue import problem

    values = fresh.values("ch04", "dan", [problem("4/16")])["4/16"]
    a_D = problem("4/16").solve(values)["a_D"]
    CD = next(f for f in a_D.frame.tree if f.name == "CD")
    cell = f"a_D = {[float(x) for x in a_D.components(CD)]}"
    submit(fresh, "dan", work(fresh, "dan", p4_16=cell))
    result = grade(fresh, "ch04", ["dan"], workers=1)[0]
    assert "components along the axes of CD" in result.scores["4/16"].parts[2].message
