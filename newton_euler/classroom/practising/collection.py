"""The problems of a practice file, and the table of what was tried."""

from collections.abc import Iterable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ...algebra.errors import checked
from ...algebra.language import Words, _, spoken
from ...answers.givens import in_notebook
from .advice import advise, causes_of
from .files import PracticeFile, PracticeFileError
from .problems import Message, PracticeProblem
from .progress import Progress, mastery

COUNTS = Words("tried"), Words("right"), Words("at first go"), Words("with help")


SETS = Path(__file__).with_name("sets")  # made with the wheel, of all chapters
KEPT = "practice.progress.json"  # progress in the engine's problems, in the current folder


@checked
def practice(path: str | Path = "", progress: str | Path | None = "") -> "Practice":
    """The problems of a practice file: ``practice("ch04.practice")["4/16"]`` is one. Without a file
    those that come with the engine: ``practice()``, of all chapters, or ``practice("ch04")``.
    Raises :class:`PracticeFileError` for another file.

    progress : the file in which what you tried is kept, yours alone; default: beside the practice
        file, with ``.progress.json`` behind its name; of those of the engine practice.progress.json
        in the current folder. None keeps it only while Python runs.
    """
    own = SETS / f"{path}.practice"
    comes_along = not path or (own.exists() and not Path(path).exists())
    kept = (KEPT if comes_along else f"{path}.progress.json") if progress == "" else progress
    paths = [own] if path and comes_along else public() if comes_along else [Path(path)]
    if not paths:
        raise PracticeFileError("no practice comes with this engine: {how}", how=WRITTEN)
    return Practice([PracticeFile(p) for p in paths], Progress(kept))


def public() -> list[Path]:
    """The practice files that come with the engine, in the order of the book."""
    return sorted(SETS.glob("*.practice"), key=lambda p: (p.stem.startswith("app"), p.stem))


WRITTEN = Words("in a checkout, `python -m grader sets` writes it; a wheel has it")


@checked
def try_problem(problem: str, folder: str | Path = ".") -> Any:
    """The problem from the first practice file in ``folder`` that has it, or else from those that
    come with the engine: in a notebook with ipywidgets as a form, otherwise as itself, which shows
    its text. If no file has it, a message says how to get one. Raises :class:`PracticeFileError`
    for a practice file that cannot be read.
    """
    same_chapter: list[str] = []
    for path in (*sorted(Path(folder).glob("*.practice")), *public()):
        file = PracticeFile(path)
        same_chapter += [n for n in file.problems if n.split("/")[0] == problem.split("/")[0]]
        if problem in file.problems:
            beside = path.parent != SETS
            kept = f"{path}.progress.json" if beside else Path(folder) / KEPT
            p = Practice([file], Progress(kept))[problem]
            return p.form() if in_notebook() and find_spec("ipywidgets") else p
    there = Words("of its chapter there are {all}", all=", ".join(dict.fromkeys(same_chapter)))
    none = Words("No practice file has problem {problem}, so nothing checks your answer: {how}.")
    text = _(none, problem=problem, how=there if same_chapter else WRITTEN)
    return Message(text.replace("`", ""), text)


class Practice:
    """The problems of practice files by number: ``practice("ch04.practice")["4/16"]``."""

    def __init__(self, files: Iterable[PracticeFile], progress: Progress):
        self._progress = progress
        self._files: dict[str, PracticeFile] = {}
        self._open: dict[str, PracticeProblem] = {}
        for file in files:
            self._files.update(dict.fromkeys(file.problems, file))

    def __getitem__(self, problem: str) -> PracticeProblem:
        if problem not in self._open:
            file = self._files.get(problem) or next(iter(self._files.values()))
            self._open[problem] = PracticeProblem(file, problem, self._progress)
        return self._open[problem]

    def __iter__(self) -> Iterator[str]:
        return iter(self._files)

    def __len__(self) -> int:
        return len(self._files)

    def _title(self, problem):
        return self._files[problem].titles[problem]

    @property
    def next(self) -> Message:
        """What to do next, chosen from what went wrong and when, with the reason in a sentence."""
        sections = {p: self._title(p)[1] for p in self}
        found = advise(sections, self._progress, may_err=lambda p: causes_of(self.page(p)))
        return Message(found.sentence, found.sentence)

    def page(self, problem: str) -> dict[str, Any]:
        """What the file has of a problem."""
        return self._files[problem].page(problem)

    @property
    def table(self) -> Message:
        """What was tried of each problem and how well each section is known."""
        wide = max(len(self._title(p)[0]) for p in self)
        named = [_("problem"), _("title"), _("section"), *map(spoken, COUNTS)]
        heads = "{:8} {:{wide}}  {:8}".format(*named[:3], wide=wide)
        text = [heads + "".join(f"  {c:>11}" for c in named[3:])]
        rows = [f"| {' | '.join(named)} |", f"|{' --- |' * 7}"]
        for p in self:
            title, section = self._title(p)
            counts = self._progress.counts(p)
            cells = [str(counts[c] or "") for c in COUNTS]
            row = f"{p:8} {title:{wide}}  {section:8}"
            text.append(row + "".join(f"  {x:>11}" for x in cells))
            rows.append(f"| {p} | {title} | {section} | {' | '.join(cells)} |")
        notes = [
            _("section {number}: {known}", number=s or "-", known=known)
            for s, known in self.mastery.items()
        ]
        notes += [self._progress.note] if self._progress.note else []
        listed = [f"- {note}" for note in notes]
        return Message("\n".join([*text, "", *notes]), "\n".join([*rows, "", *listed]))

    @property
    def mastery(self) -> dict[str, str]:
        """How well each section is known: {section: words}."""
        found: dict[str, dict[str, int]] = {}
        for p in self:
            counts = found.setdefault(self._title(p)[1], dict.fromkeys(COUNTS, 0))
            for name, n in self._progress.counts(p).items():
                counts[name] += n
        return {section: mastery(counts) for section, counts in found.items()}

    def __repr__(self) -> str:
        return self.table.text

    def _repr_markdown_(self) -> str:
        return self.table._repr_markdown_()
