"""@name@: what it measures, in a sentence."""
import math

import elsie


class @Class@(elsie.Measure):
    """How far a robot went from where it started."""

    # Parameters of the world file. Their defaults are set only here.
    robot = elsie.parameter("r1", meaning="id of the robot")

    # What it reports. A value with an empty name has the measure's name.
    quantities = {"": ("m", "largest distance from where the robot started"), "at_s": ("s", "when it was there")}

    # Called before the first run: raises if there is no such robot.
    def equipped(self, start):
        start.robot(self.robot)

    def reset(self, random):
        self.start = None
        self.farthest = 0.0  # m
        self.at_s = 0.0

    # The world at the start, then after every step.
    def observe(self, now):
        pose = now.robot(self.robot).pose
        if self.start is None:
            self.start = (pose.x, pose.y)
        distance = math.hypot(pose.x - self.start[0], pose.y - self.start[1])
        if distance > self.farthest:
            self.farthest = distance
            self.at_s = now.time

    # A value that is left out is missing.
    def report(self, end):
        return {"": self.farthest, "at_s": self.at_s} if self.start else {}
