#include "same_run.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "elsie/base/number_text.h"

namespace elsie::program {

using batch::RunRecord;
using simulation::MeasuredValue;
using simulation::RunResult;

namespace {

std::string value_text(const std::optional<double>& value, const std::string& unit) {
  return value ? base::number_text(*value) + (unit.empty() ? "" : " " + unit) : "none";
}

/// Databases hold only finite numbers.
std::optional<double> as_stored(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

template <class List>
auto named(const List& measures, const std::string& name) {
  return std::find_if(measures.begin(), measures.end(),
                      [&](const auto& measure) { return measure.name == name; });
}

void compare_measures(const RunRecord& before, const RunResult& now,
                      std::vector<std::string>& differences) {
  for (const MeasuredValue& measured : now.measures) {
    const std::optional<double> value = as_stored(measured.value);
    const auto old = named(before.measures, measured.name);
    if (old == before.measures.end()) {
      differences.push_back("measure " + measured.name + ' ' + value_text(value, measured.unit) +
                            ", before not measured");
    } else if (old->value != value) {
      differences.push_back("measure " + measured.name + ' ' + value_text(value, measured.unit) +
                            ", before " + value_text(old->value, old->unit));
    }
  }
  for (const MeasuredValue& old : before.measures) {
    if (named(now.measures, old.name) == now.measures.end()) {
      differences.push_back("measure " + old.name + " not measured, before " +
                            value_text(old.value, old.unit));
    }
  }
}

}  // namespace

std::vector<std::string> differences(const RunRecord& before, const RunResult& now) {
  std::vector<std::string> found;
  const auto compare = [&](const char* what, const std::string& value,
                           const std::optional<std::string>& old) {
    if (old != value) {
      found.push_back(std::string(what) + ' ' + value + ", before " + old.value_or("none"));
    }
  };
  compare("state hash", simulation::hash_text(now.state_hash), before.state_hash);
  compare("outcome", to_string(now.outcome),
          before.outcome ? std::optional<std::string>(to_string(*before.outcome)) : std::nullopt);
  compare("steps", std::to_string(now.steps),
          before.steps ? std::optional(std::to_string(*before.steps)) : std::nullopt);
  compare_measures(before, now, found);
  return found;
}

}  // namespace elsie::program
