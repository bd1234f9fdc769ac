// Coordinators, sensors, measures and drives with one fault each, for the checker to find.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "elsie/api/actuator.h"
#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/drive.h"
#include "elsie/api/measure.h"
#include "elsie/api/sensor.h"

using elsie::Motion;
using elsie::Perception;

namespace {

class TooMuch final : public elsie::Coordinator {
 public:
  Motion coordinate(std::span<elsie::Member> members, const Perception&) override {
    for (elsie::Member& member : members) {
      member.respond();
      member.trace.share = 1.0;
    }
    return {};
  }
};
ELSIE_COORDINATOR(TooMuch, "too_much", "Gives away more than there is");

class Overreaches final : public elsie::Coordinator {
 public:
  Motion coordinate(std::span<elsie::Member> members, const Perception&) override {
    for (elsie::Member& member : members) {
      member.respond();
    }
    return {};
  }
  std::size_t resolve(std::string_view, std::span<const elsie::ActuatorWish> wishes) override {
    return wishes.size() + 1;
  }
};
ELSIE_COORDINATOR(Overreaches, "overreaches", "Gives an actuator what nobody wished");

class Divides final : public elsie::Coordinator {
 public:
  Motion coordinate(std::span<elsie::Member> members, const Perception&) override {
    Motion sum;
    double activation = 0.0;
    for (elsie::Member& member : members) {
      sum += member.respond().command;
      activation += member.respond().activation;
    }
    return sum / activation;
  }
};
ELSIE_COORDINATOR(Divides, "divides", "Divides by nothing where nobody is active");

class KeepsLastRun final : public elsie::Coordinator {
 public:
  Motion coordinate(std::span<elsie::Member> members, const Perception&) override {
    for (elsie::Member& member : members) {
      last_ += member.respond().command;
    }
    return last_;
  }

 private:
  Motion last_;
};
ELSIE_COORDINATOR(KeepsLastRun, "remembers", "Remembers the last run");

struct Brightness {
  static constexpr const char* kind = "brightness";
  double value = 0.0;
  bool odd = false;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("value", value);
    if (odd) {
      visitor("odd", odd);
    }
  }
};
class Infinite final : public elsie::SensorOf<Brightness> {
 public:
  Brightness sense(const elsie::SensorContext& now) override {
    std::vector<elsie::NearThing> near;
    now.world->things_within(2.0, near);
    return {near.empty() ? std::numeric_limits<double>::infinity() : near[0].distance_m, false};
  }
};
ELSIE_SENSOR(Infinite, "infinite", "Reads infinity where there is nothing");
class Varying final : public elsie::SensorOf<Brightness> {
 public:
  void reset(elsie::Random&) override { odd_ = false; }
  Brightness sense(const elsie::SensorContext&) override {
    odd_ = !odd_;
    return {1.0, odd_};
  }

 private:
  bool odd_ = false;
};
ELSIE_SENSOR(Varying, "varying", "Lists other numbers now and then");
class SharedNoise final : public elsie::SensorOf<Brightness> {
 public:
  Brightness sense(const elsie::SensorContext&) override {
    static elsie::Random random(1);
    return {random.uniform(), false};
  }
};
ELSIE_SENSOR(SharedNoise, "shared_noise", "Has one noise for all");

/// Counts the instants; its variants have one fault each.
class Counting : public elsie::Measure {
 public:
  std::vector<elsie::Quantity> quantities() const override { return {{"", "", "instants"}}; }
  void reset(elsie::Random&) override { count_ = 0; }
  void observe(const elsie::Observation&) override { ++count_; }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = count_;
  }

 protected:
  int count_ = 0;
};
class CountsOn final : public Counting {
 public:
  void reset(elsie::Random&) override {}
};
ELSIE_MEASURE(CountsOn, "counts_on", "Counts on in the next run");
class KeepsAll final : public Counting {
 public:
  void reset(elsie::Random& random) override {
    Counting::reset(random);
    times_.clear();
  }
  void observe(const elsie::Observation& now) override {
    times_.push_back(now.time_s);
    count_ = static_cast<int>(times_.size());
  }

 private:
  std::vector<double> times_;
};
ELSIE_MEASURE(KeepsAll, "keeps_all", "Keeps a list of all that it was shown");
class CountsCalls final : public Counting {
 public:
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = ++calls_;
  }

 private:
  mutable int calls_ = 0;
};
ELSIE_MEASURE(CountsCalls, "counts_calls", "Counts how often it is asked");
class Dividing final : public Counting {
 public:
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = 1.0 / std::max(0.0, 6.0 - count_);
  }
};
ELSIE_MEASURE(Dividing, "dividing", "Divides by nothing once it has seen enough");
class Twins final : public Counting {
 public:
  std::vector<elsie::Quantity> quantities() const override {
    return {{"one", "", "instants"}, {"one", "", "instants"}};
  }
};
ELSIE_MEASURE(Twins, "twins", "Has two values of one name");
class Choosy final : public Counting {
 public:
  void equipped(const elsie::Observation& start) override { start.robot("nobody"); }
};
ELSIE_MEASURE(Choosy, "choosy", "Watches a robot that is not there");
class Lasting final : public Counting {};
ELSIE_MEASURE(Lasting, "lasting", "Counts instants, and nothing is wrong with it");

class Wheeled : public elsie::Drive {
 public:
  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    pair_ = wheels(chassis);
    for (const double side : {1.0, -1.0}) {
      plan.parts.push_back({side > 0 ? "left_wheel" : "right_wheel",
                            elsie::PartRole::wheel,
                            elsie::Shape::wheel(chassis.wheel_radius, chassis.wheel_width),
                            {.origin = {0.0, side * chassis.half_axle, height(chassis)}},
                            chassis.wheel_mass,
                            0,
                            elsie::WheelJoint{.torque = chassis.wheel_torque}});
    }
  }
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    elsie::WheelRates rates = pair_.wheel_rates(asked);
    const double largest = std::max(std::abs(rates.left), std::abs(rates.right));
    const double most = now.max_speed / pair_.radius;
    if (largest > most) rates = most / largest * rates;
    joints[0] = {rates.left};
    joints[1] = {rates.right};
    return pair_.motion(rates);
  }
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override {
    return pair_.motion({joints[0].rate_rad_s, joints[1].rate_rad_s});
  }

 protected:
  virtual double height(const elsie::Chassis& chassis) const { return chassis.wheel_radius; }

  elsie::WheelPair pair_;
};
class SoundDrive final : public Wheeled {};
ELSIE_DRIVE(SoundDrive, "sound", "Two wheels, and nothing is wrong with them");
class Deep final : public Wheeled {
  double height(const elsie::Chassis& chassis) const override { return 0.5 * chassis.wheel_radius; }
};
ELSIE_DRIVE(Deep, "deep", "Has wheels that reach into the floor");
class Floating final : public Wheeled {
  double height(const elsie::Chassis& chassis) const override {
    return 1.01 * chassis.wheel_radius;
  }
};
ELSIE_DRIVE(Floating, "floating", "Has wheels that do not reach the floor");
class Racing final : public Wheeled {
 public:
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState&,
                        std::span<elsie::JointSetting> joints) override {
    const elsie::WheelRates rates = pair_.wheel_rates(asked);
    joints[0] = {rates.left};
    joints[1] = {rates.right};
    return pair_.motion(rates);
  }
};
ELSIE_DRIVE(Racing, "racing", "Knows no maximum speed");
class Boasting final : public Wheeled {
 public:
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    Wheeled::command(asked, now, joints);
    return asked;
  }
};
ELSIE_DRIVE(Boasting, "boasting", "Says that it does what it was asked for");
class Creeping final : public Wheeled {
 public:
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    return Wheeled::command(0.5 * asked, now, joints);
  }
};
ELSIE_DRIVE(Creeping, "creeping", "Does half of what it can");

struct RadioReading {
  static constexpr const char* kind = "radio";
  double heard = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("heard", heard);
  }
};

std::map<std::string, double, std::less<>> message_board;

/// Reads what the behaviours of others have left in a static.
class Radio final : public elsie::SensorOf<RadioReading> {
 public:
  RadioReading sense(const elsie::SensorContext& now) override {
    near_.clear();
    now.world->things_within(1.0, near_);
    RadioReading reading;
    for (const elsie::NearThing& near : near_) {
      reading.heard += message_board.contains(near.thing.id) ? 1.0 : 0.0;
    }
    return reading;
  }
  void reset(elsie::Random&) override { message_board.clear(); }

 private:
  std::vector<elsie::NearThing> near_;
};
ELSIE_SENSOR(Radio, "radio", "Hears what others say", elsie::one_thread());

/// It answers soundly, and draws to infinity.
class Scrawling final : public elsie::Behavior {
 public:
  elsie::Response respond(const Perception& /*now*/) override { return Motion{0.1, 0.0, 0.0}; }
  void sketch(elsie::Sketch& sketch) const override {
    sketch.line(elsie::SketchRole::range, {}, {std::numeric_limits<double>::infinity(), 0.0, 0.0});
  }
};
ELSIE_BEHAVIOR(Scrawling, "scrawling", "Draws to infinity");

/// It answers soundly: the fault is that of the sensor, which lets it in.
class Gossip final : public elsie::Behavior {
 public:
  elsie::Response respond(const Perception& now) override {
    message_board[std::string(now.self().id)] = 1.0;
    return Motion{0.1, 0.0, 0.2};
  }
};
ELSIE_BEHAVIOR(Gossip, "gossip", "Talks to others", elsie::one_thread());

struct HookCommand {
  static constexpr const char* kind = "hook";
  bool out = false;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("out", out);
  }
};
class Boundless final : public elsie::ActuatorOf<HookCommand> {
 public:
  void act(const HookCommand& command, const elsie::ActuatorContext& now) override {
    if (command.out) now.robot->hold(std::numeric_limits<double>::infinity());
  }
};
ELSIE_ACTUATOR(Boundless, "boundless", "Holds what is anywhere");

class Loud final : public elsie::ActuatorOf<elsie::SayCommand> {
 public:
  void act(const elsie::SayCommand& said, const elsie::ActuatorContext& now) override {
    if (said.message) now.robot->transmit(said.message, said.to, {.range_m = std::nan("")});
  }
};
ELSIE_ACTUATOR(Loud, "loud", "Sends its messages nowhere", elsie::hears_messages());

/// Its range shrinks with each message, also over reset().
class Fading final : public elsie::ActuatorOf<elsie::SayCommand> {
 public:
  void act(const elsie::SayCommand& said, const elsie::ActuatorContext& now) override {
    if (said.message) now.robot->transmit(said.message, said.to, {.range_m = range_m_ *= 0.9});
  }

 private:
  double range_m_ = 1.0;
};
ELSIE_ACTUATOR(Fading, "fading", "Forgets nothing", elsie::hears_messages());

}  // namespace
