"""Zip archives with a manifest, as QTI and Canvas read them."""

import io
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterable, Mapping

NAMESPACE = "http://www.imsglobal.org/xsd/imscp_v1p1"


def packed(
    name: str,
    files: Mapping[str, bytes],
    resources: Iterable[tuple[str, str, list[str]]],
    schema: str,
    version: str,
) -> bytes:
    """The archive of these files: {path: content}; resources : [(identifier, type, its files)], the
    first file of each is the one that it is read from.
    """
    root = ET.Element("manifest", {"xmlns": NAMESPACE, "identifier": f"bank-{name}"})
    metadata = ET.SubElement(root, "metadata")
    ET.SubElement(metadata, "schema").text = schema
    ET.SubElement(metadata, "schemaversion").text = version
    ET.SubElement(root, "organizations")
    listed = ET.SubElement(root, "resources")
    for ident, kind, used in resources:
        what = {"identifier": f"r-{ident}", "type": kind, "href": used[0]}
        resource = ET.SubElement(listed, "resource", what)
        for path in used:
            ET.SubElement(resource, "file", href=path)
    ET.indent(root, " ")
    out = io.BytesIO()
    manifest = ET.tostring(root, encoding="utf-8", xml_declaration=True)
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in {"imsmanifest.xml": manifest, **files}.items():
            archive.writestr(zipfile.ZipInfo(path), content, zipfile.ZIP_DEFLATED)
    return out.getvalue()
