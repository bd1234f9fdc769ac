"""Worlds: reading, checking, editing and saving them."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Union

from elsie import _elsie
from elsie.errors import Problem

Value = Union[str, bool, int, float]
"""A value of an attribute, or the text of an element: "<wander/>"."""
File = Union[str, "os.PathLike[str]"]


class Paths:
    """What `World` and `Simulation` have in common: attributes and elements by the paths of `elsie run --set`.

    "robot[r1]/@max_speed" is an attribute, "robot[r1]/coordinator" an element; docs/worlds.md lists the forms of paths.
    """

    def _value(self, path: str) -> Any:
        raise NotImplementedError

    def _edit_all(self, edits: list[tuple[str, Value]]) -> None:
        raise NotImplementedError

    def __getitem__(self, path: str) -> Any:
        """The value of an attribute: a float, int, bool, str, or None if it has none. A list if the path leads to several."""
        return self._value(path)

    def __setitem__(self, path: str, value: Value) -> None:
        """Sets an attribute, or replaces an element by the text of another one."""
        self._edit_all([(path, value)])

    def __delitem__(self, path: str) -> None:
        """Removes an element, or an attribute, which then has its default."""
        self._edit_all([(path + "/@remove", True)])

    def edit(self, edits: Mapping[str, Value]) -> None:
        """Makes several edits together, or none if one is refused. Values that depend on each other need this."""
        self._edit_all(list(edits.items()))

    def add(self, where: str, element: str) -> None:
        """Adds an element at the end of a list: add("robots", '<robot id="r9" x="1"/>'), add("robot[r1]/sensors", "<lidar/>")."""
        self._edit_all([(_elsie.path_of_new(where), element)])


class World(_elsie.World, Paths):
    """A world: the text of its file, which edits change only where they must, and the plugins that it names.

        world = elsie.World("worlds/clutter.xml")
        world["robot[r1]/@max_speed"] = 0.3
        world.add("obstacles", '<static_box x="1" y="0.5"/>')
        world.save("slower.xml")

    Every edit is checked as a file is. All mistakes are in one `elsie.WorldError`, each with its line.
    """

    def __init__(self, file: File, *, plugins: Sequence[File] = ()) -> None:
        """Reads a file, or the shipped world of this name.

        plugins: folders, libraries (.so), sources (.cpp, which are compiled) and scripts (.py) that are searched first.
        """
        self._plugins = [os.fspath(each) for each in plugins]
        _elsie.World.__init__(self, None, os.fspath(file), self._plugins)

    @classmethod
    def parse(cls, text: str, *, file: File = "world.xml", plugins: Sequence[File] = ()) -> World:
        """The world of a text. `file`: its name in messages; other files are searched in the folder of that name first."""
        world = cls.__new__(cls)
        world._plugins = [os.fspath(each) for each in plugins]
        _elsie.World.__init__(world, text, os.fspath(file), world._plugins)
        return world

    def copy(self) -> World:
        """The same world, to be edited apart."""
        world = World.__new__(World)
        world._plugins = self._plugins
        _elsie.World.__init__(world, self)
        return world

    __copy__ = copy

    def __deepcopy__(self, _: object) -> World:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        """For pickle: another process reads the text again, with the same plugins."""
        return _restored, (self.text, self.file, self._plugins)

    def check(self) -> list[Problem]:
        """What is allowed but doubtful: settings that the physics may not simulate well, edits that are never made.

        Raises `elsie.WorldError` for what only shows when the world's objects are made.
        """
        return [Problem(*each) for each in self._warnings()]

    def save(self, file: File) -> None:
        """Writes the text. Comments and blanks are those of the file; names of other files lead to the same ones from there."""
        self._save_as(os.fspath(file))

    def picture(self, file: File, *, width: int = 1000) -> None:
        """Draws the world at its start, from above, as a .png or .svg; `width` in pixels."""
        _elsie.save_world(self, os.fspath(file), width)

    def __str__(self) -> str:
        """The text of the file."""
        return self.text

    def __repr__(self) -> str:
        return f"<elsie.World {self.name!r}, {len(self.robots)} robots>"

    def _repr_svg_(self) -> str:
        return _elsie.svg_of_world(self, 700)


def _restored(text: str, file: str, plugins: list[str]) -> World:
    return World.parse(text, file=file, plugins=plugins)
