// Editing a file and leaving alone what was not edited.
#include <filesystem>

#include <catch2/catch.hpp>

#include "elsie/world/document.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
using world::Document;

namespace {

const std::string kText = R"(<?xml version="1.0"?>
<!-- A world
     with a comment -->
<world   format="1"  name='single "quotes"'>

  <arena length="8"/> <!-- small -->
  <robots>
    <!-- the first -->
    <robot id="r1"
           x="1"  template="two.xml">
      <sensors><beam yaw_deg="15"/></sensors>
    </robot>
	<robot id="r2"/>
  </robots>
</world>
<!-- the end -->
)";

// What the document is when this part of it is replaced.
std::string replaced(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  REQUIRE(at != std::string::npos);
  return text.replace(at, before.size(), after);
}

}  // namespace

TEST_CASE("A document that is saved unchanged is the same to the byte") {
  const std::string file = test::build_path("saved_world.xml");
  for (const std::string& original :
       {kFolder + "data/everything.xml", test::source_path("robots/two_beams.xml")}) {
    Document::load(original).save(file);
    CHECK(text_of(file) == text_of(original));
  }
  std::filesystem::remove(file);
}

TEST_CASE("An attribute is set, and nothing else changes") {
  Document document(kText, "world.xml");
  SECTION("that is there") {
    document.set("robot[r1]/@x", "2.5");
    CHECK(document.text() == replaced(kText, "x=\"1\"", "x=\"2.5\""));
  }
  SECTION("in other quotes") {
    document.set("@name", "it's");
    CHECK(document.text() == replaced(kText, "'single \"quotes\"'", "\"it's\""));
  }
  SECTION("that is not there") {
    document.set("robot[r2]/@x", "3");
    CHECK(document.text() == replaced(kText, "id=\"r2\"", "id=\"r2\" x=\"3\""));
  }
  SECTION("with characters that XML takes for itself") {
    document.set("@name", "a<b & \"c\"");
    CHECK(document.attribute("@name") == "a<b & \"c\"");
    CHECK_THAT(document.text(), Catch::Contains("name=\"a&lt;b &amp; &quot;c&quot;\""));
  }
  SECTION("on several elements") {
    document.set("robot[*]/@leader", "true");
    CHECK(document.attribute("robot[r1]/@leader") == "true");
    CHECK(document.attribute("robot[r2]/@leader") == "true");
  }
  SECTION("on an element that must be added") {
    document.set("physics/@step", "0.005");
    CHECK(document.text() ==
          replaced(kText, "  </robots>\n", "  </robots>\n  <physics step=\"0.005\"/>\n"));
  }
  SECTION("on an element that must be added to an empty one") {
    document.set("robot[r2]/body/@mass", "2");
    CHECK(document.text() == replaced(kText, "<robot id=\"r2\"/>",
                                      "<robot id=\"r2\">\n\t  <body mass=\"2\"/>\n\t</robot>"));
  }
}

TEST_CASE("An attribute is read as the file gives it") {
  const Document document(kText, "world.xml");
  CHECK(document.attribute("robot[r1]/sensor[beam]/@yaw_deg") == "15");
  CHECK(document.attribute("robot[r1]/@template") == "two.xml");
  CHECK_FALSE(document.attribute("robot[r1]/@max_speed"));
  CHECK_FALSE(document.attribute("physics/@step"));
}

TEST_CASE("An attribute is taken out") {
  Document document(kText, "world.xml");
  document.reset("robot[r1]/@x");
  CHECK(document.text() == replaced(kText, "\n           x=\"1\"", ""));
}

TEST_CASE("Elements are added and taken out") {
  Document document(kText, "world.xml");
  SECTION("at the end of a list") {
    document.insert("robots", "<robot id=\"r3\">\n  <body/>\n</robot>");
    CHECK(document.text() ==
          replaced(kText, "  </robots>\n",
                   "    <robot id=\"r3\">\n      <body/>\n    </robot>\n  </robots>\n"));
  }
  SECTION("in a line") {
    document.insert("robot[r1]/sensors", "<bumper/>");
    CHECK(document.text() ==
          replaced(kText, "<beam yaw_deg=\"15\"/></sensors>",
                   "<beam yaw_deg=\"15\"/>\n        <bumper/>\n      </sensors>"));
  }
  SECTION("in a list that is not there") {
    document.insert("obstacles", "<static_box/>");
    CHECK(document.text() ==
          replaced(kText, "  </robots>\n",
                   "  </robots>\n  <obstacles>\n    <static_box/>\n  </obstacles>\n"));
  }
  SECTION("with their lines") {
    document.erase("robot[r2]");
    CHECK(document.text() == replaced(kText, "\t<robot id=\"r2\"/>\n", ""));
  }
  SECTION("out of a line") {
    document.erase("arena");
    CHECK(document.text() == replaced(kText, "<arena length=\"8\"/>", ""));
  }
}

TEST_CASE("A change that cannot be is refused, and the text stays") {
  Document document(kText, "world.xml");
  CHECK_THROWS_WITH(document.set("robot[r3]/@x", "1"), "there is no robot[r3]; there are: r1, r2");
  CHECK_THROWS_WITH(document.set("robot[r1]", "1"),
                    "the path 'robot[r1]' leads to an element; expected an attribute at its end");
  CHECK_THROWS_WITH(
      document.erase("robot[r1]/@x"),
      "the path 'robot[r1]/@x' leads to an attribute; expected an element at its end");
  CHECK_THROWS_WITH(document.insert("robots", "<robot>"),
                    Catch::StartsWith("this change would not leave well-formed XML: "));
  CHECK_THROWS_AS(document.set("robot[*]/@a b", "1"), std::invalid_argument);
  CHECK_THROWS_WITH(document.erase(""), Catch::StartsWith("this change would not leave"));
  CHECK(document.text() == kText);
  CHECK_THROWS_AS(document.save("/nowhere/at/all.xml"), world::WorldError);
}

TEST_CASE("An edited document is a world") {
  Document document("<world format='1'><robots><robot id='r1'/></robots></world>", "world.xml");
  document.set("robot[r1]/body/@mass", "0.25");
  document.insert("robot[r1]/sensors", "<beam id=\"left\"/>");
  document.set("robot[r1]/sensor[left]/@yaw_deg", "5");
  const world::World w = world::parse_world(document.text(), document.file(), host());
  CHECK(w.robots[0].body.mass == 0.25);
  CHECK(w.robots[0].sensors.at(0).yaw_deg == 5);
}

TEST_CASE("What stands in a plugin's element is edited like the rest") {
  const std::string text = R"(<world format="1">
  <robots>
    <robot id="r1">
      <behaviors>
        <blend id="explore"/> <!-- to be filled -->
        <roam/>
      </behaviors>
      <coordinator>
        <layers>
          <suppress by="a" of="b"/>
          <!-- the other way -->
          <suppress by="b" of="a"/>
        </layers>
      </coordinator>
    </robot>
  </robots>
</world>
)";
  Document document(text, "world.xml");
  SECTION("attributes of nested elements") {
    document.set("robot[r1]/coordinator/suppress[2]/@hold_s", "2");
    CHECK(document.text() == replaced(text, "by=\"b\" of=\"a\"", "by=\"b\" of=\"a\" hold_s=\"2\""));
    CHECK(document.attribute("robot[r1]/coordinator/suppress[1]/@by") == "a");
  }
  SECTION("nested elements") {
    document.erase("robot[r1]/coordinator/suppress[1]");
    document.insert("robot[r1]/coordinator/layers", "<inhibit by=\"c\" of=\"d\"/>");
    CHECK(document.text() ==
          replaced(replaced(text, "          <suppress by=\"a\" of=\"b\"/>\n", ""),
                   "        </layers>\n",
                   "          <inhibit by=\"c\" of=\"d\"/>\n        </layers>\n"));
  }
  SECTION("what a behaviour holds") {
    document.insert("robot[r1]/behavior[explore]/behaviors", "<roam speed=\"1\"/>");
    CHECK(document.text() == replaced(text, "<blend id=\"explore\"/>",
                                      "<blend id=\"explore\">\n"
                                      "          <behaviors>\n"
                                      "            <roam speed=\"1\"/>\n"
                                      "          </behaviors>\n"
                                      "        </blend>"));
    document.insert("robot[r1]/behavior[explore]", "<coordinator>\n  <sum/>\n</coordinator>");
    document.set("robot[r1]/behavior[explore]/behavior[roam]/@speed", "2");
    document.set("robot[r1]/behavior[explore]/coordinator/@weighted", "true");
    const world::World w = world::parse_world(document.text(), document.file(), host());
    const world::Coordination& inside = w.robots[0].behaviors[0].inside.at(0);
    CHECK(std::get<double>(inside.behaviors[0].parameters.at("speed")) == 2);
    CHECK(std::get<bool>(inside.coordinator->parameters.at("weighted")));
    CHECK(w.robots[0].behaviors[1].id == "roam");
  }
}
