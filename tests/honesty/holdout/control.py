"""Loops of control: relays, thermostats, pulse widths, limits, observers."""

import math

from newton_euler import Event, Model, cos, sin, where
from newton_euler.motion import second_order
from tests.honesty.cases import Branches, Case, decades, either, held_out


@held_out("kinked")
def escapement(rng):
    """A clock: a constant push in the direction of the swing, and damping."""
    parameters = {
        "k": rng.uniform(1.0, 30.0),
        "c": rng.uniform(0.05, 0.5),
        "F": rng.uniform(0.01, 0.1),
    }
    model = second_order(
        "clock",
        parameters,
        ("x",),
        lambda s, p, t: (where(s.dx > 0, p.F, -p.F) - p.c * s.dx - p.k * s.x,),
    )
    branches = Branches(
        (lambda s, p, t: s.dx,),
        lambda s, p, t, b: (s.dx, b[0] * p.F - p.c * s.dx - p.k * s.x),
    )
    return Case(model, rng.uniform(3.0, 12.0), (rng.uniform(0.3, 1.0), 0.0), branches=branches)


@held_out("kinked")
def relay_round_three_lags(rng):
    """A relay on the output of three lags: it swings for ever, and crosses its switch cleanly."""
    parameters = {"a": decades(rng, 0.3, 10.0), "U": decades(rng, 1e-2, 1e2)}

    def rates(s, p, t):
        u = where(s.z > 0, -p.U, p.U)
        return p.a * (u - s.x), p.a * (s.x - s.y), p.a * (s.y - s.z)

    branches = Branches(
        (lambda s, p, t: s.z,),
        lambda s, p, t, b: (p.a * (-b[0] * p.U - s.x), p.a * (s.x - s.y), p.a * (s.y - s.z)),
    )
    return Case(
        Model("relay", parameters, ("x", "y", "z"), rates),
        rng.uniform(5.0, 25.0) / parameters["a"],
        (0.0, 0.0, parameters["U"] * rng.uniform(0.1, 1.0)),
        branches=branches,
    )


@held_out("events", "kinked")
def thermostat(rng):
    """A heater that is a state of its own, 0 or 1, switched by two events."""
    parameters = {
        "tau": decades(rng, 0.5, 5.0) * 3600,
        "gain": rng.uniform(25.0, 50.0),
        "out": rng.uniform(-10.0, 5.0),
        "low": 19.0,
        "high": 21.0,
    }

    def rates(s, p, t):
        return (p.out + p.gain * s.on - s.T) / p.tau, 0.0 * s.on

    def flipped(s, p, t):
        return s.T, 1 - s.on

    def then(s, p, t):
        return model, (s.T, 1 - s.on)

    model = Model("thermostat", parameters, ("T", "on"), rates)
    cold = Event(lambda s, p, t: s.T - p.low, -1, then=then, name="cold")
    warm = Event(lambda s, p, t: s.T - p.high, 1, then=then, name="warm")
    return Case(
        model,
        parameters["tau"] * rng.uniform(0.3, 1.5),
        (rng.uniform(19.2, 20.8), rng.choice((0.0, 1.0))),
        events=(cold, warm),
        impact=flipped,
    )


@held_out("kinked")
def pid_with_a_limit(rng):
    """A PID whose output saturates and whose integrator stops meanwhile, by nested where."""
    parameters = {
        "kp": rng.uniform(2.0, 8.0),
        "ki": rng.uniform(0.5, 3.0),
        "kd": rng.uniform(0.5, 2.0),
        "U": rng.uniform(0.8, 2.0),
        "goal": rng.uniform(0.5, 4.0),
        "c": 0.2,
    }

    def asked(s, p):
        return p.kp * (p.goal - s.x) + p.ki * s.i - p.kd * s.v

    def rates(s, p, t):
        u = asked(s, p)
        held = where(u > p.U, p.U, where(u < -p.U, -p.U, u))
        grows = where(u > p.U, 0.0, where(u < -p.U, 0.0, p.goal - s.x))
        return s.v, held - p.c * s.v, grows

    def pieces(s, p, t, b):
        free, above, below = (1 - b[0]) * (1 + b[1]) / 4, (1 + b[0]) / 2, (1 - b[1]) / 2
        return s.v, (above - below) * p.U + free * asked(s, p) - p.c * s.v, free * (p.goal - s.x)

    switches = lambda s, p, t: asked(s, p) - p.U, lambda s, p, t: asked(s, p) + p.U
    return Case(
        Model("PID", parameters, ("x", "v", "i"), rates),
        rng.uniform(3.0, 10.0),
        (0.0, 0.0, 0.0),
        branches=Branches(switches, pieces),
    )


@held_out("kinked", "forced")
def motor_on_pulses(rng):
    """A motor fed by pulses of some width: current, speed and angle."""
    T = rng.uniform(0.05, 0.2)
    n = rng.randint(4, 9)
    duty = rng.uniform(0.2, 0.8)
    parameters = {
        "U": 12.0,
        "R": rng.uniform(0.5, 2.0),
        "L": decades(rng, 1e-3, 1e-2),
        "K": 0.05,
        "J": decades(rng, 1e-5, 1e-3),
        "w": 2 * math.pi * n / T,
        "level": math.sin(math.pi * (0.5 - duty)),
    }

    def electric(s, p, u):
        return s.speed, p.K * s.i / p.J, (u - p.R * s.i - p.K * s.speed) / p.L

    branches = Branches(
        (lambda s, p, t: sin(p.w * t) - p.level,),
        lambda s, p, t, b: electric(s, p, p.U * (1 + b[0]) / 2),
    )
    return Case(
        Model(
            "motor",
            parameters,
            ("phi", "speed", "i"),
            lambda s, p, t: electric(s, p, where(sin(p.w * t) > p.level, p.U, 0)),
        ),
        T,
        (0.0, 0.0, 0.0),
        branches=branches,
        knots=tuple(T * k / (4 * n) for k in range(1, 4 * n)),
    )


@held_out("smooth", "equilibrium")
def balanced_pole(rng):
    """A pole on a cart, put upright by four gains."""
    parameters = {"M": 1.0, "m": rng.uniform(0.05, 0.3), "L": rng.uniform(0.3, 1.0), "g": 9.81}
    parameters |= {
        "kx": 1.0,
        "kv": 2.0,
        "ka": rng.uniform(35.0, 60.0),
        "kw": rng.uniform(8.0, 14.0),
    }

    def accelerations(s, p, t):
        F = p.kx * s.x + p.kv * s.dx + p.ka * s.a + p.kw * s.da
        k, c = sin(s.a), cos(s.a)
        x = (F + p.m * k * (p.L * s.da * s.da - p.g * c)) / (p.M + p.m * k * k)
        return x, (p.g * k - x * c) / p.L

    return Case(
        second_order("pole", parameters, ("x", "a"), accelerations),
        rng.uniform(2.0, 20.0),
        (0.0, either(rng, decades(rng, 1e-6, 0.5)), 0.0, 0.0),
    )


@held_out("smooth", "multi-scale")
def observer(rng):
    """A pendulum, and an observer that starts almost right and gets better and better."""
    off = decades(rng, 1e-10, 1e-1)
    parameters = {"k": rng.uniform(1.0, 20.0), "l1": rng.uniform(2.0, 10.0), "l2": 15.0}

    def rates(s, p, t):
        e = s.th - s.est
        return s.w, -p.k * sin(s.th), s.west + p.l1 * e, -p.k * sin(s.est) + p.l2 * e

    th = rng.uniform(0.2, 2.0)
    return Case(
        Model("observer", parameters, ("th", "w", "est", "west"), rates),
        rng.uniform(3.0, 20.0),
        (th, 0.0, th + off, 0.0),
    )


@held_out("kinked", "stiff")
def sliding_mode_in_a_layer(rng):
    """A sliding mode whose sign is a steep ramp with limits."""
    parameters = {
        "U": rng.uniform(2.0, 5.0),
        "lam": rng.uniform(0.5, 3.0),
        "e": decades(rng, 1e-3, 1e-1),
        "d": rng.uniform(0.1, 1.0),
        "w": rng.uniform(0.5, 3.0),
    }

    def accelerations(s, p, t):
        z = (s.dx + p.lam * s.x) / p.e
        return (p.d * sin(p.w * t) - p.U * where(z > 1, 1, where(z < -1, -1, z)),)

    def pieces(s, p, t, b):
        z = (s.dx + p.lam * s.x) / p.e
        held = (1 + b[0]) / 2 - (1 - b[1]) / 2 + (1 - b[0]) * (1 + b[1]) / 4 * z
        return s.dx, p.d * sin(p.w * t) - p.U * held

    switches = (
        lambda s, p, t: s.dx + p.lam * s.x - p.e,
        lambda s, p, t: s.dx + p.lam * s.x + p.e,
    )
    return Case(
        second_order("sliding mode", parameters, ("x",), accelerations),
        rng.uniform(2.0, 8.0),
        (either(rng, rng.uniform(0.5, 3.0)), 0.0),
        branches=Branches(switches, pieces),
    )


@held_out("kinked", "sticking")
def valve_at_its_stop(rng):
    """A valve that is driven to its stop, waits there, and comes back."""
    parameters = {"A": decades(rng, 0.1, 10.0), "w": decades(rng, 0.1, 10.0)}
    parameters["stop"] = parameters["A"] / parameters["w"] * rng.uniform(0.3, 0.9)

    def rates(s, p, t):
        u = p.A * cos(p.w * t)
        return (where(s.x >= p.stop, where(u > 0, 0.0, u), u),)

    def exact(mp, s, p, t):
        reach = p.A / p.w
        if t < mp.asin(p.stop / reach) / p.w:
            return (reach * mp.sin(p.w * t),)
        if t < mp.pi / 2 / p.w:
            return (p.stop,)
        return (p.stop + reach * (mp.sin(p.w * t) - 1),)

    return Case(
        Model("valve", parameters, ("x",), rates),
        rng.uniform(1.3, 1.49) * math.pi / parameters["w"],
        (0.0,),
        exact=exact,
    )


@held_out("smooth")
def phase_locked_loop(rng):
    """A loop that slips some cycles before it locks, or never does."""
    parameters = {
        "dw": rng.uniform(0.5, 4.0),
        "K": rng.uniform(0.5, 2.0),
        "a": rng.uniform(0.1, 0.5),
    }

    def rates(s, p, t):
        return p.dw - p.K * sin(s.e) - p.a * s.i, sin(s.e)

    return Case(
        Model("PLL", parameters, ("e", "i"), rates),
        rng.uniform(10.0, 80.0),
        (rng.uniform(-3.0, 3.0), 0.0),
    )
