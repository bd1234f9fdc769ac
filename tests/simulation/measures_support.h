// Worlds with measures, and measures that do what a test says.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/measure.h"
#include "elsie/simulation/measures.h"
#include "elsie/world/colours.h"
#include "elsie/world/error.h"
#include "elsie/world/reader.h"

#include "wheels.h"
#include "world_builder.h"

namespace elsie::test {

/// What a measure of a test does.
struct Script {
  std::function<void(const Observation&)> equipped = [](const Observation&) {};
  std::function<void(const Observation&)> observe = [](const Observation&) {};
  std::function<std::optional<double>()> value = [] { return std::nullopt; };
  std::vector<Quantity> quantities{{"", "", "a test's"}};
};

class ScriptedMeasure final : public Measure {
 public:
  explicit ScriptedMeasure(std::shared_ptr<Script> script) : script_(std::move(script)) {}
  void equipped(const Observation& start) override { script_->equipped(start); }
  std::vector<Quantity> quantities() const override { return script_->quantities; }
  void observe(const Observation& now) override { script_->observe(now); }
  void report(const RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = script_->value();
  }
  std::vector<std::string> notes() const override { return {"It watches."}; }

 private:
  std::shared_ptr<Script> script_;
};

inline Declaration measure_declaration(const Script& script) {
  return declaration_of(PluginKind::measure, "scripted_measure",
                        [shared = std::make_shared<Script>(script)] {
                          return std::make_unique<ScriptedMeasure>(shared);
                        });
}

inline world::PluginUse measure(const std::string& plugin, Parameters parameters = {}) {
  world::PluginUse use;
  use.plugin = use.id = plugin;
  use.parameters = std::move(parameters);
  use.location = {"world.xml", 7};
  return use;
}

/// A robot that drives as commanded, in a world with measures.
struct Run {
  explicit Run(Script script = {},
               std::vector<world::PluginUse> measures = {measure("scripted_measure")})
      : scripted([this](const Perception& now) { return Response(drive(now)); }) {
    scripted.host.add(measure_declaration(script));
    world.robots.push_back(robot("r1", 0, 0, 0, behavior("scripted")));
    world.teams = {{"red", world::kRedTeam}, {"blue", world::kBlueTeam}};  // as every file has
    world.limits.time = 1.0;
    world.measures = std::move(measures);
  }
  simulation::RunResult run() { return simulation::Simulation(world, scripted.host).run(); }
  std::string refusal() const {
    try {
      simulation::Simulation(world, scripted.host);
      return "";
    } catch (const world::WorldError& error) {
      return error.what();
    }
  }

  std::function<Motion(const Perception&)> drive = [](const Perception&) { return wheels(10, 10); };
  ScriptedHost scripted;
  world::World world;
};

inline std::optional<double> value(const simulation::RunResult& result, const std::string& name) {
  const auto found = std::find_if(
      result.measures.begin(), result.measures.end(),
      [&](const simulation::MeasuredValue& measured) { return measured.name == name; });
  INFO(name);
  REQUIRE(found != result.measures.end());
  return found->value;
}

/// A shipped world that ends after so many seconds, whatever its goals want.
inline world::World shipped_world(const std::string& name, double seconds) {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  world::World world =
      world::read_world(source_path("worlds/" + name + ".xml"), shipped(), options);
  world.limits.time = seconds;
  return world;
}

}  // namespace elsie::test
