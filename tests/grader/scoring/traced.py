"""The diagnosis of a wrong answer whose computation is traced."""

from newton_euler.answers.diagnosis import diagnose
from newton_euler.answers.kinds import KINDS


def named_causes(slips, given, right, kind="number", key="x"):
    """The words of the causes that slips find; the components of both are lists."""
    points = tuple(map(float, given)), tuple(map(float, right))
    near = lambda fit, kind: slips.near(key, fit, kind)
    causes = diagnose((points[0],), (points[1],), [], KINDS[kind], slips=near)
    return " | ".join(c.text for c in causes)
