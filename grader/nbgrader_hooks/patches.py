"""Replacements of functions of nbgrader for which it has no setting: its own follow links (even to
the secret), wait for pipes, and fail for the whole class because of one student's timestamp.txt.
"""

import os
import stat

from nbgrader.converters import base
from nbgrader.coursedir import CourseDirectory

from ..submission.files import BESIDE
from ..submission.timestamps import read_timestamp

MAX_FILE = 10 * 2**20  # bytes of a file submitted with a notebook
MAX_FILES = 200  # most files of a submission

_find_all_files = base.find_all_files


def read_regular_files_only() -> None:
    """Have nbgrader copy only small regular files, and treat an unreadable time as missing."""
    base.find_all_files = regular_files
    CourseDirectory.get_existing_timestamp = lambda self, dest_path: read_timestamp(dest_path)


def copy_only_nbgraders_own_files() -> None:
    """Have nbgrader copy nothing but the files that it wrote itself."""
    base.find_all_files = nbgraders_own_files


def regular_files(path: str, exclude: list[str] | None = None) -> list[str]:
    """Replaces ``nbgrader.converters.base.find_all_files``."""
    return [f for f in _find_all_files(path, exclude) if _is_small_and_regular(f)][:MAX_FILES]


def nbgraders_own_files(path: str, exclude: list[str] | None = None) -> list[str]:
    """Replaces ``nbgrader.converters.base.find_all_files`` for feedback."""
    own = {os.path.join(path, name) for name in BESIDE}
    return [f for f in regular_files(path, exclude) if f in own]


def _is_small_and_regular(path: str) -> bool:
    try:
        status = os.lstat(path)
    except OSError:
        return False
    return stat.S_ISREG(status.st_mode) and status.st_size <= MAX_FILE
