"""The form, pressed without a browser."""

import pytest

from newton_euler.classroom import practice

widgets = pytest.importorskip("ipywidgets")


def parts(widget):
    yield widget
    for child in getattr(widget, "children", ()):
        yield from parts(child)


@pytest.fixture
def form(practice_file):
    p = practice(practice_file, progress=None)["4/16"]
    return p, list(parts(p.form()))


def press(form, name):
    next(w for w in form if isinstance(w, widgets.Button) and w.description == name).click()


def field(form, name):
    return next(w for w in form if isinstance(w, widgets.Text) and w.description == name)


def test_a_typed_answer_is_checked(form, capsys):
    p, form = form
    field(form, "alpha_CD").value = "[0, -b_dot*omega, 0]"
    field(form, "v_D").value = "[1, 2"
    press(form, "Check")
    assert p._found == {}  # nothing is checked while one of them cannot be read
    field(form, "v_D").value = ""
    press(form, "Check")
    assert p._found["alpha_CD"].verdict == "right"


def test_hints_steps_solution_and_new_numbers_have_buttons(form):
    p, form = form
    before = p.givens
    for name in ("Next step", "Solution"):
        press(form, name)
    next(w for w in form if isinstance(w, widgets.Dropdown)).value = "omega_CD"
    field(form, "its value").value = "[-0.45, 0, 0.6]"
    press(form, "Check step")
    assert p._found["omega_CD"].verdict == "right"
    press(form, "New numbers")
    assert p.givens != before
    assert field(form, "its value").value == ""
