// Behaviours and their coordinator at run time: those of a robot, or those inside a behaviour that
// holds others, at any depth.
#pragma once

#include <cstddef>
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

#include "plugins/guard.h"
#include "plugins/plugin_object.h"

namespace elsie::simulation {

class EditTransaction;

/// What behaviours request from their robot besides the motion.
class RobotRequests {
 public:
  virtual void raise(const Event& event) = 0;
  virtual void ask_for_charge() = 0;
  /// The index of the actuator that the robot has for this act, whose command is made if it is
  /// given by numbers. Throws std::invalid_argument or base::Error with a sentence when it has
  /// none, or the command does not fit it.
  virtual std::size_t actuator_for(Act& act) const = 0;
  /// The actuator's id.
  virtual std::string_view actuator(std::size_t index) const = 0;

 protected:
  ~RobotRequests() = default;
};

class Controller final : public Coordination, private Member::Runner {
 public:
  /// Objects that all controllers of one robot share.
  struct Setting {
    Guard& guard;
    RobotRequests& requests;
    bool measure_time;
  };

  /// Makes the plugin objects; adds what they refuse to `problems`.
  Controller(const world::Coordination& description, const plugin::Host& host,
             const Setting& setting, std::vector<base::Problem>& problems);
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  /// Visits all objects, at every depth. `path` and `within` are prefixes of their names.
  void for_each(Order order, const std::string& path, const std::string& within,
                const Visit& visit) const;
  /// Called before a run: sets priorities to those of the description.
  void begin_run();

  /// Called before each decision: forgets the last answers, at every depth.
  void begin_step();
  /// The command of the coordinator, checked; zero when there is none. Throws PluginFault.
  Motion decide(const Perception& now);

  /// What actuators are to do by the last decision.
  struct ChosenAct {
    std::size_t actuator;  // its index
    Act act;
  };
  std::span<const ChosenAct> acts() const { return acts_; }
  /// Forgets them, at every depth.
  void forget_acts();

  Response respond(const Perception& now) override;
  void rate(std::span<const Motion> candidates, std::span<double> desirability) override;
  CommandSets command_sets() override;

  /// Becomes what `next` describes; `was` is the present description. Unchanged objects stay.
  void become(const world::Coordination& was, const world::Coordination& next,
              const std::string& path, EditTransaction& transaction);

  /// Takes a copy of its description with the same objects in it.
  void describe(const world::Coordination& next);
  /// Sets the priority of a behaviour by its index in list_members(), of which those counted are
  /// taken off; returns whether it is here.
  bool set_priority(std::size_t& index, double priority);
  /// Takes the priorities of the description, at any depth. The trace of the last decision stays.
  void take_priorities();

  std::span<const Member> members() const { return members_; }
  /// Appends the inferences of the last decision. `path` as in list_members().
  void list_inferences(const std::string& path, std::vector<MadeInference>& list) const;
  /// Appends the graphs of its coordinator and of those inside its behaviours.
  void list_graphs(const std::string& path, std::vector<LitGraph>& list) const;
  /// Appends all members, each followed by those inside it. `path` is the prefix of their names.
  /// Their addresses stay valid for the life of the controller.
  void list_members(const std::string& path, int depth, int parent,
                    std::vector<TracedMember>& list) const;

 private:
  struct Slot final : ObjectOf<Behavior, PluginKind::behavior> {
    using ObjectOf::ObjectOf;
    void equip(Component& object, const Example& example) const override {
      static_cast<Behavior&>(object).equipped(example.perception);
    }
    Coordination* inside_of_it() override { return inside.get(); }
    void forget() override { response = {}; }

    bool only_acts() const { return declaration && declaration->only_acts; }

    std::size_t place = 0;               // in the description
    std::unique_ptr<Controller> inside;  // of a behaviour that holds others
    Response response;
    std::vector<std::size_t> actuators;  // of the acts in the response
  };
  struct CoordinatorSlot final : ObjectOf<Coordinator, PluginKind::coordinator> {
    CoordinatorSlot(const world::PluginUse& described, const plugin::Host& host,
                    const Controller& its_controller)
        : ObjectOf(described, host), controller(its_controller) {}
    void equip(Component& object, const Example& example) const override {
      static_cast<Coordinator&>(object).equipped(controller.movers(), example.perception);
    }

    const Controller& controller;
  };

  std::shared_ptr<Slot> make_slot(const world::BehaviorUse& use, const plugin::Host& host,
                                  std::vector<base::Problem>& problems);
  /// Behaviours that only act come last.
  void sort_slots();
  const world::BehaviorUse& use_of(const Slot& slot) const {
    return description_->behaviors[slot.place];
  }
  /// Those that the coordinator sees.
  std::span<Member> movers() { return std::span(members_).first(movers_); }
  std::span<const Member> movers() const { return std::span(members_).first(movers_); }
  /// Asks those that only act, and chooses what each actuator is to do.
  void choose_acts();
  static const world::Coordination& inside_of(const world::BehaviorUse& use);
  void list_slots();
  std::vector<Member> copied_members();
  void take_members(std::vector<Member> members);
  void make_coordinator(const plugin::Host& host, std::vector<base::Problem>& problems);

  const Response& run(Member& member) override;
  void rate(Member& member, std::span<const Motion> candidates,
            std::span<double> desirability) override;
  CommandSets command_sets(Member& member) override;
  std::span<const PublishedNumber> published(const Member& member) const override {
    return slot_of(member).declaration->published;
  }
  double published(const Member& member, std::size_t number) const override;

  void give(Member& member, double priority);
  Slot& slot_of(const Member& member) const {
    return *slots_[static_cast<std::size_t>(&member - members_.data())];
  }
  void check(const Slot& slot, const Response& response) const;
  void check_trace();

  const world::Coordination* description_;
  Setting setting_;
  std::vector<std::shared_ptr<Slot>> slots_;  // as members_
  std::vector<Member> members_;
  std::size_t movers_ = 0;                        // the first members: all but those that only act
  std::vector<ChosenAct> acts_;                   // of the last decision
  std::shared_ptr<CoordinatorSlot> coordinator_;  // or none
  std::optional<Perception> now_;  // of the last decision: members may be asked again in a step
  Motion command_;                 // of the last decision
};

}  // namespace elsie::simulation
