// What one sensor or actuator of each kind on every robot costs a swarm, against the same robots
// without any: processor time on one core, on the planar engine or another one. Prints a table in
// Markdown.
//
//   senses [--actuators] [--engine NAME] [--robots N] [--repeats N] [SENSOR or ACTUATOR...]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "elsie/api/actuator.h"
#include "elsie/api/behavior.h"
#include "elsie/commands/gripper.h"
#include "elsie/commands/led.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"
#include "elsie/simulation/simulation.h"

#include "apart.h"
#include "arena_of_robots.h"
#include "statistics.h"

namespace {

using namespace elsie;

constexpr int kFirst = 20;     // steps that are not measured
constexpr double kNear = 1.8;  // m: ten robots of the arena are within it

struct Note {
  static constexpr const char* kind = "note";
  double number = 1.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("number", number);
  }
};

/// Commands every actuator, and reads what is heard.
class Acts final : public Behavior {
 public:
  std::string kind;

  Response respond(const Perception& now) override {
    Response response;
    for (const auto& heard : now.heard<Note>()) sum_ += heard->number;
    if (kind == "say") response.say(Note{});
    if (kind == "led") response.act(LedCommand{{255, 0, 0}, 1.0});
    if (kind == "grip") response.act(GripCommand{true});
    return response;
  }

 private:
  double sum_ = 0.0;
};

/// Robots that roam, each with this sensor or actuator at its default place, or without any.
world::World swarm(int robots, const std::string& engine, const Declaration* mounted) {
  world::World world = bench::arena_of_robots(robots);
  world.physics.engine = engine;
  world.lamps.emplace_back();
  for (world::Robot& robot : world.robots) {
    world::BehaviorUse roam;
    roam.plugin = roam.id = "wander";
    robot.behaviors = {roam};
    robot.sensors.clear();
    if (!mounted) continue;
    const bool acts = mounted->kind == PluginKind::actuator;
    world::MountedUse& use = (acts ? robot.actuators : robot.sensors).emplace_back();
    use.plugin = use.id = mounted->name;
    use.x = 0.04;
    use.z = 0.05;
    if (!acts) continue;
    if (mounted->hears_messages) use.parameters["range"] = kNear;
    world::BehaviorUse& commands = robot.behaviors.emplace_back();
    commands.plugin = commands.id = "acts";
    commands.parameters["kind"] = mounted->takes.front().kind;
  }
  return world;
}

/// Processor time for a step, s, in a process of its own.
double cost(const plugin::Host& host, const world::World& world) {
  const int steps = world.robots.size() > 1000 || world.physics.engine != "planar" ? 100 : 1000;
  return bench::apart([&] {
    simulation::Simulation run(world, host);
    for (int i = 0; i < kFirst; ++i) run.step();
    const std::clock_t start = std::clock();
    for (int i = 0; i < steps; ++i) run.step();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / steps;
  });
}

}  // namespace

int main(int argc, char** argv) {
  int robots = 1000, repeats = 5;
  std::vector<std::string> names;
  std::string engine = "planar";
  bool is_sound = true, are_actuators = false;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if ((word == "--robots" || word == "--repeats") && i + 1 < argc) {
      (word == "--robots" ? robots : repeats) = std::atoi(argv[++i]);
    } else if (word == "--engine" && i + 1 < argc) {
      engine = argv[++i];
    } else if (word == "--actuators") {
      are_actuators = true;
    } else {
      is_sound = is_sound && !word.starts_with('-');
      names.push_back(word);
    }
  }
  if (!is_sound || robots < 1 || repeats < 1) {
    std::fprintf(stderr,
                 "usage: senses [--actuators] [--engine NAME] [--robots N] [--repeats N] "
                 "[PLUGIN...]\n");
    return EXIT_FAILURE;
  }
  try {
    plugin::Host host(plugin::default_search_path());
    host.add(declare<Acts>(PluginKind::behavior, "acts", "commands an actuator", only_acts(),
                           parameter("kind", &Acts::kind)));
    const PluginKind kind = are_actuators ? PluginKind::actuator : PluginKind::sensor;
    std::vector<const Declaration*> all;
    for (const Declaration* each : host.all(kind)) {
      const bool is_named = std::find(names.begin(), names.end(), each->name) != names.end();
      // For cameras that draw see "Cameras".
      if (is_named || (names.empty() && each->name != "vision")) all.push_back(each);
    }
    const world::World bare = swarm(robots, engine, nullptr);
    std::printf(
        "%d robots, engine `%s`.\n\n| %s | us per robot and step | speed, relative to none |\n"
        "|---|---|---|\n",
        robots, engine.c_str(), are_actuators ? "actuator" : "sensor");
    for (const Declaration* each : all) {
      const world::World equipped = swarm(robots, engine, each);
      std::vector<double> times, speeds;
      for (int i = 0; i < repeats; ++i) {  // in turn, because machines drift
        const double without = cost(host, bare);
        times.push_back(1e6 * cost(host, equipped) / robots);
        speeds.push_back(1e6 * without / robots / times.back());
      }
      const auto [least, most] = std::minmax_element(speeds.begin(), speeds.end());
      std::printf("| %s | %.2f | %.0f %% (%.0f to %.0f) |\n", each->name.c_str(),
                  bench::median(times), 100.0 * bench::median(speeds), 100.0 * *least,
                  100.0 * *most);
      std::fflush(stdout);
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "senses: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
