"""work_precision.py, reference.py, plots.py and the command: what is measured, against
what, and what is drawn of it.
"""

import ast
import math
import re
import subprocess
import sys
from functools import partial
from itertools import pairwise
from pathlib import Path

import matplotlib
import mpmath as mp
import pytest

from newton_euler.accuracy.catalogue import charts
from newton_euler.accuracy.command import main
from newton_euler.accuracy.measurements import work_precision as precision
from newton_euler.accuracy.measurements.comparisons import COMPARISONS
from newton_euler.accuracy.measurements.measure import Measured, timed
from newton_euler.accuracy.measurements.reference import (
    by_extrapolation,
    by_heyoka,
    reference_solution,
)
from newton_euler.accuracy.measurements.regime_maps import MAPS
from newton_euler.accuracy.measurements.work_precision import work_precision
from newton_euler.motion import ModelError
from newton_euler.motion.integration import integrate
from newton_euler.motion.methods.table import METHODS
from newton_euler.scenes import LADDERS, SCENES, scene

matplotlib.use("Agg")
ROOT = Path(__file__).parents[3]
each_scene = pytest.mark.parametrize("name", SCENES)
EXACT = [name for name in SCENES if SCENES[name].motion[0].exact]


# -- the catalogue


@each_scene
def test_every_scene_of_the_catalogue_moves_to_its_end(name):
    model, t, start = SCENES[name].motion
    motion = integrate(model, t, start, 1e-6, "dop853")
    assert motion.t_end == t
    assert motion.error <= 1e-6
    assert any(motion.end[n] != x for n, x in zip(model.states, start, strict=True))


def test_scenes_come_in_the_order_of_the_book_and_say_where_they_are():
    places = [tuple(map(int, s.section.split("."))) for s in SCENES.values()]
    assert places == sorted(places)
    assert all(s.name == name and s.description for name, s in SCENES.items())


def makers(path):
    """The functions of a file that make a model."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef):
            calls = {
                n.func.id
                for n in ast.walk(node)
                if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)
            }
            if calls & {"Model", "second_order"}:
                yield node.name


def test_no_module_of_scenes_that_makes_a_model_is_forgotten():
    """Each is called for a scene of the catalogue or a ladder; that is seen in a process of its
    own, before any of them is kept.
    """
    scenes = ROOT / "newton_euler" / "scenes"
    modules = {str(path) for path in scenes.rglob("*.py") if any(makers(path))}
    assert len(modules) > 10
    program = """if True:
        import sys
        seen = set()
        sys.setprofile(lambda frame, event, _: seen.add(frame.f_code.co_filename) if event == "call" else None)
        from newton_euler.scenes import LADDERS, SCENES, ladder
        seen.clear()
        motions = [s.motion for s in SCENES.values()], [ladder(name) for name in LADDERS]
        sys.setprofile(None)
        print(*seen, sep="\\n")
    """
    output = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout
    assert modules - set(output.splitlines()) == set()


def test_a_scene_that_does_not_exist_is_refused_with_those_that_do():
    with pytest.raises(ModelError, match=r"no scene 'topp'; there are planet, .*, top, "):
        scene("topp")


# -- the reference


@pytest.mark.parametrize("name", EXACT)
def test_references_agree_with_exact_solutions_to_28_digits(name):
    model, t, start = SCENES[name].motion
    with mp.workdps(45):
        exact = in_digits(model).solution(mp.mpf(t), [mp.mpf(x) for x in start])
        assert apart(reference_solution(model, t, start), exact) < 1e-28


QUICK_TO_EXTRAPOLATE = ("aircraft", "aircraft in space", "projectile")


@pytest.mark.parametrize(
    "name",
    [
        n if n in QUICK_TO_EXTRAPOLATE else pytest.param(n, marks=pytest.mark.slow)
        for n in SCENES
        if n not in EXACT
    ],
)
def test_references_without_exact_solution_agree_with_extrapolation_to_28_digits(name):
    pytest.importorskip("heyoka")
    motion = SCENES[name].motion
    assert apart(by_heyoka(*motion), by_extrapolation(*motion)) < 1e-28


def test_extrapolation_agrees_with_an_exact_solution_to_30_digits():
    model, _, start = SCENES["space station"].motion
    with mp.workdps(45):
        exact = in_digits(model).solution(mp.mpf(7), [mp.mpf(x) for x in start])
        assert apart(by_extrapolation(model, 7.0, start), exact) < 1e-30
        assert apart(by_extrapolation(model, 7.0, start, digits=16), exact) > 1e-30


def in_digits(model):
    """The same with its parameters as mpf."""
    return model.changed(**{n: mp.mpf(x) for n, x in model.parameters.items()})


def apart(a, b):
    """The largest difference of two states, relative to the largest of them, in all digits."""
    with mp.workdps(45):
        return float(max(abs(x - y) for x, y in zip(a, b, strict=True)) / max(map(abs, b)))


# -- what is measured


@pytest.fixture(scope="module")
def swing():
    """The pendulum by a few methods."""
    output = []
    found = work_precision(
        "pendulum",
        (1e-3, 1e-6, 1e-9),
        ("dop853", "lie-poisson4", "yoshida6", "auto"),
        longest=math.inf,  # the points shall not depend on how busy the machine is
        progress=lambda *now: output.append(now),
    )
    return found, output


def test_measured_errors_are_those_of_direct_integration(swing):
    """The end by Jacobi's elliptic functions: sin(theta/2) = k cd(w t)."""
    with mp.workdps(30):
        w, k = (
            mp.sqrt(2 * mp.mpf(10) * mp.mpf("0.5") / (mp.mpf("0.5") + 2 * mp.mpf("0.25"))),
            mp.sin(mp.mpf("0.5")),
        )
        theta = 2 * mp.asin(k * mp.ellipfun("cd", w * 10, m=k * k))
        omega = -mp.sign(mp.ellipfun("sd", w * 10, m=k * k)) * mp.sqrt(
            2 * w * w * (mp.cos(theta) - mp.cos(1))
        )
    sizes = (1.0, 2 * float(w * k))
    for p in (p for p in swing[0].points if p.method != "auto"):
        end = integrate(*SCENES["pendulum"].motion, p.asked, p.method).end
        error = max(abs(end["theta"] - theta) / sizes[0], abs(end["omega"] - omega) / sizes[1])
        assert p.error == pytest.approx(float(error), rel=0.05, abs=2e-16)
        assert p.error <= p.asked


def test_drift_is_that_of_the_invariant_at_the_steps(swing):
    model, t, start = SCENES["pendulum"].motion
    (p,) = (p for p in swing[0].points if (p.method, p.asked) == ("dop853", 1e-6))
    motion = integrate(model, t, start, 1e-6, "dop853")
    energies = [
        model.invariant("energy", state)
        for state in zip(*(x.tolist() for x in motion.states.values()), strict=True)
    ]
    assert p.drift == pytest.approx(
        max(abs(e - energies[0]) for e in energies) / max(map(abs, energies)), rel=1e-6
    )
    assert p.calls == motion.cost.calls > 100


def test_of_several_invariants_the_worst_drift_counts():
    motion = integrate(*SCENES["free body"].motion, 1e-6, "lie-poisson4")
    assert motion.drift["momentum"] < 1e-12 < 1e-10 < motion.drift["energy"]
    assert precision.worst_drift(motion) == pytest.approx(motion.drift["energy"], rel=0.1)


def test_methods_that_a_scene_cannot_use_have_no_points(swing):
    found, _ = swing
    assert [p.asked for p in found.points if p.method == "dop853"] == [1e-3, 1e-6, 1e-9]
    assert {p.method for p in found.points} == {"dop853", "yoshida6", "auto"}
    assert all(p.cost > 0 for p in found.points)


def test_progress_is_reported_and_never_goes_back(swing):
    fractions = [fraction for fraction, _ in swing[1]]
    assert all(a <= b for a, b in pairwise(fractions))
    assert 0 <= fractions[0] < fractions[-1] <= 1
    assert swing[1][0][1] == "dop853, 1e-03"


def test_the_table_has_all_numbers_and_the_ratios_of_auto(swing):
    output = swing[0].explain()
    assert output.count("yoshida6 ") >= 3
    for rtol, (ratio, best) in swing[0].ratios.items():
        assert best in ("dop853", "yoshida6")
        assert f"auto, asked for {rtol:.0e}: {ratio:.2f} times the time of {best}" in output


def test_a_method_that_takes_long_is_asked_for_no_more_digits_and_named():
    found = work_precision("sphere on an incline", (1e-3, 1e-4), ("dop853",), longest=0.0)
    assert [p.asked for p in found.points] == [1e-3]
    assert found.too_slow["dop853"].startswith("not asked for less than 1e-03, which took")


def test_a_method_that_cannot_reach_an_accuracy_has_no_point_there_and_is_named():
    found = work_precision("rolling sphere", (1e-6, 1e-7, 1e-8), ("verlet",), longest=math.inf)
    assert METHODS["verlet"].min_rtol == 1e-7
    assert [p.asked for p in found.points] == [1e-6, 1e-7]
    assert "cannot reach it, the least is 1e-07" in found.unable["verlet"]


def test_auto_is_compared_with_the_cheapest_that_reached_the_accuracy(monkeypatch):
    class Runs:
        """Runs that last so many seconds by the clock of the test."""

        now = 0.0

        def run(self, method, rtol):
            self.now += {"coarse": 1e-4, "fine": 1e-3, "slow": 4e-3, "auto": 4e-3}[method]

    runs = Runs()
    monkeypatch.setattr(precision, "timed", partial(timed, clock=lambda: runs.now))

    points = [Measured("coarse", 1e-4, 1e-2, asked=1e-6), Measured("fine", 1e-3, 1e-7, asked=1e-6), Measured("slow", 4e-3, 1e-9, asked=1e-6),
              Measured("auto", 4e-3, 1e-9, asked=1e-6), Measured("auto", 4e-3, 1e-9, asked=1e-8)]  # fmt: skip
    ((rtol, (ratio, best)),) = precision._ratios(runs, points)
    assert (rtol, best) == (1e-6, "fine")
    assert 2 < ratio < 8
    assert ratio == pytest.approx(4)


# -- the command


def run(*arguments):
    """Its exit code."""
    with pytest.raises(SystemExit) as end:
        main(arguments, prog_name="python -m newton_euler.accuracy")
    return end.value.code


def test_the_command_lists_all_charts_and_their_names_are_unique(capsys):
    assert run("--list") == 0
    output = capsys.readouterr().out
    names = list(charts())
    assert len({re.sub("[^a-z]", "", n.lower()) for n in names}) == len(names)
    assert set(names) == {
        *SCENES,
        *(f"models of {n}" for n in LADDERS),
        *COMPARISONS,
        *(f"map of {n}" for n in MAPS),
    }
    assert all(f"  {name} " in output for name in names)


def test_an_unknown_name_is_refused_with_the_list(capsys, tmp_path):
    assert run("top", "topp", "--out", str(tmp_path)) == 2
    output = capsys.readouterr()
    assert "no chart 'topp'" in output.err
    assert "models of projectile" in output.err
    assert not list(tmp_path.iterdir())


def test_with_models_only_ladders_are_known(capsys):
    assert run("pendulum of Foucault", "--models") == 2
    assert "no chart 'pendulum of Foucault'" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "file"),
    [
        ("Sphere-on-an-incline", "sphere-on-an-incline.svg"),
        ("models of projectile", "models-of-projectile.svg"),
    ],
)
def test_the_command_measures_prints_and_writes(name, file, capsys, tmp_path):
    assert run(name, "--quick", "--format", "svg", "--out", str(tmp_path / "new")) == 0
    output = capsys.readouterr()
    assert f"written: {tmp_path / 'new' / file}" in output.out
    assert "time" in output.out
    assert not output.err  # progress is for terminals
    assert (tmp_path / "new" / file).read_text().lstrip().startswith("<?xml")


def test_the_module_runs_as_a_program():
    output = subprocess.run(
        [sys.executable, "-W", "error", "-m", "newton_euler.accuracy", "--help"],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
    )
    assert "models of projectile" in output.stdout
    assert not output.stderr


@pytest.mark.parametrize("package", ["click", "rich"])
def test_without_click_or_rich_it_says_what_to_install(package):
    program = (
        f"import runpy, sys; sys.modules[{package!r}] = None; "
        "runpy.run_module('newton_euler.accuracy', run_name='__main__')"
    )
    output = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True
    )
    assert output.returncode == 1
    assert output.stderr == (
        f"python -m newton_euler.accuracy needs the package {package}: pip install "
        "'newton-euler[course]'\n"
    )


def test_a_map_is_drawn_by_the_command(tmp_path, capsys):
    assert run("map of steady precession", "--quick", "--out", str(tmp_path)) == 0
    output = capsys.readouterr().out
    assert "none: it nutates" in output
    assert (tmp_path / "map-of-steady-precession.png").stat().st_size > 10_000
