"""Pages from templates, in the language of the site."""

from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader

from newton_euler.algebra.language import _


def rendered(template: str, **given: Any) -> str:
    """The text of a template with these values."""
    return _templates().get_template(f"{template}.j2").render(given)


@cache
def _templates():
    folder = FileSystemLoader(Path(__file__).with_name("templates"))
    # no automatic escaping: the templates are Markdown with HTML
    found = Environment(loader=folder, trim_blocks=True, keep_trailing_newline=True)
    found.globals["_"] = _
    return found
