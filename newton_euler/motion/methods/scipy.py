"""SciPy's methods of integration on the traced right-hand side."""

from math import inf, isfinite, nan
from typing import Any

from ...algebra.late import np
from .base import Demand, StepError, Stepper


class SciPy(Stepper):
    """The method of SciPy that has the name of the class. The right-hand side is given Python
    floats, on which it runs three times as fast as on NumPy's (measured).
    """

    resumable = True
    remade = ("solver",)

    def begin(self, trajectory: Demand) -> None:
        step = trajectory.step
        if step:  # tolerances that any step meets
            self.options: dict[str, Any] = {"rtol": 0.5, "atol": 1e300, "max_step": step}
            self.options["first_step"] = min(step, self.goal - self.t)
        else:  # SciPy refuses an rtol below 100 times a float's epsilon
            limits = zip(self.scales, self.noise, strict=True)
            atol = [self.tolerance * s + q for s, q in limits]
            self.options = {"rtol": max(self.tolerance, 2.3e-14), "atol": atol}
            self.options["max_step"] = trajectory.longest_part * (self.goal - self.t)
        # SciPy's Runge-Kutta methods would look for their first step without end
        if not isfinite(sum(self.system.rates(self.t, self.x))):
            raise StepError("the rates are not finite")
        self.solver, self.calls_before = self._from_here(), 1

    def resume(self) -> None:
        self.solver, self.calls_before = self._from_here(), self.calls

    def _from_here(self):
        """SciPy's solver from the present state to the next stop."""
        from scipy import integrate

        f, p = self.system.folded_rates, self.system.constants

        def rates(t, y):
            # SciPy does not know singular places: nan as a rate makes its step fail
            try:
                return f(t, *y.tolist(), *p)
            except (ArithmeticError, ValueError):
                return [nan] * len(y)

        make = getattr(integrate, type(self).__name__)
        return make(rates, self.t, self.x, self.around_stop()[0], **self.options)

    def step(self, limit: float = inf) -> None:
        while limit > 0 and self.t < self.goal:
            solver = self.solver
            message = solver.step()
            if solver.status == "failed" or not isfinite(solver.y.sum()):
                raise StepError(message or "the states are not finite")
            self.steps.append((solver.dense_output(), *self.x))
            self.t, self.x, limit = float(solver.t), tuple(solver.y.tolist()), limit - 1
            before, after = self.around_stop()
            if self.t == before < after:
                self.pass_stop(after)
                self.calls_before += 2
            self.step_times.append(self.t)
            self.update_scales()
            self.check_progress()
            self.calls = self.calls_before + solver.nfev
            if solver.status == "finished" and self.t < self.goal:
                self.solver, self.calls_before = self._from_here(), self.calls

    def step_end(self, n: int) -> float:
        return float(self.steps[n][0].t_max)

    def interpolate(self, n: int, times: "np.ndarray") -> "np.ndarray":
        return self.steps[n][0](times)


class DOP853(SciPy):
    """SciPy's Runge-Kutta method of order 8."""


class RK45(SciPy):
    """SciPy's Runge-Kutta method of order 5."""


class LSODA(SciPy):
    """SciPy's method of Adams and of backward differences."""


class Radau(SciPy):
    """SciPy's implicit Runge-Kutta method of order 5."""
