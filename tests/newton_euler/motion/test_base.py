"""What all methods of integration share: where steps end, which step a time lies in, and when a run
that makes no progress is refused.
"""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from newton_euler.motion.methods.base import (
    MAX_STALLED_STEPS,
    STALLED_RATIO,
    LengthError,
    StepError,
    Stepper,
)
from tests.models import begun


class _Counted(Stepper):
    """Its states are the time and the number of the step."""

    most_steps = math.inf

    def interpolate(self, n, times):
        return np.array([times, n + 0 * times])


def stepper(*times, goal=10.0, x=(7.0, 8.0), **options):
    """A stepper that has taken steps to these times."""
    one = begun(_Counted, None, x, goal, times[0], **{"max_steps": 1e300} | options)
    one.step_times, one.t = list(times), times[-1]
    one.steps = [("length", t, n) for n, t in enumerate(times[:-1])]
    return one


def test_a_step_ends_at_the_next_stop_at_the_latest():
    stops = 2.0, 5.0
    ends = [stepper(t, stops=stops).next_stop() for t in (0.0, 1.9, 2.0, 5.0, 6.0)]
    assert ends == [2.0, 2.0, 5.0, 10.0, 10.0]


@pytest.mark.parametrize(("count", "numbers"), [(0, []), (4, []), (5, [3, 4]), (10, [6, 8])])
def test_two_runs_are_compared_at_two_steps_of_the_second_half(count, numbers):
    assert stepper(*range(count + 1)).checkpoints == [(n, (n, n)) for n in numbers]


def test_a_time_between_two_steps_is_in_the_later_one_and_those_outside_in_the_next():
    one = stepper(0.0, 1.0, 3.0, 4.0)
    times = -1.0, 0.0, 0.5, 1.0, 2.9, 3.0, 4.0, 5.0
    numbers = [0, 0, 0, 1, 1, 2, 2, 2]
    assert [one.step_index(t) for t in times] == numbers
    assert one.states(times).tolist() == [list(times), numbers]
    assert [one.state_at(t) for t in times] == [*zip(times, numbers, strict=True)]


# -- runs that make no progress


def gone(long, short, length, unit=1.0):
    """A stepper checked after ``long`` steps of a unit of time and again after ``short`` ones."""
    one = stepper(0.0, goal=1e6)
    for count, h in ((long, unit), (short, length * unit)):
        one.step_times += (one.t + h * np.arange(1, count + 1)).tolist()
        one.t = one.step_times[-1]
        one.check_progress()
    return one


@pytest.mark.parametrize("unit", [1.0, 0.01, 100.0])
def test_many_steps_far_shorter_than_the_longest_are_refused(unit):
    gone(MAX_STALLED_STEPS, MAX_STALLED_STEPS, 1.01 * STALLED_RATIO, unit)
    with pytest.raises(StepError, match=f"2000 steps took only {0.02 * unit:.1g} of time"):
        gone(MAX_STALLED_STEPS, MAX_STALLED_STEPS, 0.99 * STALLED_RATIO, unit)
    # the longest step may be among those looked at
    gone(1, MAX_STALLED_STEPS - 1, 0.5 * STALLED_RATIO)
    # equal steps are fine however short they are
    gone(0, MAX_STALLED_STEPS, 1e-9)


def test_progress_is_checked_every_so_many_steps_against_the_whole_motion():
    assert gone(MAX_STALLED_STEPS, MAX_STALLED_STEPS - 1, 1e-9).checked == MAX_STALLED_STEPS
    assert gone(MAX_STALLED_STEPS, MAX_STALLED_STEPS, 0.5).checked == 2 * MAX_STALLED_STEPS
    one = stepper(*range(MAX_STALLED_STEPS + 1), goal=3.0 * MAX_STALLED_STEPS, max_steps=5000)
    with pytest.raises(LengthError, match="about 6e"):
        one.check_progress()


def test_a_motion_that_needs_far_too_many_steps_is_refused_with_how_far_it_can_go():
    one = stepper(5.0, 6.0, goal=15.0, max_steps=100)
    one.check_length(10)
    with pytest.raises(LengthError) as refused:
        one.check_length(20)
    words = "about 2e+02 steps would be needed to reach t = 15; 1e+02 are possible, which is up to about"
    assert str(refused.value).startswith(f"{words} t = 1e+01")
    stepper(5.0, goal=15.0, max_steps=100).check_length(20)  # no step yet, so no forecast


@pytest.mark.parametrize(("part", "made"), [((), 3.0), ((0.25,), 3.5), ((1.0,), 2.0)])
def test_past_a_stop_each_part_of_the_way_has_its_own_rates(part, made):
    stepper = Stepper.__new__(Stepper)
    stepper.system = SimpleNamespace(rates=lambda t, x: (1.0 if t < 1.0 else 2.0,))
    stepper.t, stepper.x = 0.0, (0.0,)
    stepper.pass_stop(2.0, *part)
    assert (stepper.t, stepper.x) == (2.0, (made,))
