"""The command ``python -m newton_euler.accuracy``: measure, draw the chart, print the numbers."""

import sys
from functools import partial
from pathlib import Path

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn

from ..algebra.late import Figure
from ..algebra.names import did_you_mean
from ..scenes import SCENES
from .atlas import READING, write_atlas
from .catalogue import KINDS, MODEL, MODELS, charts, slug
from .charts.honesty import draw_honesty
from .measurements.honesty import PATIENCE, honesty, table, write_csv
from .measurements.work_precision import NAMES, QUICK, TOLERANCES

HONESTY, ATLAS = "honesty", "atlas"
SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 110, "show_default": True}
FILE = click.Path(path_type=Path, dir_okay=False)
FOLDER = click.Path(path_type=Path, file_okay=False)


def _out(default):
    return click.option("--out", "folder", default=default, type=FOLDER, help="Folder to write to.")


class _Charts(click.Command):
    """The command of the charts, and those of the atlas and of honesty by their first word."""

    def main(self, args=None, prog_name=None, **more):
        """Run the command that the first word names, or else that of the charts."""
        words = sys.argv[1:] if args is None else list(args)
        other = {HONESTY: _honesty_main, ATLAS: atlas_main}.get(words[0] if words else "")
        if other:
            return other.main(words[1:], f"{prog_name or self.name} {words[0]}", **more)
        return super().main(words, prog_name, **more)


@click.command(cls=_Charts, context_settings=SETTINGS, epilog=READING)
@click.argument("names", nargs=-1, metavar="[NAME …]")
@click.option("--list", "only_list", is_flag=True, help="List the charts.")
@click.option("--all", "draw_all", is_flag=True, help="Draw all of them, which takes some minutes.")
@click.option("--models", is_flag=True, help='Charts of models only: "top" is "models of top".')
@_out("charts")
@click.option(
    "--format", "kind", default="png", type=click.Choice(("png", "svg")), help="Of the files."
)
@click.option("--quick", is_flag=True, help="Four tolerances, coarse maps; no method beyond 20 ms.")
def main(
    names: tuple[str, ...],
    only_list: bool,
    draw_all: bool,
    models: bool,
    folder: Path,
    kind: str,
    quick: bool,
) -> None:
    """Measure speed and accuracy, now and on this machine, and draw a chart of each NAME.

    Quote a name of several words, or write hyphens for the blanks:

    \b
    a scene that moves, such as "top"
        all methods of integration: the true error against the time and against
        the calls of the right-hand side, and the drift of the invariants
    "models of projectile" and others
        from the coarsest model to the fullest: operations against what is left out
    a comparison, such as "angle"
        where nothing is integrated: several methods for the same number
    "map of sleeping top" and others
        the method or model to use, over two parameters

    Two words in place of NAME are commands with a --help of their own: atlas writes all charts on a
    page; honesty asks whether each method is as accurate as requested, and its own error estimate
    true.



    \b
    Examples:
      python -m newton_euler.accuracy top "free body" --out charts
      python -m newton_euler.accuracy --all --models --format svg
    """
    known = {name: c for name, c in charts().items() if c.question == MODEL or not models}
    if only_list or not (names or draw_all):
        click.echo(_list(known))
        return
    # a scene and a ladder may have the same name, which then means the scene
    slugs = {slug(name.removeprefix(MODELS)): name for name in known}
    slugs |= {slug(name): name for name in known}
    unknown = [name for name in names if slug(name) not in slugs]
    if unknown:
        near = did_you_mean(unknown[0], known) or "."
        raise click.UsageError(
            f"there is no chart {unknown[0]!r}{near} The charts are:\n\n{_list(known)}"
        )
    folder.mkdir(parents=True, exist_ok=True)
    for name in known if draw_all else [slugs[slug(name)] for name in names]:
        path = folder / f"{slug(name)}.{kind}"
        found = _with_progress(name, partial(known[name].make, quick))
        found.figure.savefig(path, dpi=110)
        click.echo(f"{name}: {known[name].title}\n{found}\n{found.caption}\nwritten: {path}\n")


@click.command(ATLAS, context_settings=SETTINGS)
@_out(ATLAS)
@click.option("--quick", is_flag=True, help="As --quick of one chart: some minutes in all.")
def atlas_main(folder: Path, quick: bool) -> None:
    """Measure and draw every chart, to index.html in a folder, which needs no network.

    The charts are grouped by the questions that they answer: Which method? Which model? Which
    formula? Where does it change? When does it fail? Each has a caption written from what was
    measured. All take some ten minutes; leave the machine alone meanwhile.
    """
    page = _with_progress(ATLAS, partial(write_atlas, folder, (), quick))
    click.echo(f"written: {page}")


def _chosen(names, known):
    unknown = [name for name in names if name not in known]
    if unknown:
        choice = "; ".join(known.values())
        raise click.BadParameter(f"there is no {unknown[0]!r}; there are {choice}")
    return [known[name] for name in names]


def _scenes(context, parameter, names):
    known = {slug(name): name for name in SCENES}
    return _chosen([slug(name) for name in names], known) or list(SCENES)


def _methods(context, parameter, text):
    names = [word.strip() for word in text.split(",")] if text else NAMES
    return _chosen(names, {name: name for name in NAMES})


def _picture(context, parameter, path):
    if path.suffix not in (".png", ".svg", ".pdf"):
        raise click.BadParameter(f"a picture ends in .png, .svg or .pdf, got {str(path)!r}")
    return path


@click.command(HONESTY, context_settings=SETTINGS)
@click.option(
    "--scene", "scenes", multiple=True, callback=_scenes, metavar="NAME", show_default="all",
    help="This scene, as in --list of the charts; may be repeated.",
)  # fmt: skip
@click.option(
    "--methods", default="", callback=_methods, metavar="A,B", show_default="all",
    help='Only these, e.g. "auto,dop853".',
)  # fmt: skip
@click.option(
    "--out", "path", default=f"charts/{HONESTY}.png", type=FILE, callback=_picture,
    help="The picture; all runs are written beside it as CSV.",
)  # fmt: skip
@click.option(
    "--longest", default=PATIENCE, type=click.FloatRange(0),
    help="Seconds; a method whose run takes longer is asked for no more digits of that scene.",
)  # fmt: skip
@click.option("--quick", is_flag=True, help="Every other tolerance, and --longest 0.05.")
def _honesty_main(scenes, methods, path, longest, quick):
    """Measure and draw whether each method keeps its word, and what it costs.

    Every method is asked for tolerances from 1e-3 to 1e-12 on every scene that it can use, which
    takes some minutes; its answer is compared with a reference of 30 digits. A method has a row,
    the cheapest is at the top: a mark for each run, dark for a fine tolerance, a bar at the median.

    \b
    cost              of a run and of its error estimate, after imports and compilations; on several
                      scenes relative to the cheapest method that was as accurate as asked on the
                      same scene: 1 is the best that can be had
    accuracy          the true error over the tolerance: right of 1 the promise is broken; far left
                      of 1 more is done than was requested
    estimate          the estimated error over the true one: left of 1 it is too small, right of 100
                      it says little. The best is little more than 1
    ring              silently wrong: the error is over ten times both tolerance and estimate
    cross             refused: no answer, and no promise broken

    \b
    The columns, of the table as well:
      met %      part of the answers within the tolerance
      covers %   part of the estimates that are not below the true error
      est/true   their median ratio

    A sound method shows nothing in the red fields. A method may do so by refusing most runs: look
    at their number too. Marks at the edge lie beyond it.

    \b
    Examples:
      python -m newton_euler.accuracy honesty --scene top --scene "free body" --out top.svg
      python -m newton_euler.accuracy honesty --methods auto,dop853,"scipy DOP853"
    """
    tolerances, longest = (QUICK[:-1], 0.05) if quick else (TOLERANCES[:-1], longest)
    answers = _with_progress(HONESTY, partial(honesty, scenes, tolerances, methods, longest))
    if not answers:
        raise click.UsageError(f"none of these methods can be used on {', '.join(scenes)}")
    where = scenes[0] if len(scenes) == 1 else f"{len(scenes)} scenes"
    figure = Figure()
    draw_honesty(answers, figure, f"Methods of integration on {where}: honesty beside cost")
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)
    write_csv(answers, path.with_suffix(".csv"))
    click.echo(f"{table(answers)}\nwritten: {path} and {path.with_suffix('.csv')}")


def _list(charts):
    width, lines = max(map(len, charts)), []
    for kind in KINDS:
        found = [f"  {c.name:{width}}  {c.title}" for c in charts.values() if c.kind == kind]
        lines += [f"{kind}:", *found, ""] if found else []
    more = "all of them on a page: see atlas --help; honesty of the methods: see honesty --help"
    return "\n".join([*lines, more])


def _with_progress(name, work):
    """What ``work`` returns, a function of a function ``progress(fraction, words)``."""
    console = Console(stderr=True)
    columns = "{task.description}", BarColumn(), TaskProgressColumn(), "{task.fields[words]}"
    # no auto_refresh: its thread would disturb the times that are measured
    look = {"console": console, "transient": True, "auto_refresh": False}
    with Progress(*columns, **look, disable=not console.is_terminal) as bar:
        task = bar.add_task(name, total=1.0, words="")

        def progress(fraction, words=""):
            bar.update(task, completed=fraction, words=words, refresh=True)

        return work(progress)
