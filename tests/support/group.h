// A group of robots with the same behaviour in an endless plane, without bodies: what the law of a
// behaviour does to a group, and nothing else.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "elsie/messages/heading.h"

#include "shipped.h"
#include "situation.h"

namespace elsie::test {

///   Group group("disperse", {{"distance", 0.5}}, Group::scattered(8, 0.3, 1));
///   group.run(30.0);
///   CHECK(group.least_distance() >= 0.5);
class Group {
 public:
  /// So many robots with uniform places in a disc around the origin and uniform headings.
  static std::vector<Pose> scattered(int count, double radius_m, std::uint64_t seed) {
    Random random(seed);
    std::vector<Pose> poses;
    for (int i = 0; i < count; ++i) {
      const double away = radius_m * std::sqrt(random.uniform());
      const double direction = random.uniform(-3.14159, 3.14159);
      poses.push_back({away * std::cos(direction), away * std::sin(direction),
                       random.uniform(-3.14159, 3.14159)});
    }
    return poses;
  }

  /// With `from` = "messages", all hear each other within the reach; else all are of one team.
  Group(const std::string& plugin, const Parameters& parameters, std::vector<Pose> poses,
        double reach_m = 10.0)
      : poses_(std::move(poses)), reach_m_(reach_m) {
    const auto from = parameters.find("from");
    hears_ = from != parameters.end() && from->second == ParameterValue(std::string("messages"));
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      behaviors_.push_back(test::make<Behavior>(PluginKind::behavior, plugin, parameters));
      Random random(i);
      behaviors_.back()->reset(random);
    }
  }

  void run(double seconds, double period_s = 0.1) {
    const auto steps = static_cast<int>(seconds / period_s + 0.5);
    std::vector<Motion> commands(poses_.size());
    for (int step = 0; step < steps; ++step, time_s_ += period_s) {
      for (std::size_t i = 0; i < poses_.size(); ++i) commands[i] = ask(i, period_s);
      for (std::size_t i = 0; i < poses_.size(); ++i) move(poses_[i], commands[i], period_s);
    }
  }

  const std::vector<Pose>& poses() const { return poses_; }
  /// The least distance between two of them, m.
  double least_distance() const {
    double least = 1e9;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) least = std::min(least, distance(poses_[i], poses_[k]));
    }
    return least;
  }
  /// The mean distance between two of them, m.
  double mean_distance() const {
    double sum = 0.0;
    for (const Pose& a : poses_) {
      for (const Pose& b : poses_) sum += distance(a, b);
    }
    const auto count = static_cast<double>(poses_.size());
    return sum / (count * (count - 1.0));
  }
  /// The largest distance of one of them from the middle of all, m.
  double radius() const {
    Pose middle;
    for (const Pose& pose : poses_) {
      middle.x += pose.x / static_cast<double>(poses_.size());
      middle.y += pose.y / static_cast<double>(poses_.size());
    }
    double largest = 0.0;
    for (const Pose& pose : poses_) largest = std::max(largest, distance(pose, middle));
    return largest;
  }
  /// The length of the mean heading vector: 1 when all look the same way.
  double order() const {
    double x = 0.0, y = 0.0;
    for (const Pose& pose : poses_) {
      x += std::cos(pose.heading_rad);
      y += std::sin(pose.heading_rad);
    }
    return std::hypot(x, y) / static_cast<double>(poses_.size());
  }

 private:
  Motion ask(std::size_t i, double period_s) {
    const Pose& own = poses_[i];
    Situation now;
    now.at(own.x, own.y, degrees(own.heading_rad)).time(time_s_).period(period_s);
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const Pose& other = poses_[k];
      if (k == i || distance(own, other) > reach_m_) continue;
      if (hears_) {
        now.hear(HeadingMessage{static_cast<float>(other.heading_rad)}, "", distance(own, other),
                 degrees(bearing(own, other.x, other.y)));
      } else {
        now.mate("r" + std::to_string(k), other.x, other.y, false, degrees(other.heading_rad));
      }
    }
    return behaviors_[i]->respond(now.perception()).command;
  }

  /// Turns at most by 6 rad/s, as a robot can: along the arc.
  static void move(Pose& pose, const Motion& command, double period_s) {
    const double turn = std::clamp(command.turn, -6.0, 6.0) * period_s;
    const double way = command.forward * period_s, along = pose.heading_rad + 0.5 * turn;
    pose.x += way * std::cos(along);
    pose.y += way * std::sin(along);
    pose.heading_rad = wrap_angle(pose.heading_rad + turn);
  }

  std::vector<plugin::Object<Behavior>> behaviors_;
  std::vector<Pose> poses_;
  double reach_m_;
  double time_s_ = 0.0;
  bool hears_ = false;
};

}  // namespace elsie::test
