"""python -m tests.mutation: would the tests notice if a module were a little different?

Makes one small change at a time in each FILE, such as a mistake would be: a comparison or an
operator swapped, a constant doubled, a condition always true, a statement dropped, min for max. With
each change ("mutant") it runs the tests. Where one fails the mutant is killed; where all pass it
survives, and either it is equivalent (nobody could see a difference, or none that matters: a margin
that is a little larger) or a test is missing.

The files themselves are never changed: each run is a fork of this process in which the module is
compiled from the changed syntax tree. Only tests that run the changed line are taken, the shortest
first.

\b
How to read the table:
  tried      mutants that were tried
  killed     by a test that failed, or took ten times as long as without the change
  survived   each is listed with its line; "no test" if no test runs it
  late       the tests take longer than --seconds, with or without the change

\b
examples:
  python -m tests.mutation newton_euler/motion/events.py
  python -m tests.mutation newton_euler/motion/run.py --limit 50
  python -m tests.mutation newton_euler/motion/run.py --lines 301-318
  python -m tests.mutation newton_euler/motion/knots.py --tests tests/stability/test_short_blow.py

Exit code 1 if not all were killed.
"""

import random
from pathlib import Path

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from tests.mutation.mutants import mutants
from tests.mutation.runs import Target, TestsFailError, warm_up

NO_TEST = "  (no test runs it)"
LATE = "  (its tests take longer than --seconds)"


def _span(context, parameter, text):
    try:
        first, _, last = text.partition("-")
        return range(int(first), int(last or first) + 1) if text else None
    except ValueError as error:
        raise click.BadParameter(f"lines are given as 301 or 301-318, got {text!r}") from error


def own_tests(path: Path) -> list[str]:
    """The tests of a module: those of its name, else those of its folder."""
    folder = Path("tests") / path.parent
    while not folder.exists() and folder.parent.name:
        folder = folder.parent
    own = folder / f"test_{path.name}"
    found = own if own.exists() else folder
    if not found.exists():
        raise click.UsageError(f"there is no {own} for {path}: name its tests with --tests")
    return [str(found)]


@click.command(help=__doc__, context_settings={"max_content_width": 100})
@click.argument("files", nargs=-1, required=True, type=click.Path(exists=True, path_type=Path))
@click.option(
    "--tests",
    multiple=True,
    metavar="PATH",
    help="tests to run, files or node ids; may be repeated (default: tests/.../test_FILE, or its "
    "folder)",
)
@click.option("--limit", type=click.IntRange(1), help="mutants of each file, drawn at random")
@click.option("--seed", default=0, show_default=True, help="of that draw")
@click.option("--lines", callback=_span, default="", metavar="A-B", help="only in these lines")
@click.option("--seconds", default=30.0, show_default=True, help="that the tests may take")
def main(files, tests, limit, seed, lines, seconds):
    """Run it."""
    warm_up()
    table = Table("file", "tried", "killed", "survived", "late")
    console = Console(width=None if Console().is_terminal else 140)
    columns = BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    columns += (TextColumn("{task.description}"),)
    survive = False
    with Progress(*columns, console=Console(stderr=True)) as bar:
        for path in files:
            task = bar.add_task(f"{path}: without a change", total=None)
            try:
                target = Target(path, list(tests) or own_tests(path))
            except TestsFailError as error:
                raise click.ClickException(str(error)) from error
            chosen = _chosen(mutants(target.tree), lines, limit, seed)
            bar.update(task, total=len(chosen))
            alive = late = 0
            for mutant in chosen:
                relevant = target.relevant(mutant)
                killed = bool(relevant) and target.killed(mutant, relevant, seconds)
                if not killed:
                    alive += killed is False
                    late += killed is None
                    why = NO_TEST if not relevant else LATE if killed is None else ""
                    text = f"{path}:{mutant.line}: {mutant}{why}"
                    console.print(text, highlight=False, markup=False, soft_wrap=True)
                bar.update(task, advance=1, description=f"{path}: {alive} survive")
            killed = len(chosen) - alive - late
            table.add_row(str(path), *map(str, (len(chosen), killed, alive, late)))
            survive |= alive + late > 0
    console.print(table)
    raise SystemExit(survive)


def _chosen(found, lines, limit, seed):
    """The mutants in these lines, at most ``limit`` of them, in their order."""
    found = [m for m in found if not lines or m.line in lines]
    if limit and limit < len(found):
        found = [found[n] for n in sorted(random.Random(seed).sample(range(len(found)), limit))]
    return found


if __name__ == "__main__":
    main()
