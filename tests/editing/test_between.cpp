// The edits that lead from one running world to another.
#include <catch2/catch.hpp>

#include "elsie/editing/between.h"
#include "elsie/world/writer.h"

#include "../world/fixture.h"

using namespace elsie;
using namespace elsie::test;
using Several = std::vector<std::string>;

namespace {

Several between(const std::string& from, const std::string& to) {
  const world::World start = read(from), end = read(to);
  const Several edits = editing::edits_between(start, end);
  world::ReadOptions running = options();
  running.is_running = true;
  running.edits = edits;
  CHECK(world::write_world(world::parse_world(world::write_world(start), start.file, host(),
                                              running)) == world::write_world(end));
  return edits;
}

std::string robots(const std::string& content) { return "<robots>" + content + "</robots>"; }

std::string robot(const std::string& content) {
  return robots("<robot id=\"r1\">" + content + "</robot>");
}

const std::string kSum = "<coordinator><sum/></coordinator>";

}  // namespace

TEST_CASE("Worlds that say the same need no edits, however they are written") {
  CHECK(between(robots("<robot id=\"r1\" x=\"0\"/>"), "<!-- one --><arena/>" + robot("")).empty());
}

TEST_CASE("An attribute that differs is set, or taken away where it has its default") {
  CHECK(between(robots("<robot id=\"r1\" x=\"1\" max_speed=\"0.3\"/>"),
                robots("<robot id=\"r1\" x=\"2\"/>")) ==
        Several{"robot[r1]/@max_speed/@remove=true", "robot[r1]/@x=2"});
  CHECK(between("", "<limits time=\"7\"/>") == Several{"limits/@time=7"});
  CHECK(between("", "<physics engine=\"planar\"/>") == Several{"physics/@engine=planar"});
}

TEST_CASE("Members of lists are known by their ids, wherever they stand") {
  const std::string a = "<robot id=\"a\" x=\"1\"/>", b = "<robot id=\"b\" x=\"2\"/>",
                    c = "<robot id=\"c\" x=\"3\"/>";
  CHECK(between(robots(a + b + c), robots(a + c)) == Several{"robot[b]/@remove=true"});
  CHECK(between(robots(a + c), robots(a + b + c)) == Several{"robot[+2]=" + b});
  CHECK(between(robots(a), robots(a + b)) == Several{"robot[+]=" + b});
  CHECK(between(robots(a + b), robots(c + b + "<robot id=\"d\"/>")) ==
        Several{"robot[+2]=" + c, "robot[+]=<robot id=\"d\"/>", "robot[a]/@remove=true"});
  // Another order is another list.
  CHECK(between(robots(a + b + c), robots(b + c + a)) == Several{"robots=" + robots(b + c + a)});
}

TEST_CASE("Plugins keep their place, and what differs in them is edited there") {
  CHECK(between(robot("<behaviors><roam/></behaviors>" + kSum),
                robot("<behaviors><roam priority=\"2\"/></behaviors>" + kSum)) ==
        Several{"robot[r1]/behavior[roam]/@priority=2"});
  CHECK(between(robot(kSum), robot("<coordinator><sum weighted=\"true\"/></coordinator>")) ==
        Several{"robot[r1]/coordinator/@weighted=true"});
  CHECK(between(robot(""), robot(kSum)) == Several{"robot[r1]/coordinator[+]=<sum id=\"sum\"/>"});
  CHECK(between(robot(kSum), robot("")) == Several{"robot[r1]/coordinator/@remove=true"});
  const auto blend = [](const std::string& inside) {
    return robot("<behaviors><blend><behaviors>" + inside + "</behaviors>" + kSum +
                 "</blend></behaviors>" + kSum);
  };
  CHECK(between(blend("<roam/>"), blend("<roam/><roam id=\"two\"/>")) ==
        Several{"robot[r1]/behavior[blend]/behavior[+]=<roam id=\"two\"/>"});
}

TEST_CASE("A list of members without ids is replaced") {
  const std::string one = "<goals><endure time=\"2\"/></goals>";
  CHECK(between("", one) == Several{"goals=" + one});
}
