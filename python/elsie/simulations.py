"""Simulations: making steps, looking, and editing while they run."""
from __future__ import annotations

import math
import os
import sys
import warnings
from collections.abc import Callable, Mapping
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from elsie import _elsie
from elsie.checks import GREATEST_SEED, is_number, whole
from elsie.errors import EditRefused, Error, InputError, PhysicsFault, PluginFault
from elsie.results import Event, Note, Result, result_of
from elsie.worlds import File, Paths, Value, World

MOST_THREADS = 256  # as of `elsie run --threads`
_MOST_WATCHED = 100
_OTHER_BITS = ("This process was not started with the settings that give the same bits on every processor, as `elsie` starts itself: "
               "start scripts with `elsie python script.py`. Runs repeat on this machine.")
_warned = False


def same_bits() -> bool:
    """Whether runs of this process are those of `elsie run` and of other machines, to the last bit: see `elsie python`."""
    return _elsie.has_fixed_arithmetic()


def _levels_inside() -> int:
    """For warnings: how many calls down the stack the user's own line is, seen from the caller."""
    levels, frame = 1, sys._getframe(1)
    while frame is not None and frame.f_globals.get("__name__", "").split(".")[0] == "elsie" and frame.f_back is not None:
        levels, frame = levels + 1, frame.f_back
    return levels


def note_of_bits() -> list[Note]:
    """For each result of this process; warns at the first call."""
    global _warned
    if same_bits():
        return []
    if not _warned:
        warnings.warn(_OTHER_BITS, RuntimeWarning, stacklevel=_levels_inside())  # raises, each time, where warnings are errors
        _warned = True
    return [Note("", "python", _OTHER_BITS)]


class _Observer:
    """A function that is called after steps."""

    def __init__(self, function: Callable[[Simulation], object], every: Optional[float], now: float) -> None:
        self.function = function
        self.every = every
        self.due = self._next(now)

    def _next(self, now: float) -> float:
        if self.every is None:
            return -math.inf
        return (math.floor(now / self.every + 1e-6) + 1) * self.every

    def call(self, run: Simulation) -> None:
        if run.time >= self.due - 1e-6 * run.step_s:
            self.due = self._next(run.time)
            self.function(run)


class Simulation(_elsie.Simulation, Paths):
    """A world that runs, step by step or to its end.

        run = elsie.Simulation("worlds/clutter.xml", seed=7)
        run.step(100)
        run["robot[r1]/@max_speed"] = 0.2
        result = run.run()

    The same world and seed give the same run as `elsie run`. Arrays such as `poses` are views of memory that each step
    fills again: take them once, look at them often. They cannot be written to, and stay valid with their last numbers when
    the simulation is gone, and when an edit adds or removes robots; then take them again.

    Only one thread at a time may use a simulation; steps let other threads of Python run.
    """

    def __init__(self, world: Union[World, File], seed: int = 1, *, threads: int = 1, time_limit: Optional[float] = None,
                 edits: Optional[Mapping[str, Value]] = None, watch: Optional[bool] = None) -> None:
        """Makes all objects of the world.

        seed: of all randomness in the run, from 0 to 2**64 - 1. threads: in which robots sense and decide; the run is the
        same with any number. time_limit: simulated seconds after which the run ends, instead of the world's. edits: values
        by paths, as of `elsie run --set`; they also reach what the layouts of a world draw. watch: keep the paths of robots,
        for pictures, and who decides, for `Result.trace`; None: for at most 100 robots. Later edits of `world` do not
        change this simulation.
        """
        read = world if isinstance(world, _elsie.World) else World(world)
        whole("seed", seed, 0, GREATEST_SEED)
        whole("threads", threads, 1, MOST_THREADS)
        if time_limit is not None and not (is_number(time_limit) and 0 < time_limit < math.inf):
            raise InputError(f"time_limit: expected a number of seconds above 0, not {time_limit!r}")
        is_watched = len(read.robots) <= _MOST_WATCHED if watch is None else watch
        _elsie.Simulation.__init__(self, read, seed, threads, time_limit, list((edits or {}).items()), is_watched, is_watched)
        self._observers: list[_Observer] = []
        self._is_observed = False
        self._events: list[Event] = []
        self._ended: Optional[Result] = None
        self._fault: Optional[Error] = None
        self._process = os.getpid() if threads > 1 else 0
        self._more_notes = note_of_bits()

    # Steps

    def step(self, steps: int = 1) -> int:
        """Makes so many steps of the physics (`step_s` long), fewer if the run ends before; returns how many.

        Raises `elsie.PluginFault` and `elsie.PhysicsFault`, which end the run; later calls raise them again.
        """
        return self._go(min(whole("steps", steps, 0), 2**63), math.inf)

    def run(self, until: Optional[float] = None) -> Result:
        """Makes steps until a goal or a limit ends the run, or until this simulated time, s. Returns the result so far."""
        if until is not None and (not is_number(until) or math.isnan(until)):
            raise InputError(f"until: expected a time in seconds, not {until!r}")
        self._go(2**63, math.inf if until is None else until)
        return self.result()

    def observe(self, function: Callable[[Simulation], object], every: Optional[float] = None) -> Callable[[Simulation], object]:
        """Has `function(run)` called after each step, or once in so many simulated seconds.

        It may look at the run and edit it, and not make steps. What it raises comes out of step() or run().
        """
        if every is not None and not (is_number(every) and 0 < every < math.inf):
            raise InputError(f"every: expected a number of seconds above 0, not {every!r}")
        if not callable(function):
            raise TypeError(f"observe() expected a function of the simulation, not {type(function).__name__}")
        at_each_step = every is not None and every <= self.step_s
        self._observers.append(_Observer(function, None if at_each_step else every, self.time))
        return function

    def reset(self, seed: Optional[int] = None) -> None:
        """Starts again at time zero, with this seed or the same. Edits since the start, observers and recordings are forgotten."""
        self._refuse_in_observer("reset")
        if seed is not None:
            whole("seed", seed, 0, GREATEST_SEED)
        self._reset_to(seed)
        self._observers.clear()
        self._events.clear()
        self._ended = None
        self._fault = None

    def close(self) -> None:
        """Ends the run where it is, so that recordings are complete. Also at the end of `with`; may be called again."""
        if self._ended is None and self._fault is None:
            self._refuse_in_observer("close")
            self._end()

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        self.close()

    def record(self, file: File, *, rate: float = 10.0, images: bool = False, robots: Optional[list[str]] = None) -> None:
        """Records the run in a .csv or .mcap file, `rate` times in a simulated second. Call it before the first step.

        images: the pictures of cameras, too (.mcap). robots: their ids; None: all, or as many as the format takes.
        """
        self._record_to(os.fspath(file), rate, images, robots or [])

    # What is now

    @property
    def poses(self) -> npt.NDArray[np.float64]:
        """True poses: a row for each robot, in the order of `robots`: x m, y m, heading rad. A view."""
        return self._of_robots("poses")

    @property
    def beliefs(self) -> npt.NDArray[np.float64]:
        """The poses that robots believe to have, likewise. A view."""
        return self._of_robots("beliefs")

    @property
    def motions(self) -> npt.NDArray[np.float64]:
        """True motions: forward m/s, lateral m/s (left), turn rad/s (counter-clockwise). A view."""
        return self._of_robots("motions")

    @property
    def commands(self) -> npt.NDArray[np.float64]:
        """The commands of the coordinators, as the drives can make them; units of `motions`. A view."""
        return self._of_robots("commands")

    @property
    def energies(self) -> npt.NDArray[np.float64]:
        """Energy in the batteries, units. A view."""
        return self._of_robots("energies")

    @property
    def distances(self) -> npt.NDArray[np.float64]:
        """Lengths of the paths driven so far, m. A view."""
        return self._of_robots("distances")

    @property
    def collisions(self) -> npt.NDArray[np.int64]:
        """Collisions so far. A view."""
        return self._of_robots("collisions")

    @property
    def obstacles(self) -> npt.NDArray[np.float64]:
        """Poses of boxes and resources, in the order of `obstacle_ids`: x m, y m, heading rad; NaN: it was collected. A view."""
        return self._of_obstacles()

    def field(self, name: str) -> npt.NDArray[np.float64]:
        """A field over the floor, units/m2: rows from south to north, each from west to east. A view."""
        return self._of_field(name)

    def readings(self, name: str) -> npt.NDArray[Any]:
        """The readings of all sensors with this id, else this plugin, else this kind of reading ("range").

        A structured array with a row for each sensor: robot (its place in `robots`), sensor (its id), and a field for each
        number of the reading, with the names and units of docs/sensors; arrays have a second axis. Places that a list does
        not fill are NaN. A view; all zero before the first decision. Pictures: see image().
        """
        return self._readings_of(name)

    def published(self, name: str) -> npt.NDArray[Any]:
        """The numbers that plugins publish under this name: robot (-1: a measure's), plugin (its path), value. A view."""
        return self._published_as(name)

    def image(self, sensor: str, *, robot: Union[int, str] = 0, name: str = "raw") -> npt.NDArray[np.uint8]:
        """A copy of a camera's last picture, (height, width, channels); name: "raw", or what the sensor makes of it."""
        return _elsie.image_of(self, self._place(robot), sensor, name)

    @property
    def events(self) -> list[Event]:
        """Everything that happened so far, in order."""
        self._events.extend(Event(*each) for each in self._events_from(len(self._events)))
        return list(self._events)

    @property
    def notes(self) -> list[Note]:
        """What plugins and the simulator have to say so far."""
        return [Note(*each) for each in self._all_notes()] + self._notes_here()

    def result(self) -> Result:
        """The result so far; once the run has ended, its result, with the trace. A fault is the outcome "fault"."""
        if self._ended is not None:
            return self._ended
        if self._fault is not None:
            return result_of({**self._result_fields(), "outcome": "fault", "reason": str(self._fault)}, self._notes_here(), self._account())
        if self.outcome != "running":
            return self._end()
        return result_of(self._result_fields(), self._notes_here(), None)

    # Pictures

    def picture(self, file: File, *, width: int = 1000) -> None:
        """Draws the run from above, with the robots' paths so far, as a .png or .svg; `width` in pixels."""
        _elsie.save_run(self, os.fspath(file), [self._headline()], width)

    def render(self, width: int = 640, height: int = 480, *, bare: bool = True) -> npt.NDArray[np.uint8]:
        """The same as pixels: (height, width, 3), red, green, blue. bare: without axes, legend and names."""
        return _elsie.render_run(self, width, height, bare)

    def __reduce__(self) -> tuple[object, ...]:
        raise TypeError("a simulation cannot be copied or pickled; make another one of the same world and seed")

    def __repr__(self) -> str:
        return f"<elsie.Simulation, {self._headline()}>"

    def _repr_svg_(self) -> str:
        return _elsie.svg_of_run(self, [self._headline()], 700)

    # Inside

    def _go(self, steps: int, until: float) -> int:
        self._refuse_in_observer("step")
        if self._process and self._process != os.getpid():
            raise InputError("this simulation was made in another process, whose threads a copy by fork() does not have; make it in the "
                             "process that uses it, or with threads=1")
        made = 0
        while made < steps and (not self._observers or self.time < until - 1e-6 * self.step_s):
            every_step = any(each.every is None for each in self._observers)
            due = min((each.due for each in self._observers if each.every is not None), default=math.inf)
            try:
                more = self._advance(1 if every_step else steps - made, min(until, due))
            except (PluginFault, PhysicsFault, EditRefused) as fault:
                self._fault = fault
                raise
            made += more
            if more == 0:
                break
            self._call_observers()
            if not self._observers:
                break
        if self.outcome != "running" and self._ended is None:
            self._end()
        return made

    def _call_observers(self) -> None:
        self._is_observed = True
        try:
            for each in list(self._observers):
                each.call(self)
        finally:
            self._is_observed = False

    def _end(self) -> Result:
        self._ended = result_of(self._finish(), self._notes_here(), self._account())
        return self._ended

    def _notes_here(self) -> list[Note]:
        """Of this process, and of recordings."""
        return self._more_notes + [Note("", "recording", each) for each in self._recorders_said()]

    def _refuse_in_observer(self, what: str) -> None:
        if self._is_observed:
            raise Error(f"an observer cannot {what} the simulation that calls it")

    def _place(self, robot: Union[int, str]) -> int:
        if isinstance(robot, str):
            if robot not in self.robots:
                raise InputError(f"there is no robot '{robot}'; there are: {', '.join(self.robots[:20])}")
            return self.robots.index(robot)
        if not 0 <= robot < len(self.robots):
            raise InputError(f"there is no robot {robot}; there are {len(self.robots)}, counted from 0")
        return robot

    def _headline(self) -> str:
        return f"{self.outcome} after {self.time:.1f} s (seed {self.seed})"
