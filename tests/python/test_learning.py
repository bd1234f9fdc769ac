"""The example learns: a few iterations, the same numbers twice, and what it learned runs without Python."""
import importlib
import subprocess
import sys
from pathlib import Path

import pytest

import elsie

EXAMPLE = Path(__file__).resolve().parents[2] / "examples/14-learning"


@pytest.fixture
def learn(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(str(EXAMPLE))
    sys.modules.pop("learn", None)
    module = importlib.import_module("learn")
    monkeypatch.setattr(module, "POPULATION", 6)
    monkeypatch.setattr(module, "ELITE", 2)
    monkeypatch.setattr(module, "EPISODES", 1)
    return module


@pytest.mark.parametrize("task", ["case1", "foraging"])
def test_a_seed_learns_the_same_twice_and_the_file_runs(learn, task, tmp_path):
    world, curve = getattr(learn, task)(2)
    assert getattr(learn, task)(2)[1] == curve and len(curve) == 2
    world.save(tmp_path / "learned.xml")
    done = subprocess.run([elsie.program(), "run", tmp_path / "learned.xml", "--seed", "1", "--quiet"], capture_output=True, text=True,
                          check=False)
    assert done.returncode in (0, 1) and done.stderr == ""  # 1: not all is collected yet


def test_case_1_is_learned_in_a_few_generations(learn):
    curve = learn.case1(3)[1]
    assert curve[-1][0] > curve[0][0] + 0.5 and curve[-1][1] > 3.4  # all four resources


def test_the_method_is_as_short_as_the_page_says():
    lines = [line for line in (EXAMPLE / "learn.py").read_text().splitlines() if line.strip()]
    assert len(lines) <= 60
