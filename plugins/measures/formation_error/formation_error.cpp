// The distance of a formation's members from their places (Balch and Arkin 1998).
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <elsie/api/measure.h>

namespace {

/// A robot and its place in the leader's frame.
struct Place {
  std::string robot;
  double x = 0.0;
  double y = 0.0;
};

class FormationError final : public elsie::Measure {
 public:
  std::string leader;
  double from_s = 0.0;
  std::vector<Place> members;

  void equipped(const elsie::Observation& start) override {
    const auto place_of = [&](const std::string& id) {
      return static_cast<std::size_t>(&start.robot(id) - start.robots.data());
    };
    leader_ = place_of(leader);
    robots_.clear();
    for (const Place& member : members) {
      const std::size_t robot = place_of(member.robot);
      if (robot == leader_ || std::find(robots_.begin(), robots_.end(), robot) != robots_.end()) {
        throw std::invalid_argument("the robot '" + member.robot + "' is " +
                                    (robot == leader_ ? "the leader" : "a <member> already") +
                                    "; expected another one");
      }
      robots_.push_back(robot);
    }
    if (robots_.empty()) {
      throw std::invalid_argument(
          "it has no members; give each a place in the leader's frame, as in "
          "<member robot=\"f1\" x=\"-0.4\" y=\"0.4\"/>");
    }
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"mean_m", "m", "distance from the places, mean over members and time"},
            {"largest_m", "m", "of one member at one instant"},
            {"end_m", "m", "mean over members at the end"}};
  }
  void reset(elsie::Random&) override {
    sum_ = time_s_ = largest_ = 0.0;
    last_.reset();
  }
  void observe(const elsie::Observation& now) override {
    if (now.is_start || now.time_s <= from_s) {
      return;
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const elsie::Vector2 place =
          elsie::point_of(now.robots[leader_].pose, {members[i].x, members[i].y});
      const elsie::Pose& pose = now.robots[robots_[i]].pose;
      const double error = std::hypot(pose.x - place.x, pose.y - place.y);
      sum += error;
      largest_ = std::max(largest_, error);
    }
    last_ = sum / static_cast<double>(robots_.size());
    sum_ += *last_ * now.step_s;
    time_s_ += now.step_s;
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    if (last_) {
      values[0] = sum_ / time_s_;
      values[1] = largest_;
      values[2] = last_;
    }
  }

 private:
  std::size_t leader_ = 0;
  std::vector<std::size_t> robots_;  // of the members
  double sum_ = 0.0;                 // m s
  double time_s_ = 0.0;
  double largest_ = 0.0;
  std::optional<double> last_;
};

}  // namespace

ELSIE_MEASURE(
    FormationError, "formation_error", "How far the members of a formation are from their places",
    elsie::parameter("leader", &FormationError::leader,
                     {.meaning = "the robot that the places are relative to", .required = true}),
    elsie::parameter("from_s", &FormationError::from_s,
                     {.unit = "s", .min = 0, .meaning = "time to fall in, which is left out"}),
    elsie::elements(
        &FormationError::members,
        elsie::element<Place>(
            "member", "A robot and its place in the leader's frame",
            elsie::parameter("robot", &Place::robot,
                             {.meaning = "id of the robot", .required = true}),
            elsie::parameter("x", &Place::x, {.unit = "m", .meaning = "ahead of the leader"}),
            elsie::parameter("y", &Place::y, {.unit = "m", .meaning = "to its left"}))));
