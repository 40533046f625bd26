"""The time of a submission, from a file that a student may have written."""

from datetime import UTC, datetime
from pathlib import Path

from ..course.files import NotTaken, read_regular

YEARS = range(2000, 2200)  # other years were not written by nbgrader


def read_timestamp(folder: str | Path) -> datetime | None:
    """The submission's time, in UTC without a zone; None if missing or unreadable."""
    from nbgrader.utils import parse_utc  # imports all of nbgrader

    try:
        when = parse_utc(read_regular(Path(folder) / "timestamp.txt", 1000).decode().strip())
    except (NotTaken, ValueError, OverflowError, TypeError):
        return None
    if not isinstance(when, datetime) or when.year not in YEARS:
        return None
    return when.astimezone(UTC).replace(tzinfo=None) if when.tzinfo else when
