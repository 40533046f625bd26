"""svg.py: the figure that matplotlib would draw, written without it and with real text."""

from xml.etree import ElementTree

import pytest
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.ft2font import FT2Font, LoadFlags
from matplotlib.textpath import text_to_path

from newton_euler.drawing.page.letters import ABOVE, BELOW, WIDTH, letters
from newton_euler.drawing.page.paper import Page
from newton_euler.drawing.page.recorder import share_window, sketches_on
from newton_euler.drawing.page.svg import DARK, dark_css, svg
from newton_euler.drawing.vocabulary import draw, entries

NAME = "{http://www.w3.org/2000/svg}"


def of_kind(tree, kind):
    return list(tree.iter(NAME + kind))


@pytest.mark.parametrize("entry", entries(), ids=lambda entry: entry.shows)
def test_everything_that_a_sketch_can_draw_is_drawn_stroke_by_stroke(entry):
    page, ax = Page((4, 3)), Figure(figsize=(4, 3)).add_axes((0.02, 0.02, 0.96, 0.96))
    draw(entry, page.panel)
    draw(entry, ax)
    tree = ElementTree.fromstring(svg(page))
    ax.figure.draw_without_rendering()
    widths = [float(g.get("stroke-width")) for g in of_kind(tree, "g") for _ in g]
    assert widths == [patch.get_linewidth() for patch in ax.patches]
    assert len(of_kind(tree, "text")) == len(ax.texts)


def test_places_are_those_of_matplotlib():
    figure, page = Figure(figsize=(4, 3), dpi=72), Page((4, 3))
    left, bottom, width, height = page.panel.box()
    ax = figure.add_axes((left / 288, bottom / 216, width / 288, height / 216))
    for surface in (ax, page.panel):
        draw(entries()[8], surface)
        share_window(sketches_on(surface))
    found = of_kind(ElementTree.fromstring(svg(page)), "path")
    figure.draw_without_rendering()
    for path, patch in zip(found, ax.patches, strict=True):
        seen = ax.transData.transform(patch.get_path().vertices[0])
        x, y = map(float, path.get("d")[1:].partition("L")[0].split())
        assert (x, 216 - y) == pytest.approx(seen, abs=0.6)


def of_matplotlib(text, weight="normal"):
    """Width and height of a text by matplotlib, as fractions of the font size."""
    font = FontProperties(size=100, weight=weight)
    math = text.count("$") > 1
    return [x / 100 for x in text_to_path.get_text_width_height_descent(text, font, math)[:2]]


def test_the_table_of_widths_is_that_of_the_font():
    import matplotlib

    font = FT2Font(f"{matplotlib.get_data_path()}/fonts/ttf/DejaVuSans.ttf")
    font.set_size(100, 72)
    for letter, width in WIDTH.items():
        glyph = font.load_char(ord(letter), flags=LoadFlags.NO_HINTING)
        assert width == pytest.approx(glyph.linearHoriAdvance / 6553600, abs=0.0051), letter


@pytest.mark.parametrize("text", [
    "P", "a force of 12 N", "$v_P$ = 1.20 m/s", r"$\dot\beta$", r"$\hat\imath'$", r"$\mathbf{r}$",
    r"$\omega_{2/1}\times\omega_{3/2}\,\Delta t$", r"$\ell_x^2 = y^2 + z^2$", r"$60^\circ$",
    r"$|\mathbf{P}+\mathbf{Q}|$ = 2.1", r"$b\cos\theta$", r"$\overrightarrow{OA}$",
])  # fmt: skip
def test_a_text_with_a_formula_is_as_wide_as_matplotlib_draws_it(text):
    found = letters(text)
    assert found.width == pytest.approx(of_matplotlib(text)[0], rel=0.12, abs=0.45)
    assert ABOVE + BELOW <= found.above + found.below < 1.5


@pytest.mark.parametrize(("text", "shown"), [
    (r"$\hat e_\theta$", "êθ"), (r"$\hat{\jmath}$", "ĵ"), (r"$\Delta\theta\,\hat\imath$", "Δθ\u2009î"),
    (r"$\ddot x$", "ẍ"), (r"cost \$5", "cost $5"), ("5 $", "5 $"), (r"$x^{10}_{2}$", "x102"),
    (r"$a - b$", "a\u2009−\u2009b"), (r"$\unheard_1$", "unheard\u20091"), ("$_$", ""), ("$}{$", "}"),
    (r"$\frac{a+b}{c}$", "(a\u2009+\u2009b)/c"), ("<b>&", "<b>&"),
])  # fmt: skip
def test_a_formula_is_written_in_letters(text, shown):
    assert "".join(run.text for run in letters(text).runs) == shown


def test_an_index_and_a_power_are_stacked_and_what_follows_is_on_the_line():
    page = Page()
    page.panel.set_title("$v_x^2$ = <4>")
    (text,) = of_kind(ElementTree.fromstring(svg(page)), "text")
    index, power, rest = list(text)[1:]
    heights = [float(span.get("dy")) for span in (index, power, rest)]
    assert heights[0] > 0 > heights[1]
    assert sum(heights) == pytest.approx(0, abs=0.11)
    assert float(power.get("dx")) < 0
    assert rest.text == " = <4>"


def test_every_colour_has_a_counterpart_for_a_dark_page():
    for entry in entries():
        page = Page((3, 2))
        draw(entry, page.panel)
        tree = ElementTree.fromstring(svg(page, 'A "dark" & simple picture'))
        assert tree.get("aria-label") == 'A "dark" & simple picture'
        used = {e.get(name) for e in tree.iter() for name in ("fill", "stroke")} - {None, "none"}
        assert used <= DARK.keys()
    assert '.dark svg [fill="#ffffff"]{fill:#131416}' in dark_css(".dark svg")
