"""The problems of a practice file, and the table of what was tried."""

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ...algebra.errors import checked
from ...answers.givens import in_notebook
from .files import PracticeFile
from .problems import Message, PracticeProblem
from .progress import Progress, mastery

COUNTS = "tried", "right", "at first go", "with help"


@checked
def practice(path: str | Path, progress: str | Path | None = "") -> "Practice":
    """The problems of a practice file: ``practice("ch04.practice")["4/16"]`` is one. Raises
    :class:`PracticeFileError` for another file.

    progress : the file in which what you tried is kept, yours alone; default: beside the practice
        file, with ``.progress.json`` behind its name. None keeps it only while Python runs.
    """
    kept = f"{path}.progress.json" if progress == "" else progress
    return Practice(PracticeFile(path), Progress(kept))


@checked
def try_problem(problem: str, folder: str | Path = ".") -> Any:
    """The problem from the first practice file in ``folder`` that has it: in a notebook with
    ipywidgets as a form, otherwise as itself, which shows its text. Without such a file: where to
    get one. Raises :class:`PracticeFileError` for a practice file that cannot be read.
    """
    for path in sorted(Path(folder).glob("*.practice")):
        problems = practice(path)
        if problem in problems:
            p = problems[problem]
            return p.form() if in_notebook() and find_spec("ipywidgets") else p
    number = problem.partition("/")[0]
    chapter = f"ch{number:0>2}" if number.isdigit() else f"app{number}"
    chapter = number if number.islower() else chapter  # of a course's own problems
    command = f"python -m grader practice {chapter} -o {chapter}.practice"
    text = (
        f"No practice file here has problem {problem}, so nothing checks your answer. Your "
        f"instructor writes one by: {command}. Put it beside this notebook and run the cell again."
    )
    return Message(text, text.replace(command, f"`{command}`"))


class Practice:
    """The problems of a practice file by number: ``practice("ch04.practice")["4/16"]``."""

    def __init__(self, file: PracticeFile, progress: Progress):
        self._file, self._progress = file, progress
        self._open: dict[str, PracticeProblem] = {}

    def __getitem__(self, problem: str) -> PracticeProblem:
        if problem not in self._open:
            self._open[problem] = PracticeProblem(self._file, problem, self._progress)
        return self._open[problem]

    def __iter__(self) -> Iterator[str]:
        return iter(self._file.problems)

    def __len__(self) -> int:
        return len(self._file.problems)

    @property
    def table(self) -> Message:
        """What was tried of each problem and how well each section is known."""
        wide = max(len(title) for title, _ in self._file.titles.values())
        heads = f"{'problem':8} {'title':{wide}}  {'section':8}"
        text = [heads + "".join(f"  {c:>11}" for c in COUNTS)]
        rows = [f"| problem | title | section | {' | '.join(COUNTS)} |", f"|{' --- |' * 7}"]
        for p in self:
            title, section = self._file.titles[p]
            counts = self._progress.counts(p)
            cells = [str(counts[c] or "") for c in COUNTS]
            row = f"{p:8} {title:{wide}}  {section:8}"
            text.append(row + "".join(f"  {x:>11}" for x in cells))
            rows.append(f"| {p} | {title} | {section} | {' | '.join(cells)} |")
        notes = [f"section {s or '-'}: {words}" for s, words in self.mastery.items()]
        notes += [self._progress.note] if self._progress.note else []
        listed = [f"- {note}" for note in notes]
        return Message("\n".join([*text, "", *notes]), "\n".join([*rows, "", *listed]))

    @property
    def mastery(self) -> dict[str, str]:
        """How well each section is known: {section: words}."""
        found: dict[str, dict[str, int]] = {}
        for p in self:
            counts = found.setdefault(self._file.titles[p][1], dict.fromkeys(COUNTS, 0))
            for name, n in self._progress.counts(p).items():
                counts[name] += n
        return {section: mastery(counts) for section, counts in found.items()}

    def __repr__(self) -> str:
        return self.table.text

    def _repr_markdown_(self) -> str:
        return self.table.markdown
