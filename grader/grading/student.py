"""Grading one submission, of one or several notebooks."""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field

from ..assignment.cells import Sources
from ..course import Course, CourseError
from ..sandbox import CAGED, Harvester, HarvestError
from ..scoring import Score
from ..submission import UnreadableError, read_timestamp
from .gradebook import Entry, Total
from .one import grade_one


@dataclass
class Result(Total):
    """The result of one submission with its points in the gradebook, or in ``problem`` the reason
    why it was not graded; ``sandbox`` is "namespaces", or "unsandboxed: …".
    """

    student: str
    scores: dict[str, Score] = field(default_factory=dict)
    sandbox: str = CAGED
    note: str = ""
    problem: str = ""
    unchanged: bool = False

    def diagnoses(self) -> list[tuple[str, str, str]]:
        """The explained wrong answers: [(problem id, key, sentence)]."""
        return [
            (i, p.key, p.diagnosis) for i, s in self.scores.items() for p in s.parts if p.diagnosis
        ]


@dataclass(frozen=True)
class GradingRun:
    """The data common to all submissions of one run; ``roster`` is None if already checked,
    ``remarks`` {student: remark on the time of submission}.
    """

    course: Course
    assignment: str
    force: bool
    names: list[str]
    sources: dict[str, Sources]
    roster: set[str] | None
    remarks: Mapping[str, str] = field(default_factory=dict)

    def grade(self, student: str, harvester: Harvester) -> tuple[Result, Entry | None]:
        """(result of one submission, entry for the gradebook); never raises."""
        if self.roster is not None and student not in self.roster:
            return self.not_on_roster(student)
        try:
            return self._grade(student, harvester)
        except UnreadableError as error:
            why = f"{error}; ask for it again. An earlier grade stays as it is"
        except (CourseError, HarvestError) as error:
            why = f"could not be graded: {error}"
        except Exception as error:  # one submission must not stop the others
            why = (
                "could not be graded, which is a bug of the grader: "
                f"{type(error).__name__}: {error}. An earlier grade stays as it is"
            )
        return Result(student, problem=why), None

    @staticmethod
    def not_on_roster(student: str) -> tuple[Result, None]:
        """The return value of :meth:`grade` for an unknown student."""
        why = (
            "is not on the roster; check the folder's name, or add the student with: nbgrader "
            f"db student add {student}"
        )
        return Result(student, problem=why), None

    def _grade(self, student: str, harvester: Harvester) -> tuple[Result, Entry]:
        folder = self.course.path / "submitted" / student / self.assignment
        there = [n for n in self.names if os.path.lexists(folder / f"{n}.ipynb")]
        if not there:
            raise UnreadableError(_missing(folder, self.names))
        about, remark = (self.course, self.assignment, student), self.remarks.get(student, "")
        outcomes = {
            n: grade_one(*about, n, self.sources[n], harvester, self.force, remark) for n in there
        }
        graded = {n: o.graded for n, o in outcomes.items()}
        timestamp, notes = read_timestamp(folder), [g.note for g in graded.values()]
        if timestamp is None and os.path.lexists(folder / "timestamp.txt"):
            notes.append("timestamp.txt holds no time: it is not known when this was handed in")
        notes += [f"{n}.ipynb was not handed in" for n in self.names if n not in there]
        result = Result(
            student,
            {i: s for g in graded.values() for i, s in g.scores.items()},
            sandbox=min((g.sandbox for g in graded.values()), key=lambda s: s == CAGED),
            note="; ".join(n for n in notes if n),
            unchanged=all(o.reused for o in outcomes.values()),
        )
        changed = any(o.changed for o in outcomes.values())
        again = any(o.again for o in outcomes.values())
        return result, Entry(student, graded, timestamp, changed, again)


def _missing(folder, names):
    others = sorted(f.name for f in folder.glob("*.ipynb")) if folder.is_dir() else []
    found = f"it holds {', '.join(others)}; if that is the work, rename it"
    found = found if others else "it holds no notebook"
    asked = " and ".join(f"{n}.ipynb" for n in names)
    return f"expected the notebook {asked} in {folder}, and {found}"
