// What is learned: the values of behaviours in states.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <elsie/learning/values.h>

/// Throws std::invalid_argument when the values of a file were learned with others than these.
void require_same(const elsie::learning::Values& values,
                  const std::vector<elsie::learning::Remark>& here, const std::string& file);

/// A choice of a behaviour, and what came of it.
struct Choice {
  std::size_t state = 0;
  std::size_t action = 0;
  std::optional<std::size_t> leader;  // the agent whose choice it is; none: it was drawn
  double since_s = 0.0;
  double passed_s = 0.0;                // of which the rewards are known
  std::vector<double> discounted = {};  // of each agent: its rewards since then
};

/// An agent for each reward, which learns the values of all actions by Q-learning (Watkins, 1989).
/// Of several agents, the one with the largest W in a state leads: W-learning (Humphrys, 1997).
class Agents {
 public:
  Agents() = default;
  Agents(const std::vector<std::string>& names, std::size_t states, std::size_t actions);
  /// As tables() gave them.
  explicit Agents(std::vector<elsie::learning::NamedTable> tables);

  std::size_t count() const { return tables_.size() > 1 ? tables_.size() - 1 : tables_.size(); }
  const std::string& name(std::size_t agent) const { return tables_[agent].name; }
  std::vector<std::string> names() const;
  const elsie::learning::ValueTable& values(std::size_t agent) const {
    return tables_[agent].values;
  }
  /// The agent that leads in a state.
  std::size_t leader(std::size_t state) const { return count() > 1 ? weights().best(state) : 0; }
  /// How much it has to lose in a state if another one leads. There must be several agents.
  double weight(std::size_t state, std::size_t agent) const { return weights().at(state, agent); }

  /// Learns from a choice that is over. `next`: the state after it; none: nothing follows.
  /// `discount`: of what follows. `rate`: how far a value moves towards what was seen.
  void learn(const Choice& past, std::optional<std::size_t> next, double discount, double rate);

  /// The values of each agent; after those of several, the W of each of them in each state.
  const std::vector<elsie::learning::NamedTable>& tables() const { return tables_; }
  /// Whether the tables are those of so many states and actions, of one agent or of several.
  bool fit(std::size_t states, std::size_t actions, bool several) const;

 private:
  const elsie::learning::ValueTable& weights() const { return tables_.back().values; }

  std::vector<elsie::learning::NamedTable> tables_;
};
