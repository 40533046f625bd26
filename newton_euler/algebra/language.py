"""The reader's language. English is in the code; other languages are gettext catalogues,
``languages/de.po`` beside this file, read when one is chosen, in an editable install, the wheel and
a browser alike.

Values are named in braces: ``_("leaves out {term}", term=name)``.
"""

import json
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache, reduce, wraps
from pathlib import Path
from typing import Any

from .scalars import NewtonEulerError

FOLDER = Path(__file__).with_name("languages")
CHAPTERS = FOLDER.parents[1] / "chapters"  # de/ch09_rotors.po: what its predictions say
VARIABLE = "NEWTON_EULER_LANGUAGE"  # environment variable, as "de"
ENGLISH = "en"
_FIELD = re.compile(r"\{(\w+)(?:\.(what|why))?\}")


class Words(str):
    """A sentence, or a part of one, to translate later: English as a text, and its template with
    its values, which :func:`spoken` says in the reader's language. A value may be such a sentence;
    ``{cause.what}`` is its text before the first colon, ``{cause.why}`` the text after it.

    >>> Words("leaves out {term}", term="m*g")
    'leaves out m*g'
    """

    template: str
    values: dict[str, str]

    def __new__(cls, template: str, /, **values: object) -> "Words":
        self = super().__new__(cls, _filled(template, values))
        self.template = template
        self.values = {n: x if isinstance(x, str) else str(x) for n, x in values.items()}
        return self

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, str]]:
        return (self.template,), self.values


def _filled(template, values):
    """Only names are replaced: a template from a file reaches nothing else."""

    def value(found):
        name, part = found.groups()
        if name not in values:
            return found[0]
        text = str(values[name])
        what, _, why = text.partition(": ")
        return {"what": what, "why": why}.get(part, text)

    return _FIELD.sub(value, template) if values else template


def cached_by_language(f: Callable[..., Any]) -> Callable[..., Any]:
    """A function that is computed once for the same arguments in each language."""
    kept = cache(lambda _language, *args: f(*args))
    found: Any = wraps(f)(lambda *args: kept(language(), *args))
    found.cache_clear = kept.cache_clear
    return found


def spoken(text: str) -> str:
    """A text in the reader's language; one that is not :class:`Words` as it is."""
    if _chosen == ENGLISH or not isinstance(text, Words):
        return text
    return _(text.template, **text.values)


def _all_spoken(values):
    return {name: spoken(x) if isinstance(x, str) else x for name, x in values.items()}


def _(text: str, /, **values: object) -> str:
    """A sentence in the reader's language, with these values.

    >>> _("{key} is right", key="a_D")
    'a_D is right'
    """
    translated = _catalogue(_chosen).texts.get(text, (text,))[0] if _chosen != ENGLISH else text
    return _filled(translated, _all_spoken(values))


def plural(one: str, several: str, n: int, /, **values: object) -> str:
    """The same for a number of things; ``{n}`` is the number.

    >>> plural("{n} problem", "{n} problems", 2)
    '2 problems'
    """
    sentence = (one, several)[n != 1]
    if _chosen != ENGLISH:
        found = _catalogue(_chosen)
        forms = found.texts.get(one, ())
        sentence = forms[found.form(n)] if len(forms) > 1 else sentence
    return _filled(sentence, {"n": str(n), **_all_spoken(values)})


def in_all(text: str) -> list[str]:
    """A sentence in every language."""
    others = [_catalogue(name).texts.get(text, (text,))[0] for name in languages()[1:]]
    return list(dict.fromkeys([text, *others]))


def relayed(text: str) -> str:
    """A sentence of another process, which speaks English, in the reader's language; its only
    number is ``{n}`` in the catalogue.

    >>> relayed("stopped after 60 s")
    'stopped after 60 s'
    """
    if number := re.search(r"\d+(\.\d+)?", text):
        return _(text.replace(number[0], "{n}", 1), n=number[0])
    return _(text)


def joined(names: Iterable[str]) -> str:
    """Names as in a sentence.

    >>> joined(["a", "b", "c"])
    'a, b and c'
    """
    *others, last = list(names) or [""]
    if not others:
        return last
    first = reduce(lambda a, b: Words("{first}, {second}", first=a, second=b), others)
    return Words("{first} and {second}", first=first, second=last)


def stored(text: str) -> Any:
    """A text as JSON: words as [template, {name: text}].

    >>> stored(Words("leaves out {term}", term="m*g"))
    ['leaves out {term}', {'term': 'm*g'}]
    """
    if not isinstance(text, Words):
        return text
    return [text.template, {name: stored(x) for name, x in text.values.items()}]


def with_values(text: str, change: Callable[[str], str]) -> str:
    """Words with their values changed; of a plain text, the whole."""
    if not isinstance(text, Words):
        return change(text)
    values = {name: with_values(x, change) for name, x in text.values.items()}
    return Words(text.template, **values)


def from_stored(data: Any) -> str:
    """The text that is stored so."""
    if isinstance(data, str):
        return data
    template, values = data
    return Words(template, **{name: from_stored(x) for name, x in values.items()})


def are_words(data: Any, deep: int = 6) -> bool:
    """True for what :func:`from_stored` can read."""
    if isinstance(data, str) or not deep:
        return isinstance(data, str)
    return (
        isinstance(data, list)
        and [type(x) for x in data] == [str, dict]
        and all(are_words(x, deep - 1) for x in data[1].values())
    )


def language() -> str:
    """The language that is spoken now, "en" unless another was chosen."""
    return _chosen


def languages() -> list[str]:
    """The languages that have a catalogue, English first."""
    return [ENGLISH, *sorted(path.stem for path in FOLDER.glob("*.po"))]


def choose_language(name: str) -> None:
    """Speak the language of this name, "de", from now on. Raises :class:`NewtonEulerError`."""
    global _chosen
    if name not in languages():
        raise NewtonEulerError(
            f"there is no language {name!r} here; there are {', '.join(languages())}"
        )
    _chosen = name


@contextmanager
def speaking(name: str) -> Iterator[None]:
    """A context in which the language of this name is spoken."""
    before = _chosen
    choose_language(name)
    try:
        yield
    finally:
        choose_language(before)


# -- catalogues


class Catalogue:
    """``texts`` is {English: its forms}, ``form`` which of them goes with a number."""

    def __init__(self, text: str):
        from gettext import c2py  # type: ignore[attr-defined]

        found = [m for m in messages(text) if all(_forms(m))]
        heads = [_forms(m)[0] for m in found if not m["msgid"]]
        self.texts = {m["msgid"]: _forms(m) for m in found if m["msgid"]}
        plural = re.search(r"plural=([^;]+);", heads[0] if heads else "")
        self.form: Callable[[int], int] = c2py(plural[1] if plural else "n != 1")


def messages(text: str) -> Iterator[dict[str, str]]:
    """The messages of a .po file: {"msgid": …, "msgstr": …}, of several forms "msgstr[0]" … ."""
    for block in re.split(r"\n\s*\n", text):
        found: dict[str, str] = {}
        name = ""
        for line in block.splitlines():
            key, quote, rest = line.partition('"')
            if quote and not line.startswith("#"):
                name = key.strip() or name
                found[name] = found.get(name, "") + json.loads(f'"{rest}')
        if found and not re.search(r"^#,.*\bfuzzy\b", block, re.M):
            yield found


def _forms(message: Mapping[str, str]) -> tuple[str, ...]:
    return tuple(text for key, text in message.items() if key.startswith("msgstr"))


@cache
def _catalogue(name: str) -> Catalogue:
    paths = FOLDER / f"{name}.po", *sorted((CHAPTERS / name).glob("*.po"))
    return Catalogue("\n\n".join(path.read_text("utf-8") for path in paths))


_chosen = os.environ.get(VARIABLE, "")[:2].lower()
if _chosen not in languages():
    _chosen = ENGLISH
