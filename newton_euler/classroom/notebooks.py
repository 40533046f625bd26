"""``python -m newton_euler chapters [FOLDER]``: copy the course's notebooks to a folder, to read
and run them there.
"""

import argparse
import shutil
from pathlib import Path

from .. import chapters


def main(arguments=None):
    """The exit code of the command line."""
    parser = argparse.ArgumentParser(
        prog="python -m newton_euler", description="Newton-Euler dynamics: the course's notebooks."
    )
    parser.add_argument(
        "command",
        choices=["chapters"],
        help="copy the notebooks to a folder; files that are there already are left alone",
    )
    parser.add_argument(
        "folder", nargs="?", default="chapters", type=Path, help="where to (default: chapters)"
    )
    return copy_chapters(parser.parse_args(arguments).folder)


def notebooks():
    """The paths of the course's notebooks, in order."""
    return sorted(Path(chapters.__path__[0]).glob("*.ipynb"))


def copy_chapters(folder):
    """Copy each notebook that is not in ``folder`` yet, and print its path; returns 0."""
    folder.mkdir(parents=True, exist_ok=True)
    for notebook in notebooks():
        target = folder / notebook.name
        if target.exists():
            print(f"{target} is there already, left alone")
        else:
            shutil.copyfile(notebook, target)
            print(target)
    return 0
