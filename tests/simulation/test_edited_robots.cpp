// What robots keep over edits of a running world, and what their coordinators make of them.
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/plugin/host.h"
#include "elsie/world/reader.h"

#include "change_support.h"

using namespace elsie;
using namespace elsie::test;

namespace {

Simulation simulation_of(const std::string& content) {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  return Simulation(world::parse_world("<world format=\"1\">" + content + "</world>", "small.xml",
                                       shipped(), options),
                    shipped(), {.data_directories = options.data_directories});
}

/// The attributes and content of a coordinator that cannot do without.
std::string needs_of(const std::string& coordinator) {
  const std::string samples =
      " training=\"training_sets/two_sensors_two_behaviors.txt\" seed=\"1\"";
  return coordinator == "fusion_context_blending"
             ? " model=\"" + source_path("tests/plugins/coordinators/contexts.fcl") + "\""
         : coordinator.ends_with("neural_network") ? samples + " presentations=\"2000\""
         : coordinator == "arbiter_learning"       ? " untrained=\"true\""
                                                   : "";
}

/// The coordinator's element, with what it cannot do without.
std::string markup_of(const std::string& coordinator) {
  const std::string inside = coordinator == "arbiter_states" ? "<state name='s' behavior='avoid'/>"
                             : coordinator == "arbiter_tree" ? "<run behavior='avoid'/>"
                             : coordinator == "arbiter_learning" ? "<feature of='battery'/>"
                                                                 : "";
  const std::string program =
      coordinator == "arbiter_remote"
          ? " command=\"while read -r line; do case $line in *'&quot;time&quot;:'*) echo "
            "'{&quot;forward&quot;:0.1}';; *'&quot;end&quot;'*) ;; *) echo '{}';; esac; done\""
          : "";
  return "<" + coordinator + needs_of(coordinator) + program + ">" + inside + "</" + coordinator +
         ">";
}

const std::string kBoth = "<wander id=\"avoid\"/><wander id=\"go\"/>";

std::string robot_of(const std::string& coordinator, const std::string& behaviors) {
  return "<robots><robot id=\"r1\"><sensors><beam_range yaw_deg=\"30\"/><beam_range "
         "yaw_deg=\"-30\"/></sensors><behaviors>" +
         behaviors + "</behaviors><coordinator>" + markup_of(coordinator) +
         "</coordinator></robot></robots>";
}

std::vector<std::string> members_of(const Simulation& simulation) {
  std::vector<std::string> paths;
  for (const simulation::TracedMember& member : simulation.robot(0).trace)
    paths.push_back(member.path);
  return paths;
}

const std::vector<simulation::Edit> kRemoval{{"robot[r1]/behavior[go]/@remove", "true"}};
const std::vector<simulation::Edit> kAddition{{"robot[r1]/behavior[+1]", "<wander/>"}};
const std::vector<simulation::Edit> kReordering{
    {"robot[r1]/behavior[avoid]/@remove", "true"},
    {"robot[r1]/behavior[+]", "<wander id=\"avoid\"/>"}};

}  // namespace

TEST_CASE("Every coordinator takes other behaviours while it runs, or refuses them") {
  for (const Declaration* declaration : shipped().all(PluginKind::coordinator)) {
    const std::string& coordinator = declaration->name;
    CAPTURE(coordinator);
    const bool is_network = coordinator.ends_with("neural_network");
    for (const bool is_nested : {false, true}) {
      const std::string path = is_nested ? "nest/" : "";
      const auto run = [&](const std::vector<simulation::Edit>& edits) {
        Simulation simulation =
            is_nested
                ? simulation_of(
                      "<robots><robot id=\"r1\"><sensors><beam_range yaw_deg=\"30\"/><beam_range "
                      "yaw_deg=\"-30\"/></sensors><behaviors><blend id=\"nest\"><behaviors>" +
                      kBoth + "</behaviors><coordinator>" + markup_of(coordinator) +
                      "</coordinator></blend></behaviors><coordinator><fusion_fuzzy/>"
                      "</coordinator></robot></robots>")
                : simulation_of(robot_of(coordinator, kBoth));
        advance(simulation, 5);
        std::vector<simulation::Edit> all = edits;
        for (simulation::Edit& edit : all) {
          if (is_nested) edit.path.insert(std::string("robot[r1]/").size(), "behavior[nest]/");
        }
        const std::string refused = why_not([&] { simulation.edit(all); });
        advance(simulation, 5);
        return std::pair(members_of(simulation), refused);
      };
      const auto fewer = run(kRemoval), more = run(kAddition), other = run(kReordering);
      const bool fits_its_model = is_network || coordinator == "fusion_context_blending";
      CAPTURE(is_nested, fewer.second, more.second, other.second);
      CHECK(fewer.second.empty() == !fits_its_model);
      CHECK(more.second.empty() == !is_network);
      CHECK(other.second.empty());
      std::vector<std::string> expected{path + "go", path + "avoid"};
      if (is_nested) expected.insert(expected.begin(), "nest");
      CHECK(other.first == expected);
    }
  }
}

TEST_CASE("A priority that is set between two steps decides as an edit of it does") {
  const std::string content =
      "<robots><robot id=\"r1\"><behaviors><wander id=\"out\"/><blend id=\"nest\"><behaviors>"
      "<wander/><go_to_point x=\"1\" "
      "y=\"1\"/></behaviors><coordinator><arbiter_suppression/></coordinator></blend>"
      "</behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>";
  Simulation set = simulation_of(content), edited = simulation_of(content);
  REQUIRE(members_of(set) ==
          std::vector<std::string>{"out", "nest", "nest/wander", "nest/go_to_point"});
  const auto priority = [](const Simulation& simulation, std::size_t behavior) {
    return simulation.robot(0).trace[behavior].member->priority();
  };
  set.set_priority(0, 1, 3.0);
  set.set_priority(0, 3, 2.5);
  const std::vector<simulation::Edit> edits{
      {"robot[r1]/behavior[nest]/@priority", "3"},
      {"robot[r1]/behavior[nest]/behavior[go_to_point]/@priority", "2.5"}};
  edited.edit(edits);
  for (Simulation* simulation : {&set, &edited}) advance(*simulation, 50);
  CHECK(priority(set, 3) == 2.5);
  CHECK(set.robot(0).trace[3].member->trace.share == 1.0);
  CHECK(set.state_hash() == edited.state_hash());
  CHECK_THROWS_AS(set.set_priority(0, 4, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(set.set_priority(0, 0, std::nan("")), std::invalid_argument);
  set.reset();
  CHECK(priority(set, 1) == 1.0);
  CHECK(priority(set, 3) == 1.0);
}

TEST_CASE("A network for the first behaviours of a robot has to be trained") {
  for (const char* const coordinator : {"arbiter_neural_network", "fusion_neural_network"}) {
    Simulation simulation = simulation_of(robot_of(coordinator, ""));
    advance(simulation, 3);
    std::vector<simulation::Edit> edits{{"robot[r1]/behavior[+]", "<wander id=\"avoid\"/>"},
                                        {"robot[r1]/behavior[+]", "<wander id=\"go\"/>"}};
    const std::string refused = why_not([&] { simulation.edit(edits); });
    CAPTURE(refused);
    CHECK(refused.find("put a coordinator with another id in its place") != std::string::npos);
    advance(simulation, 3);
    edits.push_back({"robot[r1]/coordinator", "<" + std::string(coordinator) + " id=\"new\"" +
                                                  needs_of(coordinator) + "/>"});
    simulation.edit(edits);
    advance(simulation, 3);
    CHECK(simulation.robot(0).trace[0].member->trace.asked);
  }
}

TEST_CASE("A winner that holds on stays the same behaviour at another place") {
  // The first to win holds for good, though the others are as active.
  Simulation simulation = simulation_of(
      "<robots><robot id=\"r1\"><behaviors><wander id=\"a\"/><wander id=\"b\"/></behaviors>"
      "<coordinator><arbiter_action_selection hold=\"100\"/></coordinator></robot></robots>");
  advance(simulation, 3);
  simulation.edit("robot[r1]/behavior[+1]", "<wander id=\"c\"/>");
  simulation.step();
  REQUIRE(members_of(simulation) == std::vector<std::string>{"c", "a", "b"});
  CHECK(simulation.robot(0).trace[1].member->trace.weight == 1.0);
}

TEST_CASE("A robot on a synchro drive keeps its heading over edits of its body") {
  for (const simulation::Edit& edit : {simulation::Edit{"robot[r1]/body/@mass", "3"},
                                       simulation::Edit{"robot[r1]/drive/@steer_rate_deg_s", "200"},
                                       simulation::Edit{"robot[r1]/segment[+]", "<segment/>"},
                                       simulation::Edit{"robot[r1]/drive/@remove", "true"}}) {
    CAPTURE(edit.text());
    Simulation simulation = simulation_of(
        "<robots><robot id=\"r1\"><drive><synchro/></drive><behaviors><go_to_point x=\"-2\" "
        "y=\"2\"/></behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>");
    advance(simulation, 200);
    const Pose before = simulation.robot(0).pose;
    REQUIRE(before.heading_rad > 1.0);  // the chassis points to the east as ever
    simulation.edit(edit.path, edit.value);
    const Pose& now = simulation.robot(0).pose;
    CHECK(now.heading_rad == Approx(before.heading_rad).margin(1e-9));
    CHECK(now.x == before.x);
    advance(simulation, 10);
    CHECK(now.heading_rad == Approx(before.heading_rad).margin(0.2));
  }
}

TEST_CASE("There is room beside the chassis of a robot, wherever its turret points") {
  // Long and narrow, on wheels that have turned by a right angle.
  Simulation simulation = simulation_of(
      "<robots><robot id=\"r1\"><body length=\"0.6\" width=\"0.2\"/><drive><synchro "
      "radius=\"0.05\"/></drive><behaviors><go_to_point x=\"0\" y=\"2\" "
      "speed=\"0.05\"/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>"
      "</robots>");
  advance(simulation, 200);
  const Pose pose = simulation.robot(0).pose;
  REQUIRE(pose.heading_rad > 1.4);
  const auto box_at = [&](double ahead, double left) {
    return "<static_box length=\"0.1\" width=\"0.1\" x=\"" + std::to_string(pose.x + ahead) +
           "\" y=\"" + std::to_string(pose.y + left) + "\"/>";
  };
  CHECK(why_not([&] {
          simulation.edit("obstacle[+]", box_at(0.25, 0));
        }).find("overlaps the robot 'r1'") != std::string::npos);
  CHECK(why_not([&] { simulation.edit("obstacle[+]", box_at(0, 0.25)); }) == "");
}

TEST_CASE("What a coordinator holds outlives edits of the robot, made or refused") {
  // It stands before a box that is taken away: the upper layer falls silent.
  const std::string holding =
      "<obstacles><static_box id=\"box\" x=\"0.4\" width=\"2\"/></obstacles><robots><robot "
      "id=\"r1\"><sensors><beam_range/></sensors><behaviors><wander id=\"low\"/><avoid_obstacle "
      "id=\"high\"/></behaviors><coordinator><arbiter_subsumption hold=\"100\"/></coordinator>"
      "</robot></robots>";
  const std::string in_the_way = "<static_box id=\"late\" length=\"1\" width=\"1\"/>";
  const std::vector<simulation::Edit> edits{{"robot[r1]/@team", "blue"},
                                            {"robot[r1]/sensor[+]", "<beam_range/>"},
                                            {"robot[r1]/drive[+]", "<skid_steer/>"},
                                            {"robot[r1]/behavior[+1]", "<wander id=\"lowest\"/>"}};
  for (const bool are_refused : {false, true}) {
    Simulation simulation = simulation_of(holding);
    const auto reason = [&] {
      for (const simulation::TracedMember& member : simulation.robot(0).trace) {
        if (member.path == "high") return std::string(member.member->trace.reason);
      }
      return std::string();
    };
    advance(simulation, 10);
    simulation.edit("obstacle[box]/@remove", "true");
    advance(simulation, 10);
    REQUIRE(reason() == "held");
    for (const simulation::Edit& edit : edits) {
      std::vector<simulation::Edit> all{edit};
      if (are_refused) all.push_back({"obstacle[+]", in_the_way});
      const std::string why = why_not([&] { simulation.edit(all); });
      CAPTURE(edit.text(), why);
      CHECK(why.empty() != are_refused);
      simulation.step();
      CHECK(reason() == "held");
    }
  }
}

TEST_CASE("A robot that leans on a charger has met it once, whatever is edited") {
  const auto collisions = [](bool edited) {
    Simulation simulation = simulation_of(
        "<chargers><charger x=\"0.4\" seen_by_range_sensors=\"true\"/></chargers><robots>"
        "<robot id=\"r1\"><behaviors><wander restlessness=\"0\" turn=\"0\"/></behaviors>"
        "<coordinator><arbiter_suppression/></coordinator></robot></robots>");
    for (int i = 0; i < 40; ++i) {
      advance(simulation, 10);
      if (edited) simulation.edit("arena/@wall_height", std::to_string(0.5 + 0.001 * i));
    }
    return simulation.robot(0).collisions;
  };
  CHECK(collisions(false) > 0);
  CHECK(collisions(true) == collisions(false));
}
