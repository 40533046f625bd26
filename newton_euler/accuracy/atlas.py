"""The atlas: all charts on one page, by the questions that they answer, which needs no network."""

import platform
from collections.abc import Sequence
from datetime import date
from html import escape
from pathlib import Path
from string import Template

from .catalogue import BORDER, FAILURE, FORMULA, METHOD, MODEL, charts, slug
from .measurements.measure import Progress, silent

PAGE = Path(__file__).with_name("atlas.html")
TITLE = "Speed and accuracy: an atlas of every scene"
READING = (
    "Cost is to the right and error upwards, so lower left is better. Points with rings are the "
    "front: every other one costs more and is no more accurate. Closed forms and methods that step "
    "have a front each. Times are those of a run after all imports and compilations; a grey bar "
    "ends at the time of the first run. Among models the cost is counted in operations, and the "
    "ring is the choice: the smallest within the tolerance. Errors are taken against a reference "
    "of 30 digits. Times differ by a tenth from run to run, more while the machine has other work."
)
# the text below each question
ANSWERS = {
    METHOD: "All methods of integration on each scene that moves: the error at the end against the "
    "time of a run, and against calls of the right-hand side.",
    MODEL: "From the coarsest model of a scene to the fullest. The ring is the smallest within the "
    "tolerance, the dashed line.",
    FORMULA: "Several ways to the same number, where nothing moves.",
    BORDER: "The cheapest choice that holds, over two parameters. The lines are theory's borders.",
    FAILURE: "Where digits are lost without a warning, or a run cannot decide.",
}


def write_atlas(
    folder: Path, names: Sequence[str] = (), quick: bool = False, progress: Progress = silent
) -> Path:
    """The path of the page, with the charts of these ``names``, or all, or why one is missing."""
    folder.mkdir(parents=True, exist_ok=True)
    wanted = [charts()[name] for name in names or charts()]
    entries = []
    for n, chart in enumerate(wanted):
        progress(n / len(wanted), chart.name)
        entries.append((chart, _entry(chart, quick, folder)))
    page = folder / "index.html"
    page.write_text(_page(entries, quick), encoding="utf-8")
    return page


def _entry(chart, quick, folder):
    """The chart as a part of the page; its picture is written beside it."""
    heading = f'<h3 id="{slug(chart.name)}">{escape(chart.name)}</h3>'
    try:
        found = chart.make(quick, silent)
    except Exception as error:  # the other charts are not lost with it
        return f"{heading}<p>Not drawn: {escape(str(error))}</p>"
    name = f"{slug(chart.name)}.png"
    found.figure.savefig(folder / name, dpi=110)
    width, height = (round(110 * side) for side in found.figure.get_size_inches())
    size = f'width="{width}" height="{height}" loading="lazy"'
    picture = f'<img src="{name}" alt="{escape(found.alt)}" {size}>'
    caption = f"<figcaption>{escape(found.caption)}</figcaption>"
    numbers = f"<details><summary>Numbers</summary><pre>{escape(str(found))}</pre></details>"
    return f"{heading}<figure>{picture}{caption}{numbers}</figure>"


def _page(entries, quick):
    contents = sections = ""
    for question, answer in ANSWERS.items():
        if own := [entry for entry in entries if entry[0].question == question]:
            links = (f'<li><a href="#{slug(c.name)}">{escape(c.name)}</a></li>' for c, _ in own)
            contents += f"<h2>{question}</h2><ul>{''.join(links)}</ul>"
            parts = "".join(text for _, text in own)
            sections += f"<section><h2>{question}</h2><p>{answer}</p>{parts}</section>"
    where = f"{platform.machine()}, Python {platform.python_version()}"
    when = f"Measured on {date.today():%d %B %Y} on {where}{', quickly' if quick else ''}."
    about = escape(f"{when} {READING} Captions come from the measurements.")
    page = Template(PAGE.read_text(encoding="utf-8"))
    return page.substitute(title=TITLE, about=about, contents=contents, sections=sections)
