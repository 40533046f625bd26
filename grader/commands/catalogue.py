"""The commands ``problems`` and ``preview``, for choosing problems."""

import json
import math
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from .shared import FILE, console, course_option, names_or_all, step_counter

if TYPE_CHECKING:
    from ..course import Course

COLUMNS = ("id", "section", "steps", "difficulty", "minutes", "sheets", "right")


class Span(click.ParamType):
    """A number, or a range with perhaps an open end."""

    name = "LOW-HIGH"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        low, dash, high = value.partition("-")
        try:
            first, last = float(low or 0), float(high or math.inf) if dash else float(low)
        except ValueError:
            first, last = math.nan, math.nan
        if not first <= last:
            self.fail(f"{value!r} is not a range: write 3, 2-4, 2- or -4", param, ctx)
        return first, last


SPAN = Span()


@click.command()
@click.argument("names", nargs=-1, metavar="[ch04 | 4/16 | 11/1-11/6 | hw3 …]")
@click.option(
    "--section", "sections", multiple=True, metavar="4.10", help="In this section, or chapter 4."
)
@click.option(
    "--kind", "kinds", multiple=True, help="With an answer of this kind: number, vector, choice …"
)
@click.option("--equation", "equations", multiple=True, metavar="4.18", help="Using this equation.")
@click.option("--search", "words", metavar="WORDS", help="With all these words in its texts.")
@click.option("--steps", type=SPAN, help="Number of steps to its answers.")
@click.option("--difficulty", type=SPAN, help="From 1 to 5, estimated from the computation.")
@click.option("--minutes", type=SPAN, help="Estimated time.")
@click.option("--sheets", type=SPAN, help="Number of different sheets.")
@course_option("Also list the share of points that its students earned, and the number of sheets.")
@click.option("--right", type=SPAN, help="Share of points earned, in percent.")
@click.option(
    "--sort", type=click.Choice(COLUMNS), help="Sort by this column; default: as in the book."
)
@click.option("--reverse", is_flag=True, help="Sort the other way round.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON and nothing else.")
def problems(
    names: tuple[str, ...],
    sections: tuple[str, ...],
    kinds: tuple[str, ...],
    equations: tuple[str, ...],
    words: str | None,
    course: "Course | None",
    right: tuple[float, float] | None,
    sort: str | None,
    reverse: bool,
    as_json: bool,
    **spans: tuple[float, float] | None,
) -> None:
    """List problems by subject and difficulty.

    Difficulty and minutes are estimates from the steps, equations and operations of the solution;
    with --course also what students earned. If the number of sheets is 1, all students have the
    same numbers.

    \b
    problems ch04 --difficulty 1-2               the easy ones of chapter 4
    problems --search "gyroscope precession"     in all texts
    problems --equation 4.18 --kind vector --minutes -20
    problems --course ~/mechanics --right -50    those in which half of the points were lost
    """
    from exercises.catalogue.survey import ProblemEntry, Wanted, matching
    from newton_euler.answers.kinds import KINDS

    from ..assignment.chosen import named
    from ..assignment.options import unknown
    from ..reports import measured, problems_table

    if wrong := [k for k in kinds if k.replace(" ", "_") not in KINDS]:
        raise click.UsageError(f"--kind {unknown(wrong[0], KINDS)}")
    if right and not course:
        raise click.UsageError("--right is what students earned: name a --course")
    asked = list(named(names_or_all(names), course))
    limits = {name: span for name, span in spans.items() if span}
    wanted = Wanted(
        sections, tuple(k.replace(" ", "_") for k in kinds), equations,
        tuple((words or "").split()), limits,
    )  # fmt: skip
    found: list[ProblemEntry] = []
    with step_counter("reading problems", len(asked)) as done:
        for p in asked:
            found += matching([p], wanted)
            done()
    earned = measured(course) if course else {}
    if right:
        low, high = right
        found = [e for e in found if e.id in earned and low <= 100 * earned[e.id][0] <= high]
    if sort and sort != "id":
        key = (lambda e: earned.get(e.id, (2, 0))[0]) if sort == "right" else _by(sort)
        found = sorted(found, key=key)
    if reverse:
        found.reverse()
    if as_json:
        click.echo(json.dumps([_as_json(e, earned) for e in found], indent=1))
    elif not found:
        click.echo("No problem matches.")
    else:
        console.print(problems_table(found, earned if course else None))


def _by(name):
    """The sort key of a column; sections by number, appendices first."""
    if name != "section":
        return lambda e: getattr(e, name)
    return lambda e: [int(x) if x.isdigit() else 0 for x in e.section.split(".")]


def _as_json(e, earned):
    listed = {k: x for k, x in vars(e).items() if k != "words"}
    listed["kinds"] = [kind.name for kind in e.kinds]
    listed |= {"difficulty": e.difficulty, "minutes": e.minutes}
    share, sheets = earned.get(e.id, (None, 0))
    return listed | ({"share_of_points": share, "graded_sheets": sheets} if sheets else {})


@click.command()
@click.argument("names", nargs=-1, required=True, metavar="4/16 | 11/1-11/6 | hw3 …")
@course_option("Where hw3 is an assignment.")
@click.option("--text", is_flag=True, help="Print it in the terminal instead.")
@click.option("--to", "path", type=FILE, help="The page to write; default: a private new folder.")
@click.option("--no-open", is_flag=True, help="Do not open a browser.")
def preview(
    names: tuple[str, ...], course: "Course | None", text: bool, path: Path | None, no_open: bool
) -> None:
    """Preview problems on a page in the browser.

    For each: text, figure, key, the numbers and keys of three students, steps, tolerance, number of
    sheets, difficulty, and every listed mistake with its answer and its feedback. The page holds
    keys: only you can read the file.
    """
    from ..assignment.chosen import named
    from ..course.files import write_text
    from ..reports import preview as previewed
    from ..reports import preview_page, preview_text

    chosen, found = named(names, course), []
    with step_counter("solving and drawing", len(chosen)) as done:
        for p, options in chosen.items():
            found.append(previewed(p, options))
            done()
    if text:
        for each in found:
            console.print(preview_text(each), soft_wrap=True)
        return
    path = path or Path(tempfile.mkdtemp(prefix="preview-")) / "preview.html"
    write_text(path, preview_page(found))
    click.echo(path)
    if not no_open:
        click.launch(str(path))
