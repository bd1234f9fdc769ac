"""Every block of Python in the guide runs, and so does every notebook."""
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import elsie

SOURCE = Path(__file__).resolve().parents[2]
PAGES = ["docs/python.md", "docs/learning.md", "docs/writing-a-behavior-in-python.md"]


def blocks(page):
    return re.findall(r"^```python\n(.*?)^```$", (SOURCE / page).read_text(), re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.filterwarnings("ignore:This process was not started")
def test_the_blocks_of_a_page_run_in_their_order(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names = {"__name__": "page"}
    assert blocks(page)
    for block in blocks(page):
        exec(compile(block, page, "exec"), names)  # noqa: S102


def test_the_first_behaviour_of_the_tutorial_is_the_example():
    assert blocks("docs/writing-a-behavior-in-python.md")[0] == (SOURCE / "examples/12-python-plugins/orbit.py").read_text()


@pytest.mark.parametrize("notebook", sorted(path.name for path in (SOURCE / "examples/13-python").glob("*.py")))
def test_notebooks_run(notebook, tmp_path):
    environment = {**os.environ, "PYTHONPATH": os.path.dirname(os.path.dirname(os.path.abspath(elsie.__file__)))}
    done = subprocess.run([sys.executable, str(SOURCE / "examples/13-python" / notebook)], cwd=tmp_path, env=environment,
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
