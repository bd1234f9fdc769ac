#!/usr/bin/env python3
"""The script and its modules over a made-up database, and the pages over the archive of runs. Called with the source folder and the
program that makes an empty database."""
import contextlib
import importlib.machinery
import importlib.util
import io
import math
import random
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

SOURCE = Path(sys.argv.pop(1)).resolve()
RESEARCH = SOURCE / "docs" / "research"
EMPTY = sys.argv.pop(1)
sys.path[:0] = [str(SOURCE / "experiments" / "reproduction"), str(Path(__file__).resolve().parent)]

import archive  # noqa: E402
import claims  # noqa: E402
import conclusions  # noqa: E402
import deciding  # noqa: E402
import deciding_figures  # noqa: E402
import pages  # noqa: E402
import pairs  # noqa: E402
import parts  # noqa: E402
import repeats  # noqa: E402
import results  # noqa: E402
import trajectories  # noqa: E402
from made_up import MadeUp  # noqa: E402


def load_script():
    loader = importlib.machinery.SourceFileLoader("tables", str(SOURCE / "experiments" / "reproduction" / "tables"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("tables", loader))
    loader.exec_module(module)
    return module


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def made_up(self, **how):
        return MadeUp(self.folder / "made_up.sqlite", EMPTY, **how)

    def read(self, database):
        database.close()
        read = results.Results(self.folder / "made_up.sqlite")
        self.addCleanup(read.database.close)
        return read

    def told(self, action):
        """The sentence of its error."""
        with self.assertRaises(SystemExit) as ended:
            action()
        self.assertIsInstance(ended.exception.code, str)
        return ended.exception.code


class Databases(WithFolder):
    def test_runs_have_their_levels_measures_and_notes(self):
        made_up = self.made_up().cell(0, "maze", "fusion").cell(1, "maze", "arbitration")
        made_up.run(0, 3, path_m=2.5, time_s=7.0, collected=2, state_hash="ab", note="trained: mean error 2e-05 after 9 presentations")
        made_up.run(1, 3, outcome="time_limit", note="trained: mean error 0.02 after 9 presentations").run(1, 4)
        read = self.read(made_up)
        self.assertEqual(read.build["elsie"], "9.8.7")
        fusion, arbitration = read.by_scheme(world="maze")
        self.assertEqual([(run.seed, run.path_m, run.time_s, run.collected, run.state_hash) for run in fusion], [(3, 2.5, 7.0, 2, "ab")])
        self.assertTrue(fusion[0].success and fusion[0].learned())
        self.assertFalse(arbitration[0].success or arbitration[0].learned())
        self.assertIsNone(arbitration[1].error())
        self.assertFalse(arbitration[1].learned())
        with self.assertRaises(AssertionError):
            read.of(coordinator="fusoin")

    def test_one_with_runs_to_be_done_is_refused(self):
        made_up = self.made_up().cell(0, "maze", "fusion").run(0, 1).pending(0, 2)
        made_up.close()
        told = self.told(lambda: results.Results(self.folder / "made_up.sqlite"))
        self.assertIn("made_up.sqlite has runs that are not done", told)
        self.assertIn("'pending': 1", told)

    def test_one_without_runs_is_refused(self):
        self.made_up().close()
        self.assertIn("not done", self.told(lambda: results.Results(self.folder / "made_up.sqlite")))

    def test_one_that_is_not_there_is_told(self):
        self.assertIn("there is no", self.told(lambda: results.Results(self.folder / "none.sqlite")))


class Figures(unittest.TestCase):
    def test_spreads(self):
        self.assertEqual(results.spread([], 1), "-")
        self.assertEqual(results.spread([2.5], 2), "2.50")
        self.assertEqual(results.spread([1.0, 1.004], 2), "1.00")  # no spread in so many digits
        self.assertEqual(results.spread([1, 2, 3], 1), "2.0 +- 1.0 (1.0 to 3.0)")  # n - 1 below the line
        self.assertEqual(results.short_spread(iter([1, 2, 3]), 1), "2.0 +- 1.0")

    def test_intervals_hold_the_mean_and_are_the_same_each_time(self):
        values = [1.0, 1.2, 0.9, 1.1, 1.3, 0.7, 1.0, 1.05]
        low, high = pairs.interval(values)
        self.assertLess(0.7, low)
        self.assertLess(low, sum(values) / len(values))
        self.assertLess(sum(values) / len(values), high)
        self.assertLess(high, 1.3)
        # Nearly the normal distribution's interval: mean +- 1.96 s / sqrt(n), s with divisor n.
        self.assertAlmostEqual(high - low, 2 * 1.96 * 0.170 / 8 ** 0.5, delta=0.03)
        self.assertEqual(pairs.interval(values), (low, high))
        self.assertEqual(pairs.interval([2.0, 2.0]), (2.0, 2.0))

    def test_intervals_of_rates_are_those_of_newcombes_tables(self):
        low, high = pairs.wilson(1, 29)
        self.assertAlmostEqual(low, 0.0061, delta=5e-5)
        self.assertAlmostEqual(high, 0.1718, delta=5e-5)
        low, high = pairs.difference_of_rates(56, 70, 48, 80)
        self.assertAlmostEqual(low, 0.0524, delta=5e-5)
        self.assertAlmostEqual(high, 0.3339, delta=5e-5)

    def test_without_a_trial_a_rate_may_be_any(self):
        self.assertEqual(pairs.wilson(0, 0), (0.0, 1.0))
        self.assertEqual(pairs.difference_of_rates(0, 0, 3, 4), (-1.0, 1.0))
        self.assertEqual(pairs.difference_of_rates(3, 4, 0, 0), (-1.0, 1.0))

    def test_the_original_decided_every_tenth_of_a_second(self):
        """Its times, printed with six digits after the point, are sums of steps of 0.1 s in single precision, and of no others."""
        printed = {("5", "arbitration"): "15.300022", ("5", "fusion"): "50.999794", ("6", "arbitration"): "89.599205", ("6", "fusion"): "155.700302"}
        self.assertEqual(parts.ORIGINAL_STEPS, dict(zip(printed, (153, 510, 896, 1557))))
        for case, count in parts.ORIGINAL_STEPS.items():
            self.assertEqual(f"{pairs.sum_of_steps(0.1, count):.6f}", printed[case])
            self.assertAlmostEqual(pairs.sum_of_steps(0.1, count), parts.ORIGINAL[case][1], delta=0.005)
            for step in (0.01, 0.02, 0.05):
                self.assertNotEqual(f"{pairs.sum_of_steps(step, round(0.1 / step * count)):.6f}", printed[case])

    def test_means_with_intervals_are_told_in_few_words(self):
        self.assertEqual(pairs.mean_with_interval([], 2), "-")
        self.assertEqual(pairs.mean_with_interval([0.5, 0.5], 2), "0.50")
        self.assertEqual(pairs.mean_with_interval([0.50001, 0.50002], 2), "0.50")
        self.assertRegex(pairs.mean_with_interval([0.5, 0.7, 0.9], 1), r"^0\.7 \(0\.5 to 0\.9\)$")


class Pairs(WithFolder):
    def test_only_runs_of_a_seed_with_which_both_succeed_are_compared(self):
        made_up = self.made_up().cell(0, "maze", "fusion").cell(1, "maze", "arbitration")
        made_up.run(0, 1, path_m=1, time_s=8).run(0, 2, path_m=90).run(0, 3, path_m=90, outcome="time_limit").run(0, 4, path_m=3, time_s=6).run(0, 9)
        made_up.run(1, 4, path_m=4, time_s=4).run(1, 3, path_m=50).run(1, 2, path_m=50, outcome="failure").run(1, 1, path_m=2, time_s=4)
        fusion, arbitration = self.read(made_up).by_scheme()
        self.assertEqual([(a.seed, b.seed) for a, b in pairs.both_succeed(fusion, arbitration)], [(1, 1), (4, 4)])
        self.assertEqual(pairs.ratios(fusion, arbitration, pairs.path_m), [0.5, 0.75])
        self.assertEqual(pairs.ratios(fusion, arbitration, pairs.seconds_per_metre), [4.0, 2.0])
        row = conclusions.pair_row("maze", fusion, arbitration)
        self.assertEqual(row[:2], ["maze", 2])
        self.assertTrue(row[2].startswith("0.625 ("), row)
        self.assertEqual(row[3:5], ["1.50", "5.00"])
        self.assertTrue(row[5].startswith("0.375 ("), row)

    def test_two_that_never_succeed_together_have_no_figures(self):
        made_up = self.made_up().cell(0, "maze", "fusion").cell(1, "maze", "arbitration").run(0, 1).run(1, 1, outcome="failure")
        self.assertEqual(conclusions.pair_row("maze", *self.read(made_up).by_scheme()), ["maze", 0, "-", "-", "-", "-"])


class Conclusions(WithFolder):
    def test_a_verdict_names_the_cases_and_the_set_ups_in_which_it_holds(self):
        entry = deciding.SHORTER_PATH
        told = conclusions.verdict(entry, [("cases 1 to 4", {"2": deciding.Share(3, 160, 0.0, 0.05)}), ("case 7", {"2": deciding.Share(160, 200, 0.6, 0.95)})])
        self.assertEqual(told, "Where both succeed, fusion's path is much shorter: **refuted** for cases 1 to 4 (it holds in 3 of 160 set-ups), "
                               "**not to be decided** for case 7 (it holds in 160 of 200 set-ups).")

    def test_the_page_says_of_which_build_its_runs_are(self):
        one = self.read(self.made_up().cell(0, "maze", "fusion").run(0, 1))
        one.build["commit"] = "abc"
        self.assertIn("of one build, Elsie 9.8.7, commit abc, `libelsie`", parts.builds({"x": one, "y": one}))
        other = results.Runs(one.runs, {**one.build, "commit": ""})
        told = parts.builds({"x": one, "y": other})
        self.assertIn("of 2 builds: `x.xml`: Elsie 9.8.7, commit abc", told)
        self.assertIn("`y.xml`: Elsie 9.8.7, commit not noted", told)
        self.assertTrue(parts.provenance({"x": one}).startswith("Written by `make tables`: 1 runs of an experiment file, of one build, "))
        self.assertTrue(parts.builds({"x": one}, "make comparison").startswith("Written by `make comparison`: "))


    def test_the_page_says_where_the_files_are_and_what_was_repeated(self):
        one = self.read(self.made_up().cell(0, "maze", "fusion").run(0, 1))
        one.build.update(commit="abc", files="def", repeated={"commit": "123", "runs": 5, "same_outcome": 5, "same": 5})
        other = results.Runs(one.runs, {**one.build, "repeated": {"commit": "123", "runs": 3, "same_outcome": 3, "same": 3}})
        told = parts.builds({"x": one, "y": other})
        self.assertIn("commit abc with the files of experiments, worlds and models that were committed later, in def, `libelsie`", told)
        self.assertTrue(told.endswith(" Of these runs 8 were repeated by commit 123: all have the same outcome, and all the same state at the "
                                      "end, bit for bit."), told)
        other.build["repeated"]["same"] = 2
        self.assertIn("all have the same outcome, and 7 the same state", parts.builds({"x": one, "y": other}))


class Repeats(unittest.TestCase):
    def run_of(self, seed, state_hash="0123456789ab", outcome="success", world="maze"):
        return results.Run({"world": world, "coordinator": "fusion"}, seed, outcome, dict.fromkeys(archive.MEASURES, 0), state_hash)

    def test_a_sample_has_as_many_runs_as_asked_for_of_each_experiment_its_part(self):
        runs = {"small": 40, "middle": 1100, "large": 25600}
        found = repeats.sample(runs, 200, random.Random(1))
        counts = {name: len(range(first - 1, runs[name], step)) for name, (first, step) in found.items()}
        self.assertAlmostEqual(sum(counts.values()), 200, delta=5)
        self.assertGreaterEqual(counts["small"], 1)
        for name, (first, step) in found.items():
            self.assertEqual(math.gcd(step, runs[name]), 1)
            self.assertTrue(1 <= first <= step)

    def test_runs_are_compared_with_those_of_the_same_cell_and_seed(self):
        archived = [self.run_of(1, "01234567"), self.run_of(2, "01234567"), self.run_of(1, "89abcdef", world="hall")]
        again = [self.run_of(1), self.run_of(1, "89abcdef0123", world="hall"), self.run_of(7)]  # of the last one nothing is known
        self.assertEqual(repeats.compare(archived, again), (2, 2, []))
        count, outcomes, [other_hash, other_outcome] = repeats.compare(archived, [self.run_of(2, "ff"), self.run_of(1, outcome="failure")])
        self.assertEqual((count, outcomes), (2, 1))
        self.assertEqual(other_hash, "world maze, coordinator fusion, seed 2: ff success, in the archive 01234567 success")
        self.assertIn("seed 1: 01234567 failure, in the archive 01234567 success", other_outcome)


class Commits(WithFolder):
    """Which commit the runs are noted with."""

    def git(self, *words):
        subprocess.run(["git", "-c", "user.name=n", "-c", "user.email=e", *words], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def test_a_file_that_is_not_in_the_commit_marks_it(self):
        commit = load_script().commit
        self.assertEqual(commit(self.folder), "")
        self.git("init", "--quiet")
        (self.folder / "experiments").mkdir()
        (self.folder / "experiments" / "a.xml").touch()
        self.git("add", ".")
        self.git("commit", "--quiet", "-m", "a")
        self.assertRegex(commit(self.folder), "^[0-9a-f]{12}$")
        (self.folder / "notes.txt").touch()  # makes no run
        self.assertRegex(commit(self.folder), "^[0-9a-f]{12}$")
        (self.folder / "experiments" / "b.xml").touch()
        self.assertRegex(commit(self.folder), "^[0-9a-f]{12}-dirty$")


class Archives(WithFolder):
    def test_runs_that_are_read_back_are_those_that_were_written(self):
        made_up = self.made_up().cell(0, "maze", "fusion").cell(1, "maze; or not", "arbitration")
        made_up.run(0, 3, path_m=2.5124, time_s=7.0, collected=2, state_hash="0123456789abcdef", note="trained: mean error 2e-05 after 9 presentations")
        made_up.run(1, 4, outcome="time_limit", note="mean error 0.11 after 9 presentations. It sits on a plateau, whatever the input, (0.75, 0.11)",
                    robots=[("leader", [[0, 0, 0], [1, 2, 0]]), ("f1", [[-1, 0, 0], [-0.5, 0.25, 0]])])
        runs = self.read(made_up).runs
        archive.write(runs, self.folder / "x.csv.gz")
        (self.folder / "builds.json").write_text('{"x": {"elsie": "9.8.7"}}')
        again = archive.read(self.folder, "x")
        self.assertEqual(again.build, {"elsie": "9.8.7"})
        first, second = again.runs
        self.assertEqual(first.levels, {"world": "maze", "coordinator": "fusion"})
        self.assertEqual((first.seed, first.outcome, first.path_m, first.time_s, first.collected, first.state_hash), (3, "success", 2.512, 7.0, 2, "01234567"))
        self.assertTrue(first.learned() and not first.flat)
        self.assertEqual((second.flat, second.outputs, second.error()), (True, (0.75, 0.11), 0.11))
        self.assertEqual(second.robots, {"f1": ((-1, 0), (-0.5, 0.25)), "leader": ((0, 0), (1, 2))})

    def test_the_same_runs_give_the_same_bytes(self):
        runs = self.read(self.made_up().cell(0, "maze", "fusion").run(0, 1)).runs
        for name in ("a", "b"):
            archive.write(runs, self.folder / f"{name}.csv.gz")
        self.assertEqual((self.folder / "a.csv.gz").read_bytes(), (self.folder / "b.csv.gz").read_bytes())


def made_up_study(outcome, seeds=4, layers=("2 2", "4 4", "2 2 2 2", "4 4 4 4")):
    """outcome(scheme, layers, search, avoidance, seed): success, path in m, time in s, error of its network."""
    runs = []
    for search in ("left", "right"):
        for avoidance in ("0/20/1", "0/30/1"):
            for size in layers:
                for scheme in ("fusion", "arbitration"):
                    for seed in range(1, seeds + 1):
                        success, path, time, error = outcome(scheme, size, search, avoidance, seed)
                        levels = {"world": "w", "coordinator": scheme, "layers": size, "search": search, "limit": "none", "avoidance": avoidance}
                        measures = {"path_length_m": path, "time_s": time, "collected": 0, "collisions": 0}
                        runs.append(results.Run(levels, seed, "success" if success else "time_limit", measures, error=error))
    return deciding.Study(results.Runs(runs, {}))


def as_the_original_says(scheme, layers, *_):
    """Fusion completes everything on half of the way in twice the time a metre, faster with larger networks; arbitration fails where "2 2 2 2" did not learn."""
    untrained = layers == "2 2 2 2"
    if scheme == "fusion":
        return True, 15.0, 60.0 if "4" in layers else 90.0, 0.1 if untrained else 1e-5
    return not untrained, 30.0, 60.0, 0.1 if untrained else 1e-5


class Deciding(unittest.TestCase):
    def holds(self, study):
        return {key: {holds(study, study.counts[setup]) for setup in study.setups} for key, _, holds in deciding.conclusions_of(study)}

    def test_runs_that_are_as_the_original_says_bear_it_out(self):
        held = self.holds(made_up_study(as_the_original_says))
        for key in ("1, first half", "1, second half", "2", "3, first half", "3, second half"):
            self.assertEqual(held[key], {True}, key)
        self.assertEqual(held["4, wider and deeper"], {True})  # fusion needs a third less time, arbitration the same
        self.assertEqual(held["4, wider"], {False})  # arbitration succeeds more often, too

    def test_runs_in_which_both_do_the_same_do_not(self):
        held = self.holds(made_up_study(lambda *_: (True, 30.0, 60.0, 1e-5)))
        self.assertEqual(held["1, first half"], {True})
        self.assertEqual(held["1, second half"], {None})  # all networks learned
        self.assertEqual([held[key] for key in ("2", "3, first half", "3, second half")], [{False}, {False}, {False}])

    def test_exactly_a_tenth_of_the_runs_counts_whatever_the_rates(self):
        for runs in (20, 80):
            for won in range(runs - runs // 10 + 1):
                self.assertTrue(deciding.more_often((won + runs // 10, runs), (won, runs)), (won, runs))
                self.assertFalse(deciding.more_often((won + runs // 10 - 1, runs), (won, runs)), (won, runs))
        # 6 of 20 runs are 10 % more than 4 of 20; in floating point, 0.3 - 0.2 is less than 0.1.
        share = {"fusion": 6, "arbitration": 4}
        held = self.holds(made_up_study(lambda scheme, layers, search, avoidance, seed: (seed <= share[scheme], 30.0, 60.0, 1e-5), seeds=20))
        self.assertEqual(held["3, second half"], {True})
        # The same for networks: with four neurons a layer fusion succeeds in 6 of 20, with two in 4.
        held = self.holds(made_up_study(lambda scheme, layers, search, avoidance, seed: (
            seed <= (6 if scheme == "fusion" and "4" in layers else 4), 30.0, 60.0, 1e-5), seeds=20))
        self.assertEqual((held["4, wider"], held["4, deeper"]), ({True}, {False}))

    def test_what_never_succeeds_twice_says_nothing_about_paths(self):
        held = self.holds(made_up_study(lambda scheme, *_: (scheme == "fusion", 30.0, 60.0, 1e-5)))
        self.assertEqual((held["2"], held["3, first half"], held["3, second half"]), ({None}, {None}, {True}))

    def test_a_share_counts_the_set_ups_that_can_be_judged_with_the_interval_over_seeds(self):
        def outcome(scheme, layers, search, avoidance, seed):
            # To the right, fusion completes some of its runs; with 0/30/1, all fail.
            won = avoidance != "0/30/1" and (scheme == "arbitration" or search == "left" or seed > 1)
            return won, 15.0 if scheme == "fusion" else 30.0, 60.0, 1e-5

        found = deciding.shares(made_up_study(outcome))
        completes, path = found["1, first half"], found["2"]
        self.assertEqual((completes.holds, completes.judged), (1, 4))
        self.assertEqual((completes.low, completes.high), (0.25, 0.5))  # some draws of four seeds lack the first
        self.assertEqual((path.holds, path.judged, path.verdict()), (2, 2, "confirmed"))

    def test_a_verdict_needs_the_whole_interval(self):
        self.assertEqual([deciding.Share(*share).verdict() for share in ((19, 20, 0.9, 1.0), (19, 20, 0.85, 1.0), (1, 20, 0.0, 0.1), (1, 20, 0.0, 0.15), (0, 0, 0.0, 1.0))],
                         ["confirmed", "not to be decided", "refuted", "not to be decided", "not to be decided"])

    def test_the_variance_goes_to_the_unknowns_that_make_it(self):
        study = made_up_study(as_the_original_says)
        alone = deciding.effects(study, {setup: float(study.level(setup, "search") == "left") for setup in study.setups})
        self.assertEqual(max(alone, key=alone.get), ("search",))
        self.assertAlmostEqual(alone["search",], 1.0)
        both = deciding.effects(study, {setup: float((study.level(setup, "search") == "left") == (study.level(setup, "avoidance") == "0/30/1")) for setup in study.setups})
        self.assertAlmostEqual(both["search", "avoidance"], 1.0)
        self.assertAlmostEqual(sum(both.values()), 1.0)
        self.assertEqual(deciding.effects(study, dict.fromkeys(study.setups, 0.5)), {})

    def test_the_nearest_cells_are_those_whose_paths_differ_by_the_smallest_factors(self):
        def outcome(scheme, layers, search, avoidance, seed):
            return True, (30.0 if search == "left" else 60.0) * (1 if scheme == "fusion" else 2), 60.0, 1e-5

        study = made_up_study(outcome)
        [first, *_] = deciding.nearest(study, "4 4", {"arbitration": 110.0, "fusion": 55.0})
        self.assertEqual(study.level(first.setup, "search"), "right")
        self.assertAlmostEqual(first.off({"arbitration": 60.0, "fusion": 60.0}), (0.5 * 0.6931 ** 2) ** 0.5, delta=1e-4)

    def test_only_an_open_road_of_30_without_a_limit_is_as_fast_as_the_original(self):
        study = made_up_study(as_the_original_says)
        self.assertEqual({study.level(setup, "avoidance") for setup in study.setups if deciding.as_fast_as_the_original(study, setup)}, {"0/30/1"})

    def test_pictures_have_a_square_for_each_set_up_and_a_dot_for_each_cell(self):
        study = made_up_study(as_the_original_says)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "picture.svg"
            deciding_figures.where_it_holds([("made up", study)], file)
            drawn = [element.get("d").count("M") for element in xml.etree.ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}path")]
            self.assertEqual(sum(drawn), 4 * len(deciding.conclusions_of(study)))
            deciding_figures.paths([("made up", study, [("4 4", "case 2", {"arbitration": 72.0, "fusion": 33.0})], (10, 100), [10, 100])], file)
            dots = list(xml.etree.ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}circle"))
            self.assertEqual(len(dots), 4 + 4)  # of the legend, and of the set-ups
            deciding_figures.effects_of_levels([("made up", study)], file)
            dots = list(xml.etree.ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}circle"))
            self.assertEqual(len(dots), 2 + 2 * (2 + 1 + 2))


class Published(unittest.TestCase):
    """What stands in docs/ is what the archive of runs says."""

    @classmethod
    def setUpClass(cls):
        cls.published = pages.Published(RESEARCH / "tables")

    def test_every_generated_part_of_the_pages_is_that_of_the_archive(self):
        for page, generated in self.published.parts().items():
            text = (RESEARCH / page).read_text()
            for name, part in generated.items():
                with self.subTest(page=page, part=name):
                    self.assertIn(f"<!-- {name} -->\n\n{part}\n\n<!-- end of {name} -->\n", text)

    def test_every_figure_in_the_prose_is_that_of_the_archive(self):
        self.assertEqual(self.published.problems(RESEARCH), [])

    def test_the_files_of_every_experiment_are_in_the_commit_that_its_page_names(self):
        experiments = {**self.published.every, **self.published.deciding}
        text = "".join((RESEARCH / page).read_text() for page in pages.PAGES)
        for name, runs in experiments.items():
            commit, file = runs.build.get("files", runs.build["commit"]), SOURCE / "experiments" / f"{name}.xml"
            self.assertIn(commit, text)
            if subprocess.run(["git", "cat-file", "-e", commit], cwd=SOURCE, capture_output=True, check=False).returncode != 0:
                self.skipTest("this is no repository with the history of the runs")
            worlds = [(file.parent / world.get("file")).resolve() for world in xml.etree.ElementTree.parse(file).iter("world") if world.get("file")]
            for path in [file, *worlds]:
                with self.subTest(path=path):
                    subprocess.run(["git", "cat-file", "-e", f"{commit}:{path.relative_to(SOURCE)}"], cwd=SOURCE, check=True)

    def test_every_set_up_and_scheme_has_the_same_seeds(self):
        for study in (self.published.arena, self.published.clutter):
            for setup in study.setups:
                self.assertEqual(sorted(study.runs[setup]), study.seeds)
                self.assertEqual({len(runs) for runs in study.runs[setup].values()}, {2 * len(study.layers)})


class Tables(WithFolder):
    def test_cells_tell_rates_only_where_runs_differ(self):
        made_up = self.made_up().cell(0, "a", "x").cell(1, "b", "x").cell(2, "c", "x").cell(3, "d", "x")
        made_up.run(0, 1, 2.0, 5.0).run(0, 2, 2.0, 5.0)
        made_up.run(1, 1, 2.0, 5.0, state_hash="1").run(1, 2, 4.0, 9.0, "time_limit", state_hash="2")
        made_up.run(2, 1, 2.0, 9.0, "time_limit", 0, "1").run(2, 2, 4.0, 9.0, "time_limit", 1, "2")
        made_up.run(3, 1, 2.0, 9.0, "time_limit", 0).run(3, 2, 2.0, 9.0, "time_limit", 0)
        read = self.read(made_up)
        self.assertEqual([parts.cell_of(read.of(world=world)) for world in "abcd"],
                         ["2.00 m, 5.0 s", "1 of 2: 2.00 m, 5.0 s", "0 of 2 (3.00 m, 0.5 collected)", "- (2.00 m, 0 collected)"])

    def test_groups_count_those_within_coverage_and_how_far_the_others_went(self):
        made_up = self.made_up()
        worlds = ["within_1.5_m", "within_3_m", "to_a_resource", "to_a_resource_in_a_column"]
        for cell, world in enumerate(worlds):
            made_up.cell(cell, world, "x")
            made_up.run(cell, 1, robots=[("leader", [[0, 0, 0], [0, 0, 0]]), ("near", [[1, 0, 0], [0.3, 0.4, 0]]), ("far", [[2, 0, 0], [2, 0.25, 0]])])
        rows = parts.groups(self.read(made_up)).splitlines()
        self.assertEqual(rows[2], "| the leader stands, coverage 1.5 m | 1 of 1 | 1 | 1 of 1 | 0.50 | 1 | 0.250 | 10.0 | 0.0 |")
        self.assertEqual(rows[3], "| the leader stands, coverage 3 m | 1 of 1 | 2 | 1 of 2 | 1.26 +- 1.07 (0.50 to 2.02) | 0 | - | 10.0 | 0.0 |")


class Pages(WithFolder):
    def setUp(self):
        super().setUp()
        self.fill = load_script().fill
        self.page = self.folder / "page.md"

    def write(self, text):
        self.page.write_text(text)

    def test_what_stands_between_the_markers_is_replaced(self):
        self.write("above\n<!-- a -->\nold\n<!-- end of a -->\nbetween\n<!-- b -->\n<!-- end of b -->\nbelow\n")
        with contextlib.redirect_stdout(io.StringIO()):
            for _ in range(2):  # the second time changes nothing
                self.fill(self.page, {"a": "new \\1", "b": "two\nlines"})
        self.assertEqual(self.page.read_text(), "above\n<!-- a -->\n\nnew \\1\n\n<!-- end of a -->\nbetween\n<!-- b -->\n\ntwo\nlines\n\n<!-- end of b -->\nbelow\n")

    def test_a_page_without_the_markers_or_with_two_of_them_is_refused_and_stays(self):
        both = "<!-- a -->\nold\n<!-- end of a -->\n"
        for text in ("above\n", "<!-- a -->\nold\n", "old\n<!-- end of a -->\n", both + both):
            self.write(text)
            self.assertIn("docs/research/page.md lacks the lines <!-- a --> and <!-- end of a -->", self.told(lambda: self.fill(self.page, {"a": "new"})))
            self.assertEqual(self.page.read_text(), text)


class Seeds(WithFolder):
    """The deciding experiment has a database for each seed."""

    def setUp(self):
        super().setUp()
        self.tables = load_script()
        self.tables.DATABASES, self.tables.COMMITS, self.tables.TABLES = self.folder, self.folder / "commits.json", self.folder / "tables"

    def seed(self, seed, state="done"):
        made_up = MadeUp(self.tables.of_seed("original_step", seed), EMPTY).cell(0, "arena", "fusion").cell(1, "arena", "arbitration")
        made_up.run(0, seed, path_m=10.0 + seed)
        (made_up.run if state == "done" else made_up.pending)(1, seed)
        made_up.close()

    def databases(self):
        found = self.tables.databases_of("original_step")
        for each in found:
            self.addCleanup(each.database.close)
        return found

    def test_all_that_are_done_are_read_in_order_from_the_first_on(self):
        for seed in (2, 1, 4):
            self.seed(seed)
        self.assertEqual([each.seeds() for each in self.databases()], [[1], [2]])  # 4 without 3 would leave a gap

    def test_one_that_is_not_done_ends_them(self):
        self.seed(1)
        self.seed(2, "pending")
        self.assertEqual([each.seeds() for each in self.databases()], [[1]])

    def test_without_any_the_first_is_told(self):
        self.assertIn("there is no", self.told(self.databases))

    def test_their_runs_are_one_table_with_the_build_that_did_them(self):
        for seed in (1, 2):
            self.seed(seed)
        self.tables.COMMITS.write_text('{"original_step.01": "abc", "original_step.02": "abc"}')
        with contextlib.redirect_stdout(io.StringIO()):
            self.tables.write_archive({"original_step": self.databases()})
        read = archive.read(self.folder / "tables", "original_step")
        self.assertEqual(read.seeds(), [1, 2])
        self.assertEqual([run.path_m for run in read.of(coordinator="fusion")], [11.0, 12.0])
        self.assertEqual((read.build["elsie"], read.build["commit"], read.build["runs"]), ("9.8.7", "abc", 4))

    def test_those_of_several_builds_are_refused(self):
        for seed in (1, 2):
            self.seed(seed)
        self.tables.COMMITS.write_text('{"original_step.01": "abc", "original_step.02": "def"}')
        self.assertIn("are of several builds", self.told(lambda: self.tables.build_of(self.databases())))


class Expectations(WithFolder):
    def test_experiments_whose_report_is_not_good_are_told(self):
        program = self.folder / "elsie"
        program.write_text('#!/bin/sh\ncase "$1 $2 $3" in "report "*/good.sqlite" --quiet") exit 0;; esac\nexit 1\n')
        program.chmod(0o755)
        unmet = load_script().unmet(str(program), [self.folder / "good.sqlite", self.folder / "bad.sqlite"])
        self.assertEqual(len(unmet), 1)
        self.assertIn("experiments/bad.xml expects something else", unmet[0])


class Prose(unittest.TestCase):
    PAGE = "It took 203 s\ninstead of   294 s.\n<!-- t -->\n\nIt took 99 s.\n\n<!-- end of t -->\nArbitration always fails."

    def found(self, *statements):
        return claims.problems({"page.md": self.PAGE}, statements)

    def test_figures_are_held_against_what_was_computed_to_the_digits_that_the_page_has(self):
        sentence = "took {:.0f} s instead of {:.0f} s"
        self.assertEqual(self.found(claims.Claim("page.md", sentence, 203.4, 293.7)), [])
        [told] = self.found(claims.Claim("page.md", sentence, 203.6, 293.7))
        self.assertIn('docs/research/page.md does not match the databases, which give "took 204 s instead of 294 s"', told)

    def test_what_is_generated_does_not_count_as_prose(self):
        self.assertEqual(len(self.found(claims.Claim("page.md", "It took {} s.", 99))), 1)

    def test_what_has_no_figure_must_stand_there_and_hold(self):
        self.assertEqual(self.found(claims.Claim("page.md", "Arbitration always fails.")), [])
        self.assertIn("and the databases say otherwise", self.found(claims.Claim("page.md", "Arbitration always fails.", holds=False))[0])
        self.assertIn("does not match the databases", self.found(claims.Claim("page.md", "Arbitration never fails."))[0])

    def test_numbers_in_words(self):
        self.assertEqual([claims.in_words(n) for n in (0, 2, 20, 21)], ["none", "two", "twenty", "21"])
        self.assertEqual([claims.one_part(1 / n) for n in (2, 4, 8, 13.3, 20.1, 21, 24, 28.3)],
                         ["half", "a quarter", "an eighth", "a thirteenth", "a twentieth", "a twenty-first", "a twenty-fourth", "a twenty-eighth"])
        self.assertEqual([claims.quarters(value) for value in (0.3, 0.5, 0.72)], ["a quarter", "half", "three quarters"])
        self.assertTrue(claims.about(29.6, 30, 1))
        self.assertFalse(claims.about(31.1, 30, 1))


class Ways(WithFolder):
    SVG = "{http://www.w3.org/2000/svg}"
    WORLD = ('<world><obstacles><static_box x="1" y="1" heading_deg="90" length="0.4" width="0.2"/></obstacles>'
             '<resources><resource x="2" y="0"/></resources></world>')

    def drawn(self, ways, **how):
        trajectories.draw(self.WORLD, ways, self.folder / "ways.svg", **how)
        return xml.etree.ElementTree.parse(self.folder / "ways.svg").getroot()

    def test_each_way_has_a_panel_with_the_world(self):
        # From x = 0 to 2 and y = 0 to 1, with half a metre around it: 100 pixels a metre, y upwards.
        root = self.drawn([("a < b", True, [[0, 0, 0], [0.001, 0, 0], [1, 0, 0], [2, 0, 0]]), ("c", False, [[0, 0, 0], [0, 1, 0]])], width=300)
        panels = root.findall(self.SVG + "svg")
        self.assertEqual([(float(panel.get("width")), float(panel.get("height"))) for panel in panels], [(300, 200), (300, 200)])
        self.assertLess(float(panels[0].get("x")) + 300, float(panels[1].get("x")))  # beside each other
        for panel in panels:
            box, resource = [{tuple(float(c) for c in point.split(",")) for point in element.get("points").split()}
                             for element in panel.iter(self.SVG + "polygon")]
            self.assertEqual(box, {(140, 30), (160, 30), (140, 70), (160, 70)})  # turned by 90 degrees it is 0.2 m wide
            self.assertEqual(resource, {(240, 140), (260, 140), (240, 160), (260, 160)})
        ways = [element.get("points") for element in root.iter(self.SVG + "polyline")]
        self.assertEqual(ways, ["50.0,150.0 150.0,150.0 250.0,150.0", "50.0,150.0 50.0,50.0"])  # a millimetre is not drawn
        self.assertEqual([element.text for element in root.findall(self.SVG + "text")], ["a < b", "all collected", "c", "not all collected"])
        ends = [[(e.get("cx"), e.get("cy"), e.get("fill")) for e in panel.iter(self.SVG + "circle")][-1] for panel in panels]
        self.assertEqual(ends, [("250.0", "150.0", trajectories.SUCCESS), ("50.0", "50.0", "#ffffff")])

    def test_panels_go_on_in_the_next_row_and_the_picture_holds_them(self):
        root = self.drawn([(str(k), True, [[0, 0, 0], [1, k / 10, 0]]) for k in range(5)], columns=2, width=200)
        panels = [[float(panel.get(name)) for name in ("x", "y", "width", "height")] for panel in root.findall(self.SVG + "svg")]
        self.assertEqual(len({x for x, *_ in panels}), 2)
        self.assertEqual(len({y for _, y, *_ in panels}), 3)
        self.assertLess(max(x + width for x, _, width, _ in panels), float(root.get("width")))
        self.assertLess(max(y + height for _, y, _, height in panels), float(root.get("height")))


if __name__ == "__main__":
    unittest.main()
