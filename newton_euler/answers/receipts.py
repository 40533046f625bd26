"""The functions ``expect`` and ``receipt`` of a student's notebook: what a problem asks for, and a
check and a record of the *form* of the answers (kind, shape, finite numbers, known symbols, the
dimension of formulas), as JSON. Neither function holds or needs the key.
"""

import json
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from ..algebra.errors import checked
from ..algebra.language import Words, _
from .checks import Check, check
from .forms import AnswerError, Form
from .givens import in_notebook, outdated, seals, stale
from .messages import OpenAnswer
from .notation import formula, is_word, symbol, unit_symbol
from .sanity import doubts
from .trees import NODES, dimension_hints, in_words

_expected: dict = {}
receipts: dict = {}


@checked
def expect(
    problem: str,
    symbols: dict[str, str] | None = None,
    notation: dict[str, str] | None = None,
    sane: dict | bool | None = None,
    **forms: str,
) -> None:
    """Announce what ``problem`` asks for, each answer by its form.

    symbols, notation : maps the symbols of formulas to their units, and names to LaTeX where
        :func:`~newton_euler.answers.notation.symbol` would print another symbol
    sane : maps answers to what any answer must be, see :func:`~newton_euler.answers.sanity.doubts`;
        a receipt warns of one that is not; False: no warnings, as in exams

    >>> expect("0/1", v="vector, mm/s")
    >>> expect("0/2", {"r": "m", "omega": "rad/s"}, v="expression, m/s")
    """
    read = {key: Form.read(text) for key, text in forms.items()}
    known = sane if sane is False else dict(sane or {})  # type: ignore[arg-type]
    _expected[problem] = read, dict(symbols or {}), dict(notation or {}), known


@checked
def receipt(
    problem: str, names: Mapping[str, object] | None = None, /, **answers: object
) -> "Receipt":
    """A :class:`Receipt` that shows how each answer to ``problem`` was read; None stands for an
    answer that is not given yet. Raises :class:`AnswerError`, which names every answer that cannot
    be read; under nbgrader's Validate, where answers are open as well.

    names : where answers are looked up that are not passed, as ``globals()``

    >>> expect("0/1", v="vector, mm/s")
    >>> receipt("0/1", v=[1, 2.5, 0])
    0/1: v = [1, 2.5, 0] mm/s. Form checked only; the key is not here.
    """
    forms, symbols, notation, sane = _asked(problem, answers)
    old = outdated(problem, forms.keys() - answers.keys())
    there = {key: (names or {}).get(key) for key in forms}
    answers = there | dict.fromkeys(old) | answers
    read, faults = record(forms, symbols, answers)
    receipts[problem] = {"problem": problem, "answers": read, "faults": faults}
    if faults:
        raise AnswerError("\n".join(f"{problem}, {key}: {fault}" for key, fault in faults.items()))
    execution = os.environ.get("NBGRADER_EXECUTION")
    _refuse_in(execution, problem, _blank(forms, read))
    others = {key for forms, *_others in _expected.values() for key in forms}
    warning = "; ".join([*old.values(), *filter(None, [stale(problem, answers, others)])])
    # slow, and not needed in grading
    checks = {} if execution else _checked(seals.get(problem, {}), forms, read)
    doubted = None if sane is False else _doubted(forms, read, symbols, sane)
    return Receipt(problem, read, forms, symbols, warning, notation, doubted, checks)


def _asked(problem, answers):
    """What was announced of a problem; refuses answers that it does not ask for."""
    if problem not in _expected:
        raise AnswerError(
            "problem {problem} has not been announced; run the cells of the notebook from the top",
            problem=repr(problem),
        )
    forms = _expected[problem][0]
    for key in (key for key in answers if key not in forms):
        text = Words("problem {problem} does not ask for {key}; it asks for {asked}")
        raise AnswerError(text, problem=problem, key=repr(key), asked=", ".join(forms))
    return _expected[problem]


def _refuse_in(execution, problem, blank):
    """Refuse open answers where nbgrader validates, and refuse its own grading."""
    if execution == "validate" and blank:
        text = Words("{problem}: no answer yet for {blank}; an open answer earns no points")
        raise OpenAnswer(text, problem=problem, blank=blank)
    if execution == "autograde":
        raise AnswerError(
            "{problem} is not graded here, since nbgrader runs without this course's "
            "configuration; use its nbgrader_config.py, or python -m grader grade",
            problem=problem,
        )


def _checked(sealed, forms, read):
    """{answer: its check} of the answers that have a seal."""
    given = {k: seal for k, seal in sealed.items() if k in forms and read.get(k) is not None}
    found = {k: check(seal, forms[k].kind, read[k]) for k, seal in given.items()}
    return {k: outcome for k, outcome in found.items() if outcome}


def _doubted(forms, read, symbols, sane):
    """{answer: why it is impossible} of the impossible answers."""
    beside = {k: (form, read.get(k)) for k, form in forms.items()}
    found = {k: doubts(f, read.get(k), symbols, sane.get(k), beside) for k, f in forms.items()}
    return {k: why for k, why in found.items() if why}


def _blank(forms, read):
    """The names of the answers that are not given yet, as text."""
    return ", ".join(key for key in forms if read.get(key) is None)


@dataclass(frozen=True, repr=False)
class Receipt:
    """The answers to one problem as they were read; ``json`` is the record, ``warning`` names
    answers that were computed with the numbers of another problem, ``notation`` is the LaTeX of
    names that are printed otherwise than they read, ``doubted`` has the reasons why answers are
    impossible, whatever the key (None: nothing is doubted, not even the unit of a formula),
    ``checks`` whether they are right, where the instructor lets a receipt check it.
    """

    problem: str
    answers: dict
    forms: dict
    symbols: dict
    warning: str = ""
    notation: dict = field(default_factory=dict)
    doubted: dict | None = field(default_factory=dict)
    checks: dict[str, Check] = field(default_factory=dict)

    @property
    def verdicts(self) -> dict[str, bool | None]:
        """{answer: whether it is right}; None where a check must wait."""
        return {key: found.right for key, found in self.checks.items()}

    @property
    def json(self) -> str:
        """The record that is handed in, as JSON text."""
        return json.dumps({"problem": self.problem, "answers": self.answers})

    def _ipython_display_(self):
        """Typeset in a notebook, else printed: as the value of its cell, nbgrader would take it for
        points.
        """
        if in_notebook():
            from IPython.display import display

            wrong = {key: found.wrong for key, found in self.checks.items() if found.wrong}
            counts = {"metadata": {"newton_euler": {"wrong": wrong}}} if wrong else {}
            display({"text/plain": repr(self), "text/markdown": self.markdown}, raw=True, **counts)
        else:
            print(repr(self))

    def __repr__(self):
        if not self._given:
            again = _(" Look again: {warning}.", warning=self.warning) if self.warning else ""
            return _("{problem}: no answer yet.{again}", problem=self.problem, again=again)
        read = "; ".join(self._as_text(key, tree) for key, tree in self._given.items())
        hints = "".join(f"\n  {hint}" for hint in self._hints())
        return f"{self.problem}: {read}. {self._remarks()}{hints}"

    @property
    def markdown(self) -> str:
        """The same as Markdown, with the answers as formulas."""
        if not self._given:
            return _escaped(repr(self))
        read = "; ".join(self._as_markdown(key, tree) for key, tree in self._given.items())
        hints = "".join(f"\n- {_escaped(hint)}" for hint in self._hints())
        space = "\n" if hints else ""
        return f"**{self.problem}:** {read}. {_escaped(self._remarks())}{space}{hints}"

    @property
    def _given(self):
        return {key: tree for key, tree in self.answers.items() if tree is not None}

    def _as_text(self, key, tree):
        between = _(", in ") if isinstance(tree, dict) else " "  # components in several frames
        kind, unit = self.forms[key].kind, self.forms[key].unit
        text = f"{key} = {in_words(kind.in_rows(tree))}{between}{unit}"
        return text.removesuffix(f"{between}1")

    def _as_markdown(self, key, tree):
        form = self.forms[key]
        if form.kind.has_options:
            return f"`{key}`: {_escaped(tree)}"
        between = r",\ \text{in}" if isinstance(tree, dict) and form.unit != "1" else ""
        written = formula(form.kind.in_rows(tree), self.notation)
        value = f"= {written}{between}{unit_symbol(form.unit)}"
        if is_word(key) and key not in self.notation:
            return f"`{key}` ${value}$"
        return f"${self.notation.get(key) or symbol(key, form.kind.is_vector)} {value}$"

    def _hints(self):
        if self.warning:
            yield _("look again: {warning}", warning=self.warning)
        for key, tree in self._given.items() if self.doubted is not None else ():
            for doubt in self.doubted.get(key, ()):
                yield _("look again at {key}: {doubt}", key=key, doubt=doubt)
            if self.forms[key].kind.is_formula:
                found = dimension_hints(tree, self.forms[key], self.symbols)
                yield from (_("look again at {key}: {hint}", key=key, hint=hint) for hint in found)

    def _remarks(self):
        blank = _blank(self.forms, self._given)
        remarks = _("Form checked only; the key is not here.")
        if self.checks:
            remarks = f"{'; '.join(f'{key} {found}' for key, found in self.checks.items())}."
        return remarks + (_(" Still open: {blank}.", blank=blank) if blank else "")


def _escaped(text):
    """A plain text in Markdown."""
    return re.sub(r"([\\`*_<>$\[\]^~])", r"\\\1", text)


def record(
    forms: Mapping[str, Form], symbols: Mapping[str, str], answers: Mapping[str, Any]
) -> tuple[dict[str, Any], dict[str, str]]:
    """({key: tree or None}, {key: fault}) of the answers, read according to their forms."""
    read: dict[str, Any] = {}
    faults: dict[str, str] = {}
    budget = [NODES]
    for key, form in forms.items():
        value, left = answers.get(key), budget[0]
        try:
            read[key] = None if value is None else form.kind.read(value, form, symbols, budget)
        except AnswerError as error:
            faults[key], budget[0] = str(error), left
        # objects of any library may fail in any way: that answer is refused, the others are read
        except Exception as error:
            text = Words("the value given cannot be read: {name}: {error}")
            fault = form.error(text, name=type(error).__name__, error=error)
            faults[key], budget[0] = str(fault)[:500], left
    return read, faults
