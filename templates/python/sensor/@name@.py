"""@name@: what it senses, in a sentence; and a behaviour that reads it. A sensor alone needs no behaviour: remove it here and in the world."""
import math

import elsie


class @Class@(elsie.Sensor):
    """Sees how bright a lamp is."""

    # Parameters of the world file. Their defaults are set only here.
    lamp_x = elsie.parameter(0.0, unit="m", min=-1000, max=1000, meaning="position of the lamp")
    lamp_y = elsie.parameter(0.0, unit="m", min=-1000, max=1000, meaning="position of the lamp")
    error = elsie.parameter(0.0, min=0, max=1, meaning="standard deviation of the noise, relative to the brightness")

    # A kind of reading of its own, with the units of its numbers.
    reading = elsie.reading("@name@", brightness="")

    # Called in every control period. `now.ray()` asks the world; help(elsie.SensorNow) lists what else there is.
    def sense(self, now):
        x, y, _ = now.place  # of the sensor in the world
        distance = math.hypot(self.lamp_x - x, self.lamp_y - y)
        noise = self.error * now.random.normal() if self.error > 0 else 0.0
        return {"brightness": (1.0 + noise) / (1.0 + distance * distance)}

    # What pictures, recordings and the window draw of it.
    def sketch(self, sketch):
        sketch.in_world()
        sketch.point("hit", (self.lamp_x, self.lamp_y))


class Seek@Class@(elsie.Behavior):
    """Turns to the side that is brighter."""  # Braitenberg's vehicle 2b

    speed = elsie.parameter(0.2, unit="m/s", min=0, max=5, meaning="speed")
    gain = elsie.parameter(100.0, unit="rad/s", min=0, max=1000, meaning="turn rate if only one side sees light")
    needs = ["@name@"]

    def respond(self, now):
        eyes = now.readings["@name@"]
        left = eyes.brightness[eyes.azimuth_rad > 0].sum()
        right = eyes.brightness[eyes.azimuth_rad <= 0].sum()
        return elsie.Motion(forward=self.speed, turn=self.gain * (left - right) / (left + right + 1e-9))
