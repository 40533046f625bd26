"""``python -m newton_euler chapters [FOLDER]``."""

from .classroom.notebooks import main

raise SystemExit(main())
