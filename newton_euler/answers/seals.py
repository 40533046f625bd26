"""Whether an answer is right, from a seal: a salted slow hash of the right one, which an instructor
may put into each student's own copy.

It gives away the size, to a factor of 1.4: a program that tries all numbers of that size finds a
number in 20 s, a vector in a plane in an hour or two, one in space in a month; of a formula only
the value. So a seal helps those who learn, and does not stop those who search by program;
:mod:`.checks` makes those wait who guess by hand.
"""

import hashlib
import math
import os
from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any

from .kinds import Kind
from .tolerance import NOISE, RTOL
from .trees import evaluate

VERSION = 2
OF_OWN_TOLERANCE = 3  # the version of a seal that states its tolerance
COST = 2**15  # cost of scrypt: some 0.1 s
MEMORY = 2**26  # bytes, twice what it takes
SHIFTS = 8  # positions within a cell; that of the right answer is published
ZERO = NOISE  # a smaller answer counts as zero
FORMULA = 1e-3  # cells for formulas, which have all their digits, are finer by this factor


def seal(
    kind: Kind,
    numbers: Sequence[float] | str | int,
    at: Mapping[str, float] | None = None,
    rtol: float = RTOL,
) -> dict[str, Any]:
    """The seal of an answer of this kind, its ``numbers`` or the word, a dict that a notebook can
    hold; ``at`` is {symbol: number} where a formula has these values; ``rtol``: as for
    :meth:`~.kinds.Kind.is_right`.

    Numbers are those of the cell in which the components lie together. Where in its cell each
    component lies is published, so that an answer near it is in one or two cells, which are tried.
    """
    salt = os.urandom(8).hex()
    if isinstance(numbers, (str, int)):
        return {"version": VERSION, "salt": salt, "hashes": [_hash(salt, numbers)]}
    numbers = kind.sealed(tuple(numbers))[0]
    size = math.hypot(*numbers)
    exponent = round(math.log2(size)) if size > ZERO else None
    width = _width(kind, exponent, rtol)
    places = [round(SHIFTS * x / width) if width else 0 for x in numbers]
    cell, shifts = [n // SHIFTS for n in places], [n % SHIFTS for n in places]
    found = {
        "version": VERSION, "salt": salt, "size": exponent, "shifts": shifts,
        "hashes": [_hash(salt, *cell)],
    }  # fmt: skip
    if rtol != RTOL:
        found |= {"version": OF_OWN_TOLERANCE, "rtol": rtol}
    return found | ({"at": dict(at)} if at else {})


def is_known(sealed: Mapping[str, Any]) -> bool:
    """False for a seal that another version of this module made, and where Python has no scrypt, as
    in a browser: an answer is recorded there, and not compared.
    """
    return hasattr(hashlib, "scrypt") and sealed.get("version") in (VERSION, OF_OWN_TOLERANCE)


def opens(sealed: Mapping[str, Any], kind: Kind, tree: Any) -> bool:
    """True if an answer, as it was read, is the one that was sealed: to its tolerance (0.5 % of its
    size), formulas to 0.0005 %.
    """
    if kind.is_word:
        return _hash(sealed["salt"], tree) == sealed["hashes"][0]
    if isinstance(tree, dict):  # components in several frames
        return any(opens(sealed, kind, part) for part in tree.values())
    point = tuple(float(evaluate(t, sealed.get("at", {}))) for t in kind.parts(tree))
    return any(_opens(sealed, kind, numbers) for numbers in kind.sealed(point))


def _opens(sealed, kind, numbers):
    rtol = sealed.get("rtol", RTOL)
    width, size = _width(kind, sealed["size"], rtol), math.hypot(*numbers)
    if not width:
        return size <= 1e3 * ZERO
    if not 0.4 < size / 2.0 ** sealed["size"] < 2.5 or len(numbers) != len(sealed["shifts"]):
        return False
    near = _near(kind, rtol) * size + width / (2 * SHIFTS)
    pairs = zip(numbers, sealed["shifts"], strict=True)
    cells = (_cells(x, n / SHIFTS, near, width) for x, n in pairs)
    return any(_hash(sealed["salt"], *cell) == sealed["hashes"][0] for cell in product(*cells))


def _near(kind, rtol):
    return RTOL * FORMULA if kind.is_formula else rtol


def _width(kind, exponent, rtol):
    """The width of a cell: as far as answers are right around the smallest number of this size."""
    return 0.0 if exponent is None else math.sqrt(2) * _near(kind, rtol) * 2.0**exponent


def _cells(x, shift, near, width):
    """The numbers of the cells in which the right component may lie, at most ``near`` from x."""
    low, high = math.ceil((x - near) / width - shift), math.floor((x + near) / width - shift)
    return sorted(range(low, high + 1), key=lambda n: abs((n + shift) * width - x))


def _hash(salt, *values):
    text = " ".join(map(str, values)).encode()
    salt = bytes.fromhex(salt)
    return hashlib.scrypt(text, salt=salt, n=COST, r=8, p=1, maxmem=MEMORY, dklen=12).hex()
