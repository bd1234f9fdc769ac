"""Pictures of the deciding experiment as SVG: where each conclusion holds, what the unknowns do, and how long the paths are."""
import itertools
import math
from html import escape
from statistics import mean

from deciding import WHAT, cells, conclusions_of

# Okabe and Ito (2008): colours that can be distinguished with any colour vision.
YES, NO, UNKNOWN = "#0072b2", "#d55e00", "#d4d4d4"
SEARCH_COLOURS = {"left": "#0072b2", "right": "#d55e00", "last column": "#009e73", "last side": "#cc79a7"}
TEXT, LINE = "#222222", "#888888"
FACTOR_NAMES = {"avoidance": "avoidance model", "beams": "beams", "boxes": "boxes", "limit": "limit", "search": "search"}


class Canvas:
    """Elements of an SVG file; lengths in pixels, y downwards."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" height="{height:.0f}" '
                    f'font-family="sans-serif" font-size="12" fill="{TEXT}">', f'<rect width="{width:.0f}" height="{height:.0f}" fill="#ffffff"/>']

    def text(self, x, y, words, anchor="start", size=12, turn=0, weight="normal"):
        turned = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.out.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" font-weight="{weight}"{turned}>{escape(words)}</text>')

    def box(self, x, y, width, height, fill, stroke="none"):
        self.out.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{fill}" stroke="{stroke}"/>')

    def squares(self, corners, side, fill):
        """Many of one size and colour, by their upper left corners."""
        outline = "".join(f"M{x:g} {y:g}h{side}v{side}h-{side}z" for x, y in corners)
        self.out.append(f'<path d="{outline}" fill="{fill}"/>')

    def line(self, x1, y1, x2, y2, colour=LINE, width=1, dashes=""):
        dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.out.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" stroke-width="{width}"{dashed}/>')

    def dot(self, x, y, colour, radius=4, filled=True):
        self.out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour if filled else "#ffffff"}" stroke="{colour}" stroke-width="1.5" fill-opacity="{0.75 if filled else 1}"/>')

    def write(self, file):
        file.write_text("\n".join([*self.out, "</svg>"]) + "\n")


def holds_panel(canvas, x, y, study, holds, square):
    """A grid of set-ups: a row for each avoidance model, a column for each combination of the other unknowns."""
    rows = study.levels["avoidance"]
    others = [factor for factor in study.factors if factor != "avoidance"]
    columns = list(itertools.product(*(study.levels[factor] for factor in others)))
    corners = {YES: [], NO: [], UNKNOWN: []}
    for j, row in enumerate(rows):
        canvas.text(x - 6, y + (j + 0.75) * square, row, "end", 10)
        for i, column in enumerate(columns):
            setup = tuple({**dict(zip(others, column)), "avoidance": row}[factor] for factor in study.factors)
            value = holds(study, study.counts[setup])
            corners[UNKNOWN if value is None else YES if value else NO].append((x + i * square, y + j * square))
    for colour, places in corners.items():
        canvas.squares(places, square - 1, colour)
    width = len(columns) / len(study.levels["search"]) * square
    bottom = y + len(rows) * square
    for k, level in enumerate(study.levels["search"]):
        canvas.line(x + k * width, bottom + 2, x + (k + 1) * width - 2, bottom + 2)
        canvas.text(x + (k + 0.5) * width, bottom + 14, level, "middle", 9)


def where_it_holds(studies, file):
    """studies: [(title, study)]. A panel for each conclusion and study."""
    square, gap, left, top = 13, 58, 84, 96
    panels = [(f"{title}: {key}", words, study, holds) for title, study in studies for key, words, holds in conclusions_of(study)]
    wide = max(len(study.setups) / len(study.levels["avoidance"]) for _, study in studies) * square
    columns = 2
    height = max(len(study.levels["avoidance"]) for _, study in studies) * square + gap + 16
    canvas = Canvas(columns * (wide + left) + 24, top + -(-len(panels) // columns) * height)
    canvas.text(16, 24, "Where the original's conclusions hold", size=16, weight="bold")
    x = 16
    for colour, words in ((YES, "holds"), (NO, "does not hold"), (UNKNOWN, "cannot be judged: too few runs in which both succeed, or too few untrained networks")):
        canvas.box(x, 36, 12, 12, colour)
        canvas.text(x + 18, 46, words)
        x += 40 + 6.6 * len(words)
    canvas.text(16, 66, "Rows: avoidance models. Columns: the search, and within each of its levels " +
                ", ".join(FACTOR_NAMES[factor] for factor in studies[-1][1].factors if factor not in ("search", "avoidance")) + " in the order of the table of unknowns.", size=11)
    for k, (title, words, study, holds) in enumerate(panels):
        px, py = left + k % columns * (wide + left), top + k // columns * height + 16
        canvas.text(px, py - 22, title, weight="bold")
        holds_panel(canvas, px, py, study, holds, square)
        canvas.text(px, py - 8, words, size=11)
    canvas.write(file)


def effects_of_levels(studies, file):
    """studies: [(title, study)]. The success rates of both schemes with each level of each unknown, over all else."""
    row, left, width, gap, top = 17, 170, 300, 60, 88
    factors = list(dict.fromkeys(factor for _, study in studies for factor in study.factors))
    labels = {factor: list(dict.fromkeys(level for _, study in studies for level in study.levels.get(factor, []))) for factor in factors}
    height = sum(len(levels) * row + 26 for levels in labels.values())
    canvas = Canvas(left + len(studies) * (width + gap), top + height + 40)
    canvas.text(16, 24, "What the unknowns do to success", size=16, weight="bold")
    for k, (colour, words) in enumerate(((YES, "fusion"), (NO, "arbitration"))):
        canvas.dot(22 + 110 * k, 44, colour)
        canvas.text(32 + 110 * k, 48, words)
    for k, (title, study) in enumerate(studies):
        x, y = left + k * (width + gap), top
        canvas.text(x, y - 12, title, weight="bold")
        for part in range(0, 101, 25):
            canvas.line(x + part / 100 * width, y, x + part / 100 * width, y + height, "#e4e4e4")
            canvas.text(x + part / 100 * width, y + height + 16, f"{part} %", "middle", 11)
        canvas.text(x + width / 2, y + height + 34, "successful runs", "middle", 11)
        for factor in factors:
            y += 20
            if k == 0:
                canvas.text(16, y - 4, WHAT[factor], weight="bold")
            for level in labels[factor]:
                if k == 0:
                    canvas.text(left - 12, y + row * 0.7, level, "end", 11)
                if factor in study.factors:
                    setups = [setup for setup in study.setups if study.level(setup, factor) == level]
                    canvas.line(x, y + row / 2, x + width, y + row / 2, "#eeeeee")
                    for scheme, colour in (("fusion", YES), ("arbitration", NO)):
                        rate = mean(study.rate(study.counts[setup], scheme) for setup in setups)
                        canvas.dot(x + rate * width, y + row / 2, colour)
                elif level == labels[factor][0]:
                    canvas.text(x + width / 2, y + row, "there are none", "middle", 11)
                y += row
            y += 6
    canvas.write(file)


class LogAxes:
    """Two logarithmic axes of the same range."""

    def __init__(self, canvas, x, y, side, low, high):
        self.canvas, self.x, self.y, self.side, self.low, self.high = canvas, x, y, side, low, high

    def at(self, first, second):
        scale = self.side / math.log(self.high / self.low)
        return self.x + math.log(first / self.low) * scale, self.y + self.side - math.log(second / self.low) * scale

    def draw(self, ticks, first_label, second_label):
        self.canvas.box(self.x, self.y, self.side, self.side, "none", LINE)
        for tick in ticks:
            px, _ = self.at(tick, self.low)
            _, py = self.at(self.low, tick)
            self.canvas.line(px, self.y, px, self.y + self.side, "#eeeeee")
            self.canvas.line(self.x, py, self.x + self.side, py, "#eeeeee")
            self.canvas.text(px, self.y + self.side + 16, f"{tick}", "middle", 11)
            self.canvas.text(self.x - 6, py + 4, f"{tick}", "end", 11)
        self.canvas.text(self.x + self.side / 2, self.y + self.side + 36, first_label, "middle")
        self.canvas.text(self.x - 40, self.y + self.side / 2, second_label, "middle", turn=-90)

    def diagonal(self, ratio, words):
        """Where the second is this part of the first."""
        start, end = self.at(self.low / ratio, self.low), self.at(self.high, self.high * ratio)
        self.canvas.line(*start, *end, dashes="4 3")
        self.canvas.text(end[0] - 4, end[1] + 16, words, "end", 11)


def paths(panels, file):
    """panels: [(title, study, [(layers, name of the case, {scheme: m of the original})], range, ticks)]. A dot for each cell in which both schemes succeed often
    enough for a mean: full where each succeeds in at least half of its runs."""
    side, left, gap = 380, 70, 90
    canvas = Canvas(left + len(panels) * (side + gap), side + 160)
    canvas.text(16, 24, "Mean paths of the successful runs, m", size=16, weight="bold")
    for k, (level, colour) in enumerate(SEARCH_COLOURS.items()):
        canvas.dot(22 + 120 * k, 44, colour)
        canvas.text(32 + 120 * k, 48, level)
    canvas.text(32 + 120 * len(SEARCH_COLOURS), 48, "+ the original; full: both schemes succeed in half of their runs or more")
    for k, (title, study, cases, (low, high), ticks) in enumerate(panels):
        axes = LogAxes(canvas, left + k * (side + gap), 92, side, low, high)
        canvas.text(axes.x, axes.y - 10, title, weight="bold")
        axes.draw(ticks, "arbitration", "fusion")
        axes.diagonal(1, "equal")
        axes.diagonal(0.5, "half")
        for layers, _, _ in cases:
            for cell in cells(study, layers):
                canvas.dot(*axes.at(cell.path_m["arbitration"], cell.path_m["fusion"]), SEARCH_COLOURS[study.level(cell.setup, "search")], 3.5,
                           min(cell.rate.values()) >= 0.5)
        for number, (_, name, original) in enumerate(cases):
            px, py = axes.at(original["arbitration"], original["fusion"])
            canvas.line(px - 7, py, px + 7, py, "#000000", 2)
            canvas.line(px, py - 7, px, py + 7, "#000000", 2)
            canvas.text(px + 8, py - 6 if number % 2 else py + 16, name, weight="bold")
    canvas.write(file)
