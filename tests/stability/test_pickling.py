"""What the engine makes can be pickled and copied, so that other processes can compute with it: bit
for bit as here, even with lambdas, and what comes back fits what is here.
"""

import copy
import gc
import math
import multiprocessing
import pickle
import subprocess
import sys

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import (
    Body,
    Couple,
    Dimension,
    Event,
    Force,
    ForceSystem,
    Frame,
    Model,
    NewtonEulerError,
    compiled,
    cylindrical,
    equations_of_motion,
    frenet,
    integrate,
    kinetic_energy,
    moving,
    polar,
    prepare,
    sin,
    smallest,
    spherical,
    unit,
    where,
)
from newton_euler.dynamics import angular_momentum
from newton_euler.kinematics import curvilinear
from newton_euler.motion import METHODS, Neglected
from newton_euler.motion.prepared import prepared_model
from newton_euler.scenes import LADDERS, SCENES, Ladder, Rung, ladder, scene


def sent(x):
    """As received by another process, which knows no frame of this one."""
    return pickle.loads(pickle.dumps(x))


WAYS = pytest.mark.parametrize("again", [sent, copy.deepcopy, copy.copy], ids=lambda f: f.__name__)
PENDULUM = {"g": 9.81, "l": lambda s, p, t: 1.0 + 0 * t}


def by_lambdas(G=0.25):
    """A model of functions that no other process can find by name."""
    exact = lambda s, p, t: (s.x + s.v * t - (G + p.k) * t * t / 2, s.v - (G + p.k) * t)
    return Model(
        "of lambdas",
        {"k": 2.0, "law": lambda s, p, t: p.k + 0 * s.x},
        ("x", "v"),
        lambda s, p, t: (s.v, -p.law - G),
        {"energy": lambda s, p, t: s.v**2 / 2 + (p.k + G) * s.x},
        exact,
        (Neglected("the air", lambda s, p, t: abs(s.v) * t, "position, m"),),
    )


# -- models


@WAYS
@pytest.mark.parametrize("name", SCENES)
def test_scenes_can_be_sent(name, again):
    model, _, start = scene(name).motion
    there = again(model)
    assert there.derivative(start) == model.derivative(start)
    # the same object, as long as it is in the cache
    assert prepared_model(there).traced.rhs.source == prepared_model(model).traced.rhs.source
    for n in model.invariants:
        assert there.invariant(n, start) == model.invariant(n, start)
    if model.exact:
        assert there.solution(0.5, start) == model.solution(0.5, start)
    assert repr(there) == repr(model)
    with pytest.raises(TypeError):
        there.parameters["m"] = 1.0


@pytest.mark.parametrize("name", LADDERS)
def test_ladders_and_choices_can_be_sent(name):
    models = ladder(name)
    there = sent(models)
    times = 0.1 * models.t
    for rung, other in zip(models.rungs, there.rungs, strict=True):
        assert other.bound(times) == rung.bound(times)
        assert other.model.derivative(other.start) == rung.model.derivative(rung.start)
    choice = smallest(ladder("projectile"), 2.0)
    assert str(sent(choice)) == str(copy.deepcopy(choice)) == str(choice)


@WAYS
def test_a_ladder_of_lambdas_can_be_sent_after_it_was_measured(again):
    rates = {"slow": lambda s, p, t: (s.v, -9.0), "full": lambda s, p, t: (s.v, -10.0)}
    rungs = [
        Rung(Model(name, {}, ("h", "v"), f), (0.0, 0.0), lambda s, p, t: (s.h,))
        for name, f in rates.items()
    ]
    measured = Ladder("fall", "height, m", 2.0, tuple(rungs))
    error = measured.error(rungs[0])
    there = again(measured)
    assert there.error(there.rungs[0]) == error


@WAYS
def test_lambdas_can_be_sent_as_what_they_compute(again):
    model = by_lambdas()
    there, start = again(model), (0.3, -0.7)
    assert there.derivative(start, 0.5) == model.derivative(start, 0.5)
    assert there.solution(1.5, start) == model.solution(1.5, start)
    assert there.invariant("energy", start) == model.invariant("energy", start)
    assert [*there.neglected(2.0, start).values()] == [1.4]
    assert there.changed(k=3.0).derivative(start) == model.changed(k=3.0).derivative(start)
    for method in ("exact", "dop853", "scipy DOP853"):
        ends = [integrate(m, 3.0, start, 1e-9, method).end for m in (model, there)]
        assert ends[0] == ends[1]


def test_what_was_sent_is_a_formula_over_every_kind_of_number():
    model = Model("pendulum", PENDULUM, ("x", "v"), lambda s, p, t: (s.v, -p.g / p.l * sin(s.x)))
    there = sent(model)
    x, v = sympy.symbols("x v")
    assert sympy.simplify(there.derivative((x, v))[1] - model.derivative((x, v))[1]) == 0
    with mpmath.workdps(40):
        third = mpmath.mpf(1) / 3
        assert there.derivative((third, 0)) == model.derivative((third, 0))
    columns = np.linspace(0.0, 1.0, 5), np.ones(5)
    assert np.array_equal(there.derivative(columns)[1], model.derivative(columns)[1])


def test_a_pickle_has_what_functions_read_when_it_was_made():
    space = {"G": 9.81}
    exec("rhs = lambda s, p, t: (s.v, -G)", space)
    there = sent(model := Model("fall", {}, ("h", "v"), space["rhs"]))
    space["G"] = 1.62
    assert there.derivative((0.0, 0.0)) == (0.0, -9.81)
    assert copy.deepcopy(model).derivative((0.0, 0.0)) == (0.0, -1.62)


def test_a_scripts_own_functions_are_sent_as_steps():
    """They cannot be found by name: __main__ of another process is a different module."""
    code = (
        "import pickle, sys\nfrom newton_euler import Model\nG = 9.81\n"
        "def rhs(s, p, t): return s.v, -G\n"
        "sys.stdout.buffer.write(pickle.dumps(Model('fall', {}, ('h', 'v'), rhs)))"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout
    assert pickle.loads(out).derivative((0.0, 0.0)) == (0.0, -9.81)


def test_events_can_be_sent():
    G = 2.0
    event = Event(lambda s, p, t: s.h - G, direction=-1, terminal=True, name="low")
    there = sent(event)
    assert (there.direction, there.terminal, there.name, there.then) == (-1, True, "low", None)
    model = Model("fall", {}, ("h", "v"), lambda s, p, t: (s.v, -9.81))
    ends = [integrate(model, 5.0, (3.0, 0.0), events=e).t_end for e in (event, there)]
    assert ends[0] == ends[1]


def test_a_lambda_that_branches_is_refused_as_python_does():
    event = Event(lambda s, p, t: 1.0 if s.h > 0 else -1.0)
    with pytest.raises((AttributeError, pickle.PicklingError), match=r"[Cc]an't pickle|lambda"):
        pickle.dumps(event)
    assert copy.deepcopy(event).function is event.function


# -- motions


def differences(motion, there):
    """What differs, or the states between the samples that differ."""
    facts = "end", "events", "drift", "error", "cost", "method"
    differing = [name for name in facts if getattr(there, name) != getattr(motion, name)]
    if str(there) != str(motion):
        differing.append("text")
    times = np.linspace(motion.segments[0].t0, motion.t_end, 29)
    between, between_there = motion.at(times), there.at(times)
    pairs = {"times": (motion.times, there.times)}
    pairs |= {name: (x, there.states[name]) for name, x in motion.states.items()}
    pairs |= {f"{name} between": (x, between_there[name]) for name, x in between.items()}
    return differing + [
        name for name, (x, y) in pairs.items() if not np.array_equal(x, y, equal_nan=True)
    ]


@pytest.mark.parametrize("again", [sent, copy.deepcopy], ids=lambda f: f.__name__)
@pytest.mark.parametrize("method", METHODS)
def test_motions_of_every_method_can_be_sent(method, again):
    model = Model(
        "oscillator", {"k": 4.0}, ("x", "v"), lambda s, p, t: (s.v, -p.k * s.x),
        {"energy": lambda s, p, t: (s.v**2 + p.k * s.x**2) / 2},
    )  # fmt: skip
    start = (1.0, 0.3)
    if method.startswith("lie-poisson") or method == "exact":
        model, _, start = scene("free body, calm").motion
    motion = integrate(model, 1.5, start, 1e-4, method)
    there = again(motion)
    assert there.method is motion.method
    assert differences(motion, there) == []
    assert differences(motion, again(there)) == []


@pytest.mark.parametrize("method", ["dop853", "taylor", "scipy RK45"])
def test_motions_with_events_can_be_sent(method):
    ball = Model("ball", {"g": 9.81}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    back = lambda s, p, t: (ball, (0.0, -0.7 * s.v))
    bounce = Event(lambda s, p, t: s.h, -1, then=back, name="bounce")
    motion = integrate(ball, 2.0, (1.0, 0.0), 1e-7, method, events=bounce)
    assert len(motion.segments) > 2
    assert differences(motion, sent(motion)) == []


def test_a_motion_that_was_sent_belongs_to_what_its_functions_read_then():
    space = {"G": 9.81}
    exec("rhs = lambda s, p, t: (s.v, -G)\nenergy = lambda s, p, t: s.v**2/2 + G*s.h", space)
    model = Model("fall", {}, ("h", "v"), space["rhs"], {"energy": space["energy"]})
    motion = integrate(model, 1.0, (0.0, 1.0), 1e-9, "dop853")
    space["G"] = 1.62
    assert differences(motion, sent(motion)) == []
    assert sent(motion).drift["energy"] < 1e-9


def test_many_motions_can_be_sent():
    starts = np.linspace(0.5, 1.5, 4)
    motions = integrate(by_lambdas(), 1.0, (starts, 0.0), 1e-6, "dop853")
    for there in (sent(motions), copy.deepcopy(motions)):
        assert np.array_equal(there.states["x"], motions.states["x"])
        assert there.method is motions.method


@WAYS
@pytest.mark.parametrize("method", ["exact", "dop853", "taylor"])
def test_prepared_runs_can_be_sent(method, again):
    run = prepare(by_lambdas(), 1e-8, method)
    assert again(run)(2.0, (0.3, 0.1)) == run(2.0, (0.3, 0.1))


# -- other processes


def test_other_processes_integrate_as_this_one():
    """Fresh interpreters, which know nothing of this one; models of scenes, and one of lambdas."""
    runs = [(*scene(n).motion, 1e-8, "auto") for n in ("free body", "planet", "rolling sphere")]
    runs += [(*scene(n).motion, 1e-8, "dop853") for n in ("pendulum", "top")]
    runs += [(by_lambdas(), 2.0, (0.3, 0.1), 1e-8, method) for method in ("auto", "dop853")]
    if METHODS["taylor"].unusable_because(None) is None:
        runs += [(by_lambdas(), 2.0, (0.3, 0.1), 1e-8, "taylor")]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        motions = pool.starmap(integrate, runs, chunksize=2)
    for run, motion in zip(runs, motions, strict=True):
        here = integrate(*run)
        assert motion.end == here.end
        assert motion.method is here.method
        times = np.linspace(0.0, run[1], 7)
        for name, x in here.at(times).items():
            assert np.array_equal(motion.at(times)[name], x)


def test_a_vector_that_comes_back_fits_those_here():
    """Frames of another process are those of this one, if they come from here."""
    ground = Frame("ground")
    arm = ground.rotate("arm", "z", moving(0.3, rate=2.0, acceleration=0.5))
    points = [arm.point("P", moving(1.0, rate=0.1 * n), 0, 0.2) for n in range(3)]
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        there = pool.starmap(type(points[0]).acceleration, [(P, ground) for P in points])
    for P, a in zip(points, there, strict=True):
        assert a.frame is arm
        assert a == P.acceleration(ground)
        assert (a - P.acceleration(ground)).norm() == 0
        assert str(a.explain()) == str(P.acceleration(ground).explain())


# -- frames, points, vectors


def things():
    """Results of many kinds, each with a function that returns what must stay the same."""
    ground = Frame("ground")
    arm = ground.rotate("arm", "z", moving(0.3, rate=2.0, acceleration=0.5))
    body = arm.rotate("body", (0, 0.6, 0.8), moving(0.1, 1.0), origin=arm.point("O", 1.0, 0, 0))
    P = body.point("P", moving(1.0, rate=3.0), 0, 0.5)
    whole = Body("b", 2.0, body, (0.1, 0.2, 0.25))
    seen = lambda v: (v.components(), v.frame.name, *map(str, v.terms.values()))
    described = lambda v: (*seen(v), v.rate(v.frame._above[-1]).components(), str(v.explain()))
    text = lambda x: (str(x), repr(x))
    force = Force(ground.vector(0, 3.0, 0), ground.point("A", 2.0, 0, 0))
    parabolic = lambda u, v, w: ((u * u - v * v) / 2, u * v, w)
    q = moving(1.0, rate=0.5), moving(0.5, rate=0.2), moving(0.0, rate=1.0)
    return {
        "frame": (body, lambda f: (f.rotation(f._above[-1]), repr(f), len(f._above))),
        "point": (P, lambda x: described(x.velocity(x.frame._above[-1]))),
        "vector": (ground.vector(1.0, 2.0, 0), seen),
        "vector at rest": (
            ground.vector(1.0, 2.0, 0),
            lambda v: v.rate(v.frame).rate(v.frame).rate(v.frame).rate(v.frame).components(),
        ),
        "velocity": (P.velocity(ground), described),
        "acceleration": (P.acceleration(ground), seen),
        "angular velocity": (body.angular_velocity(ground), described),
        "angular acceleration": (body.angular_acceleration(ground), seen),
        "array": (ground.vector(np.arange(3.0), 1.0, 0), lambda v: v.to_array().tolist()),
        "symbols": (arm.vector(sympy.Symbol("x"), 1, 0), seen),
        "explanation": (P.acceleration(ground).explain("m/s^2"), text),
        "polar": (polar(ground, "B", q[0], q[1]), lambda x: described(x.velocity(x.ground))),
        "cylindrical": (cylindrical(ground, "B", *q), lambda x: described(x.velocity(x.ground))),
        "spherical": (spherical(ground, "B", *q), lambda x: seen(x.acceleration(x.ground))),
        "coordinates": (
            curvilinear(ground, "B", parabolic, *q), lambda x: seen(x.acceleration(x.ground))
        ),
        "frenet": (
            frenet(P.velocity(ground), P.acceleration(ground)), lambda x: (x.speed, x.flexure)
        ),
        "moving": (moving(1.0, rate=2.0), text),
        "dimension": (Dimension(1, 2, -1), text),
        "unit": (unit("km/h"), text),
        "body": (whole, lambda b: (repr(b), b.mass, seen(b.momentum(b.frame._above[-1])))),
        "inertia": (whole.about(body), lambda I: (I.moments, I.products)),
        "energy": (kinetic_energy(whole, ground), lambda T: (T.value, T.terms, T.explain())),
        "momentum": (angular_momentum(whole, ground), lambda H: seen(H)),
        "force": (force, lambda f: (str(f), f.moment(f.point.frame).components())),
        "couple": (Couple(ground.vector(0, 0, 1.0)), str),
        "system": (ForceSystem([force, force]), lambda s: (str(s), seen(s.force))),
        "equations": (
            equations_of_motion(whole, {"F": (force.vector, force.point)}, ground),
            lambda e: {n: str(x) for n, x in e.items()},
        ),
    }  # fmt: skip


@WAYS
@pytest.mark.parametrize("name", things())
def test_results_can_be_sent(name, again):
    thing, described = things()[name]
    assert described(again(thing)) == described(thing)
    assert described(again(again(thing))) == described(thing)


def test_a_process_that_does_not_know_the_frames_builds_them():
    """From its own tokens, which this process has forgotten."""
    made = ((name, things()[name]) for name in things())
    rows = [(name, f, f(thing), pickle.dumps(thing)) for name, (thing, f) in made]
    gc.collect()
    for name, described, expected, data in rows:
        assert described(pickle.loads(data)) == expected, name


def test_a_copy_of_a_frame_is_the_frame():
    """A copied vector can be added to the one it was copied from, and is equal to it."""
    ground = Frame("ground")
    v = ground.rotate("arm", "z", 0.3).vector(1.0, 2.0, 0)
    assert copy.deepcopy(v) == v == sent(v)
    assert copy.deepcopy(ground) is ground
    assert len(ground.tree) == 2


def test_an_error_on_demand_stays_one():
    ground = Frame("ground")
    v = sent(ground.point("P", moving(1.0, rate=2.0, acceleration=3.0), 0, 0).acceleration(ground))
    with pytest.raises(NewtonEulerError, match="the third time derivative of a moving quantity"):
        v.rate(ground)


# -- compiled formulas


@WAYS
@pytest.mark.parametrize("formula", [
    lambda x, y=2.0: sin(x) * y + x / 3,
    lambda x, y=2.0: {"a": x, "b": (x * y, where(x < y, x, y))},
    lambda x, y=2.0: Frame("g").vector(x, y, 0),
    lambda x, y=2.0: moving(x, rate=y) ** 2,
    lambda x, y=2.0: x * mpmath.mpf("0.1") + math.inf * y,
], ids=["scalar", "dict", "vector", "moving", "mpf"])  # fmt: skip
def test_compiled_formulas_can_be_sent(formula, again):
    f = compiled(formula)
    there = again(f)
    assert there.source == f.source
    for x in (0.3, 2.5, mpmath.mpf("0.7")):
        assert repr(there(x)) == repr(f(x))
        assert repr(there(x, y=0.1)) == repr(f(x, y=0.1))
    assert repr(there(np.array([0.3, 0.4]))) == repr(f(np.array([0.3, 0.4])))
    assert there.dependencies == f.dependencies
