"""work_precision.py: what is measured for each method, and against what."""

import math
from functools import partial
from itertools import pairwise

import mpmath as mp
import pytest

from newton_euler.accuracy import Measured, timed
from newton_euler.accuracy.measurements import work_precision as precision
from newton_euler.accuracy.measurements.work_precision import work_precision
from newton_euler.motion import METHODS, integrate
from newton_euler.scenes import SCENES
from tests.honesty import closed_forms


@pytest.fixture(scope="module")
def swing():
    """The pendulum by a few methods."""
    output, methods = [], ("dop853", "lie-poisson4", "yoshida6", "auto")
    # the points must not depend on how busy the machine is
    options = {"longest": math.inf, "progress": lambda *now: output.append(now)}
    return work_precision("pendulum", (1e-3, 1e-6, 1e-9), methods, **options), output


def test_errors_and_drifts_are_those_of_direct_integration(swing):
    with mp.workdps(30):
        theta, omega = closed_forms.pendulum(mp, *map(mp.mpf, (10, 1, 0, 10)))
    sizes = 1.0, 2 * math.sqrt(10) * math.sin(0.5)
    for p in (p for p in swing[0].points if p.method != "auto"):
        end = integrate(*SCENES["pendulum"].motion, p.asked, p.method).end
        error = max(abs(end["theta"] - theta) / sizes[0], abs(end["omega"] - omega) / sizes[1])
        assert p.error == pytest.approx(float(error), rel=0.05, abs=2e-16)
        assert p.error <= p.asked
    model, t, start = SCENES["pendulum"].motion
    (p,) = (p for p in swing[0].points if (p.method, p.asked) == ("dop853", 1e-6))
    motion = integrate(model, t, start, 1e-6, "dop853")
    states = zip(*(x.tolist() for x in motion.states.values()), strict=True)
    energies = [model.invariant("energy", state) for state in states]
    off = max(abs(e - energies[0]) for e in energies) / max(map(abs, energies))
    assert p.drift == pytest.approx(off, rel=1e-6)
    assert p.calls == motion.cost.calls > 100
    motion = integrate(*SCENES["free body"].motion, 1e-6, "lie-poisson4")
    assert motion.drift["momentum"] < 1e-12 < 1e-10 < motion.drift["energy"]
    assert precision.worst_drift(motion) == pytest.approx(motion.drift["energy"], rel=0.1)


def test_methods_that_a_scene_cannot_use_have_no_points_and_progress_never_goes_back(swing):
    found, _ = swing
    assert [p.asked for p in found.points if p.method == "dop853"] == [1e-3, 1e-6, 1e-9]
    assert {p.method for p in found.points} == {"dop853", "yoshida6", "auto"}
    assert all(p.cost > 0 for p in found.points)
    fractions = [fraction for fraction, _ in swing[1]]
    assert all(a <= b for a, b in pairwise(fractions))
    assert 0 <= fractions[0] < fractions[-1] <= 1
    assert swing[1][0][1] == "dop853, 1e-03"


def test_the_table_has_all_numbers_and_ratios_of_auto_where_it_steps(swing):
    output = swing[0].explain()
    assert output.count("yoshida6 ") >= 3
    assert swing[0].ratios == {}
    assert "auto takes the exact solution" in output
    found = work_precision("top", (1e-3,), ("dop853", "auto"), longest=math.inf)
    ((rtol, (ratio, best)),) = found.ratios.items()
    assert best == "dop853"
    assert f"auto, asked for {rtol:.0e}: {ratio:.2f} times the time of {best}" in found.explain()
    assert "exact solution" not in found.explain()


def test_a_method_that_is_slow_or_cannot_reach_an_accuracy_has_no_point_there_and_is_named():
    found = work_precision("sphere on an incline", (1e-3, 1e-4), ("dop853",), longest=0.0)
    assert [p.asked for p in found.points] == [1e-3]
    assert found.too_slow["dop853"].startswith("not asked for less than 1e-03, which took")
    found = work_precision("rolling sphere", (1e-6, 1e-7, 1e-8), ("verlet",), longest=math.inf)
    assert METHODS["verlet"].min_rtol == 1e-7
    assert [p.asked for p in found.points] == [1e-6, 1e-7]
    assert "cannot reach it, the least is 1e-07" in found.unable["verlet"]


def test_auto_is_compared_with_the_cheapest_that_reached_the_accuracy(monkeypatch):
    class Runs:
        """Runs that last a given number of seconds by the clock of the test."""

        now = 0.0

        def run(self, method, rtol):
            self.now += {"coarse": 1e-4, "fine": 1e-3, "slow": 4e-3, "auto": 4e-3}[method]

    runs = Runs()
    monkeypatch.setattr(precision, "timed", partial(timed, clock=lambda: runs.now))

    measured = ("coarse", 1e-4, 1e-2), ("fine", 1e-3, 1e-7), ("slow", 4e-3, 1e-9), ("auto", 4e-3, 1e-9)  # fmt: skip
    points = [Measured(*point, asked=1e-6) for point in measured]
    points += [Measured("auto", 4e-3, 1e-9, asked=1e-8)]
    ((rtol, (ratio, best)),) = precision._ratios(runs, points)
    assert (rtol, best) == (1e-6, "fine")
    assert ratio == pytest.approx(4)
