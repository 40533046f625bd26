"""Sphinx's configuration of the site: Markdown and notebooks by MyST, nothing from a network.
MathJax, from the package sphinx-mathjax-offline, is for formulas that scripts add to a page, and
for pages whose formulas website/formulas.py could not typeset.
"""

import importlib.util
import re
import sys
from functools import cache
from pathlib import Path
from typing import Any

from sphinx.addnodes import toctree

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))

from transforms import docstring, formulas, problem_links  # noqa: E402

from newton_euler.drawing import dark_css  # noqa: E402
from website.languages import links  # noqa: E402

project = "Newton-Euler dynamics"
html_title = project
language = "en"
author = ""
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.mathjax"]
exclude_patterns: list[str] = []

nb_execution_mode = "off"  # the notebooks have been run
nb_merge_streams = True
nb_code_prompt_show = "Code"
nb_code_prompt_hide = "Code"
nb_render_image_options: dict[str, str] = {}
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_dmath_allow_labels = False
myst_heading_anchors = 4

myst_heading_slug_func = "transforms.slug"

autodoc_typehints = "none"
add_module_names = False
python_use_unqualified_type_names = True
pygments_style = "friendly"

OFFLINE: Any = importlib.util.find_spec("sphinx-mathjax-offline")
MATHJAX = Path(OFFLINE.origin).parent / "static/mathjax"
mathjax_path = "tex-svg-full.js"  # draws outlines, so that no fonts are loaded
mathjax3_config = {
    "options": {"enableMenu": False},
    "svg": {"scale": 0.93},  # to match the typeface
    "tex": {"tags": "none"},
}

html_theme = "furo"
html_favicon = "static/icon.svg"
html_static_path = ["static", str(MATHJAX / mathjax_path)]
html_css_files = ["site.css", "sketches.css"]
html_js_files = [("words.js", {"defer": "defer", "priority": 100}), ("site.js", {"defer": "defer"})]
html_show_sourcelink = html_show_sphinx = html_show_copyright = False
html_copy_source = False
html_search_scorer = str(HERE / "scorer.js")
html_use_index = True
html_domain_indices = False
html_permalinks_icon = "#"
html_theme_options: dict[str, list[str]] = {"top_of_page_buttons": []}


SKETCHES = """\
@media screen {{
{}
@media (prefers-color-scheme: dark) {{ {} }}
}}
"""


def sketches(app: Any) -> None:
    """Write the style sheet for sketches on a dark page."""
    chosen, system = 'body[data-theme="dark"]', 'body:not([data-theme="light"])'
    rules = (dark_css(f"{theme} svg.sketch") for theme in (chosen, system))
    folder = Path(app.outdir, "_static")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "sketches.css").write_text(SKETCHES.format(*rules), encoding="utf-8")


# spans of names and signs, which have no colour of their own: a tenth of a chapter's page
PLAIN = re.compile(r'<span class="[np]">([^<]*)</span>')
# nothing is loaded from elsewhere; "file:" is for pages on a disk, eval for the plurals of Sphinx's
# own script
RULE = "default-src 'self' file: data: blob: 'unsafe-inline' 'unsafe-eval'"
# styles that the first page does not use, a quarter of its size
CELLS = re.compile(r"mystnb|pygments")


def finished(app: Any, page: str, template: str, context: dict, doctree: Any) -> None:
    """Finish a page: lighter code, no content from other sites, its languages; the first page has
    its own script.
    """
    rule = f'<meta http-equiv="Content-Security-Policy" content="{RULE}">'
    context["metatags"] = rule + context.get("metatags", "")
    if "body" in context:
        body = PLAIN.sub(r"\1", context["body"])
        if app.config.language != "en" and page not in app.config.own_pages:
            body = f'<div lang="en">{body}</div>'
        context["body"] = links(page, app.config.beside) + body
    if page == app.config.root_doc:
        app.add_js_file("landing.js", defer="defer")
        files = context["css_files"]
        context["css_files"] = [x for x in files if not CELLS.search(str(x.filename))]


def sidebar(app: Any, page: str, template: str, context: dict, doctree: Any) -> None:
    """Let Sphinx make a page's list of all pages from their titles: it would copy all headings of
    all pages for each page, in a third of its time, to leave them out.
    """
    listed = context["toctree"]

    def of_titles(**options):
        full, app.env.tocs = app.env.tocs, _titles(app.env)
        try:
            return listed(**options)
        finally:
            app.env.tocs = full

    context["toctree"] = of_titles


@cache
def _titles(env):
    """The table of contents of each page without its headings below the title."""
    titles = {}
    for page, contents in env.tocs.items():
        titles[page] = contents
        if not any(contents.findall(toctree)):
            titles[page] = contents.deepcopy()
            for entry in titles[page]:
                del entry[1:]
    return titles


def setup(app: Any) -> None:
    """Connect the functions of the site."""
    app.connect("html-page-context", sidebar, priority=400)  # before the theme asks for the list
    app.connect("html-page-context", finished)
    app.add_config_value("own_pages", [], "html")
    app.add_config_value("beside", {}, "html")
    app.connect("builder-inited", sketches)
    if app.tags.has("engine"):  # the engine is part of the site
        for name in ("engine.js", "moving.js", "cells.js"):
            app.add_js_file(name, defer="defer")
    app.connect("autodoc-process-docstring", docstring)
    app.connect("doctree-read", formulas)
    app.connect("doctree-read", problem_links)
