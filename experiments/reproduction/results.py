"""Reads databases of results of elsie batch (docs/results-database.md), and summarizes them in a few words."""
import json
import re
import sqlite3
import sys
from statistics import mean, stdev

LEARNED_BELOW = 1e-3  # mean error of a network that has learned all nine samples; with one sample missed it is above 0.01


class Run:
    """One run. robots: {id: ((x_m, y_m) at the start, (x_m, y_m) at the end)}; outputs: what a network on a plateau answers to everything, or ()."""

    def __init__(self, levels, seed, outcome, measures, state_hash="", error=None, flat=False, outputs=(), robots=None):
        self.levels, self.seed, self.outcome, self.state_hash = levels, seed, outcome, state_hash
        self.path_m = measures["path_length_m"]
        self.time_s = measures["time_s"]
        self.collected = measures["collected"]
        self.collisions = measures["collisions"]
        self.success = outcome == "success"
        self.training_error, self.flat, self.outputs = error, flat, outputs
        self.robots = robots or {}

    def error(self):
        """The mean error with which its network's training ended; None without a network."""
        return self.training_error

    def learned(self):
        return self.training_error is not None and self.training_error < LEARNED_BELOW


class Runs:
    """The runs of an experiment, and the build that did them: {"elsie", "libelsie", "fingerprint"}."""

    def __init__(self, runs, build):
        self.runs, self.build = runs, build

    def of(self, **wanted):
        """The runs of the cells with these levels."""
        found = [run for run in self.runs if all(run.levels[factor] == level for factor, level in wanted.items())]
        assert found, wanted
        return found

    def levels(self, factor):
        return list(dict.fromkeys(run.levels[factor] for run in self.runs))

    def by_scheme(self, **wanted):
        """The runs of these cells with fusion, and those with arbitration."""
        return self.of(coordinator="fusion", **wanted), self.of(coordinator="arbitration", **wanted)

    def seeds(self):
        return sorted({run.seed for run in self.runs})


def what_notes_say(notes):
    """Of a run's notes: the error with which training ended, whether the network is on a plateau, and its outputs there."""
    text = "\n".join(notes)
    error = re.search(r"mean error (\S+) after", text)
    outputs = re.search(r"whatever the input, \((\S+), (\S+)\)", text)
    return (float(error.group(1)) if error else None, "sits on a plateau" in text,
            tuple(float(output) for output in outputs.groups()) if outputs else ())


def is_done(file):
    """Whether there is such a database, and all of its runs are done."""
    if not file.exists():
        return False
    database = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    states = [state for state, in database.execute("SELECT DISTINCT state FROM runs")]
    database.close()
    return states == ["done"]


class Results(Runs):
    """The runs of a database, all of which must be done. With them come the trajectories."""

    def __init__(self, file):
        if not file.exists():
            sys.exit(f"experiments/reproduction/tables: there is no {file}; run without --no-runs")
        self.file = file
        self.database = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
        ask = self.database.execute
        program = ask("SELECT sha256 FROM files WHERE kind = 'library' ORDER BY id LIMIT 1").fetchone() or ["unknown"]
        version, fingerprint = ask("SELECT elsie_version, fingerprint FROM about").fetchone()
        states = dict(ask("SELECT state, count(*) FROM runs GROUP BY state"))
        if set(states) != {"done"}:
            sys.exit(f"experiments/reproduction/tables: {file} has runs that are not done: {states}; run without --no-runs")
        levels, measures, notes, robots = {}, {}, {}, {}
        for cell, factor, label in ask(
                "SELECT cell_id, name, label FROM cell_levels JOIN factors ON factors.id = factor_id"):
            levels.setdefault(cell, {})[factor] = label
        for run, measure, value in ask("SELECT run_id, measure, value FROM run_measures"):
            measures.setdefault(run, {})[measure] = value
        for run, text in ask("SELECT run_id, text FROM notes ORDER BY place"):
            notes.setdefault(run, []).append(text)
        for run, robot, x, y, poses in ask("SELECT run_id, robot, x_m, y_m, poses FROM run_robots JOIN trajectories USING (run_id, robot) ORDER BY robot"):
            robots.setdefault(run, {})[robot] = (tuple(json.loads(poses)[0][:2]), (x, y))
        runs = []
        for run, cell, seed, outcome, state_hash in ask("SELECT id, cell_id, seed, outcome, state_hash FROM runs ORDER BY id"):
            runs.append(Run(levels[cell], seed, outcome, measures[run], state_hash, *what_notes_say(notes.get(run, [])), robots.get(run)))
            runs[-1].id, runs[-1].cell = run, cell
        super().__init__(runs, {"elsie": version, "libelsie": program[0], "fingerprint": fingerprint})

    def poses(self, run, robot):
        """The way of a robot: [[x_m, y_m, heading_rad], ...]."""
        row = self.database.execute(
            "SELECT poses FROM trajectories WHERE run_id = ? AND robot = ?", (run.id, robot)).fetchone()
        return json.loads(row[0])

    def world(self, run):
        return self.database.execute("SELECT world_text FROM cells WHERE id = ?", (run.cell,)).fetchone()[0]


def spread(values, digits):
    """Mean +- standard deviation (least to largest); one value for all when there is no spread."""
    values = list(values)
    if not values:
        return "-"
    if len(values) == 1 or max(values) - min(values) < 0.5 * 10 ** -digits:
        return f"{mean(values):.{digits}f}"
    return (f"{mean(values):.{digits}f} +- {stdev(values):.{digits}f}"
            f" ({min(values):.{digits}f} to {max(values):.{digits}f})")


def short_spread(values, digits):
    return spread(values, digits).split(" (")[0]


def of(part, whole):
    return f"{part} of {whole}"


def successes(runs):
    return [run for run in runs if run.success]


def share(runs):
    return of(len(successes(runs)), len(runs))


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)
