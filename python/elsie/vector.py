"""`VectorEnv`: many worlds at once, stepped in threads of C++ without Python's lock.

    envs = elsie.VectorEnv("worlds/clutter.xml", 64, threads=2, observe=["range.distance_m"], act="motion", steps=10)
    observations, infos = envs.reset(seed=1)
    observations, rewards, terminations, truncations, infos = envs.step(envs.action_space.sample())

The same bits for any number of worlds and threads: world i with the seed s is `Env` with the seed s + i.
"""
from __future__ import annotations

import enum
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from elsie.environments import Base, Floats, Names, Reward, Setup, WorldLike, checked_seed, refuse_options, save
from elsie.errors import InputError
from elsie.simulations import MOST_THREADS
from elsie.spaces import Box, Discrete, MultiDiscrete


class _AutoresetMode(enum.Enum):
    """When a world whose episode has ended begins the next one."""

    NEXT_STEP = "NextStep"
    """In the next step: its action is ignored, and its reward is 0."""
    SAME_STEP = "SameStep"
    """In the same step: infos["final_obs"] has the last observation."""
    DISABLED = "Disabled"
    """When reset() is told so, by options["reset_mask"]."""


if TYPE_CHECKING:
    AutoresetMode = _AutoresetMode
    _GymVectorEnv = object
else:
    try:
        from gymnasium.vector import AutoresetMode
        from gymnasium.vector import VectorEnv as _GymVectorEnv
    except ImportError:
        AutoresetMode, _GymVectorEnv = _AutoresetMode, object
        AutoresetMode.__name__ = AutoresetMode.__qualname__ = "AutoresetMode"

_RENEWALS = {"NextStep": 0, "SameStep": 1, "Disabled": 2}


def _batched(space: Any, count: int) -> Any:
    if isinstance(space, Discrete):
        return MultiDiscrete([space.n] * count)
    if isinstance(space, MultiDiscrete):
        return MultiDiscrete(np.tile(space.nvec, (count, 1)))
    return Box(np.stack([space.low] * count), np.stack([space.high] * count), dtype=space.dtype)


class VectorEnv(Base, _GymVectorEnv):
    """`num_envs` worlds: a Gymnasium vector environment if Gymnasium is installed, with the same interface if not.

    The other arguments are those of `Env`. threads: None: one for each processor. copy: False: observations are views of memory that
    the next step changes.
    """

    spec: Any = None

    def __init__(self, world: WorldLike, num_envs: int, *, threads: Optional[int] = None, robot: Optional[str] = None,
                 robots: Union[None, str, Sequence[str]] = None, observe: Names = None, act: Names = None, reward: Reward = None,
                 steps: Optional[int] = None, duration: Optional[float] = None, autoreset_mode: Union[str, AutoresetMode] = AutoresetMode.NEXT_STEP,
                 copy: bool = True, render_mode: Optional[str] = None) -> None:
        if robot is not None and robots is not None:
            raise InputError("robot=... and robots=... exclude each other")
        try:
            self.autoreset_mode = AutoresetMode(autoreset_mode)
        except ValueError:
            raise InputError(f"autoreset_mode={autoreset_mode!r}: expected \"NextStep\", \"SameStep\" or \"Disabled\"") from None
        setup = Setup(world, num_envs, min(len(os.sched_getaffinity(0)), MOST_THREADS) if threads is None else threads,
                      robot if robots is None else robots, robots is None, observe, act, reward, steps, duration)
        self._begin(setup, render_mode)
        self.metadata["autoreset_mode"] = self.autoreset_mode
        self._renewal = _RENEWALS[str(self.autoreset_mode.value)]
        self.num_envs = num_envs
        self.copy = copy
        self.single_observation_space = setup.stacked("observation")
        self.single_action_space = setup.stacked("action")
        self.observation_space = _batched(self.single_observation_space, num_envs)
        self.action_space = _batched(self.single_action_space, num_envs)
        numbers = (len(setup.action_names[0]),)
        setup.worlds.set_shapes((num_envs, *numbers) if setup.is_one else (num_envs, len(setup.robots), *numbers),
                                self.observation_space.shape)
        # Views: they show what the last step did.
        shape = self.observation_space.shape
        self._observations: Floats = setup.worlds.observations.reshape(shape)
        self._last: Floats = setup.worlds.last_observations.reshape(shape)
        self._rewards = setup.worlds.rewards[:, 0] if len(setup.robots) == 1 else None
        self._terminated, self._truncated, self._begun = setup.worlds.terminated, setup.worlds.truncated, setup.worlds.begun
        self._before: Any = None

    @property
    def unwrapped(self) -> "VectorEnv":
        """The environment itself: it wraps none."""
        return self

    def reset(self, *, seed: Union[None, int, Sequence[Optional[int]]] = None,
              options: Optional[dict[str, Any]] = None) -> tuple[Floats, dict[str, Any]]:
        """Begins an episode in all worlds, or in those of options["reset_mask"]. An int seed gives world i the seed + i; None goes on."""
        worlds = self._open.worlds
        chosen = np.ones(self.num_envs, np.bool_)
        refuse_options(options, ["reset_mask"])
        if options and "reset_mask" in options:
            chosen = np.asarray(options["reset_mask"])
            if chosen.shape != (self.num_envs,) or chosen.dtype != np.bool_ or not chosen.any():
                raise InputError(f"options[\"reset_mask\"]: expected {self.num_envs} booleans, at least one of them true")
        seeds: list[Optional[int]]
        if seed is None:
            seeds = [None] * self.num_envs
        elif isinstance(seed, (int, np.integer)):
            seeds = [checked_seed(seed) + i for i in range(self.num_envs)]
            self._seed(int(seed))
        else:
            seeds = [None if each is None else checked_seed(each) for each in seed]
            if len(seeds) != self.num_envs:
                raise InputError(f"{len(seeds)} seeds were given; expected one for each of the {self.num_envs} worlds")
        given = {i: each for i, each in enumerate(seeds) if chosen[i] and each is not None}
        if given:
            worlds.begin(list(given), list(given.values()))
        others = [i for i in range(self.num_envs) if chosen[i] and i not in given]
        if others:
            worlds.begin(others, [])
        observations = self._observations.copy() if self.copy or self._open.reward else self._observations
        self._before = observations
        return observations, self._seeds_of(chosen)

    def step(self, actions: Any) -> tuple[Floats, NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], dict[str, Any]]:
        """Makes a step of each world."""
        setup = self._open
        setup.worlds.step(setup.numbers_of(actions, self.action_space), self._renewal)
        terminated, truncated = self._terminated.copy(), self._truncated.copy()
        ended = terminated | truncated
        observations = self._observations.copy() if self.copy or setup.reward else self._observations
        infos: dict[str, Any] = {}
        if self._begun.any():
            infos = self._seeds_of(self._begun.copy())
        is_same_step = self._renewal == 1
        if ended.any():
            infos.update(self._endings_of(ended))
        if setup.reward:
            following = observations
            if is_same_step and ended.any():
                following = observations.copy()
                following[ended] = self._last[ended]
            rewards = np.array(setup.reward(self._before, actions, following), np.float64)
            if rewards.shape != (self.num_envs,):
                raise InputError(f"The reward function returned the shape {rewards.shape}; expected ({self.num_envs},)")
            if not np.isfinite(rewards).all():
                raise InputError(f"The reward function returned {rewards}; expected finite numbers")
            if self._renewal == 0:
                rewards[self._begun] = 0.0
            self._before = observations
        elif self._rewards is not None:
            rewards = self._rewards.copy()
        else:
            rewards = setup.worlds.rewards.mean(axis=1)
        return observations, rewards, terminated, truncated, infos

    def _seeds_of(self, mask: NDArray[np.bool_]) -> dict[str, Any]:
        worlds = self._open.worlds
        return {"seed": np.array([worlds.seed(i) if mask[i] else 0 for i in range(self.num_envs)], np.int64), "_seed": mask}

    def _endings_of(self, ended: NDArray[np.bool_]) -> dict[str, Any]:
        worlds = self._open.worlds
        outcomes = np.full(self.num_envs, None, object)
        for i in np.flatnonzero(ended):
            outcomes[i] = worlds.outcome(i)
        info = {"outcome": outcomes, "_outcome": ended}
        if self._renewal != 1:
            return info
        final = np.full(self.num_envs, None, object)
        for i in np.flatnonzero(ended):
            final[i] = self._last[i].copy()
        return {"final_obs": final, "_final_obs": ended, "final_info": info, "_final_info": ended}

    @property
    def robot_rewards(self) -> NDArray[np.float64]:
        """The rewards of the last step, (worlds, robots)."""
        return self._open.worlds.rewards.copy()

    def render(self) -> Optional[tuple[NDArray[np.uint8], ...]]:
        """Each world from above: (height, width, 3)."""
        if self.render_mode is None:
            return None
        return tuple(self._open.worlds.picture(i, 240) for i in range(self.num_envs))

    def close(self, **kwargs: Any) -> None:
        """Gives the worlds up. May be called twice."""
        super().close()
        self._observations = self._last = np.zeros(0, np.float32)
        self._rewards = self._before = None
        self._terminated = self._truncated = self._begun = np.zeros(0, np.bool_)

    def time_s(self) -> NDArray[np.float64]:
        """Simulated, of the present episodes."""
        return np.array([self._open.worlds.time_s(i) for i in range(self.num_envs)])

    def seeds_now(self) -> list[int]:
        """The seeds of the present episodes."""
        return [self._open.worlds.seed(i) for i in range(self.num_envs)]

    def state_hashes(self) -> list[str]:
        """Of the worlds' states, as results have them."""
        return [self._open.worlds.state_hash(i) for i in range(self.num_envs)]

    def save(self, world: int, file: Union[str, "os.PathLike[str]"]) -> None:
        """Keeps the present episode of a world; see Env.save()."""
        save(self._open, world, file)
