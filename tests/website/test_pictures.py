"""Pictures embedded in a page, moved to files beside it."""

import io
import re
from base64 import b64encode

import numpy as np
from PIL import Image

from newton_euler.drawing.animation import Animation
from website.pictures import LARGE, take_out

RNG = np.random.default_rng(1)


def png(side):
    """A picture that no compression makes small."""
    out = io.BytesIO()
    Image.fromarray(RNG.integers(0, 255, (side, side, 3), np.uint8)).save(out, "png")
    return out.getvalue()


def pixels(contents):
    return np.asarray(Image.open(io.BytesIO(contents)).convert("RGB"))


def test_charts_and_films_become_files_with_the_same_pixels_fetched_in_sight(tmp_path):
    chart, icon, frames = png(100), png(4), tuple(png(40) for _ in range(3))
    assert len(chart) > LARGE
    film = Animation(frames, (0.0, 0.5, 1.0), 1.0, "A disk turns.", (40, 40)).html()
    tags = [
        f'<img alt="{alt}" src="data:image/png;base64,{b64encode(data).decode()}">'
        for alt, data in (("a chart", chart), ("an icon", icon))
    ]
    page = tmp_path / "chapters" / "one.html"
    page.parent.mkdir()
    page.write_text(f"{tags[0]}{film}{tags[1]}")
    take_out(tmp_path)
    text = page.read_text()
    files = [(page.parent / name).resolve() for name in re.findall(r'"(\.\./_images/[^"]+)"', text)]
    assert files[0].suffix == ".webp"
    shown = [chart, frames[0], *frames]  # the first of a film stands in it before it plays
    for path, contents in zip(files, shown, strict=True):
        assert (pixels(path.read_bytes()) == pixels(contents)).all()
    assert text.count('<img loading="lazy"') == 3
    assert tags[1].partition(" ")[2] in text  # what is small stays
