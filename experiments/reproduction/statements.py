"""The figures in the prose of the pages of the published experiments, in docs/research/, computed from the archive of runs."""
import math
from statistics import mean

import comparison
import deciding
from claims import Claim, about, in_words, one_part
from pairs import path_m, sum_of_steps
from parts import ORIGINAL, ORIGINAL_STEP_S, ORIGINAL_STEPS, SCHEMES
from results import successes

EXPERIMENTS, COORDINATORS, STEP = "experiments.md", "every-coordinator.md", "original-step.md"
TOUR_M = 4 * math.sqrt(2) + 3 * 8  # from the origin to the corners of the square of the resources


def mean_path(runs):
    return mean(run.path_m for run in successes(runs))


def mean_time(runs):
    return mean(run.time_s for run in successes(runs))


def all_succeed(runs):
    return all(run.success for run in runs)


def none_succeeds(runs):
    return not successes(runs)


def plateau_outputs(runs):
    """The constant answers of networks on a plateau, in the mean over the networks."""
    found = [run.outputs for run in runs if run.outputs]
    return [mean(outputs[k] for outputs in found) for k in (0, 1)]


def corner_distance(run):
    """How far from the nearest corner of the arena of 10 m the robot ended, m."""
    x, y = run.robots["collector"][1]
    return math.hypot(5 - abs(x), 5 - abs(y))


def four_resources(every):
    four = every["four_resources"]
    arbitration, fusion = ([four.of(coordinator=scheme, layers=hidden) for hidden in ("2 2", "4 4", "2 2 2 2", "4 4 4 4")] for scheme in SCHEMES)
    lost = [run for runs in arbitration for run in runs if not run.learned()]
    avoid, find = plateau_outputs(fusion[2])
    yield Claim(EXPERIMENTS, "The shortest tour is {:.2f} m from middle to middle.", TOUR_M)
    yield Claim(EXPERIMENTS, "**Arbitration, cases 1 and 2: {:.0f} and {:.0f} % of the original's path.**",
                *(100 * mean_path(arbitration[k]) / ORIGINAL[case, "arbitration"][0] for k, case in enumerate("12")),
                holds=not any(map(loses_sight, successes(arbitration[0] + arbitration[1]))))
    yield Claim(EXPERIMENTS, "**Fusion, case 2: {:.0f} s instead of {:.0f} s.**", mean_time(fusion[1]), ORIGINAL["2", "fusion"][1])
    yield Claim(EXPERIMENTS, "ours take {:.0f} s more,", mean_time(fusion[1]) - ORIGINAL["2", "fusion"][1])
    yield Claim(EXPERIMENTS, "In case 1 the original took {:.0f} s, with an error of 3.0e-4 after training; ours is {:.1e}.", ORIGINAL["1", "fusion"][1],
                mean(run.error() for run in fusion[0] if run.learned()))
    yield Claim(EXPERIMENTS, "The robot drives along the walls until a corner holds it (picture),", holds=all(not run.success and corner_distance(run) < 0.2 for run in lost))
    yield Claim(EXPERIMENTS, "The original's paths and times give {:.2f} m/s,",
                mean(ORIGINAL[case, "arbitration"][0] / ORIGINAL[case, "arbitration"][1] for case in "34"))
    yield Claim(EXPERIMENTS, "Of \"4 4 4 4\" {} in {} of our networks did not learn.", in_words(sum(not run.learned() for run in arbitration[3])),
                in_words(len(arbitration[3])), holds=all(run.success == run.learned() for run in arbitration[3]))
    yield Claim(EXPERIMENTS, "both behaviours have fixed weights, {:.2f} and {:.2f}:", avoid, find)
    spared = [run for runs in fusion for run in runs if run.success and not run.learned()]
    yield Claim(EXPERIMENTS, "{} networks that missed a sample and with which arbitration fails complete the tour under fusion.", in_words(len(spared)),
                holds=not any(run.flat for run in spared))
    way, time = ORIGINAL["4", "fusion"][:2]
    yield Claim(EXPERIMENTS, "**Fusion, case 4: {:.0f} s instead of {:.0f} s.** The original's {:.0f} m in {:.0f} s are {:.2f} m/s, against {:.2f} m/s in its cases 2 and 3:",
                mean_time(fusion[3]), time, way, time, way / time, mean(ORIGINAL[case, "fusion"][0] / ORIGINAL[case, "fusion"][1] for case in "23"))
    yield Claim(EXPERIMENTS, "ours is the mean of all, {:.4f} there.", max(run.error() for run in fusion[2]))
    yield Claim(EXPERIMENTS, "\"2 2 2 2\" mostly does not.", holds=sum(run.learned() for run in fusion[2]) < 0.5 * len(fusion[2]))
    yield Claim(EXPERIMENTS, "small nets learn,", holds=all(sum(run.learned() for run in runs) >= 0.9 * len(runs) for runs in fusion[:2]))
    yield Claim(EXPERIMENTS, "\"4 4 4 4\" mostly learns:", holds=sum(run.learned() for run in fusion[3]) >= 0.8 * len(fusion[3]))


def before_a_resource(every):
    obstacles = every["obstacles"]
    one, two, staggered = (obstacles.by_scheme(world=world, search="left") for world in ("one_obstacle", "two_obstacles", "two_obstacles_staggered"))
    yield Claim(EXPERIMENTS, "Fusion takes {:.1f} times as long as arbitration (the original's {:.1f} times),", mean_time(one[0]) / mean_time(one[1]),
                ORIGINAL["5", "fusion"][1] / ORIGINAL["5", "arbitration"][1])
    yield Claim(EXPERIMENTS, "**Case 6: {} (fusion) and {} (arbitration) of the original's way.**",
                *(one_part(mean_path(runs) / ORIGINAL["6", scheme][0]) for scheme, runs in zip(("fusion", "arbitration"), two)))
    yield Claim(EXPERIMENTS, "{:.0f} m and {:.0f} m are {:.1f} and {:.1f} times the distance.", ORIGINAL["6", "fusion"][0], ORIGINAL["6", "arbitration"][0],
                ORIGINAL["6", "fusion"][0] / 4, ORIGINAL["6", "arbitration"][0] / 4)
    failed = [run for runs in staggered for run in runs if not run.success]
    yield Claim(EXPERIMENTS, "the robot goes back to the second box and stands against its end for ever (picture).", holds=all(
        math.dist(run.robots["collector"][1], (2.67, -0.05)) < 0.25 for run in failed))
    yield Claim(EXPERIMENTS, "This happens in all runs of fusion and in {} of {} of arbitration.", len(staggered[1]) - len(successes(staggered[1])), len(staggered[1]),
                holds=none_succeeds(staggered[0]))
    yield Claim(EXPERIMENTS, "A robot that searches to the right always succeeds:", holds=all_succeed(obstacles.of(search="right")))
    yield Claim(EXPERIMENTS, "So the {} failures of fusion are one invented layout with one of two searches,", in_words(len(staggered[0])))


def clutter(every):
    fusion, arbitration = every["clutter"].by_scheme()
    same = len({run.seed for run in successes(fusion)} & {run.seed for run in successes(arbitration)})
    yield Claim(EXPERIMENTS, "Each scheme succeeds in {} of {} layouts, {} of them the same. Where they succeed, their paths are {:.0f} and {:.0f} m:",
                len(successes(fusion)), len(fusion), same, mean_path(arbitration), mean_path(fusion), holds=len(successes(fusion)) == len(successes(arbitration)))
    yield Claim(EXPERIMENTS, "The original's {:.0f} m and {:.0f} m", ORIGINAL["7", "fusion"][0], ORIGINAL["7", "arbitration"][0])


def backing_off(every):
    yield Claim(EXPERIMENTS, "At this step no run succeeds:", holds=none_succeeds(every["backing_off"].runs))


def loses_sight(run):
    """Whether a tour of the four resources is longer than the shortest one by more than the figures of a straight one vary."""
    return run.path_m > 30.5


def decision_period(every):
    results = every["decision_period"]
    counts = [ORIGINAL_STEPS[case, scheme] for case in "56" for scheme in SCHEMES]
    yield Claim(EXPERIMENTS, "Adding {} in single precision {}, {}, {} and {} times gives {:.6f}, {:.6f}, {:.6f} and {:.6f}.", ORIGINAL_STEP_S, *counts,
                *(sum_of_steps(ORIGINAL_STEP_S, count) for count in counts))
    straight = [run for run in results.of(world="four_resources", period="0.01 s") + sum(every["four_resources"].by_scheme(layers="4 4"), [])]
    yield Claim(EXPERIMENTS, "With 0.1 s both schemes drive straight from resource to resource, as with 0.01 s.", holds=all_succeed(straight) and not any(map(loses_sight, straight)))
    late = {period: results.by_scheme(world="four_resources", period=f"{period} s") for period in ("0.3", "0.4")}
    sentence = "every {} s{} arbitration succeeds in {} of {}{} and takes {:.1f} m, fusion in {} and takes {:.1f} m"
    for period, words in (("0.3", (",", " runs")), ("0.4", ("", ""))):
        fusion, arbitration = late[period]
        yield Claim(EXPERIMENTS, sentence, period, words[0], len(successes(arbitration)), len(arbitration), words[1], mean_path(arbitration), len(successes(fusion)), mean_path(fusion))
    yield Claim(EXPERIMENTS, "The original's paths were {:.1f} and {:.1f} m.", ORIGINAL["2", "arbitration"][0], ORIGINAL["2", "fusion"][0])


def groups(every):
    results = every["groups"]
    column, default = results.of(world="to_a_resource_in_a_column"), results.of(world="to_a_resource")
    near = {sum(math.dist(end, run.robots["leader"][1]) <= 0.5 for robot, (_, end) in run.robots.items() if robot != "leader") for run in column}
    yield Claim(EXPERIMENTS, "**A leader that finds a resource: as in the original** with the default parameters,", holds=all_succeed(default))
    yield Claim(EXPERIMENTS, "{} of four are within 0.5 m at the end.", in_words(min(near)), holds=len(near) == 1 and all(run.collected == 1 for run in column))
    yield Claim(EXPERIMENTS, "**With own distances nobody touches,", holds=all(run.collisions == 0 for run in column))
    yield Claim(EXPERIMENTS, "All within its coverage gather around it, the others do not move at all.",
                holds=all(all_succeed(results.of(world=world)) for world in ("within_1.5_m", "within_3_m")))


def every_coordinator(published_):
    """Of docs/research/every-coordinator.md."""
    study, compared = comparison.Study(published_.study), published_.compared
    dominance = comparison.Dominance(compared, study.coordinators)
    cells = {(cell["coordinator"], cell["world"]): cell for cell in compared["cells"]}
    won = {key: cell["successes"] for key, cell in cells.items()}
    everyone, sum_of_all, worst = study.coordinators, "fusion_vector_summation", "fusion_null_space"
    overall = {name: compared["overall"][name]["success"] for name in everyone}

    def interval(name, world):
        return [100 * end for end in cells[name, world]["interval"]]

    def apart(world, measure):
        return sum(comparison.is_apart(effects[measure]) for _, _, effects in compared["pairs"][world] if measure in effects)

    def differences(measure):
        """Of vector summation from each other one over all cases: the difference and its interval in percent of the runs, the smallest first."""
        found = [(effects[measure], 1 if first == sum_of_all else -1) for first, second, effects in compared["pairs"][comparison.EVERYWHERE] if sum_of_all in (first, second)]
        return sorted([100 * sign * effect[0], *sorted(100 * sign * end for end in effect[1:3])] for effect, sign in found)

    never, pairs = dominance.never_dominated(), len(everyone) * (len(everyone) - 1) // 2
    yield Claim(COORDINATORS, "**{} of {} coordinators are dominated,** {} never:", in_words(len(everyone) - len(never)).capitalize(), in_words(len(everyone)), in_words(len(never)),
                holds=never == ["arbiter_action_selection", "arbiter_states", "arbiter_tree", "fusion_context_blending", "fusion_interval", sum_of_all])
    least, *_, most = more = differences("success")
    yield Claim(COORDINATORS, "**Vector summation succeeds more often than every other one,** by {:.0f} ({:.0f} to {:.0f}) to {:.0f} ({:.0f} to {:.0f}) % of the runs:", *least, *most,
                holds=all(low > 0 for _, low, _ in more) and sum(comparison.is_apart(effects["success"]) for first, second, effects in compared["pairs"][comparison.EVERYWHERE]
                                                                 if sum_of_all in (first, second)) == len(everyone) - 1)
    yield Claim(COORDINATORS, "it alone leaves the trap, in {} of 20 runs (95 % interval: {:.0f} to {:.0f} %),", won[sum_of_all, "trap"], *interval(sum_of_all, "trap"),
                holds=all(won[name, "trap"] == 0 for name in everyone if name != sum_of_all))
    passing = [name for name in everyone if won[name, "one_obstacle"] == 20]
    yield Claim(COORDINATORS, "and is among the {} that pass one obstacle in all runs; the other {} never do.", in_words(len(passing)), in_words(len(everyone) - len(passing)),
                holds=set(passing) == {"arbiter_neural_network", "arbiter_subsumption", "fusion_ib2c", "fusion_neural_network", worst, sum_of_all}
                and all(won[name, "one_obstacle"] == 0 for name in everyone if name not in passing))
    slower = [cells[sum_of_all, world]["time_s"] / min(cells[name, world]["time_s"] or math.inf for name in everyone) for world in ("four_resources", "resources")]
    yield Claim(COORDINATORS, "with four resources it takes {:.1f} and {:.1f} times as long as the fastest,", *slower)
    yield Claim(COORDINATORS, "**In the clutter nobody is ahead of anybody:** {} to {} of 20 runs, and of the {} pairs none differs in successes, times or touches.",
                min(won[name, "clutter"] for name in everyone), max(won[name, "clutter"] for name in everyone), pairs,
                holds=not any(apart("clutter", measure) for measure in comparison.BETTER))
    yield Claim(COORDINATORS, "**States, the tree and activation decide alike:** they are ahead of each other on no case.", holds=not any(
        dominance.ahead[one, other] for one in ("arbiter_states", "arbiter_tree", "arbiter_action_selection") for other in ("arbiter_states", "arbiter_tree", "arbiter_action_selection")))
    medians = {world: [cells[name, world]["time_s"] or math.inf for name in everyone] for world in ("four_resources", "two_obstacles", "resources")}
    slow = {world: cells["fusion_neural_network", world]["time_s"] for world in medians}
    factors = [slow[world] / min(medians[world]) for world in medians]
    yield Claim(COORDINATORS, "**Fusion by a network is the slowest:** it takes {:.1f} to {:.1f} times as long as the fastest.", min(factors), max(factors),
                holds=all(slow[world] == max(median for median in medians[world] if median < math.inf) for world in medians))
    yield Claim(COORDINATORS, "**Null-space control succeeds least often,** in {:.0f} % ({:.0f} to {:.0f} %) of the runs:", *(100 * value for value in overall[worst]),
                holds=min(overall, key=overall.get) == worst)
    yield from away(study, compared)


def away(study, compared):
    """What engine, noise and failures change."""
    single = [effects["success"] for name, _, _, effects in compared["away"] if name != comparison.EVERYBODY and "success" in effects]
    all_together = {level: effects for name, _, level, effects in compared["away"] if name == comparison.EVERYBODY}
    one_sided = sum(low is not None and (low > 0 or high < 0) for _, low, high, _ in single)
    yield Claim(COORDINATORS, "**No single coordinator's success changes for certain:** of {} differences none stays after the correction; {} intervals lie on one side of 0, where {:.0f} would by chance.",
                len(single), in_words(one_sided), 0.05 * len(single), holds=not any(map(comparison.is_apart, single)))
    more, low, high, _ = (100 * value for value in all_together["0.1 m too far"]["success"])
    yield Claim(COORDINATORS, "beams that see everything 0.1 m too far let them succeed in {:.0f} ({:.0f} to {:.0f}) % more of the runs.", more, low, high,
                holds=[level for level, effects in all_together.items() if comparison.is_apart(effects["success"])] == ["0.1 m too far"])
    yield Claim(COORDINATORS, "The other engine changes the rate of success by {:.0f} ({:.0f} to {:.0f}) %,", *(100 * value for value in all_together["planar"]["success"][:3]))
    yield Claim(COORDINATORS, "10 % noise by {:.0f} ({:.0f} to {:.0f}) %.", *(100 * value for value in all_together["10 %"]["success"][:3]))
    yield Claim(COORDINATORS, "Readings that are 0.3 s late cost time", holds=comparison.is_apart(all_together["0.3 s late"]["time_s"]) and all_together["0.3 s late"]["time_s"][0] > 0)


def original_step(published_):
    """Of docs/research/original-step.md."""
    arena, clutter = published_.arena, published_.clutter
    yield Claim(STEP, "The original's figures give {:.2f} and {:.2f} in cases 1 and 2, and {:.2f} in case 7", *(
        ORIGINAL[case, "fusion"][0] / ORIGINAL[case, "arbitration"][0] for case in "127"))
    yield Claim(STEP, "That makes {} set-ups for cases 1 to 4", len(arena.setups))
    yield Claim(STEP, "and {} for case 7", len(clutter.setups))
    often = {layers: sum(arena.rate(counts, "fusion", [layers]) >= deciding.COMPLETES for counts in arena.counts.values()) for layers in arena.layers}
    others = [count for layers, count in often.items() if layers != "2 2 2 2"]
    yield Claim(STEP, "It completes 90 % of its runs with \"2 2 2 2\" in {} of {} set-ups, with each other size in {} to {}.", often["2 2 2 2"], len(arena.setups), min(others), max(others))
    untrained = {scheme: sum(counts["untrained", scheme] for counts in arena.counts.values()) for scheme in SCHEMES}
    spared = {scheme: sum(counts["untrained successes", scheme] for counts in arena.counts.values()) for scheme in SCHEMES}
    yield Claim(STEP, "Of {} runs of arbitration with a network that missed a sample {} succeeds, of fusion {:.0f} %.", untrained["arbitration"],
                in_words(spared["arbitration"]), 100 * spared["fusion"] / untrained["fusion"])
    survives = [setup for setup in arena.setups if arena.counts[setup]["untrained successes", "fusion"] >= 0.5 * arena.counts[setup]["untrained", "fusion"]]
    yield Claim(STEP, "In {} set-ups fusion succeeds with at least half of these networks; in all of them beams do not see resources.", len(survives),
                holds=all(arena.level(setup, "beams") == "do not" for setup in survives))
    yield Claim(STEP, "but in none does it complete nine of ten runs with such networks.", holds=not any(
        counts["untrained successes", "fusion"] >= deciding.COMPLETES * counts["untrained", "fusion"] for counts in arena.counts.values()))
    least = [min(ratio for ratio in (deciding.mean_of_pairs(counts, "path ratio") for counts in study.counts.values()) if ratio) for study in (arena, clutter)]
    yield Claim(STEP, "In cases 1 to 4 the least mean of a set-up is {:.2f} of arbitration's, in case 7 {:.2f}.", *least)
    in_the_open = published_.arena_shares["3, first half"]
    yield Claim(STEP, "**Arbitration is faster per metre in the open,** in every set-up of cases 1 to 4.", holds=in_the_open.holds == in_the_open.judged)
    more = [[sum(study.succeeds_more(counts, *schemes) for counts in study.counts.values()) for schemes in (("fusion", "arbitration"), ("arbitration", "fusion"))]
            for study in (arena, clutter)]
    yield Claim(STEP, "fusion in {} set-ups of cases 1 to 4 and arbitration in {}; fusion in {} of case 7 and arbitration in {}.", *more[0], *more[1])
    exact = [sum(deciding.DIFFERENT * (won - other) == runs for (won, runs), (other, _) in (
        (study.won(counts, "fusion"), study.won(counts, "arbitration")) for counts in study.counts.values())) for study in (arena, clutter)]
    yield Claim(STEP, "In {} and {} of these set-ups fusion is ahead by exactly 10 %, so a slightly larger threshold would give other shares.", *exact)
    yield from what_decides(arena, clutter)
    yield from nearest(arena, clutter)


def rate_with(study, scheme, factor, *levels):
    """The success rate of a scheme over the set-ups with one of these levels."""
    return mean(study.rate(study.counts[setup], scheme) for setup in study.setups if study.level(setup, factor) in levels)


def what_decides(arena, clutter):
    schemes = ("fusion", "arbitration")
    last = [100 * rate_with(arena, scheme, "search", "last column") for scheme in schemes]
    other = [100 * rate_with(arena, scheme, "search", "left", "right", "last side") for scheme in schemes]
    yield Claim(STEP, "{:.0f} % of its runs with fusion and {:.0f} % with arbitration in cases 1 to 4, against {:.0f} and {:.0f} % with the other searches.", *last, *other)
    unseen = [100 * (rate_with(arena, scheme, "beams", "do not") - rate_with(arena, scheme, "beams", "see resources")) for scheme in schemes]
    yield Claim(STEP, "by {:.0f} % of the runs with fusion and {:.0f} % with arbitration in cases 1 to 4.", *unseen)
    small = [abs(rate_with(study, scheme, factor, first) - rate_with(study, scheme, factor, second)) for study, factor, first, second in (
        (arena, "limit", "none", "0.5 m/s"), (clutter, "limit", "none", "0.5 m/s"), (clutter, "boxes", "low", "high")) for scheme in schemes]
    yield Claim(STEP, "each changes success by at most {:.0f} % of the runs.", 100 * max(small))


def nearest(arena, clutter):
    found = [cell for layers in ("2 2", "4 4") for cell in deciding.cells(arena, layers)]
    steady = [metres for cell in found if min(cell.rate.values()) >= 0.5 for metres in cell.path_m.values()]
    yield Claim(STEP, "has paths between {:.1f} and {:.0f} m.", min(steady), max(steady))
    roams = [cell.setup for cell in found if cell.path_m["arbitration"] > 1.25 * TOUR_M]
    yield Claim(STEP, "the only set-ups with arbitration's long paths are those that go on in the last column and whose beams do not see resources.", holds=bool(roams) and all(
        arena.level(setup, "search") == "last column" and arena.level(setup, "beams") == "do not" for setup in roams))
    yield Claim(STEP, "In none is the mean path of arbitration above {} m.", 10 * math.ceil(max(cell.path_m["arbitration"] for cell in deciding.cells(clutter, "4 4")) / 10))


def statements(published_):
    """All claims of the three pages. published_: pages.Published."""
    every = published_.every
    found = [claim for part in (four_resources, before_a_resource, backing_off, clutter, decision_period, groups) for claim in part(every)]
    return found + list(every_coordinator(published_)) + list(original_step(published_))
