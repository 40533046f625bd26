"""Control loops: relays, thermostats, pulse widths, limits, observers."""

import math

from newton_euler import Event, Model, cos, sin, where
from tests.honesty.cases import Case, Log, by_accelerations, by_rates, held_out


@held_out("kinked")
def escapement(rng):
    """A clock: a constant push in the direction of the swing, and damping."""
    parameters = rng.parameters(k=(1.0, 30.0), c=(0.05, 0.5), F=(0.01, 0.1))
    a = lambda s, p, t: (where(s.dx > 0, p.F, -p.F) - p.c * s.dx - p.k * s.x,)
    T, x = rng.values((3.0, 12.0), (0.3, 1.0))
    return by_accelerations(a, parameters, "x", T, (x, 0.0))


@held_out("kinked")
def relay_round_three_lags(rng):
    """A relay on the output of three lags: it oscillates for ever, crossing its switch cleanly."""
    a, U = rng.values(Log(0.3, 10.0), Log(1e-2, 1e2))

    def rates(s, p, t):
        u = where(s.z > 0, -p.U, p.U)
        return p.a * (u - s.x), p.a * (s.x - s.y), p.a * (s.y - s.z)

    T, z = rng.values((5.0, 25.0), (0.1, 1.0))
    return by_rates(rates, {"a": a, "U": U}, "x y z", T / a, (0.0, 0.0, U * z))


@held_out("events", "kinked")
def thermostat(rng):
    """A heater that is a state of its own, 0 or 1, switched by two events."""
    parameters = {"tau": rng.decades(0.5, 5.0) * 3600}
    parameters |= rng.parameters(gain=(25.0, 50.0), out=(-10.0, 5.0), low=19.0, high=21.0)
    rates = lambda s, p, t: ((p.out + p.gain * s.on - s.T) / p.tau, 0.0 * s.on)
    then = lambda s, p, t: (model, (s.T, 1 - s.on))
    model = Model("thermostat", parameters, ("T", "on"), rates)
    cold = Event(lambda s, p, t: s.T - p.low, -1, then=then, name="cold")
    warm = Event(lambda s, p, t: s.T - p.high, 1, then=then, name="warm")
    T, start = rng.values((0.3, 1.5), (19.2, 20.8))
    T, start = parameters["tau"] * T, (start, rng.choice((0.0, 1.0)))
    return Case(model, T, start, events=(cold, warm))


@held_out("kinked")
def pid_with_a_limit(rng):
    """A PID whose output saturates and whose integrator stops in the meantime, by nested where."""
    parameters = rng.parameters(kp=(2.0, 8.0), ki=(0.5, 3.0), kd=(0.5, 2.0))
    parameters |= rng.parameters(U=(0.8, 2.0), goal=(0.5, 4.0), c=0.2)

    def rates(s, p, t):
        u = p.kp * (p.goal - s.x) + p.ki * s.i - p.kd * s.v
        limited = where(u > p.U, p.U, where(u < -p.U, -p.U, u))
        grows = where(u > p.U, 0.0, where(u < -p.U, 0.0, p.goal - s.x))
        return s.v, limited - p.c * s.v, grows

    return by_rates(rates, parameters, "x v i", rng.uniform(3.0, 10.0), (0.0, 0.0, 0.0))


@held_out("kinked", "forced")
def motor_on_pulses(rng):
    """A motor fed by pulses of some width: current, speed and angle."""
    T, n, duty = rng.uniform(0.05, 0.2), rng.randint(4, 9), rng.uniform(0.2, 0.8)
    parameters = rng.parameters(U=12.0, R=(0.5, 2.0), L=Log(1e-3, 1e-2), K=0.05, J=Log(1e-5, 1e-3))
    parameters |= {"w": 2 * math.pi * n / T, "level": math.sin(math.pi * (0.5 - duty))}

    def rates(s, p, t):
        u = where(sin(p.w * t) > p.level, p.U, 0)
        return s.speed, p.K * s.i / p.J, (u - p.R * s.i - p.K * s.speed) / p.L

    knots = tuple(T * k / (4 * n) for k in range(1, 4 * n))
    return by_rates(rates, parameters, "phi speed i", T, (0.0, 0.0, 0.0), knots=knots)


@held_out("smooth", "equilibrium")
def balanced_pole(rng):
    """A pole on a cart, put upright by four gains."""
    parameters = rng.parameters(
        M=1.0, m=(0.05, 0.3), L=(0.3, 1.0), g=9.81, kx=1.0, kv=2.0, ka=(35.0, 60.0), kw=(8.0, 14.0)
    )

    def accelerations(s, p, t):
        F = p.kx * s.x + p.kv * s.dx + p.ka * s.a + p.kw * s.da
        k, c = sin(s.a), cos(s.a)
        x = (F + p.m * k * (p.L * s.da * s.da - p.g * c)) / (p.M + p.m * k * k)
        return x, (p.g * k - x * c) / p.L

    T, a = rng.values((2.0, 20.0), Log(1e-6, 0.5))
    return by_accelerations(accelerations, parameters, "x a", T, (0.0, rng.either(a), 0.0, 0.0))


@held_out("smooth", "multi-scale")
def observer(rng):
    """A pendulum, and an observer that starts almost right and gets better and better."""
    off = rng.decades(1e-10, 1e-1)

    def rates(s, p, t):
        e = s.th - s.est
        return s.w, -p.k * sin(s.th), s.west + p.l1 * e, -p.k * sin(s.est) + p.l2 * e

    parameters = rng.parameters(k=(1.0, 20.0), l1=(2.0, 10.0), l2=15.0)
    th, T = rng.values((0.2, 2.0), (3.0, 20.0))
    return by_rates(rates, parameters, "th w est west", T, (th, 0.0, th + off, 0.0))


@held_out("kinked", "stiff")
def sliding_mode_in_a_layer(rng):
    """A sliding mode whose sign is a steep ramp with limits."""
    parameters = rng.parameters(
        U=(2.0, 5.0), lam=(0.5, 3.0), e=Log(1e-3, 1e-1), d=(0.1, 1.0), w=(0.5, 3.0)
    )

    def accelerations(s, p, t):
        z = (s.dx + p.lam * s.x) / p.e
        return (p.d * sin(p.w * t) - p.U * where(z > 1, 1, where(z < -1, -1, z)),)

    T, x = rng.values((2.0, 8.0), (0.5, 3.0))
    return by_accelerations(accelerations, parameters, "x", T, (rng.either(x), 0.0))


@held_out("kinked", "sticking")
def valve_at_its_stop(rng):
    """A valve that is driven to its stop, waits there, and comes back."""
    A, w, stop, T = rng.values(Log(0.1, 10.0), Log(0.1, 10.0), (0.3, 0.9), (1.3, 1.49))

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

    parameters = {"A": A, "w": w, "stop": A / w * stop}
    return by_rates(rates, parameters, "x", T * math.pi / w, (0.0,), exact=exact)


@held_out("smooth")
def phase_locked_loop(rng):
    """A loop that slips some cycles before it locks, or never does."""
    parameters = rng.parameters(dw=(0.5, 4.0), K=(0.5, 2.0), a=(0.1, 0.5))
    rates = lambda s, p, t: (p.dw - p.K * sin(s.e) - p.a * s.i, sin(s.e))
    T, e = rng.values((10.0, 80.0), (-3.0, 3.0))
    return by_rates(rates, parameters, "e i", T, (e, 0.0))
