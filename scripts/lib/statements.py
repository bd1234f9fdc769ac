"""The figures in the prose of docs/experiments.md and docs/every-coordinator.md, computed from the databases."""
import math
import re
import xml.etree.ElementTree
from statistics import mean

from claims import Claim, about, in_words, one_part
from pairs import path_m, sum_of_steps
from parts import ORIGINAL, ORIGINAL_STEP_S, ORIGINAL_STEPS, PERIODS, SCHEMES, published, same
from results import successes

EXPERIMENTS, COORDINATORS = "experiments.md", "every-coordinator.md"


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
    found = [re.search(r"whatever the input, \((\S+), (\S+)\)", note) for run in runs for note in run.notes]
    return [mean(float(match.group(k)) for match in found if match) for k in (1, 2)]


def shortest_tour(results):
    """The distance from the origin to the corners of the square of the resources."""
    resources = xml.etree.ElementTree.fromstring(results.world(results.runs[0])).iter("resource")
    corners = [(float(e.get("x")), float(e.get("y"))) for e in resources]
    side = min(math.dist(corners[0], corner) for corner in corners[1:])
    return math.hypot(*corners[0]) + 3 * side


def four_resources(every):
    four = every["four_resources"]
    arbitration, fusion = ([four.of(coordinator=scheme, layers=hidden) for hidden in ("2 2", "4 4", "2 2 2 2", "4 4 4 4")] for scheme in SCHEMES)
    lost = [run for runs in arbitration for run in runs if not run.learned() and not run.success]
    avoid, find = plateau_outputs(fusion[2])
    learned = [run.error() for run in fusion[0] if run.learned()]
    original = {(case, scheme): ORIGINAL[case, scheme] for case, scheme in ORIGINAL}
    yield Claim(EXPERIMENTS, "The shortest tour is {:.2f} m from middle to middle.", shortest_tour(four))
    yield Claim(EXPERIMENTS, "**Arbitration, cases 1 and 2: {:.0f} and {:.0f} % of the original's path.**",
                *(100 * mean_path(arbitration[k]) / original[case, "arbitration"][0] for k, case in enumerate("12")))
    yield Claim(EXPERIMENTS, "**Fusion, case 1: {:.0f} s instead of {:.0f} s.**", mean_time(fusion[0]), original["1", "fusion"][1])
    yield Claim(EXPERIMENTS, "ours have {:.1e}; case 2, with a net as good as ours (3.8e-5), took it {:.0f} s.", mean(learned), original["2", "fusion"][1])
    yield Claim(EXPERIMENTS, "ours take {:.0f} s more,", mean_time(fusion[1]) - original["2", "fusion"][1])
    yield Claim(EXPERIMENTS, "Ours goes at {:.2f} m/s. The original's paths and times come to {:.2f} m/s,",
                mean(run.path_m / run.time_s for run in lost), mean(original[case, "arbitration"][0] / original[case, "arbitration"][1] for case in "34"))
    way, time = original["4", "fusion"][:2]
    yield Claim(EXPERIMENTS, "**Fusion, case 4: {:.0f} s instead of {:.0f} s.** The original's {:.0f} m in {:.0f} s are {:.2f} m/s, against {:.2f} m/s in its cases 2 and 3:",
                mean_time(fusion[3]), time, way, time, way / time, mean(original[case, "fusion"][0] / original[case, "fusion"][1] for case in "23"))
    yield Claim(EXPERIMENTS, "**Fusion, cases 1 and 2: {:.1f} m shorter than the original's.**",
                mean(original[case, "fusion"][0] - mean_path(runs) for case, runs in zip("12", fusion)))
    yield Claim(EXPERIMENTS, "Of \"4 4 4 4\" {} in {} of our networks did not learn.", in_words(sum(not run.learned() for run in arbitration[3])),
                in_words(len(arbitration[3])), holds=all(run.success == run.learned() for run in arbitration[3]))
    yield Claim(EXPERIMENTS, "both behaviours have fixed weights, {:.2f} and {:.2f}:", avoid, find)
    yield Claim(EXPERIMENTS, "ours is the mean of all, {:.4f} there.", max(run.error() for run in fusion[2]))
    yield Claim(EXPERIMENTS, "\"2 2 2 2\" hardly ever does.", holds=sum(run.learned() for run in fusion[2]) <= 0.1 * len(fusion[2]))
    yield Claim(EXPERIMENTS, "small nets learn,", holds=all(sum(run.learned() for run in runs) >= 0.9 * len(runs) for runs in fusion[:2]))
    yield Claim(EXPERIMENTS, "\"4 4 4 4\" mostly learns:", holds=sum(run.learned() for run in fusion[3]) >= 0.8 * len(fusion[3]))


def before_a_resource(every):
    obstacles = every["obstacles"]
    one, two, staggered = (obstacles.by_scheme(world=world) for world in ("one_obstacle", "two_obstacles", "two_obstacles_staggered"))
    yield Claim(EXPERIMENTS, "Fusion takes {:.1f} times as long as arbitration (the original's {:.1f} times),", mean_time(one[0]) / mean_time(one[1]),
                ORIGINAL["5", "fusion"][1] / ORIGINAL["5", "arbitration"][1])
    yield Claim(EXPERIMENTS, "**Case 6: {} (fusion) and {} (arbitration) of the original's way.**",
                *(one_part(mean_path(runs) / ORIGINAL["6", scheme][0]) for scheme, runs in zip(("fusion", "arbitration"), two)))
    yield Claim(EXPERIMENTS, "{:.0f} m and {:.0f} m are {:.1f} and {:.1f} times the distance.", ORIGINAL["6", "fusion"][0], ORIGINAL["6", "arbitration"][0],
                ORIGINAL["6", "fusion"][0] / 4, ORIGINAL["6", "arbitration"][0] / 4)
    ends = [obstacles.poses(run, "collector")[-1] for runs in staggered for run in runs]
    yield Claim(EXPERIMENTS, "the robot goes back to the second box and stands against its end for ever", holds=all(
        math.dist(end[:2], (2.67, -0.05)) < 0.25 for end in ends))
    yield Claim(EXPERIMENTS, "**Case 6, staggered: fails in both schemes.**", holds=all(none_succeeds(runs) for runs in staggered))


def clutter(every):
    fusion, arbitration = every["clutter"].by_scheme()
    yield Claim(EXPERIMENTS, "Both succeed, as in the original, on {} (fusion) and {} (arbitration) of the way:",
                *(one_part(mean_path(runs) / ORIGINAL["7", scheme][0]) for scheme, runs in (("fusion", fusion), ("arbitration", arbitration))),
                holds=all_succeed(fusion) and all_succeed(arbitration))
    yield Claim(EXPERIMENTS, "The original's {:.0f} m and {:.0f} m", ORIGINAL["7", "fusion"][0], ORIGINAL["7", "arbitration"][0])


def eight_clutters(every):
    for layout in range(1, 9):
        assert every["clutters"].of(world=f"clutter_{layout}")
    tried = {layout: every["clutters"].by_scheme(world=f"clutter_{layout}") for layout in range(1, 9)}
    both = [layout for layout, runs in tried.items() if all(all_succeed(some) for some in runs)]
    yield Claim(EXPERIMENTS, "In layouts {} both schemes always succeed,", " and ".join(map(str, both)))


def backing_off(every):
    results = every["backing_off"]
    worlds = ["one_obstacle", "two_obstacles", "two_obstacles_staggered"]
    yield Claim(EXPERIMENTS, "Arbitration stops before the first thing that both beams see:", holds=none_succeeds(results.of(coordinator="arbitration")))
    yield Claim(EXPERIMENTS, "Fusion does both at once and gets past, slowly,", holds=all(all_succeed(results.of(world=world, coordinator="fusion")) for world in worlds[:2]))
    yield Claim(EXPERIMENTS, "but not past staggered obstacles.", holds=none_succeeds(results.of(world=worlds[2], coordinator="fusion")))


def loses_sight(run):
    """Whether a tour of the four resources is longer than the shortest one by more than the figures of a straight one vary."""
    return run.path_m > 30.5


def decision_period(every):
    results = every["decision_period"]
    fusion, arbitration = ({period: results.of(world="four_resources", coordinator=scheme, period=f"{period} s") for period in PERIODS}
                           for scheme in ("fusion", "arbitration"))
    way, time = ORIGINAL["2", "arbitration"][:2]
    yield Claim(EXPERIMENTS, "With a decision every 0.4 or 0.5 s arbitration takes {:.0f} and {:.0f} s, the original's {:.0f} s, and {:.0f} and {:.0f} % of its way:",
                mean_time(arbitration["0.4"]), mean_time(arbitration["0.5"]), time, *(100 * mean_path(arbitration[period]) / way for period in ("0.4", "0.5")))
    yield Claim(EXPERIMENTS, "With a decision every 0.3 s arbitration loses it with all networks, fusion with none; every 0.4 s fusion does with {} of {},",
                sum(map(loses_sight, fusion["0.4"])), len(fusion["0.4"]),
                holds=all(map(loses_sight, arbitration["0.3"] + arbitration["0.4"] + arbitration["0.5"])) and not any(map(loses_sight, fusion["0.3"])))
    yield Claim(EXPERIMENTS, "every 0.5 s it always does, and only {} of {} are done within 400 s.", len(successes(fusion["0.5"])), len(fusion["0.5"]),
                holds=all(map(loses_sight, fusion["0.5"])))
    counts = [ORIGINAL_STEPS[case, scheme] for case in "56" for scheme in SCHEMES]
    yield Claim(EXPERIMENTS, "Adding {} in single precision {}, {}, {} and {} times gives {:.6f}, {:.6f}, {:.6f} and {:.6f}.", ORIGINAL_STEP_S, *counts,
                *(sum_of_steps(ORIGINAL_STEP_S, count) for count in counts))
    yield Claim(EXPERIMENTS, "With 0.2 s, twice the original's period, both schemes still drive straight ({:.2f} and {:.2f} m in case 2),",
                mean_path(arbitration["0.2"]), mean_path(fusion["0.2"]), holds=not any(map(loses_sight, arbitration["0.2"] + fusion["0.2"])))
    passed = [run for scheme in SCHEMES for run in results.of(world="two_obstacles_staggered", coordinator=scheme, period="0.4 s")]
    yield Claim(EXPERIMENTS, "With a decision every 0.4 s both schemes succeed: see below.", holds=all_succeed(passed))
    yield Claim(EXPERIMENTS, "With a decision every 0.4 s the staggered obstacles are always passed, too:", holds=all_succeed(passed))


def groups(every):
    results = every["groups"]
    column, default = results.of(world="to_a_resource_in_a_column"), results.of(world="to_a_resource")

    def farthest(run):
        ends = {robot: results.poses(run, robot)[-1] for robot in results.robots(run)}
        return max(math.dist(ends[robot][:2], ends["leader"][:2]) for robot in ends)

    yield Claim(EXPERIMENTS, "all arrive with it when each has a distance of its own, up to {:.1f} m.", max(farthest(run) for run in column), holds=all_succeed(column))
    yield Claim(EXPERIMENTS, "In {} runs of {} two of them get wedged", in_words(len(default) - len(successes(default))), in_words(len(default)))
    yield Claim(EXPERIMENTS, "All within its coverage gather around it, the others do not move at all.",
                holds=all(all_succeed(results.of(world=world)) for world in ("within_1.5_m", "within_3_m")))


def every_coordinator(every):
    study, networks = every["every_coordinator"], published(every)
    worlds = ["four_resources", "one_obstacle", "two_obstacles", "two_obstacles_staggered", "clutter"]
    first, above = "arbiter_suppression (find_resource first)", "arbiter_subsumption (avoid_obstacle above)"
    runs = {(run.levels["coordinator"], run.levels["world"]): run for run in study.runs}
    labels = dict.fromkeys(run.levels["coordinator"] for run in study.runs)

    def fastest(world):
        return min(runs[label, world].time_s for label in labels if runs[label, world].success)

    everywhere = {label for label in labels if all(runs[label, world].success for world in worlds)}
    yield Claim(COORDINATORS, "**Three complete every column:** vector summation; `arbiter_strength`,",
                holds=everywhere == {"fusion_vector_summation", "arbiter_strength", above})
    yield Claim(COORDINATORS, "its figures are the same to 2 %, but for the staggered obstacles.", holds=all(
        about(mean(figure(run) for run in successes(networks[world, "arbitration"])) / figure(runs[above, world]), 1, 0.02)
        for world in worlds if "staggered" not in world for figure in (path_m, lambda run: run.time_s)))
    yield Claim(COORDINATORS, "In the empty arena and through a gap, `find_resource` first is the best there is; one obstacle in its way holds it for ever,",
                holds=all(about(runs[first, world].time_s, fastest(world), 0.05) for world in ("four_resources", "two_obstacles"))
                and not runs[first, "one_obstacle"].success)
    yield Claim(COORDINATORS, "**`avoid_obstacle` first never collects anything.**",
                holds=all(run.collected == 0 for run in study.of(coordinator="arbiter_suppression (avoid_obstacle first)")))
    three = [[runs[label, world].time_s for label in ("arbiter_voting", "fusion_fuzzy", "fusion_interval") if runs[label, world].success] for world in worlds]
    yield Claim(COORDINATORS, "agree with each other to a tenth of the time, in the clutter, too.",
                holds=all(not times or (len(times) == 3 and max(times) < 1.1 * min(times)) for times in three))
    yield Claim(COORDINATORS, "**Fusion by a network is the slowest of those that succeed:**", holds=all(
        mean_time(networks[world, "fusion"]) > max([runs[label, world].time_s for label in labels if runs[label, world].success] +
                                                   [mean_time(networks[world, "arbitration"])])
        for world in worlds if successes(networks[world, "fusion"])))
    yield Claim(COORDINATORS, "**In the clutter vector summation takes more than twice the way of the others:**", holds=runs["fusion_vector_summation", "clutter"].path_m > 2 * max(
        [runs[label, "clutter"].path_m for label in labels if runs[label, "clutter"].success and label != "fusion_vector_summation"] +
        [mean_path(networks["clutter", scheme]) for scheme in SCHEMES]))


def statements(every):
    """All claims of both pages."""
    return [claim for part in (four_resources, before_a_resource, backing_off, clutter, eight_clutters, decision_period, groups, every_coordinator)
            for claim in part(every)]
