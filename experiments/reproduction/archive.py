"""The published results, in docs/research/tables/: for each experiment a table of all its runs, NAME.csv.gz, and the builds that did them, builds.json.

The pages are written from these tables alone, so that the figures on them can be checked without a single run.
"""
import csv
import gzip
import io
import json

from results import Run, Runs

MEASURES = {"path_length_m": 3, "time_s": 2, "collected": 0, "collisions": 0}  # and their decimals
FIXED = ["seed", "outcome", *MEASURES, "state_hash", "training_error", "plateau", "robots"]
HASH_DIGITS = 8


def number(value, decimals):
    """As short as it can be: "2", not "2.000"."""
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def robots_as_text(robots):
    """"leader 0 0 0.1 0.2; ...": the start and the end of each."""
    return "; ".join(" ".join([robot, *(number(value, 3) for place in places for value in place)]) for robot, places in robots.items())


def robots_from_text(text):
    robots = {}
    for part in filter(None, text.split("; ")):
        robot, *values = part.split(" ")
        x0, y0, x1, y1 = map(float, values)
        robots[robot] = ((x0, y0), (x1, y1))
    return robots


def row_of(run, factors, with_robots):
    measures = {"path_length_m": run.path_m, "time_s": run.time_s, "collected": run.collected, "collisions": run.collisions}
    plateau = " ".join(map(repr, run.outputs)) or "yes" if run.flat else ""
    return [*(run.levels[factor] for factor in factors), run.seed, run.outcome, *(number(measures[name], digits) for name, digits in MEASURES.items()),
            run.state_hash[:HASH_DIGITS], "" if run.training_error is None else repr(run.training_error), plateau,
            robots_as_text(run.robots) if with_robots else ""]


def write(runs, file, with_robots=True):
    """The same runs give the same bytes. with_robots: whether it has where each robot began and ended."""
    factors = list(runs[0].levels)
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(factors + FIXED)
    table.writerows(row_of(run, factors, with_robots) for run in runs)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(gzip.compress(text.getvalue().encode(), 9, mtime=0))


def run_from(row):
    plateau = row["plateau"]
    outputs = tuple(float(output) for output in plateau.split()) if plateau not in ("", "yes") else ()
    return Run({name: value for name, value in row.items() if name not in FIXED}, int(row["seed"]), row["outcome"], {name: float(row[name]) for name in MEASURES},
               row["state_hash"], float(row["training_error"]) if row["training_error"] else None, plateau != "", outputs, robots_from_text(row["robots"]))


def builds(folder):
    """What is noted about each experiment's runs; nothing before the first archive."""
    file = folder / "builds.json"
    return json.loads(file.read_text()) if file.exists() else {}


def write_builds(folder, every):
    (folder / "builds.json").write_text(json.dumps(every, indent=2) + "\n")


def read(folder, name):
    """The runs of an experiment."""
    text = gzip.decompress((folder / f"{name}.csv.gz").read_bytes()).decode()
    return Runs([run_from(row) for row in csv.DictReader(io.StringIO(text))], builds(folder)[name])
