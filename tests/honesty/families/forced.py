"""Rates that depend on time: pulses, switches, resonance, late beginnings."""

from newton_euler import Model, cos, exp, sin, sqrt, tanh
from newton_euler.motion import second_order
from tests.honesty import closed_forms
from tests.honesty.cases import Case, around, decades, either, family


@family("forced")
def narrow_pulse(rng):
    """A push that lasts a few thousandths to a tenth of the time, somewhere on the way."""
    T = rng.uniform(5.0, 30.0)
    width = T * decades(rng, 2e-3, 5e-2)  # a shorter one is missed by a thousand looks
    parameters = {"k": 1.0, "A": rng.uniform(0.5, 2.0), "tp": T * rng.uniform(0.2, 0.8), "w": width}

    def accelerations(s, p, t):
        u = (t - p.tp) / p.w
        return (p.A / p.w * exp(-u * u) - p.k * s.x,)

    knots = around(parameters["tp"], width / 2, 22)
    return Case(
        second_order("pulse", parameters, ("x",), accelerations),
        T,
        (rng.uniform(-0.1, 0.1), 0.0),
        knots=knots,
    )


@family("forced")
def pulse_on_rest(rng):
    """The same on a system at rest, of which nothing else tells that something happens."""
    T = rng.uniform(5.0, 30.0)
    width = T * decades(rng, 2e-3, 5e-2)
    parameters = {
        "k": rng.uniform(0.2, 2.0),
        "A": rng.uniform(0.5, 2.0),
        "tp": T * rng.uniform(0.3, 0.8),
        "w": width,
    }

    def accelerations(s, p, t):
        u = (t - p.tp) / p.w
        return (p.A / p.w * exp(-u * u) - p.k * s.x,)

    knots = around(parameters["tp"], width / 2, 22)
    return Case(
        second_order("pulse on rest", parameters, ("x",), accelerations), T, (0.0, 0.0), knots=knots
    )


@family("forced")
def sharp_switch(rng):
    """A force that is switched on by a steep hyperbolic tangent."""
    T = rng.uniform(5.0, 20.0)
    parameters = {
        "k": rng.uniform(0.5, 4.0),
        "F": rng.uniform(0.5, 2.0),
        "ts": T * rng.uniform(0.2, 0.8),
        "w": decades(rng, 1e-4, 1e-1),
        "one": 1.0,
    }

    def accelerations(s, p, t):
        return (p.F * (p.one + tanh((t - p.ts) / p.w)) / 2 - p.k * s.x,)

    knots = around(parameters["ts"], parameters["w"], 55)
    return Case(
        second_order("sharp switch", parameters, ("x",), accelerations),
        T,
        (rng.uniform(-1.0, 1.0), 0.0),
        knots=knots,
    )


@family("forced")
def near_resonance(rng):
    """Driven at nearly its own frequency, from rest."""
    w = rng.uniform(0.5, 5.0)
    parameters = {
        "k": w * w,
        "F": decades(rng, 1e-3, 1.0),
        "q": w * (1 + either(rng, decades(rng, 1e-3, 0.1))),
    }
    model = second_order(
        "near resonance", parameters, ("x",), lambda s, p, t: (p.F * cos(p.q * t) - p.k * s.x,)
    )

    def exact(mp, s, p, t):
        return closed_forms.driven(mp, mp.sqrt(p.k), p.F, p.q, s.x, s.dx, t)

    return Case(model, rng.uniform(10.0, 150.0) / w, (0.0, 0.0), exact=exact)


@family("forced")
def rising_tone(rng):
    """Driven by cos(a t^2), through the resonance."""
    parameters = {
        "k": rng.uniform(4.0, 40.0),
        "c": rng.uniform(0.02, 0.2),
        "F": 1.0,
        "a": decades(rng, 0.05, 0.5),
    }
    model = second_order(
        "rising tone",
        parameters,
        ("x",),
        lambda s, p, t: (p.F * cos(p.a * t * t) - p.k * s.x - p.c * s.dx,),
    )
    return Case(model, rng.uniform(5.0, 25.0), (rng.uniform(-0.5, 0.5), 0.0))


@family("forced")
def mathieu(rng):
    """A spring whose stiffness varies, stable or not."""
    parameters = {"a": rng.uniform(0.2, 3.0), "q": rng.uniform(0.1, 1.0)}
    model = second_order(
        "Mathieu", parameters, ("x",), lambda s, p, t: (-(p.a - 2 * p.q * cos(2 * t)) * s.x,)
    )
    return Case(model, rng.uniform(5.0, 30.0), (1.0, rng.uniform(-1.0, 1.0)))


@family("forced", "late")
def late_beginning(rng):
    """A driven oscillator watched from a late time on, where the clock shows large numbers."""
    begin = decades(rng, 1e2, 1e6)
    parameters = {"k": rng.uniform(1.0, 10.0), "c": 0.1, "F": 1.0, "w": rng.uniform(0.5, 3.0)}
    model = second_order(
        "late beginning",
        parameters,
        ("x",),
        lambda s, p, t: (p.F * cos(p.w * t) - p.k * s.x - p.c * s.dx,),
    )
    return Case(
        model,
        begin + rng.uniform(3.0, 20.0),
        (rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)),
        t0=begin,
    )


@family("forced", "late")
def shrinking_string(rng):
    """A pendulum whose string is drawn in, from some time on (Ehrenfest)."""
    parameters = {"L": 1.0, "v": rng.uniform(0.01, 0.04), "g": 9.81}

    def rates(s, p, t):
        length = p.L - p.v * t
        return s.omega, (2 * p.v * s.omega - p.g * sin(s.theta)) / length

    begin = rng.uniform(0.5, 2.0)
    return Case(
        Model("shrinking string", parameters, ("theta", "omega"), rates),
        begin + rng.uniform(3.0, 18.0),
        (rng.uniform(0.1, 1.5), 0.0),
        t0=begin,
    )


@family("forced")
def thrust_programme(rng):
    """A rocket that burns for a while by a smooth programme and climbs against gravity and air."""
    parameters = {
        "g": 9.81,
        "u": rng.uniform(1500.0, 3000.0),
        "q": rng.uniform(0.05, 0.2),
        "c": decades(rng, 1e-6, 1e-4),
        "tb": rng.uniform(8.0, 15.0),
        "one": 1.0,
    }
    parameters |= {"H": 8000.0, "w": rng.uniform(0.05, 0.5), "tiny": 1.0}

    def rates(s, p, t):
        burning = p.q * (p.one - tanh((t - p.tb) / p.w)) / 2
        air = p.c * exp(-s.h / p.H) * sqrt(s.v * s.v + p.tiny) * s.v
        return s.v, (p.u * burning - air) / s.m - p.g, -burning

    knots = around(parameters["tb"], parameters["w"], 55)
    return Case(
        Model("rocket", parameters, ("h", "v", "m"), rates),
        rng.uniform(15.0, 40.0),
        (0.0, 0.0, rng.uniform(4.0, 10.0)),
        knots=knots,
    )
