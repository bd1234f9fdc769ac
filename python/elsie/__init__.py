"""Elsie: behaviour-based mobile robot control.

    import elsie
    world = elsie.World("worlds/clutter.xml")
    run = elsie.Simulation(world, seed=7)
    run.run()
"""
from elsie.errors import (EditRefused, Error, InputError, ModelError, PhysicsFault, PluginError, PluginFault, Problem, WorldError)

__all__ = ["EditRefused", "Error", "InputError", "ModelError", "PhysicsFault", "PluginError", "PluginFault", "Problem", "WorldError"]
