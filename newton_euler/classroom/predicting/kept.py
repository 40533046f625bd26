"""The first prediction of each question, in a file beside the notebook: a kernel cannot write into
its own notebook, and the state of widgets is lost when that is closed.
"""

import contextlib
import json
import os
from pathlib import Path

from ...algebra.language import _

FILE = "predictions.json"


def kept_prediction(*keys: str) -> str | None:
    """What was predicted under the first of these keys that is kept, None if nothing was yet."""
    kept = _read()
    return next((kept[key] for key in keys if key in kept), None)


def keep(key: str, prediction: str) -> str:
    """Keep a prediction; returns why it could not be written, or nothing."""
    kept = {**_read(), key: prediction}
    partial = Path(f"{FILE}.{os.getpid()}")
    try:
        partial.write_text(json.dumps(kept, ensure_ascii=False, indent=1), encoding="utf-8")
        os.replace(partial, FILE)
    except OSError as error:
        _unwritten[key] = prediction
        return _("It is kept only while this notebook runs: {error}", error=error)
    return ""


_unwritten: dict[str, str] = {}


def _read():
    kept = dict(_unwritten)
    with contextlib.suppress(OSError, ValueError):
        found = json.loads(Path(FILE).read_text(encoding="utf-8"))
        kept |= {q: p for q, p in dict(found).items() if isinstance(p, str)}
    return kept
