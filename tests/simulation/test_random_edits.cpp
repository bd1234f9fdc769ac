// Random edits of the shipped worlds while they run.
#include <cstdlib>
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/world/data_directories.h"
#include "elsie/world/reader.h"

#include "../world/random_edits.h"
#include "change_support.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr int kEdits = 120;  // of each world; ELSIE_EDITS asks for others
constexpr unsigned kSeed = 11;

int edits_of_each_world() {
  const char* const asked = std::getenv("ELSIE_EDITS");
  return asked ? std::atoi(asked) : kEdits;
}

simulation::Change change_of(const std::string& edit) {
  const std::size_t equals = edit.find('=');
  return {edit.substr(0, equals), edit.substr(equals + 1)};
}

bool needs_cameras(const world::World& world) {
  for (const world::Robot& robot : world.robots) {
    for (const world::SensorUse& sensor : robot.sensors) {
      if (sensor.plugin == "vision") {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

TEST_CASE(
    "Random edits of running worlds are made or refused, and what is refused changes nothing") {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  const simulation::Options run{.seed = 3, .data_directories = options.data_directories};
  int made = 0, refused = 0;
  for (const auto& file : std::filesystem::directory_iterator(source_path("worlds"))) {
    if (file.path().extension() != ".xml") {
      continue;
    }
    CAPTURE(file.path());
    const world::World world = world::read_world(file.path().string(), shipped(), options);
    if (needs_cameras(world)) {
      continue;
    }
    RandomEdits random(kSeed, shipped());
    Simulation simulation(world, shipped(), run);
    Simulation twin(world, shipped(), run);  // to which what is refused is not even told
    for (int i = 0; i < edits_of_each_world(); ++i) {
      const std::string text = random.next(simulation.world());
      CAPTURE(i, text);
      const simulation::Change edit = change_of(text);
      try {
        simulation.change(edit.path, edit.value);
        ++made;
        REQUIRE_NOTHROW(twin.change(edit.path, edit.value));
      } catch (const ChangeRefused&) {
        ++refused;
      }
      REQUIRE(simulation.state_hash() == twin.state_hash());
      try {
        advance(simulation, 2);
      } catch (const simulation::PhysicsFault&) {  // of bodies that no engine could move
        break;
      }
      advance(twin, 2);
      REQUIRE(simulation.state_hash() == twin.state_hash());
    }
  }
  CAPTURE(made, refused);
  CHECK(made > 10 * (edits_of_each_world() / 10));
  CHECK(refused > 0);
}
