"""Whatever is called with whatever: an exception, never a crash."""
import copy
import pickle
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
