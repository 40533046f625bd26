"""The methods of integration, in one table.

The rtol is the error of the motion, not that of a step, so a method runs at least twice.
Runge-Kutta methods run first at a tolerance a thousand times as coarse: the difference is the error
of the coarse run, and predicts that of the fine one, as it is nearly proportional to the tolerance.
Runs of heyoka cost so little that they are compared with one two orders higher. If the error is too
large, the tolerance is reduced; if that does not help, the answer is refused.
"""

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass

from .base import Stepper
from .dop853 import Dop853
from .exact import Exact
from .scipy import DOP853, LSODA, RK45, Radau
from .splitting import LiePoisson, Splitting, partition, principal_moments
from .taylor import LEVELS, Taylor, installed, level_of

MAX_COARSE_TOLERANCE = 1e-4  # the largest tolerance of a first run


@dataclass(frozen=True)
class Method:
    """One method of integration. All that other files ask about it is an attribute here.

    name, description : its name in ``integrate(method=...)``, and a description
    stepper : the class of its runs
    unusable_because : a function of prepared model and start time that returns why not, or None
    order : of convergence with a fixed step; None if it has no fixed step
    min_rtol : the smallest rtol that it can reach
    tolerance_ratio : rtol over the first tolerance; Runge-Kutta errors are 1 to 100 tolerances
    max_tolerance, min_tolerance : of the first fine run, as coarser predict little; of any run
    coarsening : the tolerance of the first run over that of the second; < 1 where finer is as cheap
    adaptive : True if its steps follow from errors of this order
    closed : True for a closed form: no finer run exists, its error is rounding, see :mod:`.exact`
    series : True for a power series: its order and not its step follows from the tolerance, and
        beyond a kink or a branch point it continues the formula with which it began
    rounded : a function of a tolerance that returns the one at which the method runs
    """

    name: str
    description: str
    stepper: type[Stepper]
    unusable_because: Callable = lambda system, t0=0.0: None
    order: int | None = None
    min_rtol: float = 1e-13
    tolerance_ratio: float = 100.0
    max_tolerance: float = 3e-6
    min_tolerance: float = 1e-14
    coarsening: float = 1e3
    adaptive: bool = False
    closed: bool = False
    series: bool = False
    rounded: Callable = lambda tolerance: tolerance

    def other(self, tolerance: float) -> float:
        """The tolerance of the run that is compared with one at this tolerance."""
        other = tolerance * self.coarsening
        if self.coarsening > 1:
            return max(min(other, MAX_COARSE_TOLERANCE), 10 * tolerance)
        return other if other > self.min_tolerance else tolerance / self.coarsening

    def __reduce__(self):
        return _method, (self.name,)


def _method(name):
    return METHODS[name]


def _no_exact(system, t0=0.0):
    model = system.model
    if model.exact is None:
        return f"no exact solution of {model.name!r} is known"
    if t0 and not system.autonomous:
        return f"the rates of {model.name!r} depend on time, so its exact solution starts at t = 0"
    return None


def _no_heyoka(system, t0=0.0):
    if not installed():
        return "heyoka is not installed: pip install heyoka (Linux)"
    inner, kinks = (system.traced.inner, system.traced.kinks) if system else ((), ())
    if inner:
        of = f"the {inner[0]} in the rates of {system.model.name!r}"
        return f"there is no series of {of}; take method='auto'"
    if kinks:
        return (
            f"the rates of {system.model.name!r} choose between formulas by {', '.join(kinks)}, "
            "and a series continues the one with which it began; take method='auto'"
        )
    return None


def _no_scipy(*_):
    missing = "SciPy is not installed: pip install scipy"
    return None if importlib.util.find_spec("scipy") else missing


def _no_groups(system, t0=0.0):
    if system.traced.kinks:
        return f"the rates of {system.model.name!r} have kinks, at which it loses its order"
    why = f"the states of {system.model.name!r} are not two groups, as places and velocities"
    return None if partition(system) else why


def _no_body(system, t0=0.0):
    why = f"{system.model.name!r} is not Euler's equations of a free body"
    return None if principal_moments(system) else why


def _table():
    yield Method("exact", "exact solution", Exact, _no_exact, min_rtol=1e-15, closed=True)
    # a small tolerance costs a series little; 54, a little less than e^4, is two orders
    series = {"tolerance_ratio": 10.0**1.5, "max_tolerance": 1.0, "min_tolerance": LEVELS[-1]}
    series |= {"coarsening": 1 / 54.0, "series": True, "rounded": level_of}
    yield Method("taylor", "Taylor series of heyoka", Taylor, _no_heyoka, None, 1e-15, **series)
    runge_kutta = "Runge-Kutta of order 8 in straight-line Python"
    yield Method("dop853", runge_kutta, Dop853, order=8, adaptive=True)
    # min_rtol is measured; the errors of Radau are smaller than its tolerance
    for kind, *options in (
        (DOP853, 8, 1e-11),
        (RK45, 5, 1e-12),
        (LSODA, None, 1e-8),
        (Radau, 5, 1e-10, 1.0, 1e-4),
    ):
        name = kind.__name__
        what = f"SciPy's {name} on traced straight-line code"
        yield Method(f"scipy {name}", what, kind, _no_scipy, *options)
    # many small steps have much round-off; the tolerance only sets the step, so it may be tiny
    for order, min_rtol in ((2, 1e-7), (4, 1e-9), (6, 1e-10), (8, 1e-10)):
        name, what = f"yoshida{order}", f"Yoshida's composition of order {order}, symplectic"
        if order == 2:
            name, what = "verlet", "Verlet's method, symplectic"
        limits = {"min_rtol": min_rtol, "min_tolerance": 1e-40, "tolerance_ratio": 30.0}
        yield Method(name, what, Splitting, _no_groups, order, **limits)
        what = f"Lie-Poisson splitting of order {order}, preserves the angular momentum"
        yield Method(f"lie-poisson{order}", what, LiePoisson, _no_body, order, **limits)


METHODS: dict[str, Method] = {method.name: method for method in _table()}
