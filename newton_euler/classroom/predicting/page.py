"""Predictions as HTML: folded for a page without a kernel, which the site's script makes a form of;
open where the kernel has the buttons.
"""

import re
from html import escape, unescape

from ...algebra.language import _
from .question import Question, with_unit

STATIC = "application/vnd.newton-euler.static+html"  # what a page without a kernel shows


def inline(text: str) -> str:
    """Markdown of one line as HTML: formulas, code, bold and italics."""
    parts = re.split(r"(\$[^$]+\$|`[^`]+`)", text)
    return "".join(_part(part) for part in parts)


def _part(part):
    if len(part) > 1 and part[0] == part[-1] == "$":
        return rf'<span class="math notranslate nohighlight">\({escape(part[1:-1], False)}\)</span>'
    if len(part) > 1 and part[0] == part[-1] == "`":
        return f"<code>{escape(part[1:-1], False)}</code>"
    bold = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", escape(part, False))
    return re.sub(r"\*(.+?)\*", r"<i>\1</i>", bold)


def folded_html(q: Question) -> str:
    """The question with its choices or its answer folded."""
    body = "".join(_choice(q, c) for c in q.choices) if q.choices else _form(q) + _folded_answer(q)
    return f'<div class="prediction" data-key="{escape(q.key)}">{_asked(q)}{body}</div>'


def _asked(q):
    return f'<p class="question"><b>{_("Predict.")}</b> {inline(q.text)}</p>'


def _choice(q, choice):
    right, means = " data-right" * (choice == q.right), inline(_means(q, choice))
    summary = f"<summary>{inline(choice)}</summary>"
    return f'<details class="choice"{right}>{summary}<p>{means}</p></details>'


def _means(q, choice):
    """What a choice means; of the right one also why."""
    return f"{q.choices[choice]} {q.why if choice == q.right else ''}".strip()


def _form(q):
    """What is typed, for the script; hidden without it."""
    number = {"answer": q.number, "within": q.within, "unit": q.unit}
    data = "".join(f' data-{name}="{escape(str(x))}"' for name, x in number.items())
    data *= q.number is not None
    name = escape(re.sub(r"[$*`\\{}]", "", q.text))
    return (
        f'<form{data} hidden><input type="text" aria-label="{name}" autocomplete="off"> '
        f"{escape(q.unit)} <button>{_('Predict')}</button></form>"
    )


def _folded_answer(q):
    mistakes = "".join(
        f'<p class="mistake" data-value="{m!r}">{escape(with_unit(m, q.unit))}: {inline(words)}</p>'
        for m, words in (q.mistakes or {}).items()
    )
    return (
        f'<details class="answer"><summary>{_("Answer")}</summary>'
        f"<p>{_answer(q)}</p>{mistakes}</details>"
    )


def _answer(q):
    return " ".join(filter(None, (f"<b>{escape(q.answer)}.</b>" * bool(q.answer), inline(q.why))))


def opened(q: Question, given: str | None, note: str = "") -> str:
    """The question as a notebook shows it beside its buttons; with a prediction also the answer."""
    listed = "".join(f"<li>{inline(c)}</li>" for c in q.choices or ())
    choices = f'<ol type="a">{listed}</ol>' if listed else ""
    judged = "" if given is None else _judged(q, given) + f"<p>{escape(note)}</p>" * bool(note)
    return f'<div class="prediction">{_asked(q)}{choices}{judged}</div>'


def _judged(q, given):
    found = q.judge(given)
    mark = {True: "✓", False: "✗", None: "·"}[found.right]
    first = f"<p>{mark} {_('You predicted:')} <b>{inline(given)}</b>. {inline(found.words)}</p>"
    if q.choices and found.right:
        return f"{first}<p>{inline(q.why)}</p>"
    chosen = q.choices and f"<b>{inline(q.right)}</b>. {inline(_means(q, q.right))}"
    return f"{first}<p>{_('The answer:')} {chosen or _answer(q)}</p>"


def plain(html: str) -> str:
    """HTML as text, for a terminal."""
    broken = re.sub(r"</p>|</li>|</ol>", "\n", html).replace("<li>", "- ")
    bare = re.sub(r"<[^>]+>", "", broken).replace(r"\(", "").replace(r"\)", "")
    return unescape(bare).strip()
