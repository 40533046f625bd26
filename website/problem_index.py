"""The page on which a problem is chosen: all of them in one table, which its script filters. It has
the data of ``python -m grader problems``: no answer, no step and no mistake.
"""

import re
from collections.abc import Iterable
from html import escape

from exercises.catalogue import Problem, problems
from exercises.catalogue.survey import Entry, entry

from .problem_pages import anchor

PAGE = """\
# Choose a problem

Difficulty (1 to 5) and minutes are estimates from the steps and operations of the solution; sheets is how many sets of numbers can be drawn.

```{{raw}} html
<form class="choose" role="search" hidden>
<label>Words <input type="search" name="words"></label>
<label>Section <input name="section" size="6" placeholder="4 or 4.10"></label>
<label>Kind of answer <select name="kind"><option value="">any</option>{kinds}</select></label>
<label>Equation <input name="equation" size="6" placeholder="4.18"></label>
<label>Difficulty at most <input name="difficulty" type="number" min="1" max="5"></label>
<label>Minutes at most <input name="minutes" type="number" min="5" step="5"></label>
<label>Steps at most <input name="steps" type="number" min="0"></label>
<label>Sheets at least <input name="sheets" type="number" min="1"></label>
</form>
<p class="chosen" role="status"></p>
<div class="problems"><table class="docutils problems"><thead><tr>{heads}</tr></thead>
<tbody>
{rows}
</tbody></table></div>
```
"""  # noqa: E501  # a text for readers
HEADS = (
    "problem",
    "section",
    "title",
    "asks for",
    "equations",
    "steps",
    "difficulty",
    "min",
    "sheets",
)


def page(names: Iterable[str]) -> str:
    """The text of the page, of the problems of these chapters."""
    found = [(p, entry(p)) for name in names for p in problems(name)]
    kinds = sorted({kind for _, e in found for kind in e.kinds})
    return PAGE.format(
        kinds="".join(f'<option value="{k}">{k.replace("_", " ")}</option>' for k in kinds),
        heads="".join(f'<th scope="col">{head}</th>' for head in HEADS),
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
    link = f'<a href="{p.chapter}.html#{anchor(p.id)}">{p.id}</a>'
    cells = link, e.section, escape(p.title), kinds, equations, steps, e.difficulty, e.minutes
    attributes = "".join(f' data-{name}="{escape(str(x))}"' for name, x in data.items())
    return f"<tr{attributes}>{''.join(f'<td>{x}</td>' for x in (*cells, f'{e.sheets:.3g}'))}</tr>"
