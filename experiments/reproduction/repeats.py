"""Repeats runs of the archive: which ones, and whether they are the same."""
import math
import random

from archive import HASH_DIGITS


def sample(runs, count, draw=random.SystemRandom()):
    """About so many runs over all tables, as shards of their experiments: {experiment: (K, N)}, every N-th run from the K-th on. N has no factor in common with
    the number of runs, so that a sample goes through all levels and seeds. runs: {experiment: number of runs}."""
    found, whole = {}, sum(runs.values())
    for name, of in runs.items():
        step = max(1, of // max(1, round(count * of / whole)))
        while math.gcd(step, of) > 1:
            step -= 1
        found[name] = draw.randint(1, step), step
    return found


def key(run):
    return tuple(sorted(run.levels.items())), run.seed


def compare(archived, again):
    """Of the runs that were done again and are in the archive: their number, how many have the same outcome, and those that differ, a sentence each."""
    known = {key(run): run for run in archived}
    both = [(known[key(run)], run) for run in again if key(run) in known]
    different = []
    for old, new in both:
        old_is, new_is = ((run.state_hash[:HASH_DIGITS], run.outcome) for run in (old, new))
        if old_is != new_is:
            where = ", ".join(f"{factor} {level}" for factor, level in new.levels.items())
            different.append(f"{where}, seed {new.seed}: {' '.join(new_is)}, in the archive {' '.join(old_is)}")
    return len(both), sum(old.outcome == new.outcome for old, new in both), different
