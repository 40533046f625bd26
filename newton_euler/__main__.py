"""``python -m newton_euler chapters [DIR]``."""

from .classroom.notebooks import main

if __name__ == "__main__":
    raise SystemExit(main())
