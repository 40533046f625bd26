"""The XML of a bank from templates, and its zip archives for QTI and Canvas."""

import io
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

NAMESPACE = "http://www.imsglobal.org/xsd/imscp_v1p1"


def xml(template: str, **given: Any) -> bytes:
    """The well-formed XML of a template with these values."""
    made = _templates().get_template(f"{template}.xml.j2").render(given).encode()
    ET.fromstring(made)
    return made


@cache
def _templates():
    from jinja2 import Environment, FileSystemLoader

    folder = FileSystemLoader(Path(__file__).with_name("templates"))
    return Environment(loader=folder, autoescape=True, trim_blocks=True, lstrip_blocks=True)


def archive_of(
    name: str,
    files: Mapping[str, bytes],
    resources: Iterable[tuple[str, str, list[str]]],
    schema: str,
    version: str,
) -> bytes:
    """The archive of ``files``, {path: content}; resources : [(identifier, type, its files, the
    main one first)].
    """
    manifest = xml(
        "manifest", namespace=NAMESPACE, name=name, resources=resources, schema=schema,
        version=version,
    )  # fmt: skip
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in {"imsmanifest.xml": manifest, **files}.items():
            archive.writestr(zipfile.ZipInfo(path), content, zipfile.ZIP_DEFLATED)
    return out.getvalue()
