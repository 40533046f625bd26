"""Why a motion cannot be followed beyond a state that it has reached."""

from contextlib import suppress

from ..algebra.compile import Compiled
from ..algebra.scalars import Scalar, short
from ..algebra.trace import Step
from .methods.base import Floats, LengthError, StepError, System
from .solution import LongError, MotionError, NoValueError, StickingError

# parts of the whole time: a trial step, and the time to reach a border; how a step grows
TINY, NEAR, LONGER = 1e-9, 1e-3, 10.0

DIGITS = 1e-12  # part of two values by which they differ in their last digits only

TOO_LARGE = (
    "a power or an exponential is too large for a float; if the rates are not infinite, write them "
    "differently, as (1 - tanh(x/2))/2 in place of 1/(1 + exp(x))"
)


def why(
    error: Exception, system: System, t: float, x: Floats, span: float
) -> tuple[type[MotionError], str]:
    """The class of the error to be raised for the ``error`` of a method at the time t and the state
    x, and the end of its message; ``span`` is the whole time of the motion.
    """
    if isinstance(error, LengthError):
        with suppress(ArithmeticError):
            if words := _sticking(system, t, x, span):
                return StickingError, words
        return LongError, ""
    if isinstance(error, StepError):
        with suppress(ArithmeticError):
            for kind, found in _REASONS:
                if words := found(system, t, x, span):
                    return kind, words
            words = "; the coordinates may be singular there, or the motion leaves the model"
            return MotionError, words
    if isinstance(error, ValueError) and not isinstance(error, ArithmeticError):
        return NoValueError, ""  # for example of a table, whose message says so
    if isinstance(error, OverflowError):
        return MotionError, f": {TOO_LARGE}"
    return MotionError, "; the coordinates are singular there"


def _moved(system, t, x, step):
    """The time and the states after a step by the rates here."""
    return t + step, *(v + step * rate for v, rate in zip(x, system.rates(t, x), strict=True))


def _without_value(system, t, x, span):
    try:
        later, *moved = _moved(system, t, x, TINY * span)
        system.rates(later, moved)
    except ValueError as error:
        return f": beyond it the rates have no value: {error}"
    except OverflowError:
        return f": beyond it {TOO_LARGE}"
    return ""


def stuck_at(system: System, t: float, x: Floats, span: float) -> tuple[Scalar, Scalar] | None:
    """The choice (a, b) to whose border the rates on both sides lead back, or None."""
    rhs = system.traced.rhs
    for pair in system.traced.choices:
        both = Compiled("switch", rhs.parameters, rhs.trace, pair).on_floats

        def distance(t, *x, both=both):
            one, other = both(t, *x, *system.p)
            return one - other

        if _leads_back(system, distance, t, x, span):
            return pair
    return None


def _sticking(system, t, x, span):
    """The end of a message: where the motion sticks, and what to write; "" if it does not."""
    pair = stuck_at(system, t, x, span)
    if not pair:
        return ""
    one, other, place = _border(pair, system)
    event = (one if other == "0" else f"{one} - {other}") if one and other else "..."
    return (
        f"; it sticks at {place}, to which the rates on both sides lead back: write "
        f"Event(lambda s, p, t: {event}, then=...), which goes on with the model and the "
        "start of what sticks"
    )


def _border(pair, system):
    """The two sides of a choice, each in words or None, and the words for their border."""
    one, other = [_spelled(side, system) for side in pair]
    return one, other, f"{one} = {other}" if one and other else "the border of a choice"


def _hidden(system, t, x, span):
    """The end of a message where only the last digits of what is compared decide; or ""."""
    values = system.traced.compiled_choices(t, *x, *system.p) if system.traced.choices else ()
    for pair, a, b in zip(system.traced.choices, values[::2], values[1::2], strict=True):
        if abs(a - b) < DIGITS * (abs(a) + abs(b)):
            return (
                f"; the rates change at {_border(pair, system)[2]}, which is known to the last "
                f"digit of {max(a, b, key=abs):.6g} only: ask for a larger rtol, or take the "
                "distance from there as the state"
            )
    return ""


def _leads_back(system, distance, t, x, span):
    """True if the rates here, and those beyond the border, soon lead back to it."""
    step, signs = TINY * span, []
    for _ in range(2):
        here, there = distance(t, *x), distance(*_moved(system, t, x, step))
        while there == here and step < NEAR * span:  # as within the last digit of a place far away
            step *= LONGER
            there = distance(*_moved(system, t, x, step))
        time = here * step / ((here - there) or here or step)
        if not 0.0 <= time < NEAR * span:
            return False
        signs.append(here > 0)
        t, *x = _moved(system, t, x, time + step)
    return signs[0] != signs[1] or here == 0


def _spelled(x, system):
    """A state, a parameter, the time or a number as in a function (s, p, t); None for others."""
    if not isinstance(x, Step):
        return short(x)
    name = x.args[0]
    if x.op != "argument" or name == "t":
        return name if x.op == "argument" else None
    return f"s.{name}" if name in system.model.states else f"p.{name}"


# in the order in which they are tried
_REASONS = (NoValueError, _without_value), (StickingError, _sticking), (MotionError, _hidden)
