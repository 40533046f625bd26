"""The engine for a reader's browser: Pyodide and the package, as files of the site."""

import io
import json
import zipfile
from importlib.util import find_spec
from pathlib import Path

from .kept import ROOT, put
from .npm import Package

PYODIDE = Package(
    "pyodide",
    "314.0.7",
    "sha512-0YvXxEhfEdpLfb/XkM2BFAeMROq0iMUX2bzzH9pOttyMcWkwq+HbE5uyuGD82LN7y2q+SNvi/6V5JEsOlD2R1A==",
)
FILES = (
    "pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "pyodide-lock.json", "python_stdlib.zip",
)  # fmt: skip
# notebooks are pages already, practice files are fetched by chapter
LEFT_OUT = {".ipynb", ".pyc", ".md", ".pyi", ".practice"}
OFFLINE = Path(__file__).with_name("theme") / "offline.js"
# what pages call, in a zip with the engine: nothing else of this repository is imported there
ON_PAGES = [ROOT / "website" / "__init__.py", *(ROOT / "website" / "browser").glob("*.py")]


def write(out: Path, found: dict[str, bytes], packages: str = "") -> None:
    """Write the engine and these files of Pyodide to the folder ``engine`` of the site. Names
    change with contents, so that a browser may cache them for ever.

    packages : address of Pyodide's other packages, from which readers may load NumPy; another
    server must allow the site to read them (CORS)
    """
    folder, python = out / "engine", f"pyodide-{PYODIDE.version}"
    (folder / python).mkdir(parents=True)
    for name, contents in found.items():
        (folder / python / name).write_bytes(contents)
    package = put(folder, zipped(ROOT / "newton_euler", *ON_PAGES), ".zip", "newton_euler-")
    about = {
        "python": f"{python}/",
        "package": package,
        "bytes": sum(map(len, found.values())) + (folder / package).stat().st_size,
        "later": {
            name: [put(folder, zipped(path), ".zip", f"{path.name}-") for path in paths]
            for name, paths in _later().items()
        },
        "packages": packages and f"{packages.rstrip('/')}/",
    }
    (folder / "engine.json").write_text(json.dumps(about))
    (out / OFFLINE.name).write_bytes(OFFLINE.read_bytes())  # its folder is its scope


def _later():
    """{pure Python package that cells may import: its folder and those of its dependencies}."""
    folders = {name: Path(str(find_spec(name).origin)).parent for name in ("mpmath", "sympy")}
    return {"mpmath": [folders["mpmath"]], "sympy": [*folders.values()]}


def zipped(package: Path, *others: Path) -> bytes:
    """A package as a zip, with other files beside it, the same for the same files."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        # newton_euler/chapters is a link, which rglob does not follow
        for path in sorted([*package.rglob("*"), *(package / "chapters").rglob("*"), *others]):
            if path.suffix not in LEFT_OUT and "tests" not in path.parts and path.is_file():
                name = zipfile.ZipInfo(str(path.relative_to(package.parent)))
                name.compress_type = zipfile.ZIP_DEFLATED
                archive.writestr(name, path.read_bytes())
    return out.getvalue()
