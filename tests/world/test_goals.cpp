// Goals: whom they are about, which events they wait for, and groups of them.
#include <string>
#include <variant>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/world/world_tree.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace {

class Watching final : public Behavior {
 public:
  Response respond(const Perception&) override { return Motion{}; }
};

const plugin::Host& watched() {
  static const plugin::Host made = [] {
    plugin::Host host = make_host();
    host.add(declare<Watching>(PluginKind::behavior, "guard", "Raises the alarm", only_acts(),
                               raises("alarm", "something is wrong")));
    return host;
  }();
  return made;
}

const std::string kRobots =
    "<robots><robot id='r1'><behaviors><guard/></behaviors></robot><robot id='r2' x='1'/>"
    "<robot id='b1' team='blue' x='2'/></robots>";

world::World with_goals(const std::string& goals) {
  return world::parse_world("<world format='1'>" + kRobots + "<goals>" + goals + "</goals></world>",
                            "world.xml", watched(), options());
}

std::string wrong_with(const std::string& goals) {
  try {
    with_goals(goals);
    return "";
  } catch (const world::WorldError& error) {
    return error.what();
  }
}

const std::string kGroups =
    "<any><reach robot='r1' x='1' y='1'/>"
    "<all><endure time='5'/><reach robot='r2' x='2' y='2'/><travel team='red' any='true'/></all>"
    "<reach x='3' y='0'/></any>";

const world::AnyGoal& group_of(const world::World& world) {
  return std::get<world::AnyGoal>(world.goals.at(0));
}

world::World edited(const world::World& world, std::vector<std::string> edits) {
  return world::edited(world::WorldTree(world), watched(), options(std::move(edits)));
}

}  // namespace

TEST_CASE("Groups hold goals to reach, to any depth, in the order of the file") {
  const world::World world = with_goals(kGroups);
  const world::AnyGoal& any = group_of(world);
  REQUIRE(any.goals.size() == 3);
  CHECK(std::get<world::ReachGoal>(any.goals[0]).robot == "r1");
  const auto& all = std::get<world::AllGoal>(any.goals[1]);
  REQUIRE(all.goals.size() == 3);
  CHECK(std::get<world::EndureGoal>(all.goals[0]).time == 5.0);
  CHECK(std::get<world::TravelGoal>(all.goals[2]).team == "red");
  CHECK(std::get<world::TravelGoal>(all.goals[2]).any);
  CHECK(std::get<world::ReachGoal>(any.goals[2]).robot.empty());
  std::vector<std::size_t> kinds;
  world::for_each_goal(world.goals,
                       [&](const world::Goal& goal) { kinds.push_back(goal.index()); });
  CHECK(kinds.size() == 5);
}

TEST_CASE("A world with groups of goals is written as it was read") {
  const world::World world = with_goals(kGroups);
  const world::World again =
      world::parse_world(world::write_world(world), "world.xml", watched(), options());
  CHECK(same(world, again));
  world::World other = world;
  std::get<world::AllGoal>(std::get<world::AnyGoal>(other.goals[0]).goals[1]).goals.pop_back();
  CHECK_FALSE(same(world, other));
}

TEST_CASE("Paths lead into groups of goals, which count each kind of goal by itself") {
  const world::World world = with_goals(kGroups);
  const world::World changed =
      edited(world, {"goal[1]/reach[2]/@x=4", "any/all/endure/@time=7",
                     "goal[1]/all/endure[+]=<endure time='9'/>", "any/reach[1]/@remove=true"});
  const world::AnyGoal& any = group_of(changed);
  REQUIRE(any.goals.size() == 2);
  CHECK(std::get<world::ReachGoal>(any.goals[1]).x == 4.0);
  const auto& all = std::get<world::AllGoal>(any.goals[0]);
  REQUIRE(all.goals.size() == 4);
  CHECK(std::get<world::EndureGoal>(all.goals[0]).time == 7.0);
  CHECK(std::get<world::EndureGoal>(all.goals[3]).time == 9.0);
}

TEST_CASE("The tree of a world names goals in groups by paths that lead to them") {
  const world::World world = with_goals(kGroups);
  world::WorldTree tree(world);
  std::vector<std::string> paths;
  world::for_each_element(*tree.root().child("goals"), [&](const world::Element& element) {
    if (element.name == "reach") paths.push_back(tree.path(element));
  });
  CHECK(paths == std::vector<std::string>{"goal[1]/reach[1]", "goal[1]/all[1]/reach[1]",
                                          "goal[1]/reach[2]"});
}

TEST_CASE("A robot that a goal in a group is about cannot be removed alone") {
  const world::World world = with_goals(kGroups);
  CHECK_THROWS_WITH(edited(world, {"robot[r2]/@remove=true"}),
                    Contains("robot=\"r2\" of <reach>: there is no such robot"));
  CHECK(edited(world, {"robot[r2]/@remove=true", "any/all/@remove=true"}).robots.size() == 2);
}

TEST_CASE("A goal waits for an event of the simulator, or of a behaviour of its robots") {
  for (const char* goal :
       {"<event name='collected'/>", "<event name='alarm'/>", "<event name='alarm' robot='r1'/>",
        "<event name='alarm' team='red' count='3'/>", "<event name='collision' robot='b1'/>",
        "<event name='delivered' team='red' count='5'/>"}) {
    CAPTURE(goal);
    CHECK(wrong_with(goal).empty());
  }
  CHECK_THAT(
      wrong_with("<event name='alarm' robot='r2'/>"),
      Contains(
          "<event> waits for 'alarm', which neither the simulator nor a rule nor a behaviour of "
          "the robot 'r2' raises; there are: battery_empty"));
  CHECK_THAT(wrong_with("<event name='alarm' team='blue'/>"),
             Contains("nor a behaviour of the team 'blue' raises"));
  CHECK_THAT(wrong_with("<event name='alram'/>"), Contains("did you mean 'alarm'?"));
  // What an edit does is no event that robots perceive.
  CHECK_THAT(wrong_with("<event name='changed'/>"), Contains("waits for 'changed'"));
  CHECK_THAT(wrong_with("<event name='alarm' count='0'/>"), Contains("expected"));
}

TEST_CASE("A behaviour that a goal needs for its event cannot be removed") {
  const world::World world = with_goals("<event name='alarm'/>");
  CHECK_THROWS_WITH(edited(world, {"robot[r1]/behavior[guard]/@remove=true"}),
                    Contains("<event> waits for 'alarm'"));
}
