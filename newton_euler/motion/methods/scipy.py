"""SciPy's methods of integration on the traced right-hand side."""

from math import inf

from .base import StepError, Stepper


class SciPy(Stepper):
    """One of SciPy's methods; the right-hand side gets Python's floats, on which it runs three
    times faster than on NumPy's (measured).
    """

    def begin(self, trajectory):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        from scipy import integrate

        f, p, step = self.system.folded_rates, self.system.constants, trajectory.step
        if step:  # tolerances that any step fulfils
            options = {"rtol": 0.5, "atol": 1e300, "max_step": step}
            options["first_step"] = min(step, self.goal - self.t)
        else:  # SciPy refuses an rtol below 100 times a float's epsilon
            atol = [self.tolerance * s for s in self.scales]
            options = {"rtol": max(self.tolerance, 2.3e-14), "atol": atol}
        self.solver = getattr(integrate, type(self).__name__)(
            lambda t, y: f(t, *y.tolist(), *p), self.t, self.x, self.goal, **options
        )

    def step(self, limit=inf):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        solver = self.solver
        while limit > 0 and solver.status == "running":
            message = solver.step()
            if solver.status == "failed":
                raise StepError(message)
            self.steps.append((solver.dense_output(), *self.x))
            self.t, self.x, limit = float(solver.t), tuple(solver.y.tolist()), limit - 1
            self.step_times.append(self.t)
            self.update_scales()
            self.check_progress()
        self.calls = solver.nfev

    def interpolate(self, n, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        return self.steps[n][0](times)


def scipy_method(name):
    """The stepper of one of SciPy's methods, by its name there."""
    return type(name, (SciPy,), {"__doc__": f"SciPy's {name}."})
