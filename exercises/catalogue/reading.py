"""Reads the problems of a chapter from its YAML; what does not fit is told in words."""

from functools import cache
from pathlib import Path

import yaml

from newton_euler.units import unit

from .model import KINDS, Answer, CatalogueError, Given, Problem, Symbol, folder

HERE = Path(__file__).parents[1]


@cache
def chapters():
    """The names of the chapters that have problems here."""
    return tuple(sorted(p.parent.name for p in HERE.glob("*/problems.yaml")))


@cache
def problems(chapter):
    """All problems of a chapter, in the order of the book: ``problems("ch04")``."""
    path = HERE / chapter / "problems.yaml"
    if not path.exists():
        raise CatalogueError(f"there is no chapter {chapter!r}; there are {', '.join(chapters())}")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # the C parser reads a chapter 10 times faster
    try:
        entries = yaml.load(path.read_text(encoding="utf-8"), loader)
    except yaml.YAMLError as error:
        raise CatalogueError(f"{chapter}/problems.yaml is not YAML: {error}") from error
    found = [_read(entry, path) for entry in entries]
    numbers = [p.id for p in found]
    if len(set(numbers)) != len(numbers):
        raise CatalogueError(f"{path.parent.name}/problems.yaml has the same problem twice: {sorted(n for n in numbers if numbers.count(n) > 1)[0]}")
    return tuple(found)


def problem(problem_id):
    """The problem with this number: ``problem("4/16")``."""
    chapter = folder(problem_id)
    if chapter in chapters():
        for p in problems(chapter):
            if p.id == problem_id:
                return p
        last = problems(chapter)[-1].id
        raise CatalogueError(f"there is no problem {problem_id}; {chapter} has {problems(chapter)[0].id} to {last}")
    raise CatalogueError(f"there is no problem {problem_id}: the chapters with problems are {', '.join(chapters())}")


def select(names):
    """The problems that ``names`` stand for: problem numbers, chapter names, or "all"."""
    chosen = []
    for name in names:
        if name == "all":
            chosen += [p for c in chapters() for p in problems(c)]
        elif "/" in name:
            chosen.append(problem(name))
        else:
            chosen += problems(name)
    return list(dict.fromkeys(chosen))


_ANGLES = {"rad": (0.25, 1.1), "deg": (15, 65)}


def _read(entry, path):
    where = f"{path.parent.name}/problems.yaml, problem {entry.get('id', '?')}"
    try:
        return Problem(
            id=entry["id"],
            title=entry["title"],
            section=str(entry["section"]),
            text=" ".join(entry["text"].split()),
            figure=" ".join(entry["figure"].split()),
            givens={n: _read_given(n, g) for n, g in (entry.get("givens") or {}).items()},
            symbols={n: _read_symbol(n, s) for n, s in (entry.get("symbols") or {}).items()},
            frame=" ".join(entry.get("frame", "").split()),
            answers=tuple(_read_answer(a) for a in entry["answers"]),
            mistakes=entry.get("mistakes") or {},
            struck=entry.get("struck") or {},
        )
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise CatalogueError(f"{where}: {error!r}") from error


def _read_given(name, g):
    vary = tuple(g["vary"]) if "vary" in g else None
    unit(g["unit"])
    if vary and not vary[0] < vary[1]:
        raise ValueError(f"{name}: vary must be [low, high], got {vary}")
    return Given(name, g["value"], g["unit"], g["means"], vary, g.get("figure", False))


def _read_symbol(name, s):
    s = s if isinstance(s, dict) else {"unit": s}
    unit(s["unit"])
    return Symbol(name, s["unit"], tuple(s.get("vary", _ANGLES.get(s["unit"], (0.6, 1.9)))))


def _read_answer(a):
    if a["kind"] not in KINDS:
        raise ValueError(f"kind {a['kind']!r} is none of {', '.join(sorted(KINDS))}")
    unit(a.get("unit", "1"))
    return Answer(a["key"], a["kind"], a.get("unit", "1"), a["means"], tuple(a.get("of", ())), float(a.get("atol", 1e-6)))
