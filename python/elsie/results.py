"""What a run came to."""
from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple, Optional

import numpy.typing as npt

from elsie import _elsie
from elsie.errors import InputError


class Event(NamedTuple):
    """Something that happened to a robot: "collision", "collected", an event of a plugin, an edit."""

    time_s: float
    robot: str
    name: str
    detail: str


class Note(NamedTuple):
    """A sentence for the user about a run, from a plugin, or from the simulator ("physics", "changes", "recording", "python")."""

    robot: str
    plugin: str
    text: str


class RobotResult(NamedTuple):
    """A robot at the end of its run."""

    id: str
    team: str
    distance_m: float
    """Of the path that it drove."""
    collected: int
    energy: float
    collisions: int
    pose: tuple[float, float, float]
    """x and y in m, heading in rad."""


@dataclass(frozen=True, repr=False)
class Result:
    """What a run came to, or has come to so far."""

    outcome: str
    """"success", "failure", "time_limit"; "running": it has not ended; "fault": it ended with an exception."""
    reason: str
    seed: int
    time_s: float
    """Simulated."""
    wall_s: float = field(compare=False)
    """On the clock."""
    steps: int
    state_hash: str
    """16 hexadecimal digits over the state of all bodies and batteries: the same in equal runs."""
    measures: dict[str, Optional[float]]
    """By name, as in `elsie run --json`; None: it has no value in this run."""
    units: dict[str, str]
    """Of the measures."""
    robots: list[RobotResult]
    events: list[Event]
    notes: list[Note]
    account: Optional[_elsie.Account] = field(default=None, compare=False)

    @property
    def success(self) -> bool:
        """Whether all goals were reached."""
        return self.outcome == "success"

    def trace(self, robot: Optional[str] = None, inside: str = "") -> npt.NDArray[Any]:
        """Who decided when: a structured array with a row for each episode, in order, without gaps.

        Fields: from_s, to_s, decider (the path of a behaviour; "": nobody, "*": several alike), its mean share in the
        command and mean weight, and the reason that the coordinator gave. robot: its id; None: the first one. inside: the
        path of a behaviour that holds others.
        """
        account = self._account()
        return account.episodes(self.robots[0].id if robot is None else robot, inside)

    def behaviors(self, robot: Optional[str] = None) -> npt.NDArray[Any]:
        """The sums of each behaviour of a robot: path, decided_s, longest_s, asked_s, periods, and means over time of share,
        robot_share, weight, activation and strength."""
        account = self._account()
        return account.behaviors(self.robots[0].id if robot is None else robot)

    def _account(self) -> _elsie.Account:
        if self.account is None:
            raise InputError("this result has no trace: it needs Simulation(..., watch=True), and the end of the run")
        if not self.robots:
            raise InputError("there is no robot in this run")
        return self.account

    def __getstate__(self) -> dict[str, Any]:
        """For pickle: all but the trace."""
        return {**self.__dict__, "account": None}

    def __repr__(self) -> str:
        return f"<elsie.Result: {self}>"

    def __str__(self) -> str:
        return f"{self.outcome} after {self.time_s:.1f} s: {self.reason}"


def result_of(fields: dict[str, Any], notes: list[Note], account: Optional[_elsie.Account]) -> Result:
    """A result from what the extension module gives."""
    more: dict[str, Any] = {"robots": [RobotResult(*each) for each in fields["robots"]],
            "events": [Event(*each) for each in fields["events"]],
            "notes": [Note(*each) for each in fields["notes"]] + notes}
    return Result(**{**fields, **more}, account=account)
