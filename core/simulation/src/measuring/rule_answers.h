// What rules answer.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/rule.h"
#include "elsie/physics/engine.h"
#include "elsie/simulation/edit.h"
#include "elsie/world/description.h"

#include "edits/room.h"
#include "plugins/plugin_object.h"
#include "robot/robot_surroundings.h"
#include "step/goals.h"

namespace elsie::simulation {

/// The edits of one rule, to be made together.
struct RuleEdits {
  std::string rule;  // its id
  std::string from;  // for messages: "pasture.xml:12: the rule 'food'"
  std::vector<Edit> edits;
};

/// The answers of all rules to one observation.
class RuleAnswers final : public WorldChanges {
 public:
  RuleAnswers(const world::World& world, const physics::Engine& engine, Robots robots)
      : world_(world), engine_(engine), robots_(robots) {}

  /// The answers of another rule follow.
  void begin(const PluginObject& rule) { rule_ = &rule; }

  void edit(std::string path, std::string value) override;
  void place(std::string_view what, const Pose& pose) override;
  bool has_room(std::string_view what, const Pose& pose) override {
    const auto body = find(what);
    return body && room().has_room(*body, pose);
  }
  void raise(const Event& event, std::string_view robot) override;
  void succeed(std::string reason) override { end(Outcome::success, reason); }
  void fail(std::string reason) override { end(Outcome::failure, reason); }

  /// In the order of the rules.
  std::vector<RuleEdits>& edits() { return edits_; }
  bool has_raised() const { return has_raised_; }
  /// Ends a run that the goals have not ended before, or fails one that has just succeeded.
  void decide(Judgement& judgement) const;

 private:
  void end(Outcome outcome, const std::string& reason);
  std::optional<physics::Body> find(std::string_view what) const;
  Room& room() { return room_ ? *room_ : room_.emplace(world_, engine_); }

  const world::World& world_;
  const physics::Engine& engine_;
  Robots robots_;
  const PluginObject* rule_ = nullptr;
  std::optional<Room> room_;  // with what was placed; made when it is needed
  std::vector<RuleEdits> edits_;
  bool has_raised_ = false;
  std::optional<Judgement> verdict_;
};

}  // namespace elsie::simulation
