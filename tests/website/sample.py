"""A notebook with everything that a chapter may hold."""

import nbformat
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

OPENING = "# Sample of a chapter\n\nOne of each kind of cell, with $a^2+b^2$."
FORMULAS = r"""## A numbered formula

A formula with lines and a number, as in (4.18):

$$\begin{aligned} \mathbf a &= \mathbf a_r \\ &\quad + 2\boldsymbol\omega\times\mathbf v_r \end{aligned} \tag{4.18}$$

1. The position in an item:
$$\mathbf r = x\,\mathbf i \tag{1.1}$$
2. Its rate.

Problem 4/16 and problems 3/27 and 3/25 are statements; three quarters, 3/4, are not. [Back](#A-numbered-formula)
"""
FOLDED = """<details><summary>What is $\\dot\\omega$, and *why*?</summary>

A rate, **not** an angle: $\\dot\\omega < 1$.

$$\\dot\\omega = \\frac{d\\omega}{dt} \\tag{4.13}$$

- one
- two

</details>
"""
FILM = """\
from newton_euler import Frame
from newton_euler.drawing import Sketch, animate


def swinging(t, ax):
    ground = Frame("ground")
    bob = ground.rotate("rod", "x", angle=0.4 * t).point("B", 0, 0, -1)
    Sketch(ax, ground, plane="yz").rod((0, 0, 0), bob)


animate(swinging, [0.1 * n for n in range(20)], alt="A pendulum swings.")"""
PICTURE = "import matplotlib.pyplot as plt\n\nplt.plot([0, 1], [0, 1])\nplt.show()"
CAPTION = "*Figure 1. A straight line from $0$ to 1.* It rises."
SLIDER = "from ipywidgets import FloatSlider\n\nFloatSlider()"
TRY = 'try_problem("4/12")'
PREDICT = """\
from newton_euler.classroom import predict, predict_again, tally

predict("Which is $x$?", {"one": "That is $y$.", "two": "Right."}, "two")"""
NUMBER = 'predict("How many?", {4.0: "Twice too many."}, 2.0, "m", within=0.1, why="Count.")'
PIECES = 'print("one", end="", flush=True)\nprint("\\ntwo")'
VECTOR = 'Frame("ground").vector(1, 2, 3)'


def notebook():
    """The notebook, without outputs."""
    folded = {"jupyter": {"source_hidden": True}}
    cells = [
        new_markdown_cell(OPENING), new_markdown_cell(FORMULAS), new_markdown_cell(FOLDED),
        new_code_cell(FILM, metadata=folded), new_code_cell(PICTURE), new_markdown_cell(CAPTION),
        new_code_cell(SLIDER), new_code_cell(VECTOR),
        new_code_cell("from newton_euler.classroom import try_problem"), new_code_cell(TRY),
        new_code_cell(PREDICT), new_code_cell(NUMBER), new_code_cell(PREDICT.split("\n\n")[1]),
        new_code_cell("tally()"),
        new_code_cell("predict_again()"), new_code_cell(PIECES),
    ]  # fmt: skip
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return new_notebook(cells=cells, metadata={"kernelspec": kernel})


def write(path):
    """Write it to a file."""
    path.write_text(nbformat.writes(notebook()), encoding="utf-8")
