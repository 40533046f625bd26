"""Mistakes in setting up a system, and in its formulas, made from the printed text with a student's
numbers: each is named in its own words.
"""

from math import cos, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
import sympy

from exercises.catalogue import problem
from exercises.catalogue.variants import draw
from grader.scoring.numbers import numbers_of
from tests.grader.scoring.answered import judged, right_trees, trees


def top_of_the_rim(r, P, omega_b, b):
    """4/41: the point at z = r for that at x = r."""
    bracket, disk, CP = (0, 0, omega_b), (0, P, omega_b), (0, 0, r)
    growth, centre = np.cross(bracket, (0, P, 0)), np.cross(bracket, (0, b, 0))
    v = centre + np.cross(disk, CP)
    a = np.cross(bracket, centre) + np.cross(growth, CP) + np.cross(disk, np.cross(disk, CP))
    return {"v_B": v, "a_B": a}


def blocks(moved, a, b, c, r_c, l_c, x_c, rho, in_feet=144):
    """7/3: with the parallel-axis terms of the block and of the cylinder, each or not."""

    def inertia(m, own, d, by):
        return np.diag(own) + by * m * (np.dot(d, d) * np.eye(3) - np.outer(d, d))

    block, cylinder = (rho * v / 12**3 for v in (a * b * c, pi * r_c**2 * l_c))
    edges = block / 12 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])
    across = cylinder * (3 * r_c**2 + l_c**2) / 12
    whole = inertia(block, edges, (a / 2, b / 2, c / 2), moved[0])
    own = (across, across, cylinder * r_c**2 / 2)
    return {"I_O": (whole + inertia(cylinder, own, (x_c, b / 2, c + l_c / 2), moved[1])) / in_feet}


def from_revolutions(m, omega, l, p, q, d):
    """9/5: omega, given in rad/s, converted from rev/min; lengths in mm."""
    slow = omega * pi / 30
    return {"Hdot_O": (0, slow**2 * m * q * l / 2e6, -(slow**2) * m * p * l / 2e6)}


def along_the_rod(omega, alpha, u, x_B, y_B):
    """2/37: the Coriolis term along the relative velocity, the bracket turning clockwise."""
    x = alpha * y_B + omega**2 * x_B + 2 * omega * u
    return {"a_B": (x, alpha * x_B - omega**2 * y_B, 0)}


def one_panel(c, q):
    """7/29: the moments of inertia with one of the two panels."""
    share = c * q / (2 * pi)
    I_x = 1 + share * (c**2 / 12 + (1 + c / 2) ** 2)
    return {"l_r": ((I_x - 0.5) / ((1 + share * q**2) / 12)) ** 0.5}


def about_an_end(m, xA, yA, xB, yB, **_):
    """7/31: the part about the centre of mass with 1/3."""
    own, between = (xB - xA) * (yB - yA) / 3, (xA + xB) * (yA + yB) / 4
    return {"I_xy": m * (own + between) / 10**6}


def over_the_difference(c, d, t_1, t_2):
    """A/25: t_2 - t_1 put into the antiderivative."""
    t = t_2 - t_1
    return {"whole": (0, t**4 / 4 + c * t**3 / 3, d * t)}


def without_the_fourth(m_1, m_2, m_3, m_4, d, omega, alpha):
    """8/19: the angular momentum of three of the four particles."""
    places = (d, d, 0), (2 * d, 0, d), (d, -d, 2 * d)
    each = [(m, np.array(r)) for m, r in zip((m_1, m_2, m_3), places, strict=True)]
    column = sum(m * (r @ r * np.array([1, 0, 0]) - r[0] * r) for m, r in each)
    return {"H_O": [float(f"{x:.5g}") * omega for x in column]}


def swinging(a, b, M, theta):
    """8/10: the angular acceleration at the start all the way."""
    return {"theta_dot": sympy.sqrt(3 * a * theta / b)}


def about_their_centre(a, b, c, r_c, l_c, x_c, rho):
    """7/3: the matrix about the centre of mass of the block and the cylinder."""
    masses = rho / 12**3 * np.array([a * b * c, pi * r_c**2 * l_c])
    places = np.array([(a / 2, b / 2, c / 2), (x_c, b / 2, c + l_c / 2)])
    G, about_O = masses @ places / masses.sum(), blocks((1, 1), a, b, c, r_c, l_c, x_c, rho)
    moved = masses.sum() * (G @ G * np.eye(3) - np.outer(G, G)) / 144
    return {"I_O": about_O["I_O"] - moved}


def as_it_is(c, d, t):
    """A/17: the cross product itself."""
    return {"dudt": sympy.Matrix([t, t**2, c]).cross(sympy.Matrix([d * t, t**2, t**3])).T}


def not_resolved(R, R_dot, R_ddot, theta_dot, theta_ddot, phi, phi_dot, phi_ddot):
    """3/16: the acceleration toward the axis all along e_R."""
    c, s = sympy.cos(phi), sympy.sin(phi)
    across = R * theta_ddot * c + 2 * R_dot * theta_dot * c - 2 * R * theta_dot * phi_dot * s
    outward = R_ddot - R * phi_dot**2 - R * theta_dot**2 * c
    return {"a": [outward, across, R * phi_ddot + 2 * R_dot * phi_dot]}


def with_one_more_transfer(W, k_z, k_x, c, phi_dot, theta, g):
    """10/5: the transverse moment of inertia moved to O, about which it already is."""
    spin = phi_dot * 2 * pi / 60
    return {"psi_fast": k_z**2 * spin / ((k_x**2 + c**2 - k_z**2) * np.cos(radians(theta)))}


def particles(m, a, omega, alpha):
    """8/17: each rod a particle at its centre."""
    h = m * a**2
    return {"H_O": [5 * h * omega / 2, -h * omega / 2, -3 * h * omega / 2]}


def about_the_centre(m, omega, l, p, q, **_):
    """The angular momentum of two rods about their common centre."""
    off = m * omega * l * (q - p) / 4e6
    return {"H_O": [5 * m * omega * l**2 / 12e6, off, -off]}


def in_the_ground(omega, u, x_E, y_E):
    """2/39, which turns clockwise: the Coriolis acceleration of the whole velocity."""
    turning, r = (0, 0, -omega), (x_E, y_E, 0)
    v = np.cross(turning, r) + (u, 0, 0)
    return {"a_E": np.cross(turning, np.cross(turning, r) + 2 * v)}


def to_the_origin(L, v_Ay, v_Az, v_By, v_Bz, a_Ax, a_Ay, a_Az, omega_x, wd_y, wd_z, **_):
    """4/8: -omega^2 r towards A, as if omega were at right angles to AB."""
    square = omega_x**2 + ((v_By - v_Ay) ** 2 + (v_Bz - v_Az) ** 2) / L**2
    return {"a_B": [a_Ax - square * L, a_Ay + wd_z * L, a_Az - wd_y * L]}


def twice_differentiated(name, key, limit, given):
    """What is integrated up to a limit, differentiated."""
    x = sympy.Symbol("x")
    right = problem(name).solve({**given, limit: x})[key]
    return {key: [sympy.diff(y, x, 2).subs(x, given[limit]) for y in right.components()]}


def _plate(x, y):
    """The matrix of a plate with these moments of inertia."""
    return [[x, 0, 0], [0, y, 0], [0, 0, x + y]]


CASES = {
    "not resolved": ("3/16", not_resolved, "along one axis"),
    "one more transfer": ("10/5", with_one_more_transfer, "to a moment of inertia"),
    "particles": ("8/17", particles, "takes all bodies as particles"),
    "no rate of a motion": (
        "2/33", lambda x_dot, **g: {"a": [x_dot, 0, 0]}, "takes a velocity for the acceleration"
    ),
    "no inner derivative": (
        "2/17", lambda b, c, omega, theta: {"a": sympy.sqrt(
            (c * sympy.cos(theta) - (b - c * sympy.cos(theta)) * omega**2) ** 2
            + (2 * c * sympy.sin(theta) * omega) ** 2)},
        "leaves out the inner derivative omega",
    ),
    "another law": ("5/18", lambda W0, n_R, **_: {"W": W0 / n_R**2}, "takes W0/n_R^2 for W"),
    "a factor of 2 alone": ("5/8", lambda R: {"d": [0, 0, R]}, "look for something halved"),
    "a mass that cancels": (
        "11/4", lambda m, k, R, g: {"v_B": (2 * g * R * m) ** 0.5}, "has m left in one place"
    ),
    "wrong side": (
        "6/4", lambda m, A, omega, B, t_1: {"F": [
            -A * omega * sin(omega * t_1) / m, 2 * B * t_1 / m, -A * omega * np.cos(omega * t_1) / m
        ]}, "has m on the wrong side",
    ),
    "a velocity for its rate": (
        "6/4", lambda m, A, omega, B, t_1: {"F": [
            m * A * np.cos(omega * t_1), m * B * t_1**2, -m * A * sin(omega * t_1)
        ]}, "does not differentiate",
    ),
    "an area": ("7/18", lambda m, b, h: {"I_xx": b * h**3 / 36}, "leaves out the mass per"),
    "inside an integral": (
        "5/8", lambda R: {"d": [0, 0, sympy.pi * R / 4]}, "in the integrand"
    ),
    "half an integral": (
        "5/7", lambda R, alpha: {"d": [R * (1 - sympy.cos(alpha)) / alpha, 0, 0]}, "takes sin(...)"
    ),
    "as about its end": ("7/31", about_an_end, "has 1/3 for 1/12 in "),
    "another point": ("7/3", about_their_centre, "moments of inertia about the centre of mass"),
    "no rate": ("A/17", as_it_is, "does not differentiate the vector"),
    "a point": ("4/41", top_of_the_rim, "puts r along another axis"),
    "all transfers": ("7/3", lambda **g: blocks((0, 0), **g), "leaves out all parallel-axis terms"),
    "one transfer": ("7/3", lambda **g: blocks((1, 0), **g), "of the body with its centre at x_c"),
    "a particle": ("8/19", without_the_fourth, "leaves out the particle at d, 2*d and d"),
    "near the key": (
        "8/9", lambda m, a, theta, v_0, g: {"d_OP": 3 * v_0**2 / (4 * g * tan(radians(theta)))},
        "takes tan(theta) for sin(theta)",
    ),
    "a unit once": ("7/3", lambda **g: blocks((1, 1), **g, in_feet=12), "in one factor too few"),
    "unit": ("9/5", from_revolutions, "converts omega from rev/min: it is given in rad/s"),
    "direction": (
        "2/37", along_the_rod, "has the Coriolis term 2 omega x v_r in another direction"
    ),
    "components": (
        "3/12", lambda lead, n, a: {"speed": 2 * pi * n * a + lead * n},
        "adds components as numbers",
    ),
    "composite": (
        "2/11", lambda v_0, phi, g: {"rho_top": v_0 * sin(radians(phi)) / g},
        "does not square v_0 and sin(phi)",
    ),
    "small": ("5/17", lambda W0, h, R_e: {"W": W0 * (1 - 2 * h / R_e)}, "keeps h to first order"),
    "difference": (
        "7/21", lambda m, I_AA, r_a, r_b: {"I_BB": I_AA - m * (r_a - r_b) ** 2 / 1e3},
        "squares the difference",
    ),
    "another answer added": (
        "2/14", lambda d, theta, omega, alpha: {
            "a_2": -d * alpha * sympy.sin(theta) - d * omega**2 * sympy.cos(theta)
        }, "adds a_1 to a_2",
    ),
    "another answer taken off": (
        "11/9", lambda d, h, W, h_E, g: {"N_D": -6 * W}, "subtracts N_B from N_D",
    ),
    "differentiated": (
        "A/24", lambda **given: twice_differentiated("A/24", "AxB", "t", given),
        "differentiates the integrand",
    ),
    "differentiated, in numbers": (
        "A/25", lambda **given: twice_differentiated("A/25", "whole", "t_2", given),
        "differentiates the integrand",
    ),
    "the whole velocity": ("2/39", in_the_ground, "velocity in the ground in the Coriolis term"),
    "to the origin": ("4/8", to_the_origin, "takes omega^2 r as the centripetal acceleration"),
    "third powers": (
        "5/12", lambda e, R, r: {"d": [-e * r**3 / (R**3 - r**3), 0, 0]}, "third power of R and r",
    ),
    "a ratio inverted": (
        "7/23", lambda q1, q2: {"err_1": 100 * q1**2 / (2 + q1**2)}, "inverts q1: q1 is the first",
    ),
    "divided once too often": (
        "3/21", lambda R, h, omega: {"v": [
            0, omega * sympy.sqrt(R**2 - h**2 / 4), h * omega / sympy.sqrt(R**2 - h**2 / 4)
        ]}, "divides by R once too often",
    ),
    "nothing, not millimetres": (
        "3/7", lambda b, p, nu, theta, **_: {"a": [
            float(f"{-1 / b:.6g}") * nu**2 * sympy.cos(theta),
            float(f"{-1 / b:.6g}") * nu**2 * sympy.sin(theta), 0
        ]}, "nu/b instead of nu/sqrt(b^2 + p^2)",
    ),
    "limits": ("A/25", over_the_difference, "to the difference of the limits"),
    "constant": ("8/10", swinging, "takes the integrand as constant"),
    "about the centre": ("9/5", about_the_centre, "moments of inertia about the centre of mass"),
    "in inches": (
        "2/16", lambda a_n1, r_1, **_: {"v_tape": (a_n1 / r_1) ** 0.5}, "one factor r_1 too few",
    ),
    "one of two": ("7/29", one_panel, "or q*c"),
    "a sum of weights": (
        "6/5", lambda W_A, W_B, g: {"T": W_A + W_B}, "takes W_A + W_B for T",
    ),
    "all angles": (
        "11/3", lambda W, F, s_AB, theta_1, theta_2: {
            "s": (F - W * cos(radians(theta_1))) * s_AB / W / cos(radians(theta_2))
        }, "measures all angles from the other axis",
    ),
    "the size of a sum": (
        "2/13", lambda v_1, v_2, rho, b: {
            "a": [-b, sqrt(((v_1**2 + v_2**2) / rho) ** 2 - b**2), 0]
        }, "takes the second component for the magnitude of a",
    ),
    "an arm": (
        "8/3", lambda W, L, theta, g: {
            "F_B": [0, W * (1 - 1.5 * sin(radians(theta)) ** 2), 0]
        }, "doubles what stands beside alpha in finding N_B",
    ),
    "one term": (
        "11/19", lambda M, Omega, R, d, **_: {"T_outer": M * Omega**2 * (R + d) ** 2 / 4},
        "alone: the sum has more terms",
    ),
    "no translation": (
        "11/19", lambda M, Omega, R, d, r: {
            key: M * Omega**2 * (2 * x**2 + r**2) / 8
            for key, x in (("T_outer", R + d), ("T_inner", R - d))
        }, "leaves out the translation of the body of mass M",
    ),
    "a mean rate": (
        "2/20", lambda c_2, c_3, q_1, q_2, t_1: {"v": [
            c_2 * t_1 - c_3 * t_1**2,
            (c_2 * t_1**2 - c_3 * t_1**3) * pi / 2 * (q_1 - 2 * q_2 * t_1), 0
        ]}, "over t_1 for the rate r_dot",
    ),
    "another given in one product": (
        "7/12", lambda rho, R, r, e: {"I_O": _plate(
            rho * pi * (R**4 - r**4) / 4, rho * pi * (R**4 - r**4 - 4 * R**2 * e**2) / 4
        )}, "takes R for r in rho*pi*r^2*e^2",
    ),
    "half of both": (
        "7/12", lambda rho, R, r, e: {"I_O": _plate(
            rho * pi * (R**4 - r**4) / 64, rho * pi * (R**4 - r**4 - 16 * r**2 * e**2) / 64
        )}, "takes half of R and of r",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_each_slip_is_named_in_its_own_words(case):
    name, wrong, words = CASES[case]
    p = problem(name)
    values = draw(p, b"setups")
    given = wrong(**values, **p.sympy_symbols())
    written = {key: _written(x) for key, x in given.items()}
    answers = {**right_trees(p, values), **trees(p, written)}
    parts = judged(p, answers, values)
    for key in given:
        assert parts[key].verdict == "wrong"
        assert words in parts[key].message


def _written(x):
    """An answer in six digits, as students write it; a formula as it is."""
    if isinstance(x, sympy.Basic):
        return x
    if np.ndim(x):
        return [_written(y) for y in x]
    return float(f"{x:.6g}")


def test_a_component_that_lost_its_zeros_has_as_many_digits_as_the_others():
    """A/1: the mean, whose third component is a number with one digit."""
    values = {"A_x": 4.85, "A_y": -2.6, "A_z": 5.1, "B_x": 2.7, "B_y": 4.15, "B_z": -1.1}
    part = judged(problem("A/1"), {"r_BA": [3.775, 0.775, 2.0]}, values)["r_BA"]
    assert "takes the mean of" in part.message


def test_a_slip_inside_an_integral_names_its_factor_or_term():
    p = problem("3/1")
    said = {c.what for _, c in numbers_of(p, draw(p, b"setups")).slips.ranked("r").slips}
    inside = {words.removesuffix(" in the integral over s") for words in said} - said
    assert {"leaves out the term a1*s", "has the term c0 with the wrong sign"} <= inside
    assert not {"leaves out the term s", "leaves out "} & inside
