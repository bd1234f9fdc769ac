#!/usr/bin/env python3
"""The study of every coordinator: its statistics in words on made-up figures, and a tenth of its first seed done again. Called with the source folder, and
for the second with the program."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop(1)).resolve()
PROGRAM = sys.argv.pop(1)
RESEARCH = SOURCE / "docs" / "research"
sys.path.insert(0, str(SOURCE / "experiments" / "reproduction"))

import archive  # noqa: E402
import comparison  # noqa: E402
import repeats  # noqa: E402
import results  # noqa: E402

A, B, C = "arbiter_a", "arbiter_b", "fusion_c"
BASE = {"engine": "ode", "noise": "2 %", "failure": "none"}


def run(coordinator, world="trap", seed=1, state_hash="00", outcome="success", **away):
    levels = {"world": world, "coordinator": coordinator, **BASE, **away}
    return results.Run(levels, seed, outcome, {"path_length_m": 4, "time_s": 9, "collected": 1, "collisions": 0}, state_hash)


def study(*runs):
    return comparison.Study(results.Runs(list(runs), {}))


def effect(value, low, high, p=0.001):
    return [value, low, high, p]


MORE, LESS, UNSURE = effect(0.5, 0.2, 0.8), effect(-0.5, -0.8, -0.2), effect(0.5, -0.1, 0.9)


class Cells(unittest.TestCase):
    def test_the_first_level_of_each_factor_is_the_base(self):
        made_up = study(run(A, "trap"), run(A, "clutter"), run(A, "clutter", engine="planar"), run(A, "clutter", noise="none"))
        self.assertEqual(made_up.base, BASE)
        self.assertEqual(made_up.away, [("engine", "planar"), ("noise", "none")])
        self.assertEqual(made_up.worlds_away(), ["clutter"])
        self.assertEqual(len(made_up.at_base(coordinator=A)), 2)
        self.assertEqual(made_up.group(A, engine="planar"), "coordinator=arbiter_a; engine=planar; noise=2 %; failure=none")
        self.assertEqual(made_up.group(A, "trap"), "coordinator=arbiter_a; world=trap; engine=ode; noise=2 %; failure=none")
        self.assertTrue(comparison.design(made_up).startswith("1 coordinators, 2 cases and seeds 1 to 1 are 2 runs at the base (engine ode, noise 2 %, failure none); "
                                                              "2 levels away from it on 1 cases (clutter (7)) are 2 more."))

    def test_runs_are_the_same_if_all_their_hashes_are(self):
        made_up = study(run(A, seed=1, state_hash="1"), run(A, seed=2, state_hash="2"), run(B, seed=1, state_hash="1"), run(B, seed=2, state_hash="2"),
                        run(C, seed=1, state_hash="1"), run(C, seed=2, state_hash="3"))
        ended = {name: made_up.hashes(["trap"], coordinator=name) for name in (A, B, C)}
        self.assertEqual(ended[A], ended[B])
        self.assertNotEqual(ended[A], ended[C])

    def test_of_times_that_may_be_cut_off_the_effect_is_cliffs_delta(self):
        def measure(name, **more):
            return {"measure": name, "difference": 0.25, "difference_interval": [0.125, 0.5], "seed_p_holm": 0.01, "cliffs_delta": {"value": -1.0, "interval": [-1.0, -0.5]}, **more}
        told = comparison.effects({"measures": [measure("success"), measure("time_s", difference=None), measure("collisions", difference_interval=None)]})
        self.assertEqual(told, {"success": [0.25, 0.125, 0.5, 0.01], "time_s": [-1.0, -1.0, -0.5, 0.01], "collisions": [0.25, None, None, 0.01]})


class Standing(unittest.TestCase):
    def test_an_effect_is_apart_if_interval_and_corrected_p_say_so(self):
        self.assertTrue(comparison.is_apart(MORE))
        self.assertFalse(comparison.is_apart(UNSURE))
        self.assertFalse(comparison.is_apart(effect(0.5, 0.2, 0.8, p=0.2)))
        self.assertFalse(comparison.is_apart([0.5, None, None, 0.001]))  # nothing random
        self.assertFalse(comparison.is_apart([0.5, 0.2, 0.8, None]))

    def dominance(self, pairs, times=None):
        cells = [{"coordinator": name, "world": world, "time_s": (times or {}).get(name, 9.0 + k)} for k, name in enumerate((A, B, C)) for world in pairs]
        return comparison.Dominance({"cells": cells, "pairs": pairs}, [A, B, C])

    def signs(self, effects, times=None):
        return self.dominance({"trap": []}, times).signs("trap", A, B, effects)

    def test_more_successes_less_time_and_fewer_touches_are_better(self):
        self.assertEqual(self.signs({"success": MORE}), {1})
        self.assertEqual(self.signs({"time_s": MORE}), {-1})
        self.assertEqual(self.signs({"time_s": LESS, "success": UNSURE}), {1})
        self.assertEqual(self.signs({"time_s": LESS, "collisions": MORE}), {1, -1})  # faster, but against everything
        self.assertEqual(self.signs({}), set())  # the same runs

    def test_times_that_differ_by_less_than_a_tenth_do_not_matter(self):
        self.assertEqual(self.signs({"time_s": LESS}, {A: 10.0, B: 10.9}), set())
        self.assertEqual(self.signs({"time_s": LESS}, {A: 10.0, B: 11.0}), {1})
        self.assertEqual(self.signs({"time_s": LESS}, {A: 10.0, B: None}), {1})  # less than half of the runs of B were done

    def test_who_is_ahead_somewhere_and_behind_nowhere_dominates(self):
        found = self.dominance({comparison.EVERYWHERE: [[A, B, {"success": LESS}]],  # sums over the cases decide nothing
                                "trap": [[A, B, {"success": MORE}], [A, C, {"success": MORE}], [B, C, {}]],
                                "clutter": [[A, B, {}], [A, C, {"success": UNSURE, "collisions": MORE, "time_s": LESS}], [B, C, {"time_s": UNSURE}]]})
        self.assertTrue(found.dominates(A, B))
        self.assertFalse(found.dominates(B, A))
        self.assertFalse(found.dominates(A, C))  # it touches more in the clutter
        self.assertEqual(found.dominated_by(B), [A])
        self.assertEqual(found.dominated(A), [B])
        self.assertEqual(found.never_dominated(), [A, C])
        self.assertEqual((found.ahead[A, C], found.behind[A, C], found.behind[C, A]), (1, 1, 2))


class Tables(unittest.TestCase):
    def setUp(self):
        self.study = study(run(A), run(B), run(A, noise="none"), run(B, noise="none"), run(A, noise="10 %"), run(B, noise="10 %"))
        cell = {"world": "trap", "successes": 1, "runs": 2, "interval": [0.095, 0.905], "time_s": 28.4, "path_length_m": 4.25, "collisions": 0.5, "command.variation": 12.0}
        overall = {"success": [0.5, 0.095, 0.905], "collisions": [0.5, 0.25, 1.0], "command.variation": [12.0, None, None]}
        self.figures = {"cells": [{"coordinator": A, **cell}, {"coordinator": B, **cell, "time_s": None, "path_length_m": None}],
                        "overall": {A: overall, B: {**overall, "success": [1.0, 0.9, 1.0]}}, "pairs": {"trap": [[A, B, {"success": LESS}]]},
                        "away": [[A, "noise", "none", {"success": MORE}], [B, "noise", "none", {"success": [0.0, 0.0, 0.0, 1.0]}], [A, "noise", "10 %", {}], [B, "noise", "10 %", {"success": UNSURE}],
                                 [comparison.EVERYBODY, "noise", "none", {"success": LESS}], [comparison.EVERYBODY, "noise", "10 %", {"success": UNSURE}]]}

    def test_the_best_over_all_cases_stands_first(self):
        rows = comparison.comparison_table(self.study, self.figures).splitlines()[2:]
        self.assertEqual(rows, ["| `arbiter_b` | 1 (10 to 90) | 100 (90 to 100) | 0.5 (0.2 to 1.0) | 12.0 |", "| `arbiter_a` | 1 (10 to 90), 28 s | 50 (10 to 90) | 0.5 (0.2 to 1.0) | 12.0 |"])

    def test_what_no_success_has_is_a_dash(self):
        self.assertEqual(comparison.details_table(self.study, self.figures).splitlines()[2:], ["| `arbiter_a` | 4.2 / 0.5 / 12.0 |", "| `arbiter_b` | - / 0.5 / 12.0 |"])

    def test_differences_that_are_apart_are_bold(self):
        self.assertEqual(comparison.away_table(self.study, self.figures).splitlines()[2:],
                         ["| `arbiter_a` | 1 of 1 | **+50 (+20 to +80)** | the same runs |", "| `arbiter_b` | 1 of 1 | +0 | +50 (-10 to +90) |",
                          "| all together | 2 of 2 | **-50 (-80 to -20)** | +50 (-10 to +90) |"])

    def test_dominance_is_told_with_who_and_on_how_many_cases(self):
        told = comparison.parts(self.study.runs, self.figures)["dominance"]
        self.assertIn("| `arbiter_a` | `arbiter_b` (1) | 0 | 0 | 1 |\n| `arbiter_b` | nobody | 1 | 1 | 0 |", told)
        self.assertTrue(told.endswith("Dominated: 1 of 2. Never dominated: `arbiter_b`. On all cases, and by one and the same: `arbiter_a`."))

    def test_figures_that_are_read_back_are_those_that_were_written(self):
        with tempfile.TemporaryDirectory() as folder:
            comparison.write(self.figures, Path(folder))
            self.assertEqual(comparison.read(Path(folder)), self.figures)


class Published(unittest.TestCase):
    def test_the_figures_of_the_report_are_those_of_the_archived_runs(self):
        found, runs = comparison.read(RESEARCH / "tables"), comparison.Study(archive.read(RESEARCH / "tables", comparison.EXPERIMENT))
        self.assertEqual(len(found["cells"]), len(runs.coordinators) * len(runs.worlds))
        for cell in found["cells"]:
            of_cell = runs.at_base(coordinator=cell["coordinator"], world=cell["world"])
            self.assertEqual((cell["successes"], cell["runs"]), (len(results.successes(of_cell)), len(of_cell)), cell)

    def test_every_coordinator_of_the_study_is_on_the_page_for_choosing_one(self):
        page = (SOURCE / "docs" / "choosing-a-coordinator.md").read_text()
        for name in archive.read(RESEARCH / "tables", comparison.EXPERIMENT).levels("coordinator"):
            self.assertIn(f"[{name}](coordinators/{name}.md)", page)
            for picture in ("choosing_a_coordinator", "coordinators_in_clutter"):
                self.assertIn(f">{name}<", (SOURCE / "docs" / "pictures" / f"{picture}.svg").read_text())


class Again(unittest.TestCase):
    SHARE = "1/11"  # 11 has no factor in common with the number of coordinators, nor with that of the cells of one

    def test_a_tenth_of_a_seed_comes_out_as_archived(self):
        with tempfile.TemporaryDirectory() as folder:
            experiment, database = Path(folder) / "part.xml", Path(folder) / "part.sqlite"
            experiment.write_text(comparison.of_one_seed(SOURCE, 1))
            told = subprocess.run([PROGRAM, "batch", str(experiment), "--shard", self.SHARE, "--database", str(database), "--json"],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(told.returncode, 0, told.stderr)
            self.assertEqual(json.loads(told.stdout)["failed"], 0)
            part = results.Results(database)
            count, outcomes, different = repeats.compare(archive.read(RESEARCH / "tables", comparison.EXPERIMENT).runs, part.runs)
            part.database.close()
        self.assertGreater(count, 30)
        # Pictures of another version of Mesa differ in single pixels.
        self.assertGreaterEqual(outcomes, 0.9 * count, different)


if __name__ == "__main__":
    unittest.main()
