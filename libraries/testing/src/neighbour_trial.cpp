#include <algorithm>
#include <exception>
#include <utility>

#include "elsie/plugin/call.h"

#include "trial.h"

namespace elsie::testing {
namespace {

/// A trial of another plugin, whose faults its own check finds.
class NeighbourTrial final : public Trial {
 public:
  NeighbourTrial(const Plugins& plugins, const Declaration& declaration, Input input)
      : declaration_(declaration),
        input_(std::move(input)),
        trial_(make_trial({plugins, declaration, settings_, elements_, input_})) {}

  Component& object() override { return trial_->object(); }
  void reset(std::uint64_t seed) override {
    quietly([&] { trial_->reset(seed); });
  }
  void step(std::size_t step, Answer& answer) override {
    quietly([&] { trial_->step(step, answer); });
  }
  void configure_again() override {}
  bool take_over(Trial& /*before*/) override { return false; }

 private:
  template <class Action>
  void quietly(Action action) {
    if (has_failed_) {
      return;
    }
    plugin::Call call({.plugin = &declaration_.name, .doing = "while another was checked"});
    call.start_clock();
    try {
      action();
    } catch (...) {
      has_failed_ = true;
    }
  }

  const Declaration& declaration_;
  const Settings settings_;
  const Elements elements_;
  const Input input_;
  const std::unique_ptr<Trial> trial_;
  bool has_failed_ = false;
};

/// Whether one perceives what the other makes, or both say that they share something.
bool belong_together(const Declaration& one, const Declaration& other) {
  const auto makes_for = [](const Declaration& maker, const Declaration& user) {
    return std::any_of(maker.produces.begin(), maker.produces.end(), [&](const auto& made) {
      return std::any_of(user.needs.begin(), user.needs.end(),
                         [&](const auto& needed) { return needed.kind == made.kind; });
    });
  };
  return makes_for(one, other) || makes_for(other, one) ||
         !(one.may_share_threads || other.may_share_threads);
}

}  // namespace

std::vector<const Declaration*> neighbours_of(const Declaration& declaration,
                                              const Plugins& plugins) {
  constexpr std::size_t kMost = 8;
  const auto file = plugins.host().file_of(declaration.kind, declaration.name);
  std::vector<const Declaration*> found;
  for (const PluginKind kind :
       {PluginKind::sensor, PluginKind::behavior, PluginKind::coordinator}) {
    for (const Declaration* const other : plugins.host().all(kind)) {
      if (other != &declaration && !file.empty() && found.size() < kMost &&
          belong_together(declaration, *other) &&
          plugins.host().file_of(kind, other->name) == file) {
        found.push_back(other);
      }
    }
  }
  return found;
}

std::unique_ptr<Trial> make_neighbour_trial(const Declaration& neighbour, const std::string& id,
                                            const Plugins& plugins, std::uint64_t seed) {
  constexpr int kRobot = 1;  // one with many sensors and some mates
  const CheckOptions options;
  Random random(seed);
  try {
    Input input = InputMaker(neighbour, options, plugins).make(kRobot, random);
    for (Situation& now : input.instants) {
      now.self.id = id;
    }
    return std::make_unique<NeighbourTrial>(plugins, neighbour, std::move(input));
  } catch (const std::exception&) {
    return nullptr;
  }
}

}  // namespace elsie::testing
