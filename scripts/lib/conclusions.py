"""The four conclusions of the original with figures: confirmed in our set-up, refuted, or not decided by these runs."""
from statistics import mean

from pairs import both_succeed, difference_of_rates, interval, mean_with_interval, path_m, ratios, seconds_per_metre, wilson
from parts import CASES_5_AND_6, LAYERS, PERIODS, SCHEMES
from results import share, successes, table


def cases(every):
    """The runs of cases 1 to 7 with fusion and with arbitration: {case: (runs, runs)}."""
    runs = {f"case {k + 1}": every["four_resources"].by_scheme(layers=hidden) for k, hidden in enumerate(LAYERS)}
    for case, world in CASES_5_AND_6:
        runs[f"case {case}"] = every["obstacles"].by_scheme(world=world)
    runs["case 7"] = every["clutter"].by_scheme()
    return runs


# Known differences from the original's runs that may matter. Cases without an entry have the original's set-up.
MODELS = "other models of avoid_obstacle"
PERIOD = "a decision every 0.01 s instead of 0.1 s"
LAYOUT = "a layout of our own"
DIFFERENCES = {**{f"case {k}": (PERIOD, MODELS) for k in (1, 2, 3, 4)},
               **{f"case {k}": (PERIOD, MODELS, LAYOUT) for k in ("5", "6", "6, staggered", "7")}}


def decide(evidence):
    """The evidence for a statement: {case: True, False, or None if it is unclear}. The rule is in docs/experiments.md."""
    if evidence and all(value is True for value in evidence.values()):
        return "confirmed in our set-up"
    if any(value is False and not DIFFERENCES.get(case) for case, value in evidence.items()):
        return "refuted"
    return "not decided by these runs"


def verdict(word):
    return f"**{word[0].upper()}{word[1:]}.**"


def first_and_second(first, second):
    """The verdict on a conclusion with two halves."""
    if first == second:
        return verdict(first)
    return f"**The first half is {first}, the second {second}.**"


def against(evidence):
    """The contrary cases, and why they do not refute the statement."""
    cases_ = [case for case, value in evidence.items() if value is False]
    if not cases_ or decide(evidence) != "not decided by these runs":
        return ""
    reasons = dict.fromkeys(reason for case in cases_ for reason in DIFFERENCES[case])
    return f" What speaks against it is not the original's set-up: {'; '.join(reasons)}."


def below(ends, limit):
    """Whether an interval lies below a limit: True, False when it lies above, None when the limit is in it."""
    low, high = ends
    return True if high < limit else False if low > limit else None


def pair_row(name, fusion, arbitration):
    """The values of the two where both succeed; empty if they never do."""
    pairs = both_succeed(fusion, arbitration)
    seconds = [f"{mean(seconds_per_metre(pair[k]) for pair in pairs):.2f}" if pairs else "-" for k in (1, 0)]
    return [name, len(pairs), mean_with_interval(ratios(fusion, arbitration, path_m), 3), *seconds,
            mean_with_interval(ratios(arbitration, fusion, seconds_per_metre), 3)]


def where_both_succeed(every):
    rows = [pair_row(case, *runs) for case, runs in cases(every).items()]
    for period in PERIODS:
        rows.append(pair_row(f"case 2, a decision every {period} s", *late(every, period)))
    return table(["", "pairs of runs", "fusion's path / arbitration's", "s/m, arbitration", "s/m, fusion", "arbitration's s/m / fusion's"], rows)


def late(every, period):
    return every["decision_period"].by_scheme(world="four_resources", period=f"{period} s")


def first(every):
    runs = cases(every)
    fusion = [run for both in runs.values() for run in both[0]]
    four = every["four_resources"]
    split = {scheme: {learned: [run for run in four.of(coordinator=scheme) if run.learned() == learned] for learned in (True, False)}
             for scheme in SCHEMES}
    completes = {case: len(successes(both[0])) == len(both[0]) for case, both in runs.items()}
    incomplete = [f"{case} ({share(both[0])})" for case, both in runs.items() if not completes[case]]
    untrained = split["arbitration"][False]
    fails = {"cases 1 to 4": below(wilson(len(successes(untrained)), len(untrained)), 0.5)}
    return ("*Fusion completes every case; arbitration fails where its network did not train.* " + first_and_second(decide(completes), decide(fails)) +
            f" Fusion completes {share(fusion)} runs of cases 1 to 7" +
            (f"; it does not always in {', '.join(incomplete)}" if incomplete else "") +
            f". In cases 1 to 4 arbitration succeeds with {share(split['arbitration'][True])} networks that learned all samples and with "
            f"{share(split['arbitration'][False])} of the others. So does fusion with {share(split['fusion'][False])} of the others." + against(completes))


def second(every):
    of_case = {case: ratios(*both, path_m) for case, both in cases(every).items()}
    of_case = {case: values for case, values in of_case.items() if values}
    shorter = {case: below(interval(values), 0.6 if case in ("case 1", "case 2") else 0.95) for case, values in of_case.items()}
    means = [mean(values) for values in of_case.values()]
    late_ratios = [ratios(*late(every, period), path_m) for period in PERIODS]
    least = min(mean(values) for values in late_ratios if values)
    return ("*When both succeed, fusion's path is much shorter (about half in cases 1 and 2).* " + verdict(decide(shorter)) +
            f" Fusion's path as a part of arbitration's with the same seed, where both succeed: {min(means):.3f} to {max(means):.3f} in the mean of a case. In case 2 "
            f"with a decision every {', '.join(PERIODS)} s it is " + ", ".join(mean_with_interval(values, 2) for values in late_ratios) +
            (": where decisions come late it holds." if least < 0.6 else
             ": where decisions come late fusion's path is the shorter one, if not by half." if least < 0.9 else ".") + against(shorter))


def third(every):
    runs = cases(every)
    pairs = {case: both_succeed(*both) for case, both in runs.items()}
    pairs = {case: both for case, both in pairs.items() if both}
    seconds = {case: [mean(seconds_per_metre(pair[k]) for pair in both) for k in (1, 0)] for case, both in pairs.items()}
    faster = {case: below(interval(ratios(arbitration, fusion, seconds_per_metre)), 1.0) for case, (fusion, arbitration) in runs.items() if case in pairs}
    fusion, arbitration = ([run for both in runs.values() for run in both[k]] for k in (0, 1))
    won = [(len(successes(some)), len(some)) for some in (arbitration, fusion)]
    low, high = difference_of_rates(*won[0], *won[1])
    trade = {"cases 1 to 7": below((low, high), 0.0)}
    return ("*Arbitration is faster per metre; there is a trade-off of speed against success.* " +
            first_and_second(decide(faster), decide(trade)) +
            " Seconds per metre where both succeed with the same seed, arbitration against fusion: " +
            ", ".join(f"{case} {a:.2f} against {f:.2f}" for case, (a, f) in seconds.items()) +
            f". Arbitration succeeds in {share(arbitration)} runs of cases 1 to 7, fusion in {share(fusion)}" +
            (f": a difference of {100 * low:.0f} to {100 * high:.0f} % of the runs (95 % interval)." if arbitration and fusion else "."))


def fourth(every):
    four = every["four_resources"]
    runs = {scheme: [four.of(coordinator=scheme, layers=hidden) for hidden in LAYERS] for scheme in SCHEMES}
    two, larger, *deeper = runs["fusion"]
    saved = [a.time_s - b.time_s for a, b in both_succeed(two, larger)]
    # Larger networks help when they save time; deeper ones when they succeed more often. By the number of the case.
    helps = {"case 2": below([-end for end in reversed(interval(saved))], 0.0) if saved else None}
    for k, some in zip((3, 4), deeper):
        helps[f"case {k}"] = below(difference_of_rates(len(successes(two)), len(two), len(successes(some)), len(some)), 0.0)
    times = {scheme: [f"{mean(run.time_s for run in successes(some)):.1f}" if successes(some) else "-" for some in runs[scheme]] for scheme in SCHEMES}
    return ("*Bigger networks help fusion, not arbitration.* " + verdict(decide(helps)) +
            " Success with " + ", ".join(LAYERS) + ": " +
            "; ".join(f"{scheme} {', '.join(share(some) for some in runs[scheme])}" for scheme in reversed(SCHEMES)) +
            ". Seconds, successes only: " + "; ".join(f"{scheme} {', '.join(times[scheme])}" for scheme in reversed(SCHEMES)) +
            (f". Four neurons a layer instead of two save fusion, in seconds of {mean(run.time_s for run in successes(two)):.0f}, {mean_with_interval(saved, 1)}; more layers only "
             "make fewer networks learn, for both schemes alike." if saved else ".") + against(helps))


def conclusions(every):
    return "\n".join(f"{k + 1}. {conclusion(every)}" for k, conclusion in enumerate((first, second, third, fourth)))
