"""Statistics of an assignment, part by part: difficulty, discrimination, mistakes."""

import csv
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.table import Table

from newton_euler.algebra.late import Figure

from ..course import Course
from ..submission.pipeline import MARK
from .export import cell
from .records import BY_HAND, PartScore, part_scores, questions
from .tables import in_cell, plain_table

FEWEST = 5  # students for a meaningful correlation


@dataclass(frozen=True)
class PartStatistics:
    """The statistics of one part of a problem.

    difficulty : mean share of its points (1 is easy), or of right answers in a part without points;
    None if all wait. discrimination : correlation of its points with those of all other parts; None
    for too few students or equal points. verdicts : {verdict: number}. mistakes : [(words,
    number)], the most frequent first. waiting : number to grade by hand, counted nowhere else.
    """

    problem: str
    key: str
    students: int
    out_of: float
    difficulty: float | None
    discrimination: float | None
    verdicts: Counter[str]
    mistakes: list[tuple[str, int]]
    waiting: int = 0


def part_statistics(course: Course, assignment: str) -> list[PartStatistics]:
    """The statistics of every part, then of the instructor's own questions, without verdicts."""
    by_part: defaultdict[tuple[str, str], list[PartScore]] = defaultdict(list)
    totals: defaultdict[str, float] = defaultdict(float)
    parts = part_scores(course, assignment)
    own = [e for e in questions(course, assignment, parts) if e.key != BY_HAND]
    for e in (*parts, *own):
        by_part[e.problem, e.key].append(e)
        totals[e.student] += e.points
    return [_of_part(*part, found, totals) for part, found in by_part.items()]


def _of_part(problem, key, found, totals):
    graded = [e for e in found if not e.waits]
    points = np.array([e.points for e in graded])
    rest = np.array([totals[e.student] for e in graded]) - points
    few = len(graded) < FEWEST or np.ptp(points) == 0 or np.ptp(rest) == 0
    discrimination = None if few else float(np.corrcoef(points, rest)[0, 1])
    verdicts = Counter(e.verdict for e in graded)
    return PartStatistics(
        problem, key, len(found), max(e.out_of for e in found), _difficulty(graded),
        discrimination, verdicts, mistake_counts(graded), len(found) - len(graded),
    )  # fmt: skip


def _difficulty(graded):
    if most := max((e.out_of for e in graded), default=0.0):
        return sum(e.points for e in graded) / (most * len(graded))
    judged = [e.verdict == "right" for e in graded if e.verdict]
    return sum(judged) / len(judged) if judged else None


def mistake_counts(found: Iterable[PartScore]) -> list[tuple[str, int]]:
    """[(words, number)] of the mistakes, the most frequent first. Mistakes are identified by their
    causes, since words may have changed; the last words count.
    """
    counts: Counter[object] = Counter()
    words: dict[object, str] = {}
    for e in found:
        if e.diagnosis:
            mistake = frozenset(e.causes) or e.diagnosis  # older records have no causes
            counts[mistake] += 1
            words[mistake] = e.diagnosis
    return [(words[mistake], n) for mistake, n in counts.most_common()]


def statistics_table(parts: Iterable[PartStatistics]) -> Table:
    """The statistics as a table for the terminal, each part with its most frequent mistake."""
    columns = ("problem", "part", ">diff.", ">discr.", *(f">{m}" for m in MARK.values()))
    title = "Statistics  (diff.: mean share of the points; discr.: correlation with the rest)"
    table = plain_table(title, *columns, "most frequent mistake")
    for p in parts:
        mistake, count = p.mistakes[0] if p.mistakes else ("", 0)
        shares = ("–" if x is None else f"{x:.2f}" for x in (p.difficulty, p.discrimination))
        verdicts = (str(p.verdicts[v]) for v in MARK)
        frequent = in_cell(f"{count}× {mistake}") if count else ""
        frequent = f"{p.waiting} wait for a person" if p.waiting else frequent
        table.add_row(p.problem, p.key, *shares, *verdicts, frequent)
    return table


def statistics_csv(parts: Iterable[PartStatistics], path: str | Path) -> None:
    """Write a line for each part, and below it one for each of its mistakes."""
    with open(path, "w", newline="", encoding="utf-8-sig") as f:
        writer = csv.writer(f)
        writer.writerow(
            ("problem", "part", "students", "out_of", "difficulty", "discrimination", *MARK,
             "waiting", "mistake", "times")
        )  # fmt: skip
        for p in parts:
            shares = ("" if x is None else f"{x:.4f}" for x in (p.difficulty, p.discrimination))
            verdicts = (p.verdicts[v] for v in MARK)
            name = cell(p.problem)
            own = (name, p.key, p.students, f"{p.out_of:g}", *shares, *verdicts, p.waiting)
            writer.writerow((*own, "", ""))
            empty = [""] * (len(own) - 2)
            writer.writerows((name, p.key, *empty, cell(m), n) for m, n in p.mistakes)


def statistics_figure(parts: Sequence[PartStatistics], path: str | Path) -> None:
    """Draw the statistics: a bar of verdicts for each part, a dot for its discrimination."""
    # distinguishable in grey and by the colour-blind
    colours = {"right": "#1b7f5c", "wrong": "#d1622b", "unreadable": "#8a6fb0", "blank": "#c9c9c9"}
    figure = Figure(figsize=(8, 1.2 + 0.26 * len(parts)), dpi=120, layout="constrained")
    ax = figure.add_subplot()
    places, left = np.arange(len(parts)), np.zeros(len(parts))
    for verdict, colour in colours.items():
        shares = np.array([p.verdicts[verdict] / p.students for p in parts])
        ax.barh(places, shares, left=left, color=colour, label=verdict, height=0.8)
        left += shares
    known = [(max(0.0, d), n) for n, p in enumerate(parts) if (d := p.discrimination) is not None]
    if known:
        ax.plot(*zip(*known, strict=True), "ko", markersize=4, label="discrimination")
    ax.set_yticks(places, [f"{p.problem} {p.key}" for p in parts], fontsize=8)
    ax.invert_yaxis()
    ax.set_xlim(0, 1)
    ax.set_xlabel("share of the students; dots: discrimination")
    figure.legend(loc="outside upper center", ncols=5, fontsize=8, frameon=False)
    figure.savefig(path, format="png")
