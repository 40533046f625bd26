"""Practice, the engine and its pictures where no library can be imported, as in a browser."""

import subprocess
import sys

import pytest

HIDDEN = """
import doctest, importlib, pkgutil, sys

class Hidden:
    names = {"numpy", "scipy", "matplotlib", "mpmath", "sympy", "click", "PIL", "IPython"}

    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in self.names:
            raise ModuleNotFoundError(f"{name} is hidden", name=name)

sys.meta_path.insert(0, Hidden())
sys.modules["heyoka"] = None  # which the engine looks for
import newton_euler

def modules():
    found = pkgutil.walk_packages(newton_euler.__path__, "newton_euler.")
    commands = {"newton_euler.accuracy.command"}
    for module in found:
        if not module.name.endswith("__main__") and module.name not in commands:
            yield importlib.import_module(module.name)

"""
# examples that need a library: they show arrays, mpmath's digits or what Matplotlib draws
ARRAYS = (
    "Vector.to_array", "charts.axes.chart", "integration.integrate", "ladder", "ladders.smallest",
    "measurements.honesty", "particles.projectile", "reference_solution",
    "regime_maps", "scalars.with_extra_digits", "show.compare", "solution.Motion",
    "work_precision",
)  # fmt: skip
DOCTESTS = """
tried, wrong = 0, []
for module in [*modules()][::step]:
    for test in doctest.DocTestFinder(exclude_empty=True).find(module, module.__name__):
        if test.name.endswith(arrays):
            continue
        printed = []
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
        tried += bool(test.examples)
        if runner.run(test, out=printed.append).failed:
            wrong.append("".join(printed))
assert not wrong, wrong[0]
print(tried)
"""
# what needs no array, though an installation computes it with NumPy and SciPy
NUMBERS = """
import math
from newton_euler import Frame, Inertia, Model, cos, integrate, sin
from newton_euler.bodies import integrated

skew = Inertia(Frame("body").origin, (6.0, 7.0, 5.0), (-1.2, 0.7, 2.1)).principal()
trace, squares = sum(skew.moments), sum(x * x for x in skew.moments)
assert abs(trace - 18.0) < 1e-13 and abs(squares - 110.0 - 2 * (1.44 + 0.49 + 4.41)) < 1e-12
for moment, axis in zip(skew.moments, skew.axes):
    for row, e in zip(skew.inertia.matrix, axis.c):
        assert abs(sum(a * b for a, b in zip(row, axis.c)) - moment * e) < 1e-13
ball = integrated(
    lambda r, a, b: (r * sin(a) * cos(b), r * sin(a) * sin(b), r * cos(a)),
    (0.0, 2.0), (0.0, math.pi), (0.0, 2 * math.pi), frame=Frame("ball"), mass=5.0,
)
assert all(abs(x / 8.0 - 1) < ball.error < 1e-9 for x in ball.inertia.moments)
spring = Model("spring", {}, ("x", "v"), lambda s, p, t: (s.v, -s.x))
assert abs(integrate(spring, 3.0, (1.0, 0.0)).at(2.0)["x"] - math.cos(2.0)) < 1e-7
"""
# figures of chapters: those without arguments, and some others that draw curves
CHAPTERS = """
from inspect import isfunction, signature

from newton_euler.chapters.figures import appA, ch05, ch06, ch07, ch08, ch10, ch11
from newton_euler.classroom.widgets import interactive

def take(figure):
    figure.stage.rehearse([figure.start])
    for start in figure.start, {s.name: s.limits[1] for s in figure.sliders}:
        assert b"<path" in figure.picture(start)[0]
    assert figure.stage.png() is None
    taken.append(figure)

taken, interactive.taker = [], take
alone = {
    figure
    for module in (appA, ch05, ch06, ch07, ch08, ch10, ch11)
    for figure in vars(module).values()
    if isfunction(figure)
    and hasattr(figure, "sliders")
    and len(signature(figure.draw).parameters) == 1 + len(figure.sliders)
}
for figure in alone:
    figure()
for show in ch06.screw_jack, ch07.two_balls, ch07.rods_and_axis, ch07.propeller:
    show()
ch11.weight_on_spring(2.0, 100.0)
ch11.pendulum_levels(1.0, 0.1, 0.5)
ch10.compass_swings(0.002, 0.003, 1000.0, 7.292e-5)
ch10.hanging_rod(lambda omega: 0.1 * omega)
ch08.sphere(v0=7.0, mu=0.4, g=9.81, radius=0.2)
assert len(taken) > 40, len(taken)
"""
PRACTICE = """
from newton_euler.classroom import practice

p = practice(path, progress=None)["4/16"]
print(p.check(alpha_CD=[0, -0.27, 0], v_D=[-9.6, 6.4, -3.6], a_D=[1, 2, 3]).verdicts)
print(p.check(v_D=[-9.6, 6.24, -3.6]).text)
"""
FIGURES = """
from newton_euler.classroom.widgets.stage import Stage
from newton_euler.drawing import svg_of, vocabulary
from tests.chapters.moving_figures import FIGURES

for entry in vocabulary.entries()[::14]:
    assert "<path" in svg_of(vocabulary.draw, entry)
for figure, given in FIGURES.values():
    start = {slider.name: slider.start for slider in figure.sliders}
    options = figure.options
    stage = Stage(lambda ax, **v: figure.draw(ax, **given, **v), options.get("size", (7, 4.6)),
                  options.get("panels", (1, 1)))
    stage.rehearse([start])
    assert b"<path" in stage.picture(start)
    assert stage.png() is None
print("drawn", Hidden.names & sys.modules.keys())
"""


def ran_hidden(*programs, **values):
    """What the programs print, one after another, in a Python without libraries."""
    known = "".join(f"{name} = {value!r}\n" for name, value in values.items())
    program = sys.executable, "-W", "error", "-c", HIDDEN + known + "".join(programs)
    done = subprocess.run(program, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_rooms_examples_practice_and_figures_need_no_library(practice_file):
    programs = DOCTESTS, NUMBERS, PRACTICE, CHAPTERS, FIGURES
    output = ran_hidden(*programs, path=str(practice_file), step=18, arrays=ARRAYS)
    assert int(output.split()[0]) > 5  # of every 18th module
    assert "{'alpha_CD': 'right', 'v_D': 'wrong', 'a_D': 'wrong'}" in output
    assert "v_D: right" in output
    assert output.endswith("drawn set()\n")


@pytest.mark.slow
def test_all_examples_that_need_no_array_pass():
    assert int(ran_hidden(DOCTESTS, step=1, arrays=ARRAYS)) > 360
