#include "elsie/report/formulas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>

#include "elsie/base/words.h"
#include "elsie/experiment/formula_names.h"
#include "elsie/formula/formula.h"
#include "elsie/report/findings.h"

#include "goals.h"

namespace elsie::report {

namespace {

// Where a formula finds the value of a name: in a measure, a factor or, with neither, the number of
// robots.
struct Source {
  std::optional<std::size_t> measure;  // index into Results::measures
  std::optional<std::size_t> factor;   // index into Results::factors
  double unit = 1.0;                   // of the measure
};

template <class List>
std::optional<std::size_t> place_in(const List& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
  return found == list.end() ? std::nullopt
                             : std::optional(static_cast<std::size_t>(found - list.begin()));
}

// Empty when the results lack a name.
std::vector<Source> sources_of(const formula::Formula& formula, const Results& results) {
  std::vector<Source> sources;
  for (const formula::Formula::Name& name : formula.names()) {
    Source source{place_in(results.measures, name.text), place_in(results.factors, name.text)};
    if (!source.measure && !source.factor && name.text != "robots") {
      source = {place_in(results.measures, kTime), {}, 60.0};
      if (!source.measure || !experiment::is_of_every_run(name.text)) {
        return {};
      }
    }
    sources.push_back(source);
  }
  return sources;
}

using Values = std::vector<std::optional<double>>;

// The values of the names of a formula; none when one is lacking.
std::optional<std::vector<double>> values_of(const std::vector<Source>& sources,
                                             const Values& measures, const CellInfo& cell,
                                             const Run& run) {
  std::vector<double> values;
  for (const Source& source : sources) {
    const std::optional<double> value = source.measure ? measures[*source.measure]
                                        : source.factor
                                            ? experiment::number_in(cell.levels[*source.factor])
                                            : run.robots;
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value / source.unit);
  }
  return values;
}

// A run that never reached its goals, as it is and with longer times, all else equal.
class Longer {
 public:
  Longer(const Values& values, std::size_t time) {
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      cases_[i] = values;
      *cases_[i][time] += kLonger[i] * std::max(1.0, *values[time]);
    }
  }

  enum class Course { constant, rising, falling, other };

  // How a formula depends on the time. Adds its values.
  Course add(const formula::Formula& formula, const std::vector<Source>& sources,
             const CellInfo& cell, const Run& run) {
    bool rises = false, falls = false, unknown = false;
    for (Values& values : cases_) {
      const auto found = values_of(sources, values, cell, run);
      values.push_back(found ? formula.value(*found) : std::nullopt);
      const auto& before = cases_.front().back();
      unknown |= !values.back();
      if (unknown || &values == &cases_.front()) {
        continue;
      }
      const double last = *(&values)[-1].back();
      const double rounding = 1e-12 * std::max(std::abs(last), std::abs(*before));
      rises |= *values.back() > last + rounding;
      falls |= *values.back() < last - rounding;
    }
    return unknown || (rises && falls) ? Course::other
           : rises                     ? Course::rising
           : falls                     ? Course::falling
                                       : Course::constant;
  }

  void drop_last() {
    for (Values& values : cases_) {
      values.back().reset();
    }
  }

 private:
  static constexpr std::array<double, 6> kLonger{0.0, 1e-3, 0.1, 1.0, 10.0, 1000.0};
  std::array<Values, 6> cases_;
};

// What the formulas of runs that never reached their goals are.
class Bounds {
 public:
  explicit Bounds(const Results& results) : time_(place_in(results.measures, kTime)) {
    const std::vector<bool> goals = cells_with_goals(results);
    for (std::size_t i = 0; time_ && i < results.runs.size(); ++i) {
      const Run& run = results.runs[i];
      if (never_arrived(run, goals[run.cell]) && run.values[*time_]) {
        longer_.emplace(i, Longer(run.values, *time_));
      }
    }
    for (std::size_t i = 0; i < results.measures.size(); ++i) {
      of_time_only_.push_back(i == time_);
    }
  }

  // Marks the formula's values that are bounds, and takes those away of which nothing is known:
  // returns how many.
  std::uint64_t judge(const formula::Formula& formula, const std::vector<Source>& sources,
                      Results& results) {
    // A formula that falls with the time, and names another measure, is a rate: it describes the
    // time that the run took.
    const bool time_only = std::all_of(sources.begin(), sources.end(), [&](const Source& source) {
      return !source.measure || of_time_only_[*source.measure];
    });
    std::uint64_t dropped = 0;
    for (auto& [place, longer] : longer_) {
      Run& run = results.runs[place];
      const Longer::Course course = longer.add(formula, sources, results.cells[run.cell], run);
      if (course == Longer::Course::rising) {
        run.bounds.push_back(run.values.size() - 1);
      } else if (run.values.back() && (course == Longer::Course::other ||
                                       (course == Longer::Course::falling && time_only))) {
        run.values.back().reset();
        longer.drop_last();
        ++dropped;
      }
    }
    of_time_only_.push_back(time_only);
    return dropped;
  }

 private:
  std::optional<std::size_t> time_;       // index into Results::measures
  std::map<std::size_t, Longer> longer_;  // by index into Results::runs
  std::vector<bool> of_time_only_;        // parallel to Results::measures
};

}  // namespace

std::vector<std::string> add_formulas(Results& results,
                                      const std::vector<experiment::MeasureUse>& uses) {
  std::vector<std::string> sentences;
  std::optional<Bounds> bounds;
  for (const experiment::MeasureUse& use : uses) {
    if (use.formula.empty()) {
      continue;
    }
    const formula::Formula formula(use.formula);
    const std::vector<Source> sources = sources_of(formula, results);
    if (sources.empty()) {
      continue;
    }
    if (!bounds) {
      bounds.emplace(results);
    }
    std::uint64_t undefined = 0;
    for (Run& run : results.runs) {
      const auto values = values_of(sources, run.values, results.cells[run.cell], run);
      run.values.push_back(values ? formula.value(*values) : std::nullopt);
      undefined += values && !run.values.back() ? 1 : 0;
    }
    std::string meaning = (use.meaning.empty() ? "" : use.meaning + ": ") + use.formula;
    const auto add = [&](const std::string& where) {
      meaning += "; no value in " + where;
      sentences.push_back("the measure '" + use.name + "' has no value in " + where);
    };
    if (undefined > 0) {
      add(base::counted(undefined, "run") +
          ", where its formula divides by 0 or gives no finite number");
    }
    if (const std::uint64_t unknown = bounds->judge(formula, sources, results); unknown > 0) {
      add(base::counted(unknown, "run") +
          " without success: their times are only bounds, and the formula does not rise with "
          "time_s");
    }
    results.measures.push_back({use.name, use.unit, std::move(meaning)});
  }
  return sentences;
}

}  // namespace elsie::report
