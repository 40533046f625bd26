"""Slips in the named terms of a vector that is a sum, or whose size is asked for: some left out,
one in another direction, or with its whole size along one axis; sizes added as numbers.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import reduce
from itertools import chain, combinations, permutations, product
from operator import add
from typing import Any

from newton_euler.algebra.jets import Moving
from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.scalars import sqrt
from newton_euler.algebra.trace import Step
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.causes import LEFT_OUT, ORDINALS, computed
from newton_euler.answers.near import LEAST, LESS

from .formulas import Edit

DIRECTION = Words("has {term} in another direction: check the axes of what it is made of")
WHOLE = Words("has all of {term} along one axis: it has components along several")
ONE_AXIS = Words("puts all of {key} along one axis: it has components along several")
SIZE = Words("takes the magnitude of {key} for its {one} component: the {other} one is in it")
REST = Words("takes the {one} component for the magnitude of {key}: the magnitude has both")
WITHOUT = Words("leaves out {terms}: they are not zero here")
ALONE = Words("gives {terms} alone: the sum has more terms")
SIZES = Words("adds the magnitudes of the terms: they are vectors in different directions")
SEVERAL = 6  # terms: of more, no two are left out
NAMED = 2  # terms at most that are named together

Named = Callable[[str, Vector], str]


def of_terms(
    vectors: Mapping[str, Vector], sizes: Mapping[str, Vector], named: Named
) -> Iterator[Edit]:
    """The slips in answers that are ``vectors``, and in those that are the ``sizes`` of some;
    ``named``: a term of a vector in words.
    """
    for key, v in vectors.items():
        yield from _of_vector(key, v, named, lambda c: c)
        yield from _of_size(key, v)
    for key, v in sizes.items():
        yield from _of_vector(key, v, named, lambda c, v=v: [Vector(tuple(c), v.frame).norm()])
        there = [t for t in (v.terms or {}).values() if any(map(is_there, t.c))]
        if len(there) > 1:
            total = reduce(add, (t.norm() for t in there))
            yield Edit(LESS, computed(f"sizes of terms {key}", SIZES), {}, {key: [total]})


def _of_size(key, v):
    """The size of an answer along one axis: it has not been resolved."""
    there = [n for n, x in enumerate(v.c) if is_there(x)]
    size = v.norm() if len(there) > 1 else 0
    for n, sign in product(range(3) if len(there) > 1 else (), (1, -1)):
        along = [sign * size if m == n else 0 for m in range(3)]
        words = Words(ONE_AXIS, key=key)
        yield Edit(LEAST, computed(f"size {key} {n} {sign}", words), {}, {key: along})
    for n, m in permutations(there, 2) if len(there) == 2 else ():
        for op, text in ("size", SIZE), ("rest", REST):
            square = v.c[n] * v.c[n] + (v.c[m] * v.c[m] if op == "size" else -v.c[m] * v.c[m])
            for sign in (1, -1):
                c = [*v.c]
                c[n] = sign * sqrt(sqrt(square * square))  # the component may have either sign
                words = Words(text, key=key, one=ORDINALS[n], other=ORDINALS[m])
                yield Edit(LEAST, computed(f"{op} {key} {n} {sign}", words), {}, {key: c})


def _of_vector(key, v, named, seen):
    """The slips in the terms of one vector; ``seen``: the answer with these components."""
    parts = {n: t.expressed_in(v.frame).c for n, t in (v.terms or {}).items()}
    parts = {n: c for n, c in parts.items() if any(map(is_there, c))}
    ways = chain(_without(v, parts, named), *(_of_term(v, n, c, named) for n, c in parts.items()))
    for name, rank, words, does, c in ways:
        terms = words.values.get("terms", "") if does else ""
        yield Edit(
            rank, computed(f"terms {key} {name}", words, "", does, terms), {}, {key: seen(c)}
        )


def _without(v, parts, named):
    """Two terms or more left out; of many, those that are left are named."""
    count = len(parts) if len(parts) <= SEVERAL else 0
    for few in range(1, NAMED + 1):
        for some in combinations(parts, few):
            rest = [n for n in parts if n not in some]
            words = joined(named(n, v) for n in some)
            if few > 1 and 0 < len(rest) < count:
                left = v.reweighted(**dict.fromkeys(some, 0)).c
                yield f"no {some}", LEAST, Words(WITHOUT, terms=words), LEFT_OUT, left
            if few < count - NAMED:
                alone = v.reweighted(**dict.fromkeys(rest, 0)).c
                yield f"only {some}", LEAST, Words(ALONE, terms=words), "", alone


def _of_term(v, name, c, named):
    """One term along another axis, turned in its plane, or not resolved."""
    rest = v.reweighted(**{name: 0}).c
    there = {n for n, x in enumerate(c) if is_there(x)}
    words = Words(DIRECTION, term=named(name, v))
    for n, m in combinations(range(3), 2) if len(there) < 3 else ():
        if not ((len(there) == 1 and there & {n, m}) or there == {n, m}):
            continue
        for a, b in (1, -1), (-1, 1), *[(1, 1), (-1, -1)] * (len(there) > 1):
            moved = _sum(rest, rotated_components(c, n, m, a, b))
            yield f"{name} {n} {m} {a} {b}", LESS, words, "", moved
    size = Vector(c, v.frame).norm()
    for n in there if len(there) > 1 else ():
        for sign in (1, -1):
            whole = [sign * size if m == n else 0 for m in range(3)]
            words = Words(WHOLE, term=named(name, v))
            yield f"whole {name} {n} {sign}", LEAST, words, "", _sum(rest, whole)


def _sum(a, b):
    return [x + y for x, y in zip(a, b, strict=True)]


def rotated_components(parts: Sequence[Any], n: int, m: int, a: int, b: int) -> tuple[Any, ...]:
    """The components with the n-th in the place of the m-th, times b, and back, times a."""
    moved = [*parts]
    moved[n], moved[m] = a * parts[m], b * parts[n]
    return tuple(moved)


def is_there(x: Any) -> bool:
    """True of a component that is not zero by structure, or of one whose rates are not."""
    return any(isinstance(s, Step) or s != 0 for s in scalars_in([x]))


def scalars_in(parts: Sequence[Any]) -> Iterator[Any]:
    """The scalars in components, moving or not; an axis is one of them."""
    for x in parts:
        if isinstance(x, Moving):
            yield from scalars_in((x.value, x.rate, x.acceleration))
        else:
            yield x
