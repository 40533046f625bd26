"""python -m tests.honesty: how often is a result as accurate as asked, on random models?

Draws random models of many families, computes reference solutions with more digits than a float
has, by two independent methods that must agree, integrates each model in every way that the engine
offers, and counts how often the result is as accurate as asked.

\b
How to read the table; each line is one way to ask, at one tolerance:
  met       part of the answers whose true error is not above what was asked; goal: 99.5 %
  covers    part of the error estimates that are not below the true error; goal: 99 %
  est/true  median of the estimate over the true error; goal: not over 100
  inside    part of the answers whose samples on the way are within ten times what was asked
  silent    answers whose error is over ten times what was asked and estimated; goal: none
  refused   by a ModelError; in brackets those by auto although floats can reach it easily
  raw       other exceptions
  timeout   calls without an answer in --seconds

Errors are those of the worst state, relative to its largest size on the way. A case whose
reference is not reached, or whose two methods disagree, is dropped and counted. References are kept
in --cache, so that a second run is faster.

A second table, and the chart honesty.png that --out writes, have a row for each way to ask, the
cheapest first: its cost (the first call of each kind, with all its preparation) over the cost of
the cheapest as accurate as asked. `python -m newton_euler.accuracy honesty --help` explains
the chart, and draws it for the scenes.

\b
examples:
  python -m tests.honesty                                  all families and methods: half an hour
  python -m tests.honesty --draws 1 --methods auto,taylor  some minutes
  python -m tests.honesty --families dry_friction,lorenz   two families
  python -m tests.honesty --case beside_a_constant/0/2     one case, every call listed
  python -m tests.honesty --holdout                        the held-out families
  python -m tests.honesty --list                           the families
"""

import time
from functools import partial
from itertools import product
from pathlib import Path

import click
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

import tests.honesty.families
import tests.honesty.holdout  # noqa: F401
from newton_euler.algebra.names import did_you_mean
from newton_euler.motion import METHODS
from tests.honesty import printing, report
from tests.honesty.cases import DRAWS, FAMILIES, HOLDOUT
from tests.honesty.judge import SECONDS, TOLERANCES
from tests.honesty.references import SECONDS as REFERENCE_SECONDS
from tests.honesty.references import cache_folder
from tests.honesty.workers import Plan, results

ALL, LISTED = {**FAMILIES, **HOLDOUT}, "--list names them, with --holdout the held-out ones"


def _several(allowed, where=""):
    def check(context, parameter, text):
        wanted = tuple(x.strip() for x in text.split(",")) if text else ()
        for x in wanted:
            _known(x, allowed, where)
        return wanted

    return check


def _known(name, allowed, where):
    """Refuse a name that is not ``allowed``, with the nearest one, or where they are listed."""
    if name not in allowed:
        near = did_you_mean(name, allowed) or f"; {where or ', '.join(allowed)}"
        raise click.BadParameter(f"there is no {name!r}{near}")


def _numbers(context, parameter, text):
    try:
        found = tuple(float(x) for x in text.split(","))
    except ValueError as error:
        raise click.BadParameter(f"numbers with commas between them, got {text!r}") from error
    if not all(0 < x < 1 for x in found):
        raise click.BadParameter(f"a tolerance lies between 0 and 1, got {text!r}")
    return found


def _cases(context, parameter, texts):
    out = []
    for text in texts:
        name, *numbers = text.split("/")
        if len(numbers) != 2 or not all(n.isdigit() for n in numbers):
            raise click.BadParameter(f"a case is family/seed/draw, as lorenz/0/2, got {text!r}")
        _known(name, ALL, LISTED)
        out.append((name, *map(int, numbers)))
    return out


option = partial(click.option, show_default=True)
COUNT = click.IntRange(1)
FOLDER = click.Path(file_okay=False, path_type=Path)
ASKED = "auto", *METHODS
USUAL = ",".join(f"{x:g}" for x in TOLERANCES)


@click.command(help=__doc__, context_settings={"max_content_width": 100})
@option("--families", callback=_several(ALL, LISTED), metavar="A,B", help="only these families")
@option("--holdout", is_flag=True, help="the families of the holdout in place of the others")
@option("--seeds", default=1, type=COUNT, help="how many seeds")
@option("--first-seed", default=0, help="the first of them")
@option("--draws", default=DRAWS, type=COUNT, help="models of each family for each seed")
@option(
    "--case",
    "cases",
    multiple=True,
    callback=_cases,
    metavar="F/S/D",
    help="this case, every call listed; may be repeated",
)
@option("--methods", callback=_several(ASKED), metavar="A,B", help="only these methods")
@option("--tolerances", default=USUAL, callback=_numbers, help="errors asked for")
@option("--without-heyoka", "heyoka", flag_value="without", help="as if heyoka were not installed")
@option(
    "--with-heyoka-only",
    "heyoka",
    flag_value="with",
    help="without the lines of auto without heyoka",
)
@option("--no-changes", is_flag=True, help="do not repeat calls nor run them in two threads")
@option("--jobs", default=2, type=COUNT, help="cases at the same time")
@option("--seconds", default=SECONDS, help="that a call may take")
@option("--reference-seconds", default=REFERENCE_SECONDS, help="that a reference may take")
@option("--cache", type=FOLDER, help="folder of the references (default: the user's cache)")
@option("--out", type=FOLDER, help="folder for the chart, the table, and all calls as CSV and JSON")
@option("--worst", "count", default=20, help="how many of the worst answers are listed")
@option("--list", "listed", is_flag=True, help="list the families and end")
def main(families, holdout, listed, cache, out, count, jobs, cases, **asked):
    """Run the harness."""
    console = Console(width=None if Console().is_terminal else 140)
    known = HOLDOUT if holdout else FAMILIES
    if listed:
        for name, f in known.items():
            about = f.__doc__.strip().splitlines()[0]
            text = f"{name:30} {', '.join(f.tags):28} {about}"
            console.print(text, highlight=False, soft_wrap=True)
        return
    first, seeds, draws = asked["first_seed"], asked["seeds"], asked["draws"]
    drawn = product(range(first, first + seeds), families or known, range(draws))
    plan = Plan(
        asked["methods"] or ASKED, asked["tolerances"], asked["heyoka"] or "both",
        asked["seconds"], asked["reference_seconds"], str(cache or cache_folder()),
        not asked["no_changes"],
    )  # fmt: skip
    begun = time.perf_counter()
    found = _followed(cases or [(n, seed, k) for seed, n, k in drawn], plan, jobs)
    lines = report.table([r for f in found for r in f.runs])
    printing.everything(console, found, lines, count, time.perf_counter() - begun, bool(cases))
    if out:
        report.write(out, found, lines)
        console.print(f"written: {out}")


def _followed(cases, plan, jobs):
    """The results in the order of the cases; if interrupted, those that were finished."""
    columns = BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TimeRemainingColumn()
    found, silent = [], 0
    with Progress(*columns, TextColumn("{task.description}"), console=Console(stderr=True)) as bar:
        task, coming = bar.add_task("", total=len(cases)), results(cases, plan, jobs)
        try:
            for one in coming:
                found.append(one)
                silent += sum(r.silent for r in one.runs)
                done = f"{one.case}; {silent} answers silently wrong so far"
                bar.update(task, advance=1, description=done)
                if not bar.console.is_terminal and len(found) % max(1, len(cases) // 10) == 0:
                    click.echo(f"{len(found)} of {len(cases)}: {done}", err=True)
        except KeyboardInterrupt:
            coming.close()
            click.echo("interrupted: what follows is of the cases that were finished", err=True)
    order = {"/".join(map(str, c)): n for n, c in enumerate(cases)}
    return sorted(found, key=lambda f: order[f.case])


if __name__ == "__main__":
    main()
