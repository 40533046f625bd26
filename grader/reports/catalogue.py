"""The table of problems to choose from."""

from collections.abc import Mapping, Sequence

from rich.table import Table

from exercises.catalogue.survey import Entry

from .tables import plain_table, shown

SHORT = {
    "vector_expression": "vector formula", "matrix_expression": "matrix formula",
    "expression": "formula",
}  # fmt: skip


def problems_table(
    found: Sequence[Entry], earned: Mapping[str, tuple[float, int]] | None = None
) -> Table:
    """A row for each problem; ``earned``: the share of points and number of sheets of a course."""
    columns = ("problem", "title", "section", "asks for", ">steps", ">diff.", ">min", ">sheets")
    more = () if earned is None else (">right",)
    table = plain_table(f"{len(found)} problems  (diff.: 1 to 5)", *columns, *more)
    for e in found:
        kinds = ", ".join(SHORT.get(k, k) for k in e.kinds)
        numbers = (str(e.steps + e.terms), str(e.difficulty), str(e.minutes), f"{e.sheets:.3g}")
        right = []
        if earned is not None:
            share, sheets = earned.get(e.id, (0.0, 0))
            right = [f"{share:.0%} of {sheets}" if sheets else "–"]
        table.add_row(e.id, shown(e.title), e.section, kinds, *numbers, *right)
    return table
