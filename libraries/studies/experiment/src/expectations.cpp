#include "expectations.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "elsie/base/words.h"
#include "elsie/experiment/grid.h"
#include "elsie/experiment/split.h"
#include "elsie/experiment/where.h"
#include "elsie/world/values.h"

#include "factors.h"
#include "grid.h"

namespace elsie::experiment {

namespace {

using base::Problems;

[[noreturn]] void fail(const std::string& message) { throw std::invalid_argument(message); }

std::string number(double value) { return world::format_value(ParameterValue(value)); }

constexpr const char* kStatistics[] = {"mean",    "median",  "standard_deviation",
                                       "minimum", "maximum", "rate"};

std::vector<LevelOf> parse_reference(const std::string& text, const Experiment& experiment) {
  std::vector<LevelOf> all;
  for (const Where& where : parse_where(text, labels_of(experiment))) {
    if (where.levels.size() > 1 || where.levels[0].find('*') != std::string::npos) {
      fail("each cell is compared with one other; expected one level of '" + where.factor + "'");
    }
    all.push_back({where.factor, where.levels[0]});
  }
  return all;
}

void check_bounds(const ExpectationDraft& draft, const Expectation& expectation) {
  if (!draft.at_least && !draft.at_most && !draft.about) {
    fail("<expect> has no bound; expected at_least, at_most, or about with a tolerance");
  }
  if (draft.about && (draft.at_least || draft.at_most)) {
    fail("<expect> has both about and at_least or at_most; expected one or the other");
  }
  if (draft.at_least && draft.at_most && *draft.at_least > *draft.at_most) {
    fail("at_least=\"" + number(*draft.at_least) + "\" is above at_most=\"" +
         number(*draft.at_most) + "\": that cannot be");
  }
  if (draft.confidence && (expectation.statistic == Statistic::minimum ||
                           expectation.statistic == Statistic::maximum)) {
    fail(
        "<expect> asks for confidence in a minimum or maximum: a few runs do not show how far "
        "others may go; expected another statistic, or no confidence");
  }
  const double tolerance = draft.tolerance.value_or(0.0);
  if (draft.about && tolerance <= 0.0) {
    fail("about=\"" + number(*draft.about) +
         "\" of <expect> has no tolerance: no figure is exact; expected a tolerance above 0");
  }
  if (expectation.statistic == Statistic::rate && expectation.relation == Relation::none) {
    if (draft.confidence && ((draft.at_least && *draft.at_least - tolerance >= 1.0) ||
                             (draft.at_most && *draft.at_most + tolerance <= 0.0))) {
      fail(
          "<expect> can never be met: the interval of a rate at some confidence always reaches "
          "below 1 and above 0; expected a bound in between, or no confidence");
    }
    for (const auto& bound : {draft.at_least, draft.at_most, draft.about}) {
      if (bound && (*bound < 0.0 || *bound > 1.0)) {
        fail("a rate is from 0 to 1, and " + number(*bound) + " was expected");
      }
    }
  }
}

// Parses an attribute; errors name it.
template <class Parse>
auto parsed(const char* attribute, const std::string& text, const Parse& parse) {
  try {
    return parse(text);
  } catch (const std::invalid_argument& error) {
    fail(std::string(attribute) + "=\"" + text + "\" of <expect>: " + error.what());
  }
}

Expectation expectation_from(const ExpectationDraft& draft, const Experiment& experiment) {
  Expectation result;
  result.measure = draft.measure;
  result.per = draft.per.value_or("");
  if (draft.statistic) {
    const auto found = std::find(std::begin(kStatistics), std::end(kStatistics), *draft.statistic);
    result.statistic = static_cast<Statistic>(found - std::begin(kStatistics));
  } else if (result.measure == "success" && result.per.empty()) {
    result.statistic = Statistic::rate;
  }
  result.runs = draft.runs == "successes" ? Runs::successes : Runs::all;
  const auto to_where = [&](const std::string& text) {
    return parse_where(text, labels_of(experiment));
  };
  const auto to_levels = [&](const std::string& text) { return parse_reference(text, experiment); };
  if (draft.where) {
    result.where = parsed("where", *draft.where, to_where);
  }
  if (draft.ratio_to && draft.difference_from) {
    fail("<expect> has ratio_to and difference_from; expected one of them");
  }
  if (draft.ratio_to) {
    result.relation = Relation::ratio;
    result.reference = parsed("ratio_to", *draft.ratio_to, to_levels);
  } else if (draft.difference_from) {
    result.relation = Relation::difference;
    result.reference = parsed("difference_from", *draft.difference_from, to_levels);
  }
  result.at_least = draft.at_least;
  result.at_most = draft.at_most;
  result.about = draft.about;
  result.tolerance = draft.tolerance.value_or(0.0);
  result.confidence = draft.confidence;
  result.location = draft.location;
  check_bounds(draft, result);
  result.name = draft.name ? *draft.name : in_words(result);
  if (trimmed(result.name).empty()) {
    fail("name=\"" + result.name + "\" of <expect>: expected a few words");
  }
  return result;
}

// A cell's reference is missing only because it is excluded.
void check_references(const Expectation& expectation, const Grid& grid,
                      const std::vector<Cell>& cells) {
  if (expectation.relation == Relation::none) {
    return;
  }
  for (const std::size_t cell : grid.cells_of(expectation)) {
    if (!grid.reference_of(expectation, cell)) {
      fail("<expect> compares the cell '" + cells[cell].label +
           "' with one that is excluded; expected `where` without it");
    }
  }
}

}  // namespace

std::string in_words(const Expectation& expectation) {
  std::string text = kStatistics[static_cast<std::size_t>(expectation.statistic)];
  text += " of " + expectation.measure;
  text += expectation.per.empty() ? "" : " per " + expectation.per;
  text += expectation.runs == Runs::successes ? " of successes" : "";
  for (const Where& where : expectation.where) {
    text += ", " + where.factor + "=" + base::joined(where.levels, "|");
  }
  text += ":";
  const char* before = " ";
  const bool difference = expectation.relation == Relation::difference;
  // A difference below 0 is reported as "less": at least -2 is at most 2 less.
  const auto bound = [&](const char* words, const char* if_less,
                         const std::optional<double>& value) {
    if (value) {
      const bool less = difference && *value < 0.0;
      text += before + std::string(less ? if_less : words) + number(less ? -*value : *value);
      text += !difference ? "" : less ? " less" : " more";
      before = " and ";
    }
  };
  bound("at least ", "at most ", expectation.at_least);
  bound("at most ", "at least ", expectation.at_most);
  bound("about ", "about ", expectation.about);
  const std::string tolerance =
      expectation.tolerance > 0.0 ? " give or take " + number(expectation.tolerance) : "";
  text += difference ? "" : tolerance;
  if (expectation.relation != Relation::none) {
    text += difference ? " than that of" : " times that of";
    for (const LevelOf& other : expectation.reference) {
      text += (text.ends_with(" of") ? " " : ", ") + other.factor + "=" + other.level;
    }
    text += difference ? tolerance : "";
  }
  return text;
}

std::vector<Expectation> expectations_from(const std::vector<ExpectationDraft>& drafts,
                                           const Experiment& experiment, Problems& problems) {
  std::vector<Expectation> expectations;
  std::map<std::string, int> lines;
  const std::vector<Cell> all = cells(experiment);
  const Grid grid(experiment, all);
  for (const ExpectationDraft& draft : drafts) {
    try {
      Expectation expectation = expectation_from(draft, experiment);
      if (!expectation.where.empty() && grid.cells_of(expectation.where).empty()) {
        fail("<expect> is about cells that are all excluded; expected `where` to name others");
      }
      check_references(expectation, grid, all);
      if (grid.cells_of(expectation).empty()) {
        fail("<expect> compares cells with themselves only; expected `where` to name others");
      }
      const auto [known, is_new] = lines.emplace(expectation.name, draft.location.line);
      if (!is_new) {
        fail("the expectation on line " + std::to_string(known->second) + " is called '" +
             expectation.name + "', too; give this one another name");
      }
      expectations.push_back(std::move(expectation));
    } catch (const std::invalid_argument& error) {
      problems.add(draft.location, error.what());
    }
  }
  return expectations;
}

}  // namespace elsie::experiment
