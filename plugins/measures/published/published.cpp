// A number that plugins of robots or of the world publish: its mean, its range, its end and its
// curve.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/base/near_name.h>

#include "chosen_robots.h"
#include "published_places.h"

namespace {

/// A curve of a run whose length is not known: means over equal times. When it is full, two of them
/// become one.
class LongCurve {
 public:
  void clear() {
    points_.clear();
    points_.reserve(kMost);
    per_point_ = 1;
    begun_ = {};
  }
  void add(double time_s, double value) {
    ++steps_in_it_;
    if (!std::isnan(value)) {
      begun_.time_s += time_s;
      begun_.sum += value;
      begun_.count += 1.0;
    }
    if (steps_in_it_ < per_point_) return;
    if (points_.size() == kMost) {
      for (std::size_t i = 0; i < kMost / 2; ++i) {
        points_[i] = points_[2 * i];
        points_[i].add(points_[2 * i + 1]);
      }
      points_.resize(kMost / 2);
      per_point_ *= 2;
      if (steps_in_it_ < per_point_) return;
    }
    points_.push_back(begun_);
    begun_ = {};
    steps_in_it_ = 0;
  }
  std::vector<elsie::Curve::Point> points() const {
    std::vector<elsie::Curve::Point> points;
    for (const Bin& bin : points_) {
      if (bin.count > 0.0) points.push_back({bin.time_s / bin.count, bin.sum / bin.count});
    }
    return points;
  }

 private:
  static constexpr std::size_t kMost = 400;
  struct Bin {
    double time_s = 0.0;  // sums
    double sum = 0.0;
    double count = 0.0;
    void add(const Bin& other) {
      time_s += other.time_s;
      sum += other.sum;
      count += other.count;
    }
  };

  std::vector<Bin> points_;
  std::size_t per_point_ = 1;
  std::size_t steps_in_it_ = 0;
  Bin begun_;
};

class Published final : public elsie::Measure, public ChosenRobots {
 public:
  std::string number;

  void equipped(const elsie::Observation& start) override {
    choose(start);
    places_.clear();
    std::vector<std::string> there;
    const auto find_in = [&](std::size_t place) {
      const auto name_of = [&](const elsie::ObservedNumber& each) {
        if (each.name == number) unit_ = each.unit;
        return std::string(each.name);
      };
      find_published(start, place, number, name_of, places_, there);
    };
    for (const std::size_t i : chosen()) find_in(i);
    if (places_.empty() && robot.empty() && team.empty()) find_in(PublishedPlace::kWorld);
    if (places_.empty()) {
      std::sort(there.begin(), there.end());
      throw std::invalid_argument(
          "no plugin of " +
          std::string(robot.empty() && team.empty() ? "the world" : "these robots") +
          " publishes '" + number + "'" +
          (there.empty() ? "; they publish nothing"
                         : elsie::base::near_or_all(number, there, "there are")));
    }
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"mean", unit_, "mean over time and robots of " + number},
            {"least", unit_, "the least " + number + " of a robot"},
            {"greatest", unit_, "the greatest " + number + " of a robot"},
            {"end", unit_, "mean over robots of the last " + number}};
  }
  void reset(elsie::Random&) override {
    sum_ = count_ = 0.0;
    least_ = std::numeric_limits<double>::infinity();
    greatest_ = -least_;
    last_ = std::numeric_limits<double>::quiet_NaN();
    curve_.clear();
  }
  void observe(const elsie::Observation& now) override {
    double sum = 0.0, count = 0.0;
    for (const PublishedPlace& place : places_) {
      const double value = place.value(now);
      if (std::isnan(value)) continue;
      sum += value;
      count += 1.0;
      least_ = std::min(least_, value);
      greatest_ = std::max(greatest_, value);
    }
    last_ = count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
    curve_.add(now.time_s, last_);
    if (now.is_start) return;
    sum_ += sum;
    count_ += count;
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    if (count_ > 0.0) values[0] = sum_ / count_;
    if (least_ <= greatest_) {
      values[1] = least_;
      values[2] = greatest_;
    }
    if (!std::isnan(last_)) values[3] = last_;
  }
  std::vector<elsie::Curve> curves() const override {
    const std::string name = number.substr(number.rfind('.') + 1);
    return {
        {number, "time (s)", unit_.empty() ? name : name + " (" + unit_ + ")", curve_.points()}};
  }

 private:
  std::vector<PublishedPlace> places_;
  std::string unit_;
  double sum_ = 0.0, count_ = 0.0;
  double least_ = 0.0, greatest_ = 0.0, last_ = 0.0;
  LongCurve curve_;
};

}  // namespace

ELSIE_MEASURE(Published, "published",
              "A number that plugins publish: its mean, its range, its end, its curve",
              elsie::parameter("number", &Published::number,
                               {.meaning = "the path of the plugin, then the name: "
                                           "'explore/follow_line.offset', 'respawn.returned'",
                                .required = true}),
              CHOSEN_ROBOTS_PARAMETERS);
