"""What to write in place of an unknown name of a function, an attribute, an argument or a term, and
in place of a call that does not fit. Python's own messages do not say this.
"""

import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from importlib import import_module
from importlib.util import find_spec
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar, get_args, is_typeddict

from .language import _
from .places import note_place, package_of
from .scalars import NewtonEulerError, clipped

# names of other programs, and those used here
_ALSO = {
    "accel": "acceleration", "alpha": "acceleration angular_acceleration",
    "angular_velocity": "rate", "derivative": "rate", "diff": "rate", "length": "norm",
    "m": "mass", "mag": "norm", "magnitude": "norm", "meter": "m", "metre": "m", "newton": "N",
    "normalize": "direction", "normalized": "direction", "omega": "rate angular_velocity",
    "r": "radius", "second": "s", "sec": "s", "speed": "rate norm", "unit_vector": "direction",
    "vel": "velocity",
}  # fmt: skip


class ArgumentError(NewtonEulerError, TypeError):
    """An argument is not of the expected kind, as a number where a function belongs."""


def nearest(name: object, names: Iterable[str], likeness: float = 0.7) -> str:
    """The one of ``names`` that ``name`` means: the same but for capitals and blanks, the shortest
    that begins with it, or one spelt nearly like it, with at least this ``likeness`` (of 1); or "".

    >>> nearest("Coriolis", ["origin", "coriolis"]), nearest("accel", ["rate", "acceleration"])
    ('coriolis', 'acceleration')
    """
    from difflib import get_close_matches

    wrong, known = _plain(str(name)), {_plain(n): n for n in names}
    begun = sorted((p for p in known if len(wrong) > 2 and p.startswith(wrong)), key=len)
    likely = [wrong, *_ALSO.get(wrong, "").lower().split(), *begun]
    found = [p for p in likely if p in known] or get_close_matches(wrong, known, 1, likeness)
    return known[found[0]] if found else ""


def _plain(name):
    return name.lower().replace(" ", "_").replace("-", "_").strip("_")


def did_you_mean(name: object, names: Iterable[str], written: str = "{!r}") -> str:
    """ ". Did you mean 'coriolis'?", or "" where none of the ``names`` is near."""
    found = nearest(name, names)
    return _(". Did you mean {name}?", name=written.format(found)) if found else ""


# -- attributes


class UnknownName(AttributeError):
    """An object has no such attribute; the text, made when it is asked for, names the nearest."""

    def __str__(self) -> str:
        kind = type(self.obj).__name__
        terms = self.obj if isinstance(self.obj, dict) else getattr(self.obj, "terms", {})
        if term := nearest(self.name, terms):
            where = "" if terms is self.obj else ".terms"
            return f"{kind} has no attribute {self.name!r}; the term is {where}[{term!r}]"
        public = [n for n in dir(type(self.obj)) if not n.startswith("_")]
        near = did_you_mean(self.name, public, ".{}") or f"; it has {', '.join(public)}"
        return f"{kind} has no attribute {self.name!r}{near}"


class Guided:
    """Base of classes that answer an unknown attribute with the nearest known one."""

    __slots__ = ()

    if not TYPE_CHECKING:  # else a type checker would find every attribute

        def __getattr__(self, name: str) -> Any:
            raise UnknownName(name=name, obj=self)


def guide(package: str) -> None:
    """Answer names that a room does not have with where they live."""
    sys.modules[package].__getattr__ = lambda name: unknown(package, name)  # type: ignore


def unknown(package: str, name: str) -> None:
    """Raise the error for a name that a module does not have: where it lives, or the nearest."""
    # names looked up before a module of that name is imported need no rooms, which take a second
    if name.startswith("_") or find_spec(f"{package}.{name}"):
        raise AttributeError(f"module {package!r} has no attribute {name!r}")
    top = import_module(package.partition(".")[0])
    homes = {n: f"{top.__name__}.{r}" for r in sorted(top.ROOMS) for n in _public(top, r)}
    homes |= dict.fromkeys(top.__all__, top.__name__)
    found = nearest(name, homes)
    if name in homes:
        words = f": write from {homes[name]} import {name}"
    elif found:
        words = f". Did you mean {found!r}? Write: from {homes[found]} import {found}"
    else:
        words = f". Look in its rooms: {', '.join(sorted(top.ROOMS))}"
    raise (ImportError if _is_imported(top) else AttributeError)(
        f"{package} has no {name!r}{words}"
    )


def _public(top, room):
    """The names that a room lists."""
    module = import_module(f"{top.__name__}.{room}")
    return [n for n, x in vars(module).items() if n[0] != "_" and not isinstance(x, ModuleType)]


def _is_imported(top):
    """True in a from … import, which replaces the words of an AttributeError by its own."""
    from opcode import opname

    frame = sys._getframe(2)
    while package_of(frame) == top.__name__:
        frame = frame.f_back
    return opname[frame.f_code.co_code[frame.f_lasti]] == "IMPORT_FROM"


# -- calls

F = TypeVar("F", bound=Callable)


def guided(f: F) -> F:
    """The function ``f``, or a class, with calls whose arguments do not fit refused in words; an
    error of a function of the caller has a note of the place.
    """
    if isinstance(f, type):
        f.__init__ = guided(f.__init__)  # type: ignore[misc]
        return f

    @wraps(f)
    def call(*args, **named):
        try:
            return f(*args, **named)
        except Exception as error:
            if isinstance(error, TypeError) and (words := misfit(f, args, named)):
                raise ArgumentError(words) from None
            note_place(error)
            raise

    return call  # type: ignore[return-value]


def misfit(f: Callable[..., Any], args: Sequence[Any], named: Mapping[str, Any]) -> str:
    """Why these arguments do not fit the function, and how to write them; "" where they do."""
    from inspect import Parameter, signature

    name = f.__qualname__.removesuffix(".__init__").rpartition(".")[2]
    parameters = dict(signature(f).parameters)
    if parameters.pop("self", None) or parameters.pop("cls", None):
        args = args[1:]
    by_kind: dict = {}
    for n, p in parameters.items():
        by_kind.setdefault(p.kind, []).append(n)
    by_place = [
        *by_kind.get(Parameter.POSITIONAL_ONLY, ()),
        *by_kind.get(Parameter.POSITIONAL_OR_KEYWORD, ()),
    ]
    rest, several = by_kind.get(Parameter.VAR_KEYWORD), by_kind.get(Parameter.VAR_POSITIONAL)
    more = _keys(parameters[rest[0]].annotation) if rest else []
    known = [*by_place, *by_kind.get(Parameter.KEYWORD_ONLY, ()), *more]
    write = f"Write {name}({', '.join(known)})"
    for n in named:
        if n not in known and (more or not rest):
            near = did_you_mean(n, known, "{}=") or "."
            return f"{name} has no argument {n!r}{near} {write}"
        if n in by_place[: len(args)]:
            return f"{name} was given {n} twice, by place and by name. {write}"
    needed = [n for n in known if n not in more and parameters[n].default is Parameter.empty]
    missing = [n for n in needed if n not in named and n not in by_place[: len(args)]]
    if missing:
        return _with_a_row_opened(name, args, missing) or f"{name} needs {listed(missing)}. {write}"
    if len(args) > len(by_place) and not several:
        return f"{name} takes {len(by_place)} arguments by place, got {len(args)}. {write}"
    return ""


def _with_a_row_opened(name, args, missing):
    """How to write a call in which several numbers were passed as one list; "" for others."""
    for n, x in enumerate(args):
        row = x.tolist() if hasattr(x, "tolist") else x
        if isinstance(row, (list, tuple)) and len(row) == len(missing) + 1:
            singly = ", ".join(map(clipped, [*args[:n], *row, *args[n + 1 :]]))
            return f"{name} takes its numbers one by one: write {name}({singly})"
    return ""


def listed(names: Iterable[str]) -> str:
    """The names as a list in a sentence.

    >>> listed(["a"]), listed(["a", "b", "c"])
    ('a', 'a, b and c')
    """
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last


def _keys(annotation):
    """The names that an unpacked TypedDict allows."""
    return [k for kind in filter(is_typeddict, get_args(annotation)) for k in kind.__annotations__]
