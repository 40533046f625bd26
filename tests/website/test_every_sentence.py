"""Every text that a student sees comes from the catalogue: with a pseudo-language switched on,
whatever is still English is found.
"""

import json
from base64 import b64encode
from contextlib import contextmanager

import pytest

from exercises import problem
from exercises.catalogue import chapter, sections, sources
from exercises.catalogue import translations as texts
from grader.assignment import build_notebook, personal_notebook
from grader.assignment.solution import worked_solution
from grader.practice import write_practice
from grader.scoring import score_receipt
from grader.submission import feedback_comment
from newton_euler.algebra import language
from newton_euler.algebra.names import did_you_mean
from newton_euler.answers import KINDS, AnswerError, expect, receipt
from newton_euler.classroom import Practice, PracticeFileError, predict, predict_again, tally
from newton_euler.classroom.practising.files import PracticeFile
from newton_euler.classroom.practising.progress import Progress
from tests.website import feedback
from tests.website.pseudo import bare, catalogue, wide
from website import contents, problem_index, translations
from website.browser import practice as page
from website.rendering import rendered

PROBLEMS = "4/16", "9/4", "2/4", "5/19"  # a sum of terms, a word, an interval, a count
NAMES = {  # code, files and units, wherever they stand
    *["None", "Python", "NumPy", "nbgrader", "CSV", "rad", "deg", "sin", "cos", "sqrt", "omega", "alpha", "beta", "theta", "phi"],
    *["practice", "notebook", "grader", "json", "newton_euler", "Newton", "Euler", "ada", "Vector", "Frame", "SymPy"],
}  # fmt: skip


@pytest.fixture(scope="module")
def wide_folder(tmp_path_factory):
    """A catalogue and the texts of some problems in that language, "xx"."""
    folder = tmp_path_factory.mktemp("languages")
    catalogue(folder / "xx.po", translations.sentences())
    for name in {problem(number).chapter for number in PROBLEMS}:
        (folder / name / "xx").mkdir(parents=True)
        title = {"title": wide(f"Chapter {name}"), "preamble": wide(chapter(name).preamble)}
        (folder / name / "xx/chapter.yaml").write_text(json.dumps(title))
    for number in PROBLEMS:
        file = folder / problem(number).chapter / "xx" / f"{problem(number).name}.yaml"
        file.write_text(json.dumps(_wide(sources.english(number))))
    return folder


def _wide(x):
    return {k: _wide(v) for k, v in x.items()} if isinstance(x, dict) else wide(x)


@contextmanager
def speaking(folder):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(language, "FOLDER", folder)
        patch.setattr(texts, "home", lambda name: folder / name)
        patch.setattr(sections, "headings", dict)  # of the chapters
        with language.speaking("xx"):
            yield


@pytest.fixture(autouse=True)
def spoken(wide_folder):
    with speaking(wide_folder):
        yield


def names_of(*numbers):
    """The names in the code of these problems."""
    found = set(NAMES)
    for p in map(problem, numbers):
        found |= {*p.units, *(a.key for a in p.answers), *p.steps, *p.mistakes}
        found |= {part for name in found for part in name.split("_")}
        found |= {word for a in p.answers for word in a.of}
    return found


def assert_nothing_is_english(found, names):
    """Fail with the English words of these texts, and what comes before and after each."""
    for text in found:
        for word in bare(text, names):
            at = text.find(word)
            pytest.fail(f"{word!r} in {text[max(at - 60, 0) : at + 60]!r}", pytrace=False)


def output_of(f, *args, **named):
    """What a call says, or the error that it raises."""
    try:
        return str(f(*args, **named))
    except (AnswerError, PracticeFileError, language.NewtonEulerError) as error:
        return str(error)


@pytest.fixture(scope="module")
def file(tmp_path_factory, wide_folder):
    path = tmp_path_factory.mktemp("practice") / "some.practice"
    with speaking(wide_folder):
        write_practice(path, map(problem, PROBLEMS), 2, draw=_no_figure)
    return path


def _no_figure(p, values):
    return None


@pytest.mark.parametrize("number", PROBLEMS)
def test_practice_of_a_problem(file, number):
    book = Practice([PracticeFile(file)], Progress(None))
    p = book[number]
    found = [repr(p), p._repr_markdown_(), *p.meanings.values()]
    wrong = {}, {"q_9": 1}, {next(iter(p.answers)): "x"}
    found += [output_of(p.check, **given) for given in wrong]
    found += [output_of(p.check_step, **{next(iter(p.answers)): 1}), output_of(p.check_step, q_9=1)]
    for label, x in _wrong(p):
        found.append(str(_checked(p, label[0], x)))
    found += [str(_checked(p, key, x)) for key, x in p.solved.items()]
    found += [p.next_step().markdown for _ in range(3 * len(p.quantities) + 1)]
    p.new()
    found += [p.next_step().text for _ in range(3 * len(p.quantities) + 1)]
    found += [p.solution().markdown, p.solution().text, book.table.markdown, book.next.text]
    found += book.mastery.values()
    assert_nothing_is_english(found, names_of(*PROBLEMS))


def _wrong(p):
    """[(label, numbers)] of a listed mistake or slip of each sentence."""
    found = {}
    for name, of in (("wrong", "labels"), ("slips", "slips")):
        labels = p._page[of]
        found |= {labels[n][3][0]: (labels[n], x) for n, x in p._variant[name]}
    return found.values()


def _checked(p, key, x):
    q = p._asked[key]
    x = x if q.kind.is_word and not isinstance(x, (list, tuple)) else list(x)
    if isinstance(x, list):
        x = x[0] if q.kind.length == 1 else q.kind.nested(x)
    return (p.check_step if q.step else p.check)(**{key: x}).markdown


def test_a_page_of_practice(file):
    data = b64encode(file.read_bytes()).decode()
    page.load("some", data, language="xx")
    found = [json.dumps(page.show("9/4"), ensure_ascii=False)]
    typed = ["x", "1,5", "[1", "1/0", "b*q", "9**999", "sqrt(-1)", "asin(2)", "[1,2]"]
    for text in ("", *typed, "1+" * 300):
        found.append(page.read("9/4", "H_O", [text, "0", ""])["fault"])
        found.append(str(page.check("9/4", {"H_O": [text, "0", "0"], "I_xx": [text]})["found"]))
    found += [page.hint("9/4")["text"], page.solution("9/4")["text"]]
    found += [page.advice({"9/4": ["", "9.3"]}, "9/4")["sentence"], page.advice({}, "")["sentence"]]
    refused = output_of(page.load, "x", b64encode(b"x").decode(), "xx")
    found += [output_of(page.take_in, "x"), refused.partition(": ")[0]]
    found += [output_of(page.show, "9/9"), output_of(page.read, "9/4", "no", [])]
    keys = {
        "verdict",
        "unreadable",
        "text",
        "wrong",
        "right",
        "blank",
        "True",
        "False",
        "true",
        "false",
    }
    keys |= {*KINDS, *page.show("9/4"), *page.show("9/4")["answers"][0]}
    assert_nothing_is_english(found, names_of("9/4") | keys)


def test_receipts_of_every_kind_with_what_they_cannot_read():
    forms = {name: f"{name}, m" for name in KINDS if name != "choice"}
    forms |= {"choice": "choice: lit | dark", "count": "count"}
    expect("0/1", {"r": "m", "omega": "rad/s"}, **forms)
    found = [output_of(receipt, "0/1"), output_of(receipt, "0/2"), output_of(receipt, "0/1", q_9=1)]
    given = "x", 3, [1, 2], [1, 2, 3], [[1, 0, 0], [0, 1, 0], [0, 0, 1]], 1j, float("nan"), object
    for name in forms:
        found += [output_of(receipt, "0/1", **{name: x}) for x in given]
    expect("0/3", sane={"t": "positive"}, t="number, s")
    found += [output_of(receipt, "0/3", t=-1), output_of(did_you_mean, "Coriolis", ["coriolis"])]
    names = {*NAMES, *forms, "lit", "dark", "coriolis", "nan", "class", "object"}
    assert_nothing_is_english(found, names)


def test_feedback_on_right_wrong_unreadable_and_missing_answers():
    p = problem("9/4")
    right = {key: _plain(x) for key, x in p.solve(p.book_values).items()}
    wrong = [{key: _plain(x) for key, x in w.items()} for w in p.wrong(p.book_values).values()]
    receipts = [{"answers": {**right, **w}} for w in wrong]
    receipts += [{"answers": {}}, {"answers": {"H_O": [1]}}, None, {"answers": right, "error": "x"}]
    found = []
    for r in receipts:
        score = score_receipt(p, p.book_values, r)
        found += [feedback_comment(score), feedback_comment(score.without_reasons)]
        found += feedback.verdicts(score).values()
    found.append(worked_solution(p, p.book_values))
    found.append(feedback.page(p.id, {**right, "H_O": [1, 2, 3], "F_A": [1]}))
    assert_nothing_is_english(found, names_of(p.id))


def _plain(x):
    return x if isinstance(x, str) else [float(c) for c in x.c] if hasattr(x, "c") else float(x)


@pytest.mark.parametrize("exam", [False, True])
def test_a_sheet_as_it_is_handed_out(exam):
    ps = list(map(problem, PROBLEMS))
    made = build_notebook(ps, "hw1", 10, 60, exam=exam)
    own = personal_notebook(made, "ada", {p.id: p.book_values for p in ps}, {})
    found = [c["source"] for n in (made, own) for c in n["cells"] if c["cell_type"] == "markdown"]
    sources = [c["source"] for c in own["cells"] if c["cell_type"] == "code"]
    found += [line.partition("#")[2] for text in sources for line in text.splitlines()]
    names = names_of(*PROBLEMS) | {"SOLUTION", "BEGIN", "END", *KINDS, "ada"}
    assert_nothing_is_english(found, names)


def test_predictions():
    made = [
        predict(wide("How?"), {True: wide("So."), False: wide("Not.")}, True, why=wide("Why.")),
        predict(wide("How many?"), {4.0: wide("Twice.")}, 2.0, "m", 0.1),
        predict(wide("In your words?")),
    ]
    found = []
    for p, answer in zip(made, ("b", "4", wide("so")), strict=True):
        found += [repr(p), p.html(), repr(tally()), repr(predict_again(p)), str(p.judge(answer))]
        p.question.judge(answer)
    names = {*NAMES, "Judged", "right", "words", "prediction", "True", "False"}
    assert_nothing_is_english(found, names)


def test_the_pages_of_the_site():
    found = [problem_index.page(["ch09"]), rendered("taken.md")]
    found += [contents.page([], ["ch09"], {})]
    names = names_of(*(f"9/{n}" for n in range(1, 10)))
    assert_nothing_is_english(found, names)
