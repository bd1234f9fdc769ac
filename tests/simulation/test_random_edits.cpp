// Random edits of the shipped worlds while they run.
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/number_text.h"
#include "elsie/editing/document.h"
#include "elsie/world/data_directories.h"
#include "elsie/world/reader.h"
#include "elsie/world/same.h"
#include "elsie/world/writer.h"

#include "../editing/random_edits.h"
#include "change_support.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr unsigned kSeed = 15;

// ELSIE_TEST_EDITS asks for other numbers of edits in all.
int edits_of_each_world(std::size_t worlds) {
  const char* const asked = std::getenv("ELSIE_TEST_EDITS");
  return asked ? std::atoi(asked) / static_cast<int>(worlds) + 1 : 120;
}

simulation::Edit change_of(const std::string& edit) {
  const std::size_t equals = edit.find('=');
  return {edit.substr(0, equals), edit.substr(equals + 1)};
}

bool needs_cameras(const world::World& world) {
  for (const world::Robot& robot : world.robots) {
    for (const world::MountedUse& sensor : robot.sensors) {
      if (sensor.plugin == "vision") {
        return true;
      }
    }
  }
  return false;
}

/// Edits that are made together, and what they are of: "behavior reordered".
struct Drawn {
  std::string kind;
  std::vector<std::string> edits;
  bool moves_bodies = true;  // or makes others
};

/// Draws edits that mostly can be made, of every kind.
class RunningEdits {
 public:
  RunningEdits(unsigned seed, const plugin::Host& host) : random_(seed, host) {}

  Drawn next(const world::World& world) {
    world_ = &world;
    if (world.robots.empty()) return robots();  // any edit may have removed the last one
    if (random_.happens(0.1)) {
      // Names of elements without an id, and numbers of teams that are there by themselves, depend
      // on what else there is.
      std::string edit;
      do {
        edit = random_.next(world);
      } while (edit.find("=<") != std::string::npos || edit.find("/@id") != std::string::npos ||
               edit.starts_with("team"));
      return {"any", {edit}};
    }
    const auto& draw = kinds_[random_.below(kinds_.size())];
    return (this->*draw)();
  }

 private:
  using Attributes = std::vector<std::pair<std::string, std::vector<std::string>>>;

  template <class Range>
  const auto& one_of(const Range& range) {
    return range[random_.below(range.size())];
  }
  std::string new_id() { return "new" + std::to_string(++count_); }
  std::string number(double low, double high) {
    return base::number_text(low + (high - low) * static_cast<double>(random_.below(1000)) / 1000);
  }
  std::string place() {
    const world::Arena& arena = world_->arena;
    return " x=\"" + number(-0.45 * arena.length, 0.45 * arena.length) + "\" y=\"" +
           number(-0.45 * arena.width, 0.45 * arena.width) + "\"";
  }
  std::string set(const std::string& path, const Attributes& attributes) {
    const auto& [name, values] = one_of(attributes);
    return path + "/@" + name + "=" + one_of(values);
  }
  const world::Robot& robot() { return one_of(world_->robots); }

  /// What is done to an element of a list: `things` have ids, `attributes` can be set, `markup` is
  /// that of a new one with an id.
  template <class Things>
  Drawn in_list(const std::string& start, const std::string& name, const Things& things,
                const Attributes& attributes,
                const std::function<std::string(const std::string& id)>& markup, bool moves_bodies,
                std::size_t least = 0) {
    const std::size_t way = random_.below(5);
    const auto drawn = [&](const char* done, std::vector<std::string> edits) {
      return Drawn{name + " " + done, std::move(edits), moves_bodies};
    };
    const std::string add = start + name + (random_.happens(0.5) ? "[+]=" : "[+1]=");
    if (way == 0 || things.size() <= least) {
      return drawn("added", {add + markup(new_id())});
    }
    const std::string id = one_of(things).id;
    const std::string path = start + name + "[" + id + "]";
    switch (way) {
      case 1:
        return drawn("removed", {path + "/@remove=true"});
      case 2:
        return drawn("replaced", {path + "=" + markup(id)});
      case 3:
        return drawn("reordered", {path + "/@remove=true", add + markup(id)});
      default:
        return drawn("set", {set(path, attributes)});
    }
  }

  Drawn robots() {
    return in_list(
        "", "robot", world_->robots,
        {{"max_speed", {"0.1", "0.3"}},
         {"coverage", {"0.5", "5"}},
         {"leader", {"true", "false"}},
         {"team", {"red", "blue"}},
         {"battery", {"1e6", "2e6"}},
         {"heading_deg", {"10", "-130"}},
         {"body/@mass", {"1", "2.5"}}},
        [&](const std::string& id) {
          return "<robot id=\"" + id + "\"" + place() +
                 "><sensors><beam_range/></sensors><behaviors><wander/></behaviors><coordinator>"
                 "<arbiter_suppression/></coordinator></robot>";
        },
        true, 1);
  }
  Drawn behaviors() {
    const world::Robot& on = robot();
    return in_list(
        "robot[" + on.id + "]/", "behavior", on.behaviors, {{"priority", {"0.5", "2"}}},
        [&](const std::string& id) {
          return one_of(std::vector<std::string>{"<wander", "<go_to_point x=\"1\"",
                                                 "<wander restlessness=\"3\""}) +
                 " id=\"" + id + "\"/>";
        },
        false);
  }
  Drawn sensors() {
    const world::Robot& on = robot();
    return in_list(
        "robot[" + on.id + "]/", "sensor", on.sensors,
        {{"yaw_deg", {"20", "-70"}}, {"energy_cost", {"0", "2"}}},
        [&](const std::string& id) {
          return one_of(std::vector<std::string>{"<beam_range", "<proximity"}) + " id=\"" + id +
                 "\" yaw_deg=\"" + number(-90, 90) + "\"/>";
        },
        false);
  }
  Drawn obstacles() {
    std::vector<world::Obstacle> obstacles;
    for (const world::Obstacle& box : world_->obstacles) {
      if (box.kind != world::ObstacleKind::resource) obstacles.push_back(box);
    }
    return in_list(
        "", "obstacle", obstacles,
        {{"colour", {"#123456"}}, {"height", {"0.3", "0.5"}}, {"heading_deg", {"12", "0"}}},
        [&](const std::string& id) {
          const std::string kind = one_of(std::vector<std::string>{"static", "dynamic", "moving"});
          const std::string head = "<" + kind + "_box id=\"" + id + "\"" + place();
          return kind == "moving" ? head + " speed=\"0.1\"><waypoint" + place() + "/></moving_box>"
                                  : head + "/>";
        },
        true);
  }
  Drawn resources() {
    std::vector<world::Obstacle> obstacles;
    for (const world::Obstacle& box : world_->obstacles) {
      if (box.kind == world::ObstacleKind::resource) obstacles.push_back(box);
    }
    return in_list(
        "", "resource", obstacles, {{"energy", {"1", "5"}}, {"length", {"0.1", "0.2"}}},
        [&](const std::string& id) { return "<resource id=\"" + id + "\"" + place() + "/>"; },
        true);
  }
  Drawn chargers() {
    return in_list(
        "", "charger", world_->chargers,
        {{"radius", {"0.3", "1"}}, {"seen_by_range_sensors", {"true", "false"}}},
        [&](const std::string& id) { return "<charger id=\"" + id + "\"" + place() + "/>"; }, true);
  }
  Drawn measures() {
    return in_list(
        "", "measure", world_->measures, {{"id", {"one", "two"}}},
        [&](const std::string& id) {
          return "<" + one_of(std::vector<std::string>{"path_length", "collisions"}) + " id=\"" +
                 id + "\"/>";
        },
        false);
  }
  Drawn goals() {
    const std::string goal =
        one_of(std::vector<std::string>{"<endure time=\"1000\"/>", "<travel distance=\"1000\"/>",
                                        "<event name=\"collected\" count=\"1000\"/>",
                                        "<any><endure time=\"1000\"/><all><travel any=\"true\" "
                                        "distance=\"1000\"/></all></any>",
                                        "<no_collision robot=\"" + robot().id + "\"/>"});
    if (world_->goals.empty() || random_.happens(0.4)) {
      return {"goal added", {"goal[+]=" + goal}, false};
    }
    const std::string path =
        "goal[" + std::to_string(1 + random_.below(world_->goals.size())) + "]";
    switch (random_.below(3)) {
      case 0:
        return {"goal removed", {path + "/@remove=true"}, false};
      case 1:
        return {"goal replaced", {path + "=" + goal}, false};
      default:
        return {"goal reordered", {path + "/@remove=true", "goal[+1]=" + goal}, false};
    }
  }
  Drawn coordinators() {
    const world::Robot& on = robot();
    const std::string path = "robot[" + on.id + "]/coordinator";
    const std::string markup = one_of(std::vector<std::string>{
        "<arbiter_suppression/>", "<arbiter_action_selection hold=\"1\"/>", "<arbiter_strength/>",
        "<arbiter_subsumption hold=\"1\"/>", "<arbiter_voting steps=\"5\"/>", "<fusion_fuzzy/>",
        "<fusion_interval/>", "<fusion_vector_summation/>"});
    if (!on.coordinator) {
      return {"coordinator added", {path + "[+]=" + markup}, false};
    }
    return random_.happens(0.2) ? Drawn{"coordinator removed", {path + "/@remove=true"}, false}
                                : Drawn{"coordinator replaced", {path + "=" + markup}, false};
  }
  Drawn drives() {
    const world::Robot& on = robot();
    const std::string path = "robot[" + on.id + "]/drive";
    const std::string markup = one_of(std::vector<std::string>{
        "<skid_steer/>", "<synchro/>", "<tricycle/>", "<omnidirectional/>", "<mecanum/>"});
    if (!on.drive) {
      return {"drive added", {path + "[+]=" + markup}};
    }
    return random_.happens(0.3) ? Drawn{"drive removed", {path + "/@remove=true"}}
                                : Drawn{"drive replaced", {path + "=" + markup}};
  }
  Drawn segments() {
    const world::Robot& on = robot();
    return in_list(
        "robot[" + on.id + "]/", "segment", on.segments, {{"mass", {"0.5", "0.8"}}},
        [](const std::string& id) { return "<segment id=\"" + id + "\"/>"; }, true);
  }
  Drawn physics() {
    return {"physics set",
            {set("physics", {{"step", {"0.01", "0.005"}},
                             {"control_steps", {"1", "2"}},
                             {"gravity", {"-9.81", "-9"}},
                             {"friction", {"0.8", "1"}},
                             {"bounce", {"0", "0.1"}}})},
            false};
  }
  Drawn others() {
    return {"rest set",
            {one_of(std::vector<std::string>{"@name=other", "@description=edited",
                                             "limits/@time=1000", "arena/@wall_height=0.4"})},
            false};
  }

  const std::vector<Drawn (RunningEdits::*)()> kinds_{
      &RunningEdits::robots,    &RunningEdits::behaviors, &RunningEdits::sensors,
      &RunningEdits::obstacles, &RunningEdits::resources, &RunningEdits::chargers,
      &RunningEdits::measures,  &RunningEdits::goals,     &RunningEdits::coordinators,
      &RunningEdits::drives,    &RunningEdits::segments,  &RunningEdits::physics,
      &RunningEdits::others};
  RandomEdits random_;
  const world::World* world_ = nullptr;
  int count_ = 0;
};

bool same(const world::World& a, const world::World& b) {
  return world::same(world::vocabulary(), &a, &b);
}

}  // namespace

TEST_CASE("Random edits of running worlds are what edits of their files are, or change nothing") {
  world::ReadOptions options;
  options.data_directories = {source_path("")};
  options.is_running = true;
  const simulation::Options run{.seed = 3, .data_directories = options.data_directories};
  std::map<std::string, int> made, refused;
  int all_made = 0, all_refused = 0;
  std::set<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(source_path("worlds"))) {
    if (file.path().extension() == ".xml") {
      files.insert(file.path().string());
    }
  }
  unsigned seed = kSeed;
  for (const std::string& file : files) {
    CAPTURE(file);
    const world::World world = world::read_world(file, shipped(), options);
    if (needs_cameras(world)) {
      continue;
    }
    editing::Document document(world::write_world(world), world.file, shipped(), options);
    RunningEdits random(seed++, shipped());
    Simulation simulation(document.world(), shipped(), run);
    Simulation twin(document.world(), shipped(), run);  // which is not asked for what is refused
    for (int i = 0; i < edits_of_each_world(files.size()); ++i) {
      Drawn drawn = random.next(simulation.world());
      if (i % 2 == 0) {  // not all edits are made in place
        drawn.edits.push_back("@description=edit " + std::to_string(i));
      }
      std::vector<simulation::Edit> edits;
      for (const std::string& edit : drawn.edits) {
        edits.push_back(change_of(edit));
      }
      CAPTURE(i, drawn.edits);
      const std::uint64_t before = simulation.state_hash();
      const std::size_t events = simulation.events().size();
      const world::World was = simulation.world();
      const std::string why = why_not([&] { simulation.edit(edits); });
      CAPTURE(why);
      if (!why.empty()) {
        ++refused[drawn.kind];
        ++all_refused;
        REQUIRE(same(simulation.world(), was));
        REQUIRE(simulation.state_hash() == before);
        REQUIRE(simulation.events().size() == events);
      } else {
        ++made[drawn.kind];
        ++all_made;
        REQUIRE_NOTHROW(twin.edit(edits));
        REQUIRE_NOTHROW(document.apply(drawn.edits));
        CAPTURE(document.text());
        const world::World read =
            world::parse_world(document.text(), document.file(), shipped(), options);
        REQUIRE(world::write_world(simulation.world()) == world::write_world(read));
        REQUIRE(same(simulation.world(), read));
        if (!drawn.moves_bodies) {
          REQUIRE(simulation.state_hash() == before);
        }
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
  std::string all;
  for (const auto& [kind, count] : made) {
    all += kind + ": " + std::to_string(count) + " made, " + std::to_string(refused[kind]) +
           " refused\n";
  }
  WARN(all_made << " edits made, " << all_refused << " refused\n" << all);
  CHECK(all_made > all_refused);
  CHECK(all_refused > 0);
  for (const char* const done : {"added", "removed", "replaced", "reordered", "set"}) {
    for (const char* const of :
         {"robot", "behavior", "sensor", "obstacle", "resource", "charger", "measure", "segment"}) {
      CAPTURE(of, done);
      CHECK(made[std::string(of) + " " + done] > 0);
    }
  }
  for (const char* const kind :
       {"goal added", "goal removed", "goal replaced", "goal reordered", "coordinator replaced",
        "coordinator removed", "coordinator added", "drive added", "drive replaced",
        "drive removed", "physics set", "rest set"}) {
    CAPTURE(kind);
    CHECK(made[kind] > 0);
  }
}
