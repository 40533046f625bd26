"""``python -m newton_euler chapters [DIR]``."""

from .chapters.copying import main

if __name__ == "__main__":
    raise SystemExit(main())
