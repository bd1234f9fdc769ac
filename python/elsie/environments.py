"""Environments for learning: `Env` for one world, with what all environments share.

    env = elsie.Env("worlds/maze.xml", observe=["range.distance_m", "motion"], act="motion", steps=10)
    observation, info = env.reset(seed=7)
    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
    env.save("episode.xml")                  # `elsie run episode.xml --seed 7` makes the same run again
"""
from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from elsie import _elsie
from elsie.checks import is_number, whole
from elsie.errors import InputError
from elsie.simulations import MOST_THREADS, note_of_bits
from elsie.spaces import Box, Discrete, MultiDiscrete

Named = Union[str, tuple[str, float, float]]
"""A name, or a name with its least and its greatest value."""
Names = Union[None, Named, Sequence[Named]]
"""None: those that the world's <learning> declares."""
Reward = Union[None, str, Sequence[str], Mapping[str, float], Callable[[Any, Any, Any], Any]]
"""Measures and values of results, with weights; or a function of observation, action and following observation."""
WorldLike = Union[str, "os.PathLike[str]", _elsie.World]
Floats = NDArray[np.float32]

_MOST = 10**9  # steps; environments
_GREATEST_SEED = 2**63 - 1  # of Gymnasium

if TYPE_CHECKING:
    _GymEnv = object
else:
    try:
        from gymnasium import Env as _GymEnv
    except ImportError:
        _GymEnv = object


class Setup:
    """What an environment declares, and its worlds: shared by Env, VectorEnv and ParallelEnv.

    `robots`: ids; `is_one`: the arrays have no axis for robots.
    """

    def __init__(self, world: WorldLike, count: int, threads: int, robots: Union[None, str, Sequence[str]], is_one: bool,
                 observe: Names, act: Names, reward: Reward, steps: Optional[int], duration: Optional[float]) -> None:
        self.world: _elsie.World = world if isinstance(world, _elsie.World) else _elsie.World(None, os.fspath(world), [])
        declared = {name: self.world._value(f"learning/@{name}") for name in ("robots", "observe", "act", "steps", "duration")}
        if robots is None and declared["robots"]:
            robots = "all" if declared["robots"] == "all" else declared["robots"].split()
            is_one = is_one and robots != "all" and len(robots) == 1
        observe = _declared("observe", declared["observe"]) or "readings" if observe is None else observe
        act = _declared("act", declared["act"]) or "motion" if act is None else act
        steps = declared["steps"] or self.world.control_steps if steps is None else steps
        duration = declared["duration"] if duration is None else duration
        self.is_one = is_one
        self.process = os.getpid() if whole("threads", threads, 1, MOST_THREADS) > 1 else 0
        robots = "all" if robots is None and not is_one else robots
        self.robots = _robots_of(self.world, robots, is_one)
        self.steps = whole("steps", steps, 1, _MOST)
        if duration is not None and not (is_number(duration) and 0 < duration < np.inf):
            raise InputError(f"duration={duration!r}: expected a time above 0 s")
        self.is_choice = act in ("choice", ["choice"])
        self.reward = reward if callable(reward) else None
        self.worlds = _elsie.Worlds(self.world, whole("num_envs", count, 1, _MOST), int(threads), self.robots,
                                    _names("observe", observe), _names("act", "priorities" if self.is_choice else act),
                                    None if callable(reward) else _terms(reward), self.steps, duration)
        observed = [self.worlds.observed(i) for i in range(len(self.robots))]
        acted = [self.worlds.acted(i) for i in range(len(self.robots))]
        self.observation_names: list[list[str]] = [each["names"] for each in observed]
        self.action_names: list[list[str]] = [each["names"] for each in acted]
        self.action_ranges: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = [(each["low"], each["high"]) for each in acted]
        with np.errstate(all="ignore"):  # bounds that are too small for a float
            self.observation_spaces = [Box(each["low"].astype(np.float32), each["high"].astype(np.float32), dtype=np.float32)
                                       for each in observed]
        for each, space in zip(observed, self.observation_spaces):
            for name, least, greatest in zip(each["names"], space.low, space.high):
                if not least < greatest < np.inf or not -np.inf < least:
                    raise InputError(f"observe: the bounds of '{name}' are {least} and {greatest} as numbers of 32 bits; expected two different, "
                                     "finite ones")
        self.action_spaces: list[Any] = [Discrete(len(names)) if self.is_choice else Box(-1.0, 1.0, (len(names),), np.float32)
                                         for names in self.action_names]

    def stacked(self, kind: str) -> Any:
        """The space of all robots together; they must have equal numbers."""
        names = getattr(self, f"{kind}_names")
        spaces = getattr(self, f"{kind}_spaces")
        if self.is_one:
            return spaces[0]
        for robot, each in zip(self.robots, names):
            if len(each) != len(names[0]):
                raise InputError(f"The {kind} of robot '{robot}' has {len(each)} numbers, that of '{self.robots[0]}' "
                                 f"{len(names[0])}; expected as many for all: name other things, or use ParallelEnv")
        if isinstance(spaces[0], Discrete):
            return MultiDiscrete([space.n for space in spaces])
        return Box(np.stack([space.low for space in spaces]), np.stack([space.high for space in spaces]), dtype=np.float32)

    def numbers_of(self, actions: Any, space: Any) -> Any:
        """Actions as numbers in [-1, 1]."""
        if not self.is_choice:
            return actions
        chosen = np.asarray(actions)
        if not space.contains(chosen if chosen.shape else actions):
            raise InputError(f"The action {actions!r} is not in {space}")
        numbers = np.full(chosen.shape + (len(self.action_names[0]),), -1.0, np.float32)
        np.put_along_axis(numbers, chosen[..., np.newaxis].astype(np.int64), 1.0, axis=-1)
        return numbers

    def metadata(self) -> dict[str, Any]:
        fps = max(1, round(1.0 / (self.steps * self.world.step_s)))
        return {"render_modes": ["rgb_array"], "render_fps": fps, "name": self.world.name or "elsie"}


def _robots_of(world: _elsie.World, robots: Union[None, str, Sequence[str]], is_one: bool) -> list[str]:
    known = list(world.robots)
    if not known:
        raise InputError("The world has no robots: nobody can learn in it")
    if robots == "all" and not is_one:
        return known
    if isinstance(robots, str):
        robots = [robots]
    if robots is not None and not (isinstance(robots, Sequence) and all(isinstance(each, str) for each in robots)):
        raise InputError(f"robots={robots!r}: expected ids of robots, such as {known[0]!r}")
    if robots is None:
        if len(known) != 1:
            raise InputError(f"The world has {len(known)} robots: {', '.join(known[:10])}{', ...' if len(known) > 10 else ''}; "
                             "name one with robot=..., several with robots=[...], or robots=\"all\"")
        return known
    chosen = list(robots)
    if not chosen or len(set(chosen)) != len(chosen) or (is_one and len(chosen) != 1):
        raise InputError(f"robots={chosen}: expected ids of robots, each once")
    return chosen


def _declared(what: str, text: str) -> list[Named]:
    """The names of an attribute of <learning>: "pose vision.column:0:100"."""
    names: list[Named] = []
    for word in text.split():
        name, *bounds = word.split(":")
        try:
            names.append((name, float(bounds[0]), float(bounds[1])) if len(bounds) == 2 else name)
        except ValueError:
            bounds = [""]
        if len(bounds) not in (0, 2):
            raise InputError(f"<learning {what}=\"{text}\">: '{word}' is neither a name nor NAME:LEAST:GREATEST")
    return names


def _names(what: str, given: Union[Named, Sequence[Named]]) -> list[tuple[str, Optional[float], Optional[float]]]:
    if not isinstance(given, (str, Sequence)):
        raise InputError(f"{what}={given!r}: expected a name, or a list of names")
    alone = isinstance(given, str) or (isinstance(given, tuple) and len(given) == 3 and not isinstance(given[1], (str, tuple)))
    names: list[tuple[str, Optional[float], Optional[float]]] = []
    listed: Sequence[Any] = [given] if alone else given
    for each in listed:
        if isinstance(each, str):
            names.append((each, None, None))
        elif isinstance(each, tuple) and len(each) == 3 and isinstance(each[0], str):
            names.append((each[0], float(each[1]), float(each[2])))
        else:
            raise InputError(f"{what}: {each!r} is no name; expected a text, or (name, least, greatest)")
    if not names:
        raise InputError(f"{what}: nothing is named")
    return names


def _terms(reward: Any) -> Optional[list[tuple[str, float]]]:
    if reward is None:
        return None
    if isinstance(reward, str):
        return [(reward, 1.0)]
    if not isinstance(reward, (Mapping, Sequence)):
        raise InputError(f"reward={reward!r}: expected a name, names with weights, or a function")
    terms = list(reward.items()) if isinstance(reward, Mapping) else [(name, 1.0) for name in reward]
    for name, weight in terms:
        if not isinstance(name, str) or not isinstance(weight, (int, float, np.number)) or not np.isfinite(weight):
            raise InputError(f"reward: {name!r}: {weight!r} is no name of a measure or value with a weight")
    return [(name, float(weight)) for name, weight in terms]


class Base:
    """What environments have in common, apart from Gymnasium's interface."""

    _setup: Optional[Setup]
    render_mode: Optional[str]

    def _begin(self, setup: Setup, render_mode: Optional[str]) -> None:
        if render_mode not in (None, "rgb_array"):
            raise InputError(f"render_mode={render_mode!r}: expected \"rgb_array\" or None")
        self._setup = setup
        self.render_mode = render_mode
        self.metadata = setup.metadata()
        self.robots = tuple(setup.robots)
        self._seed(1)

    def _seed(self, seed: int) -> None:
        self._np_random = np.random.Generator(np.random.PCG64(seed))
        self._np_random_seed = seed

    @property
    def np_random(self) -> np.random.Generator:
        """Random numbers that reset(seed=...) begins anew; the world has its own."""
        return self._np_random

    @np_random.setter
    def np_random(self, value: np.random.Generator) -> None:
        self._np_random, self._np_random_seed = value, -1

    @property
    def np_random_seed(self) -> int:
        """With which `np_random` began; -1: somebody replaced it."""
        return self._np_random_seed

    @property
    def _open(self) -> Setup:
        setup = self._setup
        if setup is None:
            raise InputError("This environment is closed; make a new one")
        if setup.process and setup.process != os.getpid():
            raise InputError("This environment was made in another process, whose threads a copy by fork() does not have; make it in the "
                             "process that uses it, or with threads=1")
        return setup

    @property
    def observation_names(self) -> list[list[str]]:
        """The names of the numbers that each robot observes, in their order."""
        return self._open.observation_names

    @property
    def action_names(self) -> list[list[str]]:
        """The names of the numbers that each robot does."""
        return self._open.action_names

    @property
    def action_ranges(self) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
        """For each robot: what -1 and 1 stand for, in the units of the world."""
        return self._open.action_ranges

    def __reduce__(self) -> Any:
        raise TypeError("an environment cannot be copied or pickled; make another one of the same world, and reset it with the same seed")

    def close(self) -> None:
        """Gives the worlds up. May be called twice."""
        self._setup = None

    def _picture(self, world: int, width: int = 480) -> Optional[NDArray[np.uint8]]:
        return self._open.worlds.picture(world, width) if self.render_mode == "rgb_array" else None


class Env(Base, _GymEnv):
    """One world: a Gymnasium environment if Gymnasium is installed, with the same interface if not.

    world: a file, a shipped world, or an elsie.World.
    robot: the id of the robot that learns; or robots: several of them, or "all". Then arrays have an axis for robots, and the reward is
        the mean of theirs.
    The world may declare robots, observe, act, steps and duration itself, in <learning>; otherwise readings are observed and act is
        "motion".
    observe: names of what is observed: "readings" (all numbers of all sensors), "range.distance_m" (of all sensors of a kind),
        "left.hit" (of the sensor with this id), "pose", "motion", "odometry", "commanded", "energy", "charging", and published
        numbers, "explore/avoid.clearance". (name, least, greatest) sets bounds; values beyond are clipped.
    act: "motion"; numbers of actuators' commands, "gripper.closed"; "priorities" of the robot's own behaviours, or "choice" of one of
        them; live parameters, "behavior[wander]/@speed". All are in [-1, 1], which stand for the bounds.
    reward: measures that publish rewards, or values of results, with weights; None: all rewards that the world declares; or a function
        of observation, action and following observation.
    steps: of the physics in each step; None: a control period. duration: the limit of time, s, instead of the world's.
    """

    spec: Any = None

    def __init__(self, world: WorldLike, *, robot: Optional[str] = None, robots: Union[None, str, Sequence[str]] = None,
                 observe: Names = None, act: Names = None, reward: Reward = None, steps: Optional[int] = None,
                 duration: Optional[float] = None, render_mode: Optional[str] = None) -> None:
        if robot is not None and robots is not None:
            raise InputError("robot=... and robots=... exclude each other")
        setup = Setup(world, 1, 1, robot if robots is None else robots, robots is None, observe, act, reward, steps, duration)
        self._begin(setup, render_mode)
        self.observation_space = setup.stacked("observation")
        self.action_space = setup.stacked("action")
        numbers = (len(setup.action_names[0]),)
        setup.worlds.set_shapes(numbers if setup.is_one else (len(setup.robots), *numbers), self.observation_space.shape)
        self._step: Any = setup.worlds.step_alone
        self._plain = setup.reward is None and not setup.is_choice
        self._before: Any = None

    @property
    def unwrapped(self) -> "Env":
        """The environment itself: it wraps none."""
        return self

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None) -> tuple[Floats, dict[str, Any]]:
        """Begins an episode: with this seed, or with the next one that follows from it. The first seed is 1."""
        refuse_options(options)
        worlds = self._open.worlds
        if seed is not None:
            seed = checked_seed(seed)
            self._seed(seed)
        worlds.begin([0], [] if seed is None else [seed])
        observation: Floats = worlds.observations.reshape(self.observation_space.shape).copy()
        self._before = observation
        return observation, {"seed": worlds.seed(0)}

    def step(self, action: Any) -> tuple[Floats, float, bool, bool, dict[str, Any]]:
        """Makes a step: observation, reward, terminated (a goal was reached or broken), truncated (by the limit of time), info."""
        if self._setup is None:
            self._open
        if self._plain:
            observation, reward, terminated, truncated = self._step(action)
        else:
            observation, reward, terminated, truncated = self._special(action)
        if terminated or truncated:
            return observation, reward, terminated, truncated, self._ending()
        return observation, reward, terminated, truncated, {}

    def _special(self, action: Any) -> tuple[Floats, float, bool, bool]:
        setup = self._open
        observation, reward, terminated, truncated = self._step(setup.numbers_of(action, self.action_space))
        if setup.reward:
            reward = checked_reward(setup.reward(self._before, action, observation))
            self._before = observation
        return observation, reward, terminated, truncated

    def _ending(self) -> dict[str, Any]:
        worlds = self._open.worlds
        return {"outcome": worlds.outcome(0), "time_s": worlds.time_s(0)}

    def close(self) -> None:
        """Gives the world up. May be called twice."""
        super().close()
        self._step = None

    def robot_rewards(self) -> dict[str, float]:
        """The rewards of the last step by robot."""
        return dict(zip(self.robots, self._open.worlds.rewards[0].tolist()))

    def render(self) -> Optional[NDArray[np.uint8]]:
        """The world from above: (height, width, 3)."""
        return self._picture(0)

    @property
    def time_s(self) -> float:
        """Simulated, of this episode."""
        return self._open.worlds.time_s(0)

    @property
    def seed_now(self) -> int:
        """The seed of this episode."""
        return self._open.worlds.seed(0)

    @property
    def state_hash(self) -> str:
        """Of the world's state, as results have it."""
        return self._open.worlds.state_hash(0)

    def save(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Keeps the episode so far: as a world with the actions as edits (.xml), or as a recording (.mcap).

        `elsie run FILE --seed N`, with the seed `seed_now`, and `elsie replay FILE` make it again, bit for bit. Where the world has
        an <endure> goal that lasts longer than the episode, a warning says the `--duration` that the run needs.
        """
        save(self._open, 0, file)

    def __enter__(self) -> "Env":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def save(setup: Setup, world: int, file: Union[str, "os.PathLike[str]"]) -> None:
    """Saves an episode. Warns once if `elsie run` would make it with other bits."""
    name = os.fspath(file)
    if os.path.exists(name) and os.path.exists(setup.world.file) and os.path.samefile(name, setup.world.file):
        raise InputError(f"save: '{name}' is the world of this environment, which would be lost; name another file")
    limit = setup.worlds.save(world, name)
    if limit is not None:
        warnings.warn(f"{name}: a goal of this world lasts longer than the episode, so that its limit of time stays; "
                      f"the run ends as the episode did with `--duration {limit!r}`", stacklevel=3)
    note_of_bits()


def checked_reward(reward: Any) -> float:
    """What a function of the user returned."""
    try:
        earned = float(reward)
    except (TypeError, ValueError):
        raise InputError(f"The reward function returned {reward!r}; expected a number") from None
    if not np.isfinite(earned):
        raise InputError(f"The reward function returned {earned}; expected a finite number")
    return earned


def refuse_options(options: Optional[Mapping[str, Any]], known: Sequence[str] = ()) -> None:
    """Nothing that a user asks of reset() is passed over."""
    for name in options or ():
        if name not in known:
            raise InputError(f"options: there is no {name!r}; there is {', '.join(map(repr, known)) or 'none'}")


def checked_seed(seed: Any) -> int:
    return whole("seed", seed, 0, _GREATEST_SEED)
