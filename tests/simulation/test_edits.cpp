// Edits of a world that runs: it becomes what the edited file would describe, and all that an edit
// does not concern goes on.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/recording/csv_recorder.h"
#include "elsie/recording/mcap_recorder.h"
#include "elsie/traces/account_recorder.h"
#include "elsie/traces/tracks.h"

#include "lively.h"

using namespace elsie;
using namespace elsie::test;
using simulation::RunResult;
using simulation::TimedEdit;

TEST_CASE("A run with an edit of no consequence is one without") {
  const std::uint64_t plain = hash_after(300, {});
  const std::vector<simulation::Edit> edits{{"@name", "another"},
                                            {"arena/@wall_height", "0.4"},
                                            {"physics/@gravity", "-9.81"},
                                            {"obstacle[mast]/@colour", "#123456"},
                                            {"goal[1]/@radius", "0.02"},
                                            {"limits/@time", "7"},
                                            {"resource[food]/@energy", "5"},
                                            {"team[+]", "<team id=\"green\"/>"},
                                            {"lamp[+]", "<lamp x=\"1\"/>"},
                                            {"floor/@colour", "#123456"},
                                            {"patch[+]", "<disc_patch radius=\"1\"/>"}};
  for (const simulation::Edit& edit : edits) {
    CAPTURE(edit.text());
    CHECK(hash_after(300, {{131, edit}}) == plain);
  }
}

TEST_CASE("The same edits at the same steps give the same run, bit for bit; others another one") {
  const std::vector<std::pair<int, simulation::Edit>> edits{
      {50, {"physics/@step", "0.005"}},
      {80, {"robot[r3]/@remove", "true"}},
      {120, {"obstacle[+]", "<static_box x=\"0\" y=\"-2\"/>"}},
      {140, {"robot[r1]/behavior[+]", "<wander id=\"other\" restlessness=\"9\"/>"}},
      {160,
       {"robot[+]",
        "<robot id=\"r9\" x=\"2\"><behaviors><wander/></behaviors><coordinator>"
        "<arbiter_suppression/></coordinator></robot>"}},
      {200, {"robot[r1]/coordinator", "<arbiter_suppression/>"}}};
  const std::uint64_t first = hash_after(400, edits);
  CHECK(first == hash_after(400, edits));
  for (std::size_t i = 0; i < edits.size(); ++i) {
    auto fewer = edits;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    CAPTURE(edits[i].second.text());
    CHECK(first != hash_after(400, fewer));
  }
}

TEST_CASE("A reset forgets edits") {
  Simulation simulation(lively(), shipped(), {7});
  const std::vector<TimedEdit> edits{{1.0, {"physics/@step", "0.005"}},
                                     {2.0, {"robot[r1]/@remove", "true"}}};
  // A goal names r1.
  CHECK_THROWS_AS(simulation.run({}, edits), EditRefused);
  const std::vector<TimedEdit> good{{1.0, {"physics/@step", "0.005"}},
                                    {2.0, {"robot[r3]/@remove", "true"}}};
  const RunResult edited = simulation.run({}, good);
  CHECK(simulation.robots() == 2);
  simulation.reset();
  CHECK(simulation.robots() == 3);
  CHECK(simulation.run().state_hash == Simulation(lively(), shipped(), {7}).run().state_hash);
  simulation.reset();
  CHECK(simulation.run({}, good).state_hash == edited.state_hash);

  simulation.reset();
  const std::uint64_t unchanged = simulation.run().state_hash;
  simulation.reset();
  const std::vector<TimedEdit> in_place{{1.0, {"robot[r1]/@leader", "false"}},
                                        {1.0, {"robot[r1]/@coverage", "3"}},
                                        {1.0, {"robot[r2]/@energy", "77"}},
                                        {1.0, {"robot[r2]/sensor[ahead]/@energy_cost", "50"}},
                                        {1.0, {"robot[r1]/@x", "-2"}}};
  CHECK(simulation.run({}, in_place).state_hash != unchanged);
  CHECK(simulation.robot(1).state->energy < 77);
  simulation.reset();
  CHECK(simulation.robot(0).state->is_leader);
  CHECK(simulation.robot(0).state->coverage_m == 0.5);
  CHECK(simulation.robot(0).pose.x == Approx(-1));
  CHECK(simulation.robot(1).state->energy == 5000);
  CHECK(simulation.events().empty());
  CHECK(simulation.run().state_hash == unchanged);
}

TEST_CASE("Without gravity a falling box goes on at its speed") {
  Simulation simulation =
      of("<obstacles><dynamic_box id=\"crate\" x=\"2\" z=\"3\"/></obstacles>", "");
  advance(simulation, 20);
  simulation.edit("physics/@gravity", "0");
  // The engine has no height to look at; robots have: one that falls.
  simulation.edit("robot[r1]/@z", "2");
  advance(simulation, 50);
  CHECK(simulation.robot(0).pose.x == Approx(0).margin(1e-6));
  simulation.edit("robot[r1]/sensor[+]", "<beam_range id=\"ahead\"/>");
  const double height = simulation.sensor_frame(0, 0).origin.z;
  CHECK(height == Approx(2.09).margin(1e-3));
  simulation.edit("physics/@gravity", "-9.81");
  advance(simulation, 20);
  CHECK(simulation.sensor_frame(0, 0).origin.z < height - 0.1);
}

TEST_CASE("With half the step a robot drives on smoothly, and time goes on") {
  Simulation simulation = of("",
                             "<behaviors><wander restlessness=\"0\" turn=\"0\"/></behaviors>"
                             "<coordinator><arbiter_suppression/></coordinator>");
  advance(simulation, 100);
  const double before_x = simulation.robot(0).pose.x;
  const double speed = simulation.robot(0).moving.forward;
  simulation.edit("physics/@step", "0.005");
  CHECK(simulation.time_s() == Approx(1.0));
  simulation.step();
  CHECK(simulation.time_s() == Approx(1.005));
  CHECK(simulation.robot(0).moving.forward == Approx(speed).margin(0.01));
  CHECK(simulation.robot(0).pose.x == Approx(before_x + 0.005 * speed).margin(1e-3));
  advance(simulation, 199);
  CHECK(simulation.time_s() == Approx(2.0));
}

TEST_CASE(
    "A robot meets an obstacle that was dropped in its way, and not one that was taken away") {
  const char* const driver =
      "<behaviors><wander restlessness=\"0\" turn=\"0\"/></behaviors>"
      "<coordinator><arbiter_suppression/></coordinator>";
  const auto x_after = [&](bool dropped, bool taken) {
    Simulation simulation = of("", driver);
    advance(simulation, 50);
    const double x = simulation.robot(0).pose.x;
    const std::string at = std::to_string(x + 0.4);
    if (dropped) {
      simulation.edit("obstacle[+]", "<static_box id=\"block\" width=\"1\" x=\"" + at + "\"/>");
    }
    advance(simulation, 20);
    if (taken) {
      simulation.edit("obstacle[block]/@remove", "true");
    }
    advance(simulation, 400);
    return std::pair(simulation.robot(0).pose.x - x, simulation.robot(0).collisions);
  };
  const auto free = x_after(false, false), blocked = x_after(true, false),
             again = x_after(true, true);
  REQUIRE(free.first > 0.5);
  CHECK(free.second == 0);
  CHECK(blocked.first < 0.4);
  CHECK(blocked.second > 0);
  CHECK(again == free);
}

TEST_CASE("A sensor that was added, turned or taken away is perceived so") {
  Simulation simulation =
      of("<obstacles><static_box id=\"block\" x=\"0.5\" width=\"0.4\"/></obstacles>",
         "<sensors><beam_range id=\"ahead\"/></sensors>");
  const auto seen = [&](std::size_t sensor) {
    return test::numbers_of(simulation, 0, sensor).front();
  };
  advance(simulation, 3);
  const double ahead = seen(0);
  simulation.edit("robot[r1]/sensor[+]", "<beam_range id=\"behind\" yaw_deg=\"180\"/>");
  REQUIRE(simulation.sensors(0) == 2);
  advance(simulation, 2);
  CHECK(seen(0) == Approx(ahead).margin(0.02));
  CHECK(seen(1) > ahead + 0.1);
  simulation.edit("robot[r1]/sensor[ahead]/@yaw_deg", "180");
  advance(simulation, 2);
  CHECK(seen(0) == Approx(seen(1)).margin(0.05));
  simulation.edit("robot[r1]/sensor[ahead]/@remove", "true");
  REQUIRE(simulation.sensors(0) == 1);
  CHECK(simulation.sensor(0, 0).id == "behind");
}

TEST_CASE("A behaviour that was added acts, and the others keep their objects") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 50);
  const auto members = [&] {
    std::vector<std::string> paths;
    for (const auto& member : simulation.robot(1).trace) {
      paths.push_back(member.path);
    }
    return paths;
  };
  const auto notes_of_r2 = [&] {  // measures have theirs, too
    const auto notes = simulation.notes();
    return std::count_if(notes.begin(), notes.end(),
                         [](const simulation::Note& note) { return note.robot == "r2"; });
  };
  CHECK(notes_of_r2() == 0);
  simulation.edit("robot[r2]/behavior[+]", "<wander id=\"second\" priority=\"0\"/>");
  CHECK(members() == std::vector<std::string>{"wander", "second"});
  advance(simulation, 1);
  simulation.edit("robot[r2]/behavior[wander]/@remove", "true");
  CHECK(members() == std::vector<std::string>{"second"});
  advance(simulation, 5);
  CHECK(simulation.robot(1).trace[0].member->trace.asked);
  CHECK(notes_of_r2() == 0);
  // One of the same plugin stays. One that is replaced under its id says that it has lost its
  // memory.
  simulation.edit("robot[r2]/behavior[second]", "<wander restlessness=\"4\"/>");
  CHECK(notes_of_r2() == 0);
  simulation.edit("robot[r2]/behavior[second]", "<go_to_point x=\"1\" y=\"1\"/>");
  REQUIRE(notes_of_r2() == 1);
  CHECK(std::any_of(simulation.notes().begin(), simulation.notes().end(),
                    [](const simulation::Note& note) { return note.plugin == "second"; }));
}

TEST_CASE("What one edit of a step adds, another one may set") {
  Simulation simulation(lively(), shipped());
  const std::vector<simulation::Edit> both{
      {"obstacle[+]", "<static_box id=\"late\" x=\"1\" y=\"2.5\"/>"}, {"obstacle[late]/@y", "2"}};
  simulation.edit(both);
  const auto& obstacles = simulation.world().obstacles;
  const auto late = std::find_if(obstacles.begin(), obstacles.end(),
                                 [](const world::Obstacle& box) { return box.id == "late"; });
  REQUIRE(late != obstacles.end());
  CHECK(late->y == 2.0);
}

TEST_CASE("What other robots do is not touched by an edit of one") {
  // They are far apart, and do not see each other.
  const auto path_of_r1 = [](bool edited) {
    Simulation simulation(lively(), shipped(), {7});
    advance(simulation, 60);
    if (edited) {
      simulation.edit("robot[r3]/coordinator", "<fusion_vector_summation/>");
      simulation.edit("robot[r3]/body/@length", "0.1");
    }
    advance(simulation, 60);
    return simulation.robot(0).pose;
  };
  CHECK(path_of_r1(true) == path_of_r1(false));
}

TEST_CASE("Robots come and go, and their teams know it") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 10);
  const std::uint64_t before = simulation.state_hash();
  simulation.edit("robot[+]", "<robot id=\"r9\" x=\"2\" leader=\"true\" coverage=\"9\"/>");
  REQUIRE(simulation.robots() == 4);
  CHECK(simulation.robot(3).description->id == "r9");
  CHECK(simulation.robot(3).state->team_index == 3);
  CHECK(simulation.state_hash() != before);
  simulation.edit("robot[r2]/@remove", "true");
  REQUIRE(simulation.robots() == 3);
  CHECK(simulation.robot(2).state->team_index == 2);
  advance(simulation, 10);
  CHECK(simulation.robot(2).pose.x == Approx(2).margin(1e-6));
}

TEST_CASE("A robot with another body keeps its place, speed, energy and way") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 100);
  const auto before = *simulation.robot(2).state;
  const double way = simulation.robot(2).distance_m;
  simulation.edit("robot[r3]/body/@length", "0.1");
  const OwnState& now = *simulation.robot(2).state;
  CHECK(now.pose == before.pose);
  CHECK(now.moving.forward == Approx(before.moving.forward).margin(1e-6));
  CHECK(now.energy == before.energy);
  CHECK(now.length_m == 0.1);
  CHECK(simulation.robot(2).distance_m == way);
  simulation.edit("robot[r3]/drive[+]", "<mecanum/>");
  CHECK(simulation.robot(2).state->channels.lateral);
  CHECK(simulation.robot(2).pose == before.pose);
  advance(simulation, 50);
}

TEST_CASE("Goals and limits count from their edit on") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 10);
  simulation.edit("goal[1]", "<travel robot=\"r1\" distance=\"0.001\"/>");
  advance(simulation, 100);
  CHECK(simulation.outcome() == simulation::Outcome::success);

  Simulation limited(lively(), shipped(), {7});
  limited.edit("limits/@time", "0.5");
  advance(limited, 60);
  CHECK(limited.outcome() == simulation::Outcome::time_limit);
}

TEST_CASE("A collected resource stays away, a box that moves goes on") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 200);
  const auto cart = simulation.obstacle(2);
  REQUIRE(cart);
  simulation.edit("obstacle[mast]/@remove", "true");
  REQUIRE(simulation.obstacle(1));
  CHECK(*simulation.obstacle(1) == *cart);
  simulation.step();
  CHECK(std::abs(simulation.obstacle(1)->x - cart->x) == Approx(0.001).margin(1e-9));
}

TEST_CASE("Edits are events, with which recorders go on") {
  TemporaryFile table, recording;
  const auto run = [&](bool with_observers) {
    Simulation simulation(lively(), shipped(), {7});
    const auto csv = recording::csv_recorder(table.path, {.rate_hz = 10});
    const auto mcap = recording::mcap_recorder(recording.path);
    traces::TrackRecorder tracks;
    traces::AccountRecorder accounts;
    std::vector<simulation::Observer*> all{csv.get(), mcap.get(), &tracks, &accounts};
    if (!with_observers) {
      all.clear();
    }
    const RunResult result = simulation.run(
        all,
        std::vector<TimedEdit>{{1.0, {"robot[r2]/@remove", "true"}},
                               {1.5, {"physics/@step", "0.004"}},
                               {2.0, {"robot[r1]/sensor[ahead]/@remove", "true"}},
                               {2.0, {"robot[r1]/behavior[+]", "<wander id=\"more\"/>"}},
                               {3.0,
                                {"robot[+]",
                                 "<robot id=\"r9\" x=\"2\"><behaviors><wander/></behaviors>"
                                 "<coordinator><arbiter_suppression/></coordinator></robot>"}}});
    if (with_observers) {
      CHECK(tracks.tracks().size() == 3);
      REQUIRE(accounts.accounts().size() == 5);  // r1 has two: its behaviours changed
      CHECK(accounts.robots()[1].id == "r2");
      CHECK(accounts.accounts()[1].span.to_s == Approx(1.0).margin(0.01));
      CHECK(accounts.robots()[3].id == "r1");
      CHECK(accounts.accounts()[3].span.from_s == Approx(2.0).margin(0.1));
      CHECK(accounts.robots()[4].id == "r9");
      CHECK(accounts.accounts()[4].span.from_s == Approx(3.0).margin(0.1));
      CHECK(tracks.tracks()[2].from_s == Approx(3.1).margin(0.11));
      CHECK(tracks.tracks()[0].path.size() == 61);  // whatever the length of a step
    }
    return result;
  };
  const RunResult watched = run(true), alone = run(false);
  CHECK(watched.state_hash == alone.state_hash);
  CHECK(watched.simulated_s == Approx(6.0).margin(0.005));
  std::vector<std::string> edits;
  for (const auto& event : watched.events) {
    if (event.as<events::Changed>()) {
      edits.push_back(event.robot + " " + event.detail());
    }
  }
  REQUIRE(edits.size() == 5);
  CHECK(edits[0] == "r2 robot[r2]/@remove=true");
  CHECK(edits[1] == " physics/@step=0.004");
  CHECK(edits[2] == "r1 robot[r1]/sensor[ahead]/@remove=true");
}

TEST_CASE("What is edited of the changes that stand in the world counts, if its time is to come") {
  world::World world = lively();
  world.edits.push_back({2.0, "robot[r2]/@max_speed", "0", {}, {}});
  world.edits.push_back({3.0, "robot[r3]/@remove", "true", {}, {}});
  const auto edit = [](const std::string& time) {
    return "<change time=\"" + time + "\" path=\"@name\" value=\"at " + time + "\"/>";
  };
  Simulation simulation(world, shipped());
  const RunResult result =
      simulation.run({}, std::vector<TimedEdit>{{1.0, {"change[+]", edit("1.015")}},
                                                {1.01, {"change[+]", edit("4")}},
                                                {1.5, {"change[2]/@remove", "true"}}});
  std::vector<std::string> made;
  for (const auto& event : result.events) {
    if (event.as<events::Changed>()) made.push_back(event.detail());
  }
  CHECK(made == std::vector<std::string>{"change[+]=" + edit("1.015"), "change[+]=" + edit("4"),
                                         "@name=at 1.015", "change[2]/@remove=true",
                                         "robot[r2]/@max_speed=0", "@name=at 4"});
  CHECK(simulation.robots() == 3);
  simulation.reset();
  advance(simulation, 150);
  CHECK(refusal(simulation, "change[+]", edit("1.2"))
            .find("the run is at 1.5 s already; expected a later time") != std::string::npos);
  CHECK(refusal(simulation, "change[+]", edit("99")).find("ends after 6 s") != std::string::npos);
}

TEST_CASE("Edits of one instant are made in the order given, whatever they cost") {
  const std::string r3 = "<robot id=\"r3\" x=\"1\" heading_deg=\"-90\" max_speed=\"0.3\"/>";
  const auto speed_after = [&](std::vector<simulation::Edit> edits) {
    Simulation simulation(lively(), shipped());
    simulation.edit(edits);
    return simulation.robot(2).state->max_speed_m_s;
  };
  CHECK(why_not([&] {
          speed_after({{"robot[r3]/@max_speed", "0.1"}, {"robot[r3]", r3}});
        }).find("this replaces the element in which") != std::string::npos);
  CHECK(speed_after(
            {{"robot[r3]/@max_speed", "0.1"}, {"robot[r3]/@remove", "true"}, {"robot[+]", r3}}) ==
        0.3);
  CHECK(speed_after({{"robot[r3]", r3}, {"robot[r3]/@max_speed", "0.1"}}) == 0.1);
}

TEST_CASE("What is put in place by itself is put in place together with what is created again") {
  Simulation simulation(lively(), shipped(), {7});
  advance(simulation, 100);
  const OwnState before = *simulation.robot(0).state;
  REQUIRE(before.pose.x != -1);
  // As they are described, and not as they are.
  simulation.edit(std::vector<simulation::Edit>{{"robot[r1]/@x", "-1"},
                                                {"robot[r1]/@energy", "7"},
                                                {"robot[r1]/@energy", "7"},
                                                {"robot[r1]/behavior[wander]/@turn", "2"},
                                                {"@name", "edited"}});
  const OwnState& now = *simulation.robot(0).state;
  CHECK(now.pose.x == -1);
  CHECK(now.pose.y == before.pose.y);
  CHECK(now.pose.heading_rad == Approx(before.pose.heading_rad).margin(1e-9));
  CHECK(now.energy == 7);
  for (const simulation::Note& note : simulation.notes()) CHECK(note.robot.empty());
  CHECK(std::get<double>(simulation.world().robots[0].behaviors[0].parameters.at("turn")) == 2);
}

TEST_CASE("What an edit sets has the warnings of the physics, each once") {
  Simulation simulation(lively(), shipped(), {7});
  const auto warnings = [&] {
    std::string texts;
    for (const simulation::Note& note : simulation.notes()) {
      texts += note.text.find("warning") != std::string::npos ? note.text + "\n" : "";
    }
    return texts;
  };
  CHECK(warnings() == "");
  advance(simulation, 200);
  simulation.edit("physics/@cfm", "0");
  CHECK_THAT(warnings(), Catch::StartsWith("warning after an edit at 2 s: cfm is 0: "));
  const std::string first = warnings();
  simulation.edit("arena/@length", "7");
  CHECK(warnings() == first);
  simulation.edit("robot[r1]/@max_speed", "20");
  CHECK_THAT(warnings(), Catch::StartsWith(first) &&
                             Catch::Contains("the robot 'r1' moves up to 0.2 m in a step"));
}

TEST_CASE("Measures of all robots count those that an edit removed") {
  const auto measures = [](std::vector<TimedEdit> edits) {
    Simulation simulation(lively(), shipped(), {7});
    std::map<std::string, double> values;
    for (const simulation::MeasuredValue& measured : simulation.run({}, edits).measures) {
      values[measured.name] = measured.value.value_or(-1.0);
    }
    return values;
  };
  const auto all = measures({}), late = measures({{5.99, {"robot[r3]/@remove", "true"}}});
  CHECK(late.at("path_length_m") == Approx(all.at("path_length_m")).margin(0.05));
  CHECK(late.at("path_length_m") > 0.1);
  CHECK(late.at("collisions") == all.at("collisions"));
  CHECK(late.at("collected") == all.at("collected"));
}

TEST_CASE("The event of an edit names each robot that its path leads to") {
  Simulation simulation(lively(), shipped(), {7});
  const auto robots = [&](const std::string& path, const std::string& value) {
    const std::size_t before = simulation.events().size();
    simulation.edit(path, value);
    std::string ids;
    for (const auto& event : simulation.events().subspan(before)) {
      ids += ids.empty() ? event.robot : " " + event.robot;
    }
    return ids;
  };
  CHECK(robots("robot[2]/sensor[ahead]/@remove", "true") == "r2");
  CHECK(robots("robot[*]/body/@mass", "1.5") == "r1 r2 r3");
  CHECK(robots("coordinator", "<arbiter_suppression/>") == "r1 r2 r3");
  CHECK(robots("robot[r3]/behavior[+]", "<wander id=\"more\"/>") == "r3");
  CHECK(robots("arena/@length", "7") == "");
  CHECK(robots("robot[+]", "<robot id=\"r4\" x=\"2\"/>") == "");
}
