#include "measures.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "elsie/base/near_name.h"
#include "elsie/experiment/formula_names.h"
#include "elsie/formula/formula.h"

namespace elsie::experiment {

namespace {

using formula::Formula;
using Names = std::vector<std::string>;

bool is_in(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string beginning(const std::string& formula) {
  return "formula=\"" + formula + "\" of <measure>: ";
}

// None when it has mistakes, which are problems of the file.
std::optional<Formula> formula_of(const std::string& text) {
  try {
    return Formula(text);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// What is wrong with a formula by itself; "" if nothing.
std::string mistake(const MeasureDraft& draft, const std::vector<Factor>& factors) {
  if (!draft.formula) {
    return draft.unit || draft.meaning
               ? "the measure '" + draft.name + "' has a " + (draft.unit ? "unit" : "meaning") +
                     " of its own; expected it with a formula only"
               : "";
  }
  const std::optional<Formula> as_name = formula_of(draft.name);
  if (!as_name || as_name->names().size() != 1 || as_name->names()[0].text != draft.name) {
    return "a formula cannot be called '" + draft.name +
           "'; expected a letter or \"_\", then letters, digits, \"_\" and \".\"";
  }
  if (is_of_every_run(draft.name)) {
    return "a formula cannot be called '" + draft.name +
           "', which formulas may use of every run; give it another name";
  }
  if (std::any_of(factors.begin(), factors.end(),
                  [&](const Factor& factor) { return factor.name == draft.name; })) {
    return "the formula '" + draft.name + "' is called like a factor; give it another name";
  }
  try {
    if (Formula(*draft.formula).names().empty()) {
      return beginning(*draft.formula) + "it names no measure; expected one that the runs have";
    }
  } catch (const std::invalid_argument& error) {
    return beginning(*draft.formula) + error.what();
  }
  return "";
}

// The names that a formula may use besides the measures of runs: factors, and formulas before it.
class Known {
 public:
  Known(const Experiment& experiment, const CellMeasures& measures)
      : experiment_(experiment), measures_(measures) {}

  // What is wrong with a name of a formula; "" if nothing.
  std::string mistake(const std::string& name) const {
    const auto factor = factor_called(name);
    if (is_measure(name) || (is_of_every_run(name) && !factor)) {
      return "";
    }
    if (is_of_every_run(name)) {
      return "'" + name +
             "' is a factor, and what formulas may use of every run; give the factor " +
             "another name";
    }
    if (!factor) {
      return "there is no measure or factor '" + name + "'" +
             base::near_or_all(name, all(), "there are");
    }
    const auto word = std::find_if(factor->levels.begin(), factor->levels.end(),
                                   [](const Level& level) { return !number_in(level.label); });
    return word == factor->levels.end()
               ? ""
               : "the factor '" + name + "' has a level '" + word->label +
                     "', which is no number; expected a factor whose levels are numbers";
  }

  bool is_factor(const std::string& name) const { return factor_called(name) != nullptr; }

  // Adds the factors that are called like a measure: tables and models could not tell them apart.
  void check_factors(base::Problems& problems) const {
    for (const Factor& factor : experiment_.factors) {
      if (is_measure(factor.name)) {
        problems.add(factor.location, "the factor '" + factor.name +
                                          "' is called like a measure of the runs; give the "
                                          "factor another name");
      }
    }
  }

 private:
  const Factor* factor_called(const std::string& name) const {
    const auto found = std::find_if(experiment_.factors.begin(), experiment_.factors.end(),
                                    [&](const Factor& factor) { return factor.name == name; });
    return found == experiment_.factors.end() ? nullptr : &*found;
  }

  bool is_measure(const std::string& name) const {
    return std::any_of(measures_.lists.begin(), measures_.lists.end(), [&](const auto& list) {
      return std::any_of(list.begin(), list.end(),
                         [&](const Quantity& quantity) { return quantity.name == name; });
    });
  }

  Names all() const {
    Names names;
    for (const auto& list : measures_.lists) {
      for (const Quantity& quantity : list) {
        if (!is_in(names, quantity.name)) {
          names.push_back(quantity.name);
        }
      }
    }
    for (const Factor& factor : experiment_.factors) {
      names.push_back(factor.name);
    }
    names.insert(names.end(), {"robots", "minutes"});
    return names;
  }

  const Experiment& experiment_;
  const CellMeasures& measures_;
};

bool has_measure(const std::vector<Quantity>& list, const std::string& name) {
  return std::any_of(list.begin(), list.end(),
                     [&](const Quantity& quantity) { return quantity.name == name; });
}

// The lists that have all that a formula names; those that have its own name are a mistake.
std::vector<std::size_t> lists_for(const MeasureUse& use, const Known& known,
                                   const CellMeasures& measures, base::Problems& problems) {
  const std::optional<Formula> formula = formula_of(use.formula);
  std::vector<std::size_t> fit;
  for (std::size_t i = 0; i < measures.lists.size(); ++i) {
    const auto& list = measures.lists[i];
    if (has_measure(list, use.name)) {
      problems.add(use.location, "the runs have a measure '" + use.name +
                                     "' already; give the formula another name");
      return {};
    }
    const bool complete = !formula || std::all_of(formula->names().begin(), formula->names().end(),
                                                  [&](const Formula::Name& name) {
                                                    return has_measure(list, name.text) ||
                                                           known.is_factor(name.text) ||
                                                           is_of_every_run(name.text);
                                                  });
    if (complete) {
      fit.push_back(i);
    }
  }
  if (!formula) {
    return fit;
  }
  bool sound = true;
  for (const Formula::Name& name : formula->names()) {
    if (const std::string wrong = known.mistake(name.text); !wrong.empty()) {
      problems.add(use.location,
                   beginning(use.formula) + "column " + std::to_string(name.column) + ": " + wrong);
      sound = false;
    }
  }
  if (sound && fit.empty()) {
    problems.add(use.location,
                 beginning(use.formula) +
                     "no run has all of its measures; expected measures of the same world");
  }
  return fit;
}

}  // namespace

std::vector<MeasureUse> measures_from(const std::vector<MeasureDraft>& drafts,
                                      const std::vector<Factor>& factors,
                                      base::Problems& problems) {
  std::vector<MeasureUse> uses;
  std::set<std::string> known;
  for (const MeasureDraft& draft : drafts) {
    if (!known.insert(draft.name).second) {
      problems.add(draft.location, "the measure '" + draft.name + "' is named twice");
      continue;
    }
    if (const std::string wrong = mistake(draft, factors); !wrong.empty()) {
      problems.add(draft.location, wrong);
    }
    // One without a text stays a formula.
    const std::string formula =
        draft.formula && draft.formula->empty() ? " " : draft.formula.value_or("");
    uses.push_back(
        {draft.name, draft.location, formula, draft.unit.value_or(""), draft.meaning.value_or("")});
  }
  return uses;
}

void add_formulas(const Experiment& experiment, CellMeasures& measures, base::Problems& problems) {
  Known(experiment, measures).check_factors(problems);
  for (const MeasureUse& use : experiment.measures) {
    if (use.formula.empty()) {
      continue;
    }
    for (const std::size_t list : lists_for(use, Known(experiment, measures), measures, problems)) {
      measures.lists[list].push_back({use.name, use.unit, use.meaning});
    }
  }
}

std::vector<std::string> shown_measures(const std::vector<MeasureUse>& uses) {
  Names names;
  if (std::any_of(uses.begin(), uses.end(),
                  [](const MeasureUse& use) { return use.formula.empty(); })) {
    std::transform(uses.begin(), uses.end(), std::back_inserter(names),
                   [](const MeasureUse& use) { return use.name; });
  }
  return names;
}

bool is_of_every_run(const std::string& name) {
  return name == "robots" || name == "minute" || name == "minutes";
}

std::optional<double> number_in(const std::string& label) {
  double number = 0.0;
  const char* const end = label.data() + label.size();
  const auto [read, error] = std::from_chars(label.data(), end, number);
  return error == std::errc() && read == end && std::isfinite(number) ? std::optional(number)
                                                                      : std::nullopt;
}

}  // namespace elsie::experiment
