// A coordinator that learns and records its robot's properties, for the tests of elsie train.
#include <sstream>

#include <elsie/api/coordinator.h>
#include <elsie/neural/trainable.h>

namespace {

using namespace elsie::neural;

/// It writes what it was equipped with into the weights.
class BodyLearner final : public elsie::Coordinator, public Trainable {
 public:
  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    const elsie::OwnState& self = example.self();
    std::ostringstream body, team, sensors;
    body << self.wheels.radius << ' ' << self.wheels.half_axle << ' ' << self.length_m << ' '
         << self.width_m << ' ' << self.max_speed_m_s << ' ' << self.coverage_m << ' '
         << self.capacity;
    team << example.team().name << ' ' << self.team_index << ' ' << self.is_leader;
    if (example.team().charger) {
      team << " charger " << example.team().charger->x << ' ' << example.team().charger->y;
    }
    for (const auto& beam : example.readings<elsie::RangeReading>()) {
      sensors << beam.sensor() << ' ' << beam.mounting().position.x << ' ';
    }
    about_ = {{"body", body.str()},
              {"team", team.str()},
              {"sensors", sensors.str() + std::string(members[0].name())}};
  }
  elsie::Motion coordinate(std::span<elsie::Member>, const elsie::Perception&) override {
    return {};
  }
  Lesson learn(elsie::Random&, const TrainingWatch&) const override {
    Lesson lesson{parse_training_set("0 0\n", {1, 1}), {"in"}, {"out"}, {},
                  {Network({1, 1}), about_},           {}};
    lesson.assessment = assess(lesson.weights.network, lesson.samples);
    return lesson;
  }
  std::int64_t fixed_seed() const override { return -1; }

  elsie::FilePath weights;

 private:
  std::vector<Remark> about_;
};

}  // namespace

ELSIE_COORDINATOR(BodyLearner, "body_learner", "Learns what its robot is like",
                  elsie::parameter("weights", &BodyLearner::weights, {.meaning = "never read"}));
