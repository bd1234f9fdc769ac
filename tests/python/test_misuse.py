"""Whatever is called with whatever: an exception, never a crash."""
import copy
import os
import pickle
import signal
import threading

import numpy as np
import pytest

import elsie
from elsie import _elsie
from worlds import ARENA

NONSENSE = [None, -1, 0, 3, 2**70, 1.5, float("nan"), float("inf"), "", "r1", "nowhere", b"x", [], {}, object(), np.zeros(3), lambda: 0]


def attempts(seed, count):
    """Random arguments, the same each time."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        yield [NONSENSE[i] for i in random.integers(0, len(NONSENSE), random.integers(0, 4))]


METHODS = ["step", "observe", "reset", "record", "readings", "published", "image", "picture", "render", "edit", "add", "_value",
           "_edit_all", "_of_robots", "_readings_of", "_published_as", "_events_from", "_record_to", "_reset_to", "__getitem__",
           "__setitem__", "__delitem__", "_repr_svg_", "result", "_account", "_all_notes"]


@pytest.mark.parametrize("method", METHODS)
def test_random_arguments_of_a_simulation(method, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = elsie.Simulation(elsie.World.parse(ARENA), time_limit=0.5)
    for arguments in attempts(METHODS.index(method), 60):
        try:
            getattr(run, method)(*arguments)
        except Exception:  # noqa: BLE001: any exception is right
            pass
        run._observers.clear()
    run.reset(1)
    run.run()


@pytest.mark.parametrize("method", ["add", "edit", "_edit_all", "save", "picture", "_value", "copy", "check", "__getitem__",
                                    "__setitem__", "__delitem__"])
def test_random_arguments_of_a_world(method, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    world = elsie.World.parse(ARENA)
    for arguments in attempts(len(method), 60):
        try:
            getattr(world, method)(*arguments)
        except Exception:  # noqa: BLE001
            pass
    elsie.Simulation(world, time_limit=0.1).run()


@pytest.mark.parametrize("make", [elsie.World, elsie.World.parse, elsie.Simulation, elsie.Fuzzy, elsie.Fuzzy.parse, elsie.Network,
                                  elsie.Network.load, elsie.Results])
def test_random_arguments_of_constructors(make, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for arguments in attempts(1, 40):
        with pytest.raises(Exception):
            make(*arguments)
            raise ValueError("it was right by chance")


@pytest.mark.parametrize("kind", [elsie.World, elsie.Simulation, elsie.Fuzzy, elsie.Network, elsie.Now, elsie.SensorNow, elsie.ActuatorNow,
                                  elsie.WorldNow, elsie.WorldChanges, elsie.Member, elsie.Random, elsie.Sketch])
def test_an_object_that_was_never_made_is_refused(kind):
    empty = kind.__new__(kind)
    for name in dir(_elsie.__dict__[kind.__name__]):
        if name.startswith("__"):
            continue
        with pytest.raises(Exception):
            getattr(empty, name)()


def test_readings_that_were_never_made_have_no_attributes():
    with pytest.raises(AttributeError):
        elsie.Readings.__new__(elsie.Readings).distance_m


def test_a_simulation_is_not_copied_but_a_world_is():
    world = elsie.World.parse(ARENA)
    run = elsie.Simulation(world)
    for copying in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match="another one"):
            copying(run)
    assert str(copy.deepcopy(world)) == str(copy.copy(world)) == str(pickle.loads(pickle.dumps(world))) == ARENA


def test_a_simulation_needs_a_world():
    with pytest.raises(TypeError):
        elsie.Simulation()
    for threads in (0, 10**6):
        with pytest.raises(elsie.InputError, match="threads"):
            elsie.Simulation(elsie.World.parse(ARENA), threads=threads)
    for seed in (-1, "7", None, 1.5):
        with pytest.raises(elsie.InputError, match="seed: expected a whole number"):
            elsie.Simulation(elsie.World.parse(ARENA), seed=seed)
    with pytest.raises(elsie.InputError, match="time_limit"):
        elsie.Simulation(elsie.World.parse(ARENA), time_limit=0)


def test_an_exception_in_every_callback():
    run = elsie.Simulation(elsie.World.parse(ARENA))

    def fail(now):
        raise KeyError(now.steps)

    for _ in range(3):
        run.observe(fail)
    for steps in range(1, 20):
        with pytest.raises(KeyError, match=str(steps)):
            run.run()


def test_many_threads_on_one_simulation():
    run = elsie.Simulation(elsie.World.parse(ARENA), time_limit=100)
    wrong = []

    def work():
        for _ in range(200):
            try:
                run.step(20)
                run.poses.sum()
                run["robot[r1]/@max_speed"] = 0.2
                run.render(200, 200)
            except elsie.Error:
                pass
            except BaseException as error:  # noqa: BLE001
                wrong.append(error)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


@pytest.mark.parametrize("call, sentence", [
    (lambda: elsie.Simulation(elsie.World.parse(ARENA), threads=1.5), "threads: .* not 1.5"),
    (lambda: elsie.Simulation(elsie.World.parse(ARENA), time_limit="5"), "time_limit: .* not '5'"),
    (lambda: elsie.Simulation(elsie.World.parse(ARENA)).step(2.5), "steps: .* not 2.5"),
    (lambda: elsie.Simulation(elsie.World.parse(ARENA)).step("2"), "steps: .* not '2'"),
    (lambda: elsie.Simulation(elsie.World.parse(ARENA)).run(until="2"), "until: .* not '2'"),
    (lambda: elsie.Simulation(elsie.World.parse(ARENA)).observe(print, every="1"), "every: .* not '1'"),
    (lambda: elsie.run(elsie.World.parse(ARENA), 5), "seeds: .* not 5"),
    (lambda: elsie.run(elsie.World.parse(ARENA), workers="2"), "workers: .* not '2'"),
    (lambda: elsie.run(elsie.World.parse(ARENA), workers=True), "workers: .* not True"),
    (lambda: elsie.Env(elsie.World.parse(ARENA), robot=0), "robots=0: expected ids of robots, such as 'r1'"),
    (lambda: elsie.Env(elsie.World.parse(ARENA), robot="r1", duration=True), "duration=True"),
    (lambda: elsie.Env(elsie.World.parse(ARENA), robot="r1", observe=("pose.x", 0, 1e39)), "'pose.x' are 0.0 and inf"),
    (lambda: elsie.Env(elsie.World.parse(ARENA), robot="r1", observe=("pose.x", 0, 1e-60)), "'pose.x' are 0.0 and 0.0"),
    (lambda: elsie.Env(elsie.World.parse(ARENA), robot="r1").reset(options={"seed": 3}), "options: there is no 'seed'"),
    (lambda: elsie.ParallelEnv(elsie.World.parse(ARENA)).reset(options={"seed": 3}), "options: there is no 'seed'")])
def test_what_has_another_type_or_is_unknown_gets_a_sentence(call, sentence):
    with pytest.raises(elsie.InputError, match=sentence):
        call()


def test_an_environment_is_not_copied():
    env = elsie.Env(elsie.World.parse(ARENA), robot="r1")
    for copying in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match="make another one"):
            copying(env)


def test_actions_beyond_a_float_are_clipped_whatever_numpy_does_about_errors():
    def step(action):
        env = elsie.Env(elsie.World.parse(ARENA), robot="r1", steps=50)
        env.reset(seed=1)
        env.step(action)
        return env.state_hash
    with np.errstate(all="raise"):
        assert step(np.array([1e300, 1e-300])) == step([1, 0])
        env = elsie.ParallelEnv(elsie.World.parse(ARENA), robots=["r1"])
        env.reset(seed=1)
        env.step({"r1": np.array([1e300, 1e-300])})


@pytest.mark.parametrize("make, step", [
    (lambda: elsie.VectorEnv(elsie.World.parse(ARENA), 4, robot="r1", threads=2), lambda envs: envs.reset(seed=1)),
    (lambda: elsie.Simulation(elsie.World.parse(ARENA), threads=2), lambda run: run.step(1))])
def test_threads_do_not_come_along_with_a_copy_of_the_process(make, step):
    made = make()
    step(made)
    reads, writes = os.pipe()
    child = os.fork()
    if child == 0:
        signal.alarm(20)  # it might wait for them
        try:
            step(made)
        except elsie.InputError as error:
            os.write(writes, str(error).encode())
        finally:
            os._exit(0)
    os.close(writes)
    with os.fdopen(reads) as said:
        assert "another process" in said.read()
    os.waitpid(child, 0)
