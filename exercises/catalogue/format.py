"""The format of the YAML files of chapters and problems; what does not fit is refused in words."""

import math
from keyword import iskeyword
from pathlib import Path
from reprlib import repr as short
from typing import Any
from unicodedata import normalize

from newton_euler.algebra.units import unit
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.sanity import QUANTITIES

from .errors import meant
from .model import Answer, CatalogueError, Chapter, Given, Problem, Symbol, folder_and_file

# angles away from 0 and 90 degrees, where different formulas may agree
SYMBOL_RANGES = {"rad": (0.25, 1.1), "deg": (15, 65)}
OTHER_RANGE = (0.6, 1.9)
# the keys of a problem
IN_CELLS = "expect", "given", "receipt", "symbols"  # called in cells beside an answer's
NEEDED = "id", "title", "section", "text", "answers"
OPTIONAL = "figure", "givens", "symbols", "frame", "steps", "mistakes", "struck", "checked"


def read_chapter(entry: Any, path: Path) -> Chapter:
    """The chapter that ``chapter.yaml`` describes."""
    _check_keys(entry, "a chapter", ("title",), ("preamble",))
    return Chapter(path.parent.name, _text(entry, "title"), _text(entry, "preamble"))


def read_problem(entry: Any, path: Path) -> Problem:
    """The problem that a file such as ``p16.yaml`` describes."""
    _check_keys(entry, "a problem", NEEDED, OPTIONAL)
    _check_place(entry["id"], path)
    answered = isinstance(entry["answers"], list) and entry["answers"]
    _require(answered, f"answers must be a list, not {short(entry['answers'])}")
    answers = tuple(_answer(a) for a in entry["answers"])
    _check_names(
        {
            "a given": _named(entry, "givens"),
            "a symbol": _named(entry, "symbols"),
            "an answer": [a.key for a in answers],
        }
    )
    return Problem(
        id=entry["id"],
        title=_text(entry, "title"),
        section=_text(entry, "section"),
        text=_text(entry, "text"),
        figure=_text(entry, "figure"),
        givens={name: _given(name, g) for name, g in _named(entry, "givens").items()},
        symbols={name: _symbol(name, s) for name, s in _named(entry, "symbols").items()},
        frame=_text(entry, "frame"),
        answers=answers,
        mistakes=_mistakes(_named(entry, "mistakes")),
        struck=_texts(entry, "struck"),
        steps={key: _step(key, s) for key, s in _named(entry, "steps").items()},
        checked=_checked(_named(entry, "checked"), [a.key for a in answers]),
        same_in_book=frozenset(
            name
            for name, m in _named(entry, "mistakes").items()
            if isinstance(m, dict) and m.get("same_in_book")
        ),
    )


def _check_place(problem_id, path):
    folder, stem = folder_and_file(problem_id)
    if (folder, stem) == (path.parent.name, path.stem):
        return
    home = f"{folder}/{stem}.yaml"
    if (path.parents[1] / home).exists():
        raise CatalogueError(
            f"the id {problem_id} is also that of {home}; give one of them the id that its "
            "name says, or delete it"
        )
    raise CatalogueError(
        f"the id {problem_id} belongs in {home}; rename this file, or correct the id"
    )


def _check_names(named):
    """Refuse a name that students cannot use, and one that stands for two things."""
    taken = {}
    for what, names in named.items():
        for name in names:
            _require(
                name.isidentifier() and not iskeyword(name) and name not in IN_CELLS,
                f"{what} cannot be called {name!r}: students write the name in Python, beside "
                f"{', '.join(IN_CELLS)}",
            )
            name = normalize("NFKC", name)  # as Python reads it
            _require(
                name not in taken,
                f"{name} is {taken.get(name)} and {what}: give one of them another name",
            )
            taken[name] = what


def _given(name, g):
    _check_keys(g, name, ("value", "unit", "means"), ("vary", "figure", "symbol"))
    value = g["value"]
    fault = f"{name}: value must be a number, as in 8 or 0.6, not {short(value)}"
    _require(_is_number(value), fault)
    read = _unit(name, g), _text(g, "means"), _range(name, g), g.get("figure", False)
    return Given(name, g["value"], *read, _latex(name, g))


def _symbol(name, s):
    s = s if isinstance(s, dict) else {"unit": s}
    _check_keys(s, name, ("unit",), ("vary", "symbol"))
    vary = _range(name, s) or SYMBOL_RANGES.get(s["unit"], OTHER_RANGE)
    return Symbol(name, _unit(name, s), vary, _latex(name, s))


def _answer(a):
    optional = ("unit", "of", "atol", "weight", "follow_through", "symbol", "because", "quantity")
    _check_keys(a, "an answer", ("key", "kind", "means"), optional)
    key, name, of, atol = _text(a, "key"), _text(a, "kind"), a.get("of", []), a.get("atol", 1e-6)
    _require(name in KINDS, f"{key}: kind {name!r} is not one of {', '.join(sorted(KINDS))}")
    kind = KINDS[name]
    fault = f"{key}: of must be the list of words to choose from, not {short(of)}"
    _require(isinstance(of, list), fault)
    _require(
        kind.has_options == bool(of),
        f"{key}: a choice, and no other kind, has of: [...] with its words; this is a {kind}",
    )
    _require(len(set(map(str, of))) == len(of), f"{key}: of has a word twice: {short(of)}")
    _require(
        all(isinstance(w, str) and not set(w) & set("|\n") for w in of),
        f"{key}: of must be a list of words without a |, not {short(of)}; yes and no need "
        'quotation marks: ["yes", "no"]',
    )
    fault = f"{key}: atol must be a number, as in 1e-6, not {short(atol)}"
    _require(_is_number(atol), fault)
    weight = a.get("weight", 1.0)
    fault = f"{key}: weight must be a positive number, as in 2, not {short(weight)}"
    _require(_is_number(weight) and 0 < weight < math.inf, fault)
    follow = a.get("follow_through", 0.0)
    fault = f"{key}: follow_through must be a number from 0 to 1, as in 0.5, not {short(follow)}"
    _require(_is_number(follow) and 0 <= follow <= 1, fault)
    numbers = float(atol), float(weight), float(follow)
    because = _text(a, "because") if "because" in a else ""
    _require(kind.has_options or not because, f"{key}: because is for a choice; this is a {kind}")
    quantity = _text(a, "quantity") if "quantity" in a else ""
    _require(
        not quantity or (quantity in QUANTITIES and kind.length == 1),
        f"{key}: quantity is {' or '.join(QUANTITIES)}, of one number or formula; "
        f"this is {quantity}, a {kind}",
    )
    read = _unit(key, a), _text(a, "means"), tuple(of), *numbers
    return Answer(key, kind, *read, latex=_latex(key, a), because=because, quantity=quantity)


def _step(key, s):
    optional = ("unit", "section", "equation", "kind", "of_givens")
    _check_keys(s, f"the step {key}", ("means",), optional)
    of_givens = s.get("of_givens", False)
    fault = f"{key}: of_givens must be true or false, not {short(of_givens)}"
    _require(type(of_givens) is bool, fault)
    texts = {name: _text(s, name) for name in s if name != "of_givens"}
    return texts | {"unit": _unit(key, s), "of_givens": of_givens}


def _mistakes(named):
    """{mistake: its text}, from entries that are a text or {text: ..., same_in_book: true}."""
    for name, entry in named.items():
        if isinstance(entry, dict):
            _check_keys(entry, f"the mistake {name}", ("text",), ("same_in_book",))
            same = entry.get("same_in_book", False)
            fault = f"{name}: same_in_book must be true or false, not {short(same)}"
            _require(type(same) is bool, fault)
    return {
        n: _text(entry, "text") if isinstance(entry, dict) else _text(named, n)
        for n, entry in named.items()
    }


def _checked(found, asked):
    for key, value in found.items():
        asks = f"the answers are {', '.join(asked)}"
        _require(key in asked, f"checked has {key}, which is not asked for; {asks}")
        _require(
            value is not None and not isinstance(value, dict),
            f"checked: {key} must be a number, a formula, or a list of them, not {short(value)}",
        )
    return found


# -- parts of entries


def _require(holds, fault):
    """Raise ``fault`` as an error unless ``holds``."""
    if not holds:
        raise CatalogueError(fault)


def _check_keys(entry, what, needed, optional):
    """Refuse all but a mapping with the ``needed`` and at most the ``optional`` keys."""
    keys = f"its keys are {', '.join(needed)} and optionally {', '.join(optional)}"
    if not isinstance(entry, dict):
        raise CatalogueError(f"{what} must be written as key: value, not {short(entry)}; {keys}")
    if unknown := [key for key in entry if key not in (*needed, *optional)]:
        close = meant(unknown[0], (*needed, *optional))
        raise CatalogueError(f"{what} has the unknown key {unknown[0]!r}; {keys}{close}")
    for key in needed:
        _require(key in entry, f"{what} needs the key {key!r}; {keys}")


def _text(entry, key):
    """The text under a key, on one line; "" if it is missing."""
    text = entry.get(key, "")
    fault = f"{key} must be a text, not {short(text)}; put it in quotation marks"
    _require(isinstance(text, str), fault)
    return " ".join(text.split())


def _named(entry, key):
    """The mapping from names under a key, empty if it is missing."""
    named = entry.get(key) or {}
    fault = f"{key} must be written as name: value, not {short(named)}"
    _require(isinstance(named, dict), fault)
    for name in named:
        _require(
            isinstance(name, str) and name.isidentifier(),
            f"{key}: {name!r} is not a name: write letters, digits and _, in quotation marks if "
            "YAML takes it for something else",
        )
    return named


def _texts(entry, key):
    named = _named(entry, key)
    return {name: _text(named, name) for name in named}


def _unit(name, entry):
    text = entry.get("unit", "1")
    fault = f'{name}: unit must be a text, as in mm/s or "1", not {short(text)}'
    _require(isinstance(text, str), fault)
    unit(text)
    return text


def _latex(name, entry):
    """The symbol of a quantity, in LaTeX, where it does not follow from the name."""
    text = _text(entry, "symbol")
    _require(
        not set("$=") & set(text) and text.count("{") == text.count("}"),
        rf"{name}: symbol must be the LaTeX of one symbol without dollar signs, as in "
        rf"'\dot\beta', not {short(text)}",
    )
    return text


def _is_number(x):
    return isinstance(x, (int, float)) and not isinstance(x, bool)


def _range(name, entry):
    """The range to draw from, (low, high), or None."""
    vary = entry.get("vary")
    if vary is None:
        return None
    pair = isinstance(vary, list) and len(vary) == 2 and all(map(_is_number, vary))
    _require(
        pair and vary[0] < vary[1],
        f"{name}: vary must be [low, high], two numbers with the lower one first, not "
        f"{short(vary)}",
    )
    return tuple(vary)
