// Finds the cells that an expectation covers.
#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "elsie/experiment/grid.h"

#include "grid.h"

namespace elsie::experiment {

bool matches(const std::string& pattern, const std::string& label) {
  // The position after the last star in the pattern, and the end of the text that it matches so
  // far.
  std::size_t star = std::string::npos, stood_for = 0, at = 0, in = 0;
  while (in < label.size()) {
    if (at < pattern.size() && pattern[at] == '*') {
      star = ++at;
      stood_for = in;
    } else if (at < pattern.size() && pattern[at] == label[in]) {
      ++at;
      ++in;
    } else if (star != std::string::npos) {
      at = star;
      in = ++stood_for;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', at) == std::string::npos;
}

Grid::Grid(std::vector<std::string> factors, std::vector<std::vector<std::string>> cells)
    : factors_(std::move(factors)), cells_(std::move(cells)) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i].size() != factors_.size()) {
      throw std::invalid_argument("cell " + std::to_string(i) + " has " +
                                  std::to_string(cells_[i].size()) + " labels; expected " +
                                  std::to_string(factors_.size()) + ", one for each factor");
    }
    places_.emplace(cells_[i], i);
  }
}

Grid::Grid(const Experiment& experiment, const std::vector<Cell>& cells)
    : factors_(factor_names(experiment)) {
  for (const Cell& cell : cells) {
    places_.emplace(cell.labels, cells_.size());
    cells_.push_back(cell.labels);
  }
}

std::optional<std::size_t> Grid::place_of(const std::string& factor) const {
  const auto found = std::find(factors_.begin(), factors_.end(), factor);
  return found == factors_.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - factors_.begin()));
}

std::vector<Labels> Grid::labels() const {
  std::vector<Labels> all;
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    Labels& labels = all.emplace_back(Labels{factors_[i], {}});
    std::set<std::string> known;
    for (const std::vector<std::string>& cell : cells_) {
      if (known.insert(cell[i]).second) {
        labels.labels.push_back(cell[i]);
      }
    }
  }
  return all;
}

std::vector<std::size_t> Grid::cells_of(const Expectation& expectation) const {
  std::vector<std::size_t> found = cells_of(expectation.where);
  std::erase_if(found, [&](std::size_t cell) { return reference_of(expectation, cell) == cell; });
  return found;
}

std::vector<std::size_t> Grid::cells_of(const std::vector<Where>& where) const {
  std::vector<std::optional<std::size_t>> places;
  for (const Where& one : where) {
    places.push_back(place_of(one.factor));
  }
  const auto is_named = [&](const std::vector<std::string>& labels) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& patterns = where[i].levels;
      if (!places[i] ||
          std::none_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
            return matches(pattern, labels[*places[i]]);
          })) {
        return false;
      }
    }
    return true;
  };
  std::vector<std::size_t> found;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
    if (is_named(cells_[cell])) {
      found.push_back(cell);
    }
  }
  return found;
}

std::optional<std::size_t> Grid::reference_of(const Expectation& expectation,
                                              std::size_t cell) const {
  if (expectation.relation == Relation::none) {
    return std::nullopt;
  }
  std::vector<std::string> labels = cells_.at(cell);
  for (const LevelOf& other : expectation.reference) {
    const auto place = place_of(other.factor);
    if (!place) {
      return std::nullopt;
    }
    labels[*place] = other.level;
  }
  const auto found = places_.find(labels);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace elsie::experiment
