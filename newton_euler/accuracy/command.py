"""``python -m newton_euler.accuracy NAME [NAME ...]``: measure, draw the chart, print the numbers."""

import argparse
import re
import sys
from pathlib import Path

from .precision import LONGEST, QUICK, TOLERANCES

TOLD = """\
What is measured is measured now, on this machine, when you ask. There are four kinds of charts:

  a scene that moves, as "top"         all methods of integration: their true errors against time and against
                                       calls of the right-hand side, and the drift of what should stay constant
  "models of projectile" and others    from the coarsest model to the fullest: time against what is left out
  a comparison, as "angle"             where nothing moves: several ways to the same number
  "map of sleeping top" and others     which method or model holds where, over two parameters

How to read one: cost to the right, error upwards, so lower left is better. What no other beats is ringed, the
front; everything else costs more and is no more accurate. Times are those of a run when all is imported and
compiled; the legend says what the first run took more. Errors are told against 30 digits. Times differ by a tenth
from run to run, and by more where the machine has other work.

examples:
  python -m newton_euler.accuracy --list
  python -m newton_euler.accuracy top "free body" --out charts
  python -m newton_euler.accuracy --all --models --format svg
"""
MODELS, MAP = "models of ", "map of "
KINDS = {
    "scenes": "scenes that move, by section",
    "models": "models of a scene",
    "comparisons": "comparisons where nothing moves",
    "maps": "maps of what holds where",
}


def main(arguments=None):
    """The command line; returns the exit code."""
    args = _parser().parse_args(arguments)
    kinds = every_name()
    if args.list or not (args.names or args.all):
        print(_listed(kinds))
        return 0
    names = [n for n in kinds if not args.models or kinds[n][0] == "models"] if args.all else args.names
    unknown = [n for n in names if _found(n, kinds, args.models) is None]
    if unknown:
        print(f"there is no chart {unknown[0]!r}; there are:\n\n{_listed(kinds)}", file=sys.stderr)
        return 2
    args.out.mkdir(parents=True, exist_ok=True)
    for name in names:
        name = _found(name, kinds, args.models)
        make = {"scenes": _scene, "models": _models, "comparisons": _comparison, "maps": _map}[kinds[name][0]]
        with Progress(name) as progress:
            figure, table = make(name, args.quick, progress)
        print(f"{name}: {kinds[name][1]}\n{table}\n{_saved(figure, name, args.out, args.format)}\n")
    return 0


def _parser():
    parser = argparse.ArgumentParser(
        prog="python -m newton_euler.accuracy", description="Charts of speed against accuracy.", epilog=TOLD,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    parser.add_argument("names", nargs="*", metavar="NAME", help="of a chart, in quotes if it has blanks; hyphens will do for them")
    parser.add_argument("--list", action="store_true", help="say which charts there are")
    parser.add_argument("--all", action="store_true", help="draw all of them, which takes some minutes")
    parser.add_argument("--models", action="store_true", help='charts of models only: "top" is then "models of top"')
    parser.add_argument("--out", type=Path, default=Path("charts"), metavar="FOLDER", help="where the charts go (default: charts)")
    parser.add_argument("--format", choices=("png", "svg"), default="png", help="of the files (default: png)")
    parser.add_argument("--quick", action="store_true", help="every other tolerance, and methods that take more than 50 ms are left out sooner")
    return parser


# -- which charts there are


def every_name():
    """All charts: by name the kind, one of :data:`KINDS`, and what they show in words."""
    from ..scenes import LADDERS, SCENES
    from .comparisons import COMPARISONS
    from .maps import MAPS

    names = {name: ("scenes", f"{scene.section:>6}  {scene.description}") for name, scene in SCENES.items()}
    names |= {f"{MODELS}{name}": ("models", found.description) for name, found in LADDERS.items()}
    names |= {name: ("comparisons", comparison.title) for name, comparison in COMPARISONS.items()}
    return names | {f"{MAP}{name}": ("maps", chart.title) for name, chart in MAPS.items()}


def _found(name, kinds, models):
    """The name as it is spelled in the list, or None."""
    plain = {_slug(n): n for n in kinds}
    wanted = [MODELS + name, name] if models else [name]
    found = next((plain[_slug(n)] for n in wanted if _slug(n) in plain), None)
    return None if found and models and kinds[found][0] != "models" else found


def _slug(name):
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _listed(kinds):
    width = max(map(len, kinds))
    lines = []
    for kind, title in KINDS.items():
        lines += [f"{title}:", *(f"  {name:{width}}  {words}" for name, (k, words) in kinds.items() if k == kind), ""]
    return "\n".join(lines).rstrip()


# -- each kind


def _figure():
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure()
    FigureCanvasAgg(figure)
    return figure


def _scene(name, quick, progress):
    from .charts import draw_methods
    from .precision import work_precision

    found = work_precision(name, QUICK if quick else TOLERANCES, longest=0.05 if quick else LONGEST, progress=progress)
    figure = _figure()
    draw_methods(found, figure)
    return figure, found.explain()


def _models(name, quick, progress):
    from ..scenes import ladder
    from .charts import draw_models, measured_models

    rungs = ladder(name.removeprefix(MODELS))
    points, figure = measured_models(rungs, progress), _figure()
    draw_models(points, rungs, figure)
    lines = [f"  {p.method:44} {_seconds(p.cost):>9}  {p.error:8.2g}" for p in points]
    return figure, "\n".join([f"  {'model':44} {'time':>9}  error of {rungs.of}", *lines])


def _comparison(name, quick, progress):
    from .comparisons import COMPARISONS

    comparison, figure = COMPARISONS[name], _figure()
    points = comparison.measure(progress)
    comparison.draw(points, figure)
    lines = [f"  {p.method:44} {p.setting:24} {_seconds(p.cost):>9}  {p.error:8.1e}" for p in points]
    return figure, "\n".join([f"  {'way':44} {'set':24} {'time':>9}  error", *lines])


def _map(name, quick, progress):
    from .maps import MAPS, draw_map

    name, figure = name.removeprefix(MAP), _figure()
    figure.set_layout_engine("constrained")
    figure.set_size_inches(10.0, 5.2)
    found = draw_map(name, figure.subplots(), (18, 15) if quick else None, progress)
    counts = {choice: int((found == choice).sum()) for choice in MAPS[name].choices}
    return figure, "\n".join([f"  {MAPS[name].words}", *(f"  {choice:44} {n / found.size:6.1%} of the map" for choice, n in counts.items() if n)])


def _seconds(x):
    from matplotlib.ticker import EngFormatter

    return EngFormatter(unit="s", places=1)(x)


def _saved(figure, name, folder, kind):
    path = folder / f"{_slug(name)}.{kind}"
    figure.savefig(path, dpi=110)
    return f"written: {path}"


class Progress:
    """A line that tells how far a measurement is, on a terminal; elsewhere nothing."""

    def __init__(self, name):
        self.name, self.shown = name, sys.stderr.isatty()

    def __call__(self, fraction, words=""):
        """Show that so much is done."""
        if self.shown:
            done = round(30 * fraction)
            print(f"\r{self.name}  [{'#' * done}{'.' * (30 - done)}] {100 * fraction:3.0f} %  {words:40.40}", end="", file=sys.stderr, flush=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.shown:
            print(f"\r{'':110}\r", end="", file=sys.stderr, flush=True)
