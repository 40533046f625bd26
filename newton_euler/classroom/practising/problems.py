"""A problem to practise: its numbers, checks of answers and steps, hints, and the solution."""

import contextlib
import math
import re
import textwrap
from base64 import b64encode
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape
from typing import Any

from ...algebra.language import Words, _, from_stored, joined, spoken
from ...algebra.names import Guided, did_you_mean
from ...answers.causes import Cause, sentence
from ...answers.fit import rounding
from ...answers.forms import AnswerError
from ...answers.givens import in_notebook
from ...answers.notation import number_symbol, unit_symbol
from ...answers.receipts import record
from ...answers.tolerance import EARLY
from ...answers.trees import NODES, in_words
from ...answers.verdicts import explain, judge, value_line
from .files import HELP, PracticeFile
from .numbers import KeptNumbers, Quantity
from .panel import Ways, show_form
from .progress import Progress

WIDTH = 80  # columns of a terminal


@dataclass(frozen=True, repr=False)
class Message:
    """A message: ``text`` in a terminal, ``markdown`` in a notebook."""

    text: str
    markdown: str

    def __repr__(self) -> str:
        return self.text

    def _repr_markdown_(self) -> str:
        return _without_tags(self.markdown)


def _without_tags(markdown):
    """The same, in which nothing is read as HTML and no picture is fetched: a practice file may
    come from anywhere.
    """
    return re.sub(r"<(?=[A-Za-z/!?])|!(?=\[)", r"\g<0> ", markdown)


@dataclass(frozen=True, repr=False)
class CheckResult(Message):
    """What a check found: ``verdicts`` is {key: right, wrong, unreadable or blank}, ``explained``
    is {key: the causes that explain a wrong one}, ``sentences`` is {key: the sentence}.
    """

    verdicts: dict[str, str]
    explained: dict[str, tuple[Cause, ...]]
    sentences: dict[str, str]

    @property
    def causes(self) -> dict[str, str | None]:
        """{key: the mistake that explains a wrong one in words, or None}."""
        return {key: sentence(causes) for key, causes in self.explained.items()}


class PracticeProblem(Guided):
    """One problem of a practice file with one set of numbers at a time, the book's first. ``p``
    alone shows text and figure; ``p.new()`` takes other numbers, which ``p.givens`` has by name;
    ``p.check(...)``, ``p.check_step(...)``, ``p.next_step()``, ``p.solution()``.
    """

    def __init__(self, file: PracticeFile, problem: str, progress: Progress):
        self._file, self._progress = file, progress
        self._page = file.page(problem)
        self.help: str = self._page.get("help", file.help)  # the most that is shown
        self.id: str = problem
        self._ways = Ways()
        self._all = [Quantity.read(q) for q in self._page["quantities"]]
        self._take(0)

    def _take(self, number):
        self.number = number
        self._variant = self._page["variants"][number]
        self._numbers = KeptNumbers(self._all, self._page, number)
        self._asked = {q.key: q for q in self._numbers.answers}
        self._found: dict[str, Any] = {}
        self._trees: dict[str, Any] = {}
        self._passed: set[str] = set()
        self._shown: dict[str, int] = {}  # how much help was asked for, by quantity

    # -- the problem

    @property
    def givens(self) -> dict[str, float]:
        """The numbers of the problem, by name, in the units of its text."""
        return {n: x for n, (x, *_) in self._variant["givens"].items()}

    @property
    def symbols(self) -> dict[str, str]:
        """How the text writes them, in LaTeX, by name."""
        return self._page.get("symbols", {})

    @property
    def answers(self) -> dict[str, str]:
        """What is asked for: {name: form}."""
        return {q.key: str(q.form) for q in self._asked.values() if not q.step}

    @property
    def steps(self) -> dict[str, str]:
        """The steps that can be checked, in order: {name: form}."""
        return {q.key: str(q.form) for q in self._asked.values() if q.step}

    @property
    def meanings(self) -> dict[str, str]:
        """What the steps and answers are: {name: words}."""
        return {q.key: q.plain for q in self._asked.values()}

    @property
    def quantities(self) -> list[Quantity]:
        """The steps that can be checked, and then the answers."""
        return list(self._asked.values())

    @property
    def title(self) -> str:
        """Its title, without its number."""
        return self._page["title"]

    @property
    def solved(self) -> dict[str, tuple]:
        """The right values of steps and answers, by name, as their components."""
        return {key: points[0] for key, points in self._numbers.key.items()}

    @property
    def statement(self) -> str:
        """Its text with these numbers in Markdown, without its title."""
        text = self._variant["statement"].partition("\n")[2].strip()
        preamble = self._page["preamble"]
        return f"{text}\n\n{preamble}" if preamble else text

    @property
    def sets(self) -> int:
        """How many sets of numbers there are."""
        return len(self._page["variants"])

    @property
    def figure(self) -> bytes | None:
        """The figure as PNG or SVG, or None."""
        name = self._variant.get("figure")
        return self._file.read(name) if name else None

    @property
    def picture(self) -> tuple[str, str]:
        """The figure as an address for <img>, in which nothing of it runs, and its words; ""
        without a figure.
        """
        kind = "svg+xml" if self._variant.get("figure", "").endswith(".svg") else "png"
        data = b64encode(self.figure or b"").decode()
        words = self._page["figure"] and _("Figure: {words}", words=self._page["figure"])
        return (f"data:image/{kind};base64,{data}", words) if data else ("", words)

    def new(self) -> "PracticeProblem":
        """The same problem with other numbers; after the last set, the first comes again."""
        self._take((self.number + 1) % len(self._page["variants"]))
        return self

    def book(self) -> "PracticeProblem":
        """The same problem with the first set of numbers: those of the book, where it has any."""
        self._take(0)
        return self

    def forget(self) -> None:
        """Forget what was answered with these numbers, as if none of it had been tried."""
        self._take(self.number)

    def __repr__(self) -> str:
        lines = [f"{self.id} {self._page['title']}", "", *_wrapped(self._variant["text"])]
        if self._page["preamble"]:
            lines += ["", *_wrapped(self._page["preamble"])]
        givens = self._variant["givens"]
        lines += [""] * bool(givens)
        lines += [f"  {n} = {x:.6g}{_behind(unit)}  {means}".rstrip()
                  for n, (x, unit, means) in givens.items()]  # fmt: skip
        if self._page["figure"]:
            lines += ["", *_wrapped(_("Figure: {words}", words=self._page["figure"]))]
        lines += ["", _("Find")] + [f"  {q.key}: {q.plain} ({_stated(q.form)})"
                                 for q in self._asked.values() if not q.step]  # fmt: skip
        return "\n".join([*lines, "", self._count()])

    def _count(self):
        text = Words("Numbers {number} of {all}; {how} takes others.")
        return _(text, number=self.number + 1, all=self.sets, how=self._ways.new)

    def _repr_markdown_(self) -> str:
        head = self._variant["statement"].partition("\n")[0]
        numbers = ", ".join(f"`{n} = {x:.6g}`" for n, x in self.givens.items())
        numbers = f"\n\n*{_('Names to type:')}* {numbers}" if numbers else ""
        return _without_tags(f"{head}\n\n{self.statement}{numbers}\n\n*{self._count()}*")

    def _ipython_display_(self):
        if not in_notebook():
            print(self)
            return
        from IPython.display import HTML, Markdown, display

        display(Markdown(self._repr_markdown_()))
        address, words = self.picture
        if address:  # JupyterLab leaves out the text of an Image
            display(HTML(f'<img alt="{escape(words)}" src="{address}">'))

    def form(self) -> Any:
        """The problem as a form with fields and buttons, in a notebook with ipywidgets."""
        return show_form(self)

    @contextlib.contextmanager
    def spoken_of(self, ways: Ways) -> Iterator[None]:
        """A context in which hints and errors name these ways."""
        before, self._ways = self._ways, ways
        try:
            yield
        finally:
            self._ways = before

    # -- checks

    def check(self, *nameless: object, **answers: object) -> CheckResult:
        """Whether answers are right, and what explains a wrong one: ``p.check(v_D=[1, 2, 0])``."""
        return self._check(nameless, answers, self.answers, _OF_ANSWERS, self._ways.step)

    def check_step(self, *nameless: object, **steps: object) -> CheckResult:
        """The same for any of ``p.steps``. The message says so where one follows rightly from a
        wrong one.
        """
        return self._check(nameless, steps, self.steps, _OF_STEPS, self._ways.answer)

    def _check(self, nameless, given, names, refusals, other):
        none, write, no_such = refusals
        if not names:
            raise AnswerError(none, problem=self.id)
        if nameless:
            raise AnswerError(
                "write the name before each value, as {name}=...", name=next(iter(names))
            )
        if not given:
            raise AnswerError(write, names=", ".join(names))
        for key in given:
            if key not in names:
                unknown = _(no_such, problem=self.id, key=repr(key), names=", ".join(names))
                hint = did_you_mean(key, names)
                if key in self._asked:
                    hint = _(". {key} is checked {how}", key=key, how=_(other, name=key))
                raise AnswerError(unknown + hint)
        forms = {key: self._asked[key].form for key in given}
        trees, faults = record(forms, {}, given)
        for key, form in forms.items():
            tree, fault = trees.get(key), faults.get(key)
            self._trees[key] = tree
            self._found[key] = judge(self._asked[key], form, tree, fault, self._numbers, [NODES])
        self._numbers.tried = self._found
        sentences, explained = {}, {}
        verdicts = {key: self._found[key].verdict for key in given}
        for key, verdict in verdicts.items():
            sentences[key], explained[key] = self._explained(key)
            if verdict in ("right", "wrong"):
                cause = next(iter(explained[key]), None)
                self._progress.tried(self.id, self.number, key, verdict == "right", cause)
        text = "\n".join(f"{key}: {words}" for key, words in sentences.items())
        marks = {k: f"{_MARKS.get(v, '')} `{k}` {self._read(k)}" for k, v in verdicts.items()}
        markdown = "\n".join(f"- {marks[key]}: {words}" for key, words in sentences.items())
        return CheckResult(text, markdown, verdicts, explained, sentences)

    def _read(self, key):
        form, tree = self._asked[key].form, self._trees[key]
        return value_line(form, tree, self._found[key].verdict)

    def _explained(self, key):
        """(message, the causes that explain it) of a quantity that was checked."""
        found = self._found[key]
        if found.verdict == "right":
            return (_(_EARLY) if self._rounded_early(key) else _("right")), ()
        if found.verdict != "wrong" or found.given is None:
            return found.message, ()
        why = explain(self._asked[key], self._found, self._numbers)
        if not why.earlier:
            return why.message, why.causes
        text = Words("not right; it follows correctly from your {names}: correct that first{also}")
        return _(text, names=joined(why.earlier), also=why.also), why.causes

    def _rounded_early(self, key):
        given, kind = self._found[key].given, self._asked[key].kind
        if kind.is_word:
            return False
        (right,) = kind.like(self._numbers.key[key], given)
        least, pairs = EARLY * math.hypot(*right), zip(given[0], right, strict=True)
        return any(abs(x - k) > max(least, 2 * rounding((x,))) for x, k in pairs)

    # -- help

    def next_step(self) -> Message:
        """Where to go on: the first quantity that is not right yet, and the section it needs. Asked
        again, its equation and what it is computed from; then its value.
        """
        if self.help == HELP[0]:
            return _plain(_("this practice file gives no hints"))
        waiting = (q for q in self._asked.values() if q.key not in self._passed
                   and getattr(self._found.get(q.key), "verdict", "") != "right")  # fmt: skip
        if not (q := next(waiting, None)):
            none = _("nothing is left to find; {how} takes other numbers", how=self._ways.new)
            return _plain(none)
        most = 3 if self.help == HELP[2] else 2
        level = self._shown[q.key] = min(self._shown.get(q.key, 0) + 1, most)
        self._progress.helped(self.id, self.number, q.key, level)
        if level == 3:
            self._passed.add(q.key)
        return Message(self._hint(q, level, False), self._hint(q, level, True))

    def _hint(self, q, level, typeset):
        name = f"`{q.key}`" if typeset else q.key
        how = _(self._ways.step if q.step else self._ways.answer, name=q.key)
        where = _(" Section {number}.", number=q.section) if q.section else ""
        means = (q.means if typeset else q.plain).rstrip(".")
        text = Words("Find {name} ({form}): {means}.{where} Try it {how}.")
        lines = [_(text, name=name, form=_stated(q.form), means=means, where=where, how=how)]
        lines += self._how(q, typeset) if level >= 2 else ()
        lines += [_("It is {value}.", value=self._value(q, typeset))] if level >= 3 else ()
        return ("\n\n" if typeset else "\n").join(lines)

    def _how(self, q, typeset):
        if q.equation:
            yield _("It is found by equation ({number}).", number=q.equation)
        if terms := self._variant["terms"].get(q.key) if typeset else None:
            listed = "; ".join(map(spoken, map(from_stored, terms)))
            yield _("It is the sum of {terms}.", terms=listed)
        if before := self._numbers.program.earlier.get(q.key, ()):
            names = ", ".join(f"`{n}`" if typeset else n for n in before)
            yield _("It is computed from {names}.", names=names)
        elif not q.equation:
            yield _("It is computed from what is given.")

    def _value(self, q, typeset):
        x = self._numbers.key[q.key][0]
        if q.kind.is_word:
            return str(x[0])
        if not typeset:
            return in_words(q.kind.nested(x)) + _behind(q.unit)
        stated = q.kind.typeset([number_symbol(part) for part in x])
        return f"${q.latex and q.latex + ' = '}{stated}{unit_symbol(q.unit)}$"

    def solution(self) -> Message:
        """The solution with the present numbers: all steps, the terms of sums, the answers."""
        if self.help != HELP[2]:
            return _plain(_("this practice file has no solutions"))
        for q in self._asked.values():
            self._progress.helped(self.id, self.number, q.key, 3)
            self._passed.add(q.key)
        lines = [f"{q.key} = {self._value(q, False)}  {q.plain}" + (
                    _(", section {number}", number=q.section) if q.step and q.section else "")
                 for q in self._asked.values()]  # fmt: skip
        return Message("\n".join(lines), self._variant["solution"])


# said if a problem has none, if none is given, if it has no such one
_OF_ANSWERS = (
    Words("{problem} has no answers to check in this practice file"),
    Words("write a value for an answer: {names}"),
    Words("{problem} has no answer {key}; it has {names}"),
)
_OF_STEPS = (
    Words("{problem} has no steps to check in this practice file"),
    Words("write a value for a step: {names}"),
    Words("{problem} has no step {key}; it has {names}"),
)
_MARKS = {"right": "✓", "wrong": "✗", "unreadable": "?"}
_EARLY = Words("right, but rounded too early: keep more digits on the way, and round at the end")


def _behind(unit):
    return "" if unit == "1" else f" {unit}"


def _stated(form):
    """A form for a reader: "vector, mm/s"; "count"."""
    return form.stated.removesuffix(", 1")


def _wrapped(text):
    """The lines of paragraphs, for a terminal."""
    for n, paragraph in enumerate(text.split("\n\n")):
        yield from [""] * bool(n)
        yield from textwrap.wrap(paragraph, WIDTH, break_on_hyphens=False)


def _plain(text):
    return Message(text, text)
