"""What functions read besides their arguments: globals, variables of the functions around them,
default values; also those of every function that they can call. A text that was traced from a
function holds as long as all of this is the same. It is found in the byte code, once, and compared
before each use: no value is computed, and nothing is called.
"""

import builtins
import dis
import sys
import types
from collections.abc import Set
from dataclasses import fields
from fractions import Fraction
from functools import lru_cache, partial

from .scalars import LIBRARIES, _Own, _root

ABSENT = object()
ENGINE = {"newton_euler"}
PYTHONS = {"builtins", "math", "cmath", "operator", "itertools", "functools", "fractions"}
# packages whose functions and modules stay as they are while a program runs
FIXED = {*ENGINE, *PYTHONS, *LIBRARIES, "scipy"}
# kinds of values that never change: a name can only be given another one
CONSTANTS = (bool, int, float, complex, str, bytes, type(None), range, Fraction, _Own)
RANDOM = "numpy.random"
# functions by which code reaches what its byte code does not name
HIDDEN = {"eval", "exec", "globals", "locals", "open", "input", "__import__", "compile"}
BY_NAME = {"getattr", "vars", "dir"}


class Reads:
    """What some functions read besides their arguments, as it is now.

    checks : tuples (get, a, b, value) that find it again: get(a, b) is the value
    known : False if some of it can change unseen, as an attribute of an object
    prints : True if they are known to call ``print``

    >>> g = 9.81
    >>> read = Reads(lambda s, p, t: -g)
    >>> before = read.hold(); g = 1.62; before, read.hold()
    (True, False)
    """

    __slots__ = ("_noted", "checks", "known", "prints")

    def __init__(self, *functions: object):
        self.known, self.prints = True, False
        self.checks: list[tuple] = []
        self._noted: set[tuple[int, str]] = set()
        waiting, seen = [*functions], {}
        while waiting and self.known:
            x = waiting.pop()
            if id(x) not in seen:
                seen[id(x)] = x  # which keeps it, and so its id
                self._read(x, waiting)
        if not self.known:
            self.checks = []

    def hold(self) -> bool:
        """True if all of it is certainly the same."""
        try:
            for get, a, b, value in self.checks:
                if get(a, b) is not value:
                    return False
        except ValueError:  # a variable without a value
            return False
        return self.known

    def _read(self, x, waiting):
        """Note what one value consists of; what may follow from there is ``waiting``."""
        if isinstance(x, types.FunctionType):
            self._read_function(x, waiting)
        elif isinstance(x, (tuple, frozenset)):
            waiting += x
        elif isinstance(x, types.MappingProxyType):
            waiting += x.values()
        elif isinstance(x, partial):
            waiting += [x.func, *x.args, *x.keywords.values()]
        elif isinstance(x, types.MethodType):
            waiting += [x.__func__, x.__self__]
        elif isinstance(x, types.BuiltinFunctionType):
            if not isinstance(x.__self__, (types.ModuleType, type(None))):
                waiting.append(x.__self__)
            fixed = not isinstance(x.__self__, types.ModuleType) or _is_fixed(x.__self__)
            self.known = self.known and fixed and x.__name__ not in HIDDEN
            self.prints = self.prints or x is print
        elif _root(type(x)) == "newton_euler" and hasattr(x, "__dataclass_fields__"):
            waiting += [getattr(x, f.name) for f in fields(x)]  # a model has functions of its user
        else:
            self.known = _is_constant(x)

    def _read_function(self, f, waiting):
        cells = f.__closure__ or ()
        if _is_fixed_function(f):  # which gives its variables no other values
            waiting += [cell.cell_contents for cell in cells]
            return
        for cell in cells:
            self._note(getattr, cell, "cell_contents", waiting)
        # a notebook that reloads a module puts new code into its functions
        for part in ("__code__", "__defaults__", "__kwdefaults__"):
            if getattr(f, part) is not None:
                self.checks.append((getattr, f, part, getattr(f, part)))
        waiting += f.__defaults__ or ()
        for name in f.__kwdefaults__ or ():
            self._note(f.__kwdefaults__.get, name, ABSENT, waiting)
        loaded, names = names_in(f.__code__)
        self.known = self.known and loaded is not None
        for name in loaded or ():
            self._note_name(f.__globals__, name, loaded, names, waiting)

    def _note_name(self, space, name, loaded, names, waiting):
        self._noted.add((id(space), name))
        x = self._note(space.get, name, ABSENT, waiting)
        if x is ABSENT:  # now, but it can come, before the built-in one
            waiting.append(vars(builtins).get(name))
        elif isinstance(x, types.ModuleType) and not _is_fixed(x):
            self.known = self.known and not loaded & BY_NAME
            for n in names & vars(x).keys():
                if (id(vars(x)), n) not in self._noted:
                    self._note_name(vars(x), n, loaded, names, waiting)
        elif isinstance(x, types.ModuleType):
            reached = {x.__name__, *(f"{x.__name__}.{n}" for n in names)}
            self.known = self.known and RANDOM not in reached

    def _note(self, get, a, b, waiting):
        """Note one value that can become another, and return it."""
        x = ABSENT
        try:
            x = get(a, b)
        except ValueError:  # a variable without a value yet
            self.known = False
        self.checks.append((get, a, b, x))
        if x is not ABSENT and not isinstance(x, types.ModuleType):
            waiting.append(x)
        return x


def reads_nothing(f: object) -> bool:
    """True for a function of a module of the engine: it reads nothing that changes."""
    return type(f) is types.FunctionType and f.__closure__ is None and _is_fixed_function(f, ENGINE)


def _is_fixed_function(f, packages=FIXED):
    """True for a function of a module of these packages; not for one of a doctest in its name."""
    name = f.__module__
    if not name or name.partition(".")[0] not in packages:
        return False
    module = sys.modules.get(name)
    return module is not None and f.__globals__ is vars(module)


@lru_cache(maxsize=256)
def names_in(code: types.CodeType) -> tuple[Set[str] | None, Set[str]]:
    """The names of globals that some byte code loads, a set, and all names and texts in it; None
    and the names if it also sets some, or imports a module that is not fixed.
    """
    loaded, names = set(), {*code.co_names, *(c for c in code.co_consts if isinstance(c, str))}
    for step in dis.get_instructions(code):
        foreign = step.opname == "IMPORT_NAME" and step.argval.partition(".")[0] not in FIXED
        if foreign or step.opname in ("STORE_GLOBAL", "DELETE_GLOBAL"):
            return None, names
        if step.opname in ("LOAD_GLOBAL", "LOAD_NAME"):
            loaded.add(step.argval)
    for inner in code.co_consts:
        if isinstance(inner, types.CodeType):
            more, more_names = names_in(inner)
            if more is None:
                return None, names
            loaded, names = loaded | more, names | more_names
    return frozenset(loaded), frozenset(names)


def _is_fixed(x):
    """True for a class or module of one of the fixed packages."""
    name = getattr(x, "__name__", "") if isinstance(x, types.ModuleType) else x.__module__
    return str(name).partition(".")[0] in FIXED


def _is_constant(x):
    """True for values that cannot change: numbers, text, classes and objects of the engine."""
    kind = type(x)
    if isinstance(x, type):
        return _is_fixed(x)
    if kind in CONSTANTS or isinstance(x, _Own) or _root(kind) == "newton_euler":
        return True
    # an array and a matrix can change
    return _root(kind) in LIBRARIES and hasattr(x, "__mul__") and not hasattr(x, "__setitem__")
