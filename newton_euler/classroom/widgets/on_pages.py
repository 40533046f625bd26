"""A figure that moves as data for a page without a kernel."""

import os
from typing import Any

MOVING = "application/vnd.newton-euler.moving+json"  # the kind of what `for_site` returns
ASKED = "NEWTON_EULER_SITE"  # environment variable by which the site asks for it
PLOTTED = 5  # pictures along each slider where a page without Matplotlib can draw none


def described(figure: Any) -> dict[str, Any]:
    """The sliders of a figure as a page needs them."""
    return {
        "sliders": [
            {
                "name": s.name, "label": s.label or s.name, "unit": s.unit, "start": s.start,
                "low": s.limits[0], "high": s.limits[1], "step": s.step,
            }
            for s in figure.sliders
        ]
    }  # fmt: skip


def for_site(figure: Any) -> dict[str, Any]:
    """{MOVING: its sliders, and for each some pictures along it, with the others at their start,
    which are shown until a page can draw its own}; {} unless the site asks for it.
    """
    if not os.environ.get(ASKED):
        return {}
    count = PLOTTED if figure.stage.is_plotted else 2
    along = {s.name: [_at(figure, s.name, x) for x in s.samples(count)] for s in figure.sliders}
    return {MOVING: {**described(figure), "along": along}}


def _at(figure, name, x):
    image, words = figure.picture(figure.start | {name: x})
    return {"at": x, "svg": image.decode(), "alt": words}
