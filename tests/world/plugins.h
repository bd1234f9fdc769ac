// Plugins made up for the tests, so that these depend on none that is shipped.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/host.h"

namespace elsie::test {

class Beam final : public SensorOf<RangeReading> {
 public:
  double max_range = 1.0;
  RangeReading sense(const SensorContext&) override { return {}; }
};

struct OldRangeReading {
  static constexpr const char* kind = "range";
  double distance_m = 0.0;
};

class OldBeam final : public SensorOf<OldRangeReading> {
 public:
  OldRangeReading sense(const SensorContext&) override { return {}; }
};

class Bumper final : public SensorOf<ProximityReading> {
 public:
  ProximityReading sense(const SensorContext&) override { return {}; }
};

class Avoid final : public Behavior {
 public:
  FilePath model{"fuzzy_models/avoid.fcl"};
  double gain = 1.0;
  Response respond(const Perception&) override { return {}; }
};

class Roam final : public Behavior {
 public:
  double speed = 10.0;
  int patience = 3;
  bool shy = false;
  std::string mood = "calm";
  std::string motto = "";
  std::vector<double> weights{1, 2};
  FilePath song{""};
  Response respond(const Perception&) override { return {}; }
  void configured() override {
    if (shy && mood == "bold") {
      throw std::invalid_argument("shy and bold do not go together");
    }
  }
};

// Its parameter `priority` is an attribute of every behaviour.
class Clash final : public Behavior {
 public:
  double priority = 1.0;
  Response respond(const Perception&) override { return {}; }
};

class Pick final : public Coordinator {
 public:
  MotorCommand coordinate(std::span<Member>, const Perception&) override { return {}; }
};

class Sum final : public Coordinator {
 public:
  bool weighted = false;
  MotorCommand coordinate(std::span<Member>, const Perception&) override { return {}; }
};

inline plugin::Host make_host() {
  plugin::Host host;
  host.add(declare<Beam>(
      PluginKind::sensor, "beam", "Measures the distance along a ray", produces<RangeReading>(),
      parameter(
          "max_range", &Beam::max_range,
          {.unit = "m", .above = 0, .max = 100, .meaning = "reads this if nothing is near"})));
  host.add(declare<OldBeam>(PluginKind::sensor, "old_beam", "A beam of another version",
                            produces<OldRangeReading>()));
  host.add(declare<Bumper>(PluginKind::sensor, "bumper", "Feels whether anything is near",
                           produces<ProximityReading>()));
  host.add(declare<Avoid>(
      PluginKind::behavior, "avoid", "Turns away from what is near", needs<RangeReading>(),
      parameter("model", &Avoid::model, {.meaning = "its fuzzy model"}),
      parameter("gain", &Avoid::gain, {.min = 0, .max = 10, .meaning = "how strongly"})));
  host.add(declare<Roam>(
      PluginKind::behavior, "roam", "Drives about", raises("bored", "nothing has happened"),
      parameter("speed", &Roam::speed,
                {.unit = "rad/s", .min = 0, .max = 50, .meaning = "mean wheel rate"}),
      parameter("patience", &Roam::patience, {.min = 1, .meaning = "turns before it is bored"}),
      parameter("shy", &Roam::shy, {.meaning = "whether it keeps away from others"}),
      parameter("mood", &Roam::mood, {.choices = {"calm", "bold"}, .meaning = "how it drives"}),
      parameter("motto", &Roam::motto, {.meaning = "what it says of itself"}),
      parameter("weights", &Roam::weights, {.min = -5, .max = 5, .meaning = "of its wheels"}),
      parameter("song", &Roam::song, {.meaning = "what it hums, if anything"})));
  host.add(declare<Clash>(PluginKind::behavior, "clash", "Declares what it may not",
                          parameter("priority", &Clash::priority, {.meaning = "no good name"})));
  host.add(declare<Pick>(PluginKind::coordinator, "pick", "Runs the first behaviour"));
  host.add(declare<Sum>(PluginKind::coordinator, "sum", "Adds the commands",
                        parameter("weighted", &Sum::weighted, {.meaning = "by priority"})));
  return host;
}

}  // namespace elsie::test
