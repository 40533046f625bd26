"""What all proofs share: their digits, and sums of numbers, vectors or matrices."""

DIGITS = 50


class ProofError(ValueError):
    """A tool of a proof cannot give what is asked for: an integral that does not settle, a root
    that is not there.
    """


def weighted(weights, values):
    """The sum of ``weights`` times ``values``, which are numbers, vectors or matrices (lists)."""
    if isinstance(values[0], (list, tuple)):
        return [weighted(weights, parts) for parts in zip(*values, strict=True)]
    return sum(w * v for w, v in zip(weights, values, strict=True))


def entries(value):
    """The numbers of a number, vector or matrix, as a flat list."""
    if isinstance(value, (list, tuple)):
        return [x for part in value for x in entries(part)]
    return [value]
