#include "elsie/report/formulas.h"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "elsie/base/words.h"
#include "elsie/experiment/formula.h"

namespace elsie::report {

namespace {

// Where a formula finds the value of a name.
struct Source {
  std::optional<std::size_t> measure;  // index into Results::measures; none: a factor
  std::size_t factor = 0;              // index into Results::factors
};

template <class List>
std::optional<std::size_t> place_in(const List& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
  return found == list.end() ? std::nullopt
                             : std::optional(static_cast<std::size_t>(found - list.begin()));
}

// Empty when the results lack a name.
std::vector<Source> sources_of(const experiment::Formula& formula, const Results& results) {
  std::vector<Source> sources;
  for (const experiment::Formula::Name& name : formula.names()) {
    const auto measure = place_in(results.measures, name.text);
    const auto factor = place_in(results.factors, name.text);
    if (!measure && !factor) {
      return {};
    }
    sources.push_back({measure, factor.value_or(0)});
  }
  return sources;
}

// None when the run lacks a value.
std::optional<std::vector<double>> values_of(const std::vector<Source>& sources, const Run& run,
                                             const Results& results) {
  std::vector<double> values;
  for (const Source& source : sources) {
    const std::optional<double> value =
        source.measure ? run.values[*source.measure]
                       : experiment::number_in(results.cells[run.cell].levels[source.factor]);
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

}  // namespace

std::vector<std::string> add_formulas(Results& results,
                                      const std::vector<experiment::MeasureUse>& uses) {
  std::vector<std::string> sentences;
  for (const experiment::MeasureUse& use : uses) {
    if (use.formula.empty()) {
      continue;
    }
    const experiment::Formula formula(use.formula);
    const std::vector<Source> sources = sources_of(formula, results);
    if (sources.empty()) {
      continue;
    }
    std::uint64_t undefined = 0;
    for (Run& run : results.runs) {
      const auto values = values_of(sources, run, results);
      run.values.push_back(values ? formula.value(*values) : std::nullopt);
      undefined += values && !run.values.back() ? 1 : 0;
    }
    std::string meaning = (use.meaning.empty() ? "" : use.meaning + ": ") + use.formula;
    if (undefined > 0) {
      const std::string where = base::counted(undefined, "run") +
                                ", where its formula divides by 0 or gives no finite number";
      meaning += "; no value in " + where;
      sentences.push_back("the measure '" + use.name + "' has no value in " + where);
    }
    results.measures.push_back({use.name, use.unit, std::move(meaning)});
  }
  return sentences;
}

}  // namespace elsie::report
