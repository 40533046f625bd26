"""A chapter's files, ``pNN.yaml`` and ``pNN.py`` to be filled in, from a YAML list of problems."""

import re
import textwrap
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import yaml

from .format import OPTIONAL, read_problem
from .loading import load, not_yaml
from .model import CatalogueError, folder_and_file
from .places import EXERCISES

WIDTH = 160  # letters in a line of text
TEXTS = ("text", "figure", "frame")
# the name of a mistake: its first words except these
WORDS_OF_A_NAME = 4
EMPTY_WORDS = {
    "a", "an", "and", "as", "by", "for", "in", "is", "it", "its", "of", "on", "so", "that", "the",
    "to", "with",
}  # fmt: skip


def write_chapter(
    name: str, spec: str | Path, only: Sequence[str] = (), folder: Path | None = None
) -> list[Path]:
    """Write the files of chapter ``name`` from the file ``spec``; return their paths.

    only : numbers of the problems to write; default: all. folder : of the chapters. Existing files
    are kept. Raises :class:`CatalogueError`, before anything is written, if a problem does not fit
    the format or if all files exist.
    """
    entries = _entries(name, Path(spec), only)
    if not (folder or (EXERCISES / name).exists() or re.fullmatch(r"ch\d+|app[A-Z]", name)):
        raise CatalogueError(f"{name} is a chapter of your own: name the folder for it with --to")
    target = (folder or EXERCISES) / name
    files = {}
    for entry in entries:
        stem = folder_and_file(entry["id"])[1]
        text = problem_yaml(entry)
        try:
            read_problem(load(text), target / f"{stem}.yaml")
        except ValueError as error:
            raise CatalogueError(f"{spec}, problem {entry['id']}: {error}") from error
        files[target / f"{stem}.yaml"] = text
        files[target / f"{stem}.py"] = problem_code(entry)
    files = {path: text for path, text in files.items() if not path.exists()}
    if not files:
        raise CatalogueError(
            f"{target} has the files of all these problems, and none is overwritten: delete those "
            "to be written again"
        )
    for path, text in {**_of_the_chapter(name, Path(spec), target), **files}.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return list(files)


def _entries(name, spec, only):
    try:
        found = load(spec.read_text(encoding="utf-8"))
    except yaml.YAMLError as error:
        raise CatalogueError(f"{spec} {not_yaml(error)}") from error
    except UnicodeDecodeError as error:
        raise CatalogueError(f"{spec} is not in UTF-8; save the file as UTF-8") from error
    if not (isinstance(found, list) and all(isinstance(e, dict) for e in found)):
        raise CatalogueError(f"{spec} must be a YAML list of problems, each beginning with - id:")
    found = [e for e in found if folder_and_file(e.get("id"))[0] == name]
    unknown = set(only) - {e["id"] for e in found}
    if unknown or not found:
        ids = ", ".join(e["id"] for e in found) or "none"
        raise CatalogueError(
            f"{spec} has no problem {', '.join(sorted(unknown)) or f'of {name}'}; of {name} it has "
            f"{ids}"
        )
    return [_mended(e) for e in found if not only or e["id"] in only]


def _mended(entry):
    """The entry with texts restored that YAML cut at a comma, taking the rest for a key."""

    def whole(a):
        rest = [k for k, x in a.items() if x is None]
        kept = {k: x for k, x in a.items() if x is not None}
        return {**kept, "means": ", ".join([a["means"], *rest])}

    answers = entry.get("answers")
    if not isinstance(answers, list) or not all(
        isinstance(a, dict) and "means" in a for a in answers
    ):
        return entry  # refused by read_problem
    return {**entry, "answers": [whole(a) for a in answers]}


def _of_the_chapter(name, spec, target):
    """``chapter.yaml``, with the title from the first comment of the spec, and ``__init__.py``."""
    first = spec.read_text(encoding="utf-8").partition("\n")[0]
    title = re.match(r"#\s*([^.]+)", first)
    files = {
        target / "chapter.yaml": _as_yaml({"title": title[1] if title else name}),
        target / "__init__.py": "",
    }
    return {path: text for path, text in files.items() if not path.exists()}


def problem_yaml(entry: dict[str, Any]) -> str:
    """The text of ``pNN.yaml`` from one entry of a spec."""
    content = {field: x for field, x in entry.items() if x or field not in OPTIONAL}
    if str(content.get("figure", "")).lower().startswith("none"):
        del content["figure"]
    content |= {f: " ".join(content[f].split()) for f in TEXTS if isinstance(content.get(f), str)}
    if isinstance(mistakes := content.get("mistakes"), list):
        content["mistakes"] = mistake_names(mistakes)
    if "section" in content:
        content["section"] = str(content["section"])
    last = {f: content.pop(f) for f in ("steps", "mistakes", "struck", "checked") if f in content}
    return _as_yaml(content, None) + (_as_yaml(last) if last else "")


def _as_yaml(content, flow=False):
    return yaml.safe_dump(
        content, sort_keys=False, allow_unicode=True, width=WIDTH, default_flow_style=flow
    )


def mistake_names(texts: Iterable[str]) -> dict[str, str]:
    """{name: text}, with names made from the first words of the texts."""
    named = {}
    for text in texts:
        words = re.findall(r"[a-z]+|[A-Z]\w*", text.partition(",")[0])
        kept = [w for w in words if w not in EMPTY_WORDS][:WORDS_OF_A_NAME] or ["mistake"]
        name, n = "_".join(kept), 1
        while name in named:
            n += 1
            name = f"{'_'.join(kept)}_{n}"
        named[name] = text
    return named


# -- the code

CODE = Path(__file__).with_name("new_problem.txt")  # the author's template


def problem_code(entry: dict[str, Any]) -> str:
    """The text of ``pNN.py``: functions to be filled in, with docstrings of what they return."""
    keys = [a["key"] for a in entry["answers"]]
    figure = " ".join((entry.get("figure") or "none").split())
    mistakes = entry.get("mistakes") or ()
    names = mistakes if isinstance(mistakes, dict) else mistake_names(mistakes)
    text, drawing, last = CODE.read_text(encoding="utf-8").partition("\n\ndef draw")
    if not figure.lower().startswith("none"):
        text += drawing + last
    return text.format(
        id=entry["id"],
        what=_wrapped(f"{entry['title'][:1].lower()}{entry['title'][1:]}."),
        asked=_wrapped("; ".join(f"{a['key']}, {a['means']}" for a in entry["answers"])),
        keys=", ".join(f"'{k}': ..." for k in keys),
        mistakes=_wrapped(", ".join(names)),
        figure=_wrapped(figure),
    )


def _wrapped(text):
    """A text as a part of a docstring, without quotes or backslashes that would break it."""
    lines = textwrap.wrap(text.replace("\\", "/").replace('"', "'"), 70, break_on_hyphens=False)
    return "\n    ".join(lines)
