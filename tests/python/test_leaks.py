"""Ten thousand simulations leave nothing behind."""
import gc
import resource

import elsie
from worlds import ARENA


def memory_kb():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize() // 1024


def test_ten_thousand_simulations_are_freed():
    world = elsie.World.parse(ARENA)

    def make(count):
        for seed in range(count):
            run = elsie.Simulation(world, seed, time_limit=1)
            run.observe(lambda now: run.steps)
            run.step(2)
            run.poses, run.readings("range"), run.result()
        gc.collect()

    make(1000)  # caches fill
    before = memory_kb()
    make(10_000)
    assert memory_kb() - before < 4000


def test_views_keep_only_their_own_memory():
    world = elsie.World.parse(ARENA)
    views = []
    for seed in range(500):
        views.append(elsie.Simulation(world, seed).poses)
    gc.collect()
    before = memory_kb()
    for seed in range(500):
        views.append(elsie.Simulation(world, seed).poses)
    gc.collect()
    assert memory_kb() - before < 2000
    assert len({view.ctypes.data for view in views}) == len(views)
