#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/render/world_cameras.h"
#include "elsie/world/reader.h"

#include "wheels.h"
#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::PluginFault;
using simulation::Simulation;

namespace {

simulation::Options threads(std::size_t count, double time_limit_s = 1.0) {
  simulation::Options options;
  options.threads = count;
  options.time_limit_s = time_limit_s;
  options.cameras = render::world_cameras;
  return options;
}

/// Robots far enough from each other, 64 in all, with the behaviour "scripted".
world::World many() {
  world::World world;
  for (int i = 0; i < 64; ++i) {
    world.robots.push_back(
        robot("r" + std::to_string(i), -4 + i % 8, -4 + i / 8, 11.0 * i, behavior("scripted")));
  }
  return world;
}

/// Everything that a user sees of a run.
std::string account(const simulation::RunResult& result) {
  std::string text = std::to_string(result.state_hash) + " " + std::to_string(result.steps);
  for (const auto& each : result.robots) {
    text += " " + std::to_string(each.distance_m) + " " + std::to_string(each.energy) + " " +
            std::to_string(each.collisions);
  }
  for (const auto& event : result.events) {
    text += " " + std::to_string(event.time_s) + event.robot + event.name() + event.detail();
  }
  return text;
}

/// What so many threads see of a run, each of a simulation of its own, from its making to its end.
std::vector<std::string> at_once(std::size_t count, const world::World& world,
                                 const std::string& path = "", const std::string& value = "") {
  std::vector<std::string> seen(count);
  std::vector<std::thread> all;
  for (std::string& mine : seen) {
    all.emplace_back([&] {
      Simulation simulation(world, shipped(), threads(1));
      if (!path.empty()) simulation.edit(path, value);
      mine = account(simulation.run());
      simulation.reset(3);
      for (int i = 0; i < 20; ++i) simulation.step();
      mine += " " + std::to_string(simulation.state_hash());
    });
  }
  for (std::thread& each : all) each.join();
  return seen;
}

}  // namespace

#if !defined(__SANITIZE_THREAD__)  // which builds only some plugins
TEST_CASE("Every shipped world runs the same with 1, 2, 3 and 8 threads, with both engines") {
  for (const auto& file : std::filesystem::recursive_directory_iterator(source_path("worlds"))) {
    if (file.path().extension() != ".xml") continue;
    CAPTURE(file.path());
    world::ReadOptions options;
    options.data_directories = {source_path("")};
    world::World world = world::read_world(file.path().string(), shipped(), options);
    for (const char* engine : {"ode", "planar"}) {
      CAPTURE(engine);
      world.physics.engine = engine;
      const std::string alone = account(Simulation(world, shipped(), threads(1)).run());
      for (const std::size_t count : {2, 3, 8}) {
        CAPTURE(count);
        CHECK(account(Simulation(world, shipped(), threads(count)).run()) == alone);
      }
    }
  }
}

TEST_CASE("Every shipped world runs the same beside itself in other threads") {
  for (const auto& file : std::filesystem::recursive_directory_iterator(source_path("worlds"))) {
    if (file.path().extension() != ".xml") continue;
    CAPTURE(file.path());
    world::ReadOptions options;
    options.data_directories = {source_path("")};
    const world::World world = world::read_world(file.path().string(), shipped(), options);
    const std::string alone = account(Simulation(world, shipped(), threads(1)).run());
    for (const std::string& seen : at_once(3, world)) CHECK(seen.starts_with(alone + " "));
  }
}
#endif

TEST_CASE("Several simulations of a world run at once in threads, each as if alone") {
  for (const char* engine : {"ode", "planar"}) {
    CAPTURE(engine);
    world::ReadOptions options;
    options.data_directories = {source_path("")};
    const world::World world =
        world::parse_world(std::string("<world format=\"1\"><physics engine=\"") + engine + R"("/>
          <arena length="4" width="4"/>
          <obstacles><dynamic_box x="0.6" y="0.1"/><static_box x="-1" y="1"/></obstacles>
          <robots>
            <robot id="r1"><sensors><beam_range error="0.05"/></sensors>
              <behaviors><avoid_obstacle/><wander/></behaviors>
              <coordinator><arbiter_suppression/></coordinator></robot>
            <robot id="r2" x="-1"><sensors><beam_range/></sensors>
              <behaviors><braitenberg/></behaviors>
              <coordinator><arbiter_suppression/></coordinator></robot>
          </robots></world>)",
                           "at_once.xml", shipped(), options);
    const std::string edited = "robot[r2]/behavior[braitenberg]/@priority";
    CHECK(at_once(4, world) == std::vector<std::string>(4, at_once(1, world).front()));
    CHECK(at_once(4, world, edited, "2") ==
          std::vector<std::string>(4, at_once(1, world, edited, "2").front()));
  }
}

TEST_CASE("Robots are asked in several threads, each in one at a time") {
  std::mutex guard;
  std::set<std::thread::id> seen;
  std::vector<std::atomic<int>> busy(64);
  std::atomic<bool> crossed{false};
  ScriptedHost scripted([&](const Perception& now) {
    const int me = now.self().team_index;
    if (busy[me]++ != 0) crossed = true;
    {
      const std::scoped_lock lock(guard);
      seen.insert(std::this_thread::get_id());
    }
    std::this_thread::sleep_for(std::chrono::microseconds(50));
    --busy[me];
    return test::wheels(5, 4);
  });
  Simulation simulation(many(), scripted.host, threads(3));
  advance(simulation, 20);
  CHECK(seen.size() > 1);
  CHECK_FALSE(crossed);
}

TEST_CASE("A plugin that wants one thread is asked in one, in the order of the robots") {
  std::vector<int> order;
  std::set<std::thread::id> seen;
  auto answer = std::make_shared<Scripted::Answer>([&](const Perception& now) {
    order.push_back(now.self().team_index);
    seen.insert(std::this_thread::get_id());
    return test::wheels(5, 4);
  });
  plugin::Host host(shipped_directory());
  Declaration declaration = declaration_of(PluginKind::behavior, "scripted",
                                           [answer] { return std::make_unique<Scripted>(answer); });
  declaration.may_share_threads = false;
  host.add(std::move(declaration));
  Simulation simulation(many(), host, threads(4));
  simulation.step();
  REQUIRE(order.size() == 64);
  CHECK(std::is_sorted(order.begin(), order.end()));
  CHECK(seen == std::set{std::this_thread::get_id()});
}

TEST_CASE("The fault of the first robot that fails ends the run, with the events until then") {
  const auto run = [](std::size_t count) {
    ScriptedHost scripted([](const Perception& now) -> Response {
      const int me = now.self().team_index;
      if (now.time_s() > 0.045 && me % 20 == 13) throw std::runtime_error("lost");
      Response response = test::wheels(3, 3);
      response.events.push_back({"hello"});
      return response;
    });
    Simulation simulation(many(), scripted.host, threads(count));
    std::string said;
    try {
      simulation.run();
    } catch (const PluginFault& fault) {
      said = fault.what();
    }
    return said + account(simulation.result());
  };
  const std::string alone = run(1);
  CHECK(alone.starts_with("plugin 'scripted' of robot 'r13' failed in step 5 (at 0.05 s): lost"));
  for (int round = 0; round < 5; ++round) {
    CHECK(run(2) == alone);
    CHECK(run(4) == alone);
  }
}

TEST_CASE("A budget of plugins is refused with several threads") {
  simulation::Options options = threads(2);
  options.budget.time_s = 0.1;
  CHECK_THROWS_AS(Simulation(world::World(), shipped(), options), std::invalid_argument);
}
