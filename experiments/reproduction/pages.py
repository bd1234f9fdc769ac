"""The pages of the published experiments: which experiments they are about, and what is generated on them, all from docs/research/tables/."""
import archive
import comparison
import deciding
import deciding_figures
import parts
from claims import problems
from conclusions import conclusions, verdicts, where_both_succeed
from parts import ORIGINAL
from results import of
from statements import statements

EXPERIMENTS = ["four_resources", "obstacles", "clutter", "groups", "decision_period", "backing_off", "every_coordinator", "scattered"]
DECIDING = ["original_step", "original_clutter"]
PAGES = ["experiments.md", "every-coordinator.md", "original-step.md"]
ARENA, CLUTTER = "cases 1 to 4", "case 7"


def original(case):
    """What the original printed for a case: {scheme: m}, {scheme: s}."""
    return ({scheme: ORIGINAL[case, scheme][0] for scheme in parts.SCHEMES}, {scheme: ORIGINAL[case, scheme][1] for scheme in parts.SCHEMES})


class Published:
    """All that is on the pages. tables: the folder of the archive."""

    def __init__(self, tables):
        self.every = {name: archive.read(tables, name) for name in EXPERIMENTS}
        self.study = self.every[comparison.EXPERIMENT]
        self.compared = comparison.read(tables)
        self.deciding = {name: archive.read(tables, name) for name in DECIDING}
        self.arena, self.clutter = (deciding.Study(self.deciding[name]) for name in DECIDING)
        self.fast = [setup for setup in self.arena.setups if deciding.as_fast_as_the_original(self.arena, setup)]
        self.arena_shares, self.clutter_shares = deciding.shares(self.arena), deciding.shares(self.clutter)
        self.fast_shares = deciding.shares(self.arena, self.fast)

    def decided(self):
        return [(ARENA, self.arena_shares), (CLUTTER, self.clutter_shares)]

    def parts(self):
        """{page: {name of a part: its text}}."""
        every, arena, clutter = self.every, self.arena, self.clutter
        return {
            "experiments.md": {
                "provenance": parts.provenance({name: runs for name, runs in every.items() if name != comparison.EXPERIMENT}),
                "conclusions": conclusions(every, self.decided()),
                "where both succeed": where_both_succeed(every),
                "cases 1 to 4": parts.cases_1_to_4(every["four_resources"]),
                "training": parts.training(every["four_resources"]),
                "cases 5 and 6": parts.cases_5_and_6(every["obstacles"]),
                "search to the right": parts.search_to_the_right(every["obstacles"]),
                "backing off": parts.backing_off(every["backing_off"]),
                "case 7": parts.case_7(every["clutter"]),
                "decision period": parts.decision_period(every["decision_period"], parts.published(every)),
                "groups": parts.groups(every["groups"]),
                "scattered": parts.scattered(every["scattered"], every),
            },
            "every-coordinator.md": {"builds": parts.builds({comparison.EXPERIMENT: self.study}, "make comparison"),
                                     **comparison.parts(self.study, self.compared)},
            "original-step.md": {
                "runs": self.runs(),
                "shares": deciding.table_of_shares([(f"{ARENA}, all {len(arena.setups)} set-ups", self.arena_shares),
                                                    (f"those as fast as the original, {len(self.fast)}", self.fast_shares),
                                                    (f"{CLUTTER}, all {len(clutter.setups)} set-ups", self.clutter_shares)]),
                "effects in the arena": deciding.table_of_effects(arena),
                "effects in the clutter": deciding.table_of_effects(clutter),
                "verdicts": verdicts(self.decided()),
                "nearest to case 1": deciding.table_of_nearest(arena, "2 2", *original("1")),
                "nearest to case 2": deciding.table_of_nearest(arena, "4 4", *original("2")),
                "nearest to case 7": deciding.table_of_nearest(clutter, "4 4", *original("7")),
            },
        }

    def runs(self):
        """How many runs the deciding experiment has."""
        told = [f"{study.number_of_runs} in {name} ({len(study.setups)} set-ups, {of(len(study.seeds), 20)} seeds)"
                for name, study in ((ARENA, self.arena), (CLUTTER, self.clutter))]
        rest = "" if min(len(study.seeds) for study in (self.arena, self.clutter)) == 20 else " The same command goes on to all twenty seeds."
        return parts.builds(self.deciding) + f" There are {' and '.join(told)}." + rest

    def draw(self, folder):
        """The pictures of the deciding experiment."""
        studies = [(ARENA, self.arena), (CLUTTER, self.clutter)]
        deciding_figures.where_it_holds(studies, folder / "original_step_where.svg")
        deciding_figures.effects_of_levels(studies, folder / "original_step_effects.svg")
        deciding_figures.paths([("Cases 1 and 2", self.arena, [("2 2", "case 1", original("1")[0]), ("4 4", "case 2", original("2")[0])], (25, 200), [30, 50, 100, 200]),
                                ("Case 7", self.clutter, [("4 4", "case 7", original("7")[0])], (5, 400), [5, 10, 30, 100, 300])], folder / "original_step_paths.svg")

    def problems(self, docs):
        """Where the prose of the pages in a folder differs from the figures: sentences."""
        return problems({name: (docs / name).read_text() for name in PAGES}, statements(self))
