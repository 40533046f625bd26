"""A form for a notebook: text fields and buttons, all within reach of the keyboard. It has no list
to choose from: in one, JupyterLab takes letters and arrows as commands, and D D deletes the cell.
"""

from dataclasses import dataclass
from html import escape
from typing import Any

from ...algebra.language import Words, _
from ...answers.forms import AnswerError, Form
from .typed import typed

INSTALL = Words(
    "p.form() needs ipywidgets: pip install ipywidgets; without it, p.check(...), "
    "p.check_step(...), p.next_step() and p.solution() do the same"
)


@dataclass(frozen=True)
class Ways:
    """How an answer and a step are checked, and other numbers taken: calls, or a form's buttons."""

    answer: str = Words("by p.check({name}=...)")
    step: str = Words("by p.check_step({name}=...)")
    new: str = "p.new()"


PRESSED = Ways(
    Words("in the field {name} above, by Check"),
    Words("in the field of steps, as {name} with its value, by Check step"),
    Words("New numbers"),
)


def show_form(p: Any) -> Any:
    """A practice problem with a field for each answer, a field for any step, and buttons for hints,
    the solution and other numbers; the last message stands below. Needs ipywidgets.
    """
    try:
        import ipywidgets
    except ImportError:
        raise ImportError(_(INSTALL)) from None
    return _Panel(p, ipywidgets).box


class _Panel:
    """The widgets of one problem."""

    def __init__(self, p, widgets):
        self.p, self.widgets = p, widgets
        self.top, self.below = widgets.Output(), widgets.Output()
        self.answers = {k: self._field(k, _as_typed(f), f.of) for k, f in self._forms(p.answers)}
        hint = _("the name of a step; arrow down lists them")
        self.chosen = self._field(_("step"), hint, p.steps)
        self.chosen.observe(self._expect, "value")
        self.means = widgets.HTML(layout=widgets.Layout(margin="0 0 0 9.5em"))
        self.step = self._field(_("its value"), _("a number or a list"))
        buttons = self._row(
            (_("Check"), lambda: self._check(p.check, self.answers), _("Check the answers")),
            (_("Next step"), lambda: self._show(p.next_step()), _("Where to go on; again: more")),
            (_("Solution"), lambda: self._show(p.solution()), _("The solution in these numbers")),
            (_("New numbers"), self._new_numbers, _("The same problem with other numbers")),
        )
        check = lambda: self._check(p.check_step, {self.chosen.value: self.step})  # noqa: E731
        one = self._row((_("Check step"), check, _("Check one step")))
        steps = [self.chosen, self.means, self.step, one]
        rows = [self.top, *self.answers.values(), buttons, *(steps if p.steps else ()), self.below]
        self.box = widgets.VBox(rows)
        self._pressed(self._show_problem)

    def _forms(self, texts):
        return [(key, Form.read(text)) for key, text in texts.items()]

    def _field(self, name, shown, words=()):
        return self.widgets.Combobox(
            description=name, placeholder=shown, options=tuple(words), continuous_update=False,
            layout=self.widgets.Layout(width="100%", max_width="48em"),
            style={"description_width": "9em"},
        )  # fmt: skip

    def _row(self, *buttons):
        made = [self._button(*button) for button in buttons]
        return self.widgets.HBox(made, layout=self.widgets.Layout(flex_flow="row wrap"))

    def _button(self, text, action, tip):
        wide = self.widgets.Layout(width="auto", flex="0 0 auto")
        made = self.widgets.Button(description=text, tooltip=tip, layout=wide)
        made.on_click(lambda button: self._pressed(action))
        return made

    def _pressed(self, action):
        with self.p.spoken_of(PRESSED):
            action()

    def _expect(self, change=None):
        # never in the field of the value: a change there loses what is being typed
        form = dict(self._forms(self.p.steps)).get(name := self.chosen.value)
        self.means.value = escape(f"{self.p.meanings[name]}: {_as_typed(form)}") if form else ""

    def _check(self, check, fields):
        try:
            read = {key: self._read(key, field.value) for key, field in fields.items()}
            given = {key: x for key, x in read.items() if x is not None}
            message = check(**given) if given else self.widgets.HTML(_("Write a value first."))
        except (AnswerError, ValueError) as error:
            message = self.widgets.HTML(f"<div>{escape(str(error))}</div>")
        self._show(message)

    def _read(self, key, text):
        form = dict(self._forms({**self.p.answers, **self.p.steps})).get(key)
        x = typed(text, self.p.givens, form.of if form else ())
        return int(x) if form and form.kind.is_word and type(x) is float else x

    def _new_numbers(self):
        self.p.new()
        for field in (*self.answers.values(), self.chosen, self.step):
            field.value = ""
        self.chosen.options = tuple(self.p.steps)
        self._show_problem()
        self._show(self.widgets.HTML(""))

    def _show_problem(self):
        _replace(self.top, self.p)

    def _show(self, message):
        _replace(self.below, message)


def _replace(output, shown):
    """Show something in an output in place of what it showed."""
    from IPython.display import clear_output, display

    with output:
        clear_output(wait=True)
        display(shown)


def _as_typed(form):
    """What is typed in a field, and its unit."""
    return form.words.partition(", ")[2] if form.kind.length > 1 else form.words
