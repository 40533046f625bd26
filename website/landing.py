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


def moving() -> str:
    """The figure of 4/16 at many angles, one of them visible, with the terms at each."""
    p, values = _asked()
    stage = Stage(lambda ax, beta_1: p.code.draw(_base(p, values, beta_1), ax), (5.2, 3.6), (1, 1))
    stage.rehearse([{"beta_1": angle} for angle in ANGLES])
    frames = [stage.picture({"beta_1": x}, alt=_alt(x)).decode() for x in ANGLES]
    sizes = [_terms(p, {**values, "beta_1": angle}) for angle in ANGLES]
    most, middle = max(max(x.values()) for x in sizes), len(ANGLES) // 2
    data = {"angles": list(ANGLES), "most": most, "sizes": [list(x.values()) for x in sizes]}
    given = {"frames": frames, "angles": ANGLES, "middle": middle, "data": json.dumps(data)}
    return rendered("landing.html", **given)


def _alt(angle):
    return _(
        "A rod is hinged to an arm that turns about the vertical; the angle beta between them is "
        "{angle} degrees.",
        angle=angle,
    )


def _asked():
    """The problem and its numbers, those of a public set."""
    p = problem("4/16")
    return p, draw(p, practice_seed(p, 0))


def _base(p, values, angle):
    return p.base({**values, "beta_1": angle})


def _terms(p, values):
    """{term of the acceleration: its magnitude}, to three digits."""
    terms = p.solve(values)["a_D"].terms
    return {name: float(f"{math.hypot(*terms[name].components()):.3g}") for name in TERMS}


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
