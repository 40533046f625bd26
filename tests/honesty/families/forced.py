"""Rates that depend on time: pulses, switches, resonance, late starts."""

from newton_euler import cos, exp, sin, sqrt, tanh
from tests.honesty import closed_forms
from tests.honesty.cases import Log, around, by_accelerations, by_rates, family


def _pulse(rng, k, x, middle=0.2):
    """A spring pushed by a pulse that lasts a few thousandths to a tenth of the time."""
    T = rng.uniform(5.0, 30.0)
    width = T * rng.decades(2e-3, 5e-2)  # a shorter one is missed by a thousand samples
    parameters = rng.parameters(k=k, A=(0.5, 2.0)) | {"tp": T * rng.uniform(middle, 0.8)}

    def accelerations(s, p, t):
        u = (t - p.tp) / p.w
        return (p.A / p.w * exp(-u * u) - p.k * s.x,)

    knots = around(parameters["tp"], width / 2, 22)
    start = rng.values(x, 0.0)
    return by_accelerations(accelerations, parameters | {"w": width}, "x", T, start, knots=knots)


@family("forced")
def narrow_pulse(rng):
    """An oscillator that gets one short push on the way."""
    return _pulse(rng, 1.0, (-0.1, 0.1))


@family("forced")
def pulse_on_rest(rng):
    """A short push on a system at rest: nothing before shows that it will come."""
    return _pulse(rng, (0.2, 2.0), 0.0, 0.3)


@family("forced")
def sharp_switch(rng):
    """A force that is switched on by a steep hyperbolic tangent."""
    T = rng.uniform(5.0, 20.0)
    parameters = rng.parameters(k=(0.5, 4.0), F=(0.5, 2.0)) | {"ts": T * rng.uniform(0.2, 0.8)}
    parameters |= rng.parameters(w=Log(1e-4, 1e-1), one=1.0)
    a = lambda s, p, t: (p.F * (p.one + tanh((t - p.ts) / p.w)) / 2 - p.k * s.x,)
    knots = around(parameters["ts"], parameters["w"], 55)
    return by_accelerations(a, parameters, "x", T, rng.values((-1.0, 1.0), 0.0), knots=knots)


@family("forced")
def near_resonance(rng):
    """An oscillator driven at nearly its own frequency, from rest."""
    w, F = rng.values((0.5, 5.0), Log(1e-3, 1.0))
    parameters = {"k": w * w, "F": F, "q": w * (1 + rng.either(rng.decades(1e-3, 0.1)))}
    a = lambda s, p, t: (p.F * cos(p.q * t) - p.k * s.x,)

    def exact(mp, s, p, t):
        return closed_forms.driven(mp, mp.sqrt(p.k), p.F, p.q, s.x, s.dx, t)

    T = rng.uniform(10.0, 150.0) / w
    return by_accelerations(a, parameters, "x", T, (0.0, 0.0), exact=exact)


@family("forced")
def rising_tone(rng):
    """An oscillator driven by cos(a t^2), through the resonance."""
    parameters = rng.parameters(k=(4.0, 40.0), c=(0.02, 0.2), F=1.0, a=Log(0.05, 0.5))
    a = lambda s, p, t: (p.F * cos(p.a * t * t) - p.k * s.x - p.c * s.dx,)
    T, x = rng.values((5.0, 25.0), (-0.5, 0.5))
    return by_accelerations(a, parameters, "x", T, (x, 0.0))


@family("forced")
def mathieu(rng):
    """A spring whose stiffness varies, stable or not."""
    parameters = rng.parameters(a=(0.2, 3.0), q=(0.1, 1.0))
    a = lambda s, p, t: (-(p.a - 2 * p.q * cos(2 * t)) * s.x,)
    T, v = rng.values((5.0, 30.0), (-1.0, 1.0))
    return by_accelerations(a, parameters, "x", T, (1.0, v))


@family("forced", "late")
def late_beginning(rng):
    """A driven oscillator watched from a late start, when the clock shows large numbers."""
    begin = rng.decades(1e2, 1e6)
    parameters = rng.parameters(k=(1.0, 10.0), c=0.1, F=1.0, w=(0.5, 3.0))
    a = lambda s, p, t: (p.F * cos(p.w * t) - p.k * s.x - p.c * s.dx,)
    T, *start = rng.values((3.0, 20.0), (-1.0, 1.0), (-1.0, 1.0))
    return by_accelerations(a, parameters, "x", begin + T, start, t0=begin)


@family("forced", "late")
def shrinking_string(rng):
    """A pendulum whose string is drawn in steadily, watched from a late start (Ehrenfest)."""

    def rates(s, p, t):
        length = p.L - p.v * t
        return s.omega, (2 * p.v * s.omega - p.g * sin(s.theta)) / length

    parameters = rng.parameters(L=1.0, v=(0.01, 0.04), g=9.81)
    begin, T, theta = rng.values((0.5, 2.0), (3.0, 18.0), (0.1, 1.5))
    return by_rates(rates, parameters, "theta omega", begin + T, (theta, 0.0), t0=begin)


@family("forced")
def thrust_programme(rng):
    """A rocket that burns for a while by a smooth programme and climbs against gravity and air."""
    parameters = rng.parameters(
        g=9.81,
        u=(1500.0, 3000.0),
        q=(0.05, 0.2),
        c=Log(1e-6, 1e-4),
        tb=(8.0, 15.0),
        one=1.0,
        H=8000.0,
        w=(0.05, 0.5),
        tiny=1.0,
    )

    def rates(s, p, t):
        burning = p.q * (p.one - tanh((t - p.tb) / p.w)) / 2
        air = p.c * exp(-s.h / p.H) * sqrt(s.v * s.v + p.tiny) * s.v
        return s.v, (p.u * burning - air) / s.m - p.g, -burning

    T, m = rng.values((15.0, 40.0), (4.0, 10.0))
    knots = around(parameters["tb"], parameters["w"], 55)
    return by_rates(rates, parameters, "h v m", T, (0.0, 0.0, m), knots=knots)
