"""A form for a notebook: text fields and buttons, all within reach of the keyboard."""

from typing import Any

from ..forms import WORDS, AnswerError
from .typed import typed


def show_form(p: Any) -> Any:
    """Display a practice problem with a field for each answer, a field for any step, and buttons
    for hints, the solution and other numbers. What was said last stands below them.

    Needs ipywidgets. Tab goes from field to button, Space presses a button.
    """
    from IPython.display import clear_output, display
    from ipywidgets import HTML, Button, Dropdown, HBox, Layout, Output, Text, VBox

    top, said = Output(), Output()
    wide = Layout(width="32em")

    def say(what):
        with said:
            clear_output(wait=True)
            display(what)

    def button(text, action, tip):
        made = Button(description=text, tooltip=tip, layout=Layout(width="auto"))
        made.on_click(lambda _: action())
        return made

    def field(key, form):
        made = Text(description=key, placeholder=form, layout=wide, continuous_update=False)
        made.style.description_width = "9em"
        return made

    answers = {key: field(key, form) for key, form in p.answers.items()}
    chosen = Dropdown(options=list(p.steps), description="step", layout=wide)
    step = field("its value", "a number or a list")

    def read(key, text):
        kind = {**p.answers, **p.steps}[key]
        words = ("word",) if kind.startswith("choice") else ()
        x = typed(text, p.givens, words)
        return int(x) if kind.partition(",")[0] in WORDS and type(x) is float else x

    def checked(check, texts):
        try:
            given = {k: read(k, t) for k, t in texts.items()}
            given = {k: x for k, x in given.items() if x is not None}
            say(check(**given) if given else HTML("Write a value first, as [1.0, 0, -2.5]."))
        except (AnswerError, ValueError) as error:
            say(HTML(f"<pre>{_escaped(error)}</pre>"))

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
        for w in (*answers.values(), step):
            w.value = ""
        chosen.options = list(p.steps)
        show()
        say(HTML(""))

    rows = [
        top,
        *answers.values(),
        HBox([
            button("Check", check_answers, "Check the answers"),
            button("Next step", lambda: say(p.next_step()), "Where to go on; again: more"),
            button("Solution", lambda: say(p.solution()), "The solution in these numbers"),
            button("New numbers", new, "The same problem with other numbers"),
        ]),
        *([HBox([chosen, step, button("Check step", check_step, "Check one step")])]
          if p.steps else []),
        said,
    ]  # fmt: skip
    show()
    form = VBox(rows)
    display(form)
    return form


def _escaped(error):
    from html import escape

    return escape(str(error))
