"""``show("v", v, "m/s")``: quantities with name, value and unit, as a line of text."""

import math

from ..algebra.errors import ArgumentError, checked
from ..algebra.scalars import clipped, is_numeric, short_repr
from ..algebra.vectors import Vector

NOISE = 1e-12  # share of the largest value of the same unit; less is the round-off of a zero
ALONE = 1e-14  # NOISE for a value that stands alone, in its unit
PLAIN = 1e-4, 1e7  # numbers between these have no power of ten
MOST = 8  # numbers of an array that are printed


@checked
def show(*what: object, digits: int = 6, row: bool = False) -> None:
    """Print quantities, each by its name, its value and, where it has one, its unit; round-off in
    place of a zero is printed as 0.

    what : name, value, unit, name, value, unit, …; a unit may be left out
    digits : significant digits
    row : all on one line, for the rows of a table

    >>> from newton_euler import Frame
    >>> show("v", Frame("ground").vector(3.0, 1e-17, 0.5), "m/s", "speed", 3.04138, "m/s")
    v     = [3, 0, 0.5] m/s in ground
    speed = 3.04138 m/s
    >>> show("θ", 30.0, "°", "ratio", 2 / 3, digits=3, row=True)
    θ = 30°, ratio = 0.667
    """
    if digits < 1:
        raise ArgumentError(f"digits is 1 or more; got {digits}")
    found = list(_quantities(what))
    largest: dict[str, float] = {}
    for _, value, unit in found:
        largest[unit] = max(largest.get(unit, 0.0), *map(_size, _numbers(value)), 0.0)
    wide = 0 if row else max(len(name) for name, *_ in found)
    lines = [
        f"{name:{wide}} = {_text(value, unit, digits, max(NOISE * largest[unit], ALONE))}"
        for name, value, unit in found
    ]
    print((", " if row else "\n").join(lines))


def _quantities(what):
    """(name, value, unit) of each quantity; of two texts between values the first is a unit."""
    rest = list(what)
    while rest:
        if len(rest) < 2 or not isinstance(rest[0], str) or isinstance(rest[1], str):
            raise ArgumentError(
                f"show takes a name, a value and a unit; got {', '.join(map(clipped, rest[:3]))}"
            )
        name, value, *rest = rest
        texts = next((n for n, x in enumerate(rest) if not isinstance(x, str)), len(rest))
        unit = rest.pop(0) if texts == 2 or texts == len(rest) == 1 else ""
        yield name, value, unit
    if not what:
        raise ArgumentError('show takes a name, a value and a unit: show("v", 3.0, "m/s")')


def _numbers(value):
    """The numbers of a value, however they are nested."""
    parts = _parts(value)
    if parts is None:
        yield value
    for part in parts or ():
        yield from _numbers(part)


def _parts(value):
    """What a value consists of, None for a number."""
    if isinstance(value, (Vector, list, tuple)):
        return list(value)
    return value.tolist() if hasattr(value, "tolist") and value.shape else None


def _size(x):
    known = is_numeric(x) and not isinstance(x, complex) and math.isfinite(x)
    return abs(float(x)) if known else 0.0


def _text(value, unit, digits, noise):
    behind = unit if unit[:1] in ("", "°", "%") else f" {unit}"
    inside = f" in {value.frame.name}" if isinstance(value, Vector) else ""
    return f"{_value(value, digits, noise)}{behind}{inside}"


def _value(value, digits, noise):
    found = _parts(value)
    if found is not None:
        parts = [_value(part, digits, noise) for part in found]
        if len(parts) > MOST:
            parts[MOST - 2 : -1] = ["…"]
        return f"[{', '.join(parts)}]"
    if isinstance(value, (bool, int)) or not is_numeric(value) or isinstance(value, complex):
        return short_repr(value)
    x = 0.0 if abs(float(value)) < noise else float(f"{float(value):.{digits}g}")
    return f"{x:.15g}" if PLAIN[0] <= abs(x) < PLAIN[1] else f"{x:.{digits}g}"
