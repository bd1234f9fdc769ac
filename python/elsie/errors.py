"""What goes wrong: every error of Elsie is an `elsie.Error` with a sentence for the user."""
from __future__ import annotations

from typing import NamedTuple


class Problem(NamedTuple):
    """One mistake in a file."""

    file: str
    """As the user named it, or "--set PATH=VALUE"."""
    line: int
    """From 1; 0: the file as a whole."""
    sentence: str
    """What was found, what was expected."""

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.sentence}" if self.line else f"{self.file}: {self.sentence}"


class Error(Exception):
    """The base of all errors of Elsie. `exit_code` is that of the program `elsie` for the same."""

    exit_code: int = 4
    problems: tuple[Problem, ...] = ()
    """All mistakes of a file, each with its line."""


class InputError(Error, ValueError):
    """Input that cannot be used: a file, a path, a value."""


class WorldError(InputError):
    """A world file with mistakes: see `problems`."""


class ModelError(InputError):
    """A fuzzy model, a network or a training file with mistakes: see `problems`."""


class EditRefused(InputError):
    """An edit of a running world that cannot be made; nothing has changed."""


class PluginError(InputError):
    """A plugin that does not exist, or that failed while it was made."""


class PluginFault(Error):
    """A plugin failed during a run: it raised, answered nonsense or exceeded a limit."""

    plugin: str = ""
    id: str = ""
    robot: str = ""
    """Empty: a measure or a rule, which belong to the world."""
    step: int = 0
    place: str = ""
    """The line that raised, if it is known: "respond() at brake.cpp:12"."""


class PhysicsFault(Error):
    """The physics lost a body."""

    robot: str = ""
    step: int = 0
