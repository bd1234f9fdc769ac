#include "elsie/experiment/vocabulary.h"

#include "elsie/reference/reference.h"
#include "elsie/reference/schema.h"
#include "elsie/simulation/measures.h"
#include "elsie/world/facts.h"

#include "draft.h"

namespace elsie::experiment {

namespace {

using world::Describe;
using world::ElementSpec;
using world::fact;
using world::kId;
using world::kRequired;

constexpr double kLongest = 1e9;  // s, as in worlds

ElementSpec setting() {
  return Describe<SettingDraft>("set",
                                "Sets an attribute of a world, or replaces an element by "
                                "that which it holds")
      .takes_element(&SettingDraft::element)
      .attribute("path", &SettingDraft::path,
                 fact("where: robot[r1]/@max_speed, as with `elsie run --set`"), kRequired)
      .attribute("value", &SettingDraft::value, fact("what, when the path ends with an attribute"));
}

ElementSpec level() {
  return Describe<LevelDraft>("level",
                              "One of the values of a factor: what it holds or its value "
                              "says, for the factor's path, and all that it sets")
      .takes_element(&LevelDraft::element)
      .attribute("label", &LevelDraft::label,
                 fact("what tables call it; by default its value, or the name of its element"))
      .attribute("value", &LevelDraft::value, fact("for the factor's path"))
      .each(setting(), &LevelDraft::settings);
}

ElementSpec factor() {
  const auto bound = [](const char* meaning) { return fact(meaning); };
  return Describe<FactorDraft>("vary",
                               "A factor: each of its levels meets each level of all others")
      .unique("level", "label")
      .attribute("name", &FactorDraft::name,
                 fact("what tables call it; by default the end of its path"), kId)
      .attribute("path", &FactorDraft::path,
                 fact("what is varied: an attribute, or an element of which levels hold others"))
      .attribute("values", &FactorDraft::values, fact("its levels, separated by \";\""))
      .attribute("from", &FactorDraft::from, bound("the first level of a range"))
      .attribute("to", &FactorDraft::to, bound("the last level of a range"))
      .attribute("step", &FactorDraft::step,
                 {.above = 0, .meaning = "from one level of a range to the next"})
      .each(level(), &FactorDraft::levels);
}

Describe<ExperimentDraft> worlds() {
  return Describe<ExperimentDraft>("worlds",
                                   "What the robots live in: a factor of its own, called "
                                   "\"world\"")
      .required()
      .members("world")
      .each(Describe<WorldDraft>("world", "A world file")
                .required()
                .attribute("file", &WorldDraft::file,
                           fact("looked for beside the experiment, then in the data directories"),
                           kRequired)
                .attribute("id", &WorldDraft::id,
                           fact("what tables call it; by default the file's name without folder "
                                "and suffix"),
                           kId)
                .each(setting(), &WorldDraft::settings),
            &ExperimentDraft::worlds);
}

ElementSpec seeds() {
  return Describe<SeedsDraft>("seeds",
                              "With which seeds each cell is run: all from one number to "
                              "another, or those of a list")
      .required()
      .attribute("from", &SeedsDraft::from, {.min = 0, .meaning = "the first seed"})
      .attribute("to", &SeedsDraft::to, {.min = 0, .meaning = "the last seed"})
      .attribute("list", &SeedsDraft::list, fact("the seeds, separated by blanks"))
      .attribute("repeats", &SeedsDraft::repeats,
                 {.min = 1,
                  .max = 1000,
                  .meaning = "how often each seed is run: the same seed must give the same run, "
                             "and more than once is for those who doubt it"});
}

ElementSpec expectation() {
  const auto number = [](const char* meaning) { return fact(meaning); };
  return Describe<ExpectationDraft>("expect",
                                    "A sentence about the results, true or false for every cell "
                                    "that it is about")
      .attribute("name", &ExpectationDraft::name,
                 fact("what reports call it; by default what it says in words"))
      .attribute("measure", &ExpectationDraft::measure, fact("of which measure"), kRequired)
      .attribute("per", &ExpectationDraft::per,
                 fact("another measure, by which each run's value is divided"))
      .attribute(
          "statistic", &ExpectationDraft::statistic,
          {.choices = {"mean", "median", "standard_deviation", "minimum", "maximum", "rate"},
           .meaning = "what of the values of a cell's runs; the rate is the share of runs in "
                      "which the value is not 0; by default the mean, of `success` the rate"})
      .attribute("runs", &ExpectationDraft::runs,
                 {.choices = {"all", "successes"}, .meaning = "which runs of a cell count"})
      .attribute("where", &ExpectationDraft::where,
                 fact("which cells it is about: FACTOR=LEVEL|LEVEL; FACTOR=LEVEL, a \"*\" standing "
                      "for any text; by default all"))
      .attribute("ratio_to", &ExpectationDraft::ratio_to,
                 fact("compares each cell with that which differs in FACTOR=LEVEL; FACTOR=LEVEL: "
                      "its statistic divided by that of the other"))
      .attribute("difference_from", &ExpectationDraft::difference_from,
                 fact("the same, with its statistic minus that of the other"))
      .attribute("at_least", &ExpectationDraft::at_least, number("the least that is expected"))
      .attribute("at_most", &ExpectationDraft::at_most, number("the most that is expected"))
      .attribute("about", &ExpectationDraft::about,
                 number("what is expected, give or take the tolerance"))
      .attribute("tolerance", &ExpectationDraft::tolerance,
                 {.min = 0, .meaning = "by how much it may be missed; by default not at all"})
      .attribute("confidence", &ExpectationDraft::confidence,
                 {.above = 0,
                  .max = 0.999999,
                  .meaning = "then not the statistic alone but its whole confidence interval must "
                             "be as expected: 0.95, for example"});
}

ElementSpec experiment() {
  return world::root<ExperimentDraft>("experiment",
                                      "Runs of worlds over a grid of settings and seeds, what is "
                                      "measured, and what is expected",
                                      kFormat)
      .unique("worlds/world", "id")
      .unique("vary", "name")
      .unique("measures/measure", "name")
      .unique("expectations/expect", "name")
      .attribute("name", &ExperimentDraft::name, fact("its title; by default that of its file"))
      .attribute("description", &ExperimentDraft::description, fact("what it is for"))
      .group(worlds())
      .each(setting(), &ExperimentDraft::settings)
      .each(factor(), &ExperimentDraft::factors)
      .optional(seeds(), &ExperimentDraft::seeds)
      .optional(Describe<LimitsDraft>("limits", "What ends a run that has not ended by itself")
                    .attribute("time", &LimitsDraft::time,
                               {.unit = "s",
                                .above = 0,
                                .max = kLongest,
                                .meaning = "simulated time; by default that of the world"})
                    .attribute("wall_time", &LimitsDraft::wall_time,
                               {.unit = "s",
                                .above = 0,
                                .max = kLongest,
                                .meaning = "time on the clock: what takes longer is given up"}),
                &ExperimentDraft::limits)
      .optional(Describe<TrajectoriesDraft>("trajectories", "What is kept of the robots' ways")
                    .attribute("period", &TrajectoriesDraft::period,
                               {.unit = "s",
                                .above = 0,
                                .max = kLongest,
                                .meaning = "simulated time from one place to the next"}),
                &ExperimentDraft::trajectories)
      .group(Describe<ExperimentDraft>("measures",
                                       "What is shown, in this order; without it all "
                                       "that the runs have")
                 .members("measure")
                 .each(Describe<MeasureDraft>("measure", "A measure to show")
                           .attribute("name", &MeasureDraft::name, fact("which one"), kRequired),
                       &ExperimentDraft::measures))
      .group(Describe<ExperimentDraft>("expectations", "What is expected to come of it")
                 .members("expectation")
                 .each(expectation(), &ExperimentDraft::expectations));
}

std::string about() { return "Experiment files of Elsie, format " + std::to_string(kFormat); }

}  // namespace

const ElementSpec& vocabulary() {
  static const ElementSpec table = experiment();
  return table;
}

std::string experiment_schema(const plugin::Host& host) {
  return reference::schema_of(vocabulary(), about(), host);
}

std::string experiment_reference() {
  std::string text = "# Experiment files: elements and attributes\n\nFormat " +
                     std::to_string(kFormat) +
                     ". Paths and values are those of world files (`elsie describe world`).\n" +
                     reference::vocabulary_reference(vocabulary()) +
                     "\n## Measures of every run\n\n| measure | unit | meaning |\n|---|---|---|\n";
  for (const Quantity& measure : simulation::measures_of_every_run()) {
    text += "| `" + measure.name + "` | " + measure.unit + " | " + measure.meaning + " |\n";
  }
  return text;
}

}  // namespace elsie::experiment
