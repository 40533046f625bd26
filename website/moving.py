"""Figures with sliders on a page: the initial picture, data for the page's script, and files of
some pictures along the sliders.
"""

import json
import re
from base64 import b64decode
from html import escape
from pathlib import Path

from nbformat import NotebookNode

from newton_euler.classroom.widgets.on_pages import MOVING

from .kept import put

EMBEDDED = re.compile(r'<img\b[^>]*\bsrc="data:image/svg\+xml;base64,([^"]+)"[^>]*>')


def mark(cell: NotebookNode, folder: Path | None) -> None:
    """Wrap each moving picture of a cell for the page's script; the pictures along its sliders
    become files in the folder. Without a folder pictures are static.
    """
    outputs = (x.get("data", {}) for x in cell.outputs)
    for number, data in enumerate(x for x in outputs if MOVING in x):
        about = data.pop(MOVING)
        if folder is None:
            continue
        for picture in (x for along in about["along"].values() for x in along):
            picture["file"] = put(folder, picture.pop("svg").encode(), ".svg")
        given = escape(json.dumps({**about, "number": number}))
        # inline, so that it follows the page's theme; it has its own alternative text
        picture = EMBEDDED.sub(lambda m: b64decode(m[1]).decode(), data["text/html"])
        data["text/html"] = f'<div class="moving" data-engine data-moving="{given}">{picture}</div>'
