// The plugins that Elsie ships hand over all that they remember.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "shipped.h"
#include "versions.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Simulation;

namespace {

namespace fs = std::filesystem;

constexpr double kLength = 20.0;  // s
constexpr double kEvery = 2.93;   // s, from one replacement to the next

/// The shipped libraries in a folder of their own.
class Shelf {
 public:
  Shelf() {
    for (const auto& entry : fs::directory_iterator(plugin_directory())) {
      if (entry.path().extension() == ".so") {
        fs::copy(entry.path(), folder_.folder / entry.path().filename());
      }
    }
  }
  plugin::Host host() const { return folder_.host(); }
  /// The same libraries, as after a build of the same sources: those of these plugins, or all.
  plugin::Host rebuilt(const plugin::Host& before, const std::set<std::string>& plugins) const {
    for (const auto& entry : fs::directory_iterator(folder_.folder)) {
      if (plugins.empty() || plugins.contains(entry.path().stem())) {
        fs::last_write_time(entry.path(),
                            fs::last_write_time(entry.path()) + std::chrono::seconds(1));
      }
    }
    return folder_.renewed(before);
  }

 private:
  Versions folder_;
};

struct History {
  std::uint64_t hash = 0;
  std::vector<std::string> events;  // but for those of the replacement itself
  bool operator==(const History&) const = default;
};

History run(const std::string& file, const std::vector<std::string>& edits, const Shelf& shelf,
            bool replaces) {
  auto host = std::make_unique<plugin::Host>(shelf.host());
  world::ReadOptions options;
  options.edits = edits;
  options.data_directories = {source_path("")};
  simulation::Options how;
  how.data_directories = options.data_directories;
  how.cameras = render::world_cameras;
  Simulation simulation(world::read_world(file, *host, options), *host, how);
  double due_s = replaces ? kEvery : 2.0 * kLength;
  std::set<std::string> used;  // plugins of which there are objects: known from the first time on
  while (simulation.outcome() == simulation::Outcome::running && simulation.time_s() < kLength) {
    if (simulation.time_s() >= due_s) {
      due_s += kEvery;
      auto next = std::make_unique<plugin::Host>(shelf.rebuilt(*host, used));
      const auto replacement = simulation.replace_plugins(*next);
      CHECK_FALSE(replacement.objects.empty());
      for (const auto& object : replacement.objects) used.insert(object.plugin);
      host = std::move(next);
    }
    simulation.step();
  }
  History history;
  history.hash = simulation.state_hash();
  for (const auto& event : simulation.events()) {
    if (event.name() != "replaced") {
      history.events.push_back(event.name() + " " + event.robot + " " +
                               std::to_string(event.time_s));
    }
  }
  return history;
}

void check(const std::string& file, const std::vector<std::string>& edits = {}) {
  CAPTURE(file, edits);
  static const Shelf shelf;
  const History undisturbed = run(file, edits, shelf, false);
  const History replaced = run(file, edits, shelf, true);
  CHECK(replaced.hash == undisturbed.hash);
  CHECK(replaced.events == undisturbed.events);
}

}  // namespace

TEST_CASE("The same libraries, loaded time and again, change nothing of any world, bit for bit",
          "[release]") {
  for (const auto& entry : fs::directory_iterator(source_path("worlds"))) {
    if (entry.path().extension() != ".xml") continue;
    check(entry.path().string());
  }
}

TEST_CASE("Nor do they under coordinators that go by what was decided last") {
  const std::string layers = source_path("worlds/layers.xml");
  check(layers, {"robot[r1]/coordinator=<arbiter_voting margin=\"0.1\"/>"});
  check(layers, {"robot[r1]/coordinator=<arbiter_action_selection margin=\"0.2\" hold=\"3\"/>"});
  check(layers, {"robot[r1]/coordinator=<arbiter_subsumption threshold=\"0.4\"><suppress "
                 "by=\"avoid_obstacle\" of=\"wander\" hold=\"1\"/></arbiter_subsumption>"});
  const std::string pulls = source_path("worlds/equal_pulls.xml");
  check(pulls, {"robot[r1]/coordinator=<arbiter_voting margin=\"0.05\"/>"});
  check(pulls, {"robot[r1]/coordinator=<fusion_interval margin=\"0.1\"/>"});
}
