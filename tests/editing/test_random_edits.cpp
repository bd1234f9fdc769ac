// Random edits of all shipped worlds, and the way back. ELSIE_TEST_EDITS=1000000 makes so many.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <catch2/catch.hpp>

#include "elsie/editing/between.h"
#include "elsie/editing/document.h"
#include "elsie/world/writer.h"

#include "../world/equal.h"
#include "../world/fixture.h"
#include "random_edits.h"
#include "shipped.h"

using namespace elsie;
using namespace elsie::test;

namespace {

world::ReadOptions shipped_options(std::vector<std::string> edits = {}) {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  options.edits = std::move(edits);
  return options;
}

// Without what an edit of the text may say otherwise than an override: ids that no file gives
// depend on the place in a list, and a template's parameters are set back by giving their defaults.
void reduce(world::PluginUse& use, PluginKind kind) {
  use.id.clear();
  for (const ParameterDeclaration& parameter : shipped().find(kind, use.plugin)->parameters) {
    const auto given = use.parameters.find(parameter.name);
    if (given == use.parameters.end()) {
      continue;
    }
    const auto file = use.file_names.find(parameter.name);
    const bool is_default = file == use.file_names.end()
                                ? given->second == parameter.default_value
                                : file->second.name.empty() ||
                                      ParameterValue(file->second.name) == parameter.default_value;
    if (is_default) {
      use.parameters.erase(given);
      use.file_names.erase(parameter.name);
    }
  }
}
void reduce(world::Coordination& coordination) {
  for (world::BehaviorUse& behavior : coordination.behaviors) {
    reduce(behavior, PluginKind::behavior);
    for (world::Coordination& inside : behavior.inside) {
      reduce(inside);
    }
  }
  if (coordination.coordinator) {
    reduce(*coordination.coordinator, PluginKind::coordinator);
  }
}
world::World reduced(world::World world) {
  for (world::PluginUse& measure : world.measures) {
    reduce(measure, PluginKind::measure);
  }
  for (world::PluginUse& rule : world.rules) {
    reduce(rule, PluginKind::rule);
  }
  for (world::Obstacle& box : world.obstacles) {
    box.id.clear();
  }
  for (world::Charger& charger : world.chargers) {
    charger.id.clear();
  }
  for (world::Nest& nest : world.nests) {
    nest.id.clear();
  }
  for (world::Lamp& lamp : world.lamps) {
    lamp.id.clear();
  }
  for (world::Patch& patch : world.patches) {
    patch.id.clear();
  }
  for (world::Robot& robot : world.robots) {
    reduce(robot);
    for (world::MountedUse& sensor : robot.sensors) {
      reduce(sensor, PluginKind::sensor);
    }
    for (world::MountedUse& actuator : robot.actuators) {
      reduce(actuator, PluginKind::actuator);
    }
    if (robot.drive) {
      reduce(*robot.drive, PluginKind::drive);
    }
    for (world::Segment& segment : robot.segments) {
      segment.id.clear();
    }
  }
  return world;
}

std::size_t edits_in_all() {
  const char* const wish = std::getenv("ELSIE_TEST_EDITS");
  return wish ? std::strtoul(wish, nullptr, 10) : 12'000;
}

std::vector<std::string> shipped_worlds() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("worlds"))) {
    if (entry.path().extension() == ".xml") {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE(
    "Random edits of a document change its text and its world alike, and earlier texts lead back") {
  const std::vector<std::string> files = shipped_worlds();
  const std::size_t each = edits_in_all() / files.size() + 1;
  std::size_t made = 0;
  std::size_t refused = 0;
  for (const std::string& file : files) {
    CAPTURE(file);
    RandomEdits random(static_cast<unsigned>(made + refused), shipped());
    editing::Document document = editing::Document::open(file, shipped(), shipped_options());
    const std::string first = document.text();
    const world::World start = document.world();
    REQUIRE(first == text_of(file));
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < each;) {
      if (!texts.empty() && random.happens(texts.size() < 12 ? 0.2 : 0.8)) {
        document.become(texts.back());
        texts.pop_back();
        continue;
      }
      ++i;
      const std::string edit = random.next(document.world());
      const std::string before = document.text();
      const world::World old = document.world();
      CAPTURE(edit, before);
      try {
        document.apply({edit});
        texts.push_back(before);
        ++made;
      } catch (const world::WorldError& error) {
        ++refused;
        REQUIRE_FALSE(error.problems().empty());
        REQUIRE(document.text() == before);
        REQUIRE(same(document.world(), old));
        continue;
      }
      if (!random.happens(0.2)) {
        continue;
      }
      // The text says what the edit says when it overrides the old text.
      CAPTURE(document.text());
      REQUIRE(same(reduced(document.world()),
                   reduced(world::parse_world(before, file, shipped(), shipped_options({edit})))));
    }
    // In a running world, other edits lead to the same one.
    const world::World end = document.world();
    world::ReadOptions running = shipped_options(editing::edits_between(start, end));
    running.is_running = true;
    CAPTURE(running.edits);
    CHECK(world::write_world(world::parse_world(world::write_world(start), file, shipped(),
                                                running)) == world::write_world(end));
    document.become(first);
    REQUIRE(same(document.world(), start));
  }
  if (std::getenv("ELSIE_TEST_EDITS")) {
    WARN(made << " made, " << refused << " refused");
  }
  CHECK(made > edits_in_all() / 3);
  CHECK(refused > edits_in_all() / 20);
}
