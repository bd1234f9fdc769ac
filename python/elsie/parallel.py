"""`ParallelEnv`: an agent for each robot.

    env = elsie.ParallelEnv("worlds/ten_robots.xml", observe=["range.distance_m"], act="motion", steps=10)
    observations, infos = env.reset(seed=1)
    while env.agents:
        actions = {agent: env.action_space(agent).sample() for agent in env.agents}
        observations, rewards, terminations, truncations, infos = env.step(actions)
"""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from elsie.environments import Base, Floats, Names, Reward, Setup, WorldLike, checked_reward, checked_seed, refuse_options, save
from elsie.errors import InputError
from elsie.spaces import Box

if TYPE_CHECKING:
    _ParallelEnv = object
else:
    try:
        from pettingzoo import ParallelEnv as _ParallelEnv
    except ImportError:
        _ParallelEnv = object


class ParallelEnv(Base, _ParallelEnv):
    """One world whose robots are agents: PettingZoo's if it is installed, with the same interface if not.

    The arguments are those of `Env`; a reward function gets what one agent observed, did and observes then. An agent whose battery is
    empty has come to its end and leaves `agents`; all leave when the run ends.
    """

    def __init__(self, world: WorldLike, *, robots: Union[None, str, Sequence[str]] = None,
                 observe: Names = None, act: Names = None, reward: Reward = None, steps: Optional[int] = None,
                 duration: Optional[float] = None, render_mode: Optional[str] = None) -> None:
        setup = Setup(world, 1, 1, robots, False, observe, act, reward, steps, duration)
        self._begin(setup, render_mode)
        self.metadata["is_parallelizable"] = True
        self.possible_agents = list(setup.robots)
        self.agents: list[str] = []
        self.observation_spaces = dict(zip(setup.robots, setup.observation_spaces))
        self.action_spaces = dict(zip(setup.robots, setup.action_spaces))
        self.state_space = Box(np.concatenate([space.low for space in setup.observation_spaces]),
                               np.concatenate([space.high for space in setup.observation_spaces]), dtype=np.float32)
        sizes = [len(names) for names in setup.observation_names]
        ends = np.cumsum(sizes)
        self._places = {robot: slice(int(end) - size, int(end)) for robot, size, end in zip(setup.robots, sizes, ends)}
        counts = [len(names) for names in setup.action_names]
        first = np.cumsum([0, *counts])
        self._actions = np.zeros((1, int(first[-1])))
        self._hands = {robot: slice(int(first[i]), int(first[i + 1])) for i, robot in enumerate(setup.robots)}
        setup.worlds.set_shapes(self._actions.shape, self.state_space.shape)
        self._row: Floats = setup.worlds.observations[0]
        self._before: dict[str, Any] = {}

    def observation_space(self, agent: str) -> Any:
        """The same object at each call."""
        return self.observation_spaces[self._known(agent)]

    def action_space(self, agent: str) -> Any:
        """The same object at each call."""
        return self.action_spaces[self._known(agent)]

    def _known(self, agent: str) -> str:
        if agent not in self.observation_spaces:
            raise InputError(f"There is no agent {agent!r}; there are {', '.join(self.possible_agents)}")
        return agent

    def _observed(self) -> dict[str, Floats]:
        return {agent: self._row[self._places[agent]].copy() for agent in self.agents}

    def reset(self, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None) -> tuple[dict[str, Floats], dict[str, Any]]:
        """Begins an episode with all agents: with this seed, or with the next one that follows from it. The first seed is 1."""
        refuse_options(options)
        worlds = self._open.worlds
        if seed is not None:
            seed = checked_seed(seed)
            self._seed(seed)
        worlds.begin([0], [] if seed is None else [seed])
        self.agents = list(self.possible_agents)
        self._before = self._observed()
        return dict(self._before), {agent: {} for agent in self.agents}

    def step(self, actions: Mapping[str, Any]) -> tuple[dict[str, Floats], dict[str, float], dict[str, bool], dict[str, bool],
                                                        dict[str, dict[str, Any]]]:
        """Makes a step with the actions of all `agents`."""
        setup = self._open
        if not self.agents:
            raise InputError("There are no agents: call reset(), which begins an episode")
        if not isinstance(actions, Mapping):
            raise InputError(f"The actions are {actions!r}; expected a dictionary with an action for each agent")
        if set(actions) != set(self.agents):
            raise InputError(f"There are actions of {', '.join(sorted(actions)) or 'nobody'}; expected those of {', '.join(self.agents)}")
        self._actions[:] = 0.0
        for agent, action in actions.items():
            numbers = np.asarray(setup.numbers_of(action, self.action_spaces[agent]))
            place = self._hands[agent]
            if numbers.shape != (place.stop - place.start,):
                raise InputError(f"The action of {agent} has the shape {numbers.shape}; expected ({place.stop - place.start},)")
            try:
                self._actions[0, place] = numbers
            except (TypeError, ValueError):
                raise InputError(f"The action of {agent} is no array of numbers") from None
        worlds = setup.worlds
        worlds.step(self._actions, 2)
        terminated, truncated = bool(worlds.terminated[0]), bool(worlds.truncated[0])
        ended = dict(zip(self.possible_agents, worlds.ended[0].tolist()))
        earned = dict(zip(self.possible_agents, worlds.rewards[0].tolist()))
        observations = self._observed()
        rewards = {agent: checked_reward(setup.reward(self._before[agent], actions[agent], observations[agent])) if setup.reward
                   else earned[agent] for agent in self.agents}
        self._before = dict(observations)
        terminations = {agent: terminated or ended[agent] for agent in self.agents}
        truncations = {agent: truncated and not ended[agent] for agent in self.agents}
        infos: dict[str, dict[str, Any]] = {agent: {} for agent in self.agents}
        if terminated or truncated:
            for info in infos.values():
                info["outcome"] = worlds.outcome(0)
        self.agents = [agent for agent in self.agents if not (terminations[agent] or truncations[agent])]
        return observations, rewards, terminations, truncations, infos

    def close(self) -> None:
        """Gives the world up. May be called twice."""
        super().close()
        self._row = np.zeros(0, np.float32)

    def state(self) -> Floats:
        """What all robots observe, one after the other."""
        self._open
        return self._row.copy()

    def render(self) -> Optional[NDArray[np.uint8]]:
        """The world from above: (height, width, 3)."""
        return self._picture(0)

    @property
    def unwrapped(self) -> "ParallelEnv":
        """The environment itself: it wraps none."""
        return self

    @property
    def num_agents(self) -> int:
        """How many agents have not come to their end."""
        return len(self.agents)

    @property
    def max_num_agents(self) -> int:
        """How many there are at the start."""
        return len(self.possible_agents)

    @property
    def time_s(self) -> float:
        """Simulated, of this episode."""
        return self._open.worlds.time_s(0)

    @property
    def state_hash(self) -> str:
        """Of the world's state, as results have it."""
        return self._open.worlds.state_hash(0)

    def save(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Keeps the episode so far; see Env.save()."""
        save(self._open, 0, file)
