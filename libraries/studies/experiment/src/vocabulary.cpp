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

constexpr double kLongestTime = 1e9;  // s, as in worlds

ElementSpec setting() {
  return Describe<SettingDraft>("set",
                                "Sets an attribute of a world, or replaces an element by "
                                "the one inside")
      .takes_element(&SettingDraft::element)
      .attribute("path", &SettingDraft::path,
                 fact("path of what is set, as in `elsie run --set`: robot[r1]/@max_speed"),
                 kRequired)
      .attribute("value", &SettingDraft::value,
                 fact("value of the attribute at the end of the path"));
}

ElementSpec change() {
  ElementSpec settings = setting();
  settings.at_least = 1;
  return Describe<AtDraft>("at", "Settings that are made while the world runs")
      .attribute("time", &AtDraft::time,
                 {.unit = "s",
                  .min = 0,
                  .max = kLongestTime,
                  .meaning = "simulated time; made before the first step at or after it"},
                 kRequired)
      .each(std::move(settings), &AtDraft::settings);
}

ElementSpec level() {
  return Describe<LevelDraft>("level",
                              "A level of a factor: a value or an element for the factor's "
                              "path, and further settings")
      .takes_element(&LevelDraft::element)
      .attribute("label", &LevelDraft::label,
                 fact("name in tables; by default its value, or the name of its element"))
      .attribute("value", &LevelDraft::value, fact("value at the factor's path"))
      .each(setting(), &LevelDraft::settings)
      .each(change(), &LevelDraft::changes);
}

ElementSpec factor() {
  const auto bound = [](const char* meaning) { return fact(meaning); };
  return Describe<FactorDraft>("vary",
                               "A factor; each level is combined with each level of all others")
      .unique("level", "label")
      .attribute("name", &FactorDraft::name, fact("name in tables; by default the end of its path"),
                 kId)
      .attribute("path", &FactorDraft::path,
                 fact("what is varied: an attribute, or an element that levels replace"))
      .attribute("values", &FactorDraft::values, fact("its levels, separated by \";\""))
      .attribute("from", &FactorDraft::from, bound("the first level of a range"))
      .attribute("to", &FactorDraft::to, bound("the last level of a range"))
      .attribute("step", &FactorDraft::step,
                 {.above = 0, .meaning = "difference between a level of a range and the next"})
      .each(level(), &FactorDraft::levels);
}

Describe<ExperimentDraft> worlds() {
  return Describe<ExperimentDraft>("worlds",
                                   "The worlds to run, which are the levels of the factor "
                                   "\"world\"")
      .required()
      .members("world")
      .each(
          Describe<WorldDraft>("world", "A world file")
              .required()
              .attribute("file", &WorldDraft::file,
                         fact("path, from the experiment's folder or a data directory"), kRequired)
              .attribute("id", &WorldDraft::id,
                         fact("name in tables; by default the file's name without folder "
                              "and suffix"),
                         kId)
              .each(setting(), &WorldDraft::settings)
              .each(change(), &WorldDraft::changes),
          &ExperimentDraft::worlds);
}

ElementSpec seeds() {
  return Describe<SeedsDraft>("seeds",
                              "The seeds of each cell's runs: all from one number to "
                              "another, or a list")
      .required()
      .attribute("from", &SeedsDraft::from, fact("the first seed, a whole number from 0"))
      .attribute("to", &SeedsDraft::to, fact("the last seed, a whole number from 0"))
      .attribute("list", &SeedsDraft::list, fact("the seeds, separated by blanks"))
      .attribute("repeats", &SeedsDraft::repeats,
                 {.min = 1,
                  .max = 1000,
                  .meaning = "number of runs with each seed, to check that the same seed gives "
                             "the same run"});
}

ElementSpec layouts() {
  return Describe<LayoutsDraft>("layouts",
                                "The seeds from which layouts are drawn, as a factor "
                                "\"layout_seed\", or those of the runs")
      .attribute("rule", &LayoutsDraft::rule,
                 {.choices = {"crossed", "nested"},
                  .meaning = "crossed: each layout meets each seed; nested: each seed has its own "
                             "layout, and none is given here"})
      .attribute("from", &LayoutsDraft::from,
                 fact("the first seed of a layout, a whole number from 0"))
      .attribute("to", &LayoutsDraft::to, fact("the last seed of a layout, a whole number from 0"))
      .attribute("list", &LayoutsDraft::list, fact("the seeds, separated by blanks"));
}

ElementSpec exclusion() {
  return Describe<ExclusionDraft>("exclude", "Combinations of levels that are not run")
      .attribute("where", &ExclusionDraft::where,
                 fact("cells that are left out: FACTOR=LEVEL|LEVEL; FACTOR=LEVEL, with \"*\" for "
                      "any text; all must match"),
                 kRequired);
}

ElementSpec measure() {
  return Describe<MeasureDraft>("measure", "A measure to show, or one that is computed from others")
      .attribute("name", &MeasureDraft::name, fact("name of the measure"), kRequired)
      .attribute("formula", &MeasureDraft::formula,
                 fact("computes it when results are read: measures of the runs, factors whose "
                      "levels are numbers, and formulas above; + - * / ^ ( ), min, max, abs, sqrt, "
                      "log, exp"))
      .attribute("unit", &MeasureDraft::unit, fact("unit of the formula"))
      .attribute("meaning", &MeasureDraft::meaning,
                 fact("meaning of the formula; by default its text"));
}

ElementSpec expectation() {
  const auto number = [](const char* meaning) { return fact(meaning); };
  return Describe<ExpectationDraft>("expect",
                                    "An expected result, true or false for each cell that "
                                    "it covers")
      .attribute("name", &ExpectationDraft::name,
                 fact("name in reports; by default the expectation in words"))
      .attribute("measure", &ExpectationDraft::measure, fact("the measure"), kRequired)
      .attribute("per", &ExpectationDraft::per,
                 fact("another measure by which each run's value is divided"))
      .attribute(
          "statistic", &ExpectationDraft::statistic,
          {.choices = {"mean", "median", "standard_deviation", "minimum", "maximum", "rate"},
           .meaning = "statistic of the values of a cell's runs; the rate is the share of runs in "
                      "which the value is not 0; by default the mean, of `success` the rate"})
      .attribute("runs", &ExpectationDraft::runs,
                 {.choices = {"all", "successes"}, .meaning = "which runs of a cell count"})
      .attribute("where", &ExpectationDraft::where,
                 fact("cells that it covers: FACTOR=LEVEL|LEVEL; FACTOR=LEVEL, with \"*\" "
                      "for any text; by default all"))
      .attribute("ratio_to", &ExpectationDraft::ratio_to,
                 fact("judges the ratio of each cell's statistic to that of the cell with "
                      "FACTOR=LEVEL; FACTOR=LEVEL"))
      .attribute("difference_from", &ExpectationDraft::difference_from,
                 fact("judges the difference, cell minus other cell, in the same way"))
      .attribute("at_least", &ExpectationDraft::at_least, number("lower bound"))
      .attribute("at_most", &ExpectationDraft::at_most, number("upper bound"))
      .attribute("about", &ExpectationDraft::about, number("expected value, within the tolerance"))
      .attribute("tolerance", &ExpectationDraft::tolerance,
                 {.min = 0, .meaning = "how far a bound may be missed; by default 0"})
      .attribute("confidence", &ExpectationDraft::confidence,
                 {.above = 0,
                  .max = 0.999999,
                  .meaning = "the whole interval at this confidence must be within the bounds: "
                             "0.95, for example"});
}

ElementSpec experiment() {
  return world::root<ExperimentDraft>("experiment",
                                      "Runs of worlds over a grid of settings and seeds, with "
                                      "measures and expectations",
                                      kFormat)
      .unique("worlds/world", "id")
      .unique("vary", "name")
      .unique("measures/measure", "name")
      .unique("expectations/expect", "name")
      .attribute("name", &ExperimentDraft::name, fact("its title; by default that of its file"))
      .attribute("description", &ExperimentDraft::description, fact("what it is for"))
      .attribute("max_runs", &ExperimentDraft::max_runs,
                 {.min = 1, .meaning = "an experiment with more runs is refused"})
      .group(worlds())
      .each(setting(), &ExperimentDraft::settings)
      .each(change(), &ExperimentDraft::changes)
      .each(factor(), &ExperimentDraft::factors)
      .each(exclusion(), &ExperimentDraft::exclusions)
      .optional(seeds(), &ExperimentDraft::seeds)
      .optional(layouts(), &ExperimentDraft::layouts)
      .optional(
          Describe<LimitsDraft>("limits", "Limits of a run's time")
              .attribute("time", &LimitsDraft::time,
                         {.unit = "s",
                          .above = 0,
                          .max = kLongestTime,
                          .meaning = "simulated time; by default that of the world"})
              .attribute("wall_time", &LimitsDraft::wall_time,
                         {.unit = "s",
                          .above = 0,
                          .max = kLongestTime,
                          .meaning = "time on the clock; longer runs are ended and count as hung"}),
          &ExperimentDraft::limits)
      .optional(Describe<TrajectoriesDraft>("trajectories", "The recording of the robots' paths")
                    .attribute("period", &TrajectoriesDraft::period,
                               {.unit = "s",
                                .above = 0,
                                .max = kLongestTime,
                                .meaning = "simulated time between two recorded poses"}),
                &ExperimentDraft::trajectories)
      .group(Describe<ExperimentDraft>("measures",
                                       "The measures to show, in this order; by default all "
                                       "that the runs have")
                 .members("measure")
                 .each(measure(), &ExperimentDraft::measures))
      .group(Describe<ExperimentDraft>("expectations", "The expected results")
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
