"""The @kind@ @name@, tested by the program `elsie`: python3 -m pytest"""
import subprocess
from pathlib import Path

HERE = Path(__file__).parent


def elsie(*words):
    """The exit code of the program, and what it says."""
    done = subprocess.run(["elsie", *words], cwd=HERE, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def test_a_robot_reaches_the_goals_of_the_world_with_it():
    assert elsie("run", "world.xml", "--plugin", "@name@.py", "--quiet") == (0, "")


def test_it_keeps_its_promises_whatever_it_is_given():
    code, findings = elsie("test-plugin", "@name@.py")
    assert code == 0, findings
