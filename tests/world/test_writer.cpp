// A world that was read can be written, and read again.
#include <random>

#include <catch2/catch.hpp>

#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

world::World again(const world::World& w) {
  return world::parse_world(world::write_world(w), kFolder + "data/again.xml", host(), options());
}

}  // namespace

TEST_CASE("Nothing is lost in writing and reading") {
  const world::World w = world::read_world(kFolder + "data/everything.xml", host(), options());
  const world::World copy = again(w);
  CHECK(same(w, copy));
  CHECK(world::write_world(copy) == world::write_world(w));
}

TEST_CASE("A colour that a team was given is kept, whatever comes to the world later") {
  const world::World w = read("<teams><team id='crew'/></teams>");
  CHECK(same(w, again(w)));
  CHECK_THAT(world::write_world(w), Catch::Contains("<team id=\"crew\" colour=\"#b830d0\"/>"));
}

TEST_CASE("The comparison of these tests sees a difference") {
  const world::World w = world::read_world(kFolder + "data/everything.xml", host(), options());
  for (const char* change :
       {"robot[r1]/beam[1]/@max_range=3",
        "robot[r1]/eye/threshold[1]/@high=0.8",
        "robot[r1]/eye/mask[2]/@margin=1",
        "robot[r2]/coordinator/suppress[2]/@by=avoid",
        "robot[r1]/behavior[explore]/rule[2]/@weight=2",
        "robot[r1]/behavior[explore]/behavior[roam]/@speed=2",
        "robot[r1]/behavior[explore]/behavior[blend]/behavior[seek]/@priority=2",
        "robot[r1]/behavior[explore]/behavior[blend]/coordinator/inhibit/@by=roam",
        "robot[r1]/behavior[explore]/coordinator/@weighted=false",
        "robot[r1]/body/@mass=2",
        "goal[3]/@radius=1",
        "measure[way_2]/@from_s=3",
        "measure[way_2]/gate[2]/@x=3",
        "moving_box[patrol]/waypoint[2]/@y=3",
        "charger[dock]/@rate=3",
        "team[blue]/@colour=#000000",
        "robot[r1]/segment[2]/@gap=0.02",
        "limits/@time=200",
        "@name=x",
        "physics/@bounce=0",
        "arena/@wall_height=1"}) {
    CAPTURE(change);
    CHECK_FALSE(
        same(w, world::read_world(kFolder + "data/everything.xml", host(), options({change}))));
  }
}

TEST_CASE("What is the default is not written") {
  CHECK(world::write_world(read("")) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<world format=\"1\">\n"
        "  <teams>\n"
        "    <team id=\"red\" colour=\"#d03030\"/>\n"
        "    <team id=\"blue\" colour=\"#3060d0\"/>\n"
        "  </teams>\n"
        "</world>\n");
}

TEST_CASE("Numbers survive to the last bit") {
  std::mt19937_64 bits(1);
  for (int i = 0; i < 200; ++i) {
    world::World w;
    w.obstacles.resize(1);
    w.obstacles[0].id = "b";
    w.obstacles[0].x = std::uniform_real_distribution<double>(-5, 5)(bits);
    w.obstacles[0].length = std::exp(std::uniform_real_distribution<double>(-9, 2)(bits));
    w.physics.parameters["cfm"] = std::exp(std::uniform_real_distribution<double>(-600, 0)(bits));
    const world::World copy = again(w);
    CHECK(copy.obstacles.at(0).x == w.obstacles[0].x);
    CHECK(copy.obstacles.at(0).length == w.obstacles[0].length);
    CHECK(copy.physics.parameters == w.physics.parameters);
  }
}

TEST_CASE("A written world names no place of this machine") {
  const world::World w = world::read_world(kFolder + "data/everything.xml", host(), options());
  const std::string text = world::write_world(w);
  CHECK_THAT(text, Catch::Contains(" song=\"songs/one.txt\""));
  CHECK_THAT(text, !Catch::Contains(" model="));  // its default
  CHECK_THAT(text, !Catch::Contains(kFolder));
}

TEST_CASE("A file that the user names by an absolute path keeps it") {
  const std::string song = kFolder + "data/songs/one.txt";
  const world::World w = world::read_world(kFolder + "data/everything.xml", host(),
                                           options({"roam[1]/@song=" + song}));
  CHECK_THAT(world::write_world(w), Catch::Contains(" song=\"" + song + "\""));
  CHECK(same(w, again(w)));
}

TEST_CASE("A file parameter that is changed after reading is written as it is") {
  world::World w = world::read_world(kFolder + "data/everything.xml", host(), options());
  w.robots[0].behaviors[1].parameters["song"] = std::string("other.txt");
  w.robots[0].behaviors[0].parameters["model"] = std::string("mine.fcl");
  CHECK_THAT(world::write_world(w),
             Catch::Contains(" song=\"other.txt\"") && Catch::Contains(" model=\"mine.fcl\""));
}
