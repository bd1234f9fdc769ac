// A network of competence modules through which activation spreads (Maes, 1989).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

class SpreadingNetwork {
 public:
  using Set = std::uint64_t;  // of propositions, a bit each
  static constexpr std::size_t kPropositions = 64;

  struct Parameters {
    double phi = 20.0;    // from each true proposition
    double gamma = 70.0;  // from each goal
    double delta = 50.0;  // taken by each protected goal
    double pi = 20.0;     // mean level
    double theta = 45.0;  // threshold
  };

  struct Module {
    Set needs = 0;
    Set adds = 0;
    Set deletes = 0;
    double level = 0.0;  // of activation
  };

  std::vector<Module> modules;
  double threshold = 0.0;

  /// Counts the modules that need, add and delete each proposition.
  void prepare() {
    needing_.fill(0.0);
    adding_.fill(0.0);
    deleting_.fill(0.0);
    for (const Module& module : modules) {
      for (std::size_t j = 0; j < kPropositions; ++j) {
        needing_[j] += module.needs >> j & 1 ? 1.0 : 0.0;
        adding_[j] += module.adds >> j & 1 ? 1.0 : 0.0;
        deleting_[j] += module.deletes >> j & 1 ? 1.0 : 0.0;
      }
    }
    next_.assign(modules.size(), 0.0);
  }

  void reset(double theta) {
    for (Module& module : modules) {
      module.level = 0.0;
    }
    threshold = theta;
    selected_.reset();
  }

  bool is_executable(std::size_t i, Set state) const { return !(modules[i].needs & ~state); }

  /// One time step: spreads activation, and returns the module that becomes active, if any.
  std::optional<std::size_t> step(Set state, Set goals, const Parameters& with) {
    double sum = 0.0;
    for (std::size_t y = 0; y < modules.size(); ++y) {
      double level = selected_ == y ? 0.0 : modules[y].level;
      level += input(modules[y], state, goals, with);
      for (std::size_t x = 0; x < modules.size(); ++x) {
        level += spread(x, y, state, with) - (x == y ? 0.0 : taken(x, y, state, with));
      }
      sum += next_[y] = std::max(0.0, level);
    }
    // The mean stays at pi.
    const double scale = sum > 0.0 ? with.pi * static_cast<double>(modules.size()) / sum : 0.0;
    selected_.reset();
    for (std::size_t y = 0; y < modules.size(); ++y) {
      modules[y].level = scale * next_[y];
      if (is_executable(y, state) && modules[y].level > 0.0 && modules[y].level >= threshold &&
          (!selected_ || modules[y].level > modules[*selected_].level)) {
        selected_ = y;
      }
    }
    threshold = selected_ ? with.theta : 0.9 * threshold;
    return selected_;
  }

  /// The module that the last step selected: its level begins anew in the next one.
  std::optional<std::size_t> selected() const { return selected_; }
  void select(std::optional<std::size_t> module) { selected_ = module; }

 private:
  using Counts = std::array<double, kPropositions>;

  /// The sum over `part` of 1 / (modules that share the proposition), divided by the size of the
  /// list `whole`, of which it is a part.
  static double share(Set part, const Counts& sharing, Set whole) {
    double sum = 0.0;
    for (Set rest = part; rest; rest &= rest - 1) {
      sum += 1.0 / sharing[static_cast<std::size_t>(std::countr_zero(rest))];
    }
    return part ? sum / std::popcount(whole) : 0.0;
  }

  /// From the situation and the goals, less what protected goals, those that are reached, take.
  double input(const Module& y, Set state, Set goals, const Parameters& with) const {
    return with.phi * share(state & y.needs, needing_, y.needs) +
           with.gamma * share(goals & ~state & y.adds, adding_, y.adds) -
           with.delta * share(goals & state & y.deletes, deleting_, y.deletes);
  }

  /// What module x gives to y: backwards to one that adds what x lacks, forwards to one that lacks
  /// what x will add.
  double spread(std::size_t from, std::size_t to, Set state, const Parameters& with) const {
    const Module& x = modules[from];
    const Module& y = modules[to];
    return x.level *
           (is_executable(from, state)
                ? with.phi / with.gamma * share(x.adds & y.needs & ~state, needing_, y.needs)
                : share(x.needs & y.adds & ~state, adding_, y.adds));
  }

  /// What module x takes from y, which would delete what x needs and has. Of two that threaten each
  /// other, only the one with the higher level takes.
  double taken(std::size_t from, std::size_t to, Set state, const Parameters& with) const {
    const Module& x = modules[from];
    const Module& y = modules[to];
    if (x.level < y.level && (state & y.needs & x.deletes)) {
      return 0.0;
    }
    const double threat = share(x.needs & y.deletes & state, deleting_, y.deletes);
    return std::min(y.level, x.level * with.delta / with.gamma * threat);
  }

  Counts needing_{}, adding_{}, deleting_{};
  std::vector<double> next_;
  std::optional<std::size_t> selected_;
};
