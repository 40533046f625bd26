"""Chapter 4: every problem holds, on numbers of every kind; and results of some that were worked out by hand, typed as numbers."""

import math

import matplotlib.pyplot as plt
import mpmath
import numpy as np
import pytest
import sympy

from exercises import problem
from exercises.catalogue import problems
from exercises.checks import check, values
from exercises.variants import flat

PROBLEMS = problems("ch04")
SYMBOLIC = [p for p in PROBLEMS if p.symbolic]


def named(p):
    return p.id.replace("/", "_")


by_id = pytest.mark.parametrize("p", PROBLEMS, ids=named)


@pytest.mark.parametrize("p", PROBLEMS, ids=lambda p: f"{named(p)}_holds")
def test_problem(p):
    """Solved and proved alike in floats and in 50 digits, right in its units, and every mistake away from the key."""
    assert check(p, seeds=2) == []


@by_id
def test_solve_runs_on_arrays_of_instants(p):
    students = [values(p, seed) for seed in range(3)]
    together = p.solve({n: np.array([float(v[n]) for v in students]) for n in p.units})
    for n, alone in enumerate(map(p.solve, students)):
        for key in alone:
            at_n = [np.broadcast_to(x, 3)[n] for x in flat(together[key])]
            assert at_n == pytest.approx([float(x) for x in flat(alone[key])], rel=1e-12, abs=1e-9)


@by_id
def test_solve_keeps_the_digits_of_mpmath_numbers(p):
    with mpmath.mp.workdps(40):
        precise = p.solve({n: mpmath.mpf(repr(float(v))) for n, v in values(p, 0).items()})
        assert all(isinstance(x, mpmath.mpf) or x == 0 for answer in precise.values() for x in flat(answer))


@pytest.mark.parametrize("p", SYMBOLIC, ids=named)
def test_formulas_are_exact_and_short(p):
    for answer in p.formulas().values():
        for x in map(sympy.sympify, flat(answer)):
            assert not x.atoms(sympy.Float)
            assert sympy.count_ops(x) <= 45


@by_id
def test_figure_can_be_drawn_for_the_book_and_for_a_student(p):
    for seed in (0, 1):
        fig, ax = plt.subplots()
        p.code.draw(p.base(values(p, seed)), ax)
        assert ax.figure is fig
        plt.close(fig)


# -- worked out by hand with the book's numbers, in the units of the text

KNOWN = {
    ("4/1", "speed"): (math.hypot(6 * 8 * math.pi, 5),),  # 4 rev/s at 6 in, and 5 in/s up
    ("4/1", "acc_mag"): (384 * math.pi**2,),
    ("4/8", "omega"): (0, 1.5, 2),  # i x (0, 8, -6)/4
    ("4/8", "a_B"): (-23, 0, -7),  # (2, 0, 5) + (1, 3, 0) x (4, 0, 0) - 2.5^2 (4, 0, 0)
    ("4/9", "v_mid"): (0.75, -1.4173667737846, 1),  # B at (2.25, 5 sqrt(7)/4, 0) moves at (1.5, -7.5/sqrt(7), 0)
    ("4/12", "omega"): (1.5, 3.25, 2.5),
    ("4/12", "v_D"): (-16.5, -7, 19),
    ("4/13", "omega"): (-1.5, 1.75, 1),
    ("4/15", "v_C"): (-800, 1385.6406460551, -1039.2304845413),
    ("4/16", "alpha_CD"): (0, -0.27, 0),  # 0.6 k x 0.45 (-i)
    ("4/16", "v_D"): (-9.6, 6.2353829072480, -3.6),
    ("4/16", "a_D"): (-7.4824594886975, -7.38, -2.8059223082616),
    ("4/18", "a_A"): (-64, -921.6, -1952),  # 2*2*2.4*160 - 4*400; -2.4^2*160; -(4 + 2.4^2)*200
    ("4/20", "v_A"): (400, -300, 540),
    ("4/20", "a_A"): (576, -864, -1000),  # -1.44*300 j, 2 (1.2, 1.6, 0) x 180 k, -4*250 k
    ("4/21", "omega_A"): (math.pi / 4, 1.5, 4 + 1.5 * math.sqrt(3)),
    ("4/25", "alpha_C"): (-0.18, 0.03, 0.135),  # (-Omega P, Omega omega, omega P)
    ("4/27", "a_A"): (0, 640 * math.pi**2 * 10 - 80 * math.pi**2, -100 * math.pi**2),
    ("4/28", "v_A"): (-4 - math.sqrt(3) / 4, -0.5, -0.25),
    ("4/28", "a_A"): (0.3125, -2 - math.sqrt(3) / 4, -math.sqrt(3) / 16),
    ("4/29", "alpha_A"): (-6, math.pi * (1 - 0.375 * math.sqrt(3)), 0.375 * math.pi),
    ("4/31", "r"): (1000 * math.hypot(3.86, 4.2) / (40 * math.pi),),
    ("4/32", "omega_B"): (0, -3 * math.pi, 2 * math.pi),  # along the line of contact, which is at rest
    ("4/33", "omega_B"): (0, -2 * math.pi, 2 * math.pi),
    ("4/33", "alpha_B"): (4 * math.pi**2, 0, 0),
    ("4/41", "a_B"): (-116000 * math.pi**2 / 10, -4800 * math.pi**2, 0),  # -(100 + 16) pi^2 * 100, -16 pi^2 * 300
}


@pytest.mark.parametrize(("asked", "by_hand"), KNOWN.items(), ids=[f"{p.replace('/', '_')}-{key}" for p, key in KNOWN])
def test_book_s_numbers_give_what_was_found_by_hand(asked, by_hand):
    name, key = asked
    p = problem(name)
    assert [float(x) for x in flat(p.solve(p.book_values)[key])] == pytest.approx(by_hand, rel=1e-12, abs=1e-9)


FORMULAS = {
    ("4/2", "speed"): ("sqrt(nu**2 + (omega*d*sin(tilt))**2)",),
    ("4/5", "omega_C"): ("-R*omega/(2*r)", "0", "omega/2"),
    ("4/10", "Omega"): ("(omega_1 + omega_2)/2",),
    ("4/10", "omega_A"): ("R*(omega_2 - omega_1)/(2*r)",),
    ("4/14", "omega_A"): ("-R*omega/r", "0", "omega"),
    ("4/23", "v_A"): ("2*pi*R/T", "-2*pi*R/T", "-2*pi*r/T"),
    ("4/24", "alpha_rotor"): ("0", "omega*Omega", "0"),
    ("4/26", "alpha_drum"): ("-Omega*P*cos(theta)", "Omega*theta_dot - P*theta_dot*sin(theta)", "P*theta_dot*cos(theta)"),
    ("4/30", "a_A"): ("-4*pi**2*(r + R**2/r)/T**2", "0", "-4*pi**2*R/T**2"),
    ("4/35", "a_A"): ("0", "2*P*omega*r", "-P**2*r"),
    ("4/39", "a_B"): ("-(P**2 + omega**2)*r", "omega_dot*r", "-P_dot*r"),
    ("4/42", "alpha_disk"): ("-omega_1*omega_3", "omega_1*omega_2", "omega_2*omega_3"),
    ("4/42", "a_C"): ("2*omega_1*omega_2*r", "2*omega_1*omega_3*r", "-(omega_2**2 + omega_3**2)*r"),
    ("4/43", "a_D"): ("-(omega_1**2 + omega_3**2)*r", "2*omega_2*omega_3*r", "0"),
}


@pytest.mark.parametrize(("asked", "by_hand"), FORMULAS.items(), ids=[f"{p.replace('/', '_')}-{key}" for p, key in FORMULAS])
def test_formula_is_the_one_found_by_hand(asked, by_hand):
    name, key = asked
    p = problem(name)
    for x, text in zip(flat(p.formulas()[key]), by_hand, strict=True):
        assert sympy.simplify(x - sympy.sympify(text, p.sympy_symbols())) == 0


def test_4_11_equal_cones_turn_the_third_about_its_own_axis():
    """With beta_A = beta_B the axis of C is y, and C rolls on A at -omega*tan(beta)."""
    x, y, z = problem("4/11").solve({"omega": 2.0, "beta_A": 0.7, "beta_B": 0.7})["omega_C"]
    assert (x, y, z) == pytest.approx((0, -2 * math.tan(0.7), 0), abs=1e-12)


def test_4_10_a_car_going_straight_turns_its_differential_as_one_body():
    answers = problem("4/10").solve({"omega_1": 3.0, "omega_2": 3.0, "R": 1.0, "r": 0.4})
    assert (answers["Omega"], answers["omega_A"]) == pytest.approx((3, 0))


def test_4_33_gear_that_turns_with_the_arm_does_not_turn_the_other():
    answers = problem("4/33").solve({"n": 60.0, "n_C": 60.0, "tan_gamma": 1.5})
    assert tuple(answers["omega_B"]) == pytest.approx((0, 0, 2 * math.pi), abs=1e-12)
    assert answers["alpha_B"].norm() == pytest.approx(0, abs=1e-12)
