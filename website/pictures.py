"""Pictures embedded in pages, moved to files that a browser fetches when they come into view."""

import hashlib
import io
import re
from base64 import b64decode
from pathlib import Path

EMBEDDED = re.compile(r"data:image/(png|svg)(?:\+xml)?;base64,([A-Za-z0-9+/]{1000,}=*)")
SHOWN = re.compile(r'<img (?=[^>]*src="data:)')
LARGE = 20_000  # bytes of a PNG above which WebP takes a third: charts, not films


def take_out(pages: Path) -> None:
    """Move the pictures out of all pages in the folder, those of films included."""
    folder = pages / "_images"
    folder.mkdir(exist_ok=True)
    for path in pages.rglob("*.html"):
        text = path.read_text("utf-8")
        if "data:image/" in text:
            up = "../" * (len(path.relative_to(pages).parts) - 1)
            text = SHOWN.sub('<img loading="lazy" ', text)
            parts = EMBEDDED.split(text)  # text, kind, code, text, …
            for n in range(1, len(parts), 3):
                parts[n : n + 2] = f"{up}_images/{_written(parts[n], parts[n + 1], folder)}", ""
            path.write_text("".join(parts), encoding="utf-8")


def _written(kind, code, folder):
    """Write a picture; returns the name of its file."""
    contents = b64decode(code)
    if kind == "png" and len(contents) > LARGE:
        kind, contents = _lossless(contents)
    name = f"{hashlib.sha256(contents).hexdigest()[:16]}.{kind}"
    (folder / name).write_bytes(contents)
    return name


def _lossless(png):
    """The same pixels as WebP, if Pillow supports it."""
    from PIL import Image, features

    if not features.check("webp"):
        return "png", png
    out = io.BytesIO()
    Image.open(io.BytesIO(png)).save(out, "webp", lossless=True)
    return "webp", out.getvalue()
