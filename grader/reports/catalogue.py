"""The table of problems."""

from collections.abc import Mapping, Sequence

from rich.table import Table

from exercises.catalogue.survey import ProblemEntry

from .tables import in_cell


def problems_table(
    found: Sequence[ProblemEntry], earned: Mapping[str, tuple[float, int]] | None = None
) -> Table:
    """A row for each problem; ``earned``: {problem: (share of points, number of sheets)} of a
    course.
    """
    table = Table(
        title=f"{len(found)} problem{'s' * (len(found) != 1)}",
        title_justify="left",
        box=None,
        padding=(0, 1, 0, 0),
    )
    for name in ("problem", "section", "title", "asks for"):
        most = 14 if name == "asks for" else None
        table.add_column(name, no_wrap=name in ("problem", "section"), max_width=most)
    for name in ("steps", "hard", "min", "sheets", *(() if earned is None else ("right",))):
        table.add_column(name, justify="right", no_wrap=True)
    for e in found:
        kinds = ", ".join(k.title for k in e.kinds)
        numbers = (str(e.steps + e.terms), str(e.difficulty), str(e.minutes), f"{e.sheets:.3g}")
        right = []
        if earned is not None:
            share, sheets = earned.get(e.id, (0.0, 0))
            right = [f"{share:.0%} of {sheets}" if sheets else "–"]
        table.add_row(e.id, e.section, in_cell(e.title), kinds, *numbers, *right)
    return table
