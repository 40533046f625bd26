"""The methods of integration as values in one table, and how each is made to reach the accuracy asked for.

What is asked for is the error of the motion, not that of a step. An adaptive method therefore runs twice, once at a tolerance a thousand times
as coarse; the difference is the error of the coarse run, and as the error is proportional to the tolerance it foretells that of the fine one.
Where that is too large the tolerance is tightened by what is missing, and the new run measures the one before. Runs of heyoka cost so little that
its tolerance is a hundredth of what is asked for from the start.
"""

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass

from .dop853 import Dop853
from .exact import Exact
from .scipy_methods import scipy_method
from .splitting import partition, principal_moments, splitting
from .taylor import TAYLOR_MARGIN, Taylor, installed

COARSENING = 1e3  # between the two runs
TOLERANCE_RATIO = 30.0  # the first tolerance is so much below the accuracy asked for: errors are up to 100 tolerances, seldom less than one
MAX_COARSE_TOLERANCE = 1e-2


@dataclass(frozen=True)
class Method:
    """One method.

    name, words : its name in ``integrate(method=...)`` and what it is
    course : the class that follows a motion by it
    order : of convergence of a run with a fixed step; None where there is none
    least : the smallest error, relative to each state, that it can be asked for
    cannot : a function of the prepared model that says why it cannot be used for it, or None
    calibrated : True if its tolerance is set by two runs
    easy, loosest : the first tolerance is so much below the accuracy asked for, and not above this: coarse runs foretell little
    tightest : the least tolerance that it is given; steps that are set by it know no least
    """

    name: str
    description: str
    stepper: Callable
    order: int | None = None
    min_rtol: float = 1e-13
    unusable_because: Callable = lambda system: None
    calibrated: bool = True
    tolerance_ratio: float = TOLERANCE_RATIO
    max_tolerance: float = 3e-6
    min_tolerance: float = 1e-14


def _no_exact(system):
    if system.model.exact is None:
        return f"no exact solution of {system.model.name!r} is known"
    return None


def _no_heyoka(system):
    return None if installed() else "heyoka is not installed: pip install 'newton-euler[fast]' (Linux)"


def _no_scipy(system):
    return None if importlib.util.find_spec("scipy") else "SciPy is not installed: pip install scipy"


def _no_groups(system):
    if partition(system) is None:
        return f"the states of {system.model.name!r} do not split into two groups, as places and velocities, with no rate that needs its own group"
    return None


def _no_body(system):
    return (
        None
        if principal_moments(system)
        else f"{system.model.name!r} is not Euler's equations of a free body, three rates like a product of the two others"
    )


SCIPY = (("DOP853", 8, 1e-11), ("RK45", 5, 1e-12), ("LSODA", None, 1e-8), ("Radau", 5, 1e-10))
MIN_RTOL = {2: 1e-7, 4: 1e-9, 6: 1e-10, 8: 1e-10}  # by order: round-off of many steps


def _table():
    yield Method("exact", "exact solution", Exact, min_rtol=1e-15, unusable_because=_no_exact, calibrated=False)
    yield Method(
        "taylor", "Taylor series of heyoka", Taylor, min_rtol=1e-15, unusable_because=_no_heyoka, calibrated=False, tolerance_ratio=TAYLOR_MARGIN
    )
    yield Method("dop853", "Runge-Kutta of order 8 in straight-line Python", Dop853, 8)
    for name, order, min_rtol in SCIPY:
        tolerance_ratio, max_tolerance = (1.0, 1e-4) if name == "Radau" else (TOLERANCE_RATIO, 3e-6)  # whose errors are smaller than its tolerance
        description = f"SciPy's {name} on traced straight-line code"
        yield Method(
            f"scipy {name}", description, scipy_method(name), order, min_rtol, _no_scipy, tolerance_ratio=tolerance_ratio, max_tolerance=max_tolerance
        )
    for order in (2, 4, 6, 8):
        name = "verlet" if order == 2 else f"yoshida{order}"
        description = "Verlet's method" if order == 2 else f"Yoshida's composition of order {order}"
        yield Method(name, f"{description}, symplectic", splitting(order), order, MIN_RTOL[order], _no_groups, min_tolerance=1e-40)
        description = f"Lie-Poisson splitting of order {order}, keeps the angular momentum"
        yield Method(f"lie-poisson{order}", description, splitting(order, body=True), order, MIN_RTOL[order], _no_body, min_tolerance=1e-40)


METHODS = {m.name: m for m in _table()}
