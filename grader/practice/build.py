"""Writing a practice file: a zip archive with a JSON text for each problem, and its figures."""

import hashlib
import io
import json
import math
import os
import zipfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import repeat
from pathlib import Path
from typing import Any

from exercises.catalogue import Problem, chapter, problem
from exercises.catalogue.translations import has_own_texts
from exercises.catalogue.wording import term_text
from newton_euler.algebra.language import ENGLISH, language, speaking, stored, with_values
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.kinds import KINDS
from newton_euler.classroom.practising.files import FORMAT, HELP

from ..assignment.cells import Values
from ..assignment.figures import figure_for_page, figure_png
from ..assignment.notebook import frame_heading, short_number, slug, statement, typeset
from ..assignment.options import HELP as LEVELS
from ..assignment.sheet import with_tolerance
from ..assignment.solution import worked_solution
from ..course import CourseError
from ..course.processes import process_pool
from ..scoring.computation import section
from .graded import same_for_all
from .plain import plain
from .quantities import KEPT, quantities, wrong_numbers
from .relations import relations
from .slips import slip_numbers, without_formulas
from .twins import sets_of_numbers, twin

COLOURS = 64  # colours of a figure: a quarter of the bytes without a visible difference


def png(p: Problem, values: Values) -> tuple[str, bytes] | None:
    """(".png", the figure of a problem, in few bytes), or None."""
    found = figure_png(p, values)
    return (".png", _smaller(found)) if found else None


def svg(p: Problem, values: Values) -> tuple[str, bytes] | None:
    """(".svg", the figure of a problem), or None."""
    found = figure_for_page(p, values)
    return (".svg", found) if found else None


class PracticeError(CourseError):
    """A practice file cannot be written as asked."""


@dataclass(frozen=True)
class LeftOut:
    """A problem left out of the file, and why."""

    problem: str
    why: str


def write_practice(
    path: str | Path,
    problems: Iterable[Problem],
    count: int = 10,
    help: str = "solution",
    graded: Mapping[str, Sequence[Values]] | None = None,
    workers: int | None = None,
    done: Callable[[], object] = lambda: None,
    rules: Mapping[str, Mapping[str, Any]] | None = None,
    draw: Callable[[Problem, Values], tuple[str, bytes] | None] = png,
) -> list[LeftOut]:
    """Write the practice file of ``problems``; returns the :class:`LeftOut` ones.

    count : sets of numbers for each, including the book's
    help : the most that a student is shown, one of ``HELP``
    graded : {problem id: [numbers of a student's sheet]} of a course: answers in practice stay away
    from those of these sheets, and problems are left out if their answers are formulas or the same
    for everybody; mistakes are explained without formulas
    done : called after each problem
    rules : {problem id: {"tolerance", "help"}} of the sheets that ask for it; the lesser help
    counts
    draw : the figure of a problem with these numbers, :func:`png` or :func:`svg`
    """
    if help not in HELP:
        raise PracticeError(f"the help is one of {', '.join(HELP)}, not {help!r}")
    graded, left, pages = graded or {}, [], []
    names = [p.id for p in problems]
    own = [(rules or {}).get(name, {}) for name in names]
    given = repeat(count), repeat(help), [graded.get(name) for name in names], own, repeat(draw)
    texts = [language() if has_own_texts(name, language()) else ENGLISH for name in names]
    with process_pool(workers) as pool:
        for found in pool.map(_page_in, texts, names, *given):
            if isinstance(found, LeftOut):
                left.append(found)
            else:
                pages.append(found)
            done()
    if not pages:
        raise PracticeError("no problem is left to practise: " + "; ".join(
            f"{x.problem} {x.why}" for x in left) if left else "no problem was chosen")  # fmt: skip
    _write(Path(path), pages, help)
    return left


def _write(path, pages, help):
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(path.name + ".part")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as archive:
        titles = {page["id"]: [page["title"], page["section"]] for page, _ in pages}
        head = {"format": FORMAT, "help": help, "problems": list(titles), "titles": titles}
        archive.writestr("practice.json", json.dumps(head))
        for page, figures in pages:
            archive.writestr(f"{slug(page['id'])}.json", json.dumps(page, separators=(",", ":")))
            for name, figure in figures.items():
                # a PNG is compressed already
                packed = zipfile.ZIP_STORED if name.endswith(".png") else zipfile.ZIP_DEFLATED
                archive.writestr(zipfile.ZipInfo(name), figure, packed)
    os.replace(partial, path)


def _page_in(language, *given):
    with speaking(language):
        return page_of(*given)


def page_of(
    name: str,
    count: int,
    help: str,
    graded: Sequence[Values] | None = None,
    rules: Mapping[str, Any] | None = None,
    draw: Callable[[Problem, Values], tuple[str, bytes] | None] = png,
) -> Any:
    """(page, figures) of a problem, or :class:`LeftOut`.

    graded : students' numbers for it, None if no course has it
    rules : the "tolerance" and the "help" of the sheets that ask for it
    """
    rules = rules or {}
    help = min(help, rules.get("help", help), key=LEVELS.index)
    if help not in HELP:
        return LeftOut(name, "its sheet gives no help")
    if graded is not None and problem(name).symbols:
        return LeftOut(name, "it is graded as a formula, which its steps and numbers would tell")
    p = twin(with_tolerance(problem(name), rules.get("tolerance")))
    sets = sets_of_numbers(p, count, graded or ())
    computed = [quantities(p, values) for values in sets]
    if not sets:
        return LeftOut(name, "all its answers are near graded ones")
    if graded is not None and (same := same_for_all(p, sets)):
        return LeftOut(name, f"its {' and '.join(same)} would give away a graded answer")
    figures, variants = {}, []
    for values, (described, right) in zip(sets, computed, strict=True):
        variants.append(_variant(p, values, described, right, help))
        if drawn := draw(p, values):
            suffix, figure = drawn
            file = f"{slug(name)}-{hashlib.sha256(figure).hexdigest()[:12]}{suffix}"
            figures[file] = figure  # a figure without numbers is stored once
            variants[-1]["figure"] = file
    labels, slips = _numbered(variants, "wrong"), _numbered(variants, "slips")
    formulas = p.units if problem(name).symbols or graded is not None else ()

    def kept(text):
        return stored(without_formulas(text, formulas))

    page = {
        "id": name, "language": language(), "title": p.title, "section": p.section,
        "where": stored(section(p.section)),
        "chapter": chapter(p.chapter).title,
        "preamble": plain(chapter(p.chapter).preamble, ()), "figure": plain(p.figure, p.units),
        "quantities": _described(p, computed, help), "variants": variants,
        "labels": [(key, *map(kept, _texts(c))) for key, c in labels],
        "slips": [(key, rank, *map(kept, _texts(c)[1:])) for key, rank, c in slips],
        "book": sets[0] == problem(name).book_values, "help": help,
        "symbols": {n: p.notation[n] for n in p.givens},
    }  # fmt: skip
    return page, figures


def _texts(cause):
    """A cause as a file keeps it: its texts, and the answers that it concerns."""
    of = " ".join(cause.answers) or cause.of
    return cause.group, cause.name, cause.text, cause.where, cause.subject, cause.does, of


def _numbered(variants, name):
    """The labels of all variants' entries under this name, which become [n, numbers]."""
    labels = list(dict.fromkeys(tuple(label) for v in variants for *label, _ in v[name]))
    place = {label: n for n, label in enumerate(labels)}
    for v in variants:
        v[name] = [[place[tuple(label)], x] for *label, x in v[name]]
    return labels


def _described(p, computed, help):
    """The quantities of all sets of numbers: the same in each, except that a zero term is not a
    step.
    """
    found = {}
    for described, _ in computed:
        for q in described:
            if q["step"] and help == "check":
                continue
            found.setdefault(q["key"], q)
    for key, q in found.items():
        if q["step"]:
            q["atol"] = _zero(key, q["kind"], computed)
    steps = [q for q in found.values() if q["step"]]
    return steps + [q for q in found.values() if not q["step"]]


def _zero(key, kind, computed):
    """The size below which a step is zero: a millionth of its largest, or 1e-6 if all are zero."""
    if KINDS[kind].is_word:
        return 0.0
    sizes = [math.hypot(*right[key]) for _, right in computed if key in right]
    return 1e-6 * (max(sizes) or 1.0)


def _variant(p, values, described, right, help):
    shown = {q["key"] for q in described if not q["step"] or help != "check"}
    wrong = wrong_numbers(p, values, described, right)
    slips = slip_numbers(p, values, described, right)
    # formulas would also solve an assignment with other numbers
    solution = worked_solution(p, values, False, formulas=False) if help == "solution" else ""
    return {
        "givens": {n: [values[n], g.unit, plain(g.means, p.units)] for n, g in p.givens.items()},
        "statement": statement(p, values, figure=False),
        "text": plain_text(p, values),
        "right": {k: x for k, x in right.items() if k in shown},
        "wrong": [w for w in wrong if w[0] in shown],
        "slips": [
            (key, *label, [float(f"{part:.{KEPT}g}") for part in x])
            for key, *label, x in slips
            if key in shown
        ],
        "program": relations(p, values) if help != "check" else None,
        "terms": _terms(p, values) if help != "check" else {},
        "solution": solution,
    }


def _terms(p, values):
    """{answer: [terms of its sum, in words]}."""
    return {
        key: [stored(_typeset_term(name, x.equation, p)) for name in x.terms]
        for key, x in p.solve(values).items()
        if isinstance(x, Vector) and len(x.terms) > 1
    }


def _typeset_term(name, equation, p):
    return with_values(term_text(name, equation, p, latex=True), lambda x: typeset(x, p))


def plain_text(p: Problem, values: Values) -> str:
    """The text of a problem for a terminal, with names as typed."""

    def quantity(n):
        unit = "" if p.units[n] == "1" else f" {p.units[n]}"
        return f"{n} = {short_number(values[n])}{unit}" if n in values else n

    lines = [plain(p.text, p.units, quantity)]
    if p.frame:
        lines.append(f"{frame_heading(p)}: {plain(p.frame, p.units)}")
    return "\n\n".join(lines)


def _smaller(png):
    from PIL import Image

    out = io.BytesIO()
    with Image.open(io.BytesIO(png)) as image:
        small = image.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
        small.save(out, "PNG", optimize=True)
    return out.getvalue()
