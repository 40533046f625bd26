"""Marks and names of points."""

from tests.sketching import O, sketch, texts, vertices


def test_a_dot_is_named_as_a_label_names_its_place():
    named, both = sketch(plane="xy"), sketch(plane="xy")
    for s in (named, both):
        s.line(O, (1, 0, 0))
    named.dot(O, "O", offset=(9, -7))
    both.dot(O)
    both.label(O, "O", offset=(9, -7))
    assert texts(named)["O"].get_position() == texts(both)["O"].get_position()
    assert texts(named)["O"].get_weight() == texts(both)["O"].get_weight() == "bold"
    assert len(vertices(named)) == len(vertices(both))
