"""The pages of the site by their templates, in the language that is spoken."""

from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader

from newton_euler.algebra.language import _


def rendered(template: str, **given: Any) -> str:
    """The text that a template of the site makes of what it is given."""
    return _templates().get_template(f"{template}.j2").render(given)


@cache
def _templates():
    folder = FileSystemLoader(Path(__file__).with_name("templates"))
    # Markdown with HTML in it: what needs to be escaped says so
    found = Environment(loader=folder, trim_blocks=True, keep_trailing_newline=True)
    found.globals["_"] = _
    return found
