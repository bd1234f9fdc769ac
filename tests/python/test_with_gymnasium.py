"""What happens where Gymnasium and PettingZoo are installed, by packages that have the names which ours use."""
import os
import subprocess
import sys

import elsie

GYMNASIUM = '''
registry = {}


class Env:
    metadata, spec, render_mode, _np_random, _np_random_seed = {"render_modes": []}, None, None, None, None

    def close(self):
        raise RuntimeError("not that of the environment")

    @property
    def np_random(self):
        raise RuntimeError("not that of the environment")


def register(id, **arguments):
    registry[id] = arguments
'''
SPACES = '''
import numpy as np


class Space:
    pass


class Box(Space):
    def __init__(self, low, high, shape=None, dtype=np.float32, seed=None):
        self.shape = np.shape(low) if shape is None else shape
        self.low, self.high, self.dtype = np.full(self.shape, low, dtype), np.full(self.shape, high, dtype), np.dtype(dtype)


class Discrete(Space):
    def __init__(self, n):
        self.n = n


class MultiDiscrete(Space):
    def __init__(self, nvec):
        self.nvec = np.array(nvec)
'''
VECTOR = '''
import enum


class AutoresetMode(enum.Enum):
    NEXT_STEP, SAME_STEP, DISABLED = "NextStep", "SameStep", "Disabled"


class VectorEnv:
    closed = False
    _np_random = None

    def __del__(self):
        if not self.closed:
            self.close()
'''
PETTINGZOO = "class ParallelEnv:\n    pass\n"
SCRIPT = '''
import gymnasium, pettingzoo, elsie
env = elsie.make("elsie/OpenArena-v0")
assert isinstance(env, gymnasium.Env) and type(env.action_space) is gymnasium.spaces.Box
env.reset(seed=1), env.step([0, 0]), env.close(), env.close()
envs = elsie.make_vec("elsie/OpenArena-v0", 2, autoreset_mode=gymnasium.vector.AutoresetMode.SAME_STEP)
assert isinstance(envs, gymnasium.vector.VectorEnv) and envs.metadata["autoreset_mode"] is gymnasium.vector.AutoresetMode.SAME_STEP
envs.reset(seed=1), envs.step([[0, 0]] * 2), envs.close()
assert isinstance(elsie.ParallelEnv("worlds/ten_robots.xml"), pettingzoo.ParallelEnv)
told = gymnasium.registry["elsie/Clutter-v0"]
for point, count in (("entry_point", {}), ("vector_entry_point", {"num_envs": 2})):
    module, name = told[point].split(":")
    made = getattr(__import__(module, fromlist=[name]), name)(**count, **told["kwargs"])
    made.reset(seed=3)
'''


def test_environments_derive_from_theirs_and_are_registered(tmp_path):
    for folder, modules in {"gymnasium": {"__init__": GYMNASIUM + "from . import spaces, vector\n", "spaces": SPACES, "vector": VECTOR},
                            "pettingzoo": {"__init__": PETTINGZOO}}.items():
        (tmp_path / folder).mkdir()
        for module, text in modules.items():
            (tmp_path / folder / f"{module}.py").write_text(text)
    package = os.path.dirname(os.path.dirname(os.path.abspath(elsie.__file__)))
    done = subprocess.run([sys.executable, "-c", SCRIPT], env={**os.environ, "PYTHONPATH": f"{tmp_path}:{package}"},
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
