// Plugins that are replaced while a world runs.
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include <catch2/catch.hpp>
#include <malloc.h>

#include "elsie/plugin/abi_word.h"
#include "elsie/recording/csv_recorder.h"

#include "replacement_stage.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace {

/// The world after so many steps, as one number.
std::uint64_t run(Stage& stage, int steps) {
  for (int i = 0; i < steps; ++i) {
    stage.simulation->step();
  }
  return stage.simulation->state_hash();
}

bool is_sanitized() { return plugin::host_abi_word().find("sanitizer=none") == std::string::npos; }

}  // namespace

TEST_CASE("The new version answers from the next step on, and the old one leaves the memory") {
  Stage stage;
  stage.start();
  CHECK(stage.step().left == Approx(0.01));
  CHECK(Versions::loaded() == 1);
  const Replacement replacement = stage.replace(2);
  CHECK(stage.step().left == Approx(0.02));
  CHECK(Versions::loaded() == 1);
  REQUIRE(replacement.objects.size() == 2);
  CHECK(replacement.objects[0].robot == "r1");
  CHECK(replacement.objects[0].path == "behavior[numbered]");
  CHECK(replacement.objects[0].plugin == "numbered");
  CHECK(replacement.objects[0].remembers);
  CHECK(replacement.objects[1].path == "coordinator");
  CHECK_FALSE(replacement.objects[1].remembers);
  CHECK(replacement.notes.empty());
  const auto events = stage.simulation->events();
  CHECK(std::count_if(events.begin(), events.end(), [](const auto& event) {
          return event.name() == "replaced" && event.robot == "r1" &&
                 (event.detail() == "behavior[numbered]: numbered" ||
                  event.detail() == "coordinator: numbered_first");
        }) == 2);
}

TEST_CASE("A file that is overwritten in place does no harm to the code that runs") {
  Stage stage;
  stage.start();
  stage.versions.write(2, '-', true);
  CHECK(stage.step().left == Approx(0.01));
  stage.replace();
  CHECK(stage.step().left == Approx(0.02));
  stage.versions.write(std::string("this is no library any more"), true);
  CHECK(stage.step().left == Approx(0.02));
}

TEST_CASE("A file that has not changed is not loaded again") {
  Stage stage;
  stage.start();
  CHECK(stage.replace().objects.empty());
  stage.replace(2);
  CHECK(stage.replace().objects.empty());
  CHECK(stage.step().left == Approx(0.02));
}

TEST_CASE("Objects are replaced on all robots, at any depth, sensors too") {
  auto holder = behavior("holder");
  auto& inside = holder.inside.emplace_back();
  inside.behaviors.push_back(behavior("leveller"));
  inside.coordinator.emplace();
  inside.coordinator->plugin = inside.coordinator->id = "numbered_first";
  Stage stage(holder);
  stage.world.robots.push_back(numbered_robot("r2", 2.0, behavior("numbered")));
  stage.add_levels();
  stage.start();
  CHECK(stage.step().left == Approx(0.01));
  const Replacement replacement = stage.replace(3);
  std::vector<std::string> paths;
  for (const auto& object : replacement.objects) {
    paths.push_back(object.robot + "/" + object.path);
  }
  CHECK(paths == std::vector<std::string>{
                     "r1/sensor[level]", "r1/behavior[holder]/behavior[leveller]",
                     "r1/behavior[holder]/coordinator", "r1/behavior[holder]", "r1/coordinator",
                     "r2/sensor[level]", "r2/behavior[numbered]", "r2/coordinator"});
  CHECK(stage.step().left == Approx(0.03));
  CHECK(rates(stage.simulation->robot(1).command).left == Approx(0.03));
  CHECK(Versions::loaded() == 1);
}

TEST_CASE("Parameters stay as the world sets them and as they were changed since") {
  auto use = behavior("numbered", 1.0, {{"gain", 2.0}});
  Stage stage(use);
  stage.world.robots.push_back(numbered_robot("r2", 2.0, use));
  Simulation& simulation = stage.start();
  stage.step();
  simulation.edit("robot[r1]/behavior[numbered]/@gain", "5");
  stage.replace(2);
  CHECK(stage.step().left == Approx(0.10));
  CHECK(rates(simulation.robot(1).command).left == Approx(0.04));
  simulation.edit("robot[r2]/behavior[numbered]/@gain", "3");  // of the new library
  stage.step();
  CHECK(rates(simulation.robot(1).command).left == Approx(0.06));
  simulation.reset();
  CHECK(stage.step().left == Approx(0.04));
  CHECK(rates(simulation.robot(1).command).left == Approx(0.04));
}

TEST_CASE("A parameter that is gone is left out and reported, a new one has its default") {
  Stage stage(behavior("numbered", 1.0, {{"gain", 2.0}, {"stale", 1.0}}));
  Simulation& simulation = stage.start();
  simulation.edit("robot[r1]/behavior[numbered]/@gain", "5");
  const Replacement replacement = stage.replace(2, 'r');
  CHECK(replacement.notes ==
        std::vector<std::string>{"robot 'r1', behavior[numbered]: the parameter 'gain' is no "
                                 "longer declared by numbered and was left out"});
  CHECK(stage.step().left == Approx(0.02));
  CHECK_THROWS_WITH(simulation.edit("robot[r1]/behavior[numbered]/@gain", "5"), Contains("gain"));
  simulation.edit("robot[r1]/behavior[numbered]/@boost", "4");
  CHECK(stage.step().left == Approx(0.08));
  simulation.reset();
  CHECK(stage.step().left == Approx(0.02));
  CHECK_FALSE(simulation.world().robots[0].behaviors[0].parameters.contains("gain"));
  CHECK(simulation.world().robots[0].behaviors[0].parameters.contains("stale"));
}

TEST_CASE("What an object remembers is handed over; one that hands over nothing starts again") {
  Stage stage;
  stage.world.robots.push_back(numbered_robot("r2", 2.0, behavior("forgetful")));
  Simulation& simulation = stage.start();
  for (int i = 1; i <= 5; ++i) {
    CHECK(stage.step().right == Approx(0.01 * i));
  }
  CHECK(rates(simulation.robot(1).command).left == Approx(0.05));
  stage.replace(2);
  CHECK(stage.step().right == Approx(0.06));
  CHECK(rates(simulation.robot(1).command).left == Approx(0.01));
}

TEST_CASE("Random streams go on: the same code in a new library changes nothing of a run") {
  Stage stage(behavior("numbered", 1.0, {{"draws", true}}));
  stage.start();
  const std::uint64_t undisturbed = run(stage, 200);
  Stage other(behavior("numbered", 1.0, {{"draws", true}}));
  other.start();
  run(other, 70);
  other.replace(2);
  run(other, 30);
  other.replace(3);
  CHECK(run(other, 100) == undisturbed);
}

TEST_CASE("A version that cannot be used leaves the old one in place, on all robots") {
  Stage stage(behavior("numbered", 1.0, {{"gain", 2.0}}));
  stage.world.robots.push_back(numbered_robot("r2", 2.0, behavior("numbered")));
  stage.add_levels();
  stage.start();
  const std::uint64_t undisturbed = run(stage, 40);
  stage.start();
  run(stage, 20);
  const std::string who = "robot 'r1', behavior[numbered]: ";
  CHECK_THAT(stage.refusal(2, 'g'), Contains(who + "there is no behavior 'numbered'"));
  CHECK_THAT(stage.refusal(3, 't'),
             Contains(who) && Contains("could not be made: it cannot be made any more"));
  CHECK_THAT(stage.refusal(4, 'n'),
             Contains(who) && Contains("gain is 2, but must be a number at most 1.5"));
  CHECK_THAT(stage.refusal(5, 'c'), Contains(who) && Contains("it does not want any gain"));
  CHECK_THAT(stage.refusal(6, 'z'), Contains(who + "it cannot begin"));
  CHECK_THAT(stage.refusal(7, 'm'), Contains(who + "it makes nothing of that"));
  CHECK_THAT(stage.refusal(8, 'q'),
             Contains(who + "it needs the parameter 'stale' now, which the world does not give"));
  CHECK_THAT(stage.refusal(9, 'k'),
             Contains("robot 'r1', sensor[level]: it makes readings of the kind 'other' now"));
  CHECK_THAT(stage.refusal(10, 'o'), Contains("sensor[level]: it would gain a camera; replace "
                                              "its element by an edit"));
  CHECK(Versions::loaded() == 1);
  CHECK(run(stage, 20) == undisturbed);
  CHECK(rates(stage.simulation->robot(1).command).left == Approx(0.01));
  // And it is not in the way of a good one.
  stage.replace(11);
  CHECK(stage.step().left == Approx(0.22));
}

TEST_CASE("A file that is no library for this program, or gone, leaves the old one in place") {
  Stage stage;
  stage.start();
  std::string bytes = Versions::original();
  const std::size_t at = bytes.find("api=0.");
  REQUIRE(at != std::string::npos);
  bytes.replace(at, 5, "api=9");
  struct Case {
    std::string bytes, warning;
  };
  for (const Case& expected : {Case{bytes, "plugin interface 9."}, Case{bytes.substr(0, 3000), ""},
                               Case{"no library", ""}, Case{"", ""}}) {
    stage.versions.write(expected.bytes);
    const plugin::Host host = stage.versions.renewed(*stage.host);
    REQUIRE(host.report().warnings.size() == 1);
    CHECK_THAT(host.report().warnings[0],
               Contains(expected.warning) &&
                   Contains("the library that was there before is still in use"));
    CHECK(host.find(PluginKind::behavior, "numbered") ==
          stage.host->find(PluginKind::behavior, "numbered"));
    CHECK(stage.replace().objects.empty());
    CHECK(stage.step().left == Approx(0.01));
  }
  std::filesystem::remove(stage.versions.file());
  CHECK(stage.replace().objects.empty());
  CHECK_THAT(stage.host->report().warnings.at(0), Contains("versioned.so: is gone"));
  CHECK(stage.step().left == Approx(0.01));
  CHECK(stage.replace(2).objects.size() == 2);
  CHECK(stage.step().left == Approx(0.02));
}

TEST_CASE("Traces and events do not point into a library that is gone") {
  Stage stage;
  Simulation& simulation = stage.start();
  stage.step();
  const auto reason = [&] { return simulation.robot(0).members[0].trace.reason; };
  const std::string before = reason();
  CHECK(reason() == "by number 1");
  stage.replace(2);
  CHECK(Versions::loaded() == 1);
  CHECK(reason() == "by number 1");
  stage.step();
  CHECK(reason() == "by number 2");
  CHECK(before == "by number 1");
  stage.step();  // perceives the event that was raised before
  const auto events = simulation.events();
  CHECK(std::count_if(events.begin(), events.end(),
                      [](const auto& event) { return event.name() == "beat"; }) == 2);
  // A version that raises another event.
  stage.replace(3, 'e');
  stage.step();
  stage.step();
  CHECK(simulation.events().back().name() == "bong");
}

TEST_CASE("A recording keeps its columns when a sensor lists other numbers") {
  Stage stage;
  stage.add_levels();
  stage.world.limits.time = 0.1;
  Simulation& simulation = stage.start();
  const TemporaryFile table;
  {
    const auto recorder = recording::csv_recorder(table.path, {.rate_hz = 100.0});
    simulation::Observer* const observers[] = {recorder.get()};
    simulation.run(observers, {}, [&](Simulation& running) {
      if (running.steps() == 5) {
        stage.replace(2, 'v');
      }
    });
  }
  std::ifstream in(table.path);
  std::string heading, line;
  std::getline(in, heading);
  CHECK_THAT(heading, Contains(",sensor[level].level,") && !Contains("new_one"));
  const auto column = std::count(
      heading.begin(), heading.begin() + static_cast<long>(heading.find("sensor[level]")), ',');
  std::vector<std::string> levels;
  while (std::getline(in, line)) {
    std::size_t from = 0;
    for (long i = 0; i < column; ++i) {
      from = line.find(',', from) + 1;
    }
    levels.push_back(line.substr(from, line.find(',', from) - from));
  }
  CHECK(levels == std::vector<std::string>{"", "1", "1", "1", "1", "1", "2", "2", "2", "2", "2"});
}

TEST_CASE("A hundred versions in a row: each answers for itself, nothing grows, one is loaded") {
  Stage stage;
  Simulation& simulation = stage.start();
  const auto heap = [] {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
  };
  double after_some = 0.0;
  for (int number = 2; number <= 101; ++number) {
    stage.replace(number);
    REQUIRE(stage.step().left == Approx(0.01 * number));
    REQUIRE(Versions::loaded() == 1);
    simulation.reset();  // what the log of events takes is not counted
    if (number == 21) {
      after_some = heap();
    }
  }
  if (!is_sanitized()) {
    // Texts are kept, once each, and the loader keeps a little of every library.
    INFO(heap() - after_some << " bytes more after 80 replacements");
    CHECK(heap() - after_some < 80 * 1000);
  }
}

TEST_CASE("A replacement in a run is between two control periods, and observers hear of it") {
  Stage stage;
  stage.world.physics.control_steps = 3;
  stage.world.limits.time = 0.3;
  Simulation& simulation = stage.start();
  struct Listener : simulation::Observer {
    std::vector<std::uint64_t> steps;
    void replaced(const Simulation& running) override { steps.push_back(running.steps()); }
  } listener;
  simulation::Observer* const observers[] = {&listener};
  int asked = 0;
  simulation.run(observers, {}, [&](Simulation& running) {
    CHECK(running.steps() % 3 == 0);
    if (++asked == 4) {
      stage.replace(2);
    }
  });
  CHECK(asked == 10);
  CHECK(listener.steps == std::vector<std::uint64_t>{9});
}
