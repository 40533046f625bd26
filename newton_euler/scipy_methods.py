"""SciPy's methods of integration on the traced right-hand side."""

import math

from .courses import StepError, Stepper, checkpoint_indices


class SciPy(Stepper):
    """One of SciPy's methods on the traced right-hand side, which takes Python's floats."""

    kind = "DOP853"

    def __init__(self, system, t, x, trajectory):
        super().__init__(system, t, x, trajectory)
        from scipy import integrate

        f, p, goal, tolerance, step = system.folded_rates, system.constants, self.goal, self.tolerance, trajectory.step
        fixed = {"max_step": step, "first_step": min(step, goal - t)} if step else {}
        atol = [1e300] * len(x) if step else [tolerance * s for s in self.scales]
        self.solver = getattr(integrate, self.kind)(
            lambda t, y: f(t, *y.tolist(), *p), t, x, goal, rtol=0.5 if step else max(tolerance, 2.3e-14), atol=atol, **fixed
        )
        self.pieces, self.passed = [], []

    def step(self, limit=math.inf):
        """Go on by at most so many steps."""
        solver = self.solver
        while limit > 0 and solver.status == "running":
            failed = solver.step()
            if solver.status == "failed":
                raise StepError(failed)
            self.pieces.append(solver.dense_output())
            self.step_times.append(solver.t)
            self.x = tuple(solver.y.tolist())
            self.passed.append(self.x)
            self.update_scales()
            self.t, limit = float(solver.t), limit - 1
            self.check_progress()
        self.t, self.calls = float(solver.t), solver.nfev

    @property
    def checkpoints(self):
        """See :class:`Course`."""
        return [(self.step_times[n + 1], self.passed[n]) for n in checkpoint_indices(len(self.passed))]

    def interpolate(self, at, times):
        """SciPy's dense output."""
        return self.pieces[at](times)


def scipy_method(kind):
    """The class of one of SciPy's methods, by its name there."""
    return type(kind, (SciPy,), {"kind": kind, "__doc__": f"SciPy's {kind}."})
