"""The four conclusions of the original, each confirmed or refuted with figures."""
from statistics import mean

from pairs import both_succeed, mean_with_interval, path_m, ratios, seconds_per_metre
from parts import CASES_5_AND_6, LAYERS, PERIODS, SCHEMES
from results import share, successes, table


def cases(every):
    """The runs of cases 1 to 7 with fusion and with arbitration: {case: (runs, runs)}."""
    runs = {f"case {k + 1}": every["four_resources"].by_scheme(layers=hidden) for k, hidden in enumerate(LAYERS)}
    for case, world in CASES_5_AND_6:
        runs[f"case {case}"] = every["obstacles"].by_scheme(world=world)
    runs["case 7"] = every["clutter"].by_scheme()
    return runs


def verdict(holds):
    return "**Confirmed.**" if holds else "**Refuted.**"


def first_and_second(first, second):
    """Of a conclusion of two halves."""
    if first == second:
        return verdict(first)
    words = {True: "confirmed", False: "refuted"}
    return f"**The first half is {words[first]}, the second {words[second]}.**"


def pair_row(name, fusion, arbitration):
    """What the two come to where both succeed; nothing where they never do."""
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
    incomplete = [f"{case} ({share(both[0])})" for case, both in runs.items() if len(successes(both[0])) < len(both[0])]
    fails = len(successes(split["arbitration"][False])) <= 0.1 * len(split["arbitration"][False])
    return ("*Fusion completes every case; arbitration fails where its network did not train.* " + first_and_second(not incomplete, fails) +
            f" Fusion completes {share(fusion)} runs of cases 1 to 7" +
            (f"; it does not always in {', '.join(incomplete)}" if incomplete else "") +
            f". In cases 1 to 4 arbitration succeeds with {share(split['arbitration'][True])} networks that learned all samples and with "
            f"{share(split['arbitration'][False])} of the others. So does fusion with {share(split['fusion'][False])} of the others.")


def second(every):
    of_case = {case: ratios(*both, path_m) for case, both in cases(every).items()}
    of_case = {case: values for case, values in of_case.items() if values}
    half = all(mean(of_case[case]) < 0.6 for case in ("case 1", "case 2"))
    shorter = all(mean(values) < 0.95 for values in of_case.values())
    means = [mean(values) for values in of_case.values()]
    late_ratios = [ratios(*late(every, period), path_m) for period in PERIODS]
    least = min(mean(values) for values in late_ratios if values)
    return ("*When both succeed, fusion's path is much shorter (about half in cases 1 and 2).* " + verdict(half and shorter) +
            f" Fusion's path as a part of arbitration's with the same seed, where both succeed: {min(means):.3f} to {max(means):.3f} in the mean of a case. In case 2 "
            f"with a decision every {', '.join(PERIODS)} s it is " + ", ".join(mean_with_interval(values, 2) for values in late_ratios) +
            (": where decisions come late it holds." if least < 0.6 else
             ": where decisions come late fusion's path is the shorter one, if not by half." if least < 0.9 else "."))


def third(every):
    runs = cases(every)
    pairs = {case: both_succeed(*both) for case, both in runs.items()}
    pairs = {case: both for case, both in pairs.items() if both}
    seconds = {case: [mean(seconds_per_metre(pair[k]) for pair in both) for k in (1, 0)] for case, both in pairs.items()}
    faster = all(arbitration < fusion for arbitration, fusion in seconds.values())
    fusion, arbitration = ([run for both in runs.values() for run in both[k]] for k in (0, 1))
    return ("*Arbitration is faster per metre; there is a trade-off of speed against success.* " +
            first_and_second(faster, len(successes(arbitration)) < len(successes(fusion))) +
            " Seconds per metre where both succeed with the same seed, arbitration against fusion: " +
            ", ".join(f"{case} {a:.2f} against {f:.2f}" for case, (a, f) in seconds.items()) +
            f". Arbitration succeeds in {share(arbitration)} runs of cases 1 to 7, fusion in {share(fusion)}.")


def fourth(every):
    four = every["four_resources"]
    runs = {scheme: [four.of(coordinator=scheme, layers=hidden) for hidden in LAYERS] for scheme in SCHEMES}
    two, larger, *deeper = runs["fusion"]
    saved = [a.time_s - b.time_s for a, b in both_succeed(two, larger)]
    as_often = min(len(successes(some)) for some in deeper) >= len(successes(two))
    times = {scheme: [f"{mean(run.time_s for run in successes(some)):.1f}" if successes(some) else "-" for some in runs[scheme]] for scheme in SCHEMES}
    return ("*Bigger networks help fusion, not arbitration.* " + ("**Confirmed.**" if mean(saved) > 0 and as_often else "**Refuted as it stands.**") +
            " Success with " + ", ".join(LAYERS) + ": " +
            "; ".join(f"{scheme} {', '.join(share(some) for some in runs[scheme])}" for scheme in reversed(SCHEMES)) +
            ". Seconds, successes only: " + "; ".join(f"{scheme} {', '.join(times[scheme])}" for scheme in reversed(SCHEMES)) +
            f". Four neurons a layer instead of two save fusion, in seconds of {mean(run.time_s for run in successes(two)):.0f}, {mean_with_interval(saved, 1)}; more layers only "
            "make fewer networks learn, for both schemes alike.")


def conclusions(every):
    return "\n".join(f"{k + 1}. {conclusion(every)}" for k, conclusion in enumerate((first, second, third, fourth)))
