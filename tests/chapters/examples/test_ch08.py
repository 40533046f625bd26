"""The worked examples of 8.4."""

import numpy as np
import pytest

from newton_euler.bodies import MassError
from newton_euler.chapters.examples import ch08
from newton_euler.dynamics.euler import euler_moments, fixed_line_moment
from tests.kinds import close, every_kind, number, numbers, small


@every_kind
def test_example_8_4_1_three_bars_about_x(kind):
    m, l, w, a = numbers(kind, 2, "3/2", "4/5", "-1/3")
    e, unit = ch08.bars_about_x(m, l, w, a), m * l * l / 12
    assert close(e.H, (8 * unit * w, -3 * unit * w, 3 * unit * w), small(kind))
    assert close(e.M, (8 * unit * a, -3 * unit * (a + w * w), 3 * unit * (a - w * w)), small(kind))
    I, frame, ground = e.body.about(e.about), e.body.frame, e.ground
    assert close(fixed_line_moment(I, w, a, "x"), e.M, small(kind))
    with pytest.raises(MassError, match=r"\(8\.13\) hold along principal axes, but .* I_xy ="):
        euler_moments(I, frame.angular_velocity(ground), frame.angular_acceleration(ground))


@every_kind
def test_example_8_4_2_three_bars_about_their_principal_axis(kind):
    m, l, w, a = numbers(kind, 2, "3/2", "4/5", "-1/3")
    e = ch08.bars_about_principal_axis(m, l, w, a)
    axis = e.body.frame.vector(*numbers("float" if kind == "array" else kind, 2, 1, -1)).direction()
    assert close(e.H, axis * (5 * m * l * l / 12 * w), small(kind))
    assert close(e.M, axis * (5 * m * l * l / 12 * a), small(kind))


@every_kind
def test_example_8_4_3_three_bars_about_their_mass_centre_where_the_book_errs(kind):
    """With the mass 3 m in the parallel axis theorem; the book's (9, 1, 32)/36 takes m."""
    m, l, w, a = numbers(kind, 2, "3/2", "4/5", "-1/3")
    e, unit = ch08.bars_about_mass_centre(m, l, w, a), m * l * l / 12
    assert close(e.H, (3 * unit * w, unit * w, 10 * unit * w), small(kind))
    assert close(e.M, (unit * (3 * a - w * w), unit * (a + 3 * w * w), 10 * unit * a), small(kind))
    matrix = [[x * unit / 3 for x in row] for row in ((18, -9, 9), (-9, 30, 3), (9, 3, 30))]
    assert close(e.body.inertia.matrix, matrix, small(kind))
    origin, shift = e.body.about(e.body.frame)._rows()[2], (0, -l * l / 36, l * l / 36)
    wrong = [(x - m * d) * w for x, d in zip(origin, shift, strict=True)]
    assert close(wrong, [k * m * l * l / 36 * w for k in (9, 1, 32)], small(kind))
    assert np.all(abs(number(e.H.z) - number(wrong[2])) > 0.04)
