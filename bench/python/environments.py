#!/usr/bin/env python3
"""Environments for learning, against the same worlds in C++ and against Enki's Python (python3-enki2); a behaviour in Python; arrays.

  environments.py BUILD_FOLDER [--repeats N] [--threads N]

Prints tables in Markdown. Everything is measured in turn, in wall-clock time, because that is what threads save.
"""
import os
import re
import subprocess
import sys
import time
from pathlib import Path
from statistics import median

BUILD = Path(sys.argv[1]).resolve()
ARITHMETIC = "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4"  # that of `elsie run`
if os.environ.get("GLIBC_TUNABLES") != ARITHMETIC:  # begin again with it, and with the interpreter for which the module was built
    found = re.search(r"^_?Python3_EXECUTABLE:.*=(.+)$", (BUILD / "CMakeCache.txt").read_text(), re.MULTILINE)
    interpreter = found[1] if found else sys.executable
    os.execve(interpreter, [interpreter, *sys.argv], {**os.environ, "GLIBC_TUNABLES": ARITHMETIC})
sys.path.insert(0, str(BUILD / "lib/python3/dist-packages"))

import numpy as np  # noqa: E402

import elsie  # noqa: E402

ORBIT = Path(__file__).resolve().parents[2] / "examples/12-python-plugins/orbit.py"
BEAMS = "range.distance_m"
WORLDS, ROBOTS = 64, 10
SECONDS = 1.0


def option(name, default):
    return int(sys.argv[sys.argv.index(name) + 1]) if name in sys.argv else default


REPEATS, THREADS = option("--repeats", 5), option("--threads", os.cpu_count() or 1)


def native(*arguments):
    done = subprocess.run([BUILD / "bin/bench_learning_worlds", *map(str, arguments)], capture_output=True, text=True, check=True)
    return done.stdout


def world(robots):
    return elsie.World.parse(native("--write", robots))


def rate(step, made):
    """How many of what a step makes in a second."""
    count, start = 0, time.perf_counter()
    while (taken := time.perf_counter() - start) < SECONDS:
        for _ in range(10):
            step()
        count += 10
    return made * count / taken


def actions_of(env, count=97):
    drawn = np.random.default_rng(1).uniform(-1, 1, (count, *env.action_space.shape)).astype(np.float32)
    while True:
        yield from drawn


def stepping(env):
    env.reset(seed=1)
    actions = actions_of(env)
    return lambda: env.step(next(actions))


def enki(worlds, robots):
    """As many e-pucks, each with its eight infra-red sensors, in arenas of the same size; None without python3-enki2."""
    try:
        import pyenki
    except ImportError:
        return None
    random = np.random.default_rng(1)
    arenas, pucks = [], []
    for _ in range(worlds):
        arena = pyenki.World(1000, 1000)
        for _ in range(robots):
            puck = pyenki.EPuck()
            puck.pos = tuple(random.uniform(100, 900, 2))
            arena.addObject(puck)
            pucks.append(puck)
        arenas.append(arena)

    def step(steps):
        speeds = random.uniform(-12, 12, (len(pucks), 2))
        for puck, (left, right) in zip(pucks, speeds):
            puck.leftSpeed, puck.rightSpeed = left, right
        for arena in arenas:
            for _ in range(steps):
                arena.step(0.01, 1)
        return [puck.proximitySensorValues for puck in pucks]
    return step


def deciding(behavior):
    """Steps of a robot with eight beams and this behaviour: a decision in each."""
    beams = "".join(f'<beam_range id="b{i}" yaw_deg="{45 * i}"/>' for i in range(8))
    text = f"""<world format="1"><arena length="4" width="4"/><physics engine="planar"/>
      <robots><robot id="r1" battery="1000000000"><sensors>{beams}</sensors><behaviors>{behavior}</behaviors>
        <coordinator><arbiter_suppression/></coordinator></robot></robots><limits time="1000000"/></world>"""
    run = elsie.Simulation(elsie.World.parse(text, plugins=[ORBIT]), watch=False)
    return lambda: run.step(100)


def crowd(robots):
    """Robots that stand in a square."""
    side = int(np.ceil(np.sqrt(robots)))
    placed = "".join(f'<robot id="r{i}" x="{0.5 * (i % side - side / 2)}" y="{0.5 * (i // side - side / 2)}"/>' for i in range(robots))
    return elsie.World.parse(f'<world format="1"><arena length="{side + 2}" width="{side + 2}"/><physics engine="planar"/>'
                             f'<robots>{placed}</robots></world>')


def table(head, rows):
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def spread(values):
    return f"{median(values):.0f} ({min(values):.0f} to {max(values):.0f})"


def main():
    alone = {steps: stepping(elsie.Env(world(1), observe=BEAMS, steps=steps)) for steps in (10, 1)}
    peer = enki(1, 1)
    rows = []
    for steps, step in alone.items():
        ours, theirs = [], []
        for _ in range(REPEATS):
            ours.append(rate(step, 1))
            if peer:
                theirs.append(rate(lambda: peer(steps), 1))
        rows.append([str(steps), spread(ours), spread(theirs) if theirs else "-",
                     f"{median(ours) / median(theirs):.1f}" if theirs else "-"])
    table(["steps of the physics in each", "`elsie.Env`, steps/s", "Enki's Python, steps/s", "times Enki"], rows)

    rows = []
    peer = enki(WORLDS, ROBOTS)
    for steps in (10, 1):
        step = stepping(elsie.VectorEnv(world(ROBOTS), WORLDS, threads=THREADS, robots="all", observe=BEAMS, steps=steps))
        ours, bare, theirs, parts = [], [], [], []
        for _ in range(REPEATS):
            ours.append(rate(step, WORLDS * ROBOTS))
            bare.append(float(native(WORLDS, ROBOTS, steps, THREADS, "--seconds", SECONDS)) / steps)
            parts.append(100 * ours[-1] / bare[-1])
            if peer:
                theirs.append(rate(lambda: peer(steps), WORLDS * ROBOTS))
        rows.append([str(steps), spread(ours), spread(bare), f"{median(parts):.0f} % ({min(parts):.0f} to {max(parts):.0f})",
                     spread(theirs) if theirs else "-", f"{median(ours) / median(theirs):.1f}" if theirs else "-"])
    table(["steps of the physics in each", "`elsie.VectorEnv`, agent-steps/s", "the same worlds in C++", "part of it",
           "Enki's Python, agent-steps/s", "times Enki"], rows)

    python, native_one = deciding("<orbit/>"), deciding("<avoid_obstacle/>")
    ours, bare = [], []
    for _ in range(REPEATS):
        ours.append(rate(python, 100))
        bare.append(rate(native_one, 100))
    each_us = 1e6 / median(ours) - 1e6 / median(bare)
    table(["decisions/s of a behaviour in Python, with their steps", "of one in C++", "what Python adds to one, us"],
          [[spread(ours), spread(bare), f"{each_us:.1f}"]])

    rows = []
    for robots in (10, 10_000):
        run = elsie.Simulation(crowd(robots), watch=False)
        run.step()
        assert np.shares_memory(run.poses, run.poses)  # no copy
        rows.append([str(robots), f"{1e6 / median(rate(lambda: run.poses, 1) for _ in range(REPEATS)):.2f}"])
    table(["robots", "`run.poses`, us"], rows)


if __name__ == "__main__":
    main()
