"""``python -m newton_euler.drawing``: write a page of everything that a sketch can draw."""

import argparse
from collections.abc import Sequence
from pathlib import Path

from .vocabulary import page


def main(arguments: Sequence[str] | None = None) -> None:
    """Write the page and print where it is."""
    parser = argparse.ArgumentParser(prog="python -m newton_euler.drawing", description=__doc__)
    parser.add_argument("--to", type=Path, default=Path("drawing.html"), help="the file to write")
    path = parser.parse_args(arguments).to
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(page(), encoding="utf-8")
    print(path)


if __name__ == "__main__":
    main()
