"""``python -m newton_euler.accuracy``: see :mod:`.command`."""

from .command import main

raise SystemExit(main())
