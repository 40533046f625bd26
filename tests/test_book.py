"""Every section of the book has its room and its tests."""

from pathlib import Path

import pytest

from tests.book import numbers_in, sections, table

ROOT = Path(__file__).parent.parent


@pytest.mark.parametrize(("name", "numbers"), [
    ("test_eqn_4_18_the_sum", {("4", 18)}),
    ("test_eqn_2_15_to_2_18_polar", {("2", n) for n in (15, 16, 17, 18)}),
    ("test_eqn_8_8_8_9_8_10_about_any_point", {("8", 8), ("8", 9), ("8", 10)}),
    ("test_eqn_11_41_46_47_integrated", {("11", 41), ("11", 46), ("11", 47)}),
    ("test_eqns_6_26_and_6_27_flight", {("6", 26), ("6", 27)}),
    ("test_eqn_A_3_and_A_5_unit_vectors", {("A", 3), ("A", 5)}),
    ("test_eqn_2_1_to_2_2_and_3_1_components", {("2", 1), ("2", 2), ("3", 1)}),
    ("test_example_4_11_velocity", set()),
])  # fmt: skip
def test_a_name_gives_its_equations(name, numbers):
    assert numbers_in(name) == numbers


def test_every_numbered_equation_and_worked_example_has_a_test_by_its_number():
    assert {row[0]: row[4] for row in table() if row[4]} == {}


def test_every_room_that_the_table_names_exists():
    rooms = {room.strip() for _, names, _, _ in sections() for room in names.split(",")}
    places = {r: ROOT if r.startswith("chapters/") else ROOT / "newton_euler" for r in rooms}
    assert {room for room, place in places.items() if not (place / f"{room}.py").exists()} == set()
