"""The form, pressed without a browser."""

import sys
from html import unescape

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
    assert p._found == {}  # nothing is checked while any of them cannot be read
    field(form, "v_D").value = ""
    press(form, "Check")
    assert p._found["alpha_CD"].verdict == "right"


def test_hints_steps_solution_and_new_numbers_have_buttons(form):
    p, form = form
    before = p.givens
    for name in ("Next step", "Solution"):
        press(form, name)
    field(form, "step").value = "omega_CD"
    output = [w.value for w in form if isinstance(w, widgets.HTML)]
    # not in the field: a change there by the kernel loses what is being typed
    assert any("angular velocity of CD" in x and "in rad/s" in x for x in output)
    assert field(form, "its value").placeholder == "a number or a list"
    field(form, "its value").value = "[-0.45, 0, 0.6]"
    press(form, "Check step")
    assert p._found["omega_CD"].verdict == "right"
    press(form, "New numbers")
    assert p.givens != before
    assert field(form, "its value").value == ""


def test_the_form_speaks_of_its_own_buttons(form, capsys):
    p, form = form
    for text in ("[0, 0, 0]", ""):
        field(form, "alpha_CD").value = text
        press(form, "Next step")
    field(form, "step").value = "alpha_CD"
    field(form, "its value").value = "1"
    press(form, "Check step")
    p.solution()
    press(form, "Next step")
    press(form, "New numbers")
    output = unescape(capsys.readouterr().out)
    assert "Try it in the field of steps, as omega_CD with its value, by Check step." in output
    assert "alpha_CD is checked in the field alpha_CD above, by Check" in output
    assert "nothing is left to find; New numbers takes other numbers" in output
    assert "p.check" not in output
    assert "p.new" not in output
    assert "p.new() takes others" in repr(p)  # typed input gets the method's name


def test_help_starts_afresh_with_each_problem_and_the_table_remembers_it(practice_file, tmp_path):
    for again in range(2):
        p = practice(practice_file, progress=tmp_path / "kept.json")["4/16"]
        assert "It is" not in p.next_step().text
        assert "It is found by equation" in p.next_step().text
        p.new()
        assert "It is" not in p.next_step().text, again
    table = practice(practice_file, progress=tmp_path / "kept.json").table.text.splitlines()
    assert table[0].split("  ")[0] == "problem"
    assert next(line for line in table if line.startswith("4/16")).split()[-1] == "2"
    assert len([h for h in table[0].split("  ") if h.strip()]) == 7


def test_a_missing_step_is_reported_and_no_list_takes_letters(form, capsys):
    _, form = form
    field(form, "step").value = "omega"
    field(form, "its value").value = "1"
    press(form, "Check step")
    assert "4/16 has no step 'omega'; it has omega_CD, v_r" in unescape(capsys.readouterr().out)
    # JupyterLab takes letters for commands while a list has the focus: R makes the cell raw
    assert not [w for w in form if isinstance(w, (widgets.Dropdown, widgets.Select))]


def test_a_word_is_typed_and_the_words_are_offered(practice_file):
    p = practice(practice_file, progress=None)["2/18"]
    form = list(parts(p.form()))
    heading = field(form, "heading")
    assert heading.options == ("away", "toward", "across")
    for text in ("away", " Away ", "AWAY", "'Away'"):
        p.forget()
        heading.value = text
        press(form, "Check")
        assert p._found["heading"].verdict == "right", text


def test_without_ipywidgets_one_sentence_says_what_to_install(practice_file, monkeypatch):
    monkeypatch.setitem(sys.modules, "ipywidgets", None)
    with pytest.raises(ImportError, match=r"p.form\(\) needs ipywidgets: pip install ipywidgets; "):
        practice(practice_file, progress=None)["4/16"].form()
