"""Runs a small sheet before any submission, so that what the first formula of a process needs is
made once: the first sum imports sympy.tensor, and symbols and powers fill the caches of SymPy.

The formulas are of no problem: student code finds them in its memory.
"""

import sys

from .cells import Notebook

_GIVENS = """\
from math import pi
import numpy as np
from sympy import symbols
from newton_euler import Frame, at, atan2, cos, cross, dot, moving, radians, sin, sqrt, tan
from newton_euler.classroom import expect, given, receipt
omega, Omega, theta, phi, beta, P, omega_dot, v = symbols(
    "omega Omega theta phi beta P omega_dot v", real=True
)
r, R, L, l, m, g, t, T, d = symbols("r R L l m g t T d", positive=True)
a, b, omega_1, omega_2 = symbols("a b omega_1 omega_2", real=True)
"""
_FORMULAS = """\
from sympy import Abs, acos, asin, atan, atan2, cos, cosh, exp, log, pi, sin, sinh, sqrt, tan, tanh
size = sqrt(5*r**2*omega**2*cos(theta)**4 + 3*v**2*omega_dot**2/7)
share = (a*omega_1 - b*omega_2)/(3*a + b) - Abs(a*b)
ground = Frame("ground")
path = [
    -3*R*omega**3*sin(phi)/(5*r) + 2*g*tan(beta),
    5*r*Omega*omega*cos(phi + beta*sin(P*t))*sin(P*t)/3 - P**3*(r - 2*R),
    -m*g*L*cos(beta)/(4*pi**3*T**2) + d*(omega**3*sin(2*phi) - Omega*atan2(a, b)),
]
turned = cross(ground.vector(0, 0, Omega), ground.vector(d*cos(phi), d*sin(phi), 0))
str(share)
"""
_SYMBOLS = {
    "omega": "rad/s", "Omega": "rad/s", "theta": "rad", "phi": "rad", "beta": "rad", "P": "rad/s",
    "omega_dot": "rad/s^2", "v": "m/s", "a": "m", "b": "m", "omega_1": "rad/s", "omega_2": "rad/s",
    "r": "m", "R": "m", "L": "m", "m": "kg", "g": "m/s^2", "t": "s", "T": "s", "d": "m",
}  # fmt: skip
_FORMS = {
    "size": "expression, m/s", "share": "expression, rad/s", "path": "vector_expression, m/s^2",
    "turned": "vector_expression, m/s", "blank": "vector, mm/s",
}  # fmt: skip
_NUMBERS = "speed = 3.25*2**0.5\nacc = np.array([1.5, -speed, 0])\n"
SHEET = (
    {"role": "givens", "problem": "formulas", "text": _GIVENS, "clear": ["size", "share"]},
    {"role": "answer", "problem": "formulas", "text": _FORMULAS},
    {"role": "harvest", "problem": "formulas", "forms": _FORMS, "symbols": _SYMBOLS},
    {"role": "answer", "problem": "numbers", "text": _NUMBERS},
    {
        "role": "harvest", "problem": "numbers", "symbols": {},
        "forms": {"speed": "number, m/s", "acc": "vector, m/s^2"},
    },
)  # fmt: skip


def rehearse() -> list[bytes]:
    """Run the sheet; returns its receipts, which nobody needs."""
    before, path, receipts = sys.modules["__main__"], list(sys.path), list[bytes]()
    Notebook(10.0, receipts.append, ()).run(SHEET)
    sys.modules["__main__"], sys.path[:] = before, path
    return receipts
