"""The worked solution made from the steps of a problem."""

import math
import random
import re
from functools import cache
from itertools import combinations, islice, permutations

import pytest
import sympy

from exercises.catalogue import select
from exercises.catalogue.book_equations import own_number
from exercises.catalogue.steps import steps
from exercises.catalogue.variants import draw, flat, symbol_points, symbol_values
from grader.assignment.derivations import derivations
from grader.assignment.layout import laid_out
from grader.assignment.lines import lines
from grader.assignment.notebook import typeset
from grader.assignment.solution import worked_solution
from grader.assignment.spelled import typeset_formulas
from newton_euler.algebra.scalars import is_numeric, to_plain
from newton_euler.algebra.units import unit
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.notation import number_symbol, symbol
from tests.book import sections

ALL = select(["all"])
# one problem in six by default
EACH = [p if n % 6 == 0 else pytest.param(p, marks=pytest.mark.slow) for n, p in enumerate(ALL)]
SECTION_OF = {
    f"{section.partition('.')[0]}.{n}": section
    for section, _, numbered, _ in sections()
    for n in numbered
}
NAMED_GIVENS = {"A/20", "A/22", "2/16", "3/5"}  # where the point is that a quantity is a given
FUNCTIONS_OF_MATH = {name: getattr(math, name) for name in dir(math) if name[0] != "_"}
VECTOR = KINDS["vector"]


SEEDS = (b"one", *(pytest.param(seed, marks=pytest.mark.slow) for seed in (b"two", b"three")))
NAME = re.compile(r"(?<![\w.])[A-Za-z]\w*")
QUANTITY = re.compile(r"(?<![\w.])(\d[\d.]*(?:e[-+]\d+)?) ([A-Za-z][\w/^*]*)")


@cache
def numbers(p, seed):
    return {**draw(p, seed), **p.sympy_symbols()}


@cache
def computed(p, seed):
    return steps(p, numbers(p, seed))


@cache
def derived(p, seed):
    return derivations(p, numbers(p, seed))


@cache
def as_python(p, seed):
    return list(lines(p, numbers(p, seed), latex=False))


@cache
def as_latex(p, seed):
    return list(lines(p, numbers(p, seed)))


@cache
def written(p, seed, text=True):
    return worked_solution(p, numbers(p, seed), text=text)


@pytest.mark.one_in(8)
@pytest.mark.parametrize("seed", SEEDS, ids=bytes.decode)
@pytest.mark.parametrize("p", ALL, ids=lambda p: p.id)
def test_a_worked_solution_has_the_students_numbers_and_every_answer(p, seed):
    values = numbers(p, seed)
    text = written(p, seed)
    for a in p.answers:
        assert typeset_formulas(a.means, p.notation, lambda x: typeset(x, p))[1:] in text
    for name, given in p.givens.items():
        assert number_symbol(values[name]) in text, given
    for formula in re.findall(r"\$([^$]*)\$", text):
        assert re.sub(r"\\[{}]", "", formula).count("{") == formula.replace("\\}", "").count("}")
        assert len(re.findall(r"\\left\b", formula)) == len(re.findall(r"\\right\b", formula))
    assert text.count("$") % 2 == 0
    assert {*re.findall(r"\\(?:d?dot|hat|bar|text|mathbf)[A-Za-z]+", text)} <= {r"\dots"}
    own = text.partition("*Solution*")[2]
    cited = {int(n) for n in re.findall(r"(?:By equation|section [\d.]+,) \((\d+)\.", own)}
    assert not cited or max(cited) <= int(p.id.partition("/")[0].replace("A", "1"))
    assert all(len(digits(x)) <= 6 for x in re.findall(r"\d*\.\d+", own)), own
    before, above, _ = own.partition("from the equations above")
    assert not above or re.search(r"[Ff]rom \$", before), "equations are solved that are not shown"
    words = re.sub(r"\$[^$]*\$", "§", own)
    assert re.findall(rf"§['/^]|[/^]§|§ [-+=<>x/] |\) x \b|{DOT}|{PRIME}", words) == []
    for name, equal in re.findall(r"\$([^$=]*) = [^$]*\$ \$= ([^$]*)\$", own):
        assert name != equal, own


DOT, PRIME = r"\b[A-Z] \. [A-Z§]", r"\b[a-z]'+(?![a-z])"


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_cited_equation_is_in_the_cited_section(p):
    for s in computed(p, b"one"):
        if s.section and s.equation and own_number(s.equation, p):
            assert SECTION_OF[s.equation] == s.section, s.key


@pytest.mark.parametrize("p", [p for p in ALL if any(a.of for a in p.answers)], ids=lambda p: p.id)
def test_a_worked_solution_says_why_a_word_is_right(p):
    text = written(p, b"one")
    for a in p.answers:
        if a.of:
            assert a.because, a.key
            assert f"$. {a.because[:2]}" in text


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_the_sum_of_the_terms_that_are_shown_is_shown_too_and_no_table_twice(p):
    shown = {line.step.key for line in as_python(p, b"one")}
    assert {line.step.of for line in as_python(p, b"one")} <= {"", *shown}
    text = written(p, b"one", False)
    tables = re.findall(r"(?:^\|.*\n)+", text, re.MULTILINE)
    assert len(tables) == len({*tables})


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_each_component_found_from_equations_occurs_in_them(p):
    words = ""
    for line in as_python(p, b"one"):
        words, s = " ".join([words, *line.together]), line.step
        if (line.above or line.together) and s.is_vector and len(line.equal) == 1:
            found = {
                name
                for name, x in zip(VECTOR.names(s.key), map(to_plain, s.value.c), strict=True)
                if x
            }
            assert found <= {*NAME.findall(words)}, s.key


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_no_fraction_contains_a_fraction_and_no_description_repeats_its_formula(p):
    """But in a root, a function or a power."""
    text = written(p, b"one", False)
    for formula in re.findall(r"\$([^$]*)\$", text):
        for part in re.findall(r"\\frac(.*)", without_arguments(formula)):
            fraction = "".join(islice(groups(part), 2))
            assert r"\frac" not in fraction, formula
    for means, formula in re.findall(
        r"[,:] (\$[^$=]*\$)(?:, section [^:]*)?: \$[^$]* = ([^$]*)\$", text
    ):
        formula = letters(formula.partition(r"\ \text")[0])
        names = {x for x in letters(means) if not x.isdigit()}
        assert letters(means) != formula, means
        assert len(names) < 4 or not names <= {*formula}, means
    assert r"\sqrt{\frac{1}{" not in text


def groups(text):
    """The groups in braces at the beginning of a text, in order."""
    depth, begin = 0, 0
    for n, character in enumerate(text):
        depth += (character == "{") - (character == "}")
        if depth == 0:
            yield text[begin : n + 1]
            begin = n + 1


def without_arguments(latex):
    """A formula without fractions of numbers, and without what is in its functions, roots and
    powers.
    """
    latex = re.sub(r"\\frac\{\d+\}\{\d+\}", "", latex)
    while found := re.search(r"(?:\^|\\sqrt|\\(?:arc)?(?:sin|cos|tan)) ?(?=\{)", latex):
        latex = (
            latex[: found.start()] + latex[found.end() + len(next(groups(latex[found.end() :]))) :]
        )
    return latex


def letters(latex):
    """The names and numbers of a formula in order, without its layout."""
    words = re.findall(r"\\[A-Za-z]+|[A-Za-z]+|\d+", latex)
    return sorted({*words} - {"0", r"\frac", r"\left", r"\right", r"\cdot", r"\mathbf"})


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_term_is_not_named_after_a_quantity_that_equals_it_by_chance(p):
    """As a component of another sum whose other terms are zero, of a vector that is another term of
    its sum, or of an answer in another unit: H_O_y omega for -I_xy omega^2.
    """
    found = derived(p, b"one")
    shown = [line.step for line in as_python(p, b"one")]
    sums = {s.of for s in shown if s.of}
    units = {s.key: s.unit for s in shown}
    vectors = {
        s.key: {
            n for n, x in zip(VECTOR.names(s.key), map(to_plain, s.value.c), strict=True) if x != 0
        }
        for s in shown
        if s.is_vector
    }
    scalars = {*p.units, *(s.key for s in shown if not s.is_vector)}  # as omega_x
    whole = set()
    for s in (s for s in shown if s.of and s.key in found):
        formulas = [f for f in found[s.key].formulas if f is not None]
        names = {x.name for f in formulas for x in f.free_symbols} - scalars
        # the components of its own sum may be unknowns of equations
        used = ({name.rpartition("_")[0] for name in names} & vectors.keys()) - {s.of}
        assert not used & sums, s.key
        assert not {a.key for a in p.answers if a.key in used and a.unit != units[s.of]}, s.key
        if formulas and all(f.is_Symbol or f == 0 for f in formulas):
            assert not {(s.of, v) for v in used} & whole, s.key
            whole |= {(s.of, v) for v in used if vectors[v] <= names}


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_matrix_names_the_place_of_its_body_by_components_only(p):
    """As m d_x d_y beside m d_x^2, and no m x_c d_y, where d_x is the given x_c."""
    found = derived(p, b"one")
    formulas = {key: x.formulas for key, x in found.items() if None not in x.formulas}
    for key in (key for key, x in formulas.items() if len(x) == 9):
        names = {x.name for f in formulas[key] for x in f.free_symbols}
        for place in (k for k, x in formulas.items() if len(x) == 3):
            same_body = place.split("_")[1:] == key.split("_")[1:] != []
            given = [str(abs(f)) for f in formulas[place] if abs(f).is_Symbol and same_body]
            assert not {f for f in given if given.count(f) == 1} & names, (key, place)


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_name_in_a_formula_is_the_one_that_its_place_asks_for(p):
    """A term as -r theta_dot^2 e_r has no component of a vector, a point that turns has r omega^2
    and not omega v, a component of a turned vector has entries of its row of the matrix, and no
    scalar is two terms of a sum.
    """
    found = derived(p, b"one")
    shown = {line.step.key: line.step for line in as_python(p, b"one")}
    units, own, rows = dict(p.units), {}, {}
    for key, s in ((key, s) for key, s in shown.items() if key in found):
        names = s.kind.names(key)[: len(found[key].formulas)]
        units |= dict.fromkeys(names, s.unit)
        own |= dict(zip(names, found[key].formulas, strict=True))
        rows |= {x: n // 3 for n, x in enumerate(names) if len(names) == 9 and s.unit == "1"}
    vectors = {x for s in shown.values() if s.is_vector and s.unit != "1"
               for x in VECTOR.names(s.key)}  # fmt: skip
    rates = {x for x, of in units.items() if powers(of) in ((0, 0, -1), (0, 1, -1))}
    alone = [(shown[key].of, f) for key, x in found.items() if key in shown and shown[key].of
             for f in x.formulas if f is not None and f.is_Symbol and str(f) in {*found}]  # fmt: skip
    assert len(alone) == len({*alone}), alone
    for key, x in ((key, x) for key, x in found.items() if key in shown):
        for n, f in ((n, f) for n, f in enumerate(x.formulas) if f is not None):
            used = {y.name for y in f.free_symbols}
            if shown[key].term and r"\hat" in str(shown[key].term[1].terms.get(shown[key].term[0])):
                assert not used & vectors, (key, f)
            if len(x.formulas) == 3:
                assert {rows[name] for name in used & rows.keys()} <= {n}, (key, f)
            for term in sympy.Add.make_args(f):
                number, product = term.as_coeff_Mul()
                plain = abs(number) == 1 and not sympy.fraction(term)[1].has(sympy.Add)
                factors = {y.name for y in product.args if y.is_Symbol and plain}
                for v in (v for v in factors if v in own and powers(units[v]) == (0, 1, -1)):
                    shared = factors & {str(y) for y in sympy.Mul.make_args(own[v])} & rates
                    assert not shared, (key, f)


def powers(stated_in):
    return unit(stated_in).dimension.powers


@pytest.mark.one_in(6)
@pytest.mark.parametrize("p", [p for p in ALL if p.symbols], ids=lambda p: p.id)
def test_a_result_has_positive_denominators_and_bars_where_they_are_needed(p):
    points = [{n: float(x[k]) for n, x in symbol_points(p).items()} for k in range(8)]
    for line in as_python(p, b"one"):
        result = line.equal[-1].removesuffix(f" {line.step.unit}")
        is_word = isinstance(line.step.value, (str, int)) or callable(line.step.value)
        parts = () if is_word else re.split(r"[\[\],]+(?![^(]*\))", result)
        for text in filter(str.strip, parts):
            x = sympy.sympify(text, {n: sympy.Symbol(n, real=True) for n in p.symbols})
            bars = [y.args[0] for y in x.atoms(sympy.Abs)]
            negative = [y.base for y in x.atoms(sympy.Pow) if y.exp == -1 and y.base.is_Add]
            for y in (*bars, *(-y for y in negative)):
                at = ({s: point.get(s.name, s) for s in y.free_symbols} for point in points)
                assert not all(y.subs(values).is_positive for values in at), text


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_an_answer_that_others_use_has_a_name(p):
    found = derived(p, b"one")
    formulas = (f for x in found.values() for f in x.formulas if f is not None)
    used = {x.name for f in formulas for x in f.free_symbols}
    for line in as_latex(p, b"one"):
        assert line.name or not used & own_names(line), line.step.key
        assert not re.fullmatch(r"\\mathbf\{\w\}", line.equal[0]) or any(
            line.equal[0] == symbol(key, True) for key in found
        ), line.step.key


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_components_are_named_after_their_unit_vectors(p):
    """A component along e_theta is a_theta, and not a_y; from axes to others turns T_12, not T_xy."""
    text = written(p, b"one", False)
    for s in (line.step for line in as_python(p, b"one")):
        if isinstance(s.value, (list, tuple)) and len(flat(s.value)) == 9 and s.unit == "1":
            assert not any(symbol(f"{s.key}_{a}{b}") in text for a in "xyz" for b in "xyz")
        if s.is_vector and re.search(
            r"\be_|(polar|cylindrical|spherical) axes", s.value.frame.name
        ):
            assert symbol(f"{s.key}_x") not in text
            assert symbol(f"{s.key}_y") not in text


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_variable_of_integration_is_introduced(p):
    introduced = " ".join([p.text, *(line.step.means for line in as_python(p, b"one"))])
    for line in as_python(p, b"one"):
        for name in re.findall(r"Integral\(.*?, \((\w+), ", " ".join(line.equal)):
            assert re.search(rf"\b{name}\b", introduced), (line.step.key, name)


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_no_sum_has_two_common_factors_and_no_equation_has_two_leading_signs(p):
    """m (a^2 + b^2)/12 for m a^2/12 + m b^2/12; but terms divided by different quantities stay."""
    for key, found in derived(p, b"one").items():
        for f in (f for f in found.formulas if f is not None and not f.has(sympy.Integral)):
            for x in laid_out(f, p.units)[0].atoms(sympy.Add):
                terms = [y.as_coeff_Mul() for y in x.args]
                shared = set.intersection(*({*sympy.Mul.make_args(y)} for _, y in terms))
                divided = any(sympy.fraction(y)[1].free_symbols for _, y in terms)
                alike = len({abs(n) for n, _ in terms}) == 1
                assert divided or not alike or len(shared - {1}) < 2, (key, x)
                assert not [pair for pair in combinations(terms, 2) if are_one(*pair)], (key, x)
        for left, right in found.together:
            factors = {str(x) for x in sympy.Mul.make_args(left)} if right == 0 else set()
            assert not factors & {*p.units}, key
    for row in (row for line in as_python(p, b"one") for row in line.together):
        assert row.count("-") < 2 or re.match("[^-]|.*= [^-]", row), row


def are_one(*terms):
    """Whether two of several terms would be written as one: m d_x^2 + m d_y^2."""
    (n, one), (m, other) = terms
    shared = {*sympy.Mul.make_args(one)} & {*sympy.Mul.make_args(other)}
    rest = [x / sympy.Mul(*shared) for x in (one, other)]
    squares = all(x.is_Pow and x.exp > 0 for x in rest)
    return abs(n) == abs(m) and shared - {1} and squares


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_step_is_not_a_given_under_another_name(p):
    """As the mass of a part that the text gives."""
    found = derived(p, b"one")
    for s in computed(p, b"one"):
        formula = str(*found[s.key].formulas[:1]) if s.key in found else ""
        same = not s.term and not s.is_vector and p.units.get(formula) == s.unit
        assert not same or p.id in NAMED_GIVENS, s.key


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_no_two_numbers_share_a_name(p):
    """As a given v_x along i and the component v_x of a vector v in other axes."""
    values = numbers(p, b"one")
    known = {name: to_plain(values[name]) for name in p.givens}
    for line in as_python(p, b"one"):
        s = line.step
        parts = [] if isinstance(s.value, str) or callable(s.value) else list(flat(s.value))
        for name, x in zip(s.kind.names(s.key), map(to_plain, parts), strict=False):
            stated = p.units.get(name, s.unit)
            factor = unit(stated).from_base(unit(s.unit).to_base(1.0, p.system), p.system)
            if name in known and is_numeric(x) and is_numeric(known[name]):
                assert factor * float(x) == pytest.approx(float(known[name])), name
            known[name] = factor * x if is_numeric(x) else x


def digits(number):
    return number.replace(".", "").strip("0")


@pytest.mark.parametrize("seed", SEEDS, ids=bytes.decode)
@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_what_is_shown_with_numbers_is_the_key(p, seed):
    """The text with numbers, computed by Python, gives the value behind it, and that is the key."""
    values = numbers(p, seed)
    right = p.solve(values)
    known = {*p.units}
    named = set().union(*(map(own_names, as_python(p, seed))))
    asked = {a.key for a in p.answers}
    assert any(
        line.step.key not in asked or line.equal[1:] or line.together for line in as_python(p, seed)
    ), "nothing is explained"
    for line in as_python(p, seed):
        *formulas, value = line.equal
        assert what_a_reader_misses(line, known, named) == []
        assert not line.too_long
        key = right.get(line.step.key, line.step.value)
        assert line.step.value == key or str(line.step.value) == str(key)
        found = [x for x in map(to_plain, flat(line.step.value)) if is_numeric(x)]
        if not found or len(found) < len(flat(line.step.value)):
            continue  # words and formulas
        shown = read(value.removesuffix(f" {line.step.unit}"), p)
        assert shown == pytest.approx([float(x) for x in found], rel=5e-6, abs=1e-12)
        size = max(map(abs, shown), default=0.0)
        for text in formulas:
            if (computed := read(text, p, line.step.unit)) is not None:
                assert computed == pytest.approx(shown, rel=2e-4, abs=2e-4 * size), text


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_step_is_introduced_in_thirty_words(p):
    """A formula is one word."""
    for line in as_python(p, b"one"):
        means = "" if line.step.term else typeset_formulas(line.step.means, p.notation)
        assert len(re.sub(r"\$[^$]*\$", "formula", means).split()) <= 30, means


def own_names(line):
    """The names of what a line of a solution finds, and of its components."""
    return {line.step.key, *line.step.kind.names(line.step.key)}


def what_a_reader_misses(line, known, named):
    """The numbers without a name, the names without a meaning, and the sides that are missing, in a
    line of a solution; ``known`` are the names of the lines before, to which its own are added, and
    ``named`` those of all lines: an unknown of equations is one of them, or the cosine of one.
    """
    functions = FUNCTIONS_OF_MATH.keys() | {"Abs", "Integral"}
    vectors = {x[:-2] for x in known if x[-2:] in ("_x", "_1")}
    texts = [QUANTITY.sub("", x) for x in line.equal[:-1]]
    with_names = [x for x in texts if {*NAME.findall(x)} - functions]
    variables = {*re.findall(r"\((\w+), ", " ".join(with_names))}  # of integrals
    unknowns = {*NAME.findall(" ".join(line.together))} - known
    known |= own_names(line) | unknowns
    return [
        *(x for x in unknowns - named - functions if not x.startswith(("cos_", "sin_"))),
        *({*NAME.findall(" ".join(with_names))} - known - vectors - functions - variables),
        *(x for x in (*with_names, *line.together) for x in re.findall(r"\d*\.\d{4,}", x)),
        *(row for row in line.together if not all(map(str.strip, row.split("=")))),
        *["no name"] * (not line.name),
    ]


def read(text, p, stated_in="1"):
    """The numbers of a text, None where it has symbols."""
    in_base = QUANTITY.sub(lambda m: f"({unit(m[2]).to_base(float(m[1]), p.system)!r})", text)
    try:
        found = eval(in_base, {"__builtins__": {}, "Abs": abs, **FUNCTIONS_OF_MATH})
    except NameError:
        return None
    found = flat(found) if isinstance(found, (list, tuple)) else (found,)
    units = {m[2] for m in QUANTITY.finditer(text)} - {"deg"}  # an angle needs no coherent unit
    converted = units or stated_in == "deg" or not any(unit(stated_in).dimension.powers)
    factor = unit(stated_in).from_base(1.0, p.system) if converted else 1.0
    return [factor * x for x in found]


@cache
def in_terms_of_components(p):
    """The derivations and {vector: {component: formula}}, without sums of terms."""
    of = {line.step.of for line in as_python(p, b"one")}
    found = {k: x.formulas for k, x in derived(p, b"one").items() if k not in of}
    whole = {k: x for k, x in found.items() if len(x) == 3 and None not in x}
    return found, {k: dict(zip(VECTOR.names(k), x, strict=True)) for k, x in whole.items()}


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_component_that_is_a_given_has_its_own_name_beside_another_in_the_same_role(p):
    """As m (v_x^2 + v_y^2)/2 and omega_y r_z - omega_z r_y, where v_x and r_y are given."""
    found, vectors = in_terms_of_components(p)
    for key, formulas in found.items():
        formulas = [f for f in formulas if f is not None]
        sums = [x.args for f in formulas for x in f.atoms(sympy.Add)]
        for terms in (*sums, [x for f in formulas for x in sympy.Add.make_args(f)]):
            for one, other in permutations(terms, 2):
                above, below = (abs(x).as_base_exp() for x in sympy.fraction(one / other))
                for own in (x for k, x in vectors.items() if k != key and str(below[0]) in x):
                    given = {
                        str(abs(f)) for n, f in own.items() if n not in (str(f), str(below[0]))
                    }
                    mixed = str(above[0]) in given & {*p.units}
                    assert not mixed or above[1] != below[1], (key, one, other)


@pytest.mark.parametrize("p", EACH, ids=lambda p: p.id)
def test_a_product_of_two_vectors_has_the_axes_of_a_cross_product_if_it_can(p):
    """2 Omega_z v_x along y, and not -2 Omega_z v_y, where v_y = -v_x."""
    _, vectors = in_terms_of_components(p)
    places = {name: (v, n) for v, own in vectors.items() for n, name in enumerate(own)}
    for own in vectors.values():
        for axis, term in (
            (n, x) for n, f in enumerate(own.values()) for x in f.as_ordered_terms()
        ):
            factors = [places[str(x)] for x in sympy.Mul.make_args(term) if str(x) in places]
            if len({v for v, _ in factors}) == len(factors) == 2:
                for (v, n), (_, fixed) in permutations(factors):
                    parts, free = [*vectors[v].values()], {0, 1, 2} - {axis, fixed}
                    equal = any(parts[k] in (parts[n], -parts[n]) for k in free)
                    assert len({axis, n, fixed}) == 3 or len(free) > 1 or not equal, term


SYMBOLIC = [p for p in ALL if p.symbols and not p.givens]  # which need no units


@pytest.mark.one_in(4)
@pytest.mark.parametrize("p", SYMBOLIC, ids=lambda p: p.id)
def test_a_formula_of_symbols_is_the_result(p):
    """At random numbers; unknowns that are not quantities of the problem have no value."""
    known, named = dict(numbers(p, b"one")), {}
    for s in (line.step for line in as_python(p, b"one")):
        named[s.key] = s.kind.names(s.key)
        parts = [] if isinstance(s.value, str) or callable(s.value) else flat(s.value)
        known |= dict(zip(named[s.key], parts, strict=False))
    point = symbol_values(p, random.Random(1))
    known = {n: at(sympy.sympify(to_plain(x)), point) for n, x in known.items()}
    for key, x in derived(p, b"one").items():
        for name, f in zip(named.get(key, ()), x.formulas, strict=False):
            names = {name, *(y.name for y in f.free_symbols)} if f is not None else {""}
            if names <= known.keys():  # not of a term that is zero, which is not shown
                assert at(f, known) == pytest.approx(known[name], rel=1e-9, abs=1e-9), (key, f)


def at(formula, numbers):
    return float(formula.subs({x: numbers[x.name] for x in formula.free_symbols}).evalf())


def test_an_answer_is_typeset_by_its_kind_with_symbols_and_with_numbers(monkeypatch):
    (p,) = select(["2/4"])
    (kind,) = {a.kind for a in p.answers if a.kind.name == "interval"}
    monkeypatch.setattr(type(kind), "typeset", lambda self, parts: " until ".join(parts))
    values = draw(p, b"one")
    found = [line.equal[-1] for line in lines(p, {**p.sympy_symbols(), **values})]
    assert any(" until " in text for text in found)
