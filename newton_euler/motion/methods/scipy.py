"""SciPy's methods of integration on the traced right-hand side."""

from math import inf

from .base import StepError, Stepper


class SciPy(Stepper):
    """One of SciPy's methods; the right-hand side gets Python's floats, on which it runs three
    times faster than on NumPy's.
    """

    def __init__(self, system, t, x, trajectory):
        super().__init__(system, t, x, trajectory)
        from scipy import integrate

        f, p, goal, step = system.folded_rates, system.constants, self.goal, trajectory.step
        # SciPy's least rtol is 100 eps
        options = {
            "rtol": max(self.tolerance, 2.3e-14),
            "atol": [self.tolerance * s for s in self.scales],
        }
        if step:  # tolerances that any step fulfils
            options = {
                "rtol": 0.5,
                "atol": 1e300,
                "max_step": step,
                "first_step": min(step, goal - t),
            }
        self.solver = getattr(integrate, type(self).__name__)(
            lambda t, y: f(t, *y.tolist(), *p), t, x, goal, **options
        )
        self.polynomials = []

    def step(self, limit=inf):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        solver = self.solver
        while limit > 0 and solver.status == "running":
            message = solver.step()
            if solver.status == "failed":
                raise StepError(message)
            self.polynomials.append(solver.dense_output())
            self.steps.append(self.x)
            self.t, self.x, limit = float(solver.t), tuple(solver.y.tolist()), limit - 1
            self.step_times.append(self.t)
            self.update_scales()
            self.check_progress()
        self.calls = solver.nfev

    def interpolate(self, n, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        return self.polynomials[n](times)


def scipy_method(name):
    """The stepper of one of SciPy's methods, by its name there."""
    return type(name, (SciPy,), {"__doc__": f"SciPy's {name}."})
