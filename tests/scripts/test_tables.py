#!/usr/bin/env python3
"""scripts/tables and scripts/lib over a made-up database. Called with the source folder."""
import ast
import contextlib
import importlib.machinery
import importlib.util
import io
import re
import sys
import tempfile
import unittest
import unittest.mock
import xml.etree.ElementTree
from pathlib import Path

SOURCE = Path(sys.argv.pop(1)).resolve()
sys.path[:0] = [str(SOURCE / "scripts" / "lib"), str(Path(__file__).resolve().parent)]

import claims  # noqa: E402
import conclusions  # noqa: E402
import pairs  # noqa: E402
import parts  # noqa: E402
import results  # noqa: E402
import trajectories  # noqa: E402
from made_up import MadeUp  # noqa: E402


def load_script():
    loader = importlib.machinery.SourceFileLoader("tables", str(SOURCE / "scripts" / "tables"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("tables", loader))
    loader.exec_module(module)
    return module


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def made_up(self, **how):
        return MadeUp(self.folder / "made_up.sqlite", SOURCE / "libraries" / "studies" / "results" / "src" / "schema.sql", **how)

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
        self.assertEqual(read.version, "9.8.7")
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
    def test_a_statement_is_confirmed_refuted_or_not_decided(self):
        known = {"as the original's": (), "other": ("another layout",)}
        decide = conclusions.decide
        with unittest.mock.patch.object(conclusions, "DIFFERENCES", known):
            self.assertEqual(decide({"as the original's": True, "other": True}), "confirmed in our set-up")
            self.assertEqual(decide({"as the original's": True, "other": None}), "not decided by these runs")
            self.assertEqual(decide({"as the original's": True, "other": False}), "not decided by these runs")
            self.assertEqual(decide({"as the original's": False, "other": True}), "refuted")
            self.assertEqual(decide({"as the original's": None}), "not decided by these runs")
            self.assertEqual(decide({}), "not decided by these runs")
            self.assertEqual(conclusions.against({"other": False}), " What speaks against it is not the original's set-up: another layout.")
            self.assertEqual(conclusions.against({"as the original's": False}), "")
            self.assertEqual(conclusions.against({"other": True}), "")
        self.assertEqual(conclusions.below((0.2, 0.4), 0.5), True)
        self.assertEqual(conclusions.below((0.6, 0.7), 0.5), False)
        self.assertIsNone(conclusions.below((0.4, 0.6), 0.5))

    def test_no_case_of_ours_is_set_up_as_the_originals(self):
        self.assertEqual(len(conclusions.DIFFERENCES), 8)
        for differences in conclusions.DIFFERENCES.values():
            self.assertIn(conclusions.PERIOD, differences)
        page = (SOURCE / "docs" / "experiments.md").read_text()
        self.assertNotIn("**Refuted", page)
        self.assertIn("None of our cases is set up like that", " ".join(page.split()))
        self.assertNotRegex(page, "confirmed(?! in our set-up)")

    def test_a_conclusion_of_two_halves_tells_both(self):
        told = conclusions.first_and_second
        self.assertEqual(told("confirmed in our set-up", "confirmed in our set-up"), "**Confirmed in our set-up.**")
        self.assertEqual(told("not decided by these runs", "confirmed in our set-up"),
                         "**The first half is not decided by these runs, the second confirmed in our set-up.**")

    def test_the_four_conclusions_over_made_up_runs(self):
        def case(made_up, cell, world, scheme, layers, wins, path, time):
            made_up.cell(cell, *[level for level in (world, scheme, layers) if level])
            for seed in range(1, 11):
                won = seed <= wins
                made_up.run(cell, seed, path + 0.01 * seed, time, "success" if won else "time_limit", state_hash=str(seed),
                            note=f"trained: mean error {1e-5 if won else 0.02} after 9 presentations")

        def database(name, factors, worlds, layers, times):
            made_up = MadeUp(self.folder / f"{name}.sqlite", SOURCE / "libraries" / "studies" / "results" / "src" / "schema.sql", factors=factors)
            cell = 0
            for world in worlds:
                for layer in layers:
                    for scheme, path, time in (("fusion", 5.0, 20.0), ("arbitration", 10.0, times)):
                        case(made_up, cell, world, scheme, layer, 10 if layer != "2 2 2 2" else 1, path, time)
                        cell += 1
            made_up.close()
            read = results.Results(self.folder / f"{name}.sqlite")
            self.addCleanup(read.database.close)
            return read

        every = {"four_resources": database("four", ("world", "coordinator", "layers"), ["four_resources"], parts.LAYERS, 30.0),
                 "obstacles": database("obstacles", ("world", "coordinator"), [world for _, world in parts.CASES_5_AND_6], [None], 30.0),
                 "clutter": database("clutter", ("world", "coordinator"), ["clutter"], [None], 30.0),
                 "decision_period": database("period", ("world", "coordinator", "period"), ["four_resources"], [f"{p} s" for p in parts.PERIODS], 30.0)}
        first, second, third, fourth = conclusions.conclusions(every).splitlines()
        self.assertIn("**The first half is not decided by these runs, the second confirmed in our set-up.**", first)  # it fails with 2 2 2 2, but not as the original's
        self.assertIn("a decision every 0.01 s instead of 0.1 s", first)
        self.assertIn("**Confirmed in our set-up.**", second)  # 5 m instead of 10 m in every case
        self.assertIn("**The first half is confirmed in our set-up, the second not decided by these runs.**", third)  # both succeed equally often
        self.assertIn("**Not decided by these runs.**", fourth)
        self.assertEqual([line[:2] for line in (first, second, third, fourth)], ["1.", "2.", "3.", "4."])

    def test_groups_without_runs_decide_nothing(self):
        class Nothing:
            def of(self, **_):
                return []

            def by_scheme(self, **_):
                return [], []

        every = dict.fromkeys(("four_resources", "obstacles", "clutter", "decision_period"), Nothing())
        told = conclusions.third(every)
        self.assertIn("**Not decided by these runs.**", told)
        self.assertTrue(told.endswith("Arbitration succeeds in 0 of 0 runs of cases 1 to 7, fusion in 0 of 0."), told)
        told = conclusions.fourth(every)
        self.assertIn("**Not decided by these runs.**", told)
        self.assertTrue(told.endswith("Seconds, successes only: fusion -, -, -, -; arbitration -, -, -, -."), told)

    def test_the_page_says_of_which_build_its_runs_are(self):
        one = self.read(self.made_up().cell(0, "maze", "fusion").run(0, 1))
        self.assertIn("of one build, Elsie 9.8.7, commit abc, `libelsie`", parts.builds({"x": one, "y": one}, {"x": "abc", "y": "abc"}))
        told = parts.builds({"x": one, "y": one}, {"x": "abc"})
        self.assertIn("of 2 builds: `x.xml`: Elsie 9.8.7, commit abc", told)
        self.assertIn("`y.xml`: Elsie 9.8.7, commit not noted", told)
        self.assertTrue(parts.provenance({"x": one}, {}).startswith("Written by `make tables`: 1 runs of 1 experiment files, of one build, "))


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

    def test_all_eight_layouts_are_summed_up(self):
        made_up = self.made_up()
        for k in range(1, 9):
            for j, scheme in enumerate(("fusion", "arbitration")):
                made_up.cell(2 * k + j, f"clutter_{k}", scheme)
                for seed in (1, 2):
                    succeeds = k == 7 or (k == 3 and scheme == "fusion")
                    made_up.run(2 * k + j, seed, 4.0, 8.0 if scheme == "fusion" else 6.0, "success" if succeeds else "time_limit")
        read = self.read(made_up)
        rows = parts.eight_clutters(read).splitlines()
        self.assertEqual(rows[4], "| 3 | 0 of 2 | 1.0 | - | - | 2 of 2 | 1.0 | 4.00 | 8.0 |")
        self.assertEqual(rows[10], "| all | 2 of 16 | 1.0 |  |  | 4 of 16 | 1.0 |  |  |")


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
            self.assertIn("docs/page.md lacks the lines <!-- a --> and <!-- end of a -->", self.told(lambda: self.fill(self.page, {"a": "new"})))
            self.assertEqual(self.page.read_text(), text)


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
        self.assertIn('docs/page.md does not say "took 204 s instead of 294 s", which is what the databases come to', told)

    def test_what_is_generated_does_not_count_as_prose(self):
        self.assertEqual(len(self.found(claims.Claim("page.md", "It took {} s.", 99))), 1)

    def test_what_has_no_figure_must_stand_there_and_hold(self):
        self.assertEqual(self.found(claims.Claim("page.md", "Arbitration always fails.")), [])
        self.assertIn("and the databases say otherwise", self.found(claims.Claim("page.md", "Arbitration always fails.", holds=False))[0])
        self.assertIn("does not say", self.found(claims.Claim("page.md", "Arbitration never fails."))[0])

    def test_every_sentence_that_is_checked_stands_on_its_page(self):
        """With any figures, because the true ones need the databases."""
        pages = {"EXPERIMENTS": "experiments.md", "COORDINATORS": "every-coordinator.md"}
        text = {name: claims.prose((SOURCE / "docs" / page).read_text()) for name, page in pages.items()}
        tree = ast.parse((SOURCE / "scripts" / "lib" / "statements.py").read_text())
        told = [node.args for node in ast.walk(tree) if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Claim"]
        self.assertGreater(len(told), 30)
        for page, sentence, *_ in told:
            template = re.sub(r"\\{[^}]*\\}", ".+?", re.escape(" ".join(sentence.value.split())))
            self.assertRegex(text[page.id], template)

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
        self.assertEqual([element.text for element in root.findall(self.SVG + "text")], ["a < b", "c: not all collected"])
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
