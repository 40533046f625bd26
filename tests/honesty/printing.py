"""The table, the changes and the worst answers as text on a console of rich."""

import math
from collections import Counter

from rich.markup import escape
from rich.table import Table

from newton_euler.accuracy.measurements.honesty import table
from tests.honesty import report
from tests.honesty.cases import draw
from tests.honesty.judge import EPS


def everything(console, found, lines, count, seconds, every_call=False):
    """Print all: of ``found``, the results by case, with ``count`` of the worst answers.

    lines : the table's; seconds : the total time; every_call : True to list each call of each case
    """
    runs = [r for f in found for r in f.runs]
    for f in found if every_call else ():
        _calls(console, f)
    console.print(_table(lines))
    console.print(_subjects(report.by_subject(runs)))
    if answers := report.answers(runs):
        _say(console, "\n[bold]By method, the cheapest first; cost over the cheapest that met[/]")
        _say(console, escape(table(answers)))
    changes = [c for f in found for c in f.changes]
    for way in dict.fromkeys(c.way for c in changes):
        _changes(console, way, [c for c in changes if c.way == way])
    _worst(console, report.worst(runs, count))
    _summary(console, found, runs, seconds)


def _say(console, text):
    console.print(text, highlight=False, soft_wrap=True)


def _number(x, digits=".2g"):
    return "" if math.isnan(x) else f"{x:{digits}}"


def _rates(x):
    """Per cent met and covered, and the median of the estimate over the true error."""
    return [_number(100 * x.met, ".1f"), _number(100 * x.covers, ".1f"), _number(x.ratio)]


def _empty(title, heads):
    shown = Table(title=title, title_justify="left", box=None, pad_edge=False, header_style="bold")
    for n, head in enumerate(heads.split()):
        shown.add_column(head, justify="right" if n else "left", no_wrap=True)
    return shown


def _counts(x):
    """How many were silently wrong, refused, raw, without an answer."""
    needless = f" ({x.needless})" if x.needless else ""
    refused = f"{x.refused}{needless}" if x.refused else ""
    return [str(x.silent or ""), refused, str(x.raw or ""), str(x.timeout or "")]


def _table(lines):
    heads = "way rtol runs answers met% covers% est/true inside% silent refused raw timeout ms"
    shown = _empty("Accuracy reached and estimated", heads)
    for x in lines:
        rtol = "all" if x.rtol is None else f"{x.rtol:.0e}"
        cells = [x.row, rtol, str(x.runs), str(x.returned), *_rates(x)]
        cells += [_number(100 * x.inside, ".1f"), *_counts(x), _number(1e3 * x.seconds)]
        shown.add_row(*cells, style="bold" if x.rtol is None else None)
    return shown


def _subjects(pairs):
    heads = "subject answers met% covers% est/true silent refused raw timeout"
    shown = _empty("\nBy subject, auto at all tolerances", heads)
    for subject, x in pairs:
        shown.add_row(subject, str(x.returned), *_rates(x), *_counts(x))
    return shown


def _changes(console, way, own):
    changed = [c for c in own if c.answers]
    gross = [c for c in changed if c.gross]
    switched = sum(len(c.methods) > 1 for c in changed)
    answers, calls = sum(c.answers for c in own), sum(c.calls for c in own)
    _say(
        console,
        f"\n[bold]{way}[/]: {answers} of {calls} answers differ from the first, in {len(changed)} "
        f"of {len(own)} calls; in {len(gross)} by more than twice what was asked, in {switched} "
        "because another method was taken",
    )
    for c in sorted(gross, key=lambda c: -c.moved / c.rtol)[:5]:
        by = f"{c.answers} of {c.calls} {', '.join(c.methods)}"
        _say(console, f"  {c.case}, {c.rtol:.0e}: moved by {c.moved:.2g}; {by}")


def _case(name):
    family, seed, number = name.split("/")
    return draw(family, int(seed), int(number))


def _estimate(run):
    return "no estimate" if run.estimate is None else f"estimate {run.estimate:.1e}"


def _worst(console, runs):
    if runs:
        _say(console, "\n[bold]The worst answers[/]")
    for r in runs:
        _say(console, f"{r.row}, {r.rtol:.0e} (by {r.taken}): true {r.error:.1e}, {_estimate(r)}")
        _say(console, f"  {escape(_case(r.case).explain()[:300])}\n  {escape(r.words[:200])}")
        options = f"--case {r.case} --methods {r.method} --tolerances {r.rtol:g}"
        _say(console, f"  python -m tests.honesty {options}")


def _calls(console, f):
    _say(console, escape(_case(f.case).explain()))
    _say(console, f"condition {f.condition:.2g}; reference by {' and '.join(f.ways)}")
    for r in f.runs:
        wrong = "silently wrong" if r.silent else r.outcome
        say = f"  {r.row:28} {r.rtol:.0e} {r.taken:13} {wrong:14} true {r.error:.1e}"
        words = "" if r.outcome == "met" else escape(r.words[:160])
        _say(console, f"{say}, {_estimate(r):17} {words}")


def _summary(console, found, runs, seconds):
    judged = [f for f in found if not f.dropped]
    families = len({f.case.split("/")[0] for f in judged})
    models = f"{len(judged)} models of {families} families"
    _say(console, f"\n{models}, {len(runs)} calls, {seconds:.0f} s")
    for (first, second), n in Counter(f.ways for f in judged).most_common():
        _say(console, f"  references: {n} by {first}, checked by {second}")
    ill = sum(1e-12 < f.condition * EPS < math.inf for f in judged)
    _say(console, f"  {ill} so ill conditioned that a rounded start alone makes more than 1e-12")
    dropped = [f for f in found if f.dropped]
    if dropped:
        _say(console, f"  dropped for want of a reference: {len(dropped)}")
    for f in dropped:
        _say(console, f"    {f.case}: {escape(f.dropped)}")
