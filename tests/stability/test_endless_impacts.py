"""A bouncing ball comes to rest after infinitely many impacts in a finite time; a loop of runs lets
it fall through the floor.
"""

import numpy as np
import pytest

from newton_euler import Event, integrate
from tests.models import throw

G, E, HEIGHT, T = 10.0, 0.9, 5.0, 30.0
FIRST = (2 * HEIGHT / G) ** 0.5  # 1 s
REST = FIRST * (1 + E) / (1 - E)  # 19 s


BALL = throw(g=G, e=E)
bounce = lambda s, p, t: (BALL.changed(e=p.e), (0.0, -p.e * s.v))


def bounce_or_rest(s, p, t):
    """The rule for what comes next: an impact slower than 1 mm/s is the last."""
    return (BALL, (0.0, -p.e * s.v)) if s.v < -1e-3 else (BALL.changed(g=0.0), (0.0, 0.0), ())


def dropped(ball, then, **options):
    impact = Event(lambda s, p, t: s.h, -1, then=then, name="impact")
    return integrate(ball, T, (HEIGHT, 0.0), events=impact, **options)


def impact(n, e=E):
    """The instant of impact number n, from 0."""
    return FIRST * (1 + 2 * sum(e**k for k in range(1, n + 1)))


@pytest.mark.parametrize("method", ["exact", "dop853"])
def test_the_engine_finds_the_impacts_and_reports_that_they_have_no_end(method):
    motion = dropped(BALL, bounce, method=method)
    assert motion.ended.startswith("events follow each other without end: impact at t = 18.99999")
    assert "give then= a rule for what comes after" in motion.ended
    assert motion.t_end == pytest.approx(REST, abs=1e-5)
    found = np.array([e.t for e in motion.events])
    assert len(found) > 130
    assert np.max(np.abs(found[:100] - [impact(n) for n in range(100)])) < 1e-12
    assert motion.states["h"].min() > -1e-12


def test_with_a_rule_for_the_last_impact_it_lies_on_the_floor_for_the_rest_of_the_time():
    motion = dropped(BALL, bounce_or_rest)
    assert motion.ended == "reached t = 30"
    assert motion.end == {"h": 0.0, "v": 0.0}
    assert motion.events[-1].t == pytest.approx(REST, abs=2e-3 / G / (1 - E))


@pytest.mark.parametrize("e", [0.999, 1.0])
def test_beside_it_a_ball_that_loses_almost_nothing_goes_on(e):
    """Rest would come after 2000 s, or never: 15 impacts in 30 s, within 1e-12 s."""
    motion = dropped(BALL.changed(e=e), bounce)
    assert motion.ended == "reached t = 30"
    exact = [t for n in range(40) if (t := impact(n, e)) < T - 1e-9]
    assert [x.t for x in motion.events] == pytest.approx(exact, abs=1e-12)
