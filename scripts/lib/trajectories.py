"""Draws many robots' ways over one world, as SVG."""
import math
import xml.etree.ElementTree
from html import escape

# Okabe and Ito (2008): colours that are told apart with any colour vision; dashes tell the second round of them from the first.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"]
SCALE = 100  # pixels a metre
MARGIN = 0.3  # around what is drawn, m
LINE = 20  # of the legend, pixels


def number(element, name, default):
    return float(element.get(name, default))


def box(element, colour, x0, y1):
    x, y, angle = number(element, "x", 0), number(element, "y", 0), math.radians(number(element, "heading_deg", 0))
    corners = []
    for along, across in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        a, b = along * number(element, "length", 0.2) / 2, across * number(element, "width", 0.2) / 2
        corners.append((x + a * math.cos(angle) - b * math.sin(angle), y + a * math.sin(angle) + b * math.cos(angle)))
    points = " ".join(f"{(cx - x0) * SCALE:.1f},{(y1 - cy) * SCALE:.1f}" for cx, cy in corners)
    return f'<polygon points="{points}" fill="{colour}"/>'


def thin_out(poses):
    """Drops poses that are within a centimetre of the last one that was kept."""
    kept = [poses[0]]
    for pose in poses[1:]:
        if math.hypot(pose[0] - kept[-1][0], pose[1] - kept[-1][1]) >= 0.01:
            kept.append(pose)
    return kept


def draw(world_text, ways, file):
    """ways: (label, whether it succeeded, [[x_m, y_m, ...], ...]) for each run in the world."""
    world = xml.etree.ElementTree.fromstring(world_text)
    obstacles, resources = list(world.iter("static_box")), list(world.iter("resource"))
    things = obstacles + resources
    xs = [number(e, "x", 0) for e in things] + [pose[0] for _, _, poses in ways for pose in poses]
    ys = [number(e, "y", 0) for e in things] + [pose[1] for _, _, poses in ways for pose in poses]
    x0, x1 = min(xs) - MARGIN, max(xs) + MARGIN
    y0, y1 = min(ys) - MARGIN, max(ys) + MARGIN
    width, height = (x1 - x0) * SCALE, (y1 - y0) * SCALE
    canvas = max(width, 460)
    total = height + LINE * (len(ways) + 1)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {canvas:.0f} {total:.0f}" width="{canvas:.0f}" height="{total:.0f}" '
           'font-family="sans-serif" font-size="13">',
           f'<rect width="{canvas:.0f}" height="{total:.0f}" fill="#ffffff"/>']
    out += [box(e, "#a89c90", x0, y1) for e in obstacles]
    out += [box(e, "#2e9e50", x0, y1) for e in resources]
    for k, (label, success, poses) in enumerate(ways):
        colour = COLOURS[k % len(COLOURS)]
        dash = ' stroke-dasharray="6 4"' if k >= len(COLOURS) else ""
        poses = thin_out(poses)
        points = " ".join(f"{(p[0] - x0) * SCALE:.0f},{(y1 - p[1]) * SCALE:.0f}" for p in poses)
        out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2" stroke-opacity="0.8"{dash}/>')
        x, y = (poses[-1][0] - x0) * SCALE, (y1 - poses[-1][1]) * SCALE
        out.append(f'<circle cx="{x:.0f}" cy="{y:.0f}" r="5" fill="{colour if success else "#ffffff"}" stroke="{colour}" stroke-width="2"/>')
        line = height + LINE * (k + 1)
        out.append(f'<line x1="10" y1="{line - 4:.0f}" x2="50" y2="{line - 4:.0f}" stroke="{colour}" stroke-width="2"{dash}/>')
        out.append(f'<text x="58" y="{line:.0f}">{escape(label)}{"" if success else ": not all collected"}</text>')
    out.append("</svg>")
    file.write_text("\n".join(out) + "\n")
