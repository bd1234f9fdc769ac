"""The study of every coordinator: what `elsie report` says about its runs, and the generated parts of docs/research/every-coordinator.md.

All statistics are those of `elsie report`. Its answers are kept in docs/research/tables/every_coordinator.json, so that the page can be written without the
database."""
import json
import re
import subprocess
from itertools import combinations

from results import of, share, table

EXPERIMENT = "every_coordinator"
COORDINATOR, WORLD, EVERYWHERE = "coordinator", "world", "all cases"
DRAWN = ["one_obstacle", "trap"]  # worlds of which the ways are drawn
AWAY = ["engine", "noise", "failure"]  # the factors of which one at a time is away from its first level
BETTER = {"success": 1, "time_s": -1, "collisions": -1}  # the measures that decide who is ahead, and whether more or less of it is better
SIGNIFICANT = 0.05  # of p, corrected for all comparisons of a table
TIMES = 1.1  # medians of times that differ by less do not matter: in a case of one layout any difference is beyond chance
EVERYBODY = "all together"

# What the cases are called in the tables.
CASES = {"four_resources": "1 to 4", "one_obstacle": "5", "two_obstacles": "6", "two_obstacles_staggered": "6, staggered", "resources": "four resources",
         "obstacles": "two obstacles", "clutter": "clutter (7)", "trap": "trap", "moving_obstacles": "moving boxes"}


class Study:
    """Runs by coordinator and case. runs: results.Runs, whose first level of each factor is the base."""

    def __init__(self, runs):
        self.runs = runs
        self.coordinators, self.worlds = runs.levels(COORDINATOR), runs.levels(WORLD)
        self.base = {factor: runs.levels(factor)[0] for factor in AWAY}
        self.away = [(factor, level) for factor in AWAY for level in runs.levels(factor)[1:]]

    def at_base(self, **wanted):
        return self.runs.of(**self.base, **wanted)

    def worlds_away(self):
        """The worlds that also have runs away from the base."""
        return [world for world in self.worlds if any(run.levels != {**run.levels, **self.base} for run in self.runs.of(world=world))]

    def group(self, coordinator=None, world=None, **away):
        """Some cells, for --compare."""
        levels = {**({COORDINATOR: coordinator} if coordinator else {}), **({WORLD: world} if world else {}), **self.base, **away}
        return "; ".join(f"{factor}={level}" for factor, level in levels.items())

    def hashes(self, worlds, **levels):
        """What the runs of some cells ended as: equal for cells whose runs are the same, bit by bit."""
        return [(run.seed, run.state_hash) for world in worlds for run in self.runs.of(world=world, **{**self.base, **levels})]


def of_one_seed(source, seed):
    """The text of the experiment file with one seed; the files that it names are found from anywhere. source: the folder of the sources."""
    text = (source / "experiments" / f"{EXPERIMENT}.xml").read_text()
    text = re.sub(r'"\.\./', f'"{source}/', text).replace('file="worlds/', f'file="{source}/experiments/worlds/')
    return re.sub(r"<seeds [^>]*/>", f'<seeds list="{seed}"/>', text)


def ask(program, database, comparisons):
    """The report on a database as JSON, with these comparisons: [(group, group), ...]."""
    words = [word for pair in comparisons for word in ("--compare", *pair)]
    told = subprocess.run([program, "report", str(database), "--json", *words], capture_output=True, text=True, check=False)
    if not told.stdout:  # whatever the exit code says of expectations
        raise SystemExit(f"experiments/reproduction/tables: elsie report cannot answer about {database}: {told.stderr.strip()}")
    return json.loads(told.stdout)


def short(value):
    return value if not isinstance(value, float) else float(f"{value:.4g}")


def effects(comparison):
    """{measure: [effect, low, high, p]}: the difference by seed, of times that are cut off Cliff's delta, with its interval and the corrected p by seed."""
    found = {}
    for one in (each for each in comparison["measures"] if each["measure"] in BETTER):
        value, interval = one["difference"], one["difference_interval"]
        if one["measure"] == "time_s":
            value, interval = one["cliffs_delta"]["value"], one["cliffs_delta"]["interval"]
        found[one["measure"]] = [short(each) for each in (value, *(interval or (None, None)), one["seed_p_holm"])]
    return found


def pairs_of(study, ask_about, worlds):
    """[first, second, effects] of all coordinators on these cases together; effects are {} where the runs are the same."""
    every = list(combinations(study.coordinators, 2))
    world = worlds[0] if len(worlds) == 1 else None
    different = [pair for pair in every if len({tuple(study.hashes(worlds, coordinator=name)) for name in pair}) == 2]
    told = ask_about([tuple(study.group(name, world) for name in pair) for pair in different])["comparisons"]
    found = dict(zip(different, told))
    return [[*pair, effects(found[pair]) if pair in found else {}] for pair in every], margins(different, told)


def margins(pairs, told):
    """{coordinator: {measure: [centre, low, high]}} of the groups that were compared."""
    found = {}
    for pair, comparison in zip(pairs, told):
        for one in comparison["measures"]:
            for name, side in zip(pair, ("first", "second")):
                found.setdefault(name, {})[one["measure"]] = [short(each) for each in (one[side]["centre"], *(one[side]["interval"] or (None, None)))]
    return found


def cell_figures(cell):
    """Of one coordinator on one case: successes with Wilson's interval, the median time, and means."""
    measures = cell["measures"]

    def mean_of(name, among=None):
        figures = measures[name][among] if among else measures[name]
        return short(figures["mean"]) if figures else None

    return {"successes": cell["successes"], "runs": cell["ended"], "interval": [short(end) for end in cell["success_interval"]],
            "time_s": short(measures["time_s"]["median"]), "path_length_m": mean_of("path_length_m", "successes"),
            "collisions": mean_of("collisions"), "command.variation": mean_of("command.variation")}


def figures(program, results):
    """All that the page says, from the database of these results."""
    study = Study(results)

    def ask_about(comparisons):
        return ask(program, results.file, comparisons)

    pairs, overall = {}, {}
    pairs[EVERYWHERE], overall = pairs_of(study, ask_about, study.worlds)
    for world in study.worlds:
        pairs[world], _ = pairs_of(study, ask_about, [world])
    away = [(coordinator, factor, level) for coordinator in study.coordinators for factor, level in study.away]
    different = [(name, factor, level) for name, factor, level in away
                 if study.hashes(study.worlds_away(), coordinator=name, **{factor: level}) != study.hashes(study.worlds_away(), coordinator=name)]
    told = ask_about([(study.group(name, **{factor: level}), study.group(name)) for name, factor, level in different])
    found = dict(zip(different, told["comparisons"]))
    together = ask_about([(study.group(**{factor: level}), study.group()) for factor, level in study.away])["comparisons"]
    cells = [{**{name: cell["levels"][name] for name in (COORDINATOR, WORLD)}, **cell_figures(cell)} for cell in told["cells"]
             if all(cell["levels"][factor] == level for factor, level in study.base.items())]
    return {"cells": cells, "overall": overall, "pairs": pairs,
            "away": [[*which, effects(found[which]) if which in found else {}] for which in away] +
                    [[EVERYBODY, *which, effects(one)] for which, one in zip(study.away, together)]}


def with_lines(entry):
    """JSON with a line for each member, so that two versions can be compared."""
    is_list = isinstance(entry, list)
    lines = [json.dumps(each) for each in entry] if is_list else [f"{json.dumps(key)}: {json.dumps(value)}" for key, value in entry.items()]
    first, last = "[]" if is_list else "{}"
    return first + "\n" + ",\n".join(lines) + "\n" + last


def write(figures_, folder):
    members = [f"{json.dumps(name)}: {with_lines(entry)}" for name, entry in figures_.items()]
    (folder / f"{EXPERIMENT}.json").write_text("{\n" + ",\n".join(members) + "\n}\n")


def read(folder):
    return json.loads((folder / f"{EXPERIMENT}.json").read_text())


def is_apart(effect):
    """Whether the interval of an effect has one side of 0 to itself, and its corrected p says the same."""
    _, low, high, p = effect
    return low is not None and p is not None and (low > 0 or high < 0) and p < SIGNIFICANT


class Dominance:
    """Who is ahead of whom on how many cases, and who dominates whom: ahead on at least one case, and on none behind in any measure that decides."""

    def __init__(self, figures_, coordinators):
        self.coordinators = coordinators
        self.medians = {(cell[COORDINATOR], cell[WORLD]): cell["time_s"] for cell in figures_["cells"]}
        self.ahead = {(a, b): 0 for a in coordinators for b in coordinators}  # on how many cases
        self.behind = dict(self.ahead)  # in any measure, on how many cases
        for world, entries in figures_["pairs"].items():
            if world == EVERYWHERE:
                continue
            for first, second, effects_ in entries:
                signs = self.signs(world, first, second, effects_)
                for one, other, sign in ((first, second, 1), (second, first, -1)):
                    self.ahead[one, other] += signs == {sign}
                    self.behind[one, other] += -sign in signs

    def signs(self, world, first, second, effects_):
        """Has 1 if the first of two is better in a measure that decides, -1 if the second is."""
        return {BETTER[name] * (1 if effect[0] > 0 else -1) for name, effect in effects_.items()
                if is_apart(effect) and (name != "time_s" or self.times_matter(world, first, second))}

    def times_matter(self, world, first, second):
        """Also if less than half of the runs of one were done: its median is longer than any."""
        medians = [self.medians[name, world] for name in (first, second)]
        return None in medians or max(medians) >= TIMES * min(medians)

    def dominates(self, one, other):
        return self.ahead[one, other] > 0 and self.behind[one, other] == 0

    def dominated_by(self, coordinator):
        """Those that dominate it, the one that is ahead on most cases first."""
        found = [other for other in self.coordinators if self.dominates(other, coordinator)]
        return sorted(found, key=lambda other: -self.ahead[other, coordinator])

    def dominated(self, coordinator):
        return [other for other in self.coordinators if self.dominates(coordinator, other)]

    def never_dominated(self):
        return [one for one in self.coordinators if not self.dominated_by(one)]


def percent(rate):
    return f"{100 * rate:.0f}"


def code(name):
    return f"`{name}`"


def number_or_dash(value, digits):
    return "-" if value is None else f"{value:.{digits}f}"


def comparison_table(study, figures_):
    """The table: successes and times by case, and over all cases."""
    cells = {(cell[COORDINATOR], cell[WORLD]): cell for cell in figures_["cells"]}
    rows = []
    for name in study.coordinators:
        row = [code(name)]
        for world in study.worlds:
            cell = cells[name, world]
            low, high = map(percent, cell["interval"])
            time = "" if cell["time_s"] is None else f", {cell['time_s']:.0f} s"
            row.append(f"{cell['successes']} ({low} to {high}){time}")
        overall = figures_["overall"][name]
        rate, low, high = map(percent, overall["success"])
        touches, variation = (with_interval(overall[measure], 1) for measure in ("collisions", "command.variation"))
        rows.append((-overall["success"][0], row + [f"{rate} ({low} to {high})", touches, variation]))
    rows.sort(key=lambda entry: entry[0])
    return table([COORDINATOR, *(CASES[world] for world in study.worlds), "all, %", "touches", "rad/s<sup>2</sup>"], [row for _, row in rows])


def with_interval(values, digits):
    middle, low, high = values
    return f"{middle:.{digits}f}" + (f" ({low:.{digits}f} to {high:.{digits}f})" if low is not None else "")


def details_table(study, figures_):
    cells = {(cell[COORDINATOR], cell[WORLD]): cell for cell in figures_["cells"]}
    rows = [[code(name)] + [" / ".join(number_or_dash(cells[name, world][measure], 1) for measure in ("path_length_m", "collisions", "command.variation"))
                            for world in study.worlds] for name in study.coordinators]
    return table([COORDINATOR, *(CASES[world] for world in study.worlds)], rows)


def dominance_table(study, dominance):
    rows = []
    for name in study.coordinators:
        others = [other for other in study.coordinators if other != name]
        by = [f"{code(other)} ({dominance.ahead[other, name]})" for other in dominance.dominated_by(name)]
        rows.append([code(name), ", ".join(by) or "nobody", len(dominance.dominated(name)), sum(dominance.ahead[name, other] for other in others),
                     sum(dominance.ahead[other, name] for other in others)])
    return table([COORDINATOR, "dominated by (cases ahead)", "dominates", "ahead, pairs and cases", "behind"], rows)


def away_table(study, figures_):
    """Differences of the success rate from the base, in percent of the runs."""
    found = {tuple(entry[:3]): entry[3].get("success") for entry in figures_["away"]}
    rows = []
    for name in [*study.coordinators, EVERYBODY]:
        runs = [run for world in study.worlds_away() for run in study.at_base(world=world) if run.levels[COORDINATOR] == name or name == EVERYBODY]
        row = [name if name == EVERYBODY else code(name), share(runs)]
        for factor, level in study.away:
            effect = found[name, factor, level]
            if not effect:
                row.append("the same runs")
                continue
            value, low, high, _ = effect
            has_spread = low is not None and low < high  # else no seed differs, which is no interval
            text = f"{100 * value:+.0f}" + (f" ({100 * low:+.0f} to {100 * high:+.0f})" if has_spread else "")
            row.append(f"**{text}**" if is_apart(effect) else text)
        rows.append(row)
    return table([COORDINATOR, "base", *(f"{factor} {level}" if factor != "failure" else level for factor, level in study.away)], rows)


def design(study):
    """How many runs the study has."""
    base = [run for run in study.runs.runs if run.levels == {**run.levels, **study.base}]
    rest = len(study.runs.runs) - len(base)
    seeds = study.runs.seeds()
    return (f"{len(study.coordinators)} coordinators, {len(study.worlds)} cases and seeds {seeds[0]} to {seeds[-1]} are {len(base)} runs at the base "
            f"({', '.join(f'{factor} {level}' for factor, level in study.base.items())}); {len(study.away)} levels away from it on {len(study.worlds_away())} "
            f"cases ({', '.join(CASES[world] for world in study.worlds_away())}) are {rest} more.")


def parts(runs, figures_):
    """{name of a part of the page: its text}."""
    study = Study(runs)
    dominance = Dominance(figures_, study.coordinators)
    never = dominance.never_dominated()
    everywhere = [name for name in study.coordinators if any(dominance.ahead[other, name] == len(study.worlds) for other in dominance.dominated_by(name))]
    told = (f"Dominated: {of(len(study.coordinators) - len(never), len(study.coordinators))}. Never dominated: {', '.join(map(code, never))}."
            + (f" On all cases, and by one and the same: {', '.join(map(code, everywhere))}." if everywhere else ""))
    return {"design": design(study), "comparison": comparison_table(study, figures_), "details": details_table(study, figures_),
            "dominance": dominance_table(study, dominance) + "\n\n" + told, "away": away_table(study, figures_)}
