"""Terms and frames of the engine in the words of a problem."""

import re

from newton_euler.algebra.ledger import Equation

from .model import Problem

# the terms of the equations of relative motion, whose symbols v_B, a_B would be taken for the
# velocity and acceleration of a point B of the problem, and of (4.15)
RELATIVE_MOTION = {
    ("velocity", "origin"): "the velocity of the origin of the moving frame",
    ("velocity", "relative"): "the velocity relative to the moving frame, v_r",
    ("velocity", "rotation"): "the term omega x r",
    ("acceleration", "origin"): "the acceleration of the origin of the moving frame",
    ("acceleration", "relative"): "the acceleration relative to the moving frame, a_r",
    ("acceleration", "euler"): "the term alpha x r",
    ("rate", "relative"): "the rate of change in the moving frame, dQ/dt",
    ("rate", "rotation"): "the term omega x Q, by the turning of the moving frame",
}


def term_text(
    name: str, equation: Equation, problem: Problem | None = None, latex: bool = False
) -> str:
    """A term in the words of the problem, with its formula if it has one: as text or in LaTeX."""
    if (equation.kind, name) in RELATIVE_MOTION:
        text = RELATIVE_MOTION[equation.kind, name]
        bold = re.sub(r"\b([av])_r", r"$\\mathbf{\1}_r$", text)
        return bold.replace("dQ/dt", r"$d\mathbf{Q}/dt$") if latex else text
    if name in equation.terms:
        kind, *of = name.split("_")  # coriolis_theta_phi, of two coordinates; static_euler
        kind = " ".join([kind, *(x for x in of if x == "euler")])
        kind = kind.replace("coriolis", "Coriolis").replace("euler", "Euler")
        of = [x for x in of if x != "euler"]
        whose = f" of {' and '.join(of)}," * bool(of)
        formula = f"${equation.terms[name][1]}$" if latex else equation.terms[name][0]
        return f"the {kind} term{whose} {formula}"
    if not equation.kind.startswith("angular"):
        return f"the term {name}"
    if " x " not in name:
        # of an angular acceleration; the cross products are how the turning changes direction
        growth = "the growth of " * (equation.kind == "angular acceleration")
        return f"{growth}the turning {_of_frame(name, problem)}"
    first, second = (_of_frame(n, problem) for n in name.split(" x "))
    return f"the cross product of the turning {first} and the turning {second}"


def _of_frame(name, problem):
    """A frame in the words of the problem, after "the turning": "of the arm", "about y"."""
    if name.startswith("about ") or name in ("x", "y", "z"):
        return f"about {name.removeprefix('about ')}"
    return f"of {body_text(name)}" if named_in_text(name, problem) else "of a moving frame"


def body_text(name: str) -> str:
    """A body or frame in a sentence: "the arm", "CD"."""
    return name if not name.islower() or len(name) == 1 else f"the {name}"


def named_in_text(name: str, problem: Problem | None) -> bool:
    """True if the name of a frame is a word of the problem, and not of its solution only."""
    if problem is None:
        return True
    text = " ".join((problem.text, problem.figure, problem.frame))
    return re.search(rf"\b{re.escape(name)}\b", text) is not None
