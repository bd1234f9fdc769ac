"""Draws robots' ways over one world as SVG, with a panel for each, so that similar ways can be distinguished."""
import math
import xml.etree.ElementTree
from html import escape

# Okabe and Ito (2008): colours that can be distinguished with any colour vision. Results are also given in words.
SUCCESS, FAILURE = "#0072b2", "#d55e00"
OBSTACLE, RESOURCE, BORDER = "#a89c90", "#2e9e50", "#c8c8c8"
MARGIN = 0.5  # around resources and ways, m
TITLE = 38  # pixels above a panel: two lines
GAP = 16  # pixels between panels


def number(element, name, default):
    return float(element.get(name, default))


def corners(element):
    """The extent of a turned box, m."""
    x, y, angle = number(element, "x", 0), number(element, "y", 0), math.radians(number(element, "heading_deg", 0))
    for along, across in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        a, b = along * number(element, "length", 0.2) / 2, across * number(element, "width", 0.2) / 2
        yield x + a * math.cos(angle) - b * math.sin(angle), y + a * math.sin(angle) + b * math.cos(angle)


def thin_out(poses):
    """Drops poses that are within a centimetre of the last one that was kept."""
    kept = [poses[0]]
    for pose in poses[1:]:
        if math.hypot(pose[0] - kept[-1][0], pose[1] - kept[-1][1]) >= 0.01:
            kept.append(pose)
    return kept


class View:
    """Maps metres to pixels: y goes up in the world, down on the page."""

    def __init__(self, things, ways, width):
        xs = [number(e, "x", 0) for e in things] + [pose[0] for way in ways for pose in way[2]]
        ys = [number(e, "y", 0) for e in things] + [pose[1] for way in ways for pose in way[2]]
        self.left, self.top = min(xs) - MARGIN, max(ys) + MARGIN
        self.scale = width / (max(xs) + MARGIN - self.left)
        self.width, self.height = width, (self.top - min(ys) + MARGIN) * self.scale

    def pixel(self, x, y):
        return f"{(x - self.left) * self.scale:.1f},{(self.top - y) * self.scale:.1f}"

    def polygon(self, element, colour):
        return f'<polygon points="{" ".join(self.pixel(*corner) for corner in corners(element))}" fill="{colour}"/>'

    def circle(self, x, y, fill, stroke):
        cx, cy = self.pixel(x, y).split(",")
        return f'<circle cx="{cx}" cy="{cy}" r="5" fill="{fill}" stroke="{stroke}" stroke-width="2"/>'

    def bar(self):
        """A bar of one metre in the lower right corner."""
        right, y = self.width - 8, self.height - 8
        return (f'<path d="M {right - self.scale:.1f} {y - 4:.1f} v 4 h {self.scale:.1f} v -4" fill="none" stroke="#444444"/>'
                f'<text x="{right - self.scale / 2:.1f}" y="{y - 4:.1f}" text-anchor="middle" font-size="11" fill="#444444">1 m</text>')


def panel(view, things, success, poses):
    """A way with a small dot where it begins and a large one where it ends: full when it succeeded."""
    colour = SUCCESS if success else FAILURE
    out = [view.polygon(element, colour_of_it) for element, colour_of_it in things]
    points = " ".join(view.pixel(pose[0], pose[1]) for pose in thin_out(poses))
    out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>')
    out.append(view.circle(poses[0][0], poses[0][1], colour, colour).replace('r="5"', 'r="2"'))
    out.append(view.circle(poses[-1][0], poses[-1][1], colour if success else "#ffffff", colour))
    return out


def draw(world_text, ways, file, columns=2, width=440):
    """ways: (label, whether it succeeded, [[x_m, y_m, ...], ...]) for each run in the world, and what else its panel says; width: of a panel, pixels."""
    world = xml.etree.ElementTree.fromstring(world_text)
    things = [(e, OBSTACLE) for e in world.iter("static_box")] + [(e, RESOURCE) for e in world.iter("resource")]
    view = View(list(world.iter("resource")), ways, width)
    row = view.height + TITLE + GAP
    canvas = (columns * (width + GAP) + GAP, math.ceil(len(ways) / columns) * row + GAP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {canvas[0]:.0f} {canvas[1]:.0f}" width="{canvas[0]:.0f}" height="{canvas[1]:.0f}" '
           'font-family="sans-serif" font-size="12">',
           f'<rect width="{canvas[0]:.0f}" height="{canvas[1]:.0f}" fill="#ffffff"/>']
    for k, (label, success, poses, *said) in enumerate(ways):
        x, y = GAP + k % columns * (width + GAP), GAP + k // columns * row
        out.append(f'<text x="{x}" y="{y + TITLE - 22:.1f}">{escape(label)}</text>')
        out.append(f'<text x="{x}" y="{y + TITLE - 7:.1f}" font-size="11">{said[0] if said else "all collected" if success else "not all collected"}</text>')
        out.append(f'<rect x="{x}" y="{y + TITLE:.1f}" width="{width}" height="{view.height:.1f}" fill="none" stroke="{BORDER}"/>')
        # An inner svg clips what is beyond its borders.
        out.append(f'<svg x="{x}" y="{y + TITLE:.1f}" width="{width}" height="{view.height:.1f}">')
        out += panel(view, things, success, poses) + ([view.bar()] if k == 0 else [])
        out.append("</svg>")
    out.append("</svg>")
    file.write_text("\n".join(out) + "\n")
