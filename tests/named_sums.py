"""A check that a sum keeps all of its terms, whatever they are called.

Names are for people: two forces may both be called "force", a frame "" or "arm 2".
"""

import numpy as np
from hypothesis import settings
from hypothesis import strategies as st

NAMES = st.sampled_from(["force", "force 1", "force 2", "force x force", "", "self"])
COMPONENTS = st.integers(-8, 8).map(lambda n: n / 4)  # exact in binary, and often equal
TRIPLES = st.tuples(COMPONENTS, COMPONENTS, COMPONENTS)

by_any_names = settings(max_examples=40, derandomize=True)


def value(x):
    """A Vector, Inertia or amount of energy as numbers."""
    if hasattr(x, "expressed_in"):
        return np.array([*map(np.array, x)], dtype=float)
    return np.array(float(x))


def check_terms(whole, parts, names):
    """``whole`` is the sum of ``parts``: value, terms, what is left without a name, print."""
    size = 1 + max((np.abs(p).max() for p in parts), default=0)
    agree = lambda found, expected: np.allclose(found, expected, rtol=0, atol=1e-12 * size)
    total = sum(parts, 0 * value(whole))
    assert agree(value(whole), total)
    assert len(whole.terms) == len(parts)
    assert all(map(agree, map(value, whole.terms.values()), parts))
    for name in set(names):
        named = sum(p for p, n in zip(parts, names, strict=True) if n == name)
        assert agree(value(whole.without(name)), total - named)
        assert agree(value(whole.reweighted(**{name: 3})), total + 2 * named)
    if hasattr(whole, "explain"):
        rows = str(whole.explain()).split("\n")[1:]
        assert len({row.rsplit("  ", 1)[0] for row in rows}) == len(rows) == len(parts) + 1
