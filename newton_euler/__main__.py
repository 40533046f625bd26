"""``python -m newton_euler chapters [FOLDER]``: copy the course's notebooks to a folder, to read and run them there."""

import argparse
import shutil
from importlib.resources import files
from pathlib import Path


def main(arguments=None):
    """The command line; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m newton_euler", description="Newton-Euler dynamics: the course's notebooks.")
    commands = parser.add_subparsers(dest="command", required=True)
    chapters = commands.add_parser("chapters", help="copy the notebooks to a folder; files that are there already are left alone")
    chapters.add_argument("folder", nargs="?", default="chapters", type=Path, help="where to (default: chapters)")
    return copy_chapters(parser.parse_args(arguments).folder)


def notebooks():
    """The course's notebooks: those in the installed package, or in the checkout that it is run from."""
    try:
        place = files("newton_euler.chapters")
    except ModuleNotFoundError:
        place = Path(__file__).resolve().parent.parent / "chapters"
    return sorted((n for n in place.iterdir() if n.name.endswith(".ipynb")), key=lambda n: n.name)


def copy_chapters(folder):
    """Copy each notebook that is not in ``folder`` yet, and say so."""
    folder.mkdir(parents=True, exist_ok=True)
    for notebook in notebooks():
        target = folder / notebook.name
        if target.exists():
            print(f"{target} is there already, left alone")
        else:
            with notebook.open("rb") as source, target.open("wb") as copy:
                shutil.copyfileobj(source, copy)
            print(target)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
