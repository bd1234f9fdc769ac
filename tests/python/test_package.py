"""The package as a whole: its names, help texts and stub."""
import ast
import inspect
import subprocess
import sys
from pathlib import Path

import pytest

import elsie
from elsie import _elsie

STUB = Path(elsie.__file__).with_name("_elsie.pyi")


def public_members():
    for name in elsie.__all__:
        thing = getattr(elsie, name)
        yield name, thing
        if inspect.isclass(thing):
            for member, value in inspect.getmembers(thing):
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    yield f"{name}.{member}", value


@pytest.mark.parametrize("name, thing", [each for each in public_members()
                                         if not each[0].endswith((".with_traceback", ".add_note", ".count", ".index"))])
def test_everything_public_has_a_help_text(name, thing):
    if name == "Answer" or name.startswith("Status."):
        pytest.skip("a name of types; what every enumeration of the extension has")
    assert (inspect.getdoc(thing) or "").strip()


def stubbed(node):
    names = {each.name for each in node.body if isinstance(each, (ast.FunctionDef, ast.ClassDef))}
    names |= {each.target.id for each in node.body if isinstance(each, ast.AnnAssign)}
    return {name for name in names if not name.startswith("__")}


def test_the_stub_has_what_the_extension_has():
    tree = ast.parse(STUB.read_text())
    module = {name for name in vars(_elsie) if not name.startswith("__")}
    missing = stubbed(tree) - module
    assert not missing
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            found = {name for name in vars(getattr(_elsie, node.name)) if not name.startswith("__") and name != "_pybind11_conduit_v1_"}
            assert stubbed(node) == found, node.name


def test_pandas_is_imported_only_for_frames():
    code = "import sys, elsie; sys.exit('pandas' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_the_version_is_that_of_the_program():
    said = subprocess.run([elsie.program(), "--version"], capture_output=True, text=True, check=True).stdout
    assert elsie.__version__ in said
