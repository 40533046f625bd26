"""Worked solutions of single problems, and the formulas that a text spells."""

import re

import pytest

from exercises.catalogue import problem
from grader.assignment.lines import lines
from grader.assignment.solution import worked_solution
from grader.assignment.spelled import typeset_formulas
from tests.grader.assignment.test_solution import as_python, computed, derived, written


@pytest.mark.parametrize("name", ["7/15", "8/19", "9/1"])
def test_what_particles_have_is_a_sum_and_not_an_integral(name):
    p = problem(name)
    cited = {s.equation for s in computed(p, b"one")}
    assert "7.9" in cited
    assert not {"7.10", "7.25"} & cited


def test_a_step_and_a_term_are_those_of_the_own_chapter_and_before_their_sum():
    p = problem("2/38")
    text = worked_solution(p, p.book_values)
    assert "By equation (2.25), $\\mathbf{a}_A = " in text
    assert "(4.18)" not in text
    assert "{-0}" not in text
    assert "| the acceleration of the origin of the moving frame | $" in text
    p = problem("2/13")
    assert r"\frac{\nu^2}{\rho}\,\hat{e}_n$ |" in written(p, b"one")
    for later in map(problem, ("A/8", "3/15")):  # which do not have the equation of these terms yet
        assert "| --- |" not in written(later, b"one")
    keys = [line.step.key for line in as_python(problem("2/17"), b"one")]
    assert keys.index("a_P_radial") < keys.index("a_P_coriolis") < keys.index("a_P")


def test_the_terms_of_an_answer_are_in_its_table_and_not_among_the_steps_too():
    p = problem("4/16")
    text = worked_solution(p, p.book_values)
    assert text.count("the Coriolis term") == 1
    assert r"| the Coriolis term $2\boldsymbol{\omega}\times\mathbf{v}_r$ | $" in text
    # a term that is zero is shown as zero; a frame that adds nothing has no line
    assert "| the term $\\boldsymbol{\\alpha} \\times \\mathbf{r}$ | $\\left[0,\\ 0,\\ 0" in text
    assert "| the turning of" not in text


def found_by(p, key):
    """The names in each component's formula of a quantity."""
    found = derived(p, b"one")[key].formulas
    return [{x.name for x in f.free_symbols} for f in found]


def test_chance_and_round_off_name_no_step_and_angles_have_one_pair_of_brackets():
    # of three rods, moments that are 4/3 and 1/2 of the second one's
    p = problem("8/17")
    assert found_by(p, "I_xx_BC") == found_by(p, "I_xy") == [{"m", "a"}]
    # of three rods, I_zz of the second is I_xx of the third
    own = {"I_G_BC_xx", "a", "m", "d_BC_x", "d_BC_y", "d_BC_z"}
    assert found_by(problem("7/11"), "I_BC")[0] <= own
    p = problem("4/17")  # of the velocity along X is left what cos 60 degrees is not a half
    text = worked_solution(p, p.book_values)
    assert r"$\mathbf{v}_D = \left[0,\ 6.23538" in text
    assert r"\times 10^{-1" not in text
    p = problem("6/18")  # shot at 45 degrees, at the latitude 45 degrees
    assert r"\times 10^{-1" not in worked_solution(p, p.book_values)
    texts = [x for q in as_python(problem("6/7"), b"one") for x in (*q.equal, *q.with_numbers)]
    assert any(" deg)" in x for x in texts)
    assert not any("((" in x for x in texts)


@pytest.mark.parametrize(("name", "words"), [
    ("4/12", "2. z component of"),  # a sentence may begin with an axis
    ("3/26", r"Coriolis term of $\theta$ and $\phi$, $-2R\dot{\theta}\dot{\phi}\sin\phi\,"),
    ("4/18", r"\mathbf{a}_r$ | $"),  # a term's formula is not searched for the given length a
])  # fmt: skip
def test_axes_and_terms_are_typeset(name, words):
    p = problem(name)
    assert words in worked_solution(p, p.book_values)


@pytest.mark.parametrize(("text", "latex"), [
    ("work of a spring, k (x_1^2 - x_2^2)/2", r"work of a spring, $k\,(x_1^2 - x_2^2)/2$"),
    ("its second rate, -(z'^2 + z z'')/r", r"its second rate, $-(z'^2 + z\,z'')/r$"),
    ("by {r}/2 and $r/2$, the disk's P", "by {r}/2 and $r/2$, the disk's P"),
    ("a rate in km/h of a disk A to B", "a rate in km/h of a disk A to B"),
    ("integral of r sin(theta) r dr d(theta)", r"integral of $r\,\sin(\theta)\,r\,dr\,d\theta$"),
    ("from (r/h)^2 = 3/80 (see above)", "from $(r/h)^2 = 3/80$ (see above)"),
    ("at theta = 90 degrees, omega x r", "at theta = 90 degrees, omega x r"),
])  # fmt: skip
def test_a_formula_that_a_text_spells_is_typeset_and_words_stay(text, latex):
    assert typeset_formulas(text, {}) == latex


@pytest.mark.parametrize("name", ["2/38", "4/16", "6/5", "11/7"])
def test_without_formulas_there_are_values_only(name):
    """A practice file would otherwise give away what holds for the numbers of an assignment too."""
    p = problem(name)
    shown = list(lines(p, p.book_values, formulas=False))
    assert all(len(line.equal) == 1 and not line.together for line in shown)
    text = worked_solution(p, p.book_values, text=False, formulas=False)
    assert len(text) < len(worked_solution(p, p.book_values, text=False))
    assert " from $" not in text


@pytest.mark.parametrize("name", ["9/1", "9/5"])
def test_each_bearing_has_its_own_letter(name):
    _, *tables = written(problem(name), b"one").split("(9.9)")
    assert [re.findall(r"mathbf\{([AB])\}_\{m\\omega", x)[0] for x in tables] == ["A", "B"]
    assert [re.findall(r"[AB]_x =", x)[0] for x in tables] == ["A_x =", "B_x ="]
