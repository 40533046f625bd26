"""A ball thrown upward, whose answers are a word and a number."""

from exercises.catalogue import Answer, Given

SENSE = Answer("sense", "choice", "1", "whether it rises", ("rises", "falls", "rests"))
DOF = Answer("dof", "count", "1", "degrees of freedom")
SPEED = Answer("v", "number", "m/s", "speed upward")
THROWN = {
    "v_0": Given("v_0", 3.0, "m/s", "speed upward at first", (2.0, 9.0)),
    "t": Given("t", 0.2, "s", "time", (0.1, 0.6)),
    "g": Given("g", 9.81, "m/s^2", "acceleration downward"),
}
SLIPS = {"downward": "takes downward as positive", "no_gravity": "leaves out gravity"}


def sense(v):
    """By plain comparisons, which only numbers have."""
    return lambda: "rises" if v > 0 else "falls" if v < 0 else "rests"


def solve(g):
    v = g.v_0 - g.g * g.t
    return {"sense": sense(v), "v": v}


def mistakes(g):
    v = solve(g)["v"]
    return {
        "downward": {"sense": sense(-v), "v": -v},
        "no_gravity": {"sense": lambda: "rests", "v": g.v_0},
    }


def ball(made, **changes):
    functions = {"solve": solve, "wrong": mistakes, **changes}
    return made(answers=(SENSE, SPEED), givens=THROWN, mistakes=SLIPS, **functions)
