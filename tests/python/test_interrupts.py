"""Ctrl-C, and other signals with a handler: soon, and what there was is in a state that the docs name."""
import _thread
import signal
import threading
import time

import numpy as np
import pytest

import elsie
from worlds import ARENA

LONG = 10**8  # steps of the physics: minutes
SOON = 10  # s: far less than the work takes, and more than any machine does
VERY_LONG = 1e9


def env_of(**more):
    return elsie.Env(elsie.World.parse(ARENA), robot="r1", steps=LONG, duration=VERY_LONG, **more)


def envs_of(count=4, threads=2, **more):
    return elsie.VectorEnv(elsie.World.parse(ARENA), count, threads=threads, robot="r1", duration=VERY_LONG, **more)


def interrupted_after(work, seconds=0.2):
    """How long it took from Ctrl-C to the exception, s."""
    pressed = []

    def press():
        pressed.append(time.monotonic())
        _thread.interrupt_main()
    timer = threading.Timer(seconds, press)
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        work()
    return time.monotonic() - pressed[0]


def test_an_interrupt_ends_a_long_step_of_an_environment_which_must_be_reset():
    env = env_of()
    env.reset(seed=1)
    assert interrupted_after(lambda: env.step([0, 0])) < SOON
    for _ in range(2):
        with pytest.raises(elsie.InputError, match=r"was interrupted: call reset\(\)"):
            env.step([0, 0])
        with pytest.raises(elsie.InputError, match="was interrupted"):
            env.save("nothing.xml")
    observation, info = env.reset(seed=1)
    fresh = env_of()
    assert np.array_equal(observation, fresh.reset(seed=1)[0]) and env.state_hash == fresh.state_hash


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("mode", ["NextStep", "SameStep", "Disabled"])
def test_an_interrupt_ends_a_long_step_of_many_environments(threads, mode):
    envs = envs_of(threads=threads, steps=LONG, autoreset_mode=mode)
    envs.reset(seed=1)
    assert interrupted_after(lambda: envs.step(np.zeros((4, 2)))) < SOON
    with pytest.raises(elsie.InputError, match=r"world 0: .*interrupted: call reset\(\)"):
        envs.step(np.zeros((4, 2)))
    envs.reset(seed=1)


def test_worlds_that_were_not_begun_again_stay_interrupted():
    envs = envs_of(steps=LONG, autoreset_mode="Disabled")
    envs.reset(seed=1)
    interrupted_after(lambda: envs.step(np.zeros((4, 2))))
    envs.reset(options={"reset_mask": np.array([True, True, False, True])})
    with pytest.raises(elsie.InputError, match="world 2: .*interrupted"):
        envs.step(np.zeros((4, 2)))


def test_an_interrupt_ends_a_long_step_of_agents():
    env = elsie.ParallelEnv(elsie.World.parse(ARENA), steps=LONG, duration=VERY_LONG)
    env.reset(seed=1)
    assert interrupted_after(lambda: env.step({agent: [0, 0] for agent in env.agents})) < SOON
    with pytest.raises(elsie.InputError, match="interrupted"):
        env.step({agent: [0, 0] for agent in env.agents})


def test_an_interrupt_ends_the_beginning_of_many_episodes():
    """Each episode begins with a control period, here one that lasts long."""
    text = ARENA.replace('<physics engine="planar"/>', '<physics engine="planar" control_steps="100"/>')
    envs = elsie.VectorEnv(elsie.World.parse(text), 5000, threads=2, robot="r1", duration=VERY_LONG)
    assert interrupted_after(lambda: envs.reset(seed=1), 0.02) < SOON
    with pytest.raises(elsie.InputError, match="interrupted|not begun"):
        envs.step(np.zeros((5000, 2)))


def test_the_handler_of_the_user_decides():
    env = env_of()
    env.reset(seed=1)
    seen = []

    def look(*_):
        seen.append(time.monotonic())
        if len(seen) == 3:
            raise TimeoutError("enough")
    before = signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, 0.1, 0.1)
    try:
        with pytest.raises(TimeoutError, match="enough"):
            env.step([0, 0])
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert seen[2] - seen[0] < SOON


def test_steps_in_turns_are_the_same_to_the_last_bit():
    """A step that is long enough for several turns, and as many short ones with the same action."""
    def hashes(steps, count):
        envs = envs_of(3, steps=steps)
        envs.reset(seed=5)
        for _ in range(count):
            envs.step(np.full((3, 2), 0.3))
        return envs.state_hashes()
    assert hashes(150_000, 1) == hashes(1000, 150)
