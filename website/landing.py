"""The interactive part of the first page: a figure to move and a question about it, both computed
when the page is built.
"""

import json
import math
import tempfile
from pathlib import Path

from exercises.catalogue import problem
from exercises.catalogue.variants import draw, practice_seed
from grader.practice import write_practice
from newton_euler.algebra.language import _
from newton_euler.classroom.practising.collection import Practice
from newton_euler.classroom.practising.files import PracticeFile
from newton_euler.classroom.practising.progress import Progress
from newton_euler.classroom.widgets.stage import Stage

from .rendering import rendered

ANGLES = range(40, 149, 9)  # few enough for a page below 300 kB
TERMS = "relative", "coriolis", "centripetal"
WRONG = 1, -1, 0, 0.5, -0.5, 2, -2


def moving_figure() -> str:
    """The figure of 4/16 at many angles, one of them visible, with the terms at each."""
    p = problem("4/16")
    values = draw(p, practice_seed(p, 0))  # numbers of a public set
    at = {angle: {**values, "beta_1": angle} for angle in ANGLES}
    stage = Stage(lambda ax, beta_1: p.code.draw(p.base(at[beta_1]), ax), (5.2, 3.6), (1, 1))
    stage.rehearse([{"beta_1": angle} for angle in ANGLES])
    frames = [stage.picture({"beta_1": x}, alt=_alt(x)).decode() for x in ANGLES]
    sizes = [_sizes(p.solve(numbers)["a_D"].terms) for numbers in at.values()]
    data = {"angles": list(ANGLES), "most": max(map(max, sizes)), "sizes": sizes}
    given = {"frames": frames, "angles": ANGLES, "middle": len(ANGLES) // 2}
    return rendered("landing.html", **given, data=json.dumps(data))


def _alt(angle):
    return _(
        "A rod is hinged to an arm that turns about the vertical; the angle beta between them is "
        "{angle} degrees.",
        angle=angle,
    )


def _sizes(terms):
    """The magnitudes of the terms of the acceleration, to three digits."""
    return [float(f"{math.hypot(*terms[name].components()):.3g}") for name in TERMS]


def _no_figure(p, values):
    return None


def question() -> str:
    """A question with the verdicts of practice on the likeliest answers."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "4-16.practice"
        write_practice(path, [problem("4/16")], 2, workers=1, draw=_no_figure)
        p = Practice([PracticeFile(path)], Progress(None))["4/16"].new()
    x, y, z = p.solved["a_D"]
    judged = []
    for factor in WRONG:
        checked = p.check(a_D=[factor * x, y, z])
        judged.append([factor * x, checked.verdicts["a_D"], checked.sentences["a_D"]])
        p.forget()
    numbers = {name: f"{value:g}" for name, value in p.givens.items()}
    numbers |= {"y": f"{y:.4g}", "z": f"{z:.4g}"}
    return rendered("taste.html", numbers=numbers, data=json.dumps(judged))
