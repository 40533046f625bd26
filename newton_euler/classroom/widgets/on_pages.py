"""What a page without a kernel is given of a figure that moves."""

import os
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .interactive import MovingFigure

MOVING = "application/vnd.newton-euler.moving+json"  # the kind of what `for_site` returns
ASKED = "NEWTON_EULER_SITE"  # the variable of the environment by which the site asks for it


def described(figure: "MovingFigure") -> dict[str, Any]:
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


def for_site(figure: "MovingFigure") -> dict[str, Any]:
    """{MOVING: its sliders, and the pictures at both ends of each, which are shown until a page can
    draw others}; empty where nobody asks for it.
    """
    if not os.environ.get(ASKED):
        return {}
    ends = {s.name: [_end(figure, s.name, x) for x in s.limits] for s in figure.sliders}
    return {MOVING: {**described(figure), "ends": ends}}


def _end(figure, name, x):
    image, words = figure.picture(figure.start | {name: x})
    return {"svg": image.decode(), "alt": words}
