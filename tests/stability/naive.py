"""What a user of SciPy writes: solve_ivp with the rates of a model."""

from scipy.integrate import solve_ivp

TIGHT = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-10}


def solved(model, t, start, **options):
    """The solution from 0 to ``t`` as SciPy returns it."""
    values = tuple(model.parameters.values())
    rhs = model.compiled_rhs(*model.parameters)
    return solve_ivp(lambda t, y: rhs(t, *y.tolist(), *values), (0.0, t), start, **options)
