#include "agents.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

using elsie::learning::NamedTable;
using elsie::learning::Remark;
using elsie::learning::Values;
using elsie::learning::ValueTable;

void require_same(const Values& values, const std::vector<Remark>& here, const std::string& file) {
  for (const auto& [key, text] : here) {
    if (values.remark(key) == text) continue;
    throw std::invalid_argument(file + ": it was learned with the " + key + " '" +
                                std::string(values.remark(key)) + "', but here it is '" + text +
                                "'; train again with elsie train, or restore that");
  }
}

Agents::Agents(const std::vector<std::string>& names, std::size_t states, std::size_t actions) {
  for (const std::string& name : names) tables_.push_back({name, ValueTable(states, actions)});
  if (names.size() > 1) tables_.push_back({"W", ValueTable(states, names.size())});
}

Agents::Agents(std::vector<NamedTable> tables) : tables_(std::move(tables)) {}

std::vector<std::string> Agents::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count(); ++i) names.push_back(name(i));
  return names;
}

void Agents::learn(const Choice& past, std::optional<std::size_t> next, double discount,
                   double rate) {
  for (std::size_t i = 0; i < count(); ++i) {
    ValueTable& values = tables_[i].values;
    const double seen = past.discounted[i] + (next ? discount * values.most(*next) : 0.0);
    if (count() > 1 && past.leader && past.leader != i) {
      double& weight = tables_.back().values.at(past.state, i);
      weight += rate * (values.most(past.state) - seen - weight);
    }
    double& value = values.at(past.state, past.action);
    value += rate * (seen - value);
  }
}

bool Agents::fit(std::size_t states, std::size_t actions, bool several) const {
  if (tables_.empty() || (tables_.size() > 1) != several || tables_.size() == 2) return false;
  const auto has = [](const NamedTable& table, std::size_t rows, std::size_t columns) {
    return table.values.states() == rows && table.values.actions() == columns;
  };
  return std::all_of(tables_.begin(), tables_.begin() + static_cast<std::ptrdiff_t>(count()),
                     [&](const NamedTable& table) { return has(table, states, actions); }) &&
         (!several || has(tables_.back(), states, count()));
}
