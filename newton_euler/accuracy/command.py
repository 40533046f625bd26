"""The command ``python -m newton_euler.accuracy NAME [NAME ...]``: measure, draw the chart, print
the numbers.
"""

import re
from pathlib import Path

import click
from matplotlib.figure import Figure
from matplotlib.ticker import EngFormatter
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn

from ..scenes import LADDERS, SCENES, ladder
from .comparisons import COMPARISONS
from .plots import draw_methods, draw_models, measured_models
from .regime_maps import MAPS, draw_map
from .work_precision import LONGEST, QUICK, TOLERANCES, work_precision

MODELS, MAP = "models of ", "map of "


@click.command(
    context_settings={
        "help_option_names": ["-h", "--help"],
        "max_content_width": 110,
        "show_default": True,
    }
)
@click.argument("names", nargs=-1, metavar="[NAME …]")
@click.option("--list", "only_list", is_flag=True, help="List the charts.")
@click.option("--all", "draw_all", is_flag=True, help="Draw all of them, which takes some minutes.")
@click.option(
    "--models", is_flag=True, help='Charts of models only: "top" is then "models of top".'
)
@click.option(
    "--out",
    "folder",
    default="charts",
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder to write to.",
)
@click.option(
    "--format",
    "kind",
    default="png",
    type=click.Choice(("png", "svg")),
    help="Format of the files.",
)
@click.option(
    "--quick",
    is_flag=True,
    help="Every other tolerance, coarse maps; methods that take more than 50 ms are left out.",
)
def main(names, only_list, draw_all, models, folder, kind, quick):
    """Measure speed and accuracy, now and on this machine, and draw a chart of each NAME.

    A name of several words stands in quotes, or has hyphens for the blanks. There are four kinds of
    charts:

    \b
    a scene that moves, as "top"
        all methods of integration: the true error against the time and against
        the calls of the right-hand side, and the drift of the invariants
    "models of projectile" and others
        from the coarsest model to the fullest: time against what is left out
    a comparison, as "angle"
        where nothing is integrated: several methods for the same number
    "map of sleeping top" and others
        the method or model to use, over two parameters

    How to read a chart: cost to the right, error upwards, so lower left is better. The points with
    rings are the front: every other point costs more and is no more accurate. Times are those of a
    run after all imports and compilations; the legend says how much longer the first run took.
    Errors are taken against a reference of 30 digits. Times differ by a tenth from run to run, and
    by more while the machine has other work.

    \b
    Examples:
      python -m newton_euler.accuracy --list
      python -m newton_euler.accuracy top "free body" --out charts
      python -m newton_euler.accuracy --all --models --format svg
    """
    charts = {name: c for name, c in every_name().items() if c[0] is _models or not models}
    if only_list or not (names or draw_all):
        click.echo(_list(charts))
        return
    # a scene and a ladder may have the same name, which then means the scene
    known = {_slug(name.removeprefix(MODELS)): name for name in charts}
    known |= {_slug(name): name for name in charts}
    unknown = [name for name in names if _slug(name) not in known]
    if unknown:
        raise click.UsageError(f"there is no chart {unknown[0]!r}; there are:\n\n{_list(charts)}")
    folder.mkdir(parents=True, exist_ok=True)
    for name in charts if draw_all else [known[_slug(name)] for name in names]:
        make, title = charts[name]
        figure, path = Figure(), folder / f"{_slug(name)}.{kind}"
        table = _with_progress(name, make, figure, quick)
        figure.savefig(path, dpi=110)
        click.echo(f"{name}: {title}\n{table}\nwritten: {path}\n")


def every_name():
    """All charts: {name: (the function that draws it, one of :data:`KINDS`, and a title)}."""
    scenes = {s.name: (_scene, f"{s.section:>6}  {s.description}") for s in SCENES.values()}
    models = {f"{MODELS}{name}": (_models, found.description) for name, found in LADDERS.items()}
    comparisons = {c.name: (_comparison, c.title) for c in COMPARISONS.values()}
    return (
        scenes | models | comparisons | {f"{MAP}{m.name}": (_map, m.title) for m in MAPS.values()}
    )


def _slug(name):
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _list(charts):
    width, lines = max(map(len, charts)), []
    for kind, heading in KINDS.items():
        found = [f"  {n:{width}}  {title}" for n, (make, title) in charts.items() if make is kind]
        lines += [f"{heading}:", *found, ""] if found else []
    return "\n".join(lines).rstrip()


def _with_progress(name, make, figure, quick):
    console = Console(stderr=True)
    columns = "{task.description}", BarColumn(), TaskProgressColumn(), "{task.fields[words]}"
    # no auto_refresh: its thread would disturb the times that are measured
    look = {"console": console, "transient": True, "auto_refresh": False}
    with Progress(*columns, **look, disable=not console.is_terminal) as bar:
        task = bar.add_task(name, total=1.0, words="")

        def progress(fraction, words=""):
            bar.update(task, completed=fraction, words=words, refresh=True)

        return make(name, figure, quick, progress)


# -- each kind: draws on a figure and returns the table


def _scene(name, figure, quick, progress):
    tolerances, longest = (QUICK, 0.05) if quick else (TOLERANCES, LONGEST)
    found = work_precision(name, tolerances, longest=longest, progress=progress)
    draw_methods(found, figure)
    return found.explain()


def _models(name, figure, quick, progress):
    rungs = ladder(name.removeprefix(MODELS))
    points = measured_models(rungs, progress)
    draw_models(points, rungs, figure)
    return _table(points, f"error of {rungs.of}")


def _comparison(name, figure, quick, progress):
    points = COMPARISONS[name].measure(progress)
    COMPARISONS[name].draw(points, figure)
    return _table(points, "error")


def _table(points, error):
    seconds, width = EngFormatter(unit="s", places=1), max(len(p.setting) for p in points)
    rows = [
        f"  {p.method:44} {p.setting:{width}} {seconds(p.cost):>9}  {p.error:8.2g}" for p in points
    ]
    return "\n".join([f"  {'':{45 + width}} {'time':>9}  {error}", *rows])


def _map(name, figure, quick, progress):
    chart = MAPS[name.removeprefix(MAP)]
    figure.set(layout_engine="constrained", size_inches=(10.0, 5.2))
    found = draw_map(chart.name, figure.subplots(), (18, 15) if quick else None, progress)
    shares = {choice: (found == choice).mean() for choice in chart.choices}
    rows = [f"  {choice:44} {share:6.1%} of the map" for choice, share in shares.items() if share]
    return "\n".join([f"  {chart.words}", *rows])


KINDS = {
    _scene: "scenes that move, by section",
    _models: "models of a scene",
    _comparison: "comparisons where nothing moves",
    _map: "maps of parameter space",
}
