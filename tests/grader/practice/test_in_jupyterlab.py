"""The form of a problem in a real JupyterLab, in a real browser, by keyboard."""

import time

import pytest

from tests.jupyterlab import Page, chromium, jupyterlab, write_notebook

CELLS = (
    'from newton_euler.classroom import practice\np = practice("two.practice")["4/16"]\np',
    "p.form()",
    'practice("two.practice")["3/27"].form()',
    'practice("two.practice")',
)

pytestmark = [pytest.mark.slow, pytest.mark.integration]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A folder with a practice file and a notebook."""
    from exercises.catalogue import problem
    from grader.practice.build import write_practice

    folder = tmp_path_factory.mktemp("lab")
    write_practice(folder / "two.practice", [problem("4/16"), problem("3/27")], 2, workers=1)
    write_notebook(folder / "practice.ipynb", CELLS)
    return folder


@pytest.fixture(scope="module")
def page(folder, tmp_path_factory):
    """The notebook, all cells run."""
    own, profile = tmp_path_factory.mktemp("jupyter"), tmp_path_factory.mktemp("chromium")
    with jupyterlab(folder / "practice.ipynb", own) as address, chromium(profile) as driver:
        page = Page(driver)
        page.open(address, len(CELLS))
        page.says(3, "section 3.8: not tried")
        yield page


def test_text_formulas_and_figure_are_shown(page):
    page.says(0, "Elbow arm on a turning shaft", "Find", "beta_1 = 120")
    page.wait(lambda: len(page.all("mjx-container", 0)) > 10, "formulas")
    (figure,) = page.wait(lambda: page.all("img", 0), "the figure")
    assert "A vertical shaft with B at its top" in figure.get_attribute("alt")
    assert page.driver.execute_script("return arguments[0].naturalWidth", figure) > 300
    for n in range(3):
        assert "$" not in page.cell(n).text
        assert r"\\" not in page.cell(n).text
        assert not page.all(".jp-OutputArea-output[data-mime-type*=stderr]", n)
    assert len(page.all("mjx-merror")) == 0
    page.shoot("shown")


def test_a_wrong_answer_is_named_by_keyboard(page):
    page.says(1, "Check step")
    assert page.cut(1) == []
    page.into_form(1)
    page.go_to("a_D")
    page.press("[0, -7.38, -2.80592]")
    page.go_to("Check")
    start = time.monotonic()
    page.press(" ")
    page.says(1, "leaves out the Coriolis term")
    print(f"\nfrom pressing Check to the answer: {time.monotonic() - start:.2f} s")
    page.shoot("wrong")
    page.into_form(1)
    page.go_to("v_D")
    page.press("[1, 2")
    page.push("Check")
    page.says(1, "'[1, 2' is neither a number nor a list")
    page.shoot("unreadable")


def test_steps_hints_solution_and_new_numbers_by_keyboard(page):

    page.into_form(1)
    page.push("Next step")
    page.says(1, "Find omega_CD", "Section 4.9")
    page.press(" ")
    page.says(1, "equation (4.22)")
    page.shoot("hint")
    page.go_to("step")
    page.press("v_r")
    page.go_to("its value")
    page.press("[0, 1, 2]")
    page.push("Check step")
    page.says(1, "v_r [0, 1, 2] mm/s: not right")
    page.says(1, "velocity of D relative to the moving frame")
    page.shoot("step")
    page.into_form(1)
    page.push("Solution")
    page.says(1, "Coriolis term")
    page.wait(lambda: len(page.all("mjx-container", 1)) > 30, "formulas of the solution")
    page.shoot("solution")
    page.push("New numbers")
    page.says(1, "Numbers 2 of 2")
    assert "equation (4.22)" not in page.cell(1).text
    fields = page.all("input[type=text]", 1)
    assert [f.get_attribute("value") for f in fields] == [""] * 5
    page.shoot("new")


def test_a_matrix_by_keyboard(page):
    page.says(2, "Check step")
    page.into_form(2)
    page.go_to("T_theta")
    page.press("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]")
    page.push("Check")
    assert page.says(2, "T_theta [[1, 0, 0], [0, 1, 0], [0, 0, 1]]: not right")
    page.shoot("matrix")
    page.push("Solution")
    assert page.wait(lambda: len(page.all("mjx-mtable", 2)) > 1, "matrices")
    page.shoot("matrices")


def test_the_console_has_no_error_of_ours(page):
    assert page.errors() == []
