"""The time of a submission, from a file that a student may have written."""

from datetime import UTC, datetime
from pathlib import Path

from ..course.files import NotTaken, read_regular

YEARS = range(2000, 2200)  # what else is there was not written by nbgrader


def read_timestamp(folder):
    """The time in ``timestamp.txt`` of a folder, in UTC without a zone as nbgrader keeps it; None
    if there is none that can be read.
    """
    from nbgrader.utils import parse_utc  # with it comes all of nbgrader

    try:
        when = parse_utc(read_regular(Path(folder) / "timestamp.txt", 1000).decode().strip())
    except (NotTaken, ValueError, OverflowError, TypeError):
        return None
    if not isinstance(when, datetime) or when.year not in YEARS:
        return None
    return when.astimezone(UTC).replace(tzinfo=None) if when.tzinfo else when
