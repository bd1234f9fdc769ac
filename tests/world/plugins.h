// Plugins made up for the tests, so that these depend on none that is shipped.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/api/coordinator.h"
#include "elsie/api/drive.h"
#include "elsie/api/measure.h"
#include "elsie/api/sensor.h"
#include "elsie/plugin/host.h"

namespace elsie::test {

class Beam final : public SensorOf<RangeReading> {
 public:
  double max_range = 1.0;
  RangeReading sense(const SensorContext&) override { return {}; }
};

// One kind of reading by two versions of its header, of the same size.
struct EchoReading {
  static constexpr const char* kind = "echo";
  double distance_m = 0.0;
  double loudness = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("distance_m", distance_m);
    visitor("loudness", loudness);
  }
};
struct OldEchoReading {
  static constexpr const char* kind = "echo";
  double loudness = 0.0;
  double distance_m = 0.0;
  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("distance_m", distance_m);
    visitor("loudness", loudness);
  }
};

class OldSonar final : public SensorOf<OldEchoReading> {
 public:
  OldEchoReading sense(const SensorContext&) override { return {}; }
};

class Listen final : public Behavior {
 public:
  Response respond(const Perception&) override { return {}; }
};

class Bumper final : public SensorOf<ProximityReading> {
 public:
  ProximityReading sense(const SensorContext&) override { return {}; }
};

/// Four wheels, those of a side `gauge` apart.
class Cart final : public Drive {
 public:
  double gauge = 0.0;    // m
  double deeper = 0.0;   // m, below where wheels belong
  bool steered = false;  // by wheels without a limit
  std::string flaw;      // another one: "twins", "bare" or "no_number"

  void build(const Chassis& chassis, BodyPlan& plan) override {
    if (gauge > 5.0) throw std::invalid_argument("that is no cart but a bridge");
    for (int i = 0; i < (flaw == "bare" ? 0 : 4); ++i) {
      WheelJoint joint{.torque = chassis.wheel_torque, .steered = steered};
      if (steered) joint.max_steer_rad = 0.0;
      if (flaw == "no_number") joint.torque = std::numeric_limits<double>::quiet_NaN();
      plan.parts.push_back({"wheel" + std::to_string(flaw == "twins" ? 0 : i),
                            PartRole::wheel,
                            Shape::wheel(chassis.wheel_radius, chassis.wheel_width),
                            {.origin = {i < 2 ? 0.1 : -0.1, (i % 2 ? -0.5 : 0.5) * gauge,
                                        chassis.wheel_radius - deeper}},
                            chassis.wheel_mass,
                            0,
                            joint});
    }
  }
  Motion command(const Motion&, const DriveState&, std::span<JointSetting>) override { return {}; }
  Motion odometry(std::span<const JointSetting>) const override { return {}; }
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
  void reset(Random&) override {
    if (motto == "tomorrow") throw std::runtime_error("it does not begin today");
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
  Motion coordinate(std::span<Member>, const Perception&) override { return {}; }
};

class Sum final : public Coordinator {
 public:
  bool weighted = false;
  Motion coordinate(std::span<Member>, const Perception&) override { return {}; }
};

// Elements of two lists, one of them with defaults.
struct Threshold {
  double low = 0.0;
  double high = 1.0;
  std::string colour = "red";
  friend bool operator==(const Threshold&, const Threshold&) = default;
};
struct Mask {
  FilePath picture{"songs/one.txt"};
  int margin = 0;
};

class Eye final : public SensorOf<ProximityReading> {
 public:
  bool sharp = false;
  std::vector<Threshold> thresholds{{0.2, 0.4, "red"}, {0.0, 0.9, "blue"}};
  std::vector<Mask> masks;
  ProximityReading sense(const SensorContext&) override { return {}; }
  void configured() override {
    for (const Threshold& threshold : thresholds) {
      if (threshold.low > threshold.high) {
        throw std::invalid_argument("a threshold's low is above its high");
      }
    }
  }
};

// Elements of two kinds in one list, with a parameter that must be given.
struct Suppress {
  std::string by, of;
  double hold_s = 0.5;
};
struct Inhibit {
  std::string by, of;
};

class Layers final : public Coordinator {
 public:
  std::vector<std::variant<Suppress, Inhibit>> links;
  Motion coordinate(std::span<Member>, const Perception&) override { return {}; }
};

class Seek final : public Behavior {
 public:
  double x = 0.0;
  FilePath map{""};
  Response respond(const Perception&) override { return {}; }
};

// Holds others, and has rules of its own beside them.
struct Rule {
  std::string of;
  double weight = 1.0;
};

class Blend final : public Behavior {
 public:
  elsie::Coordination* inside = nullptr;
  double haste = 1.0;
  std::vector<Rule> rules;
  Response respond(const Perception& now) override { return inside->respond(now); }
  void configured() override {
    // What it is given must be usable already.
    std::vector<Motion> candidates(1);
    std::vector<double> desirability(1, 0.5);
    inside->rate(candidates, desirability);
    for (const Rule& rule : rules) {
      if (rule.of == "nobody") {
        throw std::invalid_argument("a rule is about nobody");
      }
    }
  }
};

// Watches, and has gates beside it.
struct Gate {
  double x = 0.0;
  double y = 0.0;
};

class Way final : public Measure {
 public:
  std::string robot;
  double from_s = 0.0;
  double to_s = 1e9;
  std::vector<Gate> gates;
  std::vector<Quantity> quantities() const override { return {{"", "m", "how far"}}; }
  void observe(const Observation&) override {}
  void report(const RunEnd&, std::span<std::optional<double>>) const override {}
  void configured() override {
    if (from_s > to_s) {
      throw std::invalid_argument("it begins after it ends");
    }
  }
};

// Phases that hold phases, pauses, and ways out of them.
struct Leave {
  std::string to;
  double after = 1.0;
  std::string song{};
};
struct Phase {
  std::string kind;
  std::string name;
  std::vector<Leave> leaves;
  std::vector<Phase> phases;
};

class Plan final : public Coordinator {
 public:
  std::vector<Phase> phases{{"phase", "first", {{"second"}}, {{"pause", "inner", {}, {}}}}};
  Motion coordinate(std::span<Member>, const Perception&) override { return {}; }
};

class Hits final : public Measure {
 public:
  std::vector<Quantity> quantities() const override { return {{"", "", "how many"}}; }
  void observe(const Observation&) override {}
  void report(const RunEnd&, std::span<std::optional<double>>) const override {}
};

inline plugin::Host make_host() {
  plugin::Host host;
  host.add(declare<Beam>(
      PluginKind::sensor, "beam", "Measures the distance along a ray", produces<RangeReading>(),
      parameter(
          "max_range", &Beam::max_range,
          {.unit = "m", .above = 0, .max = 100, .meaning = "reads this if nothing is near"})));
  host.add(declare<OldSonar>(PluginKind::sensor, "old_sonar", "A sonar of another version",
                             produces<OldEchoReading>()));
  host.add(declare<Listen>(PluginKind::behavior, "listen", "Drives by what it hears",
                           needs<EchoReading>()));
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
  host.add(
      declare<Seek>(PluginKind::behavior, "seek", "Drives to a place",
                    parameter("x", &Seek::x, {.unit = "m", .meaning = "east", .required = true}),
                    parameter("map", &Seek::map, {.meaning = "of the land", .required = true})));
  host.add(declare<Blend>(
      PluginKind::behavior, "blend", "Blends others", holds_behaviors(&Blend::inside),
      parameter("haste", &Blend::haste, {.min = 0, .max = 2, .meaning = "how fast"}),
      elements(
          &Blend::rules,
          element<Rule>("rule", "How much one of them counts",
                        parameter("of", &Rule::of, {.meaning = "which one", .required = true}),
                        parameter("weight", &Rule::weight, {.min = 0, .meaning = "how much"})))));
  host.add(declare<Eye>(
      PluginKind::sensor, "eye", "Sees colours", produces<ProximityReading>(),
      parameter("sharp", &Eye::sharp, {.meaning = "whether it looks twice"}),
      elements(
          &Eye::thresholds,
          element<Threshold>("threshold", "A band of brightness",
                             parameter("low", &Threshold::low,
                                       {.unit = "cd", .min = 0, .max = 1, .meaning = "from here"}),
                             parameter("high", &Threshold::high,
                                       {.unit = "cd", .min = 0, .max = 1, .meaning = "to here"}),
                             parameter("colour", &Threshold::colour,
                                       {.choices = {"red", "blue"}, .meaning = "of what"}))),
      elements(
          &Eye::masks,
          element<Mask>("mask", "What it does not look at",
                        parameter("picture", &Mask::picture, {.meaning = "white where it looks"}),
                        parameter("margin", &Mask::margin, {.min = 0, .meaning = "in pixels"})))));
  host.add(declare<Layers>(
      PluginKind::coordinator, "layers", "Links between behaviours",
      elements(&Layers::links,
               element<Suppress>(
                   "suppress", "One behaviour's command replaces another's",
                   parameter("by", &Suppress::by, {.meaning = "whose stands", .required = true}),
                   parameter("of", &Suppress::of, {.meaning = "whose goes", .required = true}),
                   parameter("hold_s", &Suppress::hold_s,
                             {.unit = "s", .min = 0, .max = 60, .meaning = "goes on for"})),
               element<Inhibit>(
                   "inhibit", "One behaviour's command is taken away",
                   parameter("by", &Inhibit::by, {.meaning = "by this one", .required = true}),
                   parameter("of", &Inhibit::of, {.meaning = "of this one", .required = true})))));
  host.add(declare<Way>(
      PluginKind::measure, "way", "How far robots went",
      parameter("robot", &Way::robot, {.meaning = "which one"}),
      parameter("from_s", &Way::from_s, {.unit = "s", .min = 0, .meaning = "since when"}),
      parameter("to_s", &Way::to_s, {.unit = "s", .min = 0, .meaning = "until when"}),
      elements(&Way::gates,
               element<Gate>("gate", "A place on the way",
                             parameter("x", &Gate::x, {.unit = "m", .meaning = "east"}),
                             parameter("y", &Gate::y, {.unit = "m", .meaning = "north"})))));
  host.add(declare<Cart>(
      PluginKind::drive, "cart", "Four wheels",
      parameter("gauge", &Cart::gauge, {.unit = "m", .min = 0, .meaning = "between its sides"}),
      parameter("deeper", &Cart::deeper, {.unit = "m", .meaning = "below where wheels belong"}),
      parameter("steered", &Cart::steered, {.meaning = "without a limit"}),
      parameter("flaw", &Cart::flaw, {.meaning = "that it has"})));
  host.add(declare<Plan>(
      PluginKind::coordinator, "plan", "Phases",
      elements(
          &Plan::phases,
          element<Phase>(
              "phase", "A time with ways out of it", element_name(&Phase::kind),
              nests(&Phase::phases),
              parameter("name", &Phase::name, {.meaning = "what it is called", .required = true}),
              elements(
                  &Phase::leaves,
                  element<Leave>(
                      "leave", "A way out", parameter("to", &Leave::to, {.meaning = "where to"}),
                      parameter("after", &Leave::after, {.unit = "s", .min = 0, .meaning = "when"}),
                      parameter("event", &Leave::song, {.meaning = "or then"})))),
          element<Phase>("pause", "A time without any", element_name(&Phase::kind),
                         parameter("name", &Phase::name, {.meaning = "what it is called"}))),
      names_event("leave/event")));
  host.add(declare<Hits>(PluginKind::measure, "hits", "How often robots touched something"));
  host.add(declare<Pick>(PluginKind::coordinator, "pick", "Runs the first behaviour"));
  host.add(declare<Sum>(PluginKind::coordinator, "sum", "Adds the commands",
                        parameter("weighted", &Sum::weighted, {.meaning = "by priority"})));
  return host;
}

}  // namespace elsie::test
