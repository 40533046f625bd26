"""The public names of the engine: what its rooms export, and the public methods of public classes."""

import inspect
from importlib import import_module

ROOMS = (
    "algebra", "kinematics", "bodies", "dynamics", "applications", "scenes", "motion", "accuracy",
    "drawing", "classroom",
)  # fmt: skip
OPERATORS = (
    "add", "radd", "sub", "rsub", "mul", "rmul", "truediv", "rtruediv", "pow", "rpow", "neg", "abs",
    "eq", "call", "getitem",
)  # fmt: skip
# Records that functions return, and parts made by other functions: nobody calls these classes, so
# only their methods are called here.
NOT_CALLED = (
    "Amount", "Animation", "Audit", "Equation", "Explanation", "Frenet", "LinearForm", "Measured",
    "Motion", "Moving", "Point", "Principal", "Solution", "Symmetry", "Table", "Vector",
)  # fmt: skip


def public_callables():
    """{name: function} of every public function, class and method, as ``bodies.Body.about``."""
    found = {}
    for room in ROOMS:
        for name, thing in exported(import_module(f"newton_euler.{room}")):
            if callable(thing):
                found.setdefault(id(thing), (f"{room}.{name}", thing))
    found = dict(found.values())
    for name, thing in list(found.items()):
        if inspect.isclass(thing) and not issubclass(thing, BaseException):
            for method, function in methods(thing):
                found[f"{name}.{method}"] = function
            if name.rpartition(".")[2] in NOT_CALLED:
                del found[name]
        elif inspect.isclass(thing):
            del found[name]  # errors are raised, not called
    return found


def exported(room):
    """Pairs of a public name of a room and what it stands for."""
    for name in getattr(room, "__all__", None) or sorted(vars(room)):
        thing = getattr(room, name)
        if not name.startswith("_") and str(getattr(thing, "__module__", "")).startswith(
            "newton_euler"
        ):
            yield name, thing


def methods(kind):
    """Pairs of the name of a public method or operator of a class and its function."""
    wanted = {f"__{name}__" for name in OPERATORS}
    for base in kind.__mro__:
        if not base.__module__.startswith("newton_euler"):
            continue
        for name, f in vars(base).items():
            f = f.__func__ if isinstance(f, (classmethod, staticmethod)) else f
            if (
                inspect.isfunction(f)
                and f.__code__.co_filename != "<string>"
                and (not name.startswith("_") or name in wanted)
            ):
                wanted.discard(name)
                yield name, f
