"""The page on which a problem is chosen: all of them in one table, which its script filters. It has
the data of ``python -m grader problems``: no answer, no step and no mistake.
"""

import re
from collections.abc import Iterable
from html import escape

from exercises.catalogue import Problem, problems
from exercises.catalogue.survey import Entry, entry
from grader.assignment.notebook import slug
from newton_euler.algebra.language import Words, spoken

PAGE = """\
# {title}

{about}

```{{raw}} html
<form class="choose" role="search" hidden>
<label>{words} <input type="search" name="words"></label>
<label>{section} <input name="section" size="6" placeholder="{or_}"></label>
<label>{kind} <select name="kind"><option value="">{any}</option>{kinds}</select></label>
<label>{equation} <input name="equation" size="6" placeholder="4.18"></label>
<label>{difficulty} <input name="difficulty" type="number" min="1" max="5"></label>
<label>{minutes} <input name="minutes" type="number" min="5" step="5"></label>
<label>{steps} <input name="steps" type="number" min="0"></label>
<label>{sheets} <input name="sheets" type="number" min="1"></label>
</form>
<p class="chosen" role="status"></p>
<div class="problems"><table class="docutils problems"><thead><tr>{heads}</tr></thead>
<tbody>
{rows}
</tbody></table></div>
```
"""
LABELS = {
    "title": Words("Choose a problem"),
    "about": Words(
        "Difficulty (1 to 5) and minutes are estimates from the steps and operations of the "
        "solution; sheets is how many sets of numbers can be drawn. A practice file of your "
        "instructor's opens [here](own.md)."
    ),
    "words": Words("Words"),
    "section": Words("Section"),
    "or_": Words("4 or 4.10"),
    "kind": Words("Kind of answer"),
    "any": Words("any"),
    "equation": Words("Equation"),
    "difficulty": Words("Difficulty at most"),
    "minutes": Words("Minutes at most"),
    "steps": Words("Steps at most"),
    "sheets": Words("Sheets at least"),
}
HEADS = (
    Words("problem"), Words("section"), Words("title"), Words("asks for"), Words("equations"),
    Words("steps"), Words("difficulty"), Words("min"), Words("sheets"),
)  # fmt: skip


def page(names: Iterable[str]) -> str:
    """The text of the page, of the problems of these chapters."""
    found = [(p, entry(p)) for name in names for p in problems(name)]
    kinds = sorted({kind for p, e in found for kind in e.kinds})
    return PAGE.format(
        **{name: spoken(text) for name, text in LABELS.items()},
        kinds="".join(f'<option value="{k}">{k.replace("_", " ")}</option>' for k in kinds),
        heads="".join(f'<th scope="col">{spoken(head)}</th>' for head in HEADS),
        rows="\n".join(_row(p, e) for p, e in found),
    )


def _row(p: Problem, e: Entry) -> str:
    steps = e.steps + e.terms
    words = " ".join(re.sub(r"[{}$\\]", " ", f"{p.id} {p.title} {p.text}").lower().split())
    data = {
        "words": words, "section": e.section, "kind": " ".join(e.kinds),
        "equation": " ".join(e.equations), "difficulty": e.difficulty, "minutes": e.minutes,
        "steps": steps, "sheets": e.sheets,
    }  # fmt: skip
    kinds, equations = ", ".join(e.kinds).replace("_", " "), ", ".join(e.equations)
    link = f'<a href="{slug(p.id)}.html">{p.id}</a>'
    sheets = e.sheets if e.sheets < 1000 else "1000+"
    cells = (
        link,
        e.section,
        escape(p.title),
        kinds,
        equations,
        steps,
        e.difficulty,
        e.minutes,
        sheets,
    )
    attributes = "".join(f' data-{name}="{escape(str(x))}"' for name, x in data.items())
    return f"<tr{attributes}>{''.join(f'<td>{x}</td>' for x in cells)}</tr>"
