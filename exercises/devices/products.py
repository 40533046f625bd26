"""Products of inertia as answers, for 7/31 and 7/32."""

KEYS = "I_xy", "I_yz", "I_zx"


def named(products):
    """The answers, from the three products."""
    return dict(zip(KEYS, products, strict=True))
