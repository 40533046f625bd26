"""From runs to the table and to the chart.

Accuracy reached and estimated, by way and tolerance, and the worst answers.
"""

import csv
import json
import math
from collections import Counter, defaultdict
from dataclasses import asdict, dataclass
from statistics import median

from matplotlib.figure import Figure

from newton_euler.accuracy.charts.honesty import draw_honesty
from newton_euler.accuracy.measurements.honesty import FAILED, REFUSED, MethodResult

ABSENT = {"refused": REFUSED, "raw": FAILED, "timeout": FAILED}
GOALS = {"met": 0.995, "covers": 0.99, "ratio": 100.0, "silent": 0}  # of issue 9


@dataclass(frozen=True)
class Line:
    """One line of the table: a way to ask, at one tolerance or, if ``rtol`` is None, at all.

    runs, returned : how many were asked, and how many gave an answer
    met : the part of the answers that are as accurate as asked; ``covers`` : the part of the
        estimates that are not below the true error
    ratio : the median of the estimate over the true error; ``inside`` : the part of the answers
        whose samples are accurate within ten times what was asked
    silent, refused, needless, raw, timeout : how many; ``unitless`` : the part met if no floor in
        units were granted
    seconds : the median of the time of a call
    """

    row: str
    rtol: float | None
    runs: int
    returned: int
    met: float
    covers: float
    ratio: float
    inside: float
    unitless: float
    silent: int
    refused: int
    needless: int
    raw: int
    timeout: int
    seconds: float

    @property
    def reaches_goals(self):
        """True if the line reaches the goals of issue 9, or has no answers."""
        covers, ratio = (self.covers, self.ratio) if not math.isnan(self.covers) else (1.0, 1.0)
        kept = self.met >= GOALS["met"] and covers >= GOALS["covers"] and not self.silent
        return not self.returned or (kept and ratio <= GOALS["ratio"])


def line(row, rtol, runs):
    """The :class:`Line` of some runs."""
    answers = [r for r in runs if r.returned]
    covers = [r.covers for r in answers if r.covers is not None]
    inside = [r.inside <= 10 * r.rtol for r in answers if not math.isnan(r.inside)]
    count = Counter(r.outcome for r in runs)
    return Line(
        row,
        rtol,
        runs=len(runs),
        returned=len(answers),
        met=_part(r.outcome == "met" for r in answers),
        covers=_part(covers),
        ratio=median([r.ratio for r in answers if r.ratio is not None] or [math.nan]),
        inside=_part(inside),
        unitless=_part(r.unitless <= r.rtol for r in answers),
        silent=sum(r.silent for r in runs),
        refused=count["refused"],
        needless=sum(r.needless for r in runs),
        raw=count["raw"],
        timeout=count["timeout"],
        seconds=median([r.seconds for r in answers] or [math.nan]),
    )


def _part(flags):
    flags = list(flags)
    return sum(flags) / len(flags) if flags else math.nan


def table(runs):
    """All lines: each way at each tolerance, then at all tolerances; ``auto`` first."""
    rows = defaultdict(list)
    for r in runs:
        rows[r.method != "auto", r.method, "without" in r.way, len(r.way), r.row].append(r)
    out = []
    for (*_, row), own in sorted(rows.items()):
        for rtol in sorted({r.rtol for r in own}, reverse=True):
            out.append(line(row, rtol, [r for r in own if r.rtol == rtol]))
        out.append(line(row, None, own))
    return out


def by_subject(runs, row="auto"):
    """Pairs of subject and :class:`Line` of one way, the worst first."""
    subjects = defaultdict(list)
    for r in runs:
        if r.row == row or (r.tags[0] == "batch" and r.method == row and "without" not in r.way):
            subjects[r.tags[0]].append(r)
    lines = ((subject, line(row, None, found)) for subject, found in subjects.items())
    return sorted(lines, key=lambda pair: pair[1].met)


def worst(runs, count=20):
    """The answers most wrong against what was asked and estimated, one per case and way."""
    missed, first = [r for r in runs if r.outcome == "missed"], {}
    for r in sorted(missed, key=lambda r: -r.error / max(r.rtol, r.estimate or 0.0)):
        first.setdefault((r.case, r.row), r)
    return list(first.values())[:count]


def answers(runs):
    """The runs as answers for the chart of honesty, without methods that a model cannot use."""
    of = lambda r: {"problem": r.case, "absent": ABSENT.get(r.outcome, ""), "words": r.words}
    return [
        MethodResult(r.row, r.seconds, r.error, asked=r.rtol, estimate=r.estimate, **of(r))
        for r in runs
        if r.outcome != "unfit"
    ]


def _draw(path, runs):
    given = answers(runs)
    if given:
        cases = {a.problem for a in given}
        models = f"{len(cases)} random models of {len({c.split('/')[0] for c in cases})} families"
        figure = Figure()
        draw_honesty(given, figure, f"Methods of integration on {models}: honesty beside cost")
        figure.savefig(path, dpi=110)


def write(folder, found, lines):
    """The table, runs and changes as CSV, all as JSON, and the chart, into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    runs, changes = [r for f in found for r in f.runs], [c for f in found for c in f.changes]
    named = {"table": lines, "runs": runs, "changes": changes}
    for name, records in named.items():
        if records:
            with open(folder / f"{name}.csv", "w", newline="") as file:
                writer = csv.DictWriter(file, list(asdict(records[0])))
                writer.writeheader()
                writer.writerows(asdict(r) for r in records)
    everything = {name: [asdict(x) for x in records] for name, records in named.items()}
    everything["dropped"] = {f.case: f.dropped for f in found if f.dropped}
    everything["conditions"] = {f.case: f.condition for f in found}
    (folder / "honesty.json").write_text(json.dumps(everything, default=str))
    _draw(folder / "honesty.png", runs)
