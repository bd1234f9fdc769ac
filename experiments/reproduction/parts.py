"""The tables of docs/research/experiments.md and docs/research/every-coordinator.md, from the archive of runs."""
import math
from statistics import mean

from results import of, share, short_spread, spread, successes, table

LAYERS = ["2 2", "4 4", "2 2 2 2", "4 4 4 4"]
SCHEMES = ["arbitration", "fusion"]
PERIODS = ["0.01", "0.2", "0.3", "0.4", "0.5"]  # s; 0.1 s is that of the cases
CASES_5_AND_6 = [("5", "one_obstacle"), ("6", "two_obstacles"), ("6, staggered", "two_obstacles_staggered")]
LAYOUTS = {"one_obstacle": "one obstacle", "two_obstacles": "two, side by side", "two_obstacles_staggered": "two, one after the other"}

# The original's figures: metres, seconds, outcome. Means of five repetitions, printed without a spread.
ORIGINAL = {
    ("1", "arbitration"): (64.79, 170.50, "success"), ("1", "fusion"): (32.98, 293.70, "success"),
    ("2", "arbitration"): (72.57, 189.00, "success"), ("2", "fusion"): (32.87, 170.40, "success"),
    ("3", "arbitration"): (171.95, 279.70, "failure"), ("3", "fusion"): (41.54, 220.40, "success"),
    ("4", "arbitration"): (152.20, 249.10, "failure"), ("4", "fusion"): (41.12, 546.41, "success"),
    ("5", "arbitration"): (4.49, 15.30, "success"), ("5", "fusion"): (4.07, 51.00, "success"),
    ("6", "arbitration"): (34.26, 89.60, "success"), ("6", "fusion"): (26.40, 155.70, "success"),
    ("7", "arbitration"): (285.22, 998.40, "success"), ("7", "fusion"): (134.13, 1111.57, "success"),
}
# The number of steps in these times, in single precision, which their six decimals reveal.
ORIGINAL_STEPS = {("5", "arbitration"): 153, ("5", "fusion"): 510, ("6", "arbitration"): 896, ("6", "fusion"): 1557}
ORIGINAL_STEP_S = 0.1
ORIGINAL_ERRORS = {
    ("1", "arbitration"): "0.0", ("1", "fusion"): "3.0e-4", ("2", "arbitration"): "3.5e-5", ("2", "fusion"): "3.8e-5",
    ("3", "arbitration"): "0.1238", ("3", "fusion"): "0.1238", ("4", "arbitration"): "0.1238", ("4", "fusion"): "4.5e-6",
}


def comparison(cells):
    """Our figures next to the original's: cells are (case, description, scheme, runs)."""
    rows = []
    for case, what, scheme, runs in cells:
        original = ORIGINAL.get((case.split(",")[0], scheme))
        won = successes(runs)
        rows.append([case, what, scheme, f"{original[0]:.2f}", f"{original[1]:.1f}", original[2], share(runs),
                     spread((run.path_m for run in runs), 2), spread((run.time_s for run in runs), 1),
                     short_spread((run.path_m for run in won), 2), short_spread((run.time_s for run in won), 1)])
    return table(["case", "", "scheme", "original: m", "s", "outcome", "ours: success", "m", "s", "m, successes", "s, successes"], rows)


def cases_1_to_4(results):
    return comparison([(str(k + 1), hidden, scheme, results.of(coordinator=scheme, layers=hidden))
                       for k, hidden in enumerate(LAYERS) for scheme in SCHEMES])


def training(results):
    rows = []
    for k, hidden in enumerate(LAYERS):
        # Both schemes train the same network from the same seed.
        both = {scheme: [run.error() for run in results.of(coordinator=scheme, layers=hidden)] for scheme in SCHEMES}
        assert both["arbitration"] == both["fusion"]
        runs = results.of(coordinator="fusion", layers=hidden)
        learned = [run.error() for run in runs if run.learned()]
        flat = [run for run in runs if run.flat]
        rows.append([k + 1, hidden, ORIGINAL_ERRORS[str(k + 1), "arbitration"], ORIGINAL_ERRORS[str(k + 1), "fusion"],
                     of(len(learned), len(runs)), f"{mean(learned):.1e}" if learned else "-", len(flat),
                     len(runs) - len(learned) - len(flat), f"{max(both['fusion']):.4f}"])
    return table(["case", "hidden layers", "original's last error, arbitration", "fusion", "ours: learned all samples",
                  "their mean error", "on the plateau", "missed a sample", "largest error"], rows)


def cases_5_and_6(results):
    return comparison([(case, LAYOUTS[world], scheme, results.of(world=world, coordinator=scheme, search="left"))
                       for case, world in CASES_5_AND_6 for scheme in SCHEMES])


def search_to_the_right(results):
    """Cases 5 and 6 with the search to the left, as in the table of the cases, and to the right."""
    rows = []
    for case, world in CASES_5_AND_6:
        for scheme in SCHEMES:
            rows.append([case, scheme] + [cell_of(results.of(world=world, coordinator=scheme, search=search)) for search in ("left", "right")])
    return table(["case", "scheme", "searches to the left", "to the right"], rows)


def case_7(results):
    return comparison([("7", "clutter", scheme, results.of(coordinator=scheme)) for scheme in SCHEMES])


def backing_off(results):
    rows = []
    for case, world in CASES_5_AND_6:
        for scheme in SCHEMES:
            runs = results.of(world=world, coordinator=scheme)
            rows.append([case, scheme, share(runs), spread((run.path_m for run in runs), 2), spread((run.time_s for run in runs), 1)])
    return table(["case", "scheme", "success", "m", "s"], rows)


def beside_the_cases(results, others, factor, levels):
    """The cases with one change. others: the runs of the unchanged cases, which stand where levels has None."""
    rows = []
    for case, world in [("2", "four_resources"), *CASES_5_AND_6, ("7", "clutter")]:
        if world not in results.levels("world"):
            continue
        for scheme in SCHEMES:
            cells = [results.of(world=world, coordinator=scheme, **{factor: level}) if level else others[world, scheme] for level in levels]
            rows.append([case, scheme] + [cell_of(runs) for runs in cells] + ["{:.2f} m, {:.1f} s".format(*ORIGINAL[case.split(",")[0], scheme])])
    return rows


def decision_period(results, others):
    first, *later = [f"{period} s" for period in PERIODS]
    rows = beside_the_cases(results, others, "period", [first, None, *later])
    return table(["case", "scheme", first, "0.1 s, as above", *later, "original"], rows)


# The world, the leader's coverage in m, and what it is.
GROUPS = [("within_1.5_m", 1.5, "the leader stands, coverage 1.5 m"), ("within_3_m", 3.0, "the leader stands, coverage 3 m"),
          ("to_a_resource", 3.0, "to a resource, default parameters"),
          ("to_a_resource_in_a_column", 1.5, "to a resource, own distances of 0.3 to 0.9 m")]


def distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


def groups(results):
    rows = []
    for world, coverage, what in GROUPS:
        runs = results.of(world=world)
        inside = outside = gathered = 0
        ends, strayed = [], []
        for run in runs:
            first, last = run.robots["leader"]
            for robot, (start, end) in run.robots.items():
                if robot == "leader":
                    continue
                if distance(start, first) <= coverage:
                    inside += 1
                    ends.append(distance(end, last))
                    gathered += ends[-1] <= 0.5
                else:
                    outside += 1
                    strayed.append(distance(end, start))
        rows.append([what, share(runs), inside // len(runs), of(gathered, inside), spread(ends, 2), outside // len(runs),
                     f"{max(strayed):.3f}" if strayed else "-", spread((run.time_s for run in runs), 1),
                     f"{mean(run.collisions for run in runs):.1f}"])
    return table(["", "success", "within coverage", "of them in all runs within 0.5 m at the end", "m from the leader at the end",
                  "out of coverage", "they moved by at most m", "s", "collisions a run"], rows)


# The worlds of experiments/scattered.xml: what they are, and the published runs of the same kind with this scheme.
SCATTERED = [("resources", "cases 1 to 4, four resources", lambda every, scheme: every["four_resources"].of(coordinator=scheme, layers="4 4")),
             ("obstacles", "cases 5 and 6, two obstacles", lambda every, scheme: every["obstacles"].of(coordinator=scheme, search="left")),
             ("clutter", "case 7", lambda every, scheme: every["clutter"].of(coordinator=scheme)),
             ("gathering", "groups, the leader stands", lambda every, _: every["groups"].of(world="within_1.5_m")),
             ("group_to_resource", "groups, to a resource", None)]  # has another goal than the published ones


def scattered(results, every):
    """Twenty layouts of each kind, next to the published ones. every: the published experiments."""
    rows = []
    for world, what, published_ in SCATTERED:
        for scheme in dict.fromkeys(run.levels["coordinator"] for run in results.of(world=world)):
            runs = results.of(world=world, coordinator=scheme)
            won = successes(runs)
            rows.append([what, scheme if scheme in SCHEMES else "-", share(runs), short_spread((run.path_m for run in won), 1), short_spread((run.time_s for run in won), 1),
                         f"{mean(run.collisions for run in runs):.1f}", share(published_(every, scheme)) if published_ else "-"])
    return table(["", "scheme", "success", "m, successes", "s, successes", "collisions a run", "success above"], rows)


def build_in_words(build):
    """The build that did runs: its version, the commits of its sources and of the experiments' files, and its library's hash."""
    commit, files = build.get("commit"), build.get("files")
    told = f"commit {commit}" if commit else "commit not noted"
    if files:
        told += f" with the files of experiments, worlds and models that were committed later, in {files}"
    return f"Elsie {build['elsie']}, {told}, `libelsie` {build['libelsie'][:12]} (SHA-256)"


def repeated(every):
    """Which of the runs were done again by another build; "" if none were."""
    found = {}
    for results in every.values():
        again = results.build.get("repeated")
        if again:
            before = found.get(again["commit"], (0, 0, 0))
            found[again["commit"]] = [count + again[what] for count, what in zip(before, ("runs", "same_outcome", "same"))]

    def share_in_words(part, whole):
        return "all" if part == whole else str(part)

    return "".join(f" Of these runs {runs} were repeated by commit {commit}: {share_in_words(outcomes, runs)} have the same outcome, and "
                   f"{share_in_words(same_, runs)} the same state at the end, bit for bit." for commit, (runs, outcomes, same_) in found.items())


def builds(every, command="make tables"):
    """The runs of each build, and how many of them were repeated."""
    runs = sum(len(results.runs) for results in every.values())
    found = {}
    for name, results in every.items():
        found.setdefault(build_in_words(results.build), []).append(name)
    if len(found) == 1:
        build = "one build, " + next(iter(found))
    else:
        build = f"{len(found)} builds: " + "; ".join(f"{', '.join(f'`{name}.xml`' for name in names)}: {told}" for told, names in found.items())
    files = "an experiment file" if len(every) == 1 else f"{len(every)} experiment files"
    return f"Written by `{command}`: {runs} runs of {files}, of {build}.{repeated(every)}"


def provenance(every):
    return (f"{builds(every)}\n\nUnless a table says otherwise: seeds 1 to 20 for each row; mean +- standard deviation (least to largest) over all runs of the "
            "row, those that failed included, whose times are those at their limit: such a mean is less than what it would have taken; *successes* are those "
            "that reached their goal. A single figure: all seeds came to the same.")


def cell_of(runs):
    """A cell of a table in a few words; without a rate if all its runs are the same, bit for bit."""
    won = successes(runs)
    figures = f"{short_spread((run.path_m for run in won), 2)} m, {short_spread((run.time_s for run in won), 1)} s" if won else "-"
    if same(runs):
        return figures if won else f"- ({runs[0].path_m:.2f} m, {runs[0].collected:.0f} collected)"
    return f"{share(runs)}: {figures}" if won else f"{share(runs)} ({mean(run.path_m for run in runs):.2f} m, {mean(run.collected for run in runs):.1f} collected)"


def same(runs):
    return len({run.state_hash for run in runs}) == 1


def published(every):
    """The runs of the published cases with 4 4 neurons, by world and scheme."""
    runs = {}
    for scheme in SCHEMES:
        runs["four_resources", scheme] = every["four_resources"].of(coordinator=scheme, layers="4 4")
        runs["clutter", scheme] = every["clutter"].of(coordinator=scheme)
        for _, world in CASES_5_AND_6:
            runs[world, scheme] = every["obstacles"].of(coordinator=scheme, world=world, search="left")
    return runs
