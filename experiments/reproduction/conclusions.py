"""The four conclusions of the original: the verdicts of the deciding experiment, and the figures of cases 1 to 7."""
from statistics import mean

from deciding import BIGGER, FASTER_PER_METRE, FUSION_COMPLETES, SHORTER_PATH, TRADE_OFF, UNTRAINED_FAILS
from pairs import both_succeed, difference_of_rates, mean_with_interval, path_m, ratios, seconds_per_metre
from parts import CASES_5_AND_6, LAYERS, PERIODS, SCHEMES
from results import share, successes, table


def cases(every):
    """The runs of cases 1 to 7 with fusion and with arbitration: {case: (runs, runs)}."""
    runs = {f"case {k + 1}": every["four_resources"].by_scheme(layers=hidden) for k, hidden in enumerate(LAYERS)}
    for case, world in CASES_5_AND_6:
        runs[f"case {case}"] = every["obstacles"].by_scheme(world=world, search="left")
    runs["case 7"] = every["clutter"].by_scheme()
    return runs


def verdict(entry, decided):
    """What the deciding experiment says about half a conclusion. decided: [(name of the cases, {key: Share})]."""
    key, words, _ = entry
    told = []
    for name, found in decided:
        one = found.get(key)
        if one:
            told.append(f"**{one.verdict()}** for {name} (it holds in {one.holds} of {one.judged} set-ups)")
    return f"{words[0].upper()}{words[1:]}: {', '.join(told)}."


def pair_row(name, fusion, arbitration):
    """The values of the two where both succeed; empty if they never do."""
    pairs = both_succeed(fusion, arbitration)
    seconds = [f"{mean(seconds_per_metre(pair[k]) for pair in pairs):.2f}" if pairs else "-" for k in (1, 0)]
    return [name, len(pairs), mean_with_interval(ratios(fusion, arbitration, path_m), 3), *seconds,
            mean_with_interval(ratios(arbitration, fusion, seconds_per_metre), 3)]


def where_both_succeed(every):
    rows = [pair_row(case, *runs) for case, runs in cases(every).items()]
    for period in PERIODS:
        rows.append(pair_row(f"case 2, a decision every {period} s", *of_period(every, period)))
    return table(["", "pairs of runs", "fusion's path / arbitration's", "s/m, arbitration", "s/m, fusion", "arbitration's s/m / fusion's"], rows)


def of_period(every, period):
    return every["decision_period"].by_scheme(world="four_resources", period=f"{period} s")


def first(every, decided):
    runs = cases(every)
    fusion = [run for both in runs.values() for run in both[0]]
    four = every["four_resources"]
    split = {scheme: {learned: [run for run in four.of(coordinator=scheme) if run.learned() == learned] for learned in (True, False)}
             for scheme in SCHEMES}
    incomplete = [f"{case} ({share(both[0])})" for case, both in runs.items() if len(successes(both[0])) < len(both[0])]
    return ("*Fusion completes every case; arbitration fails where its network did not train.* " + verdict(FUSION_COMPLETES, decided) + " " +
            verdict(UNTRAINED_FAILS, decided) + f" On this page: fusion completes {share(fusion)} runs of cases 1 to 7" +
            (f"; it does not always in {', '.join(incomplete)}" if incomplete else "") +
            f". In cases 1 to 4 arbitration succeeds with {share(split['arbitration'][True])} networks that learned all samples and with "
            f"{share(split['arbitration'][False])} of the others; fusion succeeds with {share(split['fusion'][False])} of the others.")


def second(every, decided):
    of_case = {case: ratios(*both, path_m) for case, both in cases(every).items()}
    means = [mean(values) for values in of_case.values() if values]
    late = [ratios(*of_period(every, period), path_m) for period in PERIODS]
    return ("*When both succeed, fusion's path is much shorter (about half in cases 1 and 2).* " + verdict(SHORTER_PATH, decided) +
            f" On this page: fusion's path as a part of arbitration's with the same seed, where both succeed: {min(means):.3f} to {max(means):.3f} in the mean of a "
            f"case. In case 2 with a decision every {', '.join(PERIODS)} s it is " + ", ".join(mean_with_interval(values, 2) for values in late) + ".")


def third(every, decided):
    runs = cases(every)
    pairs = {case: both_succeed(*both) for case, both in runs.items()}
    seconds = {case: [mean(seconds_per_metre(pair[k]) for pair in both) for k in (1, 0)] for case, both in pairs.items() if both}
    fusion, arbitration = ([run for both in runs.values() for run in both[k]] for k in (0, 1))
    low, high = difference_of_rates(len(successes(arbitration)), len(arbitration), len(successes(fusion)), len(fusion))
    return ("*Arbitration is faster per metre; there is a trade-off of speed against success.* " + verdict(FASTER_PER_METRE, decided) + " " +
            verdict(TRADE_OFF, decided) + " On this page: seconds per metre where both succeed with the same seed, arbitration against fusion: " +
            ", ".join(f"{case} {a:.2f} against {f:.2f}" for case, (a, f) in seconds.items()) +
            f". Arbitration succeeds in {share(arbitration)} runs of cases 1 to 7, fusion in {share(fusion)}" +
            (f": a difference of {100 * low:.0f} to {100 * high:.0f} % of the runs (95 % interval)." if arbitration and fusion else "."))


def fourth(every, decided):
    four = every["four_resources"]
    runs = {scheme: [four.of(coordinator=scheme, layers=hidden) for hidden in LAYERS] for scheme in SCHEMES}
    times = {scheme: [f"{mean(run.time_s for run in successes(some)):.1f}" if successes(some) else "-" for some in runs[scheme]] for scheme in SCHEMES}
    return ("*Bigger networks help fusion, not arbitration.* " + " ".join(verdict(entry, decided) for entry in BIGGER) +
            " On this page: success with " + ", ".join(LAYERS) + ": " +
            "; ".join(f"{scheme} {', '.join(share(some) for some in runs[scheme])}" for scheme in reversed(SCHEMES)) +
            ". Seconds, successes only: " + "; ".join(f"{scheme} {', '.join(times[scheme])}" for scheme in reversed(SCHEMES)) + ".")


def verdicts(decided):
    """A line for each conclusion."""
    entries = [(FUSION_COMPLETES, UNTRAINED_FAILS), (SHORTER_PATH,), (FASTER_PER_METRE, TRADE_OFF), BIGGER]
    return "\n".join(f"{k + 1}. {' '.join(verdict(entry, decided) for entry in halves)}" for k, halves in enumerate(entries))


def conclusions(every, decided):
    return "\n".join(f"{k + 1}. {conclusion(every, decided)}" for k, conclusion in enumerate((first, second, third, fourth)))
