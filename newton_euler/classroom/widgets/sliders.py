"""Sliders: the values that they take, and how these are shown."""

from dataclasses import dataclass
from decimal import Decimal

from ...algebra.errors import ArgumentError, checked


@checked
@dataclass(frozen=True)
class Slider:
    """A slider for the argument ``name`` of a figure.

    start, lowest, highest, step : its values are start + n step, exactly
    label, unit : how it is shown beside the slider; label is the name by default

    >>> phi = Slider("phi", 30, 0, 90, 5, label="φ", unit="°")
    >>> phi.shown(30), phi.nearest(33.4), phi.samples(3)
    ('φ = 30°', 35, [0, 45, 90])
    """

    name: str
    start: float
    lowest: float
    highest: float
    step: float
    label: str = ""
    unit: str = ""

    def __post_init__(self):
        if not self.name.isidentifier():
            raise ArgumentError(f"a slider has the name of an argument of draw; got {self.name!r}")
        numbers = self.start, self.lowest, self.highest, self.step
        in_order = self.lowest <= self.start <= self.highest and 0 < self.step <= self.span
        if not in_order or self.span > 1e300:
            raise ArgumentError(
                f"slider {self.name}: lowest <= start <= highest, 0 < step <= span; got {numbers!r}"
            )

    @property
    def span(self) -> float:
        """From the lowest to the highest value."""
        return self.highest - self.lowest

    @property
    def limits(self) -> tuple[float, float]:
        """The lowest and the highest value that steps from the start reach."""
        down, up = self.start - self.lowest, self.highest - self.start
        steps = -int(down / self.step + 1e-9), int(up / self.step + 1e-9)
        return self._value(steps[0]), self._value(steps[1])

    @checked
    def nearest(self, x: float) -> float:
        """The value of the slider that is nearest to x."""
        return self._value(round((x - self.start) / self.step))

    @checked
    def samples(self, count: int) -> list[float]:
        """``count`` values, evenly from the lowest to the highest, rounded to steps."""
        if count < 2:
            raise ArgumentError(f"a slider has 2 samples or more; got {count}")
        low, high = self.limits
        each = (low + (high - low) * n / (count - 1) for n in range(count))
        return list(dict.fromkeys(self.nearest(x) for x in each))

    @checked
    def shown(self, x: float) -> str:
        """A value with its label and unit."""
        number = f"{x:.{min(self._decimals, 6)}f}".replace("-", "\N{MINUS SIGN}")
        space = "" if self.unit[:1] in ("", "°", "%") else "\N{NO-BREAK SPACE}"
        return f"{self.label or self.name} = {number}{space}{self.unit}"

    @property
    def _decimals(self):
        """How many decimals the start and the step have."""
        return max(0, *(-Decimal(str(x)).as_tuple().exponent for x in (self.start, self.step)))

    def _value(self, n):
        x = self.start + n * self.step
        return x if isinstance(x, int) else round(x, self._decimals)
