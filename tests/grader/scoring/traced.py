"""Slips in traced computations, and the diagnosis of wrong answers by them."""

from grader.scoring.slips.formulas import Formulas, Intermediate, TracedAnswer
from grader.scoring.slips.perturbed import Computation, Perturbed
from newton_euler.algebra.trace import Trace
from newton_euler.algebra.units import SI
from newton_euler.answers.diagnosis import diagnose
from newton_euler.answers.kinds import KINDS


def arguments(names):
    """{name: its step} in one trace."""
    trace = Trace()
    return {n: trace.new("argument", n) for n in names}


def perturbed(
    units, answers, values=None, ways=None, systems=lambda **_: (), symbols=(), kind=KINDS["vector"]
):
    """The slips in ``answers``, {key: (unit, formula of the arguments)}, in what is computed on the
    ``ways``, {words: formula}, and in the equations that ``systems`` returns; the ``values`` of the
    arguments are 1.3, 2.3 … if there are no others. Three numbers are of the ``kind``.
    """
    given = arguments(units)

    def parts(formula):
        found = formula(**given)
        return [*found] if isinstance(found, list | tuple) else [found]

    of = lambda found: kind if len(found) == 3 else KINDS["number"]
    found = {key: (parts(f), unit) for key, (unit, f) in answers.items()}
    traced = {key: TracedAnswer(x, unit, of(x)) for key, (x, unit) in found.items()}
    way = {words: parts(f) for words, f in (ways or {}).items()}
    stages = [Intermediate(words, "", x, of(x), words) for words, x in way.items()]
    more = {"systems": systems(**given), "symbols": symbols, "given": given}
    formulas = Formulas(traced, units, SI, stages, **more)
    return Perturbed(Computation(formulas), values or {n: 1.3 + k for k, n in enumerate(units)})


def texts(slips):
    """The words of all slips."""
    return [e.cause.text for e in slips.computation.edits]


def named_causes(slips, given, right, kind="number", key="x"):
    """The words of the causes that slips find; the components of both are lists."""
    points = tuple(map(float, given)), tuple(map(float, right))
    near = lambda fit, kind: slips.near(key, fit, kind)
    causes = diagnose((points[0],), (points[1],), [], KINDS[kind], slips=near)
    return " | ".join(c.text for c in causes)
