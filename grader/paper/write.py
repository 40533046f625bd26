"""Writing the PDFs of a class: a sheet for each student, keys, a table of all answers."""

import importlib.util
import multiprocessing
import os
import secrets
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from exercises.catalogue.variants import draw, seed

from ..assignment.numbers import kept_numbers
from ..assignment.spec import Spec
from ..course import Course, check_id
from ..course.files import write_bytes, write_text
from ..course.processes import process_pool
from .markup import PaperError
from .sheet import Files, PaperItem, Student, key, overview, sheet, variant_code

ALL = "all"
NEEDED = "typst", "tex2typst"


@dataclass(frozen=True)
class WrittenPapers:
    """The written files."""

    sheets: tuple[Path, ...]
    keys: tuple[Path, ...]


def write_papers(
    folder: Path,
    spec: Spec,
    students: Iterable[Mapping[str, str]],
    course: Course | None = None,
    key_for: Iterable[str] = (),
    workers: int | None = None,
    done: Callable[[], object] = lambda: None,
) -> WrittenPapers:
    """Write ``folder``/sheets/LOGIN.pdf and ``folder``/keys/LOGIN.pdf for each of the students, and
    keys/overview.pdf; with ``key_for`` the keys of these logins only. All are private to the
    instructor.

    The numbers are those of the course, or drawn from a secret kept in ``folder``.
    done : called after each student
    """
    require_typst()
    chosen, wanted = list(students), tuple(key_for)
    if missing := set(wanted) - {s["id"] for s in chosen} - {ALL}:
        raise PaperError(f"--key-for {min(missing)}: no such student in the roster")
    if wanted and ALL not in wanted:
        chosen = [s for s in chosen if s["id"] in wanted]
    secret = course.secret if course else _own_secret(folder)
    class_ = [_student(spec, s, course, secret) for s in chosen]
    entries = tuple(_entry(i) for i in spec.items)
    for part in ("sheets", "keys"):
        (folder / part).mkdir(parents=True, exist_ok=True)
        (folder / part).chmod(0o700)
    jobs = [(folder, spec.title, entries, s, not wanted) for s in class_]
    for _ in _all(_write, jobs, workers or os.cpu_count() or 1):
        done()
    if not wanted:
        write_bytes(folder / "keys" / "overview.pdf", pdf(overview(spec.title, entries, class_)))
    logins = sorted(s.login for s in class_)
    return WrittenPapers(
        tuple(folder / "sheets" / f"{x}.pdf" for x in logins if not wanted),
        tuple(folder / "keys" / f"{x}.pdf" for x in logins),
    )


def require_typst() -> None:
    """Raise :class:`PaperError` unless the packages that write PDFs are installed."""
    if missing := [name for name in NEEDED if importlib.util.find_spec(name) is None]:
        raise PaperError(
            f"PDFs are written by {' and '.join(missing)}, not installed here: pip install -e "
            "'.[paper]' in the checkout"
        )


def pdf(files: Files) -> bytes:
    """The PDF of these files, by Typst."""
    import typst

    inputs: Any = files  # files by name are missing in its annotations
    try:
        return typst.compile(inputs, format="pdf", timestamp=0)
    except typst.TypstError as error:
        reason = str(error).replace("unknown variable: ", "it has no command \\")
        raise PaperError(f"a formula in a text of yours cannot be set: {reason}") from error


def _all(function, jobs, workers):
    """``function`` of each job, in processes that are spawned, since Typst has threads."""
    if workers == 1:
        yield from map(function, jobs)
        return
    fresh = multiprocessing.get_context("spawn")
    with process_pool(workers, fresh) as pool:
        yield from pool.map(function, jobs)


def _write(job):
    folder, title, entries, student, with_sheet = job
    if with_sheet:
        made = pdf(sheet(title, entries, student))
        write_bytes(folder / "sheets" / f"{student.login}.pdf", made)
    write_bytes(folder / "keys" / f"{student.login}.pdf", pdf(key(title, entries, student)))


def _entry(item):
    p = item.problem
    points = item.options.get("points", len(p.answers) if p else 0)
    options = dict(item.options)
    return PaperItem(p.id if p else "", item.text, points, options, item.question, item.key)


def _student(spec, known, course, secret):
    login, problems = check_id(known["id"]), spec.problems
    if course:
        values = kept_numbers(course, spec.name, login, problems)
    else:
        values = {p.id: draw(p, seed(secret, spec.name, login, p.id)) for p in problems}
    name = " ".join(known.get(k) or "" for k in ("first_name", "last_name")).strip() or login
    code = variant_code(seed(secret, spec.name, login, "paper"), values)
    return Student(login, name, code, values)


def _own_secret(folder):
    """The secret of sheets without a course."""
    path = folder / ".paper_secret"
    if not path.exists():
        folder.mkdir(parents=True, exist_ok=True)
        write_text(path, secrets.token_hex(32) + "\n")
    return bytes.fromhex(path.read_text(encoding="ascii"))
