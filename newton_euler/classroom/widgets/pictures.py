"""Pictures of figures as a notebook shows them: with an alt text, and sharp on every screen."""

import html
import io
from base64 import b64encode
from collections.abc import Sequence
from typing import Any, TypeAlias

from ...algebra.errors import ArgumentError, checked

Bundle: TypeAlias = tuple[dict[str, str], dict[str, Any]]  # data and metadata, for display
SHORTEST_ALT = 8  # words
CSS_PIXELS = 100  # per inch of a figure
SHARP = 2  # pixels of the picture for one CSS pixel, so that it is sharp on high-dpi screens
PNG: dict[str, Any] = {"format": "png", "dpi": SHARP * CSS_PIXELS}


@checked
def show_figure(figure: Any, alt: str) -> None:
    """Show a page of sketches or a matplotlib ``figure`` once, as an HTML image or in print as a
    PNG, and close it; ``alt`` says in 8 words or more what can be seen in it.
    """
    from ...drawing.page.paper import Page
    from ...drawing.page.svg import svg

    alt = alt_text(alt)
    if isinstance(figure, Page):
        size = [side * CSS_PIXELS / 72 for side in (figure.width, figure.height)]
        show(bundle(svg(figure, alt).encode(), alt, size, png_of(figure)))
        return
    if not hasattr(figure, "savefig"):
        raise ArgumentError(f"show_figure shows a matplotlib figure or a Page; got {figure!r}")
    png = saved(figure, **PNG, bbox_inches="tight", pad_inches=0.05)
    close(figure)
    show(bundle(png, alt, [side / SHARP for side in png_size(png)], png))


def png_of(figure: Any) -> bytes | None:
    """A page or a figure as PNG; None without Matplotlib."""
    from ...drawing.page.paper import Page
    from ...drawing.page.recorder import figure_of

    try:
        return saved(figure_of(figure) if isinstance(figure, Page) else figure, **PNG)
    except ImportError:
        return None


def saved(figure: Any, **options: Any) -> bytes:
    """A figure of Matplotlib as a file."""
    from matplotlib import rc_context

    out = io.BytesIO()
    with rc_context({"svg.hashsalt": "figure"}):
        figure.savefig(out, **options)
    return out.getvalue()


def alt_text(alt: Any) -> str:
    """``alt`` on one line, if it is a text of 8 words or more."""
    if not isinstance(alt, str) or len(alt.split()) < SHORTEST_ALT:
        raise ArgumentError(f"alt says what is shown, in {SHORTEST_ALT} words or more; got {alt!r}")
    return " ".join(alt.split())


def bundle(image: bytes, alt: str, size: Sequence[float], png: bytes | None = None) -> Bundle:
    """(data, metadata) for display: the picture, PNG or SVG, as HTML, in words, and a PNG."""
    width, height = (round(side) for side in size)
    kind = "svg+xml" if image[:4] == b"<svg" or image[:5] == b"<?xml" else "png"
    tag = (
        f'<img alt="{html.escape(alt)}" width="{width}" height="{height}" decoding="sync" '
        'style="max-width: 100%; height: auto" '
        f'src="data:image/{kind};base64,{b64encode(image).decode()}">'
    )
    data = {"text/html": tag, "text/plain": alt}
    if png is None:
        return data, {}
    about = {"alt": alt, "width": width, "height": height}
    return {**data, "image/png": b64encode(png).decode()}, {"image/png": about}


def show(picture: Bundle, **options: Any) -> Any:
    """Display a :func:`bundle`; returns the handle if ``display_id`` asks for one."""
    from IPython.display import display

    data, metadata = picture
    return display(data, metadata=metadata, raw=True, **options)


def png_size(png: bytes) -> tuple[int, int]:
    """Width and height of a PNG in pixels, from its header."""
    return int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big")


def close(figure: Any) -> None:
    """Close a figure of pyplot, so that the notebook does not show it a second time."""
    import matplotlib.pyplot as plt

    plt.close(figure)
