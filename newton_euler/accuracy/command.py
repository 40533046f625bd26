"""The command ``python -m newton_euler.accuracy NAME [NAME ...]``: measure, draw the chart, print
the numbers.
"""

import re
from pathlib import Path

import click
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

from ..scenes import LADDERS, SCENES, ladder
from .comparisons import COMPARISONS
from .plots import draw_methods, draw_models, measured_models
from .regime_maps import MAPS, draw_map
from .work_precision import LONGEST, QUICK, TOLERANCES, work_precision

MODELS, MAP = "models of ", "map of "


@click.command(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.argument("names", nargs=-1, metavar="[NAME …]")
@click.option("--list", "only_list", is_flag=True, help="Say which charts there are.")
@click.option("--all", "draw_all", is_flag=True, help="Draw all of them, which takes some minutes.")
@click.option(
    "--models", is_flag=True, help='Charts of models only: "top" is then "models of top".'
)
@click.option(
    "--out",
    "folder",
    default="charts",
    show_default=True,
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder to write to.",
)
@click.option(
    "--format",
    "kind",
    default="png",
    show_default=True,
    type=click.Choice(("png", "svg")),
    help="Format of the files.",
)
@click.option(
    "--quick",
    is_flag=True,
    help="Every other tolerance, coarse maps; methods whose run takes more than 50 ms are left out "
    "sooner.",
)
def main(names, only_list, draw_all, models, folder, kind, quick):
    """Measure speed and accuracy, now and on this machine, and draw a chart of each NAME.

    A name of several words stands in quotes, or has hyphens for the blanks. There are four kinds of
    charts:

    \b
    a scene that moves, as "top"         all methods of integration: the true error against the time
                                         and against the calls of the right-hand side, and the drift
                                         of the invariants
    "models of projectile" and others    from the coarsest model to the fullest: time against what
    is left out a comparison, as "angle"             where nothing is integrated: several methods
    for the same number "map of sleeping top" and others     which method or model holds where, over
    two parameters

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
    charts = {
        name: chart for name, chart in every_name().items() if chart[0] is _models or not models
    }
    if only_list or not (names or draw_all):
        click.echo(_list(charts))
        return
    known = {_slug(name): name for name in charts}
    chosen = (
        list(charts)
        if draw_all
        else [known.get(_slug(name), known.get(_slug(MODELS + name))) for name in names]
    )
    if None in chosen:
        raise click.UsageError(
            f"there is no chart {names[chosen.index(None)]!r}; there are:\n\n{_list(charts)}"
        )
    folder.mkdir(parents=True, exist_ok=True)
    for name in chosen:
        make, title = charts[name]
        figure, table = _with_progress(name, make, quick)
        path = folder / f"{_slug(name)}.{kind}"
        figure.savefig(path, dpi=110)
        click.echo(f"{name}: {title}\n{table}\nwritten: {path}\n")


def every_name():
    """All charts: {name: (the function that makes it, one of :data:`KINDS`, and a title)}."""
    return (
        {
            name: (_scene, f"{scene.section:>6}  {scene.description}")
            for name, scene in SCENES.items()
        }
        | {f"{MODELS}{name}": (_models, found.description) for name, found in LADDERS.items()}
        | {name: (_comparison, comparison.title) for name, comparison in COMPARISONS.items()}
        | {f"{MAP}{name}": (_map, chart.title) for name, chart in MAPS.items()}
    )


def _slug(name):
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _list(charts):
    width, lines = max(map(len, charts)), []
    for kind, heading in KINDS.items():
        found = [
            f"  {name:{width}}  {title}" for name, (make, title) in charts.items() if make is kind
        ]
        lines += [f"{heading}:", *found, ""] if found else []
    return "\n".join(lines).rstrip()


def _with_progress(name, make, quick):
    console = Console(stderr=True)
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        TaskProgressColumn(),
        TextColumn("{task.fields[words]}"),
    )
    # no auto_refresh: its thread would disturb the times that are measured
    with Progress(
        *columns,
        console=console,
        transient=True,
        auto_refresh=False,
        disable=not console.is_terminal,
    ) as bar:
        task = bar.add_task(name, total=1.0, words="")
        return make(
            name,
            quick,
            lambda fraction, words="": bar.update(
                task, completed=fraction, words=words, refresh=True
            ),
        )


# -- each kind: its figure and its table


def _figure():
    from matplotlib.figure import Figure

    return Figure()


def _scene(name, quick, progress):
    found = work_precision(
        name, QUICK if quick else TOLERANCES, longest=0.05 if quick else LONGEST, progress=progress
    )
    draw_methods(found, figure := _figure())
    return figure, found.explain()


def _models(name, quick, progress):
    rungs = ladder(name.removeprefix(MODELS))
    points = measured_models(rungs, progress)
    draw_models(points, rungs, figure := _figure())
    return figure, _table(points, f"error of {rungs.of}")


def _comparison(name, quick, progress):
    points = COMPARISONS[name].measure(progress)
    COMPARISONS[name].draw(points, figure := _figure())
    return figure, _table(points, "error")


def _table(points, error):
    from matplotlib.ticker import EngFormatter

    seconds, width = EngFormatter(unit="s", places=1), max(len(p.setting) for p in points)
    lines = [
        f"  {p.method:44} {p.setting:{width}} {seconds(p.cost):>9}  {p.error:8.2g}" for p in points
    ]
    return "\n".join([f"  {'':{45 + width}} {'time':>9}  {error}", *lines])


def _map(name, quick, progress):
    chart, figure = MAPS[name.removeprefix(MAP)], _figure()
    figure.set_layout_engine("constrained")
    figure.set_size_inches(10.0, 5.2)
    found = draw_map(chart.name, figure.subplots(), (18, 15) if quick else None, progress)
    shares = {choice: (found == choice).mean() for choice in chart.choices}
    return figure, "\n".join(
        [
            f"  {chart.words}",
            *(
                f"  {choice:44} {share:6.1%} of the map"
                for choice, share in shares.items()
                if share
            ),
        ]
    )


KINDS = {
    _scene: "scenes that move, by section",
    _models: "models of a scene",
    _comparison: "comparisons where nothing moves",
    _map: "maps of what holds where",
}
