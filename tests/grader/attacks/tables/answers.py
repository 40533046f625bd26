"""Libraries and receipts that are patched, and objects that lie about what they are."""

from tests.grader.attacks.attack import cells, code, edited, lie, put, right_texts

CELLS = cells(__file__)

PATCHED = {name: code(text) for name, text in CELLS["patched"].items()}

LIES = {name: lie(text) for name, text in CELLS["lies"].items()}

BOMBS = {name: code(text) for name, text in CELLS["bombs"].items()}

FRAMES = """
from newton_euler import Frame
mine = Frame("ground")
for axis in "xyx":
    mine = mine.rotate("mine", axis, angle=3.141592653589793, rate=1)
alpha_CD, v_D, a_D = (mine.vector(*(s * x for s, x in zip((-1, -1, 1), v))) for v in (alpha_CD, v_D, a_D))
"""


def _four_guesses(notebook, scene):
    """Vectors with wrong signs, which are right in a frame that is turned by half a turn."""
    right = right_texts(scene.course, scene.student)["answer-4-16"]
    put(notebook, {"answer-4-16": right + FRAMES})


GUESSES = {"four guesses in one answer": edited(_four_guesses)}

ATTACKS = {**PATCHED, **LIES, **BOMBS, **GUESSES}
