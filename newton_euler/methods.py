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
from .scipy_methods import scipy_course
from .splitting import groups, moments, splitting
from .taylor import TAYLOR_MARGIN, Taylor, installed

DECADES = 1e3  # between the two runs
EASY = 30.0  # the first tolerance is so much below the accuracy asked for: errors are up to 100 tolerances, seldom less than one
COARSEST = 1e-2


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
    words: str
    course: Callable
    order: int | None = None
    least: float = 1e-13
    cannot: Callable = lambda system: None
    calibrated: bool = True
    easy: float = EASY
    loosest: float = 3e-6
    tightest: float = 1e-14


def _no_exact(system):
    if system.model.exact is None:
        return f"no exact solution of {system.model.name!r} is known"
    return None


def _no_heyoka(system):
    return None if installed() else "heyoka is not installed: pip install 'newton-euler[fast]' (Linux)"


def _no_scipy(system):
    return None if importlib.util.find_spec("scipy") else "SciPy is not installed: pip install scipy"


def _no_groups(system):
    if groups(system) is None:
        return f"the states of {system.model.name!r} do not split into two groups, as places and velocities, with no rate that needs its own group"
    return None


def _no_body(system):
    return None if moments(system) else f"{system.model.name!r} is not Euler's equations of a free body, three rates like a product of the two others"


SCIPY = (("DOP853", 8, 1e-11), ("RK45", 5, 1e-12), ("LSODA", None, 1e-8), ("Radau", 5, 1e-10))
LEAST = {2: 1e-7, 4: 1e-9, 6: 1e-10, 8: 1e-10}  # by order: round-off of many steps


def _table():
    yield Method("exact", "exact solution", Exact, least=1e-15, cannot=_no_exact, calibrated=False)
    yield Method("taylor", "Taylor series of heyoka", Taylor, least=1e-15, cannot=_no_heyoka, calibrated=False, easy=TAYLOR_MARGIN)
    yield Method("dop853", "Runge-Kutta of order 8 in straight-line Python", Dop853, 8)
    for name, order, least in SCIPY:
        easy, loosest = (1.0, 1e-4) if name == "Radau" else (EASY, 3e-6)  # whose errors are smaller than its tolerance
        words = f"SciPy's {name} on traced straight-line code"
        yield Method(f"scipy {name}", words, scipy_course(name), order, least, _no_scipy, easy=easy, loosest=loosest)
    for order in (2, 4, 6, 8):
        name = "verlet" if order == 2 else f"yoshida{order}"
        words = "Verlet's method" if order == 2 else f"Yoshida's composition of order {order}"
        yield Method(name, f"{words}, symplectic", splitting(order), order, LEAST[order], _no_groups, tightest=1e-40)
        words = f"Lie-Poisson splitting of order {order}, keeps the angular momentum"
        yield Method(f"lie-poisson{order}", words, splitting(order, body=True), order, LEAST[order], _no_body, tightest=1e-40)


METHODS = {m.name: m for m in _table()}
