"""A prediction in a notebook: the question, and below it buttons or a field, which go once it is
answered. The answer is written into the output, so that the saved notebook shows it.
"""

from typing import Any

from ...algebra.language import _
from .page import STATIC, folded_html, plain
from .question import LETTERS


def show_prediction(p: Any) -> None:
    """Show a prediction; folded where ipywidgets is missing."""
    from IPython.display import display

    try:
        import ipywidgets
    except ImportError:
        static = folded_html(p.question)
        display({"text/html": static, "text/plain": repr(p), STATIC: static}, raw=True)
        return
    shown = display(_bundle(p), raw=True, display_id=True)
    if p.given is None:
        display(_Panel(p, ipywidgets, shown).box)


def _bundle(p):
    html = p.html()
    return {"text/html": html, "text/plain": plain(html), STATIC: folded_html(p.question)}


class _Panel:
    """The widgets of one prediction."""

    def __init__(self, p, widgets, shown):
        self.p, self.widgets, self.shown = p, widgets, shown
        made = [
            self._button(*pair) for pair in zip(LETTERS, p.question.choices or (), strict=False)
        ]
        wrapped = widgets.Layout(flex_flow="row wrap")
        self.box = widgets.HBox(made, layout=wrapped) if made else self._field()

    def _button(self, letter, choice):
        narrow = self.widgets.Layout(width="3em")
        made = self.widgets.Button(
            description=letter, tooltip=_("Predict {letter}", letter=letter), layout=narrow
        )
        made.on_click(lambda button: self._chosen(choice))  # which may read as another letter
        return made

    def _field(self):
        asked = f"{_('a number')}, {self.p.question.unit}".removesuffix(", ")
        hint = _("your words") if self.p.question.number is None else asked
        field = self.widgets.Text(placeholder=hint, continuous_update=False)
        button = self.widgets.Button(description=_("Predict"))
        field.observe(lambda change: self._chosen(change.new), "value")
        button.on_click(lambda button: self._chosen(field.value))
        return self.widgets.HBox([field, button])

    def _chosen(self, prediction):
        if prediction.strip():
            self.p.choose(prediction)
            self.box.layout.display = "none"
            self.shown.update(_bundle(self.p), raw=True)
