"""What the pages of the site call in a reader's browser, where the engine runs as WebAssembly.

Each module holds functions of values that JSON has, which return such values. A page calls one by
its name, ``engine.call("cells.run", {…})``; :func:`answer` finds it.
"""

from .calls import answer
