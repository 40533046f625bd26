"""Numbers and lists in the words of a caption: plain text, with the signs of Unicode."""

import math
from collections.abc import Iterable

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
PREFIXES = {0: "", -1: "m", -2: "µ", -3: "n"}


def two_digits(x: float) -> str:
    """A number in two digits, as a power of ten where it is small or large.

    >>> [two_digits(x) for x in (2.04e-6, 1e-9, 0.0713, 320.0, 0.0)]
    ['2 × 10⁻⁶', '10⁻⁹', '0.071', '320', '0']
    """
    if x == 0 or 1e-3 <= abs(x) < 1e5:
        return f"{x:.2g}" if abs(x) < 100 else f"{float(f'{x:.2g}'):.0f}"
    digits, _, power = f"{x:.1e}".partition("e")
    raised = "10" + str(int(power)).translate(RAISED)
    digits = digits.removesuffix(".0")
    return raised if digits == "1" else f"{digits} × {raised}"


def about(x: float) -> float:
    """The nearest of 1, 3, 10, 30 ...: the size of a time that differs from run to run.

    >>> about(1.7), about(1.8), about(54.3)
    (1.0, 3.0, 30.0)
    """
    power = 10.0 ** math.floor(math.log10(x))
    return min((power, 3 * power, 10 * power), key=lambda y: abs(math.log(y / x)))


def seconds(x: float) -> str:
    """The size of a time with the prefix of its unit.

    >>> seconds(1.234e-5)
    'about 10 µs'
    """
    value = float(f"{about(x):.0g}")
    power = min(0, max(-3, math.floor(math.log10(value * (1 + 1e-9)) / 3)))
    return f"about {value / 1000.0**power:.3g} {PREFIXES[power]}s"


def times_as_much(ratio: float) -> str:
    """How many times as much, of what was counted.

    >>> times_as_much(1.34), times_as_much(2.0), times_as_much(54.3)
    ('1.3 times', 'twice', '54 times')
    """
    return "twice" if f"{ratio:.2g}" == "2" else f"{two_digits(ratio)} times"


def about_times(ratio: float) -> str:
    """How many times as much, of what was timed.

    >>> about_times(7.2), about_times(54.3)
    ('about 10 times', 'about 30 times')
    """
    return f"about {two_digits(about(ratio))} times"


def agreed(texts: Iterable[Iterable[str]]) -> str:
    """The sentences of the first text that all others have too: what no repeat contradicts.

    >>> agreed([["a is fast.", "b is slow."], ["b is slow."]])
    'b is slow.'
    """
    first, *others = map(list, texts)
    return " ".join(s for s in first if s and all(s in other for other in others))
