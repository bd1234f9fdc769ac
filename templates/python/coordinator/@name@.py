"""@name@: how it decides, in a sentence."""
import elsie


class @Class@(elsie.Coordinator):
    """The most active behaviour drives."""

    # A parameter of the world file. Its default is set only here.
    margin = elsie.parameter(0.1, min=0, max=1, meaning="how much more active another one must be")

    def reset(self, random):
        self.winner = 0

    def coordinate(self, members, now):
        if not members:
            return elsie.Motion()
        if self.winner >= len(members):
            self.winner = 0
        # respond() runs the behaviour at most once in a step. Another one must be clearly more active than the one that
        # drives now.
        answers = [member.respond() for member in members]
        for i, answer in enumerate(answers):
            if answer.activation > answers[self.winner].activation + self.margin:
                self.winner = i
        for member in members:
            member.reason = "less active"
        winner = members[self.winner]
        winner.weight = winner.share = 1.0
        winner.reason = "most active"
        return answers[self.winner].motion
