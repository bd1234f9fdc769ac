// Random edits of all shipped worlds, and their inverses.
#include <cstdlib>
#include <filesystem>
#include <map>

#include <catch2/catch.hpp>

#include "elsie/world/document.h"

#include "equal.h"
#include "fixture.h"
#include "random_edits.h"
#include "shipped.h"

using namespace elsie;
using namespace elsie::test;

namespace {

world::ReadOptions shipped_options(std::vector<std::string> overrides = {}) {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  options.overrides = std::move(overrides);
  return options;
}

// Ids that no file gives depend on the place in a list.
void forget_names(std::vector<world::BehaviorUse>& behaviors);
void forget_names(world::Coordination& coordination) {
  forget_names(coordination.behaviors);
  if (coordination.coordinator) {
    coordination.coordinator->id.clear();
  }
}
void forget_names(std::vector<world::BehaviorUse>& behaviors) {
  for (world::BehaviorUse& behavior : behaviors) {
    behavior.id.clear();
    for (world::Coordination& inside : behavior.inside) {
      forget_names(inside);
    }
  }
}
world::World nameless(world::World world) {
  for (auto* list : {&world.measures}) {
    for (auto& each : *list) {
      each.id.clear();
    }
  }
  for (world::Box& box : world.boxes) {
    box.id.clear();
  }
  for (world::Charger& charger : world.chargers) {
    charger.id.clear();
  }
  for (world::Robot& robot : world.robots) {
    forget_names(robot);
    for (world::SensorUse& sensor : robot.sensors) {
      sensor.id.clear();
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

TEST_CASE("Random edits of a document are undone byte for byte") {
  const std::vector<std::string> files = shipped_worlds();
  const std::size_t each = edits_in_all() / files.size() + 1;
  std::size_t made = 0;
  std::size_t refused = 0;
  std::map<std::string, int> reasons;
  for (const std::string& file : files) {
    CAPTURE(file);
    RandomEdits random(static_cast<unsigned>(made + refused), shipped());
    world::Document document = world::Document::open(file, shipped(), shipped_options());
    const std::string first = document.text();
    const world::World start = document.world();
    REQUIRE(first == text_of(file));
    std::vector<world::Edits> inverses;
    for (std::size_t i = 0; i < each;) {
      if (!inverses.empty() && random.happens(inverses.size() < 12 ? 0.2 : 0.8)) {
        document.apply(inverses.back());
        inverses.pop_back();
        continue;
      }
      ++i;
      const std::string edit = random.next(document.world());
      const std::string before = document.text();
      const world::World old = document.world();
      CAPTURE(edit, before);
      try {
        inverses.push_back(document.apply(edit));
        ++made;
      } catch (const world::WorldError& error) {
        ++refused;
        ++reasons[error.problems().front().message.substr(0, 40)];
        REQUIRE(document.text() == before);
        REQUIRE(same(document.world(), old));
        continue;
      }
      if (!random.happens(0.2)) {
        continue;
      }
      // The text says what the edit says when it overrides the old text.
      CAPTURE(document.text());
      REQUIRE(same(nameless(document.world()),
                   nameless(world::parse_world(before, file, shipped(), shipped_options({edit})))));
      // As texts, the inverse leads to the old world, too.
      world::Document other(document.text(), file, shipped(), shipped_options());
      const auto& texts = inverses.back().texts();
      std::string all;
      for (const std::string& text : texts) {
        all += text + "\n";
      }
      CAPTURE(all);
      other.apply(texts);
      REQUIRE(same(nameless(other.world()), nameless(old)));
    }
    while (!inverses.empty()) {
      document.apply(inverses.back());
      inverses.pop_back();
    }
    REQUIRE(document.text() == first);
    REQUIRE(same(document.world(), start));
  }
  if (std::getenv("ELSIE_TEST_EDITS")) {
    for (const auto& [reason, count] : reasons) {
      UNSCOPED_INFO(count << " " << reason);
    }
    WARN(made << " made, " << refused << " refused");
  }
  CHECK(made > edits_in_all() / 3);
  CHECK(refused > edits_in_all() / 20);
}
