"""Numbers and lists in the words of a caption: plain text, with the signs of Unicode."""

from collections.abc import Iterable

from matplotlib.ticker import EngFormatter

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(x: float) -> str:
    """A number in two digits, as a power of ten where it is small or large.

    >>> number(2.04e-6), number(1e-9), number(0.0713), number(320.0), number(0.0)
    ('2 × 10⁻⁶', '10⁻⁹', '0.071', '320', '0')
    """
    if x == 0 or 1e-3 <= abs(x) < 1e5:
        return f"{x:.2g}" if abs(x) < 100 else f"{float(f'{x:.2g}'):.0f}"
    digits, _, power = f"{x:.1e}".partition("e")
    raised = "10" + str(int(power)).translate(RAISED)
    digits = digits.removesuffix(".0")
    return raised if digits == "1" else f"{digits} × {raised}"


def seconds(x: float) -> str:
    """A time in two digits with the prefix of its unit.

    >>> seconds(1.234e-5)
    '12 µs'
    """
    return EngFormatter(unit="s")(float(f"{x:.2g}"))


def times(ratio: float) -> str:
    """How many times as much.

    >>> times(1.34), times(2.0), times(54.3)
    ('1.3 times', 'twice', '54 times')
    """
    return "twice" if f"{ratio:.2g}" == "2" else f"{number(ratio)} times"


def listed(names: Iterable[str]) -> str:
    """The names as a list in a sentence.

    >>> listed(["a"]), listed(["a", "b", "c"])
    ('a', 'a, b and c')
    """
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last
