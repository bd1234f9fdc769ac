// The edits between two worlds: as few and as small as paths allow.
#include <catch2/catch.hpp>

#include "elsie/editing/between.h"
#include "elsie/editing/document.h"
#include "elsie/world/writer.h"

#include "../world/fixture.h"

using namespace elsie;
using namespace elsie::test;
using Several = std::vector<std::string>;

namespace {

Several between(const std::string& from, const std::string& to) {
  return editing::edits_between(read(from), read(to), host(), options());
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
  // Another order is one robot that stands elsewhere: it goes where it stood.
  CHECK(between(robots(a + b + c), robots(b + c + a)) ==
        Several{"robot[+]=" + a, "robot[1]/@remove=true"});
  CHECK(between(robots(a + b), robots(a + "<robot id=\"d\" x=\"2\"/>")) ==
        Several{"robot[b]/@id=d"});
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

TEST_CASE("A document becomes another text, and the inverse knows both ways") {
  const auto text = [](const std::string& content) {
    return "<world format=\"1\">\n  " + content + "\n</world>\n";
  };
  const std::string first = text(robots("<robot id=\"r1\"/>"));
  editing::Document document(first, kFolder + "world.xml", host(), options());
  const std::string second = text("<!-- moved -->" + robots("<robot id=\"r1\" x=\"1\"/>"));
  const editing::Edits back = document.become(second);
  CHECK(document.text() == second);
  CHECK(document.world().robots[0].x == 1.0);
  CHECK_THROWS_AS(document.become(text("<robot/>")), world::WorldError);
  CHECK(document.text() == second);

  SECTION("at once") {
    const editing::Edits again = document.apply(back);
    CHECK(document.text() == first);
    document.apply(again);
    CHECK(document.text() == second);
  }
  SECTION("later, by what its texts say") {
    document.apply("robot[r1]/@max_speed=0.3");
    document.apply(back);
    CHECK(document.text() ==
          text("<!-- moved -->" + robots("<robot id=\"r1\" max_speed=\"0.3\"/>")));
  }
}

TEST_CASE("An edit of comments alone cannot be undone in another text") {
  const std::string first = "<world format=\"1\"/>\n";
  editing::Document document(first, kFolder + "world.xml", host(), options());
  const editing::Edits back = document.become("<!-- empty -->" + first);
  const editing::Edits named = document.apply("@name=mine");
  CHECK_THROWS_AS(document.apply(back), world::WorldError);
  document.apply(named);
  document.apply(back);
  CHECK(document.text() == first);
}
