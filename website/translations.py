"""What of the course is translated, missing or stale (translated from a source that has changed
since) in another language.

Sentences are in a gettext catalogue (``newton_euler/algebra/languages/de.po``), where a changed
sentence is a missing one; those of a chapter's predictions in ``chapters/de/ch09_rotors.po``, since
code cells are not translated. The texts of a problem are in ``exercises/ch09/de/p01.yaml``, a
chapter in ``chapters/de/ch09_rotors.ipynb``; both keep hashes of their sources.
"""

import ast
import contextlib
import json
import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import nbformat

from exercises.catalogue import chapters, problems
from exercises.catalogue.sources import is_current, mark_current
from newton_euler.algebra.language import FOLDER, messages

from .kept import ROOT
from .notebooks import Chapter, is_cell_current, mark_cells_current, translation
from .notebooks import chapters as notebooks

SOURCES = "newton_euler", "grader", "exercises/catalogue", "website"


@dataclass
class Part:
    """A part of the course: the number of its texts, the missing ones, the stale ones."""

    name: str
    all: int
    missing: list[str] = field(default_factory=list)
    stale: list[str] = field(default_factory=list)

    @property
    def percent(self) -> int:
        """The percentage that is translated and current, rounded down."""
        return 100 * (self.all - len(self.missing) - len(self.stale)) // max(self.all, 1)


def sentences(suffixes: Collection[str] = (".py", ".j2", ".js")) -> dict[str, tuple[str, ...]]:
    """{English sentence: (itself, perhaps its plural)} of all that readers see, in the order of the
    files.

    suffixes : of the files to read
    """
    files = [path for folder in SOURCES for path in sorted((ROOT / folder).rglob("*.*"))]
    found: dict[str, tuple[str, ...]] = {}
    for path in (path for path in files if path.suffix in suffixes):
        read = _of_python if path.suffix == ".py" else _of_other
        for forms in read(path.read_text("utf-8")):
            if any(map(str.isalpha, re.sub(r"\{[^}]*\}", "", forms[0]))):
                found.setdefault(forms[0], forms)
    return found


def _of_python(text):
    """The sentences in Python code (Babel does not look into f-strings)."""
    for node in (x for x in ast.walk(ast.parse(text)) if isinstance(x, ast.Call)):
        count = CALLS.get(ast.unparse(node.func).removeprefix("self."), 0)
        texts = [getattr(x, "value", None) for x in node.args[:count]]
        if texts and all(isinstance(x, str) for x in texts):
            yield tuple(texts)


def _of_other(text):
    """The sentences in a script or a template."""
    found = re.findall(r'\b(?:gettext|_)\(("(?:[^"\\]|\\.)*")', text)
    return [(json.loads(sentence),) for sentence in found]


SAID = "_", "Words", "AnswerError", "OpenAnswer", "TreeError", "form.error", "PracticeFileError"
OF_CAUSES = "slip", "remark"  # in newton_euler/answers/causes.py
CALLS = {"plural": 2} | dict.fromkeys((*SAID, *OF_CAUSES), 1)  # {function: number of its sentences}


def predictions(chapter: Chapter) -> dict[str, tuple[str, ...]]:
    """The sentences in the predictions of a chapter: questions, choices, comments on these."""
    found: list[ast.AST] = []
    for cell in (c for c in chapter.cells if c["cell_type"] == "code"):
        with contextlib.suppress(SyntaxError):  # a magic
            found += ast.walk(ast.parse("".join(cell["source"])))
    calls = [x for x in found if isinstance(x, ast.Call) and getattr(x.func, "id", "") == "predict"]
    return {text: (text,) for call in calls for text in _texts(call)}


def _texts(call):
    """The texts in a call of predict, except the unit."""
    unit = 3  # index of the unit among the arguments
    given = [*call.args[:unit], *(k.value for k in call.keywords if k.arg != "unit")]
    for part in given:
        parts = [*part.keys, *part.values] if isinstance(part, ast.Dict) else [part]
        yield from (x.value for x in parts if isinstance(getattr(x, "value", None), str))


def file_of(chapter: Chapter, language: str) -> Path:
    """The catalogue of the predictions of a chapter."""
    return chapter.path.parent / language / f"{chapter.stem}.po"


def catalogue(language: str, path: Path | None = None) -> dict[str, dict[str, str]]:
    """{English sentence: its entry in the catalogue}; {} without a catalogue."""
    path = path or FOLDER / f"{language}.po"
    text = path.read_text("utf-8") if path.exists() else ""
    return {m["msgid"]: m for m in messages(text) if m["msgid"]}


def write_catalogues(language: str) -> list[Path]:
    """Rewrite the catalogues of the sentences and of the translated chapters."""
    wanted = {FOLDER / f"{language}.po": sentences()}
    own = [c for c in notebooks() if translation(c, language)]
    wanted |= {file_of(c, language): found for c in own if (found := predictions(c))}
    return [_written(path, found, language) for path, found in wanted.items()]


def _written(path, wanted, language):
    """Write a catalogue of the ``wanted`` sentences in order, with their known translations."""
    known = catalogue(language, path)
    old = path.read_text("utf-8") if path.exists() else HEADER.format(language=language)
    blocks = [old.partition("\n\n")[0].strip()]
    for text, forms in wanted.items():
        m = known.get(text, {})
        lines = [f"msgid {_quoted(text)}"]
        if len(forms) > 1:
            lines += [f"msgid_plural {_quoted(forms[1])}"]
            lines += [f"msgstr[{n}] {_quoted(m.get(f'msgstr[{n}]', ''))}" for n in (0, 1)]
        else:
            lines += [f"msgstr {_quoted(m.get('msgstr', ''))}"]
        blocks.append("\n".join(lines))
    path.write_text("\n\n".join(blocks) + "\n", "utf-8")
    return path


HEADER = r"""msgid ""
msgstr ""
"Language: {language}\n"
"Content-Type: text/plain; charset=UTF-8\n"
"Plural-Forms: nplurals=2; plural=(n != 1);\n"
"""


def _quoted(text):
    return json.dumps(text, ensure_ascii=False)


def report(language: str) -> Iterator[Part]:
    """The parts of the course: its sentences, the problems of each chapter, each notebook."""
    yield _catalogued("sentences", sentences(), catalogue(language))
    for name in chapters():
        found = {p.id: is_current(p.id, language) for p in problems(name)}
        yield _part(f"problems of {name}", found)
    for c in notebooks():
        other, current = translation(c, language), {}
        for n, cell in enumerate(c.cells):
            if cell["cell_type"] == "markdown":
                there = other and n < len(other.cells) and other.cells[n]
                current[f"cell {n}"] = is_cell_current(cell, there) if there else None
        yield _part(c.stem, current)
        if other and (asked := predictions(c)):
            known = catalogue(language, file_of(c, language))
            yield _catalogued(f"predictions of {c.stem}", asked, known)


def _catalogued(name: str, found: Iterable[str], known: Mapping[str, Mapping[str, str]]) -> Part:
    """The part of a catalogue, in which a changed sentence is a missing one."""
    forms = {m: [x for key, x in known[m].items() if "msgstr" in key] for m in found if m in known}
    return _part(name, {m: all(forms.get(m, [""])) or None for m in found})


def _part(name: str, current: Mapping[str, bool | None]) -> Part:
    """A part: of each text whether its translation is current; None without one."""
    missing = [text for text, is_it in current.items() if is_it is None]
    stale = [text for text, is_it in current.items() if is_it is False]
    return Part(name, len(current), missing, stale)


def mark(paths: Iterable[Path]) -> None:
    """Mark these translations, files of problems or notebooks, as current."""
    for path in map(Path.resolve, paths):
        if path.suffix == ".ipynb":
            source = nbformat.read(path.parents[1] / path.name, as_version=4)
            notebook = nbformat.read(path, as_version=4)
            mark_cells_current(notebook, source)
            nbformat.write(notebook, path)
        else:
            mark_current(path)
