"""@name@: what it does, in a sentence; and a behaviour that commands it. An actuator alone needs no behaviour: remove it here and in the world."""
import elsie


class @Class@(elsie.Actuator):
    """Shines while it is on."""

    # Parameters of the world file. Their defaults are set only here.
    intensity = elsie.parameter(0.5, above=0, max=1000, meaning="as that of a lamp of the world")

    # A kind of command of its own, with the units of its numbers.
    command = elsie.command("@name@", on="")

    # Called in every control period with the command that holds. help(elsie.ActuatorNow) lists what an actuator can do.
    def act(self, command, now):
        if command.on > 0.5:
            now.shine(255, 200, 0, self.intensity)


class Use@Class@(elsie.Behavior):
    """Switches it on and off."""

    period = elsie.parameter(1.0, unit="s", above=0, max=1000, meaning="from on to on")
    commands = ["@name@"]
    only_acts = True  # it never moves the robot

    def respond(self, now):
        return elsie.Response().act("@name@", on=float(now.time % self.period < 0.5 * self.period))
