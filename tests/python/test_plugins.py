"""Plugins in Python, in this process and by the program."""
import itertools
import json
import math
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import threading
import time
import types
import warnings
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pytest

import elsie

EXAMPLE = Path(os.environ["ELSIE_SOURCE"]) / "examples/12-python-plugins"

STAND = """
class Stand(elsie.Behavior):
    \"\"\"Stands.\"\"\"
    def respond(self, now):
        return elsie.Motion()
"""


class Place:
    """A folder with a script, and worlds with one robot."""

    def __init__(self, folder):
        self.folder = folder

    def script(self, text, name="mine.py"):
        file = self.folder / name
        file.write_text("import math\nimport elsie\n" + text)
        return file

    def world(self, behaviors, *, sensors="", actuators="", coordinator="<arbiter_suppression/>", more="", time_limit=1.0, robots=""):
        text = f"""<world format="1"><arena length="4" width="4"/><robots>
            <robot id="r1" team="red"><sensors>{sensors}</sensors><actuators>{actuators}</actuators>
              <behaviors>{behaviors}</behaviors><coordinator>{coordinator}</coordinator></robot>{robots}</robots>
            {more}<limits time="{time_limit}"/></world>"""
        file = self.folder / "world.xml"
        file.write_text(text)
        return file

    def run(self, script, behaviors, seed=1, **facts):
        world = elsie.World(self.world(behaviors, **facts), plugins=[self.script(script)])
        run = elsie.Simulation(world, seed=seed)
        return run, run.run()

    def elsie(self, *words, timeout=60, environment=None):
        return subprocess.run([elsie.program(), *map(str, words)], cwd=self.folder, capture_output=True, text=True, timeout=timeout,
                              env={**os.environ, **(environment or {})})


    def watched(self, world, script):
        return Watched(self, world, script)


class Watched:
    """A run of the program with --watch, in real time, until the end of `with`."""

    def __init__(self, place, world, script):
        self.errors = place.folder / "errors"
        with open(self.errors, "w") as errors:
            self.process = subprocess.Popen([elsie.program(), "run", world, "--plugin", script, "--watch", "--speed", "1"],
                                            cwd=place.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=errors)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()

    def text(self):
        return self.errors.read_text()

    def wait_until(self, holds, again=lambda i: None):
        """`again` is called meanwhile, each time after several looks of the program: a file that is saved before the program watches it is no edit.

        The next time after twice as many: a file that is saved breaks off the trial of what it was.
        """
        end = time.monotonic() + 60
        due = 0
        for i in itertools.count():
            if i == due:
                again(i)
                due = 2 * i + 14
            if holds():
                return
            assert time.monotonic() < end, self.text()
            time.sleep(0.05)

    def wait_for(self, text, again=lambda i: None, times=1):
        self.wait_until(lambda: self.text().count(text) >= times, again)


@pytest.fixture
def place(tmp_path):
    return Place(tmp_path)


def refused(place, script):
    """The sentence with which a script is refused."""
    file = place.script(script)
    with pytest.raises(elsie.InputError) as error:
        elsie.World(place.world("<stand/>"), plugins=[file])
    return str(error.value)


def fault(place, script, behaviors="<faulty/>", **facts):
    with pytest.raises(elsie.PluginFault) as error:
        place.run(script, behaviors, **facts)
    return error.value


def shown(run, name):
    """The number that the only plugin publishes."""
    return run.published(name)["value"][0]


class TestBehaviors:
    def test_the_example_reaches_its_goals_in_the_program(self, place):
        run = place.elsie("run", EXAMPLE / "world.xml", "--plugin", EXAMPLE / "orbit.py", "--json")
        assert run.returncode == 0, run.stderr
        assert run.stderr == ""
        assert json.loads(run.stdout)["outcome"] == "success"

    def test_the_checker_finds_no_fault_in_it(self, place):
        run = place.elsie("test-plugin", EXAMPLE / "orbit.py")
        assert (run.returncode, run.stdout) == (0, "behavior 'orbit': no faults found\n")

    def test_the_declaration_is_that_of_the_class(self, place):
        run = place.elsie("describe", "orbit", "--plugin-path", EXAMPLE)
        assert "Circles to the left, and matters more with something near" in run.stdout
        for words in ("radius", "of the circle", "0.5", "distance", "range"):
            assert words in run.stdout

    def test_readings_are_arrays_over_the_sensors(self, place):
        run, _ = place.run("""
class Look(elsie.Behavior):
    \"\"\"Looks.\"\"\"
    needs = ["range"]
    first = elsie.published()
    second = elsie.published()
    hits = elsie.published()
    azimuth = elsie.published()
    def respond(self, now):
        beams = now.readings["range"]
        assert beams.ids == ["a", "b"] and len(beams) == 2 and list(beams.age_s) == [0.0, 0.0]
        assert beams.distance_m.dtype == float and beams.hit.dtype == bool
        self.first, self.second = beams.distance_m
        self.hits = beams.hit.sum()
        self.azimuth = beams.azimuth_rad[1]
        return elsie.Motion()
""", "<look/>", sensors='<beam_range id="a" max_range="3"/><beam_range id="b" yaw_deg="90" max_range="1"/>', time_limit=0.1)
        seen = shown(run, "first"), shown(run, "second"), shown(run, "hits")
        assert 1.8 < seen[0] < 2.0
        assert seen[1:] == (1.0, 1.0)
        assert shown(run, "azimuth") == pytest.approx(math.pi / 2)

    def test_an_array_that_is_kept_is_not_written_again(self, place):
        place.run("""
class Keep(elsie.Behavior):
    \"\"\"Keeps what it saw.\"\"\"
    def reset(self, random):
        self.seen = []
    def respond(self, now):
        self.seen.append(now.readings["range"].distance_m)
        values = [array[0] for array in self.seen]
        assert values == sorted(values, reverse=True) and len(set(values)) == len(values), values
        return elsie.Motion(forward=0.3)
""", "<keep/>", sensors='<beam_range max_range="3"/>', time_limit=0.2)

    def test_arrays_in_readings_have_a_row_for_each_sensor(self, place):
        run, _ = place.run("""
class Look(elsie.Behavior):
    \"\"\"Looks.\"\"\"
    nearest = elsie.published()
    def respond(self, now):
        ranges = now.readings["lidar"].ranges
        assert ranges.shape == (1, 13), ranges.shape
        self.nearest = ranges.min()
        return elsie.Motion()
""", "<look/>", sensors='<lidar rays="13" max_range="5"/>', time_limit=0.1)
        assert 1.8 < shown(run, "nearest") < 2.0

    def test_now_counts_during_the_call_only(self, place):
        error = fault(place, """
class Faulty(elsie.Behavior):
    \"\"\"Reads a stream of an earlier call.\"\"\"
    def reset(self, random):
        self.random = random
    def respond(self, now):
        return elsie.Motion(self.random.uniform())
""")
        assert "mine.py:9: RuntimeError: what `now` gives is valid during the call only" in str(error)

    def test_answers_may_be_a_motion_with_its_activation_or_a_response(self, place):
        _, result = place.run("""
class Pair(elsie.Behavior):
    \"\"\"A pair.\"\"\"
    def respond(self, now):
        return elsie.Motion(forward=0.1), 0.25
class Full(elsie.Behavior):
    \"\"\"A response.\"\"\"
    raises = {"done": "it is"}
    def respond(self, now):
        answer = elsie.Response(now.self.motion(left=5.0, right=5.0), activation=0.5, strength=0.75)
        return answer.raise_event("done") if now.time == 0 else answer
class Look(elsie.Coordinator):
    \"\"\"Compares.\"\"\"
    def coordinate(self, members, now):
        pair, full = (member.respond() for member in members)
        assert (pair.motion.forward, pair.activation, pair.strength) == (0.1, 0.25, 1.0)
        assert (full.motion.turn, full.activation, full.strength) == (0.0, 0.5, 0.75)
        return elsie.Motion()
""", "<pair/><full/>", coordinator="<look/>", time_limit=0.1)
        assert [event.name for event in result.events].count("done") == 1

    def test_state_of_init_is_that_of_each_run(self, place):
        world = elsie.World(place.world("<count/>", time_limit=0.1), plugins=[place.script("""
class Count(elsie.Behavior):
    \"\"\"Counts.\"\"\"
    steps = elsie.published()
    def __init__(self):
        self.steps = 0
    def respond(self, now):
        self.steps += 1
        return elsie.Motion()
""")])
        run = elsie.Simulation(world, seed=1)
        run.run()
        first = shown(run, "steps")
        run.reset(seed=2)
        run.run()
        assert shown(run, "steps") == first > 0

    def test_random_numbers_are_those_of_the_seed(self, place):
        script = """
class Drunk(elsie.Behavior):
    \"\"\"Drives anyhow.\"\"\"
    def respond(self, now):
        draw = now.random
        return elsie.Motion(draw.uniform(0, 0.3), draw.normal(0, 2) + draw.integer(3) + draw.chance(0.5))
"""
        poses = [place.run(script, "<drunk/>", seed=seed)[0].poses.tolist() for seed in (1, 1, 2)]
        assert poses[0] == poses[1] != poses[2]

    def test_the_program_and_this_process_make_the_same_run(self, place):
        file = place.script(STAND.replace("elsie.Motion()", "elsie.Motion(0.1 + 0.1 * now.random.uniform(), 1.0)"))
        world = place.world("<stand/>")
        run = place.elsie("run", world, "--plugin", file, "--seed", 3, "--json")
        here = elsie.Simulation(elsie.World(world, plugins=[file]), seed=3)
        result = here.run()
        if elsie.same_bits():
            assert json.loads(run.stdout)["state_hash"] == result.state_hash

    def test_it_commands_actuators_and_talks(self, place):
        run, _ = place.run("""
OFFER = elsie.message("offer", x="m", y="m")
class Talk(elsie.Behavior):
    \"\"\"Talks.\"\"\"
    commands = ["say"]
    hears = [OFFER]
    heard = elsie.published()
    def respond(self, now):
        for offer in now.heard("offer"):
            assert offer.y == 2.0 and offer.kind == "offer"
            self.heard = offer.x
        return elsie.Response().say(OFFER, x=float(now.self.id == "r2") + 1.0, y=2.0)
""", "<talk/>", actuators='<radio range="3"/>', time_limit=0.5, robots="""<robot id="r2" team="red" x="1"><actuators><radio range="3"/>
            </actuators><behaviors><talk/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>""")
        assert run.published("heard")["value"].tolist() == [2.0, 1.0]


    def test_a_new_version_takes_over_what_the_class_remembers(self, place):
        script = """
class Turn(elsie.Behavior):
    \"\"\"Turns more and more.\"\"\"
    remembers = ["turn", "seen"]
    def reset(self, random):
        self.turn, self.seen = 0.0, [0.0, 0.0]
    def respond(self, now):
        self.turn += 0.01
        self.seen = [self.seen[1], self.turn]
        return elsie.Motion(self.seen[0], self.turn)
"""
        assert place.elsie("test-plugin", place.script(script)).stdout == "behavior 'turn': no faults found\n"
        findings = place.elsie("test-plugin", place.script(script.replace(', "seen"', "")))
        assert findings.returncode == 1
        assert "takes over" in findings.stdout

    def test_a_random_order_of_sets_is_noted_once(self, place):
        other = '<robot id="r2" team="red" x="1"><behaviors><stand/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>'
        place.world("<stand/>", robots=other, time_limit=0.1)
        code = """
import warnings; warnings.simplefilter("ignore")
import elsie
world = elsie.World("world.xml", plugins=["mine.py"])
print(sum("PYTHONHASHSEED" in str(note) for note in elsie.Simulation(world).run().notes))
"""
        place.script(STAND)
        for seed, notes in (("", "1"), ("0", "0")):
            said = subprocess.run([sys.executable, "-c", code], cwd=place.folder, capture_output=True, text=True,
                                  env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(Path(elsie.__file__).parents[1])})
            assert said.stdout.strip() == notes, said.stderr

    def test_messages_and_commands_are_those_of_plugins_in_cpp(self, place):
        run, _ = place.run("""
HEADING = elsie.message("heading", heading_rad="rad")
class Listen(elsie.Behavior):
    \"\"\"Listens.\"\"\"
    hears = [HEADING]
    commands = ["led"]
    heading = elsie.published()
    def respond(self, now):
        for each in now.heard("heading"):
            self.heading = each.heading_rad
        return elsie.Response().act("led", red=255, green=0, blue=0)
""", "<listen/>", actuators='<radio range="3"/><led/>', time_limit=0.5, robots="""<robot id="r2" team="red" x="1" heading_deg="90"><actuators><radio range="3"/>
            </actuators><behaviors><say what="heading"/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>""")
        assert shown(run, "heading") == pytest.approx(math.pi / 2)


class TestOtherKinds:
    def test_a_coordinator_asks_and_leaves_a_trace(self, place):
        run, _ = place.run("""
class Go(elsie.Behavior):
    \"\"\"Goes.\"\"\"
    speed = elsie.parameter(0.1)
    def respond(self, now):
        return elsie.Motion(self.speed), self.speed
class Loudest(elsie.Coordinator):
    \"\"\"The most active drives.\"\"\"
    def coordinate(self, members, now):
        assert [member.name for member in members] == ["slow", "fast"]
        best = max(members, key=lambda member: member.respond().activation)
        best.weight = best.share = 1.0
        best.reason = "most active"
        return best.respond().motion
""", '<go id="slow" speed="0.1"/><go id="fast" speed="0.3"/>', coordinator="<loudest/>")
        assert run.poses[0, 0] > 0.2

    def test_a_fault_of_a_behaviour_is_its_own_below_a_coordinator(self, place):
        error = fault(place, """
class Faulty(elsie.Behavior):
    \"\"\"Fails.\"\"\"
    def respond(self, now):
        raise ValueError("oh")
class Ask(elsie.Coordinator):
    \"\"\"Asks.\"\"\"
    def coordinate(self, members, now):
        return members[0].respond().motion
""", coordinator="<ask/>")
        assert error.plugin == "faulty"
        assert str(error).endswith("mine.py:7: ValueError: oh")

    def test_a_class_may_have_its_base_in_another_line(self, place):
        script = place.script("""
class Wide(
    elsie.Behavior,
):
    \"\"\"Stands.\"\"\"
    def respond(self, now):
        return elsie.Motion()
""")
        assert elsie.Simulation(elsie.World(place.world("<wide/>"), plugins=[script])).step(3) == 3

    @pytest.mark.parametrize("question", ["ray(math.nan)", "ray(-1)", "see(1, azimuth_rad=math.inf)", "things(math.nan)", "lights(-1)",
                                          "anything_in(math.nan, 1, 1)", "is_open(math.nan, 0, 0)", "floor_colour(math.inf, 0)"])
    def test_a_sensor_asks_with_finite_numbers(self, place, question):
        failed = fault(place, f"""
class Odd(elsie.Sensor):
    \"\"\"Asks oddly.\"\"\"
    reading = elsie.reading("odd", x="m")
    def sense(self, now):
        now.{question}
        return {{"x": 0.0}}
""", "<wander/>", sensors="<odd/>")
        assert "expected a finite number" in str(failed)

    def test_a_sensor_makes_readings_of_its_own_that_noise_may_change(self, place):
        run, _ = place.run("""
class Clearance(elsie.Sensor):
    \"\"\"Looks to both sides.\"\"\"
    reading = elsie.reading("clearance", left="m", cells=elsie.array(3, unit="m"))
    def sense(self, now):
        return {"left": now.ray(3.0, azimuth_rad=math.pi / 2) or 3.0, "cells": [1, 2, 3]}
class Read(elsie.Behavior):
    \"\"\"Reads.\"\"\"
    needs = ["clearance"]
    left = elsie.published()
    cell = elsie.published()
    def respond(self, now):
        clear = now.readings["clearance"]
        self.left = clear.left[0]
        assert clear.cells.shape == (1, 3)
        self.cell = clear.cells[0, 2]
        return elsie.Motion()
""", "<read/>", sensors='<clearance><noise on="left" bias="10"/></clearance>', time_limit=0.1)
        assert shown(run, "left") == pytest.approx(12, abs=0.1)
        assert shown(run, "cell") == 3

    def test_a_sensor_may_make_range_readings_for_any_behaviour(self, place):
        run, _ = place.run("""
class Wall(elsie.Sensor):
    \"\"\"Sees a wall that is not there.\"\"\"
    reading = "range"
    def sense(self, now):
        return {"distance_m": 0.01, "max_range_m": 1.0, "hit": True}
""", "<avoid_obstacle/>", sensors='<wall yaw_deg="20"/>')
        assert abs(run.poses[0, 2]) > 0.1

    def test_an_actuator_carries_out_commands(self, place):
        run, _ = place.run("""
class Flash(elsie.Actuator):
    \"\"\"Shines.\"\"\"
    command = elsie.command("flash", on="")
    shone = elsie.published()
    def __init__(self):
        self.shone = 0
    def act(self, command, now):
        if command.on > 0.5:
            now.shine(255, 0, 0, 2.0)
            now.draw_power(1.0)
            self.shone += 1
class Use(elsie.Behavior):
    \"\"\"Uses it.\"\"\"
    commands = ["flash"]
    only_acts = True
    def respond(self, now):
        return elsie.Response().act("flash", on=1.0)
""", "<use/>", actuators="<flash/>", time_limit=0.5)
        assert shown(run, "shone") > 10

    def test_a_measure_reports(self, place):
        _, result = place.run(STAND + """
class Far(elsie.Measure):
    \"\"\"How far.\"\"\"
    quantities = {"": ("m", "farthest"), "steps": ("", "observations")}
    def reset(self, random):
        self.far, self.steps = 0.0, 0
    def observe(self, now):
        assert now.poses.shape == (1, 3) and now.robots[0].id == "r1" and now.robot("r1").team == "red"
        self.far = max(self.far, float(abs(now.poses[0, 0])))
        self.steps += 1
    def report(self, end):
        return {"steps": self.steps, "": self.far}
""", "<stand/>", more="<measures><far/></measures>")
        assert result.measures["far.steps"] > 10
        assert result.measures["far"] == pytest.approx(0, abs=1e-9)

    def test_a_rule_changes_the_world_and_ends_the_run(self, place):
        run, result = place.run(STAND + """
class Move(elsie.Rule):
    \"\"\"Moves the robot.\"\"\"
    raises = {"moved": "it was"}
    def apply(self, now, world):
        if now.is_start:
            world.place("robot[r1]", 1.0, 0.5)
            world.raise_event("moved", "r1")
        if now.time > 0.3:
            world.succeed("it is enough")
""", "<stand/>", more="<rules><move/></rules>", time_limit=5)
        assert run.poses[0, :2].tolist() == pytest.approx([1.0, 0.5], abs=0.01)
        assert result.outcome == "success"
        assert run.time < 1

    @pytest.mark.parametrize("kind", ["behavior", "coordinator", "sensor", "actuator", "measure", "rule"])
    def test_new_makes_a_folder_whose_plugin_works(self, place, kind):
        assert place.elsie("new", kind, "my_thing", "--python").returncode == 0
        here = place.folder / "my_thing"
        assert sorted(file.name for file in here.iterdir()) == ["README.md", "my_thing.py", "test_my_thing.py", "world.xml"]
        run = place.elsie("run", here / "world.xml", "--plugin", here / "my_thing.py", "--quiet")
        assert (run.returncode, run.stderr) == (0, "")
        check = place.elsie("test-plugin", here / "my_thing.py")
        assert check.returncode == 0, check.stdout + check.stderr

    @pytest.mark.parametrize("kind", ["drive", "localisation"])
    def test_drives_and_localisations_are_only_in_cpp(self, place, kind):
        run = place.elsie("new", kind, "my_thing", "--python")
        assert run.returncode == 2
        assert "must be written in C++" in run.stderr


class TestFaults:
    def test_an_exception_is_named_with_line_robot_and_step(self, place):
        error = fault(place, """
class Faulty(elsie.Behavior):
    \"\"\"Fails.\"\"\"
    def respond(self, now):
        if now.time > 0.1:
            return elsie.Motion(1 / 0)
        return elsie.Motion()
""")
        assert (error.plugin, error.robot) == ("faulty", "r1")
        assert error.step > 0
        assert str(error).endswith("mine.py:8: ZeroDivisionError: division by zero")

    def test_the_program_ends_with_code_3(self, place):
        file = place.script("""
class Faulty(elsie.Behavior):
    \"\"\"Fails.\"\"\"
    def respond(self, now):
        return [][1]
""")
        run = place.elsie("run", place.world("<faulty/>"), "--plugin", file)
        assert run.returncode == 3
        assert "plugin 'faulty' of robot 'r1' failed in step 0 (at 0 s): mine.py:7: IndexError: list index out of range" in run.stderr

    @pytest.mark.parametrize("answer, what", [("3", "respond() returned 3; expected"), ("None", "respond() returned None"),
                                              ("(elsie.Motion(), 'x')", "respond() returned (Motion("),
                                              ("(elsie.Motion(), 7.0)", "activation"),
                                              ("elsie.Motion(math.nan)", "finite"),
                                              ("elsie.Response().raise_event('x')", "'x'"),
                                              ("elsie.Response().act('nothing', a=1)", "nothing")])
    def test_an_answer_that_makes_no_sense_is_refused(self, place, answer, what):
        error = fault(place, f"""
class Faulty(elsie.Behavior):
    \"\"\"Fails.\"\"\"
    def respond(self, now):
        return {answer}
""")
        assert what in str(error)

    @pytest.mark.parametrize("script, what", [
        ("class Stand(elsie.Behavior):\n    def respond(self, now) return 1\n", "mine.py:4: SyntaxError"),
        ("import no_such_module\n" + STAND, "mine.py:3: ModuleNotFoundError: No module named 'no_such_module'"),
        ("class Stand(elsie.Behavior):\n    def respond(self, now):\n        pass\n", "mine.py:3: Stand has no docstring"),
        ("class Stand(elsie.Behavior):\n    'Stands'\n", "mine.py:3: Stand has no method respond()"),
        (STAND + "    needs = 'range'\n", "mine.py:8: Stand.needs is 'range'; expected a list"),
        (STAND + "    size = elsie.parameter(None)\n", "mine.py:8: the default of the parameter 'size' is None"),
        (STAND + "    size = elsie.parameter(1.0, max=0)\n", "the default of size is 1"),
        ("import random\n" + STAND + "    def reset(self, stream):\n        self.x = random.random()\n", "mine.py:10: random.random() gives"),
        ("import numpy as np\n" + STAND + "    x = np.random.uniform()\n", "mine.py:9: np.random.uniform()"),
        ("from numpy import random\n" + STAND + "    x = random.uniform()\n", "mine.py:9: random.uniform()"),
        ("from numpy.random import default_rng\n" + STAND + "    x = default_rng()\n", "mine.py:9: default_rng() without a seed"),
        ("from numpy.random import default_rng\n" + STAND + "    x = default_rng(None)\n", "mine.py:9: default_rng() without a seed"),
        ("KIND = elsie.reading('own', cells=elsie.array(0))\n" + STAND, "mine.py:3: array(): the size is 0; expected a whole number"),
        (STAND + "    size = elsie.parameter(1.0, min='a')\n", "mine.py: a declaration has a value of another type")])
    def test_a_script_with_a_mistake_is_refused_with_its_line(self, place, script, what):
        assert what in refused(place, script)

    def test_generators_with_a_seed_are_allowed(self, place):
        place.run("import numpy as np\nimport random\n" + STAND + "    a = np.random.default_rng(3)\n    b = random.Random(3)\n", "<stand/>",
                  time_limit=0.1)

    @pytest.mark.parametrize("method", ["__init__(self)", "configured(self)", "equipped(self, example)", "reset(self, random)", "notes(self)",
                                        "curves(self)", "rate(self, now, given, candidates)"])
    def test_an_exception_in_any_method_is_an_error_with_its_line(self, place, method):
        with pytest.raises(elsie.Error) as error:
            place.run(STAND + f"    def {method}:\n        raise ValueError('oh')\n", "<stand/>", coordinator="<arbiter_voting/>")
        assert "mine.py:9: ValueError: oh" in str(error.value)

    @pytest.mark.parametrize("kind, method", [
        ("Sensor", "sense(self, now)"), ("Actuator", "act(self, command, now)"), ("Measure", "observe(self, now)"),
        ("Measure", "report(self, end)"), ("Rule", "apply(self, now, world)"), ("Coordinator", "coordinate(self, members, now)")])
    def test_an_exception_in_any_kind_is_an_error_with_its_line(self, place, kind, method):
        others = {"Measure": "    quantities = {'': ('', 'one')}\n    observe = report = lambda self, x: {}\n",
                  "Sensor": "    reading = elsie.reading('own', x='')\n", "Actuator": "    command = elsie.command('own', x='')\n"}
        script = STAND + f"class Faulty(elsie.{kind}):\n    'Fails.'\n    def {method}:\n        raise ValueError('oh')\n"
        if kind == "Measure":
            script = script.replace(f"    def {method}", others[kind] + f"    def {method}")
        else:
            script += others.get(kind, "")
        where = {"Sensor": {"sensors": "<faulty/>"}, "Actuator": {"actuators": "<faulty/>"}, "Measure": {"more": "<measures><faulty/></measures>"},
                 "Rule": {"more": "<rules><faulty/></rules>"}, "Coordinator": {"coordinator": "<faulty/>"}}[kind]
        error = fault(place, script, "<stand/>", **where)
        assert error.plugin == "faulty"
        assert f"mine.py:{13 if kind == 'Measure' else 11}: ValueError: oh" in str(error)

    @pytest.mark.parametrize("answer, what", [("{}", "lacks the number 'x'"), ("{'x': 'a'}", "'a'; expected a number"), ("{'x': math.inf}", "finite"),
                                              ("{'x': 1, 'y': 2}", "'y', which is not declared"), ("None", "None")])
    def test_a_reading_that_makes_no_sense_is_refused(self, place, answer, what):
        error = fault(place, STAND + f"""
class Faulty(elsie.Sensor):
    'Fails.'
    reading = elsie.reading("own", x="")
    def sense(self, now):
        return {answer}
""", "<stand/>", sensors="<faulty/>")
        assert what in str(error)
        assert "mine.py:12: its reading" in str(error) or "mine.py:12: the number 'x' of its reading" in str(error)

    def test_a_published_number_that_is_none_is_named(self, place):
        with pytest.raises(elsie.PluginFault, match="the published number 'near' is 'far'; expected a number"):
            run, _ = place.run("""
class Show(elsie.Behavior):
    \"\"\"Shows a text.\"\"\"
    near = elsie.published()
    def respond(self, now):
        self.near = "far"
        return elsie.Motion()
""", "<show/>", time_limit=0.1)
            run.published("near")

    @pytest.mark.parametrize("answer, what", [("{'': 'far'}", "a value of another type"), ("{'far': 1.0}", "none of its quantities"),
                                              ("{'more': 1.0}", "quantities names 2 values now, and named 1 before the run")])
    def test_a_report_that_makes_no_sense_is_refused(self, place, answer, what):
        error = fault(place, STAND + f"""
class Faulty(elsie.Measure):
    'Reports nonsense.'
    def __init__(self):
        self.names = {{'': ('m', 'one')}}
    def quantities(self):
        return self.names
    def observe(self, now):
        if "more" in {answer!r}:
            self.names['more'] = ('m', 'another')
    def report(self, end):
        return {answer}
""", "<stand/>", more="<measures><faulty/></measures>")
        assert error.plugin == "faulty" and what in str(error)

    def test_a_script_that_empties_its_readings_finds_none(self, place):
        error = fault(place, """
class Faulty(elsie.Behavior):
    \"\"\"Empties the dict.\"\"\"
    def respond(self, now):
        now.readings.clear()
        if now.time > 0:
            now.readings["range"]
        return elsie.Motion()
""", sensors="<beam_range/>")
        assert "no sensor of the robot makes readings of the kind 'range'" in str(error)

    def test_an_endless_loop_is_named(self, place):
        file = place.script("""
class Faulty(elsie.Behavior):
    \"\"\"Never answers.\"\"\"
    def respond(self, now):
        while True:
            pass
""")
        run = place.elsie("run", place.world("<faulty/>"), "--plugin", file, "--time-budget", "500")
        assert run.returncode == 3
        assert "'faulty'" in run.stderr and "'r1'" in run.stderr

    def test_ctrl_c_ends_a_run_of_this_process(self, place):
        script = place.script("""
import signal
class Stop(elsie.Behavior):
    \"\"\"Is interrupted.\"\"\"
    def respond(self, now):
        if now.time > 0.2:
            signal.raise_signal(signal.SIGINT)
        return elsie.Motion()
""")
        run = elsie.Simulation(elsie.World(place.world("<stop/>"), plugins=[script]))
        with pytest.raises(KeyboardInterrupt):
            run.run()

    def test_without_python_a_script_is_left_out_with_one_note(self, place):
        folder = place.folder / "plugins"
        folder.mkdir()
        place.script(STAND, "plugins/mine.py")
        (folder / "tool.py").write_text("print('no plugin')\n")
        there = without_python(place.folder)
        there_first = {**os.environ, "LD_LIBRARY_PATH": str(there.parents[1] / "lib")}
        run = subprocess.run([there, "run", place.world("<wander/>", time_limit=0.1), "--plugin-path", folder],
                             capture_output=True, text=True, env=there_first)
        assert "mine.py: is written in Python, and this Elsie was built without Python; it is left out" in run.stderr
        assert run.stderr.count(".py") == 1
        named = subprocess.run([there, "run", place.world("<stand/>"), "--plugin", folder / "mine.py"], capture_output=True, text=True,
                               env=there_first)
        assert named.returncode == 2
        assert "is written in Python, and this Elsie was built without Python" in named.stderr


def without_python(folder):
    """A copy of the program without the part that starts Python."""
    program = Path(elsie.program())
    lib, there = program.parents[1] / "lib", folder / "elsie"
    (there / "bin").mkdir(parents=True)
    shutil.copy(program, there / "bin/elsie")
    (there / "lib/elsie").mkdir(parents=True)
    for each in lib.glob("*.so*"):
        # The core finds its parts next to its own file.
        shutil.copy(each, there / "lib" / each.name) if each.name.startswith("libelsie.so") else (there / "lib" / each.name).symlink_to(each)
    for each in (lib / "elsie").iterdir():
        if each.name != "python.so":
            (there / "lib/elsie" / each.name).symlink_to(each)
    return there / "bin/elsie"


class TestInRuns:
    def test_an_edited_script_replaces_its_objects(self, place):
        file = place.script(STAND.replace("elsie.Motion()", "elsie.Motion(0.1)"))
        with place.watched(place.world("<stand/>", time_limit=1e5), file) as run:
            run.wait_for("mine.py: new: stand of 'r1'",
                         lambda i: place.script(STAND.replace("elsie.Motion()", f"elsie.Motion(0.1 + 0.001 * {i})")))

    def test_a_study_keeps_the_hash_of_the_script(self, place):
        file = place.script(STAND.replace("Motion()", "Motion(now.random.uniform())"))
        place.world("<stand/>", time_limit=0.1)
        (place.folder / "study.xml").write_text('<experiment format="1"><worlds><world file="world.xml"/></worlds>'
                                                '<seeds from="1" to="2"/></experiment>')
        run = place.elsie("batch", "study.xml", "--plugin-path", place.folder, "--database", "a.sqlite")
        assert run.returncode == 0, run.stderr
        # Runs are copies of a process that has loaded the script; each might as well have a program of its own.
        assert place.elsie("batch", "study.xml", "--plugin-path", place.folder, "--database", "b.sqlite", "--fresh-processes").returncode == 0
        hashes = [sqlite3.connect(place.folder / name).execute("SELECT seed, state_hash FROM runs ORDER BY seed").fetchall()
                  for name in ("a.sqlite", "b.sqlite")]
        assert hashes[0] == hashes[1]
        assert place.elsie("replay", "a.sqlite", "1", "--plugin-path", place.folder).returncode == 0
        place.script(STAND + "# changed\n")
        resumed = place.elsie("batch", "study.xml", "--plugin-path", place.folder, "--database", "a.sqlite", "--resume")
        assert file.name in resumed.stderr + resumed.stdout


def test_a_simple_behaviour_decides_fast(place):
    """More than 100,000 decisions in a second on a machine of our day; this finds what is ten times slower."""
    world = place.world("<orbit/>", sensors='<beam_range id="a"/>' + "".join(f'<beam_range id="b{i}" yaw_deg="{45 * i}"/>' for i in range(1, 8)),
                        time_limit=200)
    run = elsie.Simulation(elsie.World(world, plugins=[EXAMPLE / "orbit.py"]))
    start = time.perf_counter()
    run.step(10_000)
    assert time.perf_counter() - start < 1.0


class TestNumpysErrors:
    """What numpy does about errors (numpy.seterr) is the user's to say, and a script's for its own methods."""

    DIVIDES = """
import numpy as np
{0}
class Divide(elsie.Behavior):
    \"\"\"Divides by zero.\"\"\"
    def respond(self, now):
        np.zeros(1) / np.zeros(1)
        return elsie.Motion()
"""

    def test_a_script_is_under_what_the_user_has_set(self, place):
        with np.errstate(all="raise"), pytest.raises(elsie.PluginFault, match="FloatingPointError"):
            place.run(self.DIVIDES.format(""), "<divide/>")
        with np.errstate(all="ignore"):
            place.run(self.DIVIDES.format(""), "<divide/>")

    def test_what_a_script_sets_holds_for_it_alone(self, place):
        before = np.geterr()
        script = self.DIVIDES.format("np.seterr(all='raise')")
        with pytest.raises(elsie.PluginFault, match="FloatingPointError"):
            place.run(script, "<divide/>")
        assert np.geterr() == before
        with np.errstate(all="raise"):
            place.run(self.DIVIDES.format("np.seterr(all='ignore')"), "<divide/>")
            assert np.geterr()["divide"] == "raise"

    @pytest.mark.parametrize("threads", [1, 2])
    def test_it_is_the_same_in_all_threads_of_an_environment(self, place, threads):
        world = elsie.World(place.world('<divide/>', sensors="<beam_range/>"), plugins=[place.script(self.DIVIDES.format(""))])
        with np.errstate(all="ignore"):
            envs = elsie.VectorEnv(world, 16, threads=threads, act="priorities", steps=50)
            envs.reset(seed=1)
        for _ in range(5):
            with np.errstate(all="ignore"):
                envs.reset(seed=1)
            with np.errstate(all="raise"), pytest.raises(elsie.PluginFault, match="world 0: .*FloatingPointError"):
                envs.step(np.zeros(envs.action_space.shape))
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("error")
            envs.reset(seed=1)
            envs.step(np.zeros(envs.action_space.shape))

    def test_a_call_that_is_refused_changes_nothing_of_the_one_at_work(self, place):
        """A step in which the plugins wait until another thread has asked for a step, with other errors."""
        gate = types.ModuleType("gate")
        gate.entered, gate.refused = threading.Event(), threading.Event()
        script = self.DIVIDES.format("import gate").replace("np.zeros(1) /", "gate.entered.set(); gate.refused.wait(60); np.zeros(1) /")
        with patch.dict(sys.modules, gate=gate):
            world = elsie.World(place.world("<divide/>", sensors="<beam_range/>"), plugins=[place.script(script)])
        gate.refused.set()
        with np.errstate(all="ignore"):
            envs = elsie.VectorEnv(world, 16, threads=2, act="priorities", steps=50)
            envs.reset(seed=1)
        gate.entered.clear()
        gate.refused.clear()
        failed = []

        def step():
            try:
                with np.errstate(all="ignore"):
                    envs.step(np.zeros(envs.action_space.shape))
            except elsie.Error as error:
                failed.append(error)
        at_work = threading.Thread(target=step)
        at_work.start()
        assert gate.entered.wait(60)
        with np.errstate(all="raise"), pytest.raises(elsie.InputError, match="at work in another thread"):
            envs.step(np.zeros(envs.action_space.shape))
        gate.refused.set()
        at_work.join()
        assert not failed

    @pytest.mark.parametrize("threads", [1, 2])
    def test_the_function_that_numpy_calls_comes_along(self, place, threads):
        world = elsie.World(place.world("<divide/>", sensors="<beam_range/>"), plugins=[place.script(self.DIVIDES.format(""))])
        with np.errstate(all="ignore"):
            envs = elsie.VectorEnv(world, 16, threads=threads, act="priorities", steps=50)
            envs.reset(seed=1)
        called = []
        with np.errstate(all="call", call=lambda *what: called.append(what)):
            envs.step(np.zeros(envs.action_space.shape))
        assert len(called) >= 16

    def test_a_script_has_its_own_function_that_numpy_calls(self, place):
        script = self.DIVIDES.format("""
def refuse(*_):
    raise ValueError("of the script")
np.seterr(all="call")
np.seterrcall(refuse)
""")
        before = np.geterr(), np.geterrcall()
        with pytest.raises(elsie.PluginFault, match="ValueError: of the script"):
            place.run(script, "<divide/>")
        assert (np.geterr(), np.geterrcall()) == before

    def test_runs_in_threads_are_under_it_too(self, place):
        world = elsie.World(place.world("<divide/>"), plugins=[place.script(self.DIVIDES.format(""))])
        with np.errstate(all="raise"), pytest.raises(elsie.PluginFault, match="FloatingPointError"):
            elsie.run(world, range(4), workers=2)

    def test_in_a_run_of_the_program_a_script_that_changes_keeps_what_it_sets(self, place):
        """It is loaded in another thread then."""
        file = place.script(STAND)
        world = place.world("<stand/>", time_limit=1e5)
        with place.watched(world, file) as run:
            run.wait_for("mine.py: new: stand of 'r1'", lambda i: place.script(STAND + f"# {i}\n"))
            script = self.DIVIDES.format("np.seterr(all='raise')").replace("Divide(", "Stand(")
            run.wait_for("failed in step", lambda i: place.script(script + f"# {i}\n"))
            assert "FloatingPointError" in run.text() and run.process.wait(20) == 3


class TestLoadingWithoutEnd:
    ENDLESS = STAND + "\nopen('tried', 'a').write('x')\nwhile True: pass\n"

    def test_it_is_stopped_and_named_as_at_the_start(self, place):
        file = place.script(self.ENDLESS)
        run = place.elsie("load-plugin", file, file, "1")
        assert run.returncode == 3
        assert f"plugin library '{file}' did not return within 1 s and was stopped, while it was loaded\n" in run.stderr

    def test_a_watched_run_goes_on_takes_the_next_version_and_ends_with_ctrl_c(self, place):
        file = place.script(STAND)
        world = place.world("<stand/>", time_limit=1e5)
        with place.watched(world, file) as run:
            run.wait_for("mine.py: new: stand of 'r1'", lambda i: place.script(STAND + f"# {i}\n"))
            place.script(self.ENDLESS)
            run.wait_until(lambda: (place.folder / "tried").exists())
            place.script(STAND + "# mended\n")
            run.wait_for("mine.py: new: stand of 'r1'", times=2)
            (place.folder / "tried").unlink()
            place.script(self.ENDLESS)
            run.wait_until(lambda: (place.folder / "tried").exists())
            run.process.send_signal(signal.SIGINT)
            assert run.process.wait(20) == 4
            assert "interrupted after" in run.text()

    def test_a_version_that_appears_while_another_is_tried_is_tried_itself(self, place):
        """A version that saves the next one as soon as it is loaded, and ends. Each notes in which process it is."""
        file = place.script(STAND)
        world = place.world("<stand/>", time_limit=1e5)
        note = "import os\nopen('loaded', 'a').write(f'{os.getpid()}\\n')\n"
        loaded = place.folder / "loaded"
        with place.watched(world, file) as run:
            run.wait_for("mine.py: new: stand of 'r1'", lambda i: place.script(STAND + f"# {i}\n"))
            (place.folder / "next").write_text("import elsie\n" + note + STAND)
            place.script("import ctypes, os\nif os.path.exists('next'):\n    os.replace('next', __file__)\n    ctypes.CDLL('libc.so.6')._exit(0)\n" + STAND)
            run.wait_until(lambda: loaded.exists() and str(run.process.pid) in loaded.read_text().split())
        assert loaded.read_text().split()[0] != str(run.process.pid)

    def test_one_that_takes_no_signals_is_ended(self, place):
        """Also when what it started has left its group and holds its output."""
        file = place.script(STAND)
        world = place.world("<stand/>", time_limit=1e5)
        deaf = ("import os, signal, subprocess\nsignal.pthread_sigmask(signal.SIG_SETMASK, range(1, signal.NSIG))\n"
                "open('started', 'a').write(f'{subprocess.Popen([\"sleep\", \"300\"], start_new_session=True).pid}\\n')\n")
        with place.watched(world, file) as run:
            run.wait_for("mine.py: new: stand of 'r1'", lambda i: place.script(STAND + f"# {i}\n"))
            place.script(deaf + self.ENDLESS)
            run.wait_until(lambda: (place.folder / "tried").exists())
            place.script(STAND + "# mended\n")
            try:
                run.wait_for("mine.py: new: stand of 'r1'", times=2)
            finally:
                for started in (place.folder / "started").read_text().split():
                    os.kill(int(started), signal.SIGKILL)
