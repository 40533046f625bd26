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
    what = "copy the notebooks to a folder; files that are there already are left alone"
    parser.add_argument("command", choices=["chapters"], help=what)
    where = "where to (default: chapters)"
    parser.add_argument("folder", nargs="?", default="chapters", type=Path, help=where)
    copy_chapters(parser.parse_args(arguments).folder)
    return 0


def copy_chapters(folder):
    """Copy each notebook of the course that is not in ``folder`` yet, and print its path."""
    folder.mkdir(parents=True, exist_ok=True)
    for notebook in sorted(Path(chapters.__path__[0]).glob("*.ipynb")):
        target = folder / notebook.name
        if target.exists():
            print(f"{target} is there already, left alone")
        else:
            shutil.copyfile(notebook, target)
            print(target)
