"""A learning curve as CSV, and as a picture: by matplotlib if it is installed, else a plain SVG."""
from collections.abc import Sequence

Curve = Sequence[tuple[float, float]]


def draw(curve: Curve, name: str) -> None:
    with open(f"{name}.csv", "w", encoding="utf-8") as table:
        table.write("generation,mean,best\n")
        table.writelines(f"{i + 1},{mean!r},{best!r}\n" for i, (mean, best) in enumerate(curve))
    try:
        from matplotlib.figure import Figure
    except ImportError:
        return plain(curve, f"{name}.svg")
    figure = Figure(figsize=(6, 4))
    axes = figure.add_subplot(xlabel="generation", ylabel="earned in an episode")
    for column, label in enumerate(["mean of the candidates", "best candidate"]):
        axes.plot(range(1, len(curve) + 1), [row[column] for row in curve], marker="o", label=label)
    axes.legend()
    figure.savefig(f"{name}.svg")


def plain(curve: Curve, file: str) -> None:
    low, high = min(min(row) for row in curve), max(max(row) for row in curve)

    def line(column: int, colour: str) -> str:
        points = " ".join(f"{60 + 500 * i / max(1, len(curve) - 1):.1f},{340 - 300 * (row[column] - low) / ((high - low) or 1):.1f}"
                          for i, row in enumerate(curve))
        return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>'
    with open(file, "w", encoding="utf-8") as picture:
        picture.write('<svg xmlns="http://www.w3.org/2000/svg" width="600" height="400" font-family="sans-serif" font-size="12">'
                      '<rect width="600" height="400" fill="white"/><path d="M60,40V340H560" fill="none" stroke="black"/>'
                      f'<text x="5" y="45">{high:.2f}</text><text x="5" y="345">{low:.2f}</text>'
                      f'<text x="55" y="360">1</text><text x="550" y="360">{len(curve)}</text>'
                      '<text x="270" y="380">generation</text><text x="70" y="35" fill="#1f77b4">mean</text>'
                      f'<text x="120" y="35" fill="#d62728">best</text>{line(0, "#1f77b4")}{line(1, "#d62728")}</svg>\n')
