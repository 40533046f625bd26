"""A form for a notebook: text fields and buttons, all within reach of the keyboard. It has no list
to choose from: while one has the focus, JupyterLab takes letters and arrows as commands to the
notebook, and D D deletes the cell.
"""

from html import escape
from typing import Any

from ...answers.forms import AnswerError, Form
from .typed import typed

INSTALL = (
    "p.form() needs ipywidgets: pip install ipywidgets; without it, p.check(...), "
    "p.check_step(...), p.next_step() and p.solution() do the same"
)


def show_form(p: Any) -> Any:
    """A practice problem with a field for each answer, a field for any step, and buttons
    for hints, the solution and other numbers. The last message stands below them.

    Needs ipywidgets. Tab goes from field to button, Space presses a button.
    """
    try:
        from IPython.display import clear_output, display
        from ipywidgets import HTML, Button, Combobox, HBox, Layout, Output, VBox
    except ImportError:
        raise ImportError(INSTALL) from None

    top, below = Output(), Output()
    wide = Layout(width="100%", max_width="48em")
    labelled = {"description_width": "9em"}

    def show_message(what):
        with below:
            clear_output(wait=True)
            display(what)

    def button(text, action, tip):
        made = Button(description=text, tooltip=tip, layout=Layout(width="auto", flex="0 0 auto"))
        made.on_click(lambda _: action())
        return made

    def field(name, shown="", words=()):
        return Combobox(description=name, placeholder=shown, options=tuple(words), layout=wide,
                        style=labelled, continuous_update=False)  # fmt: skip

    def form_of(key):
        text = {**p.answers, **p.steps}.get(key)
        return Form.read(text) if text else None

    answers = {key: field(key, _as_typed(form_of(key)), form_of(key).of) for key in p.answers}
    chosen = field("step", "the name of a step; arrow down lists them", p.steps)
    step, means = (
        field("its value", "a number or a list"),
        HTML(layout=Layout(margin="0 0 0 9.5em")),
    )

    def expect(_=None):
        # never in the field of the value: a change there loses what is being typed
        name = chosen.value
        how = f"{p.meanings[name]}: {_as_typed(form_of(name))}" if name in p.steps else ""
        means.value = escape(how)

    chosen.observe(expect, "value")

    def read(key, value):
        form = form_of(key)
        x = typed(value, p.givens, form.of if form else ())
        return int(x) if form and form.kind.is_word and type(x) is float else x

    def checked(check, texts):
        try:
            given = {k: read(k, t) for k, t in texts.items()}
            given = {k: x for k, x in given.items() if x is not None}
            show_message(check(**given) if given else HTML("Write a value first."))
        except (AnswerError, ValueError) as error:
            show_message(HTML(f"<div>{escape(str(error))}</div>"))

    def check_answers():
        checked(p.check, {k: w.value for k, w in answers.items()})

    def check_step():
        checked(p.check_step, {chosen.value: step.value})

    def show():
        with top:
            clear_output(wait=True)
            display(p)

    def new():
        p.new()
        for w in (*answers.values(), chosen, step):
            w.value = ""
        chosen.options = tuple(p.steps)
        show()
        show_message(HTML(""))

    rows = [
        top,
        *answers.values(),
        HBox([
            button("Check", check_answers, "Check the answers"),
            button("Next step", lambda: show_message(p.next_step()), "Where to go on; again: more"),
            button("Solution", lambda: show_message(p.solution()), "The solution in these numbers"),
            button("New numbers", new, "The same problem with other numbers"),
        ], layout=Layout(flex_flow="row wrap")),
        *([chosen, means, step, HBox([button("Check step", check_step, "Check one step")])]
          if p.steps else []),
        below,
    ]  # fmt: skip
    show()
    return VBox(rows)


def _as_typed(form):
    """What is typed in a field, and its unit."""
    return form.words.partition(", ")[2] if form.kind.length > 1 else form.words
