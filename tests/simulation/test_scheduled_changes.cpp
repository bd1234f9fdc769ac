// Changes that are asked for before a run: when they are made, and that runs with them repeat.
#include <catch2/catch.hpp>

#include "elsie/recording/mcap_recorder.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/simulation/run.h"
#include "elsie/traces/trace.h"
#include "elsie/world/reader.h"

#include "lively.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;
using elsie::test::wheels;
using simulation::RunResult;
using simulation::TimedEdit;

namespace {

const std::vector<TimedEdit> kChanges{
    {1.0, {"robot[*]/@max_speed", "0.2"}},
    {2.0, {"robot[r1]/@x", "1.5"}},
    {2.0, {"robot[r1]/@y", "-1.5"}},
    {2.5, {"robot[*]/sensor[*]/@error", "0.2"}},
    {3.0, {"robot[r1]/coordinator/@weighted", "true"}},
    {3.0, {"robot[r1]/behavior[wander]/@priority", "4"}},
    {4.0, {"robot[r2]/behavior[wander]/@turn", "9"}},
};

RunResult result_of(std::uint64_t seed, const std::vector<TimedEdit>& edits) {
  return Simulation(lively(), shipped(), {seed}).run({}, edits);
}

}  // namespace

TEST_CASE("Whether a run makes its changes or a caller between two steps is the same") {
  const RunResult scheduled = result_of(5, kChanges);
  Simulation simulation(lively(), shipped(), {5});
  while (simulation.outcome() == simulation::Outcome::running) {
    std::vector<simulation::Edit> now;
    for (const TimedEdit& timed : kChanges) {
      if (simulation.steps() == static_cast<std::uint64_t>(std::lround(timed.time_s * 100))) {
        now.push_back(timed.edit);
      }
    }
    simulation.edit(now);
    simulation.step();
  }
  CHECK(simulation.state_hash() == scheduled.state_hash);
  CHECK(simulation.events().size() == scheduled.events.size());
}

TEST_CASE("A caller that makes the steps of a run makes the same run") {
  struct Counter final : simulation::Observer {
    int started_ = 0, stepped_ = 0, ended_ = 0;
    void started(const Simulation&) override { ++started_; }
    void stepped(const Simulation&) override { ++stepped_; }
    void ended(const Simulation&) override { ++ended_; }
  } counter;
  simulation::Observer* const observers[] = {&counter};
  Simulation simulation(lively(), shipped(), {5});
  {
    simulation::Run run(simulation, observers, kChanges);
    CHECK(counter.started_ == 1);
    while (run.step()) {
    }
    CHECK_FALSE(run.step());
    CHECK(run.end().state_hash == result_of(5, kChanges).state_hash);
    CHECK(run.end().steps == static_cast<std::uint64_t>(counter.stepped_));
  }
  CHECK(counter.ended_ == 1);
}

TEST_CASE("A run that failed throws the same at every later step") {
  struct Refusing final : simulation::Observer {
    void stepped(const Simulation&) override { throw std::runtime_error("enough"); }
  } refusing;
  simulation::Observer* const observers[] = {&refusing};
  Simulation simulation(lively(), shipped(), {5});
  simulation::Run run(simulation, observers);
  CHECK_THROWS_WITH(run.step(), "enough");
  CHECK_THROWS_WITH(run.step(), "enough");
  CHECK_THROWS_WITH(run.end(), "enough");
  CHECK(simulation.steps() == 1);
}

TEST_CASE("After a reset a run with changes and one without are those of a new simulation") {
  Simulation simulation(lively(), shipped(), {5});
  simulation.run({}, kChanges);
  simulation.reset();
  CHECK(simulation.run().state_hash == result_of(5, {}).state_hash);
  simulation.reset(9);
  CHECK(simulation.run({}, kChanges).state_hash == result_of(9, kChanges).state_hash);
}

TEST_CASE("A change is made before the first step at its time or after it") {
  ScriptedHost scripted([](const Perception&) { return wheels(20, 20); });
  world::World world;
  world.limits.time = 1;
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  // 57 steps of 0.01 s are a hair more than 0.57 s, and 58 a hair less than 0.58.
  const std::vector<TimedEdit> edits{{0.58, {"robot[r1]/@max_speed", "0.1"}},
                                     {0.0, {"robot[r1]/@max_speed", "0.2"}},
                                     {0.57, {"robot[r1]/@coverage", "2"}},
                                     {0.123, {"robot[r1]/@leader", "true"}}};
  const RunResult result = simulation.run({}, edits);
  CHECK(events_of(simulation) == std::vector<std::string>{"0 changed robot[r1]/@max_speed=0.2",
                                                          "0.13 changed robot[r1]/@leader=true",
                                                          "0.57 changed robot[r1]/@coverage=2",
                                                          "0.58 changed robot[r1]/@max_speed=0.1"});
  CHECK(result.robots[0].distance_m == Approx(0.58 * 0.2 + 0.42 * 0.1).margin(0.005));
}

TEST_CASE("A schedule is checked before the run begins") {
  ScriptedHost scripted([](const Perception&) { return wheels(20, 20); });
  world::World world;
  world.limits.time = 1;
  world.robots = {robot("r1", 0, 0, 0, behavior("escape"))};
  Simulation simulation(world, scripted.host);
  const auto refused = [&](const std::vector<TimedEdit>& edits, const std::string& sentence) {
    CHECK(why_not([&] { simulation.run({}, edits); }) == sentence);
    CHECK(why_not([&] { simulation.check(edits); }) == sentence);
    CHECK(simulation.steps() == 0);
  };
  const TimedEdit good{0.2, {"robot[r1]/@leader", "true"}};
  refused({good, {1.0, {"robot[r1]/@x", "1"}}},
          "robot[r1]/@x=1: its time is 1 s, but the run begins at 0 and ends after 1 s at the "
          "latest; expected a time in between, before the last step begins");
  refused({good, {0.9951, {"robot[r1]/@x", "1"}}},
          "robot[r1]/@x=1: its time is 0.9951 s, but the run begins at 0 and ends after 1 s at the "
          "latest; expected a time in between, before the last step begins");
  refused({good, {-0.1, {"robot[r1]/@x", "1"}}},
          "robot[r1]/@x=1: its time is -0.1 s, but the run begins at 0 and ends after 1 s at the "
          "latest; expected a time in between, before the last step begins");
  refused({good, {0.5, {"robot[r1]/@max_speed", "fast"}}},
          "at 0.5 s, robot[r1]/@max_speed=fast: expected a number at least 0 and at most 100 m/s");
  refused({good, {0.5, {"robot[r1]/@x", "6"}}},
          "at 0.5 s, robot[r1]/@x=6: that is outside of the arena, which reaches from -5 to 5 in "
          "x");
  // Parameters are judged by what they are by then: turn_min is 60, turn_max 150.
  const std::string turn = "robot[r1]/behavior[escape]/@turn_";
  refused({{0.5, {turn + "min", "170"}}},
          "at 0.5 s, " + turn +
              "min=170: behavior 'escape': turn_min is 170 deg and turn_max 150 deg; the turn is "
              "drawn from between the two, so turn_min must not be the larger one");
  CHECK(why_not([&] {
          simulation.check(
              std::vector<TimedEdit>{{0.5, {turn + "min", "170"}}, {0.4, {turn + "max", "180"}}});
        }).empty());
}

TEST_CASE("A place that is taken when its time comes ends the run, and its observers hear of it") {
  struct Listener final : simulation::Observer {
    void stepped(const Simulation&) override { ++steps; }
    void ended(const Simulation&) override { ended_at = steps; }
    int steps = 0, ended_at = -1;
  } listener;
  ScriptedHost scripted(
      [](const Perception& now) { return now.self().id == "walker" ? wheels(10, 10) : Motion{}; });
  world::World world;
  world.limits.time = 10;
  world.robots = {robot("walker", 0, 0, 0, behavior("scripted")),
                  robot("other", 0, 2, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  const std::vector<TimedEdit> onto{{5.0, {"robot[other]/@x", "1"}},
                                    {5.0, {"robot[other]/@y", "0"}}};
  simulation::Observer* observers[] = {&listener};
  CHECK(why_not([&] { simulation.run(observers, onto); }) ==
        "at 5 s, robot[other]/@x=1, robot[other]/@y=0: the robot 'other' overlaps the robot "
        "'walker'; expected a free place in the arena");
  CHECK(listener.ended_at == 500);
}

TEST_CASE("Recordings tell what was changed, and observers see the start as it is changed to") {
  struct Start final : simulation::Observer {
    void started(const Simulation& simulation) override { x = simulation.robot(0).pose.x; }
    double x = 0;
  } start;
  ScriptedHost scripted([](const Perception&) { return wheels(5, 5); });
  world::World world;
  world.limits.time = 1;
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  TemporaryFile file;
  const auto recorder = recording::mcap_recorder(file.path);
  simulation::Observer* observers[] = {&start, recorder.get()};
  simulation.run(observers, std::vector<TimedEdit>{{0.0, {"robot[r1]/@x", "-2"}},
                                                   {0.5, {"robot[1]/@max_speed", "0.05"}}});
  CHECK(start.x == Approx(-2));
  const traces::Trace trace = recording::read_trace(file.path);
  REQUIRE(trace.robots.at(0).events.size() == 2);
  CHECK(trace.robots[0].events[0].detail == "robot[r1]/@x=-2");
  CHECK(trace.robots[0].events[1].detail == "robot[r1]/@max_speed=0.05");
}

namespace {

/// A robot that stands, in a world with this in it.
Simulation standing(const std::string& content, std::optional<double> duration = {}) {
  return of(content, "", {.time_limit_s = duration});
}

}  // namespace

TEST_CASE("After an edit of the step the later edits are made at their own times") {
  Simulation simulation = standing("<limits time=\"2\"/>");
  simulation.run({}, std::vector<TimedEdit>{{1.0, {"physics/@step", "0.001"}},
                                            {1.508, {"robot[r1]/@max_speed", "0.2"}},
                                            {1.502, {"robot[r1]/@max_speed", "0.1"}}});
  CHECK(events_of(simulation) ==
        std::vector<std::string>{"1 changed physics/@step=0.001",
                                 "1.502 changed robot[r1]/@max_speed=0.1",
                                 "1.508 changed robot[r1]/@max_speed=0.2"});
}

TEST_CASE("A time is checked against the limit that earlier edits leave") {
  const TimedEdit late{3.0, {"robot[r1]/@max_speed", "0.2"}};
  CHECK(standing("<limits time=\"2\"/>")
            .run({}, std::vector<TimedEdit>{late, {1.0, {"limits/@time", "4"}}})
            .simulated_s == Approx(4));
  Simulation cut = standing("<limits time=\"4\"/>");
  CHECK(why_not([&] {
          cut.check(std::vector<TimedEdit>{late, {1.0, {"limits/@time", "2"}}});
        }) ==
        "robot[r1]/@max_speed=0.2: its time is 3 s, but the run begins at 0 and ends after "
        "2 s at the latest; expected a time in between, before the last step begins");
}

TEST_CASE("A run that was given a duration keeps it, and says so") {
  const RunResult result = standing("<limits time=\"4\"/>", 2.0)
                               .run({}, std::vector<TimedEdit>{{1.0, {"limits/@time", "3"}}});
  CHECK(result.simulated_s == Approx(2));
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0].plugin == "limits");
  CHECK(result.notes[0].text ==
        "An edit at 1 s gives limits/@time another value, but this run ends after 2 s at the "
        "latest: it was given that duration.");
}

TEST_CASE("A world's own edits after the end of its run are not made, which a note says") {
  Simulation simulation = standing(
      "<limits time=\"20\"/><changes><change time=\"1\" path=\"robot[r1]/@max_speed\" "
      "value=\"0.2\"/><change time=\"9\" path=\"robot[r1]/@max_speed\" value=\"0.3\"/></changes>",
      2.0);
  const RunResult result = simulation.run();
  CHECK(events_of(simulation) == std::vector<std::string>{"1 changed robot[r1]/@max_speed=0.2"});
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0].text ==
        "The edits at 9 s are not made: the run ends after 2 s at the latest.");
}

TEST_CASE("A battery that an edit makes smaller holds less, whatever the robot began with") {
  Simulation simulation = standing("<limits time=\"4\"/>");
  const RunResult result =
      simulation.run({}, std::vector<TimedEdit>{{1.0, {"robot[r1]/@energy", "3000"}},
                                                {2.0, {"robot[r1]/@battery", "2000"}}});
  CHECK(result.robots[0].energy == 2000);
}

TEST_CASE("A world's own edits are checked when it is read, all of them, each at its line") {
  world::ReadOptions options;
  options.check_plugins = true;
  std::string problems;
  try {
    world::parse_world(
        "<world format=\"1\"><robots><robot id=\"r1\"/></robots>\n<changes>\n"
        "<change time=\"3\" path=\"robot[r9]/@x\" value=\"1\"/>\n"
        "<change time=\"2\" path=\"obstacle[+]\"><static_box id=\"a\" x=\"1\"/></change>\n"
        "<change time=\"1\" path=\"robot[r1]/@max_speed\" value=\"fast\"/>\n"
        "<change time=\"4\" path=\"obstacle[+]\"><static_box id=\"a\" x=\"2\"/></change>\n"
        "</changes></world>",
        "small.xml", shipped(), options);
  } catch (const world::WorldError& error) {
    problems = error.what();
  }
  CHECK(problems ==
        "small.xml:3: at 3 s, robot[r9]/@x=1: there is no robot[r9]; there are: r1\n"
        "small.xml:5: at 1 s, robot[r1]/@max_speed=fast: max_speed=\"fast\" of <robot>: expected a "
        "number at least 0 and at most 100 m/s\n"
        "small.xml:6: at 4 s, obstacle[+]=<static_box id=\"a\" x=\"2\"/>: a second box with the id "
        "'a'; the first is there already");
}

TEST_CASE("The world of the start with a run's edits gives the same run") {
  const std::vector<TimedEdit> edits{
      {0.0, {"obstacle[+]", "<static_box id=\"a\" x=\"2\" y=\"2\"/>"}},
      {1.0, {"robot[*]/@max_speed", "0.2"}},
      {2.0, {"robot[+]", "<robot id=\"late\" x=\"-2\" y=\"-2\"/>"}},
      {3.0, {"robot[r2]/@remove", "true"}},
      {4.0, {"physics/@step", "0.005"}}};
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  world::World world = world::read_world(source_path("worlds/ten_robots.xml"), shipped(), options);
  Simulation first(std::move(world), shipped(),
                   {.seed = 3, .data_directories = options.data_directories, .time_limit_s = 6.0});
  const std::uint64_t hash = first.run({}, edits).state_hash;
  Simulation again(first.start(), shipped(),
                   {.seed = 3, .data_directories = options.data_directories, .time_limit_s = 6.0});
  CHECK(again.run().state_hash == hash);
}

TEST_CASE("A goal of time, way or touches that an edit brings counts from then on") {
  ScriptedHost scripted([](const Perception&) { return wheels(10, 10); });
  world::World world;
  world.limits.time = 20;
  world.arena.length = 20;
  world.robots = {robot("r1", -4, 0, 0, behavior("scripted"))};
  const auto ends = [&](const std::string& goal) {
    Simulation simulation(world, scripted.host);
    return simulation.run({}, std::vector<TimedEdit>{{3.0, {"goal[+]", goal}}}).simulated_s;
  };
  CHECK(ends("<endure time=\"4\"/>") == Approx(7));
  const double speed = Simulation(world, scripted.host).run().robots[0].distance_m / 20;
  CHECK(ends("<travel robot=\"r1\" distance=\"1\"/>") == Approx(3 + 1 / speed).margin(0.1));
}

TEST_CASE("A check says which of the world's own edits its run ends before") {
  const Simulation simulation = standing(
      "<limits time=\"2\"/><changes>\n<change time=\"1\" path=\"@name\" value=\"a\"/>\n"
      "<change time=\"9\" path=\"@name\" value=\"b\"/></changes>");
  const auto unmade = simulation.check({});
  REQUIRE(unmade.size() == 1);
  CHECK(unmade[0].from == "small.xml:3");
  CHECK(unmade[0].sentence ==
        "The edits at 9 s are not made: the run ends after 2 s at the latest.");
}

TEST_CASE("All that cannot be made is refused at once") {
  const Simulation simulation = standing("<limits time=\"4\"/>");
  const auto report = [&](std::vector<TimedEdit> edits) {
    try {
      simulation.check(edits);
      return std::string();
    } catch (const simulation::EditRefused& refused) {
      return refused.report();
    }
  };
  const std::string late =
      "its time is 9 s, but the run begins at 0 and ends after 4 s at the latest; expected a time "
      "in between, before the last step begins";
  CHECK(report({{1.0, {"robot[r1]/@max_speed", "fast"}, "study.xml:3"},
                {2.0, {"robot[r7]/@x", "1"}},
                {9.0, {"robot[r1]/@x", "1"}}}) ==
        "--at: robot[r1]/@x=1: " + late +
            "\nstudy.xml:3: at 1 s, robot[r1]/@max_speed=fast: expected a number at least 0 and "
            "at most 100 m/s\n--at: at 2 s, robot[r7]/@x=1: there is no robot[r7]; there are: r1");
  CHECK(report({{1.0, {"obstacle[+]", "<static_box id=\"a\"/>"}},
                {2.0, {"obstacle[b]/@remove", "true"}},
                {3.0, {"obstacle[a]/@width", "-1"}}}) ==
        "--at: at 2 s, obstacle[b]/@remove=true: there is no obstacle[b]; there are: a\n"
        "--at: at 3 s, obstacle[a]/@width=-1: width=\"-1\" of <static_box>: expected a number "
        "at least 1e-04 and at most 1000 m");
}

TEST_CASE("What does not fit the world by then is refused before the run") {
  const Simulation simulation = standing("<limits time=\"4\"/>");
  const auto why = [&](std::vector<TimedEdit> edits) {
    return why_not([&] { simulation.check(edits); });
  };
  const std::string measure = "<path_length robot=\"late\"/>";
  const TimedEdit robot{1.0, {"robot[+]", "<robot id=\"late\" x=\"2\"/>"}};
  CHECK_THAT(why({{2.0, {"measure[+]", measure}}}),
             Catch::StartsWith("at 2 s, measure[+]=" + measure) &&
                 Catch::Contains("there is no robot 'late' in the world; there is 'r1'"));
  CHECK(why({robot, {2.0, {"measure[+]", measure}}}).empty());
  CHECK_THAT(why({robot, {2.0, {"measure[+]", measure}}, {3.0, {"robot[late]/@remove", "true"}}}),
             Catch::StartsWith("at 3 s, robot[late]/@remove=true: "));
  CHECK_THAT(
      why({{2.0,
            {"robot[r1]/coordinator[+]", "<fusion_neural_network training=\"nowhere.txt\"/>"}}}),
      Catch::StartsWith("at 2 s, robot[r1]/coordinator[+]=") && Catch::Contains("nowhere.txt"));
}

TEST_CASE("Edits of later edits are followed before the run") {
  const Simulation simulation = standing("<limits time=\"4\"/>");
  const auto why = [&](const std::string& change) {
    return why_not([&] { simulation.check(std::vector<TimedEdit>{{1.0, {"change[+]", change}}}); });
  };
  CHECK(why("<change time=\"2\" path=\"robot[r1]/@max_speed\" value=\"0.2\"/>").empty());
  CHECK_THAT(why("<change time=\"2\" path=\"robot[r1]/@max_speed\" value=\"fast\"/>"),
             Catch::Contains("robot[r1]/@max_speed=fast") && Catch::Contains("expected a number"));
  CHECK_THAT(why("<change time=\"2\" path=\"robot[r8]/@x\" value=\"1\"/>"),
             Catch::Contains("there is no robot[r8]"));
}

TEST_CASE("What gets another id starts again, which a note says with the time") {
  ScriptedHost scripted([](const Perception&) { return wheels(10, 10); });
  world::World world;
  world.limits.time = 4;
  world.robots = {robot("r1", 0, 0, 0, behavior("scripted"))};
  Simulation simulation(world, scripted.host);
  const RunResult result =
      simulation.run({}, std::vector<TimedEdit>{{2.5, {"robot[r1]/@id", "r9"}}});
  const double all = Simulation(world, scripted.host).run().robots[0].distance_m;
  CHECK(result.robots[0].id == "r9");
  CHECK(result.robots[0].distance_m == Approx(all * 1.5 / 4).margin(0.05));
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0].text ==
        "An edit at 2.5 s sets robot[r1]/@id=r9: an object with another id is a new object and "
        "starts again.");
}

TEST_CASE("What no engine can do is refused before the run") {
  for (const char* engine : {"ode", "planar"}) {
    world::World world = lively();
    world.physics.engine = engine;
    const Simulation simulation(world, shipped());
    const auto refusal = [&](const char* path, const char* value) {
      return why_not([&] { simulation.check(std::vector<TimedEdit>{{1.0, {path, value}}}); });
    };
    const bool is_planar = world.physics.engine == "planar";
    CAPTURE(engine);
    CHECK_THAT(refusal("physics/@engine", is_planar ? "ode" : "planar"),
               Contains("one engine cannot take over the bodies of another"));
    CHECK(refusal("physics/@engine", engine).empty());
    const std::string to_default = refusal("physics", "<physics step='0.01'/>");
    const std::string above_the_floor = refusal("robot[r1]/@z", "1");
    if (is_planar) {
      CHECK_THAT(to_default, Contains("take over the bodies"));
      CHECK_THAT(above_the_floor, Contains("would fall"));
    } else {
      CHECK(to_default.empty());
      CHECK(above_the_floor.empty());
    }
  }
}
