"""The forms of answers, as "vector, mm/s": a kind with its unit or its words."""

from dataclasses import dataclass

from ..algebra.errors import checked, checked_but
from ..algebra.language import Words, _, spoken
from .kinds import KINDS, Kind
from .messages import AnswerError


@checked_but("kind")
@dataclass(frozen=True)
class Form:
    """The kind of one answer (a :class:`~.kinds.Kind` or its name), its unit, and of a choice the
    words.

    >>> Form.read("vector, mm/s")
    Form(kind=KINDS['vector'], unit='mm/s', of=())
    """

    kind: Kind
    unit: str = "1"
    of: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.kind, Kind):
            object.__setattr__(self, "kind", kind_named(self.kind))

    @classmethod
    @checked
    def read(cls, text: str) -> "Form":
        """The form that a notebook states as text: "vector, mm/s", "choice: stable | unstable"."""
        name, colon, words = (part.strip() for part in text.partition(":"))
        if colon and name in KINDS and KINDS[name].has_options:
            return cls(KINDS[name], "1", tuple(w.strip() for w in words.split("|")))
        name, _comma, unit = (part.strip() for part in text.partition(","))
        kind = kind_named(name)
        if kind.has_options:
            wrong = Words("a {kind} lists its words: '{kind}: one | another', not {text}")
            raise AnswerError(wrong, kind=kind, text=repr(text))
        return cls(kind, unit or "1")

    def __str__(self) -> str:
        return self.kind.name + self._asked

    @property
    def _asked(self):
        return f": {' | '.join(self.of)}" if self.kind.has_options else f", {self.unit}"

    @property
    def stated(self) -> str:
        """The form as a reader reads it: "vector, mm/s", "Vektor, mm/s"."""
        return spoken(self.kind.title) + self._asked

    @property
    def words(self) -> str:
        """The form in words for a reader."""
        if self.kind.has_options:
            return _("one of {words}", words=", ".join(map(repr, self.of)))
        words = spoken(self.kind.words)
        return words if self.unit == "1" else _("{words}, in {unit}", words=words, unit=self.unit)

    @checked
    def error(self, fault: str, /, **values: object) -> AnswerError:
        """An :class:`AnswerError` that says what was expected, then the fault, a sentence with its
        values as for :func:`~..algebra.language._`.
        """
        line = " ".join(_(fault, **values).split())
        return AnswerError("expected {words}; {fault}", words=self.words, fault=line)


def kind_named(name: str) -> Kind:
    """The kind of this name. Raises :class:`AnswerError` for an unknown one."""
    if name not in KINDS:
        text = Words("no such kind of answer: {name}; there are {kinds}")
        raise AnswerError(text, name=repr(name), kinds=", ".join(KINDS))
    return KINDS[name]
