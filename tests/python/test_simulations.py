"""elsie.Simulation: steps, edits while it runs, observers, recordings, and results."""
import _thread
import csv
import gc
import json
import os
import pickle
import subprocess
import sys
import threading
import weakref

import pytest

import elsie


def test_steps_are_counted_and_end_with_the_run(run):
    assert run.step() == 1
    assert run.step(99) == 99
    assert (run.steps, run.outcome) == (100, "running")
    assert run.time == pytest.approx(100 * run.step_s)
    made = run.step(10**6)
    assert run.outcome == "time_limit"
    assert run.time == pytest.approx(5)
    assert run.steps == 100 + made
    assert run.step(10) == 0


def test_a_run_goes_to_its_end_and_may_stop_on_the_way(run):
    half = run.run(until=2.5)
    assert half.outcome == "running" and half.time_s == pytest.approx(2.5)
    result = run.run()
    assert result.outcome == "time_limit" and not result.success
    assert result.time_s == pytest.approx(5)
    assert result.measures["path_length_m"] > 0 and result.units["path_length_m"] == "m"
    assert [robot.id for robot in result.robots] == ["r1", "r2"]
    assert str(result).startswith("time_limit after 5.0 s")
    assert run.run() is result


def test_steps_and_one_run_give_the_same_bits(world):
    whole = elsie.Simulation(world, seed=7).run()
    stepped = elsie.Simulation(world, seed=7)
    while stepped.outcome == "running":
        stepped.step(7)
    assert stepped.result().state_hash == whole.state_hash
    assert elsie.Simulation(world, seed=7, threads=2).run().state_hash == whole.state_hash
    assert elsie.Simulation(world, seed=8).run().state_hash != whole.state_hash


@pytest.mark.parametrize("name, edit", [("worlds/recharge.xml", "robot[r1]/@max_speed=0.2"), ("worlds/contexts.xml", "@name=x"),
                                        ("worlds/scattered/swarm.xml", "robot[r1]/@max_speed=0.2"),
                                        ("worlds/learned_arbitration.xml", "@name=x")])
def test_runs_are_those_of_the_program(name, edit):
    """In a process that has its arithmetic."""
    path, value = edit.split("=")
    script = (f"import elsie; run = elsie.Simulation({name!r}, seed=3, time_limit=4, edits={{{path!r}: {value!r}}})\n"
              "print(run.run().state_hash, elsie.same_bits())")
    fixed = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4"}
    ours = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True, env={**os.environ, **fixed})
    theirs = subprocess.run([elsie.program(), "run", name, "--seed", "3", "--duration", "4", "--set", edit, "--json"],
                            capture_output=True, text=True, check=False)
    assert ours.stdout.split() == [json.loads(theirs.stdout)["state_hash"], "True"]


def test_a_process_without_the_arithmetic_says_so_once():
    script = "import elsie; a = elsie.Simulation('worlds/open_arena.xml', time_limit=1).run(); print(a.notes)"
    clean = {name: value for name, value in os.environ.items() if name != "GLIBC_TUNABLES"}
    done = subprocess.run([sys.executable, "-c", script + "; elsie.Simulation('worlds/open_arena.xml')"],
                          capture_output=True, text=True, check=True, env=clean)
    assert done.stderr.count("RuntimeWarning") == 1
    assert "elsie python" in done.stdout


def test_where_warnings_are_errors_it_is_raised_each_time_until_it_is_let_pass(tmp_path):
    script = tmp_path / "twice.py"
    script.write_text("import elsie\nfor _ in range(2):\n    try:\n        elsie.Simulation('worlds/open_arena.xml')\n        print('made')\n"
                      "    except RuntimeWarning:\n        print('raised')\n")
    environment = {name: value for name, value in os.environ.items() if name != "GLIBC_TUNABLES"}
    environment["PYTHONPATH"] = os.path.dirname(os.path.dirname(elsie.__file__))
    for more, said in (([], "raised"), (["-W", "ignore:This process was not started"], "made")):
        done = subprocess.run([sys.executable, "-W", "error", *more, script], env=environment, capture_output=True, text=True, check=True)
        assert done.stdout.split() == [said, said]


def test_reset_starts_again_with_the_same_or_another_seed(run):
    first = run.run().state_hash
    run.reset()
    assert (run.time, run.steps, run.outcome) == (0, 0, "running")
    assert run.run().state_hash == first
    run.reset(9)
    assert run.seed == 9
    assert run.run().state_hash != first


def test_layouts_are_drawn_from_the_seed_of_the_run():
    def hash_of(seed):
        return elsie.Simulation("worlds/scattered/swarm.xml", seed, time_limit=0.1)
    assert hash_of(1).poses[0, 0] != hash_of(2).poses[0, 0]
    again = hash_of(1)
    before = again.poses.copy()
    again.reset(2)
    assert (again.poses == hash_of(2).poses).all()
    again.reset(1)
    assert (again.poses == before).all()


def test_a_running_world_is_edited_by_the_same_paths(run):
    run.step(50)
    run["robot[r1]/@max_speed"] = 0.1
    assert run["robot[r1]/@max_speed"] == 0.1
    run.add("robots", '<robot id="late" x="-1" y="1"/>')
    assert run.robots == ["r1", "r2", "late"]
    del run["robot[r2]"]
    assert run.robots == ["r1", "late"]
    assert [event.name for event in run.events].count("changed") >= 3
    run.step(10)


def test_a_refused_edit_changes_nothing(run):
    run.step(10)
    with pytest.raises(elsie.EditRefused, match="at most"):
        run["robot[r1]/@max_speed"] = 1e6
    with pytest.raises(elsie.EditRefused):
        run.edit({"robot[r1]/@max_speed": 0.2, "robot[r9]/@max_speed": 0.2})
    assert run["robot[r1]/@max_speed"] == 0.3


def test_later_edits_of_the_world_do_not_reach_the_simulation(world):
    run = elsie.Simulation(world)
    world["robot[r1]/@max_speed"] = 0.05
    assert run["robot[r1]/@max_speed"] == 0.3


def test_the_edits_and_rules_of_a_world_are_made_in_steps_too(world):
    world.add("changes", '<change time="1" path="robot[r1]/@max_speed" value="0.05"/>')
    run = elsie.Simulation(world)
    run.run(until=0.9)
    assert run["robot[r1]/@max_speed"] == 0.3
    run.run(until=1.1)
    assert run["robot[r1]/@max_speed"] == 0.05


def test_observers_are_called_after_steps_or_periods(run):
    steps, times = [], []
    run.observe(lambda now: steps.append(now.steps))
    run.observe(lambda now: times.append(round(now.time, 6)), every=0.5)
    run.run(until=2)
    assert steps == list(range(1, run.steps + 1))
    assert times == [0.5, 1.0, 1.5, 2.0]


def test_periods_need_no_step_of_their_own(run):
    times = []
    run.observe(lambda now: times.append(round(now.time, 6)), every=1)
    assert run.step(250) == 250
    assert times == [1.0, 2.0]


def test_an_observer_may_edit_and_its_exceptions_come_out_as_they_are(run):
    class Enough(Exception):
        pass

    def look(now):
        now["robot[r1]/@max_speed"] = 0.2
        if now.steps == 3:
            raise Enough("three")

    run.observe(look)
    with pytest.raises(Enough, match="three"):
        run.run()
    assert run.steps == 3
    assert run["robot[r1]/@max_speed"] == 0.2


def test_an_observer_cannot_step_its_simulation(run):
    run.observe(lambda now: now.step())
    with pytest.raises(elsie.Error, match="observer"):
        run.step()


def test_recordings_are_complete_when_the_run_has_ended(world, tmp_path):
    run = elsie.Simulation(world)
    run.record(tmp_path / "run.csv", rate=2)
    run.record(tmp_path / "run.mcap")
    run.run()
    rows = list(csv.DictReader((tmp_path / "run.csv").open()))
    assert len(rows) == 2 * 11
    assert float(rows[-1]["time_s"]) == pytest.approx(5)
    explained = subprocess.run([elsie.program(), "explain", str(tmp_path / "run.mcap")], capture_output=True, text=True, check=False)
    assert explained.returncode == 0 and "cut off" not in explained.stdout


def test_a_closed_run_has_a_complete_recording(world, tmp_path):
    with elsie.Simulation(world) as run:
        run.record(tmp_path / "run.csv")
        run.step(100)
    assert (tmp_path / "run.csv").read_text().count("\n") > 10
    run.close()
    with pytest.raises(elsie.Error, match="closed"):
        run.step()


def test_a_recording_begins_with_its_run(run, tmp_path):
    run.step()
    with pytest.raises(elsie.InputError, match="begun"):
        run.record(tmp_path / "late.csv")
    run.reset()
    with pytest.raises(elsie.InputError, match="suffix|csv"):
        run.record(tmp_path / "late.txt")


def test_the_trace_says_who_decided(run):
    result = run.run()
    episodes = result.trace("r1")
    assert list(episodes.dtype.names) == ["from_s", "to_s", "decider", "share", "weight", "reason"]
    assert episodes["from_s"][0] == 0 and episodes["to_s"][-1] == pytest.approx(5)
    assert (episodes["from_s"][1:] == episodes["to_s"][:-1]).all()
    assert set(episodes["decider"]) <= {"wander", "avoid_obstacle", "", "*"}
    sums = result.behaviors("r1")
    assert list(sums["path"]) == ["wander", "avoid_obstacle"]
    assert sums["decided_s"].sum() <= 5 + 1e-9
    with pytest.raises(elsie.InputError, match="r1"):
        result.trace("r9")


def test_equal_runs_have_equal_results_which_may_be_pickled(world):
    one, two = elsie.Simulation(world, 5).run(), elsie.Simulation(world, 5).run()
    assert one == two != elsie.Simulation(world, 6).run()
    assert pickle.loads(pickle.dumps(one)) == one
    assert repr(one) == f"<elsie.Result: {one}>"


def test_without_watch_there_is_no_trace(world):
    result = elsie.Simulation(world, watch=False).run()
    with pytest.raises(elsie.InputError, match="watch=True"):
        result.trace()


def test_pictures_of_a_run(run, tmp_path):
    run.step(200)
    assert "<svg" in run._repr_svg_()[:200]
    run.picture(tmp_path / "run.svg")
    pixels = run.render(320, 240)
    assert pixels.shape == (240, 320, 3) and pixels.dtype == "uint8"
    assert pixels.min() < pixels.max()
    with pytest.raises(ValueError):
        run.render(3, 3)


def test_steps_leave_other_threads_alone_and_refuse_a_second_one(world):
    long = world.copy()
    long["limits/@time"] = 1e6
    run = elsie.Simulation(long, watch=False)
    refused = []

    def meddle():
        while not refused and worker.is_alive():
            try:
                run.poses
                run.step()
            except elsie.Error as error:
                refused.append(error)

    worker = threading.Thread(target=run.step, args=(300_000,))
    worker.start()
    meddle()
    worker.join()
    assert refused and "middle of a step" in str(refused[0])


def test_an_interrupt_ends_a_long_call_and_the_run_goes_on(world):
    long = world.copy()
    long["limits/@time"] = 1e6
    run = elsie.Simulation(long, watch=False)
    timer = threading.Timer(0.2, _thread.interrupt_main)
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        run.run()
    steps = run.steps
    assert run.step(5) == 5 and run.steps == steps + 5


def test_a_simulation_with_an_observer_that_knows_it_is_freed(world):
    run = elsie.Simulation(world)
    run.observe(lambda now: run.steps)
    run.step(3)
    gone = weakref.ref(run)
    del run
    gc.collect()
    assert gone() is None
