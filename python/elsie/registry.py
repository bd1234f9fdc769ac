"""Environments with names, for shipped worlds: `elsie.make("elsie/Clutter-v0")`, and gymnasium.make() if Gymnasium is installed."""
from __future__ import annotations

import difflib
from typing import Any, Union

from elsie.environments import Env
from elsie.errors import InputError
from elsie.vector import VectorEnv

REGISTERED: dict[str, dict[str, Any]] = {
    "elsie/OpenArena-v0": {"world": "worlds/open_arena.xml", "observe": ["range.distance_m", "motion"], "act": "motion", "steps": 10,
                           "reward": {"path_length_m": 1.0}},
    "elsie/Clutter-v0": {"world": "worlds/clutter.xml", "observe": ["range.distance_m", "motion"], "act": "motion", "steps": 10,
                         "reward": {"path_length_m": 1.0, "collisions": -5.0}},
    "elsie/ClutterPriorities-v0": {"world": "worlds/clutter.xml", "observe": ["range.distance_m", "motion"], "act": "priorities",
                                   "steps": 10, "reward": {"path_length_m": 1.0, "collisions": -5.0}},
    "elsie/Maze-v0": {"world": "worlds/maze.xml", "observe": ["range.distance_m", "motion", "pose"], "act": "motion", "steps": 10,
                      "reward": {"success": 100.0, "time_s": -0.01}},
    "elsie/FourResources-v0": {"world": "worlds/four_resources.xml",
                               "observe": ["range.distance_m", "vision.found", ("vision.column", 0.0, 100.0), "motion"],
                               "act": "motion", "steps": 10, "reward": {"collected": 10.0, "time_s": -0.01}},
    "elsie/TenRobots-v0": {"world": "worlds/ten_robots.xml", "robots": "all", "observe": ["range.distance_m", "motion"],
                           "act": "motion", "steps": 10, "reward": {"path_length_m": 1.0, "collisions": -5.0}},
}
"""The arguments of each: of `Env`, `VectorEnv` and, with "robots", of `ParallelEnv`."""


def make(id: str, **changes: Any) -> Env:
    """A registered environment; `changes` replace its arguments."""
    return Env(**{**_arguments(id), **changes})


def make_vec(id: str, num_envs: int = 1, **changes: Any) -> VectorEnv:
    """The same with `num_envs` worlds."""
    return VectorEnv(num_envs=num_envs, **{**_arguments(id), **changes})


def _arguments(id: str) -> dict[str, Any]:
    if id not in REGISTERED:
        near: Union[list[str], Any] = difflib.get_close_matches(str(id), REGISTERED, 1) or sorted(REGISTERED)
        raise InputError(f"There is no environment '{id}'; there are, for example: {', '.join(near)}")
    return dict(REGISTERED[id])


def _register() -> None:
    try:
        import gymnasium
    except ImportError:
        return
    for id, arguments in REGISTERED.items():
        if id not in gymnasium.registry:
            gymnasium.register(id, entry_point="elsie.environments:Env", vector_entry_point="elsie.vector:VectorEnv",
                               kwargs=arguments, order_enforce=True)


_register()
