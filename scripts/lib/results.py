"""Reads databases of results of elsie batch (docs/results-database.md), and summarizes them in a few words."""
import json
import re
import sqlite3
import sys
from statistics import mean, stdev

LEARNED_BELOW = 1e-3  # mean error of a network that has learned all nine samples; with one sample missed it is above 0.01


class Run:
    """One run of a database."""

    def __init__(self, row, levels, measures, notes):
        self.id, self.cell, self.seed, self.outcome, self.state_hash = row
        self.levels, self.notes = levels, notes
        self.path_m = measures["path_length_m"]
        self.time_s = measures["time_s"]
        self.collected = measures["collected"]
        self.collisions = measures["collisions"]
        self.success = self.outcome == "success"

    def error(self):
        """The mean error with which its network's training ended; None without a network."""
        for note in self.notes:
            found = re.search(r"mean error (\S+) after", note)
            if found:
                return float(found.group(1))
        return None

    def learned(self):
        return self.error() is not None and self.error() < LEARNED_BELOW


class Results:
    """The runs of an experiment that are done."""

    def __init__(self, file):
        if not file.exists():
            sys.exit(f"scripts/tables: there is no {file}; run without --no-runs")
        self.file = file
        self.database = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
        ask = self.database.execute
        self.version = ask("SELECT elsie_version FROM about").fetchone()[0]
        self.program = (ask("SELECT sha256 FROM files WHERE kind = 'library' ORDER BY id LIMIT 1").fetchone() or ["unknown"])[0]
        states = dict(ask("SELECT state, count(*) FROM runs GROUP BY state"))
        if set(states) != {"done"}:
            sys.exit(f"scripts/tables: {file} has runs that are not done: {states}; run without --no-runs")
        levels, measures, notes = {}, {}, {}
        for cell, factor, label in ask(
                "SELECT cell_id, name, label FROM cell_levels JOIN factors ON factors.id = factor_id"):
            levels.setdefault(cell, {})[factor] = label
        for run, measure, value in ask("SELECT run_id, measure, value FROM run_measures"):
            measures.setdefault(run, {})[measure] = value
        for run, text in ask("SELECT run_id, text FROM notes ORDER BY place"):
            notes.setdefault(run, []).append(text)
        self.runs = [Run(row, levels[row[1]], measures[row[0]], notes.get(row[0], []))
                     for row in ask("SELECT id, cell_id, seed, outcome, state_hash FROM runs ORDER BY id")]

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

    def poses(self, run, robot):
        """The way of a robot: [[x_m, y_m, heading_rad], ...]."""
        row = self.database.execute(
            "SELECT poses FROM trajectories WHERE run_id = ? AND robot = ?", (run.id, robot)).fetchone()
        return json.loads(row[0])

    def robots(self, run):
        return [robot for robot, in self.database.execute("SELECT robot FROM run_robots WHERE run_id = ? ORDER BY robot", (run.id,))]

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
