"""One configuration for the students of several courses on one machine, as on a JupyterHub."""

import shutil
from collections.abc import Sequence
from pathlib import Path

from .creation import FETCH
from .files import write_text
from .folder import Course
from .identity import CourseError

HUB = """\
\"\"\"nbgrader's configuration for the students of {names}: put this file and
newton_euler_fetch.py where Jupyter reads nbgrader_config.py (/etc/jupyter).\"\"\"

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

c = get_config()  # noqa: F821
c.ExchangeFactory.fetch_assignment = "newton_euler_fetch.PersonalFetch"
c.Exchange.path_includes_course = True  # COURSE/ASSIGNMENT in a student's home
c.Exchange.root = {root!r}
"""


def write_hub(courses: Sequence[Course], to: Path) -> str:
    """Write the students' configuration for these courses into the folder ``to``; returns their
    exchange, which must be one.
    """
    roots = {course.config().Exchange.get("root", "") or "" for course in courses}
    names = [course.name for course in courses]
    if len(roots) > 1 or not all(isinstance(r, str) and r for r in roots):
        raise CourseError(
            "these courses need one exchange, which all their students reach: build them with the "
            "same --exchange, as /srv/nbgrader/exchange"
        )
    if len(set(names)) < len(names):
        raise CourseError(f"two of these courses have the id {names[0]}: build one with --name")
    (root,) = roots
    to.mkdir(parents=True, exist_ok=True)
    shutil.copy(FETCH, to / "newton_euler_fetch.py")
    text = HUB.format(names=" and ".join(names), root=root)
    write_text(to / "nbgrader_config.py", text, 0o644)
    return root


def closed_to_others(folder: str | Path) -> Path | None:
    """The outermost folder on the way to this one that other users cannot enter, or None."""
    path = Path(folder).resolve()
    shut = (p for p in [*reversed(path.parents), path] if p.exists() and not p.stat().st_mode & 1)
    return next(shut, None)
