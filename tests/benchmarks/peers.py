"""Rivals on the two scenes of the benchmarks, each as a good user of it would write them: the
nutating top and the free body.

A :class:`Rival` runs the scene at a setting, a tolerance or a number of steps, and returns its last
state; :func:`loosest` finds the setting whose true error is small enough. Errors are measured in
what every model of a scene has: for the top the height of its axis and its rate, for the free body
the three rates. What a peer needs is imported when the peer is made; without it only that peer is
missing.
"""

import importlib.util
import math
import warnings
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from time import perf_counter

import numpy as np

TOLERANCES = tuple(10.0**-n for n in range(3, 16))
LEAST = 3e-14  # SciPy warns of a smaller rtol
STEPS = tuple(125 * 2**n for n in range(11))
THETA, SPIN = 0.6, 8.0  # of the top, with I0 = 1, I = 1.5 about its point of support, mgr = 5
# quaternion of the body and its rates
TOP, TOP_TIME = [math.cos(THETA / 2), math.sin(THETA / 2), 0.0, 0.0, 0.0, 0.0, SPIN], 10.0
FREE, FREE_TIME = [0.01, 1.0, 0.01], 50.0
TOP_ANGLES = [0.0, THETA, 0.0, 0.0, 0.0, SPIN]  # psi, theta, phi and the body rates
# moments about the centre of mass; and m, g, r
CENTRAL, WEIGHTY = (0.75, 0.75, 1.5), (0.75, 0.75, 1.5, 1.0, 10.0, 0.5)
UPRIGHT = [1.0, 0.0, 0.0, 0.0]


@dataclass(frozen=True)
class Rival:
    """``run(setting)``: the last state; ``settings`` from the loosest on; ``prepared`` in seconds."""

    run: Callable
    observed: Callable
    settings: tuple
    prepared: float

    def error(self, setting, exact):
        """The largest difference from the exact values."""
        return float(abs(self.observed(self.run(setting)) - exact).max())


@contextmanager
def quiet():
    """Without the warnings of other packages and of settings that are too loose."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def prepared(make, observed, settings=TOLERANCES):
    """The rival made by ``make``, run once: mostly derivation and compilation."""
    begun = perf_counter()
    with quiet():
        run = make()
        run(settings[0])
    return Rival(run, observed, settings, perf_counter() - begun)


def loosest(rival, exact, wanted):
    """The first setting that is accurate enough, and its true error; None where there is none."""
    with quiet():
        errors = ((setting, rival.error(setting, exact)) for setting in rival.settings)
        return next((pair for pair in errors if pair[1] <= wanted), None)


def have(*modules):
    """True if all of these can be imported."""
    return all(importlib.util.find_spec(name) for name in modules)


# -- what is compared


def axis(x):
    """The height cos(theta) of the top's axis, and its rate over the spin, in any frame of the axis."""
    a, b, c, d, wx, wy = x[:6]
    rate = 2 * (wy * (b * d - a * c) - wx * (c * d + a * b))
    return np.array([a * a + d * d - b * b - c * c, rate / SPIN])


def axis_of_angle(theta, rate):
    """The same from theta and its rate."""
    return np.array([math.cos(theta), -math.sin(theta) * rate / SPIN])


def rates(x):
    """The three body rates, which come last in a state."""
    return np.array(x)[-3:]


# -- SciPy, and diffrax with the same right-hand sides


def free_rates(xp):
    """Euler's equations as a user writes them, with the functions of NumPy or jax.numpy."""
    I = xp.array([1.0, 2.0, 3.0])
    return lambda t, w, args=None: -xp.cross(w, I * w) / I


def top_rates(xp):
    """Quaternion and body rates of the top, the weight 5 along -Z at the unit distance along z."""
    I, down, along = map(xp.array, ([1.0, 1.0, 1.5], [0.0, 0.0, -5.0], [0.0, 0.0, 1.0]))

    def rhs(t, y, args=None):
        q, w = y[:4], y[4:]
        v = q[1:]
        dq = 0.5 * xp.concatenate((xp.array([-v @ w]), q[0] * w + xp.cross(v, w)))
        # in the body
        weight = down - 2 * q[0] * xp.cross(v, down) + 2 * xp.cross(v, xp.cross(v, down))
        return xp.concatenate((dq, (xp.cross(along, weight) - xp.cross(w, I * w)) / I))

    return rhs


def scipy_alone(rhs, t, y, method="DOP853"):
    """SciPy's solve_ivp, rtol = atol."""
    from scipy.integrate import solve_ivp

    return lambda tolerance: solve_ivp(
        rhs, (0, t), y, method=method, rtol=max(tolerance, LEAST), atol=tolerance
    ).y[:, -1]


def diffrax_alone(rates_by, t, y, solver):
    """Diffrax in double precision, compiled as a whole; the tolerance stays an argument."""
    import diffrax
    import jax

    jax.config.update("jax_enable_x64", True)
    term, start = diffrax.ODETerm(rates_by(jax.numpy)), jax.numpy.array(y)

    @jax.jit
    def run(tolerance):
        control = diffrax.PIDController(rtol=tolerance, atol=tolerance)
        method, given = getattr(diffrax, solver)(), {"max_steps": 100_000, "throw": False}
        return diffrax.diffeqsolve(
            term, method, 0.0, t, None, start, stepsize_controller=control, **given
        ).ys[-1]

    return lambda tolerance: np.asarray(run(tolerance))


# -- heyoka by itself


def heyoka_alone(equations, y, t):
    """Heyoka with the scene's numbers in its equations, compiled once for each tolerance."""
    import heyoka as hy

    made = {}

    def run(tolerance):
        if tolerance not in made:
            made[tolerance] = hy.taylor_adaptive(equations, y, tol=tolerance)
        ta = made[tolerance]
        ta.time = 0.0
        ta.state[:] = y
        ta.propagate_until(t)
        return ta.state

    return run


def turning(a, b, c, d, x, y, z):
    """The rates of a quaternion with body rates x, y, z."""
    return [(a, -0.5 * (b * x + c * y + d * z)), (b, 0.5 * (a * x + c * z - d * y)),
            (c, 0.5 * (a * y + d * x - b * z)), (d, 0.5 * (a * z + b * y - c * x))]  # fmt: skip


def heyoka_top():
    """The full model, quaternion and three body rates, as for a body without symmetry."""
    import heyoka as hy

    a, b, c, d, x, y, z = hy.make_vars(*"abcdxyz")
    kx, ky = 2.0 * (b * d - a * c), 2.0 * (c * d + a * b)
    own = (x, 5.0 * ky - 0.5 * y * z), (y, 0.5 * z * x - 5.0 * kx), (z, 0.0 * z)
    return [*turning(a, b, c, d, x, y, z), *own]


def heyoka_free(full=True):
    """The free body with its quaternion, or its rates alone."""
    import heyoka as hy

    a, b, c, d, x, y, z = hy.make_vars(*"abcdxyz")
    own = (x, -y * z), (y, z * x), (z, -x * y / 3.0)
    return [*(turning(a, b, c, d, x, y, z) if full else ()), *own]


# -- Kane's method by SymPy, and PyDy, which compiles it by Cython


def kanes_method(weight):
    """A body about a fixed point, angles 3-1-3 and body rates: KanesMethod, and its constants."""
    import sympy.physics.mechanics as me
    from sympy import cos, sin, symbols

    _, theta, phi = turned = me.dynamicsymbols("psi theta phi")
    wx, wy, wz = w = me.dynamicsymbols("w_x w_y w_z")
    inertias, (m, g, r) = symbols("A B C"), symbols("m g r") if weight else (1, 0, 0)
    ground = me.ReferenceFrame("N")
    body = ground.orientnew("body", "Body", turned, "313")
    # solved by hand: SymPy's own solution divides by sin(phi) too
    precession = (wx * sin(phi) + wy * cos(phi)) / sin(theta)
    changes = precession, wx * cos(phi) - wy * sin(phi), wz - precession * cos(theta)
    kinematic = [q.diff() - change for q, change in zip(turned, changes, strict=True)]
    body.set_ang_vel(ground, wx * body.x + wy * body.y + wz * body.z)
    O = me.Point("O")
    O.set_vel(ground, 0)
    G = O.locatenew("G", r * body.z)
    G.v2pt_theory(O, ground, body)
    rigid = me.RigidBody("body", G, body, m, (me.inertia(body, *inertias), G))
    kane = me.KanesMethod(ground, list(turned), list(w), kd_eqs=kinematic)
    kane.kanes_equations([rigid], [(G, -m * g * ground.z)] if weight else [])
    return kane, (*inertias, m, g, r) if weight else inertias


def pydy_system(constants, start, t):
    """PyDy's System, compiled; constants: three moments, and m, g, r for a weight."""
    from pydy.system import System

    kane, symbols = kanes_method(weight=len(constants) > 3)
    values = dict(zip(symbols, constants, strict=True))
    begin = dict(zip((*kane.q, *kane.u), start, strict=True))
    system = System(kane, values, initial_conditions=begin, times=np.array([0.0, t]))
    system.generate_ode_function(generator="cython")
    return system


def first_top_by_sympy():
    """From equations to motion by Kane's method, lambdify and solve_ivp, within 1e-6."""
    from scipy.integrate import solve_ivp
    from sympy import lambdify

    kane, symbols = kanes_method(weight=True)
    system = kane.mass_matrix_full, kane.forcing_full
    equations = lambdify((*kane.q, *kane.u, *symbols), system, cse=True)

    def rhs(t, y):
        M, f = equations(*y, *WEIGHTY)
        return np.linalg.solve(M, f)[:, 0]

    return solve_ivp(rhs, (0, TOP_TIME), TOP_ANGLES, method="DOP853", rtol=1e-8, atol=1e-8).y[:, -1]


def pydy_odeint(system):
    """As PyDy's System integrates by itself."""
    return lambda tolerance: system.integrate(rtol=tolerance, atol=tolerance, mxstep=100_000)[-1]


def pydy_dop853(system):
    """Its compiled right-hand side in solve_ivp."""
    f, p = system.evaluate_ode_function, system.constants
    start = [system.initial_conditions[q] for q in system.states]
    return scipy_alone(lambda t, y: f(y, t, p), system.times[-1], start)


def axis_of_angles(x):
    """What :func:`axis` returns, from the angles psi, theta, phi and the body rates."""
    _, theta, phi, wx, wy, _ = x
    return axis_of_angle(theta, wx * math.cos(phi) - wy * math.sin(phi))


# -- MuJoCo: a ball joint, Runge-Kutta of order four, the loop in C


MUJOCO = """<mujoco><option integrator="RK4" gravity="0 0 {g}"><flag constraint="disable"/></option><worldbody><body>
<joint type="ball"/><inertial pos="0 0 {r}" mass="1" diaginertia="{moments}"/></body></worldbody></mujoco>"""


def mujoco_alone(moments, r, g, quaternion, w, t):
    """MuJoCo with this many steps; its quaternion and body rates."""
    import mujoco

    text = MUJOCO.format(g=-g, r=r, moments=" ".join(map(str, moments)))
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)

    def run(steps):
        model.opt.timestep = t / steps
        mujoco.mj_resetData(model, data)
        data.qpos[:], data.qvel[:] = quaternion, w
        mujoco.mj_step(model, data, nstep=steps)
        return np.concatenate((data.qpos, data.qvel))

    return run


# -- all of a scene


def top_rivals():
    """Those that are installed, by name."""
    return _rivals(
        axis, top_rates, TOP, TOP_TIME, {"full model": lambda: (heyoka_top(), TOP)},
        (WEIGHTY, TOP_ANGLES, axis_of_angles), (CENTRAL, 0.5, 10.0, TOP[:4], TOP[4:]),
    )  # fmt: skip


def free_rivals():
    """Those installed, by name; PyDy's angles begin far from their singular point."""
    angles, moments = [0.0, math.pi / 2, 0.0, *FREE], (1.0, 2.0, 3.0)
    heyokas = {
        "full model": lambda: (heyoka_free(), [*UPRIGHT, *FREE]),
        "rates alone": lambda: (heyoka_free(full=False), FREE),
    }
    return _rivals(
        rates, free_rates, FREE, FREE_TIME, heyokas,
        (moments, angles, rates), (moments, 0.0, 0.0, UPRIGHT, FREE),
    )  # fmt: skip


def _rivals(observed, rates_by, start, t, heyokas, of_pydy, of_mujoco):
    """All rivals on one scene.

    heyokas : {name: a function that returns equations and the start}; of_pydy : constants, start and
        what is compared; of_mujoco : the arguments of :func:`mujoco_alone` except the time
    """
    alone = lambda m: scipy_alone(rates_by(np), t, start, m)
    makers = {f"SciPy {m}, np.cross": partial(alone, m) for m in ("DOP853", "LSODA")}
    if have("heyoka"):
        alone = lambda scene: heyoka_alone(*scene(), t)
        makers |= {f"heyoka, {name}": partial(alone, scene) for name, scene in heyokas.items()}
    if have("diffrax"):
        alone = partial(diffrax_alone, rates_by, t, start)
        makers |= {f"diffrax {s}": partial(alone, s) for s in ("Tsit5", "Dopri8")}
    out = {name: prepared(make, observed) for name, make in makers.items()}
    if have("mujoco"):
        out["MuJoCo RK4"] = prepared(lambda: mujoco_alone(*of_mujoco, t), observed, STEPS)
    return out | (_pydy(*of_pydy, t) if have("pydy", "Cython") else {})


def _pydy(constants, start, observed, t):
    """One compiled system, run by both integrators."""
    begun = perf_counter()
    with quiet():
        system = pydy_system(constants, start, t)
    took = perf_counter() - begun
    runs = {"PyDy odeint, Cython": pydy_odeint(system), "PyDy DOP853, Cython": pydy_dop853(system)}
    return {name: Rival(run, observed, TOLERANCES, took) for name, run in runs.items()}
