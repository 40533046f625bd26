"""Runs a small sheet before any submission, so that the work of a first formula is done only once:
the first sum imports sympy.tensor, and symbols and powers fill the caches of SymPy.

The formulas belong to no problem, since student code can find them in its memory.
"""

import sys

from .cells import Submission

_NAMES = "omega, Omega, theta, phi, beta, P, omega_dot, v, a, b, omega_1, r, R, L, m, g, t, T, d"
_GIVENS = f"""\
from math import pi
import numpy as np
from sympy import symbols
from newton_euler import Frame, at, atan2, cos, cross, dot, moving, radians, sin, sqrt, tan
from newton_euler.classroom import expect, given, receipt
{_NAMES} = symbols("{_NAMES}", real=True)
"""
_FORMULAS = """\
from sympy import Abs, acos, asin, atan, atan2, cos, cosh, exp, log, pi, sin, sinh, sqrt, tan, tanh
size = sqrt(5*r**2*omega**2*cos(theta)**4 + 3*v**2*omega_dot**2/7)
share = (a*omega_1 - b*P)/(3*a + b) - Abs(a*b)
ground = Frame("ground")
path = [
    -3*R*omega**3*sin(phi)/(5*r) + 2*g*tan(beta),
    5*r*Omega*omega*cos(phi + beta*sin(P*t))*sin(P*t)/3 - P**3*(r - 2*R),
    -m*g*L*cos(beta)/(4*pi**3*T**2) + d*(omega**3*sin(2*phi) - Omega*atan2(a, b)),
]
turned = cross(ground.vector(0, 0, Omega), ground.vector(d*cos(phi), d*sin(phi), 0))
str(share)
"""
_SYMBOLS = dict.fromkeys(_NAMES.split(", "), "1")
_FORMS = {
    "size": "expression", "share": "expression", "path": "vector_expression",
    "turned": "vector_expression", "blank": "vector",
}  # fmt: skip
_NUMBERS = "speed = 3.25*2**0.5\nacc = np.array([1.5, -speed, 0])\n"
_NUMBERED = {"speed": "number", "acc": "vector"}
SHEET = (
    {"role": "givens", "problem": "formulas", "text": _GIVENS, "clear": ["size", "share"]},
    {"role": "answer", "problem": "formulas", "text": _FORMULAS},
    {"role": "harvest", "problem": "formulas", "forms": _FORMS, "symbols": _SYMBOLS},
    {"role": "answer", "problem": "numbers", "text": _NUMBERS},
    {"role": "harvest", "problem": "numbers", "forms": _NUMBERED, "symbols": {}},
)


def rehearse() -> list[bytes]:
    """Run the sheet; returns its receipts, for tests only."""
    before, path, receipts = sys.modules["__main__"], list(sys.path), list[bytes]()
    Submission(10.0, receipts.append, ()).run(SHEET)
    sys.modules["__main__"], sys.path[:] = before, path
    return receipts
