"""Drawing: to scale, right-handed, finished automatically, and mistakes reported in words."""

import io
import math

import numpy as np
import pytest

from newton_euler import Frame, NewtonEulerError
from newton_euler.drawing.page.primitives import KINDS
from newton_euler.drawing.sketch import Sketch
from tests.sketching import O, ground, png, sketch, texts, vertices


def test_points_vectors_and_triples_name_the_same_place():
    arm = ground.rotate("arm", "z", angle=math.pi / 2)
    s = sketch(plane="xy")
    for place in (arm.point("P", 2, 0, 0), arm.vector(2, 0, 0), (0, 2, 0), [0.0, np.float64(2), 0]):
        s.line(O, place)
    for line in vertices(s):
        assert line[1] == pytest.approx((0, 2), abs=1e-12)


def test_one_metre_is_as_long_across_as_up_within_the_axes():
    s = sketch()
    s.rod((0, 0, 0), (0, 7, 1))
    png(s)
    (ax, ay), (bx, by) = s.ax.transData.transform([(0, 0), (1, 1)])
    assert bx - ax == pytest.approx(by - ay, rel=1e-9)
    assert not s.ax.axison
    s = sketch()
    s.box((0, 0, 0), ground, (1, 5, 2))
    s.axes((0, 2.5, 1), ground)
    s.vector((0, -2.5, -1), (0, -1, 0), "v")
    png(s)
    for patch in s.ax.patches:
        seen = s.ax.transAxes.inverted().transform(
            s.ax.transData.transform(patch.get_path().vertices)
        )
        assert (seen > -0.01).all()
        assert (seen < 1.01).all()


def test_a_disk_is_as_wide_as_its_diameter_and_foreshortened_by_the_elevation():
    s = sketch(azimuth=10, elevation=30)
    s.disk((1, 2, 3), ground.k, 0.5)
    assert np.ptp(vertices(s)[0], axis=0) == pytest.approx((1, 0.5), rel=3e-3)


def test_an_arc_spans_its_angle_farther_out_where_it_is_small():
    s = sketch(plane="xy")
    A, B = (2, 0, 0), (3 * math.cos(2), 3 * math.sin(2), 0)
    s.line(O, A)
    s.line(O, B)
    s.arc(O, A, B, label=r"$\beta$")
    x, y = vertices(s)[-1].T
    angles = np.unwrap(np.arctan2(y, x))
    assert angles == pytest.approx(np.linspace(0, 2, len(angles)))
    assert np.ptp(np.hypot(x, y)) < 1e-12
    assert r"$\beta$" in texts(s)

    def drawn(angle, **radius):
        s = sketch(plane="xy")
        s.line(O, (1, 1, 0))
        s.arc(O, (1, 0, 0), (math.cos(angle), math.sin(angle), 0), **radius)
        return np.hypot(*vertices(s)[-1][0]), s.drawn.pt

    assert drawn(0.3, radius=0.4)[0] == pytest.approx(0.4)
    assert [r / pt for r, pt in map(drawn, (1, 0.1))] == pytest.approx([30, 54])


@pytest.mark.parametrize(
    ("B", "angle"), [((1, 0, 0), 0), ((-1, 0, 0), math.pi), ((0, 0, 1), math.pi / 2)]
)
def test_arcs_of_0_and_180_degrees_and_arcs_seen_edge_on_are_drawn(B, angle):
    s = sketch(plane="xy")
    s.arc(O, (1, 0, 0), B, "a")
    x, y = vertices(s)[0].T
    assert abs(np.unwrap(np.arctan2(y, x))[-1]) == pytest.approx(
        angle if angle != math.pi / 2 else 0, abs=1e-9
    )


@pytest.mark.parametrize(("axis", "sign"), [((0, 0, 1), 1), ((0, 0, -1), -1), ((0, -1, 2), 1)])
def test_a_turn_about_an_axis_towards_the_eye_runs_counter_clockwise(axis, sign):
    s = sketch(plane="xy")
    s.line((-2, -2, 0), (2, 2, 0))
    s.turn(O, axis, r"$\omega$")
    first = next(v for v in vertices(s, KINDS["rate"]))
    a, b = first[0], first[1]
    assert np.sign(a[0] * b[1] - a[1] * b[0]) == sign


def test_arrows_have_lengths_in_proportion_and_dots_or_crosses_at_the_eye():
    s = sketch(plane="xy")
    s.rod(O, (10, 10, 0))
    s.vector(O, (4, 0, 0), "u")
    s.vector(O, (0, 2, 0), "w")
    s.vector(O, (0, 90, 0), "a", kind="acceleration")
    u, w = (np.hypot(*(v[1] - v[0])) for v in vertices(s, KINDS["velocity"]) if len(v) == 2)
    (a,) = (np.hypot(*(v[1] - v[0])) for v in vertices(s, KINDS["acceleration"]) if len(v) == 2)
    assert u == pytest.approx(2 * w)
    assert a == pytest.approx(u)
    for z, extra in ((1, 1), (-1, 2)):
        s = sketch(plane="xy")
        s.vector(O, (0, 0, z), "v")
        assert len(vertices(s, KINDS["velocity"])) == extra
        assert len(s.ax.patches) == 1 + extra


def test_a_dimension_line_is_parallel_to_what_it_measures_and_keeps_its_offset():
    s = sketch(plane="xy")
    s.dimension((1, 1, 0), (4, 5, 0), "b", offset=0.5)
    lines = [v for v in vertices(s, "#000000") if len(v) == 2]
    assert lines[-1] == pytest.approx(np.array([(0.6, 1.3), (3.6, 5.3)]))
    assert texts(s).keys() == {"$b$"}


def test_symbols_keep_their_size_when_the_scene_is_a_thousand_times_larger():
    def head(size):
        s = sketch(plane="xy")
        s.rod(O, (size, 0.7 * size, 0))
        s.axes(O, ground, labels="")
        png(s)
        return np.ptp(s.ax.transData.transform(s.ax.patches[-1].get_path().vertices), axis=0)

    assert head(1e3) == pytest.approx(head(1.0), rel=1e-6)


def everything(s):
    A, B, C = (0, 0, 0), (0, 1, 0), (1, 1, 0.5)
    s.axes(A, ground, length=0.4)
    for draw in (s.rod, s.shaft, s.line, s.cable, s.spring):
        draw(A, C)
    s.disk(B, ground.j, 0.3, spoke=(0, 1, 0.3))
    s.ring(B, ground.k, 0.3)
    s.cone(A, (1, 0, 0), 0.5, 0.2)
    s.gear(C, (0, 1, 1), 0.4, cone_apex=A)
    s.cylinder(A, B, 0.1)
    s.sphere(C, 0.1)
    s.plate([A, B, C])
    s.box(C, ground, (0.1, 0.2, 0.3))
    s.ground(A, normal=ground.k)
    s.ground(A, normal=(1, 0, 0), size=0.5)
    s.hinge(B)
    s.hinge(B, axis=ground.i)
    s.ball_joint(C)
    s.dot(A)
    s.turn(B, ground.k, r"$\omega$", radius=0.2)
    s.arc(A, B, C, r"$\theta$")
    s.dimension(A, B, "b")
    s.path([(0, 0, 0.1 * n) for n in range(7)], on=(A, ground.k))
    s.cable((1, 1, -1), s.pulley((1, 1, 1), ground.i, 0.3), C, (0, 2, 0))
    s.vector(C, (0, 0, -1), "$mg$", kind="force")
    s.label(A, "A")


@pytest.mark.parametrize(
    "view",
    [{}, {"plane": "xy"}, {"plane": "zx"}, {"azimuth": 0, "elevation": 0}, {"elevation": 90}, {"up": "y"}],
)  # fmt: skip
def test_every_primitive_is_drawn_from_every_side(view):
    s = sketch(**view)
    everything(s)
    assert png(s)
    assert all(np.isfinite(p.get_path().vertices).all() for p in s.ax.patches)
    assert {r"$\omega$", r"$\theta$", "$b$", "A", "$mg$", "$x$", "$y$", "$z$"} <= texts(s).keys()


def test_what_is_drawn_after_the_figure_was_shown_is_added_and_finishing_twice_adds_nothing():
    s, t = sketch(), sketch()
    everything(s)
    everything(t)
    t.finish()
    t.finish()
    assert len(s.ax.patches) == 0
    first = png(s)
    assert len(s.ax.patches) == len(t.ax.patches) > 60
    assert png(s) == first
    s = sketch()
    s.rod(O, (1, 0, 0))
    png(s)
    s.label(O, "O")
    png(s)
    assert len(s.ax.texts) == 1
    assert len(s.ax.patches) == 2


def test_a_figure_saves_as_svg_and_with_a_tight_box():
    s = sketch()
    everything(s)
    out = io.StringIO()
    s.ax.figure.savefig(out, format="svg", bbox_inches="tight")
    assert "</svg>" in out.getvalue()


@pytest.mark.parametrize("place", [O, (3, 4, 5)])
def test_a_scene_of_one_place_and_an_empty_scene_are_drawn(place):
    s = sketch()
    s.dot(place)
    assert png(s)
    assert png(sketch())


CORNERS = [(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 2, 0)]


@pytest.mark.parametrize(("draw", "words"), [
    (lambda s: s.rod(O, 3), "a place is a Point, a Vector or three numbers, got"),
    (lambda s: s.rod(O, (1, 2, "a")), "needs numbers, but the place is"),
    (lambda s: s.rod(O, np.array([1, 2, 3j])), "needs numbers, but the place is"),
    (lambda s: s.rod(O, (1, 2, math.nan)), "not finite"),
    (lambda s: s.rod(O, Frame("moon").point("M", 0, 0, 0)), "share no frame"),
    (lambda s: s.ground(O, normal=(0, 0, 0)), "points nowhere"),
    (lambda s: s.turn(O, ground.point("A", 1, 0, 0), "w"), "write B - A"),
    (lambda s: s.vector(O, ground.i, "v", kind="speed"), "kind is one of 'velocity', 'acceleration', 'rate', 'force', 'plain'; got 'speed'"),
    (lambda s: s.disk(O, ground.k, -1), "positive number of metres; got -1"),
    (lambda s: s.sphere(O, "big"), "positive number of metres; got 'big'"),
    (lambda s: s.disk(O, ground.k, 1, hole=-0.1), "positive number of metres; got -0.1"),
    (lambda s: s.cylinder(O, (0, 0, 1), 1, bore=1), "a hole is narrower than its body, 1 m"),
    (lambda s: s.plate([O, O]), "three corners or more, got 2"),
    (lambda s: s.plate(CORNERS, thickness=math.nan), "positive number of metres; got nan"),
    (lambda s: s.plate([O, (1, 0, 0), (2, 0, 0)], thickness=1), "has an area"),
    (lambda s: s.plate(CORNERS, holes=[3]), "as holes=[s.around(...)]; got [3]"),
    (lambda s: s.plate(CORNERS, holes=3), "holes are outlines"),
    (lambda s: s.plate(CORNERS, s.around(O, CORNERS[1], ground.k)), "holes are outlines"),
    (lambda s: s.around(O, (0, 0, 1), ground.k), "a circle needs a place off its axis"),
    (lambda s: s.around(O, CORNERS[1], ground.k, "pi"), "an angle is in radians, at most 1000 turns; got 'pi'"),
    (lambda s: s.around(O, CORNERS[1], ground.k, 1e308), "at most 1000 turns; got 1e"),
    (lambda s: s.spring(O, CORNERS[1], radius=0.1, coils=0), "a spring has 1 to 100 coils; got 0"),
    (lambda s: s.spring(O, CORNERS[1], radius=0.1, coils=2.5), "a spring has 1 to 100 coils; got 2.5"),
    (lambda s: s.spring(O, CORNERS[1], radius=0.1, coils=101), "a spring has 1 to 100 coils; got 101"),
    (lambda s: s.road([O]), "two places or more, got 1"),
    (lambda s: s.swing(O, (0, 0, 2), ground.k), "a circle needs a place off its axis"),
    (lambda s: s.sum(O, ground.i), "a Vector with terms"),
    (lambda s: s.arc(O, O, (1, 0, 0), "a"), "two other places"),
    (lambda s: s.axes(O, ground, labels="xy"), "three labels"),
    (lambda s: s.axes(O, ground, labels="wxyz"), "three labels"),
    (lambda s: s.axes(O, ground.k), "axes of a Frame, got"),
    (lambda s: s.path([O, O], on=-1), "a place is a Point, a Vector or three numbers"),
    (lambda s: s.cable(O), "between two places or pulleys at least; got 1"),
    (lambda s: s.cable((0.1, 0, 0), s.pulley(O, ground.k, 0.5), (2, 0, 0)), "is within the radius 0.5"),
    (lambda s: s.cable(O, (1, 0, 0), turns=[1]), "1 or -1 for each of 0 pulleys"),
    (lambda s: s.cable(*[s.pulley((3 * n, 0, 0), ground.k, 1) for n in range(11)]), "say how the cable goes round each of 11 pulleys, as in turns="),
    (lambda s: Sketch(s.ax, s.ax), "ground) is a Frame"),
    (lambda s: Sketch(ground, ground), "the Axes of plt.subplots()"),
    (lambda s: Sketch(s.ax, ground, plane="xx"), "two axes, as in plane='xz'"),
])  # fmt: skip
def test_a_mistake_is_an_error_at_once(draw, words):
    with pytest.raises(NewtonEulerError) as caught:
        draw(sketch())
    assert words in str(caught.value)
