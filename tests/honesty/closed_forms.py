"""Motions known in closed form, to any number of digits and over any number of periods: the
references where integration would take too long.

All take and return mpmath numbers; ``mp`` is mpmath, whose precision the caller sets.
"""


def oscillator(mp, w, x, v, t):
    """x'' = -w^2 x: x and v."""
    c, s = mp.cos(w * t), mp.sin(w * t)
    return x * c + v / w * s, v * c - w * x * s


def damped(mp, w, c, x, v, t):
    """x'' = -w^2 x - 2 c x', with c < w."""
    d = mp.sqrt(w * w - c * c)
    e, k, s = mp.exp(-c * t), mp.cos(d * t), mp.sin(d * t) / d
    return e * (x * k + (v + c * x) * s), e * (v * k - (c * v + w * w * x) * s)


def driven(mp, w, f, q, x, v, t):
    """x'' = -w^2 x + f cos(q t), with q other than w: the free and the forced oscillation."""
    b = f / (w * w - q * q)
    free = oscillator(mp, w, x - b, v, t)
    return free[0] + b * mp.cos(q * t), free[1] - b * q * mp.sin(q * t)


def _pendulum(mp, k, theta, omega):
    """Square of the modulus, phase at the start and its rate, of theta'' = -k sin(theta)."""
    half = mp.sin(theta / 2)
    m, w = half * half + omega * omega / (4 * k), mp.sqrt(k)
    if m < 1:
        phase = mp.ellipf(mp.asin(max(-1, min(1, half / mp.sqrt(m)))), m)
        return m, 2 * mp.ellipk(m) - phase if omega < 0 else phase, w
    return m, mp.ellipf(theta / 2, 1 / m), mp.sign(omega) * w * mp.sqrt(m)


def pendulum(mp, k, theta, omega, t):
    """theta'' = -k sin(theta), from -pi < theta < pi: theta, which counts turns, and its rate."""
    m, phase, rate = _pendulum(mp, k, theta, omega)
    u = phase + rate * t
    if m < 1:
        u = u % (4 * mp.ellipk(m))
        sn, cn = mp.ellipfun("sn", u, m=m), mp.ellipfun("cn", u, m=m)
        return 2 * mp.asin(mp.sqrt(m) * sn), 2 * mp.sqrt(k * m) * cn
    quarter = mp.ellipk(1 / m)
    turns = mp.floor((u + quarter) / (2 * quarter))
    u -= 2 * quarter * turns
    return 2 * (mp.asin(mp.ellipfun("sn", u, m=1 / m)) + mp.pi * turns), 2 * rate * mp.ellipfun(
        "dn", u, m=1 / m
    )


def pendulum_zeros(mp, k, theta, omega, t):
    """The times up to t at which a swinging pendulum passes its lowest point."""
    m, phase, rate = _pendulum(mp, k, theta, omega)
    half = 2 * mp.ellipk(m)
    first = int(mp.floor(phase / half)) + 1
    count = int(mp.floor((phase + rate * t) / half))
    return [(half * n - phase) / rate for n in range(first, count + 1)]


def free_body(mp, moments, rates, t):
    """By Jacobi's functions (Landau and Lifshitz, 37); I1 < I2 < I3, off the separatrix."""
    a, b, c = moments
    energy = sum(i * w * w for i, w in zip(moments, rates, strict=True))
    momentum = sum((i * w) ** 2 for i, w in zip(moments, rates, strict=True))
    # about the axis of the least moment: the axes in reverse order and mirrored, so time runs back
    if (momentum - energy * b) * (c - a) < 0:
        x, y, z = free_body(mp, (c, b, a), rates[::-1], -t)
        return z, y, x
    low, high = energy * c - momentum, momentum - energy * a
    first = mp.sqrt(low / (a * (c - a)))
    third = mp.sqrt(high / (c * (c - a))) * mp.sign(rates[2])
    rate = mp.sqrt((c - b) * high / (a * b * c))
    second = first * rate * a / ((c - b) * third)
    m = (b - a) * low / ((c - b) * high)
    phase = mp.ellipf(mp.atan2(rates[1] / second, rates[0] / first), m)
    u = (phase + rate * t) % (4 * mp.ellipk(m))
    cn, sn, dn = (mp.ellipfun(kind, u, m=m) for kind in ("cn", "sn", "dn"))
    return first * cn, second * sn, third * dn


def kepler(mp, gm, place, velocity, t):
    """Position and velocity on an ellipse, by the eccentric anomaly traversed (Battin, 4.3)."""
    x, y = place
    u, v = velocity
    r = mp.sqrt(x * x + y * y)
    a = 1 / (2 / r - (u * u + v * v) / gm)
    n, s, d = mp.sqrt(gm / a**3), (x * u + y * v) / mp.sqrt(gm * a), 1 - r / a
    passed = (n * t) % (2 * mp.pi)

    def lacks(e):
        return e + s * (1 - mp.cos(e)) - d * mp.sin(e) - passed

    low, high = passed - 2, passed + 2  # the other terms are smaller than 2
    e = mp.mpf(passed)
    for _ in range(400):  # Newton's method, kept between the bounds
        value = lacks(e)
        low, high = (e, high) if value < 0 else (low, e)
        step = value / (1 + s * mp.sin(e) - d * mp.cos(e))
        new = e - step if low < e - step < high else (low + high) / 2
        if abs(new - e) < mp.eps * 8:
            break
        e = new
    c, k = mp.cos(e), mp.sin(e)
    f, g = 1 - a / r * (1 - c), (passed - (e - k)) / n
    now = a * (1 - d * c + s * k)
    f_rate, g_rate = -mp.sqrt(gm * a) / (now * r) * k, 1 - a / now * (1 - c)
    return x * f + u * g, y * f + v * g, x * f_rate + u * g_rate, y * f_rate + v * g_rate


def crossings_of_a_spring(T):
    """(mp, s, p) -> the times up to T at which a spring let go at ``s.x`` is at ``p.line``."""

    def times(mp, s, p):
        n, a = mp.sqrt(p.k), mp.acos(p.line / s.x)
        turns = range(int(mp.mpf(T) * n / (2 * mp.pi)) + 2)
        both = ((2 * mp.pi * k + sign * a) / n for k in turns for sign in (1, -1))
        return sorted(t for t in both if 0 < t <= T)

    return times
