"""``python -m newton_euler chapters [DIR]``: copy the course's notebooks to a folder, to read and
run them there.
"""

import argparse
import shlex
import shutil
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

HELP = """\
Copy the notebooks of the course to the folder DIR, and say how to open them.

Files in DIR are kept, so a second call adds only what is new. To get a chapter again, rename or
delete your copy first.
"""
EXAMPLES = """\
examples:
  python -m newton_euler chapters             to the folder "chapters" here
  python -m newton_euler chapters ~/dynamics  to another one; then: jupyter lab ~/dynamics
"""
CHAPTERS = Path(__file__).parent
# packages that open notebooks and draw their sliders
NEEDED = ("jupyterlab", "ipywidgets")


def main(arguments: Sequence[str] | None = None) -> int:
    """The exit code of the command line."""
    parser = argparse.ArgumentParser(
        prog="python -m newton_euler",
        description="The course on Newton-Euler dynamics.",
        epilog="More about a command: python -m newton_euler chapters --help",
    )
    commands = parser.add_subparsers(required=True, metavar="chapters")
    command = commands.add_parser(
        "chapters",
        help="copy the notebooks of the course to a folder",
        description=HELP,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    where = "folder to copy to, created if missing (default: chapters)"
    command.add_argument(
        "folder", nargs="?", default="chapters", type=Path, metavar="DIR", help=where
    )
    folder = parser.parse_args(arguments).folder
    try:
        copied, kept = copy_chapters(folder)
    except OSError as error:
        command.error(_refused(folder, error))
    print(_summary(folder, copied, kept))
    print(_how_to_open(folder))
    return 0


def copy_chapters(folder: Path) -> tuple[list[str], list[str]]:
    """Copy each notebook of the course that is not in ``folder`` yet; returns the names of those
    copied and of those already there.
    """
    folder.mkdir(parents=True, exist_ok=True)
    names = sorted(path.name for path in CHAPTERS.glob("*.ipynb"))
    kept = [name for name in names if (folder / name).exists()]
    copied = [name for name in names if name not in kept]
    for name in copied:
        shutil.copyfile(CHAPTERS / name, folder / name)
    return copied, kept


def _refused(folder, error):
    if folder.exists() and not folder.is_dir():
        return f"{folder} is a file; name a folder, or a name that is not taken"
    return f"nothing can be written to {folder}: {error.strerror}"


def _summary(folder, copied, kept):
    lines = [f"copied to {folder}: {_count(copied)}", *(f"  {name}" for name in copied)]
    if kept:
        lines += [f"there already, left alone: {_count(kept)}", *(f"  {name}" for name in kept)]
    return "\n".join(lines)


def _count(names):
    return f"{len(names)} notebook{'' if len(names) == 1 else 's'}"


def _how_to_open(folder):
    missing = " ".join(name for name in NEEDED if find_spec(name) is None)
    first = f"  pip install {missing}\n" if missing else ""
    return f"To open them:\n{first}  jupyter lab {shlex.quote(str(folder))}"
