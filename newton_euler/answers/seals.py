"""Whether an answer is right, from a seal: a salted slow hash of the right one, which an instructor
may put into each student's own copy.

With the seal of a number, a program finds the number by trying all of its size (known to a factor
of 1.4), a thousand or two, in a minute; a vector or a matrix one component after the other.
Formulas are compared at one point of their symbols, to five digits, and would take a day. So a seal
helps those who learn, and does not stop those who look for the answer.
"""

import hashlib
import math
import os
from collections.abc import Mapping, Sequence
from typing import Any

from .kinds import Kind
from .tolerance import NOISE, RTOL
from .trees import evaluate

COST = 2**13  # of scrypt: some 25 ms
STEP = 1e-3  # of the size of the answer: the width of the cells that are numbered and hashed
ZERO = NOISE  # a smaller answer is round-off for zero
FORMULA = 1e-3  # the factor by which both are finer for formulas, which have all their digits


def seal(
    kind: Kind, numbers: Sequence[float] | str | int, at: Mapping[str, float] | None = None
) -> dict[str, Any]:
    """The seal of an answer of this kind, its ``numbers`` or the word; ``at`` is {symbol: number}
    where a formula has these values. A dict that a notebook can hold.
    """
    salt = os.urandom(8).hex()
    if isinstance(numbers, (str, int)):
        return {"salt": salt, "hashes": [_hash(salt, 0, numbers)]}
    numbers = kind.sealed(tuple(numbers))[0]
    size = math.hypot(*numbers)
    exponent = round(math.log2(size)) if size > ZERO else None
    width = _width(kind, exponent)
    cells = [round(x / width) if width else 0 for x in numbers]
    hashes = [_hash(salt, *cell) for cell in enumerate(cells)]
    found: dict[str, Any] = {"salt": salt, "size": exponent, "hashes": hashes}
    return found | ({"at": dict(at)} if at else {})


def opens(sealed: Mapping[str, Any], kind: Kind, tree: Any) -> bool:
    """True if an answer, as it was read, is the one that was sealed: to 0.5 % of its size and a
    little more, formulas to 0.0005 %.
    """
    if kind.is_word:
        return bool(_hash(sealed["salt"], 0, tree) == sealed["hashes"][0])
    if isinstance(tree, dict):  # components in several frames
        return any(opens(sealed, kind, part) for part in tree.values())
    point = tuple(float(evaluate(t, sealed.get("at", {}))) for t in kind.parts(tree))
    return any(_opens(sealed, kind, numbers) for numbers in kind.sealed(point))


def _opens(sealed, kind, numbers):
    salt, hashes = sealed["salt"], sealed["hashes"]
    width, size = _width(kind, sealed["size"]), math.hypot(*numbers)
    if not width:
        return size <= 1e3 * ZERO
    if not 0.4 < size / 2.0 ** sealed["size"] < 2.5:
        return False
    near = RTOL * (FORMULA if kind.is_formula else 1) * size
    return len(numbers) == len(hashes) and all(
        any(_hash(salt, n, cell) == right for cell in _cells(x, near, width))
        for n, (x, right) in enumerate(zip(numbers, hashes, strict=True))
    )


def _width(kind, exponent):
    if exponent is None:
        return 0.0
    return STEP * (FORMULA if kind.is_formula else 1) * 2.0**exponent


def _cells(x, near, width):
    """The numbers of the cells in which the right component may lie, the nearest first."""
    low = math.ceil((x - near) / width - 0.5)
    high = math.floor((x + near) / width + 0.5)
    return sorted(range(low, high + 1), key=lambda n: abs(n * width - x))


def _hash(salt, place, value):
    text = f"{place} {value}".encode()
    return hashlib.scrypt(text, salt=bytes.fromhex(salt), n=COST, r=8, p=1, dklen=12).hex()
