"""Systems that are built otherwise than their code says."""

from newton_euler import Frame, moving, polar, sin
from newton_euler.algebra.otherwise import built_otherwise
from newton_euler.bodies import rod


def rod_about_its_end(length):
    """The moment of inertia about y at the origin of a rod of mass 3 along x."""
    body = Frame("body")
    return rod(length, body.point("G", length / 2, 0, 0), mass=3.0).about(body).moment("y")


def test_a_change_holds_in_its_block_alone():
    without_transfers = lambda kind, parts, of: (0,) if kind == "transfer" else parts
    with built_otherwise(without_transfers):
        assert rod_about_its_end(2.0) == 1.0
    assert rod_about_its_end(2.0) == 4.0


def test_a_change_sees_what_systems_are_built_of():
    seen = []

    def note(kind, parts, of):
        seen.append((kind, parts))
        return parts

    with built_otherwise(note):
        ground = Frame("ground")
        arm = ground.rotate("arm", "z", rate=2.0)
        arm.vector(1.0, 0, 0)
        arm.angular_acceleration(ground)
        rod_about_its_end(2.0)
        polar(ground, "P", sin(moving(0.0, rate=5.0)), 0.0).acceleration(ground)
    kinds = "turn vector point body transfer rate motion coordinate chain"
    assert {kind for kind, _ in seen} == {*kinds.split()}
    assert ("vector", (1.0, 0, 0)) in seen
    assert ("point", (1.0, 0, 0)) in seen
    assert ("transfer", (1,)) in seen
    assert ("chain", (5.0, 0, 1.0, 0.0)) in seen
