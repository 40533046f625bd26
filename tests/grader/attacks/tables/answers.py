"""Libraries and receipts that are patched, and objects that lie about what they are."""

from tests.grader.attacks.attack import code, edited, lie, put, right_texts

PATCHED = {
    "the reading of answers is replaced": code("""
        import newton_euler.answers.receipts as a
        a.record = lambda forms, *_: ({k: "right" for k in forms}, {})
    """),
    "the reading of answers says True": code("""
        import newton_euler.answers.receipts as a
        a.record = lambda forms, *_: (dict.fromkeys(forms, True), {})
    """),
    "the receipt is replaced": code("""
        import newton_euler.classroom as c
        c.receipt = receipt = lambda *_, **__: 1e9
        receipt("4/1")
    """),
    "the sheet asks for a choice": code("""
        from newton_euler.answers.forms import Form
        Form.read = staticmethod(lambda _: Form("choice", "1", ("right",)))
        speed = acc_mag = "right"
    """),
    "another sheet is expected": code("""
        expect("4/1", speed="choice, right wrong", acc_mag="count")
        speed, acc_mag = "right", 1
        receipt("4/1", speed=speed, acc_mag=acc_mag)
    """),
    "json": code("""
        import json
        json.dumps = lambda *_, **__: '{"id": "4/1", "answers": {"speed": "right"}, "points": 9}'
    """),
    "builtins": code("""
        import builtins
        builtins.isinstance = lambda *_: True
        builtins.abs = builtins.len = lambda *_: 0
        builtins.float = lambda *_: 1.0
        speed = acc_mag = "anything"
    """),
    "what numpy compares with": code("""
        import numpy as np, math
        np.isclose = np.allclose = math.isclose = lambda *_, **__: True
        speed = acc_mag = 1.0
    """),
    "sys.modules": code("""
        import sys, types
        for name in ("grader", "grader.scoring", "exercises", "exercises.catalogue", "nbgrader"):
            sys.modules[name] = types.ModuleType(name)
            sys.modules[name].score_receipt = lambda *_: 9
        speed = acc_mag = 1.0
    """),
    "an import hook": code("""
        import sys
        class Hook:
            def find_spec(self, name, *_):
                raise SystemExit(name)
        sys.meta_path.insert(0, Hook())
        speed = acc_mag = 1.0
    """),
    "the cage itself": code("""
        import sys
        for name, module in list(sys.modules.items()):
            if name.startswith("cage"):
                for attribute in list(vars(module)):
                    if not attribute.startswith("__"):
                        setattr(module, attribute, lambda *_, **__: {"points": 9, "error": None})
    """),
    "a trace function": code("""
        import sys, threading
        def trace(frame, *_):
            frame.f_locals.update(points=9, error=None)
            return trace
        sys.settrace(trace), sys.setprofile(trace), threading.settrace(trace)
        speed = acc_mag = 1.0
    """),
    "what runs at a fork and at the end": code("""
        import atexit, gc, os
        def forge(*_):
            for fd in range(3, 64):
                try: os.write(fd, b'{"id": "4/16", "answers": {"v_D": "right"}, "points": 3}\\n')
                except OSError: pass
        atexit.register(forge), gc.callbacks.append(forge)
        os.register_at_fork(before=forge, after_in_child=forge, after_in_parent=forge)
    """),
    "the C library's memory": code("""
        import ctypes
        for flag in (id(True), id(None), id(1)):
            ctypes.memmove(flag, id(0.0), 16)
    """),
}

LIES = {
    "equal to everything": lie("""
        class Lie:
            __hash__ = object.__hash__
            def __eq__(self, _): return True
            def __ne__(self, _): return False
            __lt__ = __le__ = __gt__ = __ge__ = __contains__ = __eq__
            def __bool__(self): return True
    """),
    "another class": lie("""
        class Lie:
            @property
            def __class__(self): return float
            def __getattr__(self, name): return lambda *_, **__: self
    """),
    "an array of its own": lie("""
        class Lie:
            def __array__(self, *_, **__):
                import numpy as np
                return np.full(3, np.nan)
            def __len__(self): return 3
            def __iter__(self): return iter([float("nan")] * 3)
    """),
    "a number without end": lie("""
        class Lie:
            def __float__(self): return float("inf")
            def __index__(self): return 10**400
            def __complex__(self): return complex("nan")
    """),
    "another number at each look": lie("""
        class Lie:
            n = 0
            def __float__(self):
                Lie.n += 1
                return float(Lie.n)
            def __len__(self): return 3
            def __getitem__(self, i):
                if i > 2: raise IndexError
                return float(self)
    """),
    "a float that equals all": lie("""
        class Lie(float):
            def __new__(cls): return float.__new__(cls, 1.5)
            def __eq__(self, _): return True
            __hash__ = float.__hash__
            def __sub__(self, _): return 0.0
            __rsub__ = __sub__
            def __abs__(self): return 0.0
            def __repr__(self): return 'null}, "points": 9, "x": {"a": 1'
    """),
    "text that ends its own quotes": lie("""
        class Lie(str):
            def __new__(cls): return str.__new__(cls, '1.5"}, "points": 9}')
            def __float__(self): return 1.5
    """),
    "code in a pickle": lie("""
        class Lie:
            def __reduce__(self):
                import os
                return os.system, ("touch $OUTSIDE/pickled",)
            def __deepcopy__(self, _): return 1.0
    """),
    "iteration without end": lie("""
        class Lie(list):
            def __iter__(self):
                while True: yield 1.0
            def __len__(self): return 3
    """),
    "a display that never ends": lie("""
        class Lie:
            def __repr__(self): return "x" * 10**9
            __str__ = __repr__
            def __format__(self, _): raise BaseException("no")
    """),
    "an array of objects": lie("""
        import numpy as np
        class True_(float):
            def __eq__(self, _): return True
            __hash__ = None
        Lie = lambda: np.array([True_(1), True_(2), True_(3)], dtype=object)
    """),
    "a number of a million digits": lie("Lie = lambda: 10**10**6"),
    "a nested list": lie("""
        def Lie():
            x = 1.0
            for _ in range(500): x = [x]
            return x
    """),
    "a list that holds itself": lie("""
        def Lie():
            x = [1.0, 2.0]
            x.append(x)
            return x
    """),
}

BOMBS = {
    "a tower of powers": code("""
        from sympy import Pow, Integer
        speed = acc_mag = Pow(9, Pow(9, Integer(9), evaluate=False), evaluate=False)
    """),
    "a sum of a hundred thousand terms": code("""
        from sympy import Add, symbols
        speed = acc_mag = Add(*symbols("x:100000"), evaluate=False)
    """),
    "sines in sines": code("""
        from sympy import sin, Symbol
        x = Symbol("x")
        for _ in range(700): x = sin(x, evaluate=False)
        speed = acc_mag = x
    """),
    "shared terms that double": code("""
        from sympy import Symbol, Add
        x = Symbol("x")
        for n in range(60): x = Add(x, x * n, evaluate=False)
        speed = acc_mag = x
    """),
    "an array of a billion": code("""
        import numpy as np
        speed = acc_mag = np.broadcast_to(1.0, (10**9,))
    """),
}

FRAMES = """
from newton_euler import Frame
mine = Frame("ground")
for axis in "xyx":
    mine = mine.rotate("mine", axis, angle=3.141592653589793, rate=1)
alpha_CD, v_D, a_D = (mine.vector(*(s * x for s, x in zip((-1, -1, 1), v))) for v in (alpha_CD, v_D, a_D))
"""


def _four_guesses(notebook, scene):
    """Vectors with wrong signs, which are right in a frame that is turned by half a turn."""
    right = right_texts(scene.course, scene.student)["answer-4-16"]
    put(notebook, {"answer-4-16": right + FRAMES})


GUESSES = {"four guesses in one answer": edited(_four_guesses)}

ATTACKS = {**PATCHED, **LIES, **BOMBS, **GUESSES}
