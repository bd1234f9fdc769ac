// A world file that is edited: what changes in its text, and what comes back.
#include <filesystem>

#include <catch2/catch.hpp>

#include "elsie/editing/document.h"

#include "documents.h"

using namespace elsie;
using namespace elsie::test;
using editing::Document;

TEST_CASE("A document is its text and its world") {
  const Document d = document();
  CHECK(d.text() == kWorld);
  CHECK(d.file() == file());
  CHECK(d.world().robots.size() == 2);
  CHECK_THROWS_AS(document("<world format=\"1\"><robot/></world>"), world::WorldError);
}

TEST_CASE("An attribute that is set changes in its place") {
  CHECK(change("robot[r1]/@max_speed=0.5") ==
        "-    <robot id=\"r1\" max_speed=\"0.30\">\n+    <robot id=\"r1\" max_speed=\"0.5\">\n");
  CHECK(change("@name=a \"b\" & 'c'") ==
        "-<world  format='1'   name=\"odd\" >\n"
        "+<world  format='1'   name=\"a &quot;b&quot; &amp; 'c'\" >\n");
  CHECK(change("obstacle[crate]/@id=c") ==
        "-    <dynamic_box id='crate'\n+    <dynamic_box id='c'\n");
  CHECK(change("obstacle[crate]/@mass=2") ==
        "-                 y='0.5' />\n"
        "+                 y='0.5'\n+                 mass=\"2\" />\n");
  CHECK(change("robot[r1]/sensor[left]/@x=0.5") ==
        "-        <beam id=\"left\" yaw_deg=\"20\"/>\n"
        "+        <beam id=\"left\" yaw_deg=\"20\" x=\"0.5\"/>\n");
  CHECK(change("robot[r1]/behavior[both]/behavior[roam]/@speed=3") ==
        "-          <behaviors><roam/></behaviors>\n"
        "+          <behaviors><roam speed=\"3\"/></behaviors>\n");
  CHECK(change("robot[r1]/@max_speed=0.30") == "");
  CHECK(change("robot[*]/@coverage=3") == diff(kWorld, [] {
          std::string text = kWorld;
          text.replace(text.find("\"0.30\""), 6, "\"0.30\" coverage=\"3\"");
          text.replace(text.find("y=\"1\">"), 6, "y=\"1\" coverage=\"3\">");
          return text;
        }()));
}

TEST_CASE("An attribute that is removed takes the blanks in front of it") {
  CHECK(change("robot[r1]/@max_speed/@remove=true") ==
        "-    <robot id=\"r1\" max_speed=\"0.30\">\n+    <robot id=\"r1\">\n");
  CHECK(change("obstacle[crate]/@x/@remove=true") == "-                 x='2'\n");
  CHECK(change("@name/@remove=true") ==
        "-<world  format='1'   name=\"odd\" >\n+<world  format='1' >\n");
  CHECK(change("robot[r1]/sensor[left]/@id/@remove=true") ==
        "-        <beam id=\"left\" yaw_deg=\"20\"/>\n+        <beam yaw_deg=\"20\"/>\n");
}

TEST_CASE("An element that is removed takes its line") {
  CHECK(change("robot[r1]/sensor[left]/@remove=true") ==
        "-        <beam id=\"left\" yaw_deg=\"20\"/>\n");
  CHECK(change("obstacle[crate]/@remove=true") ==
        "-    <dynamic_box id='crate'\n-                 x='2'\n-                 y='0.5' />\n");
  CHECK(change("obstacle[wall]/@remove=true") ==
        "-    <static_box id=\"wall\" x=\"1\"/>   <!-- in the way -->\n"
        "+    <!-- in the way -->\n");
  CHECK(change("obstacle[4]/@remove=true") ==
        "-    <static_box x=\"3\"/><static_box x=\"4\"/>\n+    <static_box x=\"3\"/>\n");
  CHECK(change("robot[r1]/sensor[eye]/threshold[1]/@remove=true") ==
        "-          <threshold low=\"0.1\"/>\n");
  CHECK(change("robot[r1]/sensor[eye]/mask/@remove=true") == "-          <mask/>\n");
}

TEST_CASE("An element that is added stands as far in as its siblings") {
  CHECK(change("robot[+]=<robot id='r9' x='-2'/>") == "+    <robot id=\"r9\" x=\"-2\"/>\n");
  CHECK(change("robot[+1]=<robot id='r9' x='-2'/>") == "+    <robot id=\"r9\" x=\"-2\"/>\n");
  CHECK(change("robot[r1]/sensor[+2]=<bumper/>") == "+        <bumper/>\n");
  CHECK(change("obstacle[+2]=<static_box id='b' x='-3'/>") ==
        "+    <static_box id=\"b\" x=\"-3\"/>\n");
  CHECK(change("robot[r2]/sensor[+]=<beam/>") ==
        "-    <robot id=\"r2\" x=\"-1\" y=\"1\"><sensors/></robot>\n"
        "+    <robot id=\"r2\" x=\"-1\" y=\"1\"><sensors>\n"
        "+      <beam/>\n"
        "+    </sensors></robot>\n");
  CHECK(change("charger[+]=<charger x='-2'/>") ==
        "+  <chargers>\n+    <charger x=\"-2\"/>\n+  </chargers>\n");
  CHECK(change("robot[+]=<robot id='r9' x='-2'><sensors><beam/></sensors></robot>") ==
        "+    <robot id=\"r9\" x=\"-2\">\n+      <sensors>\n+        <beam/>\n"
        "+      </sensors>\n+    </robot>\n");
  CHECK(change("limits/@time=9") == "+  <limits time=\"9\"/>\n");
  CHECK(change("robot[r1]/sensor[eye]/threshold[+]=<threshold low='0.3'/>") ==
        "+          <threshold low=\"0.3\"/>\n");
}

TEST_CASE("An element that is replaced leaves everything around it") {
  CHECK(change("robot[r1]/coordinator=<pick/>") ==
        "-      <coordinator><sum weighted=\"true\"/></coordinator>\n"
        "+      <coordinator><pick/></coordinator>\n");
  CHECK(change("obstacle[wall]=<dynamic_box x='1' mass='3'/>") ==
        "-    <static_box id=\"wall\" x=\"1\"/>   <!-- in the way -->\n"
        "+    <dynamic_box x=\"1\" mass=\"3\" id=\"wall\"/>   <!-- in the way -->\n");
}

TEST_CASE("Line ends, a byte order mark and files without line ends stay") {
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : kWorld) {
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  }
  CHECK(change(document(windows), "robot[+]=<robot id='r9' x='-2'><sensors/></robot>") ==
        "+    <robot id=\"r9\" x=\"-2\">\r\n+      <sensors/>\r\n+    </robot>\r\n");
  CHECK(change(document(windows), "robot[r1]/sensor[left]/@remove=true") ==
        "-        <beam id=\"left\" yaw_deg=\"20\"/>\r\n");
  const std::string line =
      "<world format='1'><robots><robot id='a'/><robot id='b' x='1'/></robots></world>";
  CHECK(change(document(line), "robot[b]/@remove=true") ==
        "-" + line + "\n+<world format='1'><robots><robot id='a'/></robots></world>\n");
  CHECK(change(document(line), "robot[+2]=<robot id='c' x='-1'/>") ==
        "-" + line +
            "\n+<world format='1'><robots><robot id='a'/><robot id=\"c\" x=\"-1\"/>"
            "<robot id='b' x='1'/></robots></world>\n");
}

TEST_CASE("Edits of a document are refused as those of a file are") {
  CHECK(refusal("robot[r9]/@x=1") == "there is no robot[r9]; there are: r1, r2");
  CHECK(refusal("robot[r1]/@max_speed=fast") ==
        "max_speed=\"fast\" of <robot>: expected a number at least 0 and at most 100 m/s");
  CHECK(refusal("robot[+]=<robot id='r1' x='3'/>") ==
        "a second robot with the id 'r1'; the first is there already (" + file() + ":14)");
  CHECK_THAT(refusal("obstacle[+1]=<static_box id='crate' x='-3'/>"),
             Catch::Contains("a second box with the id 'crate'"));
  CHECK_THAT(refusal("robot[r1]/coordinator/@remove=true"),
             Catch::Contains("has behaviours but no coordinator"));
  CHECK(refusal("robot[r1]/@weight=1") ==
        "<robot> has no attribute 'weight'; it may have: id, template, team, colour, x, y, z, "
        "heading_deg, "
        "max_speed, coverage, leader, battery, energy");
  CHECK_THAT(refusal("robot[r2]/@x=\xFF"), Catch::Contains("UTF-8"));
  CHECK(refusal("nonsense") == "expected PATH=VALUE, as in robot[r1]/@max_speed=0.3");
}

TEST_CASE("Several edits are made together or not at all") {
  Document d = document();
  CHECK_THAT(refusal(d, {"robot[r1]/@y=-2", "robot[r2]/@x=nowhere"}),
             Catch::Contains("expected a number"));
  // The world between them would be refused.
  d.apply(
      {"goal[+]=<travel robot='r2' distance='1'/>", "robot[r2]/@remove=true", "goal[1]/@robot=r1"});
  CHECK(d.world().robots.size() == 1);
}

TEST_CASE("A document becomes another text") {
  Document d = document();
  const std::string other =
      "<!-- moved -->\n<world format=\"1\"><robots><robot id=\"r1\"/></robots></world>";
  d.become(other);
  CHECK(d.text() == other);
  CHECK(d.world().robots.size() == 1);
  CHECK_THROWS_AS(d.become("<world format=\"1\"><robot/></world>"), world::WorldError);
  CHECK(d.text() == other);
}

TEST_CASE("A member that is named by its place yields its name to one that is given it") {
  Document d = document(R"(<world format="1">
  <obstacles>
    <static_box x="1"/>
    <dynamic_box x="2" id="static_box_2"/>
    <static_box x="3"/>
  </obstacles>
</world>
)");
  CHECK(d.world().obstacles[2].id == "static_box_3");
  d.apply({"obstacle[2]/@remove=true"});
  CHECK(d.world().obstacles[1].id == "static_box_2");
}

TEST_CASE("A member that is named elsewhere keeps its name when its place changes") {
  Document d = document(R"(<world format="1">
  <obstacles>
    <dynamic_box x="1"/>
    <dynamic_box x="2"/>
    <dynamic_box x="3"/>
  </obstacles>
  <robots>
    <robot id="r1"/>
  </robots>
  <goals>
    <push box="dynamic_box_2" x="0" y="3"/>
  </goals>
</world>
)");
  const std::string before = d.text();
  d.apply({"obstacle[1]/@remove=true"});
  CHECK(diff(before, d.text()) ==
        "-    <dynamic_box x=\"1\"/>\n-    <dynamic_box x=\"2\"/>\n"
        "+    <dynamic_box x=\"2\" id=\"dynamic_box_2\"/>\n");
  d.become(before);
  CHECK_THAT(refusal(d, {"obstacle[2]/@remove=true"}), Catch::Contains("there is no such box"));
}

TEST_CASE("In a running world, all members keep their names") {
  Document d = document(R"(<world format="1">
  <obstacles>
    <dynamic_box x="1"/>
    <dynamic_box x="2"/>
    <dynamic_box x="3" id="last"/>
  </obstacles>
</world>
)");
  const std::string before = d.text();
  d.apply({"obstacle[1]/@remove=true"}, editing::Names::all);
  CHECK(diff(before, d.text()) ==
        "-    <dynamic_box x=\"1\"/>\n-    <dynamic_box x=\"2\"/>\n"
        "+    <dynamic_box x=\"2\" id=\"dynamic_box_2\"/>\n");
}

TEST_CASE("In a running world, which is given no defaults, an attribute may have its own already") {
  const char* const text = "<world format=\"1\"><robots><robot id=\"r1\"/></robots></world>";
  const std::string edit = "robot[r1]/@max_speed/@remove=true";
  CHECK_THROWS_WITH(Document(text, "world.xml", host(), options()).apply({edit}),
                    Catch::Contains("<robot> does not set 'max_speed'"));
  world::ReadOptions running = options();
  running.is_running = true;
  Document document(text, "world.xml", host(), running);
  document.apply({edit});
  CHECK(document.text() == text);
  document.apply({"robot[r1]/@max_speed=0.1"});
  document.apply({edit});
  CHECK(document.world().robots[0].max_speed == world::Robot().max_speed);
  CHECK_THROWS_WITH(document.apply({"robot[r1]/@max_sped/@remove=true"}),
                    Catch::Contains("<robot> does not set 'max_sped'"));
}
