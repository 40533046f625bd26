"""Terms and frames of the engine in the words of a problem."""

import re

from newton_euler.algebra.language import Words, joined
from newton_euler.algebra.ledger import Crossed, Equation

from .book_equations import own_term
from .model import Problem

# terms of (4.15) and relative motion: v_B, a_B would be read as those of a point B of the problem
RELATIVE_MOTION = {
    ("velocity", "origin"): Words("the velocity of the origin of the moving frame"),
    ("velocity", "relative"): Words(
        "the velocity relative to the moving frame, {formula}", formula="v_r"
    ),
    ("velocity", "rotation"): Words("the term {formula}", formula="omega x r"),
    ("acceleration", "origin"): Words("the acceleration of the origin of the moving frame"),
    ("acceleration", "relative"): Words(
        "the acceleration relative to the moving frame, {formula}", formula="a_r"
    ),
    ("acceleration", "euler"): Words("the term {formula}", formula="alpha x r"),
    ("rate", "relative"): Words(
        "the rate of change in the moving frame, {formula}", formula="dQ/dt"
    ),
    ("rate", "rotation"): Words(
        "the term {formula}, by the turning of the moving frame", formula="omega x Q"
    ),
}
TYPESET = {
    "v_r": r"$\mathbf{v}_r$", "a_r": r"$\mathbf{a}_r$", "dQ/dt": r"$d\mathbf{Q}/dt$",
}  # fmt: skip
KINDS = {
    "coriolis": Words("the Coriolis term"),
    "centripetal": Words("the centripetal term"),
    "euler": Words("the Euler term"),
    "relative": Words("the relative term"),
    "origin": Words("the origin term"),
    "rotation": Words("the rotation term"),
    "tangential": Words("the tangential term"),
    "normal": Words("the normal term"),
    "radial": Words("the radial term"),
    "transverse": Words("the transverse term"),
    "axial": Words("the axial term"),
    "orbital": Words("the orbital term"),
    "own": Words("the spin term"),
}
OTHERS = {str(kind): kind for kind in (
    Words("acceleration"), Words("attraction"), Words("centrifugal"), Words("dynamic"),
    Words("dynamic Euler"), Words("fall"), Words("fall turned"), Words("gravity"),
    Words("gyroscopic"), Words("inertia"), Words("launch"), Words("launch turned"),
    Words("moment"), Words("precession"), Words("reference"), Words("static"),
    Words("static Euler"), Words("turning"), Words("weight"),
)}  # fmt: skip


def term_text(
    name: str, equation: Equation, problem: Problem | None = None, latex: bool = False
) -> str:
    """A term in the words of the problem, with its formula if it has one: as text or in LaTeX."""
    if (equation.kind, name) in RELATIVE_MOTION:
        text = RELATIVE_MOTION[equation.kind, name]
        formula = str(text.values.get("formula", ""))
        return Words(text.template, formula=TYPESET.get(formula, formula)) if latex else text
    if name in equation.terms:
        kind, *of = name.split("_")  # coriolis_theta_phi, of two coordinates; static_euler
        kind = " ".join([kind, *(x for x in of if x == "euler")])
        whose = joined(x for x in of if x != "euler")
        written = own_term(equation.number, name, problem) or equation.terms[name]
        formula = f"${written[1]}$" if latex else written[0]
        other = kind.replace("euler", "Euler")
        the_term = KINDS.get(kind) or Words("the {kind} term", kind=OTHERS.get(other, other))
        if whose:
            return Words(
                "{term} of {coordinates}, {formula}",
                term=the_term, coordinates=whose, formula=formula,
            )  # fmt: skip
        return Words("{term} {formula}", term=the_term, formula=formula)
    if not equation.kind.startswith("angular"):
        return Words("the term {formula}", formula=name)
    if not isinstance(name, Crossed):
        # the cross products of an angular acceleration are the change of direction
        whose = _of_frame(name, problem)
        if equation.kind == "angular acceleration":
            return Words("the rate of the turning {whose}", whose=whose)
        return Words("the turning {whose}", whose=whose)
    first, second = (_of_frame(n, problem) for n in name.factors)
    return Words(
        "the cross product of the turning {first} and the turning {second}",
        first=first, second=second,
    )  # fmt: skip


def _of_frame(name, problem):
    """A frame in the words of the problem, after "the turning": "of the arm", "about y"."""
    if name.startswith("about ") or name in ("x", "y", "z"):
        return Words("about {axis}", axis=name.removeprefix("about "))
    if named_in_text(name, problem):
        return Words("of {body}", body=body_text(name))
    return Words("of a moving frame")


def body_text(name: str) -> str:
    """A body or frame in a sentence: "the arm", "CD"."""
    is_name = not name.islower() or len(name) == 1
    return name if is_name else Words("the {body}", body=name)


def named_in_text(name: str, problem: Problem | None) -> bool:
    """True if the name of a frame is a word of the problem, and not of its solution only."""
    if problem is None:
        return True
    text = " ".join((problem.text, problem.figure, problem.frame))
    return re.search(rf"\b{re.escape(name)}\b", text) is not None
