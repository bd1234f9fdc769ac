"""@name@: what it does, in a sentence."""
import elsie


class @Class@(elsie.Behavior):
    """Drives on, and stops in front of obstacles."""

    # Parameters of the world file. Their defaults are set only here.
    speed = elsie.parameter(0.2, unit="m/s", min=0, max=5, meaning="speed when all is clear")
    distance = elsie.parameter(0.5, unit="m", above=0, max=100, meaning="it slows down for obstacles nearer than this")

    # What it shows: a column of tables, a channel of recordings, a curve in the window.
    nearest = elsie.published(unit="m", meaning="to the nearest obstacle that it minds")

    needs = ["range"]

    def respond(self, now):
        # An array with a number for each range sensor.
        self.nearest = min(self.distance, now.readings["range"].distance_m.min())
        # Slower with nearness; at half the distance it stands still.
        forward = self.speed * max(0.0, 2.0 * self.nearest / self.distance - 1.0)
        # The motion, and the activation, which grows with nearness.
        return elsie.Motion(forward=forward), 1.0 - self.nearest / self.distance
