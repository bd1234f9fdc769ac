"""Compares runs of the same seed: their common effect of the seed counts neither as a difference nor as uncertainty."""
import math
import random
import struct
from statistics import mean

RESAMPLES = 4000  # as elsie report


def both_succeed(first, second):
    """Pairs of runs of the same seed, in the order of the seeds; those in which both reached their goal."""
    others = {run.seed: run for run in second}
    pairs = [(run, others[run.seed]) for run in sorted(first, key=lambda run: run.seed) if run.seed in others]
    return [pair for pair in pairs if pair[0].success and pair[1].success]


def ratios(first, second, figure):
    """The ratio of the first one's figure to that of the second, for each seed with which both succeed."""
    return [figure(a) / figure(b) for a, b in both_succeed(first, second)]


def interval(values):
    """The 95 % interval of a mean: percentile bootstrap (Efron, 1979). The same values give the same interval."""
    if max(values) == min(values):
        return values[0], values[0]
    draw = random.Random(len(values))
    means = sorted(mean_of(draw.choices(values, k=len(values))) for _ in range(RESAMPLES))
    return means[round(0.025 * (RESAMPLES - 1))], means[round(0.975 * (RESAMPLES - 1))]


def wilson(hits, trials):
    """The 95 % interval of a rate: Wilson (1927). Without trials, from 0 to 1."""
    if trials == 0:
        return 0.0, 1.0
    z, rate = 1.959964, hits / trials
    shrink = 1 + z * z / trials
    middle, half = (rate + z * z / (2 * trials)) / shrink, z * math.sqrt(rate * (1 - rate) / trials + z * z / (4 * trials ** 2)) / shrink
    return (0.0 if hits == 0 else middle - half), (1.0 if hits == trials else middle + half)


def difference_of_rates(hits, trials, other_hits, other_trials):
    """The 95 % interval of a rate less another one: Newcombe's method 10 (1998). Without trials of one, from -1 to 1."""
    if trials == 0 or other_trials == 0:
        return -1.0, 1.0
    p, q = hits / trials, other_hits / other_trials
    (low, high), (other_low, other_high) = wilson(hits, trials), wilson(other_hits, other_trials)
    return p - q - math.hypot(p - low, other_high - q), p - q + math.hypot(high - p, q - other_low)


def mean_of(values):
    return sum(values) / len(values)


def mean_with_interval(values, digits):
    """"0.74 (0.72 to 0.76)"; the mean alone if the interval's ends are equal in these digits, "-" without values."""
    if not values:
        return "-"
    ends = [f"{end:.{digits}f}" for end in interval(values)]
    middle = f"{mean(values):.{digits}f}"
    return middle if ends == [middle, middle] else f"{middle} ({ends[0]} to {ends[1]})"


def single(value):
    """The nearest number of single precision."""
    return struct.unpack("f", struct.pack("f", value))[0]


def sum_of_steps(step, count):
    """The sum of steps of single precision, in single precision."""
    time = 0.0
    for _ in range(count):
        time = single(time + single(step))
    return time


def path_m(run):
    return run.path_m


def seconds_per_metre(run):
    return run.time_s / run.path_m
