"""What the first page lets its reader do at once: move a figure, and answer a question about it.
The engine has computed both when the page was built, so that neither waits for it.
"""

import json
import math
import tempfile
from pathlib import Path

from exercises.catalogue import problem
from exercises.catalogue.variants import draw, practice_seed
from grader.practice import write_practice
from newton_euler.algebra.language import Words, _, spoken
from newton_euler.classroom.practising.collection import Practice
from newton_euler.classroom.practising.files import PracticeFile
from newton_euler.classroom.practising.progress import Progress
from newton_euler.classroom.widgets.stage import Stage

ANGLES = range(40, 149, 9)  # the page is to stay under 300 kB
TERMS = {
    "relative": Words("relative, a<sub>r</sub>"),
    "coriolis": Words("Coriolis, 2 ω × v<sub>r</sub>"),
    "centripetal": Words("centripetal, ω × (ω × r)"),
}
ALT = Words(
    "A rod is hinged to an arm that turns about the vertical; the angle beta between them is "
    "{angle} degrees."
)
MOVING = """\
<div class="landing">
<div class="figure">{frames}</div>
<p><label for="turn">{turn} <output for="turn">{first}°</output></label>
<input id="turn" type="range" min="0" max="{last}" value="{middle}" step="1"></p>
<p class="terms">{by_terms}</p>
<dl>{rows}</dl>
<script type="application/json">{data}</script>
</div>
"""
ASK = """\
<form class="taste">
<p>{asked} <label for="taste">{question}</label></p>
<p><input id="taste" inputmode="text" autocomplete="off"> mm/s² <button>{check}</button></p>
<p role="status" class="verdict"></p>
<p>{more}</p>
<script type="application/json">{data}</script>
</form>
"""
ASKED = Words(
    "<strong>Try it.</strong> The arm turns at ω = {omega} rad/s, counterclockwise seen from "
    "above, and β grows at {b_dot} rad/s; BC is b = {b} mm, CD is L = {L} mm. At β = {beta_1}° the "
    "acceleration of D is a<sub>D</sub> = (?, {y}, {z}) mm/s² along X, Y, Z."
)
MORE = Words(
    "A wrong sign? Give it the other one, a half or zero, too: the answer says which mistake it "
    'is. <a href="problems/4-16.html">Work the whole problem</a>, with its steps and hints.'
)
WRONG = 1, -1, 0, 0.5, -0.5, 2, -2


def moving() -> str:
    """The figure of 4/16 at many angles, of which one is shown, and the terms at each."""
    p, values = _asked()
    stage = Stage(lambda ax, beta_1: p.code.draw(_base(p, values, beta_1), ax), (5.2, 3.6), (1, 1))
    stage.rehearse([{"beta_1": angle} for angle in ANGLES])
    frames = [
        stage.picture({"beta_1": angle}, alt=_(ALT, angle=angle)).decode() for angle in ANGLES
    ]
    sizes = [_terms(p, {**values, "beta_1": angle}) for angle in ANGLES]
    most, middle = max(max(x.values()) for x in sizes), len(ANGLES) // 2
    shown = "".join(
        f"<div{'' if n == middle else ' hidden'}>{x}</div>" for n, x in enumerate(frames)
    )
    rows = "".join(
        f"<dt>{spoken(words)}</dt><dd><span></span><b></b></dd>" for words in TERMS.values()
    )
    data = {"angles": list(ANGLES), "most": most, "sizes": [list(x.values()) for x in sizes]}
    return MOVING.format(
        frames=shown, first=ANGLES[middle], last=len(ANGLES) - 1, middle=middle,
        rows=rows, data=json.dumps(data), turn=_("Turn the rod: angle β ="),
        by_terms=_("The acceleration of its end, by its terms:"),
    )  # fmt: skip


def _asked():
    """The problem and the numbers that are asked, which are those of a public set."""
    p = problem("4/16")
    return p, draw(p, practice_seed(p, 0))


def _base(p, values, angle):
    return p.base({**values, "beta_1": angle})


def _terms(p, values):
    """{term of the acceleration: its size}, to three digits."""
    terms = p.solve(values)["a_D"].terms
    return {name: float(f"{math.hypot(*terms[name].components()):.3g}") for name in TERMS}


def _no_figure(p, values):
    return None


def question() -> str:
    """A question with what practice says to the answers that come first to mind."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "4-16.practice"
        write_practice(path, [problem("4/16")], 2, workers=1, draw=_no_figure)
        p = Practice([PracticeFile(path)], Progress(None))["4/16"].new()
    x, y, z = p.solved["a_D"]
    judged = []
    for factor in WRONG:
        checked = p.check(a_D=[factor * x, y, z])
        judged.append([factor * x, checked.verdicts["a_D"], checked.said["a_D"]])
        p.forget()
    numbers = {name: f"{value:g}" for name, value in p.givens.items()}
    return ASK.format(
        asked=_(ASKED, **numbers, y=f"{y:.4g}", z=f"{z:.4g}"), more=_(MORE), check=_("Check"),
        question=_("What is its first component?"), data=json.dumps(judged),
    )  # fmt: skip
