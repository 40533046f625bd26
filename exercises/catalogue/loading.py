"""The YAML of the catalogue."""

import re
from typing import Any

import yaml


# the C parser is 10 times faster
class _Loader(getattr(yaml, "CSafeLoader", yaml.SafeLoader)):  # type: ignore[misc]
    """The safe loader, which also refuses repeated keys: YAML would drop the first."""

    def construct_mapping(self, node, deep=False):
        keys = [key.value for key, _ in node.value]
        for key, _ in node.value:
            if keys.count(key.value) > 1:
                raise yaml.constructor.ConstructorError(
                    None, None, f"the key {key.value} occurs twice", key.start_mark
                )
        return super().construct_mapping(node, deep)


# 1e-3 as a number: YAML 1.1 accepts only 1.0e-3
_Loader.add_implicit_resolver(
    "tag:yaml.org,2002:float", re.compile(r"[-+]?[0-9]+[eE][-+]?[0-9]+$"), list("-+0123456789")
)


def load(text: str) -> Any:
    """The content of a YAML text."""
    return yaml.load(text, _Loader)


def not_yaml(error: yaml.YAMLError) -> str:
    """The end of a sentence that a file is not YAML: where, why, and what to do."""
    reason = " ".join(str(error).replace('"<unicode string>", ', "").split())
    return f"is not YAML: {reason}; a text with a colon, a # or quotation marks must be quoted"
