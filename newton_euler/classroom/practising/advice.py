"""What to do next: chosen from what went wrong, by section and mistake, and spaced over days."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import date, timedelta
from typing import Any

from ...algebra.language import Words, _, joined, plural
from .progress import Progress, at_first_go

# days until a problem comes again, by how many sets of its numbers were right at first go
GAPS = 1, 3, 7, 21, 60


@dataclass(frozen=True)
class Advice:
    """The problem to do next, or "", and why, as a sentence."""

    problem: str
    sentence: str


@dataclass(frozen=True)
class _Done:
    """What is known of a problem that was tried."""

    problem: str
    section: str
    day: date
    due: date
    open: list[str]  # quantities that were wrong and are not right yet
    missed: list[tuple[str, list[str]]]  # (quantity, cause) of those that went wrong at first


def advise(
    sections: Mapping[str, str],
    progress: Progress,
    now: str = "",
    may_err: Callable[[str], set[tuple[str, str]]] = lambda problem: set(),
) -> Advice:
    """What to do next of the problems, {number: section} in the order of the book.

    now : the problem that has just been worked, which is not proposed again once it is finished
    may_err : function of a problem, the (group, name) of the causes that can be seen in it
    """
    today = progress.today()
    done = [d for p, s in sections.items() if (d := _done(p, s, progress))]
    latest = sorted(done, key=lambda d: d.day, reverse=True)
    for d in latest:
        if d.open and d.day == today:
            text = Words("{problem} is unfinished: {names} is not right yet.")
            return Advice(d.problem, _(text, problem=d.problem, names=joined(d.open[:3])))
    for d in sorted(done, key=lambda d: d.due):
        if d.due <= today and d.problem != now:
            text = Words("Again {problem}, with other numbers: {why}.")
            return Advice(d.problem, _(text, problem=d.problem, why=_why(d, today)))
    fresh = [p for p in sections if p not in {d.problem for d in done} and p != now]
    for d in latest:
        if d.missed and (near := _alike(d, fresh, sections, may_err)):
            text = Words("{problem} is from section {number}, too: {why}.")
            return Advice(near, _(text, problem=near, number=d.section, why=_why(d, today)))
    if fresh:
        return _onwards(fresh, sections, latest)
    if done:
        first = min(done, key=lambda d: d.due)
        days = max((first.due - today).days, 1)
        return Advice("", plural(
            "All done for now. {problem} comes again in a day.",
            "All done for now. {problem} comes again in {n} days.", days, problem=first.problem,
        ))  # fmt: skip
    return Advice("", _("There is no problem to do."))


def _done(problem, section, progress):
    variants = progress.entries(problem)
    entries = [(key, e) for v in variants.values() for key, e in v.items()]
    if not entries:
        return None
    day = max(date.fromisoformat(e.get("day", "2000-01-01")) for _, e in entries)
    well = sum(all(map(at_first_go, v.values())) for v in variants.values())
    missed = [(key, e.get("cause", [])) for key, e in entries if not at_first_go(e)]
    unfinished = [key for key, e in entries if e["tries"] and not e["right"] and e["help"] < 3]
    due = day + timedelta(GAPS[min(well, len(GAPS) - 1)])
    return _Done(problem, section, day, due, list(dict.fromkeys(unfinished)), missed)


def _why(d, today):
    """What happened in a problem, as the end of a sentence."""
    days = (today - d.day).days
    when = _("today") if days < 1 else plural("yesterday", "{n} days ago", days)
    for key, cause in reversed(d.missed):
        if cause:
            text = Words("{when} your {key} of {problem} fitted a solution that {cause}")
            return _(text, when=when, key=key, problem=d.problem, cause=cause[2])
    if not d.missed:
        return _("{when} all of it was right", when=when)
    names = joined(list(dict.fromkeys(key for key, _cause in d.missed))[:3])
    return _("{when} you needed help, or more than one try, for {names}", when=when, names=names)


def _alike(d, fresh, sections, may_err):
    """A new problem of the same section, best one in which the same mistake can be made."""
    near = [p for p in fresh if sections[p] == d.section]
    causes = {tuple(cause[:2]) for key, cause in d.missed if cause}
    return next((p for p in near if causes & may_err(p)), near[0] if near else None)


def _onwards(fresh, sections, latest):
    """The next new problem: of the section that was practised last, or the first after it."""
    if not latest:
        first = fresh[0]
        begin = _("Begin with {problem}, section {number}.", problem=first, number=sections[first])
        return Advice(first, begin)
    order = list(sections)
    place = order.index(latest[0].problem)
    p = next((p for p in fresh if order.index(p) > place), fresh[0])
    text = Words("{problem} begins section {number}: what you tried before is right.")
    if sections[p] == latest[0].section:
        text = Words("{problem} goes on with section {number}: what you tried before is right.")
    return Advice(p, _(text, problem=p, number=sections[p]))


def causes_of(page: Mapping[str, Any]) -> set[tuple[str, str]]:
    """The (group, name) of the causes that a page of a practice file can name."""
    return {(group, name) for key, group, name, *more in page["labels"]}
