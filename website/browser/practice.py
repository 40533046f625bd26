"""Practice on a page: the form of a problem, what is typed in it, checks, hints, what to do next.

A page hands over the practice files that it has fetched, and what it keeps of the reader's
progress; nothing of either leaves the browser.
"""

from base64 import b64decode
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

from newton_euler.algebra.errors import NewtonEulerError
from newton_euler.algebra.language import Words, _, choose_language, languages
from newton_euler.answers.forms import AnswerError
from newton_euler.answers.notation import formula, list_symbol, number_symbol, unit_symbol
from newton_euler.classroom.practising.advice import advise, causes_of
from newton_euler.classroom.practising.collection import Practice
from newton_euler.classroom.practising.files import HELP, PracticeFile
from newton_euler.classroom.practising.numbers import Quantity
from newton_euler.classroom.practising.panel import Ways
from newton_euler.classroom.practising.problems import Message, PracticeProblem
from newton_euler.classroom.practising.progress import Progress
from newton_euler.classroom.practising.typed import typed, typed_tree

ON_A_PAGE = Ways(
    Words("in its fields, by Check"),
    Words("among the steps below, by Check step"),
    Words('"New numbers"'),
)


_progress = Progress(None)  # the page keeps it
_books: dict[str, Practice] = {}  # by file, the one opened last at the end


def load(name: str, data: str, language: str = "en") -> dict[str, list[str]]:
    """Open the practice file of this name, ``data`` in base64; {problem: [title, section]} of those
    in it. Speaks the ``language`` of the page from now on, if it is known. Raises
    :class:`PracticeFileError` for another file.
    """
    if language in languages():
        choose_language(language)
    path = Path(mkdtemp(), "file.practice")
    path.write_bytes(b64decode(data))
    file = PracticeFile(path, name)
    _books.pop(name, None)
    _books[name] = Practice([file], _progress)
    return {problem: file.titles[problem] for problem in file.problems}


def _problem(number: str) -> PracticeProblem:
    """A problem of the files that were opened, the last first."""
    for book in reversed(_books.values()):
        if number in book:
            return book[number]
    raise NewtonEulerError(
        _("no practice file that was opened has problem {number}", number=number)
    )


def show(problem: str, new: bool = False) -> dict[str, Any]:
    """A problem with its numbers, the next ones if ``new``: its text in Markdown, its figure as the
    address of an image, the names that may be typed, the fields of its answers and steps.
    """
    p = _problem(problem)
    if new:
        p.new()
    figure, words = p.picture
    return {
        "id": p.id, "title": p.title, "text": p.statement, "figure": figure, "words": words,
        "number": p.number + 1, "sets": p.sets, "names": p.givens,
        "answers": [_field(q) for q in p.quantities if not q.step],
        "steps": [_field(q) for q in p.quantities if q.step],
        "hints": p.help != HELP[0], "solution": p.help == HELP[2],
    }  # fmt: skip


def _field(q: Quantity) -> dict[str, Any]:
    """What a page needs to ask for a quantity: a field for each of ``parts``, or one of ``of``."""
    kind = q.kind
    return {
        "key": q.key, "means": q.means, "symbol": q.latex, "unit": unit_symbol(q.unit).strip(),
        "kind": str(q.form), "parts": kind.places(), "of": list(q.of), "section": q.section,
    }  # fmt: skip


def read(problem: str, key: str, texts: Sequence[str]) -> dict[str, str]:
    """How the texts in the fields of a quantity are read, as they are typed: {"latex": …, "fault":
    …}, one of them "".
    """
    p = _problem(problem)
    q = _quantity(p, key)
    try:
        value = _value(p, q, texts)
    except ValueError as error:
        return {"latex": "", "fault": str(error)}
    latex = "" if value is None or q.kind.is_word else _as_read(p, q, texts, value)
    return {"latex": latex, "fault": ""}


def _as_read(p, q, texts, value):
    """The formulas that were typed and, where they are not plain numbers, what they come to."""
    trees = [typed_tree(text, p.givens) for text in texts if text.strip()]
    trees = _flat(trees[0]) if len(trees) == 1 and isinstance(trees[0], tuple) else trees
    stated = _typeset(q.kind, [formula(tree, p.symbols) for tree in trees])
    if all(isinstance(tree, float) for tree in trees):
        return stated + unit_symbol(q.unit)
    numbers = [*map(number_symbol, _flat(value))]
    return f"{stated} = {_typeset(q.kind, numbers)}{unit_symbol(q.unit)}"


def _typeset(kind, parts):
    """Components as one formula, in a list where there are not as many as the kind has."""
    whole = len(parts) == kind.length
    return kind.typeset(parts) if whole else rf"\left[{list_symbol(parts)}\right]"


def _flat(value):
    if not isinstance(value, (list, tuple)):
        return [value]
    return [x for part in value for x in _flat(part)]


def _quantity(p, key):
    for q in p.quantities:
        if q.key == key:
            return q
    raise NewtonEulerError(_("{problem} has no quantity {key}", problem=p.id, key=repr(key)))


def _value(p, q, texts):
    """The value in the fields of a quantity; None if all are empty. A list may stand in the first.
    Raises :class:`ValueError`.
    """
    found = [typed(text, p.givens, q.of) for text in texts]
    if all(x is None for x in found):
        return None
    if q.kind.is_word:
        return int(found[0]) if isinstance(found[0], float) and found[0] % 1 == 0 else found[0]
    parts = [found[0]] if isinstance(found[0], list) and not any(texts[1:]) else found
    lists = [t for t, x in zip(texts, found, strict=True) if isinstance(x, list)]
    if lists and (parts is found or q.kind.length == 1):
        raise AnswerError(
            "{text} has a comma: write a decimal point, as -2.5, and nothing between thousands",
            text=repr(lists[0][:60]),
        )
    if None in parts:
        missing = q.kind.places()[parts.index(None)]
        raise AnswerError("write the {missing}, too; 0 where there is none", missing=missing)
    parts = _flat(parts)
    return q.kind.nested(parts) if len(parts) == q.kind.length else parts


def check(problem: str, fields: Mapping[str, Sequence[str]]) -> dict[str, Any]:
    """Whether the answers and steps in these fields, {quantity: texts}, are right, and what
    explains a wrong one: {"found": {quantity: {"verdict", "text"}}, "kept": the reader's progress}.
    """
    p, found = _problem(problem), {}
    given: dict[bool, dict[str, Any]] = {False: {}, True: {}}
    for key, texts in fields.items():
        q = _quantity(p, key)
        try:
            value = _value(p, q, texts)
        except ValueError as error:
            found[key] = {"verdict": "unreadable", "text": str(error)}
            continue
        if value is not None:
            given[q.step][key] = value
    with p.spoken_of(ON_A_PAGE):
        for ask, values in ((p.check, given[False]), (p.check_step, given[True])):
            if values:
                checked = ask(**values)
                for key, verdict in checked.verdicts.items():
                    found[key] = {"verdict": verdict, "text": checked.sentences[key]}
    return {"found": found, "kept": str(_progress)}


def hint(problem: str) -> dict[str, str]:
    """Where to go on, in Markdown; asked again, more."""
    return _help(_problem(problem), PracticeProblem.next_step)


def solution(problem: str) -> dict[str, str]:
    """The worked solution with the present numbers, in Markdown."""
    return _help(_problem(problem), PracticeProblem.solution)


def _help(p, help):
    with p.spoken_of(ON_A_PAGE):
        message: Message = help(p)
    return {"text": message.markdown, "kept": str(_progress)}


def advice(titles: Mapping[str, Sequence[str]], now: str = "") -> dict[str, str]:
    """What to do next, of the problems {number: (title, section)} of all chapters; ``now``: the one
    that has just been worked.
    """
    sections = {problem: section for problem, (*other, section) in titles.items()}
    found = advise(sections, _progress, now, _may_err)
    return {"problem": found.problem, "sentence": found.sentence}


def _may_err(problem):
    pages = (book.page(problem) for book in _books.values() if problem in book)
    return next(map(causes_of, pages), set())


def take_in(progress: str) -> dict[str, str]:
    """Add a file of progress, from a notebook or from another browser, to the reader's; what is
    kept then. Raises :class:`NewtonEulerError` for another text.
    """
    try:
        _progress.take_in(progress)
    except ValueError as error:
        raise NewtonEulerError(
            _("this file of progress cannot be read: {error}", error=error)
        ) from None
    return {"kept": str(_progress)}
