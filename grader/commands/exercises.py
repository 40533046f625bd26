"""Commands about the exercises: their answers, proofs, figures and mistakes."""

import json
import math
import sys
from collections import Counter
from pathlib import Path

import click
from rich.markup import escape

from .shared import FOLDER, SEED, console, count_option, names_or_all, progress_bar, step_counter


@click.command()
@click.argument("names", nargs=-1, required=True, metavar="4/16 | 11/1-11/6 | ch04 | all …")
@SEED
@click.option(
    "--given",
    "changed",
    multiple=True,
    metavar="NAME=VALUE",
    help="Replace a given, in the unit of the text: --given omega=0.9. May be repeated.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON and nothing else.")
@click.option("--explain", is_flag=True, help="Also print steps, equations and terms of sums.")
def solve(
    names: tuple[str, ...], seed: int | None, changed: tuple[str, ...], as_json: bool, explain: bool
) -> None:
    """Print the answers of problems.

    The numbers are those of the book, of a variant (--seed), or your own (--given). Formulas are
    printed in the symbols of the text; --given also replaces a symbol by a number.
    """
    from exercises.catalogue import select

    from ..reports import answers_json, answers_text, given_values, solution_text, solve_problem

    problems = select(names)
    changes = dict(_pair(c) for c in changed)
    for name in changes:
        if not any(name in p.units for p in problems):
            raise click.UsageError(
                f"none of these problems has a given {name!r}; {problems[0].id} has "
                f"{', '.join(problems[0].units) or 'none'}"
            )
    out = {}
    for p in problems:
        own = {n: v for n, v in changes.items() if n in p.units}
        try:
            results = solve_problem(p, seed, own)
        except (ArithmeticError, ValueError) as error:
            if not changes:
                raise
            raise click.UsageError(
                f"{p.id} has no answer for {', '.join(changed)}: {error}"
            ) from error
        out[p.id] = answers_json(p, results)
        if not as_json:
            console.print(answers_text(p, results))
            if explain:
                console.print(solution_text(p, given_values(p, seed, own)), soft_wrap=True)
    if as_json:
        click.echo(json.dumps(out, indent=1))


def _pair(text):
    name, _, value = text.partition("=")
    try:
        number = float(value)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise click.UsageError(
            f"--given {text}: expected NAME=VALUE with a number, as in --given omega=0.9"
        )
    return name.strip(), number


@click.command()
@click.argument("names", nargs=-1, metavar="[4/16 | 11/1-11/6 | ch04 | all …]")
@count_option("--seeds", 3, "Sets of numbers to check: the book's and drawn ones.")
@click.option(
    "--workers", type=click.IntRange(1), help="Number of processes; default: one per core."
)
def prove(names: tuple[str, ...], seeds: int, workers: int | None) -> None:
    """Check the keys, units and mistakes of problems.

    Every key must agree with its independent proof, every formula with its unit, and every listed
    mistake must differ from the key; exit code 1 if a check fails. Mistakes with the same wrong
    answer are a warning.
    """
    from exercises.catalogue import select
    from exercises.catalogue.checks import AGREEMENT

    from ..course.processes import process_pool

    problems, failed, steps, proved = select(names_or_all(names)), 0, 0, 0
    numbers = [p.id for p in problems]
    with progress_bar() as bar, process_pool(workers) as pool:
        task = bar.add_task("proving", total=len(problems))
        for p, found in zip(
            problems, pool.map(_proved, numbers, [seeds] * len(numbers)), strict=True
        ):
            faults, warnings, *counts = found
            failed += bool(faults)
            steps, proved = steps + counts[0], proved + counts[1]
            for fault in faults:
                bar.console.print(f"[red]{p.id}[/]: {escape(fault)}")
            for warning in warnings:
                bar.console.print(f"[yellow]{p.id}[/]: {escape(warning)}")
            bar.advance(task)
    click.echo(f"{len(problems) - failed} passed, {failed} failed")
    if failed:
        sys.exit(1)
    mistakes = sum(len(p.mistakes) for p in problems)
    click.echo(
        f"Every key agrees with its proof to {AGREEMENT:g} (floats) and {AGREEMENT**2:g} (50 "
        f"digits) for {seeds} sets of numbers;\n"
        f"of {steps} steps {proved} are proved by themselves, the terms of sums with their sums;\n"
        f"all units are right; {mistakes} listed mistakes give answers that differ from the key."
    )


def _proved(name, seeds):
    """(faults, warnings, number of steps, number of proved steps) of a problem."""
    from exercises.catalogue import problem
    from exercises.catalogue.checks import alike, check, proved_steps, values
    from exercises.catalogue.overlooked import missing_in_figure
    from exercises.catalogue.steps import steps

    p = problem(name)
    if faults := check(p, seeds) or missing_in_figure(p):
        return faults, [], 0, 0
    book = values(p, 0)
    return [], alike(p, seeds), len(steps(p, book)), len(proved_steps(p, book))


@click.command()
@click.argument("names", nargs=-1, required=True, metavar="4/16 | 11/1-11/6 | ch04 …")
@SEED
@click.option(
    "--to", "folder", default=Path("."), type=FOLDER, help="Folder to write to; default: here."
)
@click.option("--sheet", is_flag=True, help="Write a contact sheet for each chapter instead.")
def figure(names: tuple[str, ...], seed: int | None, folder: Path, sheet: bool) -> None:
    """Write the figure of each problem as a PNG file, and report what is hard to read in it."""
    from exercises.catalogue import select

    from ..assignment import contact_sheet, figure_faults, figure_png
    from ..reports import given_values

    def values_of(p):
        return given_values(p, seed, {})

    folder.mkdir(parents=True, exist_ok=True)
    asked = select(names)
    problems = [p for p in asked if p.figure]
    for p in asked if len(asked) < 4 else ():  # not for whole chapters
        if not p.figure:
            click.echo(f"{p.id} has no figure")
    if sheet:
        for chapter in dict.fromkeys(p.chapter for p in problems):
            path = folder / f"{chapter}_sheet.png"
            chosen = [p for p in problems if p.chapter == chapter]
            path.write_bytes(contact_sheet(chosen, values_of))
            click.echo(path)
        return
    for p in problems:
        path = folder / f"{p.id.replace('/', '_')}.png"
        if png := figure_png(p, values_of(p)):
            path.write_bytes(png)
        click.echo(path)
        for fault in figure_faults(p, values_of(p)):
            console.print(f"[yellow]{p.id}[/]: {escape(fault)}")


@click.command()
@click.argument("names", nargs=-1, required=True, metavar="4/16 | 11/1-11/6 | ch04 …")
@SEED
def solution(names: tuple[str, ...], seed: int | None) -> None:
    """Print the worked solution of each problem, as Markdown: text, steps, terms, answers."""
    from exercises.catalogue import select

    from ..assignment.solution import worked_solution
    from ..reports import given_values

    for p in select(names):
        click.echo(worked_solution(p, {**p.sympy_symbols(), **given_values(p, seed, {})}) + "\n")


@click.command()
@click.argument("chapter", metavar="ch02")
@click.option(
    "--spec",
    required=True,
    type=click.Path(path_type=Path, exists=True, dir_okay=False),
    help="The chapter's problems as one YAML list.",
)
@click.option("--only", multiple=True, metavar="2/4", help="Only this problem. May be repeated.")
@click.option("--to", "folder", type=FOLDER, help="Folder of the chapters; default: the exercises.")
def new(chapter: str, spec: Path, only: tuple[str, ...], folder: Path | None) -> None:
    """Write the files of a new chapter's problems from a spec.

    Each problem becomes pNN.yaml and a pNN.py with functions to be filled in. Existing files are
    kept; if all exist, the exit code is 2.
    """
    from exercises.catalogue.specs import write_chapter

    for path in write_chapter(chapter, spec, only, folder):
        click.echo(path)


@click.command()
@click.argument("names", nargs=-1, metavar="[4/16 | 11/1-11/6 | ch04 | all …]")
@count_option("--draws", 3, "Sets of numbers to use: the book's and drawn ones.")
@click.option(
    "--practice",
    is_flag=True,
    help="Measure the checks of practice files instead: listed mistakes in check, common "
    "slips in check_step, and random numbers in both.",
)
def diagnose(names: tuple[str, ...], draws: int, practice: bool) -> None:
    """Print how often the listed mistakes of problems are recognised.

    Each mistake is made with each set of numbers and scored as a student's answer: it is named,
    misnamed as another, or unnamed; one that passed as right gives exit code 1. A second table has
    unlisted slips, random edits of the formulas and of the set-up.
    """
    from exercises.catalogue import select

    from ..practice import practice_shares
    from ..reports import RANDOM, SLIP_OUTCOMES, diagnosis_shares, shares_table, slip_shares

    problems = select(names_or_all(names))
    with step_counter("making mistakes", len(problems)) as done:
        if practice:
            found, took = practice_shares(problems, draws, done)
        else:
            found = diagnosis_shares(problems, draws, done)
    console.print(shares_table(found, "What was given" if practice else "Listed mistakes"))
    if practice:
        click.echo(f"a check takes {1000 * took:.2g} ms")
        return  # random numbers are sometimes right
    slips = slip_shares(problems, draws)
    by_chance = slips.pop(RANDOM, Counter())
    console.print(shares_table(slips, "Unlisted slips", "kind", SLIP_OUTCOMES))
    click.echo(f"of {by_chance.total()} random numbers {by_chance['named']} are named")
    if any(counts["passed"] for counts in found.values()):
        sys.exit(1)
