"""A valid call of every public name: recorded from the examples in docstrings while they run, or
written here where there is no example.
"""

import contextlib
import doctest
import inspect
import io
import sys
import tempfile
from importlib import import_module
from pkgutil import walk_packages

from matplotlib.figure import Figure

import newton_euler as ne
from newton_euler.answers.forms import Form
from newton_euler.classroom import predict_again, tally, try_problem


def valid_calls(functions):
    """{name: (positional, named)} of the first call of each function in the examples."""
    wanted = {}
    for name, f in functions.items():
        code = code_of(f)
        if code is not None:
            wanted.setdefault(code, []).append(name)
    calls = {}

    def note(frame, event, _):
        if event == "call" and frame.f_code in wanted:
            names = wanted.pop(frame.f_code)
            call = arguments(frame)
            calls.update((name, call) for name in names)

    for module in walk_packages(ne.__path__, "newton_euler."):
        if "chapters" in module.name or module.name.endswith("__main__"):
            continue
        for test in doctest.DocTestFinder().find(import_module(module.name)):
            runner = doctest.DocTestRunner(verbose=False)
            with contextlib.redirect_stdout(io.StringIO()):
                sys.setprofile(note)
                try:
                    runner.run(test, out=lambda _: None, clear_globs=False)
                finally:
                    sys.setprofile(None)
    sys.setprofile(note)
    try:
        more_examples()
    finally:
        sys.setprofile(None)
    return calls


def code_of(f):
    """The code that runs when a function or a class is called; None for one without."""
    f = f.__init__ if inspect.isclass(f) else f
    return getattr(inspect.unwrap(f), "__code__", None)


def arguments(frame):
    """(positional, named) with which a function was called, from its frame."""
    code, values = frame.f_code, frame.f_locals
    names = code.co_varnames
    count = code.co_argcount
    positional = [values[n] for n in names[:count]]
    named = {n: values[n] for n in names[count : count + code.co_kwonlyargcount]}
    rest = count + code.co_kwonlyargcount
    if code.co_flags & inspect.CO_VARARGS:
        positional += values[names[rest]]
        rest += 1
    if code.co_flags & inspect.CO_VARKEYWORDS:
        named |= values[names[rest]]
    return positional, named


def more_examples():
    """Calls of names that no docstring calls."""
    ground = ne.Frame("ground")
    body = ground.rotate("body", "z", angle=0.3, rate=2.0)
    places = body.point("C", 0.1, 0.2, 0.3), body.point("D", 1.0, 0.0, 0.5)
    solids(body, *places)
    of_a_wheel(ground, body, *places)
    scalars_and_vectors(ground)
    forces_and_motions(ground, *places)
    drawings(ground, body, *places)
    Form.read("number, m").error("got nothing")
    try_problem("4/16", "no folder")
    tally()
    predict_again()


def solids(body, C, D):
    round_, angled, two = {"centre": body}, {"half_angle": 0.6, "middle": body}, {"inner": 0.1}
    two |= {"outer": 0.2}
    for shape, lengths in {
        "annulus": two | round_, "arc": {"radius": 0.2} | angled,
        "box": {"a": 0.1, "b": 0.2, "c": 0.3} | round_, "cone": {"radius": 0.1, "height": 0.3, "apex": body},
        "cylindrical_shell": {"radius": 0.1, "length": 0.2} | round_,
        "ellipsoid": {"a": 0.1, "b": 0.2, "c": 0.3} | round_, "half_disk": {"radius": 0.1, "middle": body},
        "half_ring": {"radius": 0.1, "middle": body}, "hemisphere": {"radius": 0.1, "middle": body},
        "plate": {"b": 0.1, "c": 0.2} | round_, "ring": {"radius": 0.1} | round_,
        "sector": {"radius": 0.2} | angled, "spherical_shell": {"radius": 0.1} | round_,
        "tube": two | {"length": 0.4} | round_, "wedge": {"radius": 0.2, "length": 0.3} | angled,
        "rod": {"length": 0.3} | round_, "cylinder": {"radius": 0.1, "length": 0.3} | round_,
        "disk": {"radius": 0.1} | round_, "sphere": {"radius": 0.1} | round_,
    }.items():  # fmt: skip
        getattr(ne.bodies, shape)(**lengths, mass=2.0)
    ne.bodies.simplex(C, D, mass=2.0, name="rod")


def of_a_wheel(ground, body, C, D):
    wheel = ne.Body("wheel", 2.0, body, (0.1, 0.08, 0.05))
    wheel.check()
    wheel.momentum(ground)
    I = wheel.about(C)
    I.to_array()
    I.expressed_in(body.rotate("tilted", "x", 0.2))
    I + I
    I - ne.Body("hole", 0.1, body, (0.001, 0.0008, 0.0005)).about(C)
    sum([I, I])
    I.reweighted(own=2.0)
    I.without("own")
    I.principal().frame("principal")

    T = ne.dynamics.kinetic_energy(wheel, ground)
    T.explain()
    T.without("rotation")


def scalars_and_vectors(ground):
    length = ne.algebra.Dimension(0, 1, 0)
    -length, abs(length), 1 / length, length.function("sqrt"), 2.0 ** ne.algebra.Dimension()
    form = ne.algebra.LinearForm(2.0, (1, 3.0))
    form / 2.0, 1.0 - form
    for refused in (
        lambda: 1 / form, lambda: form.function("sin"), lambda: form**2, lambda: 2.0**form,
        lambda: 1.0 / ground.i, lambda: abs(form), lambda: form == 1.0, lambda: ne.algebra.Moving(2.0) == 1.0,
    ):  # fmt: skip
        with contextlib.suppress(ne.algebra.ScalarError, ne.algebra.FrameError):
            refused()
    x = ne.algebra.Moving(2.0, 3.0)
    1 / x, 2.0**x, 1.0 - x, abs(x)
    data = ne.algebra.table([0.0, 1.0], [2.0, 3.0])
    data == data.derivative(), data.key()
    v = ground.vector(1.0, 2.0, 2.0)
    v[0], abs(v), v.latex(), sum([v, v]), v.direction()
    arm = ground.rotate("arm", "z", rate=2.0)
    arm.point("P", ne.moving(1.0, rate=3.0), 0, 0).acceleration(ground).without("coriolis")


def forces_and_motions(ground, C, D):
    v = ground.vector(1.0, 2.0, 2.0)
    load = ne.Force(v, C, "load")
    system = ne.ForceSystem([load])
    system + ne.ForceSystem([ne.Force(v, D, "other")])
    system.at(C)
    system.equivalent(system)
    fall = ne.Model("fall", {"g": 9.81}, ("h", "v"), lambda s, p, t: (s.v, -p.g),
                 {"energy": lambda s, p, t: s.v**2 / 2 + p.g * s.h})  # fmt: skip
    fall.invariant("energy", (1.0, 2.0))
    ne.integrate(fall, 0.1, (1.0, 0.0), 1e-6).explain()
    ladder = ne.scenes.ladder("projectile")
    ladder.rung(ladder.rungs[0].name)
    balance = ne.dynamics.audit(lambda t: 0.5 * (9.81 * t) ** 2, 0.0, 1.0, {},
                             {"weight": lambda t: 9.81**2 * t})  # fmt: skip
    balance.heat()


def drawings(ground, body, C, D):
    s = ne.drawing.Sketch(Figure().add_subplot(), ground, plane="xz")
    s.axes(C, body)
    s.turn(C, body.k, "omega")
    s.ground(C, ground.k)
    s.hinge(C)
    s.ball_joint(C)
    s.dot(C)
    s.arc(C, ground.i, ground.k, "a")
    s.dimension(C, D, "b")
    s.path([C, D])
    for name in ("shaft", "line", "spring", "damper", "arrow"):
        getattr(s, name)(C, D)
    s.swing(D, C, ground.j)
    s.road([C, D])
    s.hemisphere(C, ground.k, 0.2)
    s.disk(C, ground.j, 0.2)
    s.ring(C, ground.j, 0.2)
    s.cone(C, ground.j, 0.3, 0.2)
    s.gear(C, ground.j, 0.2)
    s.cylinder(C, D, 0.2)
    s.sphere(C, 0.2)
    s.plate([(0, 0, 0), (1, 0, 0), (0, 0, 1)])
    s.box(C, body, (0.1, 0.2, 0.3))
    s.sum(C, body.point("P", 1.0, 0, 0).acceleration(ground))

    def draw(t, ax):
        ne.drawing.Sketch(ax, ground, plane="xz").rod((0, 0, 0), (1, 0, t))

    film = ne.drawing.animate(draw, (0.0, 0.1, 0.2))
    film.html()
    with tempfile.TemporaryDirectory() as folder:
        film.save(f"{folder}/film.gif")
