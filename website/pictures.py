"""Pictures embedded in pages, moved to files that a browser fetches when they come into view."""

import io
import re
from base64 import b64decode
from functools import partial
from pathlib import Path

from PIL import Image

from .kept import put

EMBEDDED = re.compile(r"data:image/(png|svg)(?:\+xml)?;base64,([A-Za-z0-9+/]{1000,}=*)")
SHOWN = re.compile(r'<img (?=[^>]*src="data:)')
LARGE = 20_000  # bytes of a PNG above which WebP takes a third: charts, not films


def take_out(pages: Path) -> None:
    """Move the pictures out of all pages in the folder, those of films included."""
    for path in pages.rglob("*.html"):
        text = path.read_text("utf-8")
        if "data:image/" in text:
            up = "../" * (len(path.relative_to(pages).parts) - 1)
            text = SHOWN.sub('<img loading="lazy" ', text)
            path.write_text(EMBEDDED.sub(partial(_address, pages, up), text), encoding="utf-8")


def _address(pages, up, found):
    """Write a picture; returns the address of its file, with ``up`` to the first page."""
    kind, contents = found[1], b64decode(found[2])
    if kind == "png" and len(contents) > LARGE:
        out = io.BytesIO()
        Image.open(io.BytesIO(contents)).save(out, "webp", lossless=True)
        kind, contents = "webp", out.getvalue()
    return f"{up}_images/{put(pages / '_images', contents, f'.{kind}')}"
