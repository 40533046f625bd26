"""Oversights of authors, in texts, numbers and figures, as sentences."""

import random
import re
from collections.abc import Iterator

from .errors import error_sentence, meant
from .model import Problem
from .sections import headings
from .variants import Hides, at_points, distance, drawn_value, flat, objection

DRAWS = 4  # sets of numbers for each that is proved; none if only the book's are
MANY = 0.5  # share of draws without an answer at which ranges are reported
MOST = 0.95  # share of draws refused for any reason at which ranges are reported
SAME = 1e-9  # relative change below which an answer is the same
BY_HAND = 1e-6  # relative error of numbers found by hand
NOISE = 1e-9  # round-off for zero
SHARED = 0.2  # largest share of the points for a number that is the same for all


def overlooked(p: Problem, seeds: int = 1) -> list[str]:
    """Faults that need no proof; with ``DRAWS`` sets of numbers for each of several ``seeds``."""
    found = [*_in_texts(p), *_in_numbers(p)]
    return found or [*_by_hand(p), *_over_draws(p, DRAWS * seeds if seeds > 1 else 0)]


# -- texts


def _in_texts(p: Problem) -> Iterator[str]:
    texts = {"text": p.text, "frame": p.frame} | {a.key: a.means for a in p.answers}
    for where, text in texts.items():
        for name in re.findall(r"\{(\w+)\}", text):
            if name not in p.notation and not _of_latex(text, name):
                yield (
                    f"{where}: {{{name}}} is not a given, symbol or answer; there are "
                    f"{', '.join(p.units)}{meant(name, p.notation, '{{{}}}')}"
                )
    for a in p.answers:
        if a.kind.is_vector and not p.frame:
            yield f"{a.key} is a vector: name its axes under frame:"
    for name, text in p.mistakes.items():
        if text and (not re.match(r"[a-z]+s ", text) or text.endswith(".")):
            yield (
                f"the mistake {name}: a hint says 'your answer fits a solution that {text}'; write "
                "it so that this is a sentence, as in 'leaves out the Coriolis term'"
            )
    for number in {p.section, *(s.get("section", "") for s in p.steps.values())} - {""}:
        if number[:1].isdigit() and number not in headings():
            yield f"section {number} is not in the chapters{meant(number, headings())}"
    if not p.figure and callable(getattr(p.code, "draw", None)):
        yield (
            f"{p.name}.py has draw, but {p.name}.yaml has no figure:, the text for those who "
            "cannot see it"
        )


def _of_latex(text, name):
    r"""True for the argument of a LaTeX command or index, as in ``$\mathbf{r}$``."""
    return re.search(rf"(\\\w+|[_^]|\}})\{{{name}\}}", text) is not None


# -- numbers


def _in_numbers(p: Problem) -> Iterator[str]:
    for name, g in p.givens.items():
        # where the book's value hides a mistake, the range leaves it out on purpose
        if g.vary and not (p.same_in_book or g.vary[0] <= g.value <= g.vary[1]):
            yield (
                f"{name}: the value {g.value:g} is outside of vary: [{g.vary[0]:g}, {g.vary[1]:g}]"
            )
        if g.vary and (own := re.search(r"\([-\d.*/ ]*(pi)?[\d./ ]*\)", g.means)):
            yield f"{name}: means: names the book's number, {own[0]}; each student has another"


def _by_hand(p: Problem) -> Iterator[str]:
    """Results by hand that differ from ``solve``; formulas are compared at two points."""
    for share in (0.5, 0.31) if p.checked else ():
        at = {n: low + share * (high - low) for n, (low, high) in _ranges(p).items()}
        right = p.solve({**p.book_values, **at})
        for key, stated in p.checked.items():
            if fault := _differs(p, key, stated, flat(right[key]), at):
                yield f"checked: {key}{fault}"
                return


def _ranges(p):
    return {n: s.vary for n, s in p.symbols.items()}


def _differs(p, key, stated, right, at):
    """How the result by hand differs from the right answer at this point, or ""."""
    import sympy

    if p.answer(key).kind.is_word:
        same, shown = right == flat(stated), str(right[0])
    else:
        symbols = p.sympy_symbols()
        here = {symbols[n]: x for n, x in at.items()}
        try:
            found = [complex(sympy.sympify(x, symbols).subs(here)) for x in flat(stated)]
        except (sympy.SympifyError, SyntaxError, TypeError):
            return f": {stated!r} cannot be read as a number or formula"
        numbers = [float(x) for x in right]
        off = [abs(x - y) for x, y in zip(found, numbers, strict=False)]
        least = BY_HAND * max(map(abs, numbers)) + NOISE
        same = len(found) == len(numbers) and not max(off) > least
        shown = f"({', '.join(f'{x:.6g}' for x in numbers)})"
    where = f" at {', '.join(f'{n} = {x:.4g}' for n, x in at.items())}" if at else ""
    return "" if same else f" is {stated} by hand, and solve gives {shown}{where}"


# -- many sets of numbers


def _over_draws(p: Problem, number: int) -> Iterator[str]:
    """Faults that show over many draws like students', refused ones included."""
    if not number or not any(g.vary for g in p.givens.values()):
        return
    rng = random.Random(f"draws of {p.id}")
    drawn: list[dict[str, float]] = []
    refused: list[str | None] = []
    # up to four times as many, if most are refused
    while len(drawn) < number or (refused.count(None) < number / 2 and len(drawn) < 4 * number):
        drawn.append({n: drawn_value(g, rng) for n, g in p.givens.items()})
        refused.append(objection(p, drawn[-1]))
    number = len(drawn)
    why = list(filter(None, refused))
    without = [reason for reason in why if not isinstance(reason, Hides)]
    if len(without) > MANY * number or len(why) > MOST * number:
        usual = max(set(without or why), key=why.count)
        yield (f"of {number} draws {len(why)} are refused: one {usual}; narrow vary")
        return
    good = [values for values, reason in zip(drawn, refused, strict=True) if not reason]
    keys = [at_points(p, values) for values in good]
    yield from _tolerances(p, keys)
    yield from _unchanging(p, [right for right, _ in keys])
    yield from _unused(p, good[0])


def _tolerances(p, keys):
    for a in p.answers:
        for right, wrong in keys:
            taken = [
                name
                for name, answers in wrong.items()
                if not a.kind.is_word
                and a.key in answers
                and a.kind.is_right(answers[a.key], right[a.key], a.atol)
            ]
            if taken:
                yield (
                    f"{a.key}: atol: {a.atol:g} {a.unit} accepts the mistake {taken[0]}, "
                    "where the numbers are small; atol is for a key that is zero"
                )
                break


def _unchanging(p, keys):
    whole = sum(a.weight for a in p.answers)
    for a in p.answers:
        points = [right[a.key] for right in keys]
        is_number = not (a.kind.is_word or a.kind.is_formula)
        if is_number and a.weight > SHARED * whole and all(_is_same(points[0], x) for x in points):
            yield (
                f"{a.key} is the same for all students and worth "
                f"{a.weight / whole:.0%} of the points: let a given decide it, or lower its weight:"
            )


def _unused(p, values):
    """Givens that the text does not name and no answer or mistake depends on."""
    here = at_points(p, values)
    for name, g in p.givens.items():
        if f"{{{name}}}" in p.text:  # a superfluous given, on purpose
            continue
        others = [*(g.vary or ()), 1.1 * values[name]]
        moved = [at_points(p, {**values, name: x}) for x in others]
        if all(_all_same(here, there) for there in moved):
            yield f"no answer depends on {name}: leave it out, or name it in the text"


def _all_same(here, there):
    pairs = [(here[0], there[0]), *((here[1][n], there[1][n]) for n in here[1])]
    return all(_is_same(one[key], other[key]) for one, other in pairs for key in one)


def _is_same(one, other):
    if isinstance(one[0][0], str):
        return one == other
    return all(distance(x, y) <= SAME for x, y in zip(one, other, strict=True))


# -- figures


def missing_in_figure(p: Problem) -> list[str]:
    """Labels missing in the figure of ``p``: symbols with ``figure: true``, points of its text."""
    try:
        labels = _labels(p) if p.figure else []
    except Exception as error:  # the code of a problem may raise anything
        return [error_sentence(p.id, error)]
    if not p.figure:
        return []
    shown = " ".join(labels)
    found = [
        f"the figure has no label {p.notation[n]}, and its given {n} has figure: true"
        for n, g in p.givens.items()
        if g.figure and _letter(p.notation[n]) not in shown
    ]
    return found + [
        f"the figure has no label {point}, a point of its text"
        for point in sorted(_points(p.figure) & _points(p.text))
        if point not in shown
    ]


def _labels(p):
    from matplotlib.figure import Figure

    from newton_euler.drawing.page.recorder import sketches_on

    ax = Figure().add_subplot()
    middle = {n: sum(s.vary) / 2 for n, s in p.symbols.items()}
    p.code.draw(p.base({**p.book_values, **middle}), ax)
    for sketch in sketches_on(ax):
        sketch.finish()
    return [text.get_text() for text in ax.texts]


def _letter(symbol):
    r"""The letter of a symbol without its index and accents: "v" of ``\dot v_x``."""
    return re.sub(r"_.*|\\d?dot|\\mathrm|[{}\s]", "", symbol)


def _points(text):
    """The single capital letters in a text, without those of shapes, as in L-section."""
    return set(re.findall(r"(?<=[^.:]\s)([A-Z])\b(?![-'])", text))
