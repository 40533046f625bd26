"""The table of scenes: each scene runs to its end, and none is missing."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

from newton_euler.motion import ModelError, integrate
from newton_euler.scenes import SCENES, scene

ROOT = Path(__file__).parents[3]
each_scene = pytest.mark.parametrize("name", SCENES)


@each_scene
def test_every_scene_of_the_catalogue_moves_to_its_end(name):
    model, t, start = SCENES[name].motion
    motion = integrate(model, t, start, 1e-6, "dop853")
    assert motion.t_end == t
    assert motion.error <= 1e-6
    assert any(motion.end[n] != x for n, x in zip(model.states, start, strict=True))


def test_scenes_come_in_the_order_of_the_book_and_one_that_does_not_exist_is_refused():
    places = [tuple(map(int, s.section.split("."))) for s in SCENES.values()]
    assert places == sorted(places)
    assert all(s.name == name and s.description for name, s in SCENES.items())
    with pytest.raises(ModelError, match=r"no scene 'topp'; there are planet, .*, top, "):
        scene("topp")


def makers(path):
    """The functions of a file that make a model."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef):
            called = [n.func for n in ast.walk(node) if isinstance(n, ast.Call)]
            if {"Model", "second_order"} & {f.id for f in called if isinstance(f, ast.Name)}:
                yield node.name


def test_no_module_of_scenes_that_makes_a_model_is_forgotten():
    """Checked in a process of its own, before any model is cached."""
    scenes = ROOT / "newton_euler" / "scenes"
    modules = {str(path) for path in scenes.rglob("*.py") if any(makers(path))}
    assert len(modules) > 10
    program = """if True:
        import sys
        seen = set()
        sys.setprofile(lambda frame, event, _: seen.add(frame.f_code.co_filename) if event == "call" else None)
        from newton_euler.scenes import LADDERS, SCENES, ladder
        seen.clear()
        motions = [s.motion for s in SCENES.values()], [ladder(name) for name in LADDERS]
        sys.setprofile(None)
        print(*seen, sep="\\n")
    """
    output = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout
    assert modules - set(output.splitlines()) == set()
