#include "elsie/testing/rule.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "made.h"

namespace elsie::testing {
namespace {

class Notes final : public WorldChanges {
 public:
  Notes(const Rule& rule, Ruling& answer) : rule_(rule), answer_(answer) {}

  void edit(std::string path, std::string value) override {
    answer_.edits.push_back(path + "=" + value);
  }
  void place(std::string_view what, const Pose& pose) override {
    const std::string path = std::string(what) + "/@";
    set(path + "x", pose.x);
    set(path + "y", pose.y);
    set(path + "heading_deg", degrees(wrap_angle(pose.heading_rad)));
  }
  bool has_room(std::string_view what, const Pose& pose) override {
    return !rule_.has_room || rule_.has_room(what, pose);
  }
  void raise(const Event& event, std::string_view robot) override {
    const auto& declared = rule_.declaration().events;
    if (std::none_of(declared.begin(), declared.end(),
                     [&](const EventDeclaration& each) { return each.name == event.name; })) {
      throw std::invalid_argument(
          "it raised the event '" + event.name +
          "', which its declaration does not name; add elsie::raises() to it");
    }
    answer_.events.push_back(event.name + (robot.empty() ? "" : " of " + std::string(robot)));
  }
  void succeed(std::string reason) override { end(RunEnd::Outcome::success, std::move(reason)); }
  void fail(std::string reason) override { end(RunEnd::Outcome::failure, std::move(reason)); }

 private:
  /// As in a run, the first counts, and a failure more than a success.
  void end(RunEnd::Outcome outcome, std::string reason) {
    using enum RunEnd::Outcome;
    if (answer_.outcome == running || (answer_.outcome == success && outcome == failure)) {
      answer_.outcome = outcome;
      answer_.reason = std::move(reason);
    }
  }

  const Rule& rule_;
  Ruling& answer_;
};

}  // namespace

Rule::Rule(const std::string& name, const Settings& settings, const Elements& elements)
    : Rule(Plugins::found(), name, settings, elements) {}

Rule::Rule(const Plugins& plugins, const std::string& name, const Settings& settings,
           const Elements& elements)
    : plugins_(plugins),
      declaration_(&plugins_.declaration(PluginKind::rule, name)),
      object_(make<elsie::Rule>(plugins_, *declaration_, settings, elements, [](elsie::Rule&) {})) {
}

const Ruling& Rule::apply(const Scene& now) {
  if (!equipped_) equip(now);
  if (!reset_) reset();
  answer_ = {};
  Notes notes(*this, answer_);
  object_->apply(now.observation(), notes);
  return answer_;
}

void Rule::reset(std::uint64_t seed) {
  random_ = Random(seed);
  object_->reset(random_);
  reset_ = true;
}

void Rule::equip(const Scene& start) {
  object_->equipped(start.observation());
  equipped_ = true;
}

}  // namespace elsie::testing
