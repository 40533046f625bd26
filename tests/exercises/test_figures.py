"""Single figures: rotations drawn as rotations, slopes hatched, axles and faces visible."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from exercises.catalogue import problem
from exercises.catalogue.checks import values
from newton_euler.drawing.page.recorder import sketches_on


def drawn(problem_id, seed=0):
    """The numbers, in base units, and the sketch of a problem, finished."""
    p = problem(problem_id)
    ax = Figure(figsize=(5.2, 4)).add_subplot()
    g = p.base(values(p, seed))
    p.code.draw(g, ax)
    (sketch,) = sketches_on(ax)
    sketch.finish()
    return g, sketch


def strokes(sketch, style):
    return [np.array(s.points) for s in sketch.drawn.strokes if style in s.styles]


@pytest.mark.parametrize(("problem_id", "radius"), [("4/4", "R"), ("4/15", "L")])
def test_the_rate_of_an_arm_is_drawn_as_an_arc_about_its_hinge(problem_id, radius):
    g, sketch = drawn(problem_id)
    radii = [np.linalg.norm(arc, axis=1) for arc in strokes(sketch, "rate")]
    assert any(np.allclose(r, getattr(g, radius)) and len(r) > 10 for r in radii)


@pytest.mark.parametrize("seed", range(4))
def test_4_6_hatches_its_slope_and_the_roller_touches_it(seed):
    g, sketch = drawn("4/6", seed)
    (slope,) = strokes(sketch, "support")
    along = slope[1] - slope[0]
    assert np.arctan2(-along[2], along[0]) == pytest.approx(float(g.incline))
    to_centre = np.cross(along / np.linalg.norm(along), -slope[0])  # O is the origin
    assert np.linalg.norm(to_centre) == pytest.approx(0.3 * float(g.b))


def test_4_10_turns_the_cage_about_the_line_of_the_axles():
    _, sketch = drawn("4/10")
    arcs = np.concatenate(strokes(sketch, "rate"))
    radius = 0.4 * float(drawn("4/10")[0].R)
    assert len(arcs[np.abs(np.abs(arcs[:, 1]) - radius) < 0.02 * radius]) > 0


@pytest.mark.parametrize("problem_id", ["4/22", "4/23", "4/30"])
@pytest.mark.parametrize("seed", range(4))
def test_the_axle_of_the_rolling_disk_is_in_front_of_the_disk(problem_id, seed):
    _, sketch = drawn(problem_id, seed)
    order = [s.styles for s in sketch.drawn.strokes]
    assert order.index(("rod edge", "rod")) > order.index(("body",))


@pytest.mark.parametrize("seed", range(12))
def test_4_31_shows_the_end_face_on_which_P_is(seed):
    """At least a third of its true width, whatever the velocity."""
    _, sketch = drawn("4/31", seed)
    (face,) = [s for s in sketch.drawn.strokes if s.styles == ("top",)]
    assert sketch.drawn.depth(face.normal) / np.linalg.norm(face.normal) > 1 / 3


def drawn_texts(problem_id):
    """All texts in the figure of a problem, with the numbers of a variant."""
    ax = Figure(figsize=(5.2, 4)).add_subplot()
    p = problem(problem_id)
    p.code.draw(p.base(values(p, 1)), ax)
    (sketch,) = sketches_on(ax)
    sketch.finish()
    return {t.get_text() for t in ax.texts}


@pytest.mark.one_in(3)
@pytest.mark.parametrize(("problem_id", "rates"), [
    ("2/10", {"$v_1$", "$v_2$"}),
    ("2/13", {"b"}),
    ("2/14", {r"$\dot\theta,\ \ddot\theta$"}),
    ("2/16", {"$a_{n1}$", "$a_{t2}$"}),
    ("4/3", {r"$\dot\beta,\ \ddot\beta$"}),
    ("4/16", {r"$\dot\beta$"}),
    ("11/11", {"$v_C$"}),
    ("2/15", {"v", r"$\dot v$"}),
    ("2/32", {"v", "$c_A$", "$c_B$"}),
    ("2/37", {r"$\omega$", r"$\alpha$", "u"}),
    ("2/38", {r"$\omega$", "d", "u"}),
    ("2/26", {r"$\dot L,\ \ddot L$"}),
    ("3/18", {r"$\dot\beta$"}),
    ("11/12", {"r"}),
    ("2/33", {r"$\omega,\ \alpha$"}),
    ("4/21", {r"$|\dot\gamma|$"}),
    ("4/15", {r"$\omega_2,\ \dot\omega_2$"}),
    ("8/13", {r"$\omega,\ \alpha$"}),
    ("10/8", {"p"}),
    ("11/15", {r"$\omega_A$"}),
    ("4/8", {"$v_A$", "$v_B$", "$a_A$", r"$\omega_x$"}),
    ("11/3", {"W", "F"}),
    ("11/20", {"f"}),
    ("8/1", {"kL", "nL"}),
])  # fmt: skip
def test_rates_and_forces_that_are_given_are_drawn(problem_id, rates):
    texts = drawn_texts(problem_id)
    assert rates <= {t.strip() for t in texts} | {t.strip("$") for t in texts}


@pytest.mark.parametrize(("problem_id", "points"), [
    ("4/34", ""), ("4/37", ""), ("4/40", "A"), ("4/41", "B"), ("4/42", "ABC"), ("4/43", "ABD"),
])  # fmt: skip
def test_problems_with_one_machine_show_their_own_points(problem_id, points):
    """A label for a point that the text does not mention helps nobody."""
    assert drawn_texts(problem_id) & set("ABCD") == set(points)
