"""Elsie: behaviour-based mobile robot control.

    import elsie
    world = elsie.World("worlds/clutter.xml")
    run = elsie.Simulation(world, seed=7)
    run.step(100)
    print(run.poses)
    print(run.run())

`World` reads, checks and edits; `Simulation` makes steps; `Result` is what a run came to. `run` and `batch` make many,
as frames of pandas. `Fuzzy` and `Network` need no simulation. docs/python.md is the guide.
"""
from elsie import _elsie
from elsie.environments import Env
from elsie.errors import (EditRefused, Error, InputError, ModelError, PhysicsFault, PluginError, PluginFault, Problem, WorldError)
from elsie.inference import Fuzzy, Network, Training, Variable
from elsie.parallel import ParallelEnv
from elsie.plugins import (Actuator, ActuatorNow, Answer, Behavior, Coordinator, Measure, Member, Motion, Now, Pose, Random, Readings,
                           Response, Rule, Sensor, SensorNow, Sketch, Status, WorldChanges, WorldNow, array, command, message,
                           parameter, published, reading)
from elsie.plots import plot
from elsie.registry import make, make_vec
from elsie.results import Event, Note, Result, RobotResult
from elsie.simulations import Simulation, same_bits
from elsie.studies import Results, batch, program, run
from elsie.vector import AutoresetMode, VectorEnv
from elsie.worlds import World

__version__: str = _elsie.version

__all__ = [
    "AutoresetMode", "EditRefused", "Env", "Error", "Event", "Fuzzy", "InputError", "ModelError", "Network", "Note", "ParallelEnv",
    "PhysicsFault", "PluginError", "PluginFault", "Problem", "Result", "Results", "RobotResult", "Simulation", "Training", "Variable",
    "VectorEnv", "World", "WorldError", "batch", "make", "make_vec", "plot", "program", "run", "same_bits",
    # Of plugins.
    "Actuator", "ActuatorNow", "Answer", "Behavior", "Coordinator", "Measure", "Member", "Motion", "Now", "Pose", "Random", "Readings",
    "Response", "Rule", "Sensor", "SensorNow", "Sketch", "Status", "WorldChanges", "WorldNow", "array", "command", "message",
    "parameter", "published", "reading",
]
