"""Typical slips of those who write their first problem: each is an edit of a good problem, and is
found with words that say where it is and what to do.
"""

import contextlib
import os
import re
import shutil
import sys
from pathlib import Path

import pytest

import exercises
from exercises.catalogue import CatalogueError, places, problem, reading, variants
from exercises.catalogue.checks import alike, check
from exercises.catalogue.overlooked import missing_in_figure

GOOD = Path(__file__).with_name("own_problems")
TEXT, CODE = "p01.yaml", "p01.py"


@contextlib.contextmanager
def place(folder):
    """The problems in this folder are known, and forgotten again."""
    path = list(exercises.__path__)
    names = places.use(folder)
    try:
        yield names
    finally:
        os.environ.pop(places.VARIABLE)
        exercises.__path__[:] = path
        reading.forget()
        variants._compiled.cache_clear()
        for module in [m for m in sys.modules if m.split(".")[1:2] and m.split(".")[1] in names]:
            del sys.modules[module]


def found(folder, seeds=3):
    """What the checks say of bead/1 in this folder."""
    with place(folder):
        try:
            p = problem("bead/1")
            return check(p, seeds) or [*alike(p, seeds), *missing_in_figure(p)]
        except CatalogueError as error:
            return [str(error)]


def edited(tmp_path, *edits):
    """A copy of the good problem with parts of its files, (file, what, by what), replaced."""
    shutil.copytree(GOOD / "bead", tmp_path / "bead", ignore=shutil.ignore_patterns("__*"))
    for file, old, new in edits:
        path = tmp_path / "bead" / file
        text = path.read_text()
        assert text.count(old) == 1, (old, text.count(old))
        path.write_text(text.replace(old, new))
    return tmp_path


def test_the_good_problem_is_found_good():
    assert found(GOOD) == []


SLIPS = {
    "a name that is not given": (
        [(TEXT, "rate {omega}", "rate {gamma}")],
        r"text: \{gamma\} is no given, symbol or answer; there are omega, v, r, L",
    ),
    "a name that is nearly given": (
        [(TEXT, "rate {omega}", "rate {omgea}")], r"\{omgea\} is no given.*; did you mean \{omega\}\?",
    ),
    "a book value outside its range": (
        [(TEXT, "vary: [350, 500]", "vary: [35, 50]")], r"L: the value 400 is outside of vary: \[35, 50\]",
    ),
    "a wrong number found by hand": (
        [(TEXT, "v_B: [30, 100, 0]", "v_B: [30, 10, 0]")],
        r"checked: v_B is \[30, 10, 0\] by hand, and solve gives \(30, 100, 0\)",
    ),
    "a formula found by hand that cannot be read": (
        [(TEXT, "time: 20/3", "time: 20//")], r"checked: time: '20//' cannot be read",
    ),
    "a figure without a letter": (
        [(CODE, 's.dimension(O, end, label="L"', 's.dimension(O, end, label="l"')],
        r"the figure has no label L, .*figure: true",
    ),
    "a figure without a point of the text": (
        [(CODE, '    s.label(B, "B", offset=(0, -12))\n', "")], r"the figure has no label B, a point of its text",
    ),
    "a figure without a text": (
        [(TEXT, """figure: >
  A vertical axle at O with an arrow omega about it; a horizontal rod of length L from O; a bead B
  on the rod at the distance r from O, with an arrow v outward.
""", "")],
        r"p01.py has draw, but p01.yaml no figure:, the text for those who cannot see it",
    ),
    "a figure that cannot be drawn": (
        [(CODE, "s.rod(O, end)", "s.rood(O, end)")], r"draw: .*bead/p01.py, line \d+: .*rood.*did you mean.*rod",
    ),
    "a given that is never used": (
        [(TEXT, "givens:\n", "givens:\n  m: {value: 2, unit: kg, means: mass of B, vary: [1, 3]}\n")],
        r"no answer depends on m",
    ),
    "a given in a unit of another quantity": (
        [(TEXT, "r: {value: 200, unit: mm,", "r: {value: 200, unit: s,")],
        r"unlike quantities: .*bead/p01.py, line \d+",
    ),
    "a mistake under another name": (
        [(CODE, '"speeds_added":', '"speed_added":')],
        r"the mistake speed_added is computed but not in p01.yaml; did you mean speeds_added\?",
    ),
    "a tolerance wider than a mistake": (
        [(TEXT, "unit: mm/s^2, means", "unit: mm/s^2, atol: 40, means")],
        r"a_B: atol: 40 mm/s\^2 takes the mistake no_coriolis for right",
    ),
    "an answer that is the same for all": (
        [(CODE, '"time": (g.L - g.r) / g.v,', '"time": 0.02 * (g.L - g.r) / (g.L - g.r) * g.one * (g.r / g.v) / (g.r / g.v),'),
         (CODE, '"time": left / g.v}', '"time": 0.02 * g.one}')],
        r"time is the same .*whatever the numbers|time is asked for in s",
    ),
    "a range in which there is no answer": (
        [(TEXT, "r: {value: 200, unit: mm, means: distance of B from O, vary: [100, 300]",
          "r: {value: 200, unit: mm, means: distance of B from O, vary: [100, 2000]"),
         (CODE, '"time": (g.L - g.r) / g.v,', '"time": sqrt(g.L - g.r) * sqrt(g.L - g.r) / g.v,'),
         (CODE, "import Frame, moving", "import Frame, moving, sqrt")],
        r"of \d+ draws \d+ are refused.*vary",
    ),
    "a division by zero in a range": (
        [(TEXT, "vary: [20, 60]", "vary: [0, 60]"), (TEXT, "v: {value: 30", "v: {value: 0")],
        r"time.*(not finite|infinite|no real)|prove: .*line 37: ZeroDivisionError",
    ),
    "a step that is an answer": (
        [(TEXT, "steps:\n", "steps:\n  velocity: {unit: mm/s, means: velocity of B}\n"),
         (CODE, 'return {"omega_rod": rod.angular_velocity(ground)}',
          'return {"omega_rod": rod.angular_velocity(ground), "velocity": solve(g)["v_B"]}')],
        r"the step velocity is an answer",
    ),
    "a step without a text": (
        [(CODE, '"omega_rod": rod', '"omega_rd": rod')], r"the step 'omega_rd' .*did you mean omega_rod\?",
    ),
    "a given under another name": (
        [(CODE, "rate=g.omega)", "rate=g.omgea)")],
        r"bead/p01.py, line 9: .*omgea.*; did you mean omega\?",
    ),
    "an error in Python": (
        [(CODE, 'v = B.velocity(ground, via=rod)\n    a = B.acceleration(ground, via=rod)\n    return {\n        "v_B"',
          'v = B.velocty(ground, via=rod)\n    a = B.acceleration(ground, via=rod)\n    return {\n        "v_B"')],
        r"solve: .*bead/p01.py, line 15: .*velocty.*did you mean.*velocity",
    ),
    "code that is no Python": (
        [(CODE, "def solve(g):", "def solve(g)")], r"bead/p01.py, line 13: .*expected ':'",
    ),
    "a function that is not written yet": (
        [(CODE, '    ground, rod, _ = bead(g)\n    return {"omega_rod": rod.angular_velocity(ground)}',
          "    raise NotImplementedError")],
        r"steps: .*bead/p01.py, line \d+: .*not written yet",
    ),
    "math of numbers alone": (
        [(CODE, '"time": (g.L - g.r) / g.v,', '"time": math.sqrt((g.L - g.r) ** 2) / g.v,'),
         (CODE, "from exercises.tools", "import math\n\nfrom exercises.tools")],
        r"bead/p01.py, line \d+: .*sqrt.* of newton_euler, not of math",
    ),
    "a proof that is the solution": (
        [(CODE, '    velocity = rate(B)\n    left = g.L - g.r\n', "    return solve(g)\n")],
        r"prove .*(engine|solve)",
    ),
    "an answer under another key": (
        [(CODE, '        "speed": v.norm(),', '        "sped": v.norm(),')],
        r"solve returns .*sped.*; did you mean speed\?",
    ),
    "a vector without axes": (
        [(TEXT, "frame: >\n  Ground axes with origin O: x along the rod at the instant, z up.\n", "")],
        r"v_B is a vector: say in frame: along which axes",
    ),
    "a section that is not there": (
        [(TEXT, 'section: "4.8"', 'section: "4.88"')], r"section 4.88 is not in the chapters",
    ),
    "a mistake whose text does not go on from the answer": (
        [(TEXT, "no_turning: leaves out", "no_turning: The student left out")],
        r"no_turning: .*'leaves out",
    ),
    "an answer that is named as a given": (
        [(TEXT, "{key: time,", "{key: L,"), (CODE, '"time": (g.L - g.r) / g.v,', '"L": (g.L - g.r) / g.v,'),
         (CODE, '"time": left / g.v}', '"L": left / g.v}'), (CODE, '{"time": g.L / g.v}', '{"L": g.L / g.v}'),
         (TEXT, "  time: 20/3\n", "")],
        r"L is a given and an answer",
    ),
}  # fmt: skip


@pytest.mark.parametrize("slip", SLIPS, ids=[s.replace(" ", "_") for s in SLIPS])
def test_a_slip_is_found_and_said(slip, tmp_path):
    edits, message = SLIPS[slip]
    sentences = found(edited(tmp_path, *edits))
    assert any(re.search(message, s, re.S) for s in sentences), sentences
