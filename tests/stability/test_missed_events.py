"""Events that lie close together: a solver that compares signs at the ends of its steps finds none
of two; roots of a polynomial are all at hand.
"""

import math

import numpy as np
import pytest

from newton_euler import Event, Model, cos, integrate, sin
from tests.models import throw
from tests.stability.naive import solved

G, V0 = 10.0, 10.0  # thrown upwards: 5 m high at 1 s
TOP = V0 * V0 / (2 * G)


THROUGH = lambda s, p, t: s.h - p.line
THROW = throw(g=G, line=0.0)
WAVE = Model("wave", {"k": 400.0, "line": 0.999}, ("x", "dx"), lambda s, p, t: (s.dx, -p.k * s.x))
METHODS = ("exact", "dop853", "taylor", "scipy DOP853")


def crossings(gap, method="auto"):
    """When it passes a line above which it stays for ``gap`` s; negative: a line above its top."""
    model = THROW.changed(line=TOP - math.copysign(G * gap * gap / 8, gap))
    motion = integrate(model, 3.0, (0.0, V0), method=method, events=Event(THROUGH))
    return [e.t for e in motion.events]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("gap", [0.5, 2e-2, 1e-3, 1e-5])
def test_the_engine_finds_both_down_to_1e_minus_5_s(method, gap):
    """The height is known to 1e-15 m, the instant so near the top to a few 1e-15 s over the gap."""
    assert crossings(gap, method) == pytest.approx(
        [1 - gap / 2, 1 + gap / 2], abs=1e-13 + 5e-15 / gap
    )


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("gap", [-1e-5, -1e-3, -0.5])
def test_no_event_is_found_at_a_line_that_is_just_not_reached(method, gap):
    assert crossings(gap, method) == []


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("gap", [2e-2, 1e-3, 1e-4])
def test_a_ball_that_grazes_the_ceiling_turns_there_and_one_that_stays_below_does_not(method, gap):
    """The speed at the impact is half of G gap; it comes down earlier by the gap."""

    def thrown(line):
        then = lambda s, p, t: (THROW.changed(line=p.line), (s.h, -s.v))
        ceiling = Event(THROUGH, 1, then=then, name="impact")
        return integrate(THROW.changed(line=line), 1.8, (0.0, V0), method=method, events=ceiling)

    hit, missed = (thrown(TOP + side * G * gap * gap / 8) for side in (-1, 1))
    assert [e.name for e in hit.events] == ["impact"]
    assert hit.events[0].state["v"] == pytest.approx(G * gap / 2, rel=2e-14 / gap**2 + 1e-12)
    assert hit.end["v"] == pytest.approx(V0 - G * (1.8 + gap), abs=1e-12 / gap)
    assert missed.events == ()
    assert missed.end["v"] == pytest.approx(V0 - G * 1.8, abs=1e-13)


def test_solve_ivp_loses_most_of_the_63_short_visits_to_a_crest_and_the_engine_none():
    """x = cos(20 t): above 0.999 for 4.5 ms in every 314 ms."""
    crest = lambda t, y: y[0] - 0.999
    wave = solved(WAVE, 20.0, (0.0, 20.0), rtol=1e-6, atol=1e-9, events=crest)
    around = math.acos(0.999) * np.array([-1, 1])  # of the phase pi/2 + 2 pi n
    exact = (math.pi / 2 + 2 * math.pi * np.arange(64)[:, None] + around).ravel() / 20
    exact = exact[exact < 20]
    assert len(wave.t_events[0]) < len(exact) / 2
    visits = Event(lambda s, p, t: s.x - p.line)
    ours = [e.t for e in integrate(WAVE, 20.0, (0.0, 20.0), events=visits).events]
    assert len(ours) == len(exact)
    assert np.abs(ours - exact).max() < 1e-8  # s


def test_roots_of_a_function_that_is_not_a_polynomial_of_the_states_are_found_as_well():
    beats = lambda s, p, t: sin(40 * t) * cos(3 * t + 0.1)
    found = [e.t for e in integrate(THROW, 3.0, (0.0, V0), events=Event(beats)).events]
    exact = [math.pi * n / 40 for n in range(1, 39)]
    exact += [(math.pi * (n + 0.5) - 0.1) / 3 for n in range(3)]
    assert found == pytest.approx(sorted(t for t in exact if t < 3), abs=1e-12)
