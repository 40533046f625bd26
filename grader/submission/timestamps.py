"""The time of a submission, from a file that a student may have written."""

import re
from datetime import UTC, datetime
from pathlib import Path

from ..course.files import NotTaken, read_regular

YEARS = range(2000, 2200)  # other years were not written by nbgrader
# what follows the time may name a zone; dateutil opens a file of that name
TIME = re.compile(r"[-+:.\d]+([ T]?[-+:.\d]*Z?)( \w{1,20}(/\w{1,20})*| [-+:\d]+)?", re.ASCII)


def read_timestamp(folder: str | Path) -> datetime | None:
    """The submission's time, in UTC without a zone; None if missing or unreadable."""
    from nbgrader.utils import parse_utc  # imports all of nbgrader

    try:
        text = read_regular(Path(folder) / "timestamp.txt", 1000).decode().strip()
        when = parse_utc(text) if TIME.fullmatch(text) else None
    except (NotTaken, ValueError, OverflowError, TypeError):
        return None
    if not isinstance(when, datetime) or when.year not in YEARS:
        return None
    return when.astimezone(UTC).replace(tzinfo=None) if when.tzinfo else when
