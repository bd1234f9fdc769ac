// New plugin objects in the places of old ones.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/component.h"
#include "elsie/api/declaration.h"
#include "elsie/base/random.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/simulation/replacement.h"
#include "elsie/world/description.h"

#include "changes/tuning.h"
#include "plugins/guard.h"

namespace elsie::simulation {

/// All that is exchanged at one time. Undone by its destructor unless it was settled.
class Swap {
 public:
  /// One object that is new.
  struct Exchanged {
    PluginKind kind = PluginKind::behavior;
    const world::PluginUse* use = nullptr;
    std::string robot;
    std::string path;  // on the robot: "behavior[roam]"
    const Declaration* declaration = nullptr;
    Component* before = nullptr;
    Component* now = nullptr;
    Random* random = nullptr;
    Setup described;               // what the world will say
    std::optional<Setup> changed;  // parameters that are not as the world says
    bool remembers = false;        // what the old object remembered
  };

  /// `host`: where the new objects come from. Files that new parameters name by default are looked
  /// for in `data_directories`.
  Swap(const plugin::Host& host, std::uint64_t seed, std::vector<std::string> data_directories)
      : host_(host), seed_(seed), data_directories_(std::move(data_directories)) {}
  Swap(const Swap&) = delete;
  Swap& operator=(const Swap&) = delete;
  ~Swap();

  /// The robot that the next exchanges are about.
  void begin_robot(const std::string& id, const Tuning& tuning) {
    robot_ = id;
    tuning_ = &tuning;
  }

  /// Puts a new object in the place of `object` if its plugin has changed; whether it did.
  /// `inside`: what it holds if it is a behaviour that holds others. Throws ReplacementRefused.
  template <class Kind>
  bool exchange(PluginKind kind, const world::PluginUse& use, const std::string& path,
                plugin::Object<Kind>& object, const Declaration*& declaration, Random& random,
                Coordination* inside = nullptr) {
    const Declaration* const fresh = checked(kind, use, path, *declaration);
    if (fresh == declaration) {
      return false;
    }
    Exchanged exchanged{kind,    &use,    robot_, path, fresh, object.get(),
                        nullptr, &random, {},     {},   false};
    run(exchanged, [&] {
      auto made = host_.create<Kind>(kind, use.plugin);
      if (fresh->hold) {
        fresh->hold(*made, *inside);
      }
      const Setup setup = setup_for(exchanged);
      plugin::apply_parameters(*fresh, *made, setup.parameters, setup.elements);
      exchanged.now = made.get();
      auto old = std::make_shared<plugin::Object<Kind>>(std::move(made));
      object.swap(*old);
      undo([&object, &declaration, old, before = std::exchange(declaration, fresh)] {
        object.swap(*old);
        declaration = before;
      });
    });
    all_.push_back(std::move(exchanged));
    return true;
  }

  /// What else has to be put back, in reverse order, when this is not settled.
  void undo(std::function<void()> action) { undo_.push_back(std::move(action)); }

  /// What follows from the new objects once all of them are in use, but not before. Throws nothing.
  void when_settled(std::function<void()> action) { when_settled_.push_back(std::move(action)); }

  /// Runs code of a new object; what it throws becomes a ReplacementRefused.
  template <class Action>
  void run(const Exchanged& exchanged, Action action) {
    const plugin::Call call({.plugin = exchanged.use->plugin.c_str(),
                             .id = exchanged.use->id.c_str(),
                             .robot = exchanged.robot.c_str(),
                             .doing = "while it was put in the place of an older one"});
    try {
      action();
    } catch (...) {
      refuse(exchanged.robot, exchanged.path, what_was_thrown());
    }
  }

  /// Resets the new objects from `first` on, and hands over what the old ones remember.
  void hand_over(std::size_t first);

  /// All those that were exchanged.
  const std::vector<Exchanged>& all() const { return all_; }

  /// From here on nothing is undone. Takes over what is left of the parameters: the world's and, by
  /// `tuning_of` a robot, those that were changed. The old objects go. All that can be refused was
  /// refused before.
  void settle(const std::function<Tuning&(const std::string& robot)>& tuning_of);

  Replacement result() const;

  [[noreturn]] static void refuse(const std::string& robot, const std::string& path,
                                  const std::string& problem) {
    throw ReplacementRefused("robot '" + robot + "', " + path + ": " + problem);
  }

 private:
  const Declaration* checked(PluginKind kind, const world::PluginUse& use, const std::string& path,
                             const Declaration& before) const;
  Setup setup_for(Exchanged& exchanged);
  void add_default_files(const Declaration& declaration, Setup& setup) const;

  const plugin::Host& host_;
  std::uint64_t seed_;
  std::vector<std::string> data_directories_;
  std::string robot_;
  const Tuning* tuning_ = nullptr;
  std::vector<Exchanged> all_;
  std::vector<std::function<void()>> undo_;
  std::vector<std::function<void()>> when_settled_;
  std::vector<std::string> notes_;
};

}  // namespace elsie::simulation
