"""Plugins in Python: a class in a file that the plugin path or `--plugin FILE` names.

    import elsie

    class Orbit(elsie.Behavior):
        \"\"\"Circles to the left at a distance from the nearest thing.\"\"\"

        radius = elsie.parameter(0.5, unit="m", min=0.05, meaning="of the circle")
        distance = elsie.published(unit="m")
        needs = ["range"]

        def respond(self, now):
            self.distance = min(now.readings["range"].distance_m)
            return elsie.Motion(forward=0.2, turn=0.2 / self.radius), 1.0 if self.distance < 1 else 0.2

The first line of the docstring describes the plugin, and its name is that of the class: `orbit`. A class whose name begins with
an underscore is no plugin. docs/writing-a-behavior-in-python.md is the tutorial.
"""
from __future__ import annotations

import ast
import functools
import math
import os
import re
import sys
import types
from pathlib import Path
from typing import Any, ClassVar, Iterable, Mapping, NamedTuple, Optional, Sequence, TypeVar, Union

import numpy as np

from elsie._elsie import (ActuatorNow, Member, Motion, Now, Pose, Random, Readings, Response, SensorNow, Sketch, Status, WorldChanges,
                           WorldNow)
from elsie.errors import InputError

__all__ = ["Actuator", "ActuatorNow", "Answer", "Behavior", "Coordinator", "Measure", "Member", "Motion", "Now", "Pose", "Random",
           "Readings", "Response", "Rule", "Sensor", "SensorNow", "Sketch", "Status", "Struct", "WorldChanges", "WorldNow", "array",
           "command", "message", "parameter", "published", "reading"]

Answer = Union[Motion, "tuple[Motion, float]", Response]
"""What a behaviour answers: a motion, perhaps with its activation, or a response."""

Value = TypeVar("Value", bool, int, float, str, "list[float]")


class Field(NamedTuple):
    """A number of a struct, or an array of numbers."""

    name: str
    unit: str
    size: int  # 0: one number


class Struct(NamedTuple):
    """What a reading, a command or a message consists of: see reading(), command() and message()."""

    kind: str
    fields: tuple[Field, ...]


_MOST_NUMBERS = 1_000_000


class _Array(NamedTuple):
    size: int
    unit: str


def array(size: int, unit: str = "") -> _Array:
    """As many numbers, in a reading, command or message: cells=elsie.array(8, unit="K")."""
    if isinstance(size, bool) or not isinstance(size, int) or not 0 < size <= _MOST_NUMBERS:
        raise InputError(f"array(): the size is {size!r}; expected a whole number from 1 to {_MOST_NUMBERS}")
    return _Array(size, unit)


def _struct(kind: str, fields: Mapping[str, Union[str, _Array]]) -> Struct:
    return Struct(kind, tuple(Field(name, of.unit, of.size) if isinstance(of, _Array) else Field(name, of, 0)
                              for name, of in fields.items()))


def reading(kind: str, **units: Union[str, _Array]) -> Struct:
    """Readings of a kind of one's own, with the unit of each number: elsie.reading("heat", kelvin="K").

    A plugin in C++ exchanges them as a struct of doubles with these names and units, in this order; an array is a std::array.
    """
    return _struct(kind, units)


def command(kind: str, **units: Union[str, _Array]) -> Struct:
    """Commands of a kind of one's own; see reading()."""
    return _struct(kind, units)


def message(kind: str, **units: Union[str, _Array]) -> Struct:
    """Messages of a kind of one's own: elsie.message("offer", x="m", y="m"). See reading()."""
    return _struct(kind, units)


class Mate(NamedTuple):
    """Another robot of the team: `now.team.mates`."""

    id: str
    pose: Pose  # as it believes
    distance_m: float
    bearing_rad: float  # from this robot's heading, positive to the left
    is_leader: bool
    team_index: int


class Held(NamedTuple):
    """Something that the robot holds: `now.self.held`."""

    id: str
    actuator: str
    moves: bool  # as many robots hold it as must for it to move with them


class Heard:
    """A message that the robot hears: `now.heard("offer")`. Its numbers are attributes: `offer.x`."""

    def __init__(self, kind: str, numbers: dict[str, Any], device: str, sender: str, age_s: float, distance_m: float,
                 bearing_rad: float, elevation_rad: float) -> None:
        self.__dict__.update(numbers)
        self.kind = kind
        self.device = device
        self.sender = sender  # its id; empty: the device does not tell
        self.age_s = age_s  # since it was said
        self.distance_m = distance_m  # of the sender, with its bearing and elevation; NaN: the device does not tell
        self.bearing_rad = bearing_rad
        self.elevation_rad = elevation_rad

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"the message has no number '{name}'; it has {', '.join(vars(self))}")


class Thing(NamedTuple):
    """What a sensor sees: `now.see(1.0)`, `now.things(1.0)`."""

    kind: str  # "floor", "wall", "obstacle", "resource", "charger" or "robot"
    id: str
    team: str
    colour: tuple[int, int, int]


class Lamp(NamedTuple):
    """A lamp, or the light of a robot: `now.lamps`."""

    id: str
    place: tuple[float, float, float]
    intensity: float
    colour: tuple[int, int, int]


class Obstacle(NamedTuple):
    """A box or a resource that is still there: `now.obstacles` of measures and rules."""

    id: str
    kind: str  # "fixed", "dynamic", "moving" or "resource"
    team: str
    pose: Pose


class ObservedBehavior(NamedTuple):
    """A behaviour of a robot in its last decision, for measures and rules."""

    path: str  # the ids of those around it, and its own: "explore/avoid"
    plugin: str
    asked: bool
    command: Motion
    activation: float
    share: float  # in the command of its own coordinator
    robot_share: float  # in the robot's command


class End(NamedTuple):
    """How a run ended, for measures."""

    outcome: str  # "success", "failure", "time_limit" or "running"
    time: float  # s


class _Readings(dict):  # type: ignore[type-arg]
    """`now.readings`"""

    def __missing__(self, kind: str) -> Any:
        made = ", ".join(f"'{each}'" for each in self) or "none"
        raise KeyError(f"no sensor of the robot makes readings of the kind '{kind}'; there are {made}. With needs = [\"{kind}\"] "
                       "in the class, a robot without them is refused at the start")


class Parameter:
    """What parameter() makes; an object of the plugin has its value."""

    def __init__(self, **facts: Any) -> None:
        self.facts = facts


def parameter(default: Value, *, unit: str = "", min: float = -math.inf, above: float = -math.inf, max: float = math.inf,
              choices: Sequence[str] = (), meaning: str = "", required: bool = False, live: bool = True, file: bool = False) -> Value:
    """An attribute that a world file sets, of the type of its default: float, int, bool, str or a list of floats.

    A value is at least `min`, greater than `above` and at most `max`; a text may be one of `choices`, or name a `file`, whose path
    it then is. `required`: a world must give it. Not `live`: its value only counts before a run.
    """
    return Parameter(default=default, unit=unit, min=min, above=above, max=max, choices=list(choices), meaning=meaning,
                     required=required, live=live, file=file)  # type: ignore[return-value]


class Published:
    """What published() makes; an object of the plugin has the number."""

    def __init__(self, unit: str, meaning: str) -> None:
        self.unit = unit
        self.meaning = meaning


def published(*, unit: str = "", meaning: str = "") -> float:
    """A number that recordings, measures and the window show: assign it to the attribute. NaN, as at first: there is none."""
    return Published(unit, meaning)  # type: ignore[return-value]


class Plugin:
    """The base of all plugins. An object belongs to one robot, or to the world. All methods are optional unless a class says so.

    The object has its parameters before `__init__(self)`. Then come `configured(self)`, again after a change of parameters, also
    during a run, and `equipped(self, ...)`, when the robot is complete. Before each run `reset(self, random)` forgets the last
    one; a class without it has `__init__` called again. `notes(self)` gives sentences for the user, `curves(self)` tuples (name,
    label of x, label of y, points), and `sketch(self, sketch)` draws.

    When the file is edited during a run, a new object takes the place of this one, with the attributes that `remembers` names.
    """

    name: ClassVar[str]
    version: ClassVar[str] = "1.0"
    remembers: ClassVar[Sequence[str]] = ()

    def __new__(cls, *args: Any, **kwargs: Any) -> Any:
        made = super().__new__(cls)
        for name, item in _members(cls).items():
            if isinstance(item, Parameter):
                default = item.facts["default"]
                made.__dict__[name] = list(default) if isinstance(default, (list, tuple)) else default
            elif isinstance(item, Published):
                made.__dict__[name] = math.nan
        return made


class Behavior(Plugin):
    """A small, complete reason to move. `respond(self, now)` answers a `Motion`, `(Motion, activation)` or a `Response`.

    `equipped(self, example)` gets what `now` will be, with meaningless readings. `rate(self, now, given, candidates)` says how
    desirable motions would be, in [0, 1]: an array of three columns, one number for each row.
    """

    needs: ClassVar[Sequence[Union[str, Struct]]] = ()
    """Kinds of readings without which a robot is refused: ["range"]."""
    commands: ClassVar[Sequence[Union[str, Struct]]] = ()
    """Kinds of commands that it gives."""
    hears: ClassVar[Sequence[Struct]] = ()
    """Messages that it listens to."""
    raises: ClassVar[Mapping[str, str]] = {}
    """Events that it may raise, with their meanings."""
    reacts_to: ClassVar[Sequence[str]] = ()
    """Events that it reacts to."""
    only_acts: ClassVar[bool] = False
    """It never moves the robot, and is asked in every control period."""


class Coordinator(Plugin):
    """Decides which behaviours run and combines their wishes: `coordinate(self, members, now)` answers a `Motion`.

    `member.respond()` asks a behaviour, at most once in a control period. `member.weight`, `member.share` and `member.reason` tell
    the trace what its wish counted for. `equipped(self, names, example)` gets their names.
    """

    needs: ClassVar[Sequence[Union[str, Struct]]] = ()
    hears: ClassVar[Sequence[Struct]] = ()
    raises: ClassVar[Mapping[str, str]] = {}
    reacts_to: ClassVar[Sequence[str]] = ()


class Sensor(Plugin):
    """Asks the world around its robot: `sense(self, now)` answers a dict of the numbers of its reading, or the only number.

    `equipped(self, mounting)` gets its place on the robot. `camera(self)` may give (width, height, field of view in radians): then
    `now.image` is a picture.
    """

    reading: ClassVar[Union[str, Struct]]
    """What it produces: elsie.reading(...), or "range" or "proximity"."""
    feels_contacts: ClassVar[bool] = False
    """It asks for now.contacts."""


class Actuator(Plugin):
    """Does something besides moving: `act(self, command, now)` carries out a command, in every control period.

    `command.NAME` are its numbers. `equipped(self, mounting)` gets its place on the robot.
    """

    command: ClassVar[Struct]
    """What it takes: elsie.command(...)."""
    hears_messages: ClassVar[bool] = False
    """Robots with it hear what others transmit with such ones."""


class Measure(Plugin):
    """Computes figures of a run: `observe(self, now)` sees the world after each step, `report(self, end)` gives a dict.

    A value that is missing in the dict, or None, there is not. `equipped(self, start)` may refuse a world. A measure changes
    nothing.
    """

    quantities: ClassVar[Mapping[str, tuple[str, str]]]
    """The values that it reports, each with its unit and meaning: {"time_s": ("s", "until the goal")}. A method is allowed, too."""


class Rule(Plugin):
    """Changes the world while it runs: `apply(self, now, world)` sees it after each step, and edits it by `world`."""

    raises: ClassVar[Mapping[str, str]] = {}


_KINDS = {"behavior": (Behavior, "respond"), "coordinator": (Coordinator, "coordinate"), "sensor": (Sensor, "sense"),
          "actuator": (Actuator, "act"), "measure": (Measure, "observe"), "rule": (Rule, "apply")}


def _members(cls: type) -> dict[str, Any]:
    """The attributes of a class and its bases, in the order of their definition."""
    members: dict[str, Any] = {}
    for base in reversed(cls.__mro__):
        members.update(vars(base))
    return members


class _Wrong(InputError):
    """A declaration with a mistake; the text has file and line."""


class _Declarer:
    """Makes the declarations of the classes of a script, as dicts for C++."""

    def __init__(self, module: types.ModuleType, tree: ast.Module, file: Path) -> None:
        self.module = module
        self.file = file
        self.lines = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}

    def all(self) -> list[dict[str, Any]]:
        return [self.declared(cls) for cls in vars(self.module).values()
                if isinstance(cls, type) and issubclass(cls, Plugin) and cls.__module__ == self.module.__name__
                and not cls.__name__.startswith("_")]

    def fault(self, cls: type, sentence: str, member: str = "") -> _Wrong:
        node = self.lines.get(cls.__name__)
        line = node.lineno if node else 0
        for part in node.body if node else ():
            targets = part.targets if isinstance(part, ast.Assign) else [part.target] if isinstance(part, ast.AnnAssign) else []
            names = [target.id for target in targets if isinstance(target, ast.Name)]
            if member in names or (isinstance(part, ast.FunctionDef) and part.name == member):
                line = part.lineno
        return _Wrong(f"{self.file.name}:{line}: {sentence}")

    def declared(self, cls: type) -> dict[str, Any]:
        kinds = [kind for kind, (base, _) in _KINDS.items() if issubclass(cls, base)]
        if len(kinds) != 1:
            raise self.fault(cls, f"{cls.__name__} should derive from one of elsie.Behavior, Coordinator, Sensor, Actuator, "
                             "Measure and Rule")
        kind = kinds[0]
        method = _KINDS[kind][1]
        if not callable(getattr(cls, method, None)):
            raise self.fault(cls, f"{cls.__name__} has no method {method}(), which every {kind} needs")
        text = (cls.__dict__.get("__doc__") or "").strip().split("\n")[0].strip().rstrip(".")
        if not text:
            raise self.fault(cls, f"{cls.__name__} has no docstring; its first line describes the plugin")
        members = _members(cls)
        return {
            "cls": cls, "kind": kind, "file": str(self.file), "description": text, "version": str(members["version"]),
            "name": members.get("name", re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", cls.__name__).lower()),
            "parameters": [self.parameter(cls, name, item.facts) for name, item in members.items() if isinstance(item, Parameter)],
            "published": [(name, item.unit, item.meaning) for name, item in members.items() if isinstance(item, Published)],
            "needs": self.structs(cls, "needs"), "commands": self.structs(cls, "commands"),
            "hears": self.structs(cls, "hears", named=False), "raises": self.mapping(cls, "raises"),
            "reacts_to": self.names(cls, "reacts_to"), "remembers": self.names(cls, "remembers"),
            "only_acts": bool(members.get("only_acts", False)), "feels_contacts": bool(members.get("feels_contacts", False)),
            "hears_messages": bool(members.get("hears_messages", False)), "struct": self.own_struct(cls, kind),
        }

    def own_struct(self, cls: type, kind: str) -> Any:
        """The reading of a sensor, the command of an actuator."""
        attribute = {"sensor": "reading", "actuator": "command"}.get(kind)
        if attribute is None:
            return None
        own = getattr(cls, attribute, None)
        if isinstance(own, Struct) and own.fields or (kind == "sensor" and own in ("range", "proximity")):
            return own
        raise self.fault(cls, f"{cls.__name__}.{attribute} is {own!r}; expected elsie.{attribute}(\"kind\", name=\"unit\", ...)" +
                         (', or "range" or "proximity"' if kind == "sensor" else ""), attribute)

    def sequence(self, cls: type, attribute: str) -> Iterable[Any]:
        items = getattr(cls, attribute, ())
        if not isinstance(items, (list, tuple)):
            raise self.fault(cls, f"{cls.__name__}.{attribute} is {items!r}; expected a list", attribute)
        return items

    def names(self, cls: type, attribute: str) -> list[str]:
        for item in self.sequence(cls, attribute):
            if not isinstance(item, str):
                raise self.fault(cls, f"{cls.__name__}.{attribute} has {item!r}; expected names", attribute)
        return list(self.sequence(cls, attribute))

    def structs(self, cls: type, attribute: str, named: bool = True) -> list[Struct]:
        structs = []
        for item in self.sequence(cls, attribute):
            if isinstance(item, Struct):
                structs.append(item)
            elif isinstance(item, str) and named:
                structs.append(Struct(item, ()))
            else:
                raise self.fault(cls, f"{cls.__name__}.{attribute} has {item!r}; expected " +
                                 ("the name of a kind" if named else 'elsie.message("kind", name="unit", ...)'), attribute)
        return structs

    def mapping(self, cls: type, attribute: str) -> dict[str, str]:
        items = getattr(cls, attribute, {})
        if not isinstance(items, dict) or not all(isinstance(word, str) for item in items.items() for word in item):
            raise self.fault(cls, f"{cls.__name__}.{attribute} is {items!r}; expected a dict of names and meanings", attribute)
        return items

    def parameter(self, cls: type, name: str, facts: dict[str, Any]) -> dict[str, Any]:
        default = facts["default"]
        is_list = isinstance(default, (list, tuple)) and all(isinstance(each, (int, float)) for each in default)
        if not isinstance(default, (bool, int, float, str)) and not is_list:
            raise self.fault(cls, f"the default of the parameter '{name}' is {default!r}; expected a float, int, bool, str or a "
                             "list of floats", name)
        of_type = ("reals" if is_list else "file" if facts["file"] else
                   {bool: "boolean", int: "integer", float: "real"}.get(type(default), "text"))
        return {**facts, "name": name, "type": of_type, "default": [float(each) for each in default] if is_list else default}


_ALLOWED_OF_RANDOM = {"Random"}
_ALLOWED_OF_NUMPY = {"default_rng", "Generator", "RandomState", "SeedSequence", "PCG64", "MT19937", "Philox", "SFC64", "BitGenerator"}


def _refuse_shared_random(tree: ast.Module, file: Path) -> None:
    """Runs must repeat: random numbers come from the object's own stream, or from a generator with a seed."""
    modules: dict[str, set[str]] = {"numpy.random": _ALLOWED_OF_NUMPY, "np.random": _ALLOWED_OF_NUMPY}
    made: set[str] = set()

    def refuse(node: ast.AST, what: str) -> None:
        raise _Wrong(f"{file.name}:{getattr(node, 'lineno', 0)}: {what} gives other numbers in each run; draw from now.random, or "
                     "from numpy.random.default_rng(SEED)")

    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name == "random":
                    modules[alias.asname or alias.name] = _ALLOWED_OF_RANDOM
                elif alias.name == "numpy":
                    modules[(alias.asname or "numpy") + ".random"] = _ALLOWED_OF_NUMPY
                elif alias.name == "numpy.random" and alias.asname:
                    modules[alias.asname] = _ALLOWED_OF_NUMPY
        elif isinstance(node, ast.ImportFrom) and node.module == "numpy":
            modules.update({alias.asname or alias.name: _ALLOWED_OF_NUMPY for alias in node.names if alias.name == "random"})
        elif isinstance(node, ast.ImportFrom) and node.module in ("random", "numpy.random"):
            allowed = _ALLOWED_OF_RANDOM if node.module == "random" else _ALLOWED_OF_NUMPY
            for alias in node.names:
                if alias.name not in allowed:
                    refuse(node, f"{node.module}.{alias.name}")
                made.add(alias.asname or alias.name)
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            allowed_here = modules.get(ast.unparse(node.value))
            if allowed_here is not None and node.attr not in allowed_here:
                refuse(node, ast.unparse(node) + "()")
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and all(isinstance(seed, ast.Constant) and seed.value is None
                                              for seed in [*node.args, *(word.value for word in node.keywords)]):
            called = node.func
            if (isinstance(called, ast.Attribute) and ast.unparse(called.value) in modules or
                    isinstance(called, ast.Name) and called.id in made):
                refuse(node, ast.unparse(called) + "() without a seed")


def errors_of_numpy() -> tuple[dict[str, Any], Any]:
    """What numpy does about errors in this thread, for `take_errors`."""
    return dict(np.geterr()), np.geterrcall()


def take_errors(errors: dict[str, Any], call: Any) -> None:
    """Has numpy do the same in this thread: a new one would have numpy's own choice."""
    np.seterr(**errors)
    np.seterrcall(call)


_loaded = 0


def _load(path: str) -> list[dict[str, Any]]:
    """Runs a script as a module of its own, also if it was loaded before, and gives its declarations. For C++."""
    global _loaded
    file = Path(path)
    tree = ast.parse(file.read_bytes(), path)
    _refuse_shared_random(tree, file)
    _loaded += 1
    module = types.ModuleType(f"elsie_script_{_loaded}_{file.stem}")
    module.__file__ = path
    sys.modules[module.__name__] = module  # dataclasses look there
    before = errors_of_numpy()
    try:
        exec(compile(tree, path, "exec"), module.__dict__)
        # What the script sets holds for its own methods: in any thread, and nowhere else.
        errors, call = errors_of_numpy()
        errstate = functools.partial(np.errstate, call=call, **errors) if (errors, call) != before else None
        return [{**declared, "errstate": errstate} for declared in _Declarer(module, tree, file).all()]
    except BaseException:
        _unload(module.__name__)
        raise
    finally:
        take_errors(*before)


def _unload(module: str) -> None:
    sys.modules.pop(module, None)


def _fault(error: BaseException, path: str, function: Optional[str] = None) -> str:
    """What happened, with the line of the script that was at work: "orbit.py:12: ValueError: ..."."""
    if isinstance(error, _Wrong):
        return str(error)
    line = error.lineno or 0 if isinstance(error, SyntaxError) and error.filename == path else 0
    trace = error.__traceback__
    while trace is not None:
        if trace.tb_frame.f_code.co_filename == path:
            line = trace.tb_lineno
        trace = trace.tb_next
    try:
        text = str(error.msg) if isinstance(error, SyntaxError) else str(error)
    except Exception:  # noqa: BLE001: the script's own class of exceptions
        text = "its text cannot be made"
    if isinstance(error, KeyError) and error.args and isinstance(error.args[0], str):
        text = error.args[0]
    kind = "" if isinstance(error, InputError) else type(error).__name__ + (": " if text else "")
    return f"{Path(path).name}:{line}: {kind}{text}" if line else f"{Path(path).name}: {kind}{text}"


def _has_random_hashes() -> bool:
    """Whether sets of texts have another order in each process."""
    return sys.flags.hash_randomization != 0 and os.environ.get("PYTHONHASHSEED", "random") in ("", "random")


def _line_of(function: Any) -> int:
    """The line at which a method begins; 0: unknown."""
    code = getattr(getattr(function, "__func__", function), "__code__", None)
    return int(code.co_firstlineno) if code else 0
