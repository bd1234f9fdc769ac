"""@name@: what it changes, in a sentence."""
import elsie


class @Class@(elsie.Rule):
    """Fills the battery of a robot that is nearly empty."""

    # Parameters of the world file. Their defaults are set only here.
    robot = elsie.parameter("r1", meaning="id of the robot")
    below = elsie.parameter(2.0, unit="units", min=0, meaning="what counts as nearly empty")

    filled = elsie.published(meaning="how often it did so")
    raises = {"filled": "the battery of the robot was filled"}

    # Called before the first run: raises if there is no such robot.
    def equipped(self, start):
        start.robot(self.robot)

    def reset(self, random):
        self.filled = 0

    # The world at the start, then after every step. Robots may come and go: they are looked for by their ids.
    def apply(self, now, world):
        for robot in now.robots:
            if robot.id == self.robot and robot.energy < self.below:
                world.set(f"robot[{self.robot}]/@energy", robot.capacity)  # before the next step
                world.raise_event("filled", self.robot)
                self.filled += 1
