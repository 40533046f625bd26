"""What is made and dropped leaves no memory in use: frames, models, motions, and what was traced or
generated for them.
"""

import gc
import pickle
import tracemalloc
import weakref

import pytest

from newton_euler import Event, Frame, Model, integrate, moving, prepare
from newton_euler.motion import model as model_module
from newton_euler.motion import prepared as prepared_module
from newton_euler.motion.model import KEPT


@pytest.fixture(autouse=True)
def only_new_objects():
    """Older objects are not searched, which would take most of the time."""
    gc.collect()
    gc.freeze()


MB = 2**20
FEW = 5  # objects for each n: a model that stays would be hundreds
RATES = "lambda s, p, t: (s.v, -{n}.5*s.x - p.k)"
STATES = ("x", "v")


def growth(make, before, after):
    """The bytes by which memory grows while ``make(n)`` runs for n from ``before`` to ``after``."""
    tracemalloc.start()
    try:
        for n in range(before):
            make(n)
        gc.collect()
        before_bytes = tracemalloc.get_traced_memory()[0]
        for n in range(before, after):
            make(n)
        gc.collect()
        return tracemalloc.get_traced_memory()[0] - before_bytes
    finally:
        tracemalloc.stop()


def more_objects(make, before, after):
    """The same in objects for each n: quicker, for slow cases."""
    for n in range(before):
        make(n)
    gc.collect()
    first = len(gc.get_objects())
    for n in range(before, after):
        make(n)
    gc.collect()
    return (len(gc.get_objects()) - first) / (after - before)


def test_frames_that_are_dropped_are_freed():
    """10 000 of them used to hold 9 MB, in the list of their tree."""
    ground = Frame("ground")

    def make(n):
        arm = ground.rotate("arm", "z", 0.1 * n)
        if n % 20 == 0:
            arm.point("P", 1.0, 0, 0).acceleration(ground)

    assert growth(make, 100, 10_000) < MB / 4
    assert ground.tree == [ground]


def test_frames_that_refer_to_each_other_are_freed():
    """What one has computed of its motion as seen from the other keeps neither alive."""
    ground, other = Frame("ground"), None
    other = ground.rotate("other", "x", moving(0.3, rate=1.0))

    def make(n):
        arm = ground.rotate("arm", "z", moving(0.1 * n, rate=2.0))
        other.angular_velocity(arm), arm.angular_acceleration(other)

    assert growth(make, 100, 3000) < MB / 4
    assert ground.tree == [ground, other]


def test_frames_that_are_sent_are_freed():
    ground = Frame("ground")

    def make(n):
        pickle.loads(pickle.dumps(ground.rotate("arm", "z", moving(0.1 * n, rate=2.0)).i))

    assert growth(make, 100, 1000) < MB / 4
    assert ground.tree == [ground]


def run(n, method="dop853"):
    """One integration of a model of new functions, no two of which are equal."""
    model = Model(
        "new", {"k": 1.0, "law": eval(f"lambda s, p, t: {n}.25")}, STATES,
        eval(RATES.format(n=n)), {"energy": eval(f"lambda s, p, t: s.v**2 + {n}.5*s.x**2")},
    )  # fmt: skip
    event = Event(eval(f"lambda s, p, t: s.x - {n}"))
    motion = integrate(model, 0.01, (0.3, 0.0), 1e-3, method, events=event)
    assert motion.drift["energy"] < 1
    return model, motion


def test_models_of_new_lambdas_do_not_pile_up():
    """The latest stay in the caches, which are full after the first ones."""
    made = []

    def make(n):
        model, motion = run(n)
        if n % 50 == 0:
            made.extend(map(weakref.ref, (model, motion, model.rhs, model.parameters["law"])))

    assert more_objects(make, 3 * KEPT, 300) < FEW
    assert [seen() for seen in made[:-4]] == [None] * (len(made) - 4)


def test_caches_stay_within_their_bound():
    for n in range(2 * KEPT):
        run(n)
    caches = [
        model_module._BY_FUNCTION, model_module._BY_CONTENT, prepared_module._TRACED,
    ]  # fmt: skip
    assert [len(cache) <= KEPT for cache in caches] == [True] * 3


def test_functions_that_read_unknown_things_are_not_kept():
    """They are traced afresh each time, so an entry for each would be of no use."""
    constants = [9.81]
    before = len(model_module._BY_FUNCTION)
    for _ in range(KEPT // 2):
        model = Model("fall", {}, STATES, lambda s, p, t: (s.v, -constants[0]))
        integrate(model, 0.01, (0.0, 0.0), 1e-3)
    assert len(model_module._BY_FUNCTION) <= before


def test_changed_models_share_what_was_traced():
    """A slider makes a model for each of its positions."""
    model = Model("pendulum", {"k": 1.0}, STATES, eval(RATES.format(n=0)))

    def make(n):
        integrate(model.changed(k=1.0 + n), 0.01, (0.3, 0.0), 1e-3, "dop853")

    assert more_objects(make, 10, 300) < FEW


def test_prepared_runs_that_are_dropped_are_freed():
    def make(n):
        prepare(Model("new", {"k": 1.0}, STATES, eval(RATES.format(n=n))), 1e-3, "dop853")(
            0.01, (0.3, 0.0)
        )

    assert more_objects(make, 3 * KEPT, 300) < FEW
