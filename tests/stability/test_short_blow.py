"""A short blow: between two steps no method sees it, and no estimate of the error can; an event at
its instants ends a step there.
"""

import math

import pytest

from newton_euler import Event, Model, exp, integrate

BEGINS, LASTS, FORCE = 5.0, 0.01, 100.0  # s, s, N on 1 kg: it changes the speed by 1 m/s


pushed = lambda s, p, t: (s.v, p.F)
blow = lambda s, p, t: (s.v, p.F * exp(-(((t - p.t0) / p.width) ** 2)))
STEPS = {"F": 0.0, "blow": FORCE, "t0": BEGINS, "t1": BEGINS + LASTS}
BODY = Model("body", STEPS, ("x", "v"), pushed)
SMOOTH = Model(
    "struck", {"F": FORCE / math.sqrt(math.pi), "t0": BEGINS, "width": LASTS}, ("x", "v"), blow
)


@pytest.mark.parametrize("method", ["auto", "dop853", "taylor", "scipy DOP853"])
def test_the_methods_of_the_engine_look_where_a_force_changes_in_time(method):
    """Neither a tolerance nor a second run helps, but looking at the force beforehand does."""
    motion = integrate(SMOOTH, 10.0, (0.0, 1.0), method=method)
    assert abs(motion.end["v"] - 2.0) <= 2 * motion.error <= 2e-9


@pytest.mark.parametrize("method", ["auto", "dop853", "taylor", "scipy DOP853", "scipy RK45"])
@pytest.mark.parametrize("lasts", [1e-1, 1e-2, 1e-4, 1e-6])
def test_given_as_events_it_is_met_and_the_motion_is_right_to_1e_minus_12(method, lasts):
    body = BODY.changed(blow=1.0 / lasts, t1=BEGINS + lasts)
    struck = lambda s, p, t: (body.changed(F=p.blow), (s.x, s.v), (over,))
    begins = Event(lambda s, p, t: t - p.t0, then=struck, name="blow")
    over = Event(lambda s, p, t: t - p.t1, then=lambda s, p, t: (body, (s.x, s.v)), name="over")
    motion = integrate(body, 10.0, (0.0, 1.0), method=method, events=begins)
    assert [e.name for e in motion.events] == ["blow", "over"]
    assert motion.end["v"] == pytest.approx(2.0, abs=1e-15 / lasts + 1e-12)
    assert motion.end["x"] == pytest.approx(5.0 + 2 * 5.0 - lasts / 2, abs=1e-11 + 1e-14 / lasts)


def test_a_smooth_blow_is_seen_when_a_step_ends_before_it():
    """The same model from 4.95 s on: steps begin short, and grow only while nothing happens."""
    before = integrate(SMOOTH, BEGINS - 5 * LASTS, (0.0, 1.0), method="dop853")
    motion = integrate(SMOOTH, (BEGINS - 5 * LASTS, 10.0), before.end, 1e-9, "dop853")
    assert motion.end["v"] == pytest.approx(2.0, abs=1e-8)
