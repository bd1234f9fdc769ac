// Behaviours and their coordinator at run time: those of a robot, and those inside a behaviour that
// holds others, to any depth.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

#include "changes/tuning.h"
#include "plugins/guard.h"
#include "plugins/names.h"
#include "plugins/statements.h"

namespace elsie::simulation {

class Swap;
class Becoming;

/// What behaviours want of their robot besides the command.
class Wishes {
 public:
  virtual void raise(const Event& event) = 0;
  virtual void ask_for_charge() = 0;

 protected:
  ~Wishes() = default;
};

class Controller final : public Coordination, private Member::Runner {
 public:
  /// What all controllers of one robot share.
  struct Setting {
    const plugin::Host& host;  // while the objects are made; it may be gone later
    Guard& guard;
    Wishes& wishes;
    Names& names;
    bool measure_time;
  };

  /// Makes the plugin objects; adds to `problems` what they refuse.
  Controller(const world::Coordination& description, const Setting& setting,
             std::vector<base::Problem>& problems);
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// Tells all objects what the robot has; see Behavior::equipped().
  void equip(const Perception& example, std::vector<base::Problem>& problems);
  /// Fresh random streams, named after `path`, which ends in "/"; all objects reset.
  void reset(std::uint64_t seed, const std::string& path);
  /// Gathers what the objects say once they are reset. `path` is what stands before their ids and
  /// ends in "/", or "".
  void ask(const std::string& path, Statements& said);

  /// Before each decision: forgets the last answers, at every depth.
  void begin_step();
  /// The command of the coordinator, checked; zero when there is none. Throws PluginFault.
  Motion decide(const Perception& now);

  Response respond(const Perception& now) override;
  void rate(std::span<const Motion> candidates, std::span<double> desirability) override;
  CommandSets command_sets() override;

  /// The object that a use of a plugin stands for, at any depth; none when it is not in here.
  std::optional<TunedObject> object_of(const world::PluginUse& use);
  /// Puts new objects in the places of those whose plugins have changed, at any depth. `path` is
  /// what stands before their names and ends in "/".
  void replace(Swap& swap, const std::string& path);
  /// Throws ReplacementRefused when a behaviour needs readings that are not there.
  void check_needs(std::span<const ReadingGroup> groups, const std::string& robot,
                   const std::string& path) const;

  /// Becomes what `next` describes; `was` is what it is now. What is described as before stays.
  void become(const world::Coordination& was, const world::Coordination& next,
              const std::string& path, Becoming& becoming);
  /// Tells all objects anew what the robot has, `all` or those that are new.
  void equip_anew(Becoming& becoming, const Perception& example, bool all);
  /// Resets those that are new, and gathers what they say. `path` as in reset() and `shown` as in
  /// ask().
  void reset_new(Becoming& becoming, const std::string& path, const std::string& shown);

  /// Sets the priority of a behaviour, at any depth, until the next reset. The trace of the last
  /// decision stays.
  void set_priority(const world::PluginUse& use, double priority);

  std::span<const Member> members() const { return members_; }
  /// Appends what was inferred in the last decision. `path` as in list_members().
  void list_inferences(const std::string& path, std::vector<MadeInference>& list) const;
  /// Appends all members, each followed by those inside it. `path` is what stands before their
  /// names; they stay where they are for the life of the controller.
  void list_members(const std::string& path, int depth, int parent,
                    std::vector<TracedMember>& list) const;

 private:
  struct Slot {
    const world::BehaviorUse* use = nullptr;
    const Declaration* declaration = nullptr;
    std::unique_ptr<Controller> inside;  // of a behaviour that holds others
    plugin::Object<Behavior> object;
    Random random;
    Response response;

    TunedObject own_object() const {
      return {PluginKind::behavior, use, declaration, object.get(), {}};
    }
  };

  std::shared_ptr<Slot> make_slot(const world::BehaviorUse& use, const plugin::Host& host,
                                  std::vector<base::Problem>& problems);
  static const world::Coordination& inside_of(const world::BehaviorUse& use);
  void list_slots();
  std::vector<Member> copied_members();
  void take_members(std::vector<Member> members);
  void make_coordinator(const plugin::Host& host, std::vector<base::Problem>& problems);
  /// The coordinator, if there is one.
  TunedObject own_object() const {
    return {PluginKind::coordinator, &*description_->coordinator, coordinator_declaration_,
            coordinator_.get(), members_};
  }

  const Response& run(Member& member) override;
  void rate(Member& member, std::span<const Motion> candidates,
            std::span<double> desirability) override;
  CommandSets command_sets(Member& member) override;

  Slot& slot_of(const Member& member) {
    return *slots_[static_cast<std::size_t>(&member - members_.data())];
  }
  void set_priority(std::size_t member, double priority);
  void check(const Slot& slot, const Response& response) const;
  void check_trace();

  const world::Coordination* description_;
  Setting setting_;
  std::vector<std::shared_ptr<Slot>> slots_;
  bool has_other_members_ = false;  // since the coordinator was equipped
  std::vector<Member> members_;
  std::vector<const char*> reasons_;  // of each member's trace, kept
  plugin::Object<Coordinator> coordinator_;
  const Declaration* coordinator_declaration_ = nullptr;
  Random random_;                  // the coordinator's
  std::optional<Perception> now_;  // of the last decision: members may be asked later in a step
  Motion command_;                 // of the last decision
};

}  // namespace elsie::simulation
