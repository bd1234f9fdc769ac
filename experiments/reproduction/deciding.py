"""The deciding experiment (docs/research/original-step.md): in which of the set-ups that the original may have had do its conclusions hold?

A set-up is one level of each unknown of the original. In each, fusion and arbitration do the same seeds with networks of the same sizes.
"""
import itertools
import math
import random
from statistics import mean

from results import table

UNKNOWNS = ["search", "beams", "boxes", "limit", "avoidance"]
WHAT = {"search": "while nothing is seen", "beams": "beams and resources", "boxes": "obstacles", "limit": "speed limit", "avoidance": "avoidance model"}
RESAMPLES = 400
# What "holds" means, fixed before the runs.
COMPLETES = 0.9  # of the runs
FAILS = 0.1  # of the runs
DIFFERENT = 10  # two success rates that are at least one run in so many apart
SHORTER = 0.75  # of the other path
FASTER = 0.9  # of the other time
ENOUGH = 3  # pairs of runs, or networks
SIZES = {"wider": (("2 2", "2 2 2 2"), ("4 4", "4 4 4 4")), "deeper": (("2 2", "4 4"), ("2 2 2 2", "4 4 4 4")), "wider and deeper": (("2 2",), ("4 4 4 4",))}


class Counts:
    """Sums over the runs of a set-up: additive, so that resampled seeds need no second look at the runs."""

    def __init__(self):
        self.of = {}

    def add(self, *key, value=1):
        self.of[key] = self.of.get(key, 0) + value

    def __getitem__(self, key):
        return self.of.get(key, 0)

    def sum(self, *prefixes):
        return sum(self.of.get(prefix, 0) for prefix in prefixes)


def counts_of_seed(runs):
    """runs: {(scheme, layers): run} of one seed."""
    counts = Counts()
    for (scheme, layers), run in runs.items():
        counts.add("runs", scheme, layers)
        if run.success:
            counts.add("successes", scheme, layers)
            counts.add("time", scheme, layers, value=run.time_s)
            counts.add("path", scheme, layers, value=run.path_m)
        if not run.learned():
            counts.add("untrained", scheme)
            counts.add("untrained successes", scheme, value=int(run.success))
    for layers in {layers for _, layers in runs}:
        fusion, arbitration = runs["fusion", layers], runs["arbitration", layers]
        if fusion.success and arbitration.success:
            counts.add("pairs")
            counts.add("path ratio", value=fusion.path_m / arbitration.path_m)
            counts.add("time ratio", value=arbitration.time_s / arbitration.path_m * fusion.path_m / fusion.time_s)
    return counts


class CountsOfSeeds:
    """The counts of a set-up for each seed."""

    def __init__(self, counts):
        self.keys = sorted({key for each in counts for key in each.of})
        self.columns = [[each[key] for each in counts] for key in self.keys]

    def total(self, seeds):
        """The sum over these seeds, given by their places, each as often as it occurs."""
        whole = Counts()
        whole.of = {key: sum([column[seed] for seed in seeds]) for key, column in zip(self.keys, self.columns)}
        return whole


class Study:
    """The runs of one of the two experiments, by set-up."""

    def __init__(self, runs):
        self.build = runs.build
        self.factors = [factor for factor in UNKNOWNS if factor in runs.runs[0].levels]
        self.levels = {factor: runs.levels(factor) for factor in self.factors}
        self.layers = runs.levels("layers") if "layers" in runs.runs[0].levels else ["4 4"]
        self.seeds = runs.seeds()
        self.number_of_runs = len(runs.runs)
        found = {}
        for run in runs.runs:
            setup = tuple(run.levels[factor] for factor in self.factors)
            found.setdefault(setup, {}).setdefault(run.seed, {})[run.levels["coordinator"], run.levels.get("layers", "4 4")] = run
        self.runs = found
        self.by_seed = {setup: CountsOfSeeds([counts_of_seed(seeds[seed]) for seed in self.seeds]) for setup, seeds in found.items()}
        self.counts = {setup: each.total(range(len(self.seeds))) for setup, each in self.by_seed.items()}
        self.setups = list(found)

    def level(self, setup, factor):
        return setup[self.factors.index(factor)]

    def won(self, counts, scheme, layers=None):
        """The successes and the runs of a scheme with networks of these sizes; by default of all."""
        keys = [(scheme, each) for each in layers or self.layers]
        return counts.sum(*(("successes", *key) for key in keys)), counts.sum(*(("runs", *key) for key in keys))

    def rate(self, counts, scheme, layers=None):
        """The success rate of a scheme with networks of these sizes."""
        successes, runs = self.won(counts, scheme, layers)
        return successes / runs

    def succeeds_more(self, counts, scheme, other):
        """Whether the first of two schemes succeeds more often."""
        return more_often(self.won(counts, scheme), self.won(counts, other))

    def resampled(self, setups):
        """The counts of these set-ups with resampled seeds, the same in each of them: {set-up: counts} once for each resample."""
        draw = random.Random(len(self.seeds))
        for _ in range(RESAMPLES):
            seeds = draw.choices(range(len(self.seeds)), k=len(self.seeds))
            yield {setup: self.by_seed[setup].total(seeds) for setup in setups}


def as_fast_as_the_original(study, setup):
    """Whether its robot can drive at the 0.61 m/s of the original's case 3: it needs 30 rad/s in the open, and no limit of 0.5 m/s."""
    return "/30/" in study.level(setup, "avoidance") and study.level(setup, "limit") == "none"


def completes(study, counts):
    return all(study.rate(counts, "fusion", [layers]) >= COMPLETES for layers in study.layers)


def fails_untrained(_, counts):
    if counts["untrained", "arbitration"] < ENOUGH:
        return None
    return counts["untrained successes", "arbitration"] / counts["untrained", "arbitration"] <= FAILS


def mean_of_pairs(counts, what):
    """The mean over pairs of runs of a seed with which both succeed; None if there are not enough."""
    return counts[what,] / counts["pairs",] if counts["pairs",] >= ENOUGH else None


def shorter(_, counts):
    ratio = mean_of_pairs(counts, "path ratio")
    return None if ratio is None else ratio <= SHORTER


def faster(_, counts):
    ratio = mean_of_pairs(counts, "time ratio")
    return None if ratio is None else ratio < 1


def more_often(first, second):
    """Whether the first of two success rates, each as (successes, runs), is the higher one by DIFFERENT. In whole numbers: the difference of two
    quotients may be rounded to either side of a tenth."""
    (won, runs), (other_won, other_runs) = first, second
    return DIFFERENT * (won * other_runs - other_won * runs) >= runs * other_runs


def trades(study, counts):
    return study.succeeds_more(counts, "fusion", "arbitration")


def helps(study, counts, scheme, sizes):
    """Whether networks of the second sizes do better than those of the first: they succeed more often, or as often in less time."""
    small, large = (study.won(counts, scheme, layers) for layers in sizes)
    if more_often(large, small) or more_often(small, large):
        return more_often(large, small)
    small_s, large_s = (counts.sum(*(("time", scheme, each) for each in layers)) for layers in sizes)
    return bool(small[0] and large[0]) and large_s / large[0] <= FASTER * small_s / small[0]


def helps_fusion_only(sizes):
    return lambda study, counts: helps(study, counts, "fusion", sizes) and not helps(study, counts, "arbitration", sizes)


# The original's conclusions, each half by itself: (key, in words, whether it holds in a set-up: True, False, or None if the runs cannot tell).
FUSION_COMPLETES = ("1, first half", "fusion completes every case", completes)
UNTRAINED_FAILS = ("1, second half", "arbitration fails where its network did not train", fails_untrained)
SHORTER_PATH = ("2", "where both succeed, fusion's path is much shorter", shorter)
FASTER_PER_METRE = ("3, first half", "arbitration is faster per metre", faster)
TRADE_OFF = ("3, second half", "fusion succeeds more often than arbitration", trades)
BIGGER = [(f"4, {name}", f"networks that are {name} help fusion, not arbitration", helps_fusion_only(sizes)) for name, sizes in SIZES.items()]


def conclusions_of(study):
    """Those that the runs of a study can be judged by."""
    every = [FUSION_COMPLETES, UNTRAINED_FAILS, SHORTER_PATH, FASTER_PER_METRE, TRADE_OFF, *BIGGER]
    return every if len(study.layers) > 1 else [FUSION_COMPLETES, SHORTER_PATH, FASTER_PER_METRE, TRADE_OFF]


class Share:
    """In how many of the set-ups that can be judged a conclusion holds, with the 95 % interval of that share over resampled seeds."""

    def __init__(self, holds, judged, low, high):
        self.holds, self.judged, self.low, self.high = holds, judged, low, high
        self.share = holds / judged if judged else None

    def verdict(self):
        """The rule of docs/research/original-step.md."""
        if not self.judged:
            return "not to be decided"
        return "confirmed" if self.low >= COMPLETES else "refuted" if self.high <= FAILS else "not to be decided"


def share_of(judgements):
    judged = [value for value in judgements if value is not None]
    return sum(judged) / len(judged) if judged else None


def shares(study, setups=None):
    """{key of a conclusion: Share} over these set-ups; by default over all."""
    setups = setups or study.setups
    entries = conclusions_of(study)
    drawn = {key: [] for key, _, _ in entries}
    for counts in study.resampled(setups):
        for key, _, holds in entries:
            value = share_of(holds(study, counts[setup]) for setup in setups)
            if value is not None:
                drawn[key].append(value)
    found = {}
    for key, _, holds in entries:
        judged = [value for value in (holds(study, study.counts[setup]) for setup in setups) if value is not None]
        ends = sorted(drawn[key]) or [0.0, 1.0]
        found[key] = Share(sum(judged), len(judged), ends[round(0.025 * (len(ends) - 1))], ends[round(0.975 * (len(ends) - 1))])
    return found


def effects(study, response):
    """How much of the variance over the set-ups each unknown explains by itself, and each pair of them beyond that: {(factor,) or (factor, factor): share}.
    response: {set-up: number}. The set-ups are all combinations, so the sums of squares add up."""
    whole = mean(response.values())
    spread = sum((value - whole) ** 2 for value in response.values())
    if spread == 0:
        return {}

    def means(*factors):
        groups = {}
        for setup, value in response.items():
            groups.setdefault(tuple(study.level(setup, factor) for factor in factors), []).append(value)
        return {levels: (mean(values), len(values)) for levels, values in groups.items()}

    alone = {factor: means(factor) for factor in study.factors}
    found = {(factor,): sum(count * (value - whole) ** 2 for value, count in alone[factor].values()) / spread for factor in study.factors}
    for first, second in itertools.combinations(study.factors, 2):
        found[first, second] = sum(count * (value - alone[first][a,][0] - alone[second][b,][0] + whole) ** 2
                                   for (a, b), (value, count) in means(first, second).items()) / spread
    return found


def responses(study):
    """What is explained by the unknowns: the success rates, and where each conclusion holds."""
    found = {f"success of {scheme}": {setup: study.rate(study.counts[setup], scheme) for setup in study.setups} for scheme in ("fusion", "arbitration")}
    for key, words, holds in conclusions_of(study):
        found[f"{key}: {words}"] = {setup: float(bool(holds(study, study.counts[setup]))) for setup in study.setups}
    return found


def name_of(study, setup):
    """A set-up in words: "search left, beams see resources, ..."."""
    return ", ".join(f"{factor} {level}" for factor, level in zip(study.factors, setup))


class Cell:
    """What both schemes do in a set-up with networks of one size: success rates, and mean paths and times of the successes."""

    def __init__(self, study, setup, layers):
        counts = study.counts[setup]
        self.setup, self.layers = setup, layers
        self.rate, self.path_m, self.time_s, self.successes = {}, {}, {}, {}
        for scheme in ("arbitration", "fusion"):
            won = counts["successes", scheme, layers]
            self.successes[scheme], self.rate[scheme] = won, won / counts["runs", scheme, layers]
            self.path_m[scheme] = counts["path", scheme, layers] / won if won else None
            self.time_s[scheme] = counts["time", scheme, layers] / won if won else None

    def off(self, original):
        """How far its paths are from the original's: the root mean square of the two logarithms of the ratios. original: {scheme: path in m}."""
        return math.sqrt(mean(math.log(self.path_m[scheme] / metres) ** 2 for scheme, metres in original.items()))


def cells(study, layers):
    """The cells in which enough runs of each scheme succeed for a mean."""
    found = [Cell(study, setup, layers) for setup in study.setups]
    return [cell for cell in found if min(cell.successes.values()) >= ENOUGH]


def nearest(study, layers, original, count=5):
    return sorted(cells(study, layers), key=lambda cell: cell.off(original))[:count]


def percent(value):
    return f"{100 * value:.0f} %"


def table_of_shares(every):
    """every: [(name of the column, {key: Share})], the first with all conclusions."""
    rows = []
    for key, words, _ in [FUSION_COMPLETES, UNTRAINED_FAILS, SHORTER_PATH, FASTER_PER_METRE, TRADE_OFF, *BIGGER]:
        cells_ = []
        for _, found in every:
            share = found.get(key)
            cells_.append("-" if share is None or not share.judged else f"{share.holds} of {share.judged}: {percent(share.share)} ({percent(share.low)} to {percent(share.high)})")
        rows.append([key, words, *cells_])
    return table(["", "conclusion", *(name for name, _ in every)], rows)


def table_of_effects(study, count=4):
    """The strongest effects on each response."""
    rows = []
    for what, response in responses(study).items():
        strongest = sorted(effects(study, response).items(), key=lambda entry: -entry[1])[:count]
        told = [f"{' x '.join(factors)} {percent(share)}" for factors, share in strongest if share >= 0.005]
        rows.append([what, f"{percent(mean(response.values()))}", ", ".join(told) or "the same in all"])
    return table(["", "mean over all set-ups", "part of the variance over the set-ups that is explained by"], rows)


def table_of_nearest(study, layers, original, original_times):
    """original, original_times: {scheme: m}, {scheme: s}."""
    rows = [["the original", "-", *(f"{original[scheme]:.1f} m, {original_times[scheme]:.0f} s" for scheme in original), "-"]]
    for cell in nearest(study, layers, original):
        rows.append([name_of(study, cell.setup), ", ".join(percent(cell.rate[scheme]) for scheme in original),
                     *(f"{cell.path_m[scheme]:.1f} m, {cell.time_s[scheme]:.0f} s" for scheme in original), f"{math.exp(cell.off(original)):.2f}"])
    return table(["set-up", "success: arbitration, fusion", "arbitration", "fusion", "off by the factor"], rows)
