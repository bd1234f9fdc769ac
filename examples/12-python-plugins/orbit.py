"""Circles around whatever comes near: a behaviour in Python."""
import elsie


class Orbit(elsie.Behavior):
    """Circles to the left, and matters more with something near."""

    # Parameters of the world file: their type and default are set only here.
    radius = elsie.parameter(0.5, unit="m", min=0.05, meaning="of the circle")
    speed = elsie.parameter(0.2, unit="m/s", min=0, max=2, meaning="along the circle")
    near = elsie.parameter(1.0, unit="m", above=0, meaning="what counts as near")

    # What it shows: a column of tables, a channel of recordings, a curve in the window.
    distance = elsie.published(unit="m", meaning="to the nearest thing")

    needs = ["range"]

    def respond(self, now: elsie.Now) -> elsie.Answer:
        self.distance = now.readings["range"].distance_m.min()
        activation = 1.0 if self.distance < self.near else 0.2
        return elsie.Motion(forward=self.speed, turn=self.speed / self.radius), activation
