"""``python -I .../cage/__main__.py FD`` serves the jobs that come over the socket FD.

With ``-I`` the folder of a script is not on ``sys.path``, and ``grader`` may not be importable: so
this folder is loaded by its place, as a package of its own that student code cannot replace.
"""

import importlib.util
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def _load():
    spec = importlib.util.spec_from_file_location(
        "cage", HERE / "__init__.py", submodule_search_locations=[str(HERE)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["cage"] = package
    spec.loader.exec_module(package)
    return importlib.import_module("cage.serve")


if __name__ == "__main__":
    _load().main(int(sys.argv[1]))
