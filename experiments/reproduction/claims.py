"""Compares the figures in a page's prose with the databases, and reports differences."""
import re

UNITS = ["none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen",
         "sixteen", "seventeen", "eighteen", "nineteen", "twenty"]
ORDINALS = ["", "", "half", "third", "quarter", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth", "eleventh", "twelfth", "thirteenth", "fourteenth",
            "fifteenth", "sixteenth", "seventeenth", "eighteenth", "nineteenth"]


def in_words(count):
    """"two" for 2; figures beyond twenty."""
    return UNITS[count] if 0 <= count < len(UNITS) else str(count)


def one_part(value):
    """"a thirteenth" for 1 / 13.3, "half" for 0.49."""
    parts = round(1 / value)
    if parts == 2:
        return "half"
    if 20 <= parts < 30:
        ordinal = "twentieth" if parts == 20 else "twenty-" + (["", "first", "second"] + ORDINALS[3:])[parts - 20].replace("quarter", "fourth")
    else:
        ordinal = ORDINALS[parts]
    return ("an " if ordinal[0] in "aeiou" else "a ") + ordinal


def quarters(value):
    """"three quarters" for 0.73."""
    return {1: "a quarter", 2: "half", 3: "three quarters"}[round(4 * value)]


def about(value, expected, tolerance):
    """Whether a value agrees with a round figure in the prose."""
    return abs(value - expected) <= tolerance


class Claim:
    """A statement of a page's prose. The sentence has {} for each of the computed values; the page has them as they are
    formatted here, so that the rounding is the tolerance. A statement without figures is true or false."""

    def __init__(self, page, sentence, *values, holds=True):
        self.page, self.holds = page, holds
        self.sentence = " ".join(sentence.format(*values).split())


def prose(text):
    """A page without its generated parts, with one blank for each space."""
    text = re.sub(r"<!-- (?P<name>[^>]*) -->\n.*?<!-- end of (?P=name) -->\n", "", text, flags=re.S)
    return " ".join(text.split())


def problems(pages, claims):
    """The differences as sentences. pages: the text of each by its name."""
    told = {name: prose(text) for name, text in pages.items()}
    found = []
    for claim in claims:
        if claim.sentence not in told[claim.page]:
            found.append(f"docs/research/{claim.page} does not match the databases, which give \"{claim.sentence}\": correct the page, or "
                         "experiments/reproduction/statements.py if the page says it in other words")
        elif not claim.holds:
            found.append(f"docs/research/{claim.page} says \"{claim.sentence}\", and the databases say otherwise: correct the page and experiments/reproduction/statements.py")
    return found
