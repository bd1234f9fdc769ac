// Sessions: what a window offers, and texts that are typed.
#include <algorithm>
#include <filesystem>
#include <tuple>

#include "session.h"

using namespace elsie;
using namespace elsie::test;

namespace {

std::string room(const std::string& from, const std::string& to) {
  std::string text = kRoom;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

Json become(Session& session, const std::string& text) {
  return session.ask({{"do", "become"}, {"text", text}});
}

}  // namespace

TEST_CASE("The catalog has elements, plugins and events, with and without a world") {
  Session session;
  const Json catalog = session.ask({{"do", "catalog"}});
  REQUIRE(catalog.contains("elements"));
  const Json& robot = catalog["elements"]["robot"];
  const auto speed = std::find_if(robot["attributes"].begin(), robot["attributes"].end(),
                                  [](const Json& each) { return each["name"] == "max_speed"; });
  REQUIRE(speed != robot["attributes"].end());
  CHECK((*speed)["type"] == "number");
  CHECK((*speed)["unit"] == "m/s");
  CHECK((*speed)["cost"] == "in place");
  CHECK(robot["children"].dump().find("\"behaviors\"") != std::string::npos);
  CHECK(catalog["elements"]["behaviors"]["holds"] == "behavior");
  CHECK(catalog["elements"]["behavior"]["attributes"].dump().find("priority") != std::string::npos);
  CHECK(catalog["elements"]["coordinator"]["holds"] == "coordinator");
  CHECK(catalog["elements"]["coordinator"]["attributes"].size() > 0);

  const test::Workplace place;
  CHECK(catalog["plugins"] == Json::parse(place.elsie("plugins --json").out)["plugins"]);
  CHECK(catalog["events"] == Json::parse(place.elsie("describe events --json").out));

  session.open(kRoom);
  CHECK(session.ask({{"do", "catalog"}})["elements"] == catalog["elements"]);
}

TEST_CASE("A typed text becomes the document, and back") {
  Session session;
  session.open(kRoom);
  const std::string typed = room("<!-- a room -->", "<!-- my room -->\n  <teams/>");
  const Json answer = become(session, typed);
  CHECK(answer["text"] == typed);
  CHECK(become(session, kRoom)["text"] == kRoom);
}

TEST_CASE("A wrong text is refused with its line, and nothing changes") {
  Session session;
  REQUIRE_FALSE(session.open(kRoom, "w.xml").contains("refused"));
  const Json refused = become(session, room("x=\"-1\"", "x=\"-1\" hue=\"red\""));
  REQUIRE(refused.contains("refused"));
  CHECK(refused["refused"][0]["file"] == "w.xml");
  CHECK(refused["refused"][0]["line"] == 5);
  CHECK(become(session, "<world").contains("refused"));
  CHECK(session.ask({{"do", "reset"}})["text"] == kRoom);
}

TEST_CASE("A run that is under way becomes the typed world, as with --at") {
  const auto [from, to, edit] =
      GENERATE(std::tuple("</robots>",
                          "<robot id=\"r2\" x=\"1\"><behaviors><turn_right/></behaviors>"
                          "<coordinator><arbiter_suppression/></coordinator></robot></robots>",
                          std::string(kSecond)),
               std::tuple("<turn_left/>", "<turn_left priority=\"2\"/>",
                          std::string("robot[r1]/behavior[turn_left]/@priority=2")),
               std::tuple("<turn_left/>", "<turn_right/>",
                          std::string("robot[r1]/behavior[turn_left]=<turn_right/>")),
               std::tuple("<!-- a room -->", "<!-- the room -->", std::string()));
  Session session;
  session.open(kRoom);
  session.step(50);
  const std::string typed = room(from, to);
  const Json answer = become(session, typed);
  INFO(answer.dump());
  REQUIRE_FALSE(answer.contains("refused"));
  CHECK(answer["text"] == typed);
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();

  const test::Workplace place;
  place.write("room.xml", kRoom);
  CHECK(end["state_hash"] ==
        hash_of_run(place, edit.empty() ? "room.xml" : "room.xml --at '0.5:" + edit + "'"));
}

TEST_CASE("A run for which the typed world has no room stays, and so does its text") {
  Session session;
  session.open(kRoom);
  session.step();
  const Json refused =
      become(session, room("</robots>",
                           "<robot id=\"r2\" x=\"-1\"><behaviors><turn_right/></behaviors>"
                           "<coordinator><arbiter_suppression/></coordinator></robot></robots>"));
  REQUIRE(refused.contains("refused"));
  session.ask({{"do", "run"}});
  const test::Workplace place;
  place.write("room.xml", kRoom);
  CHECK(session.end_of_run()["state_hash"] == hash_of_run(place, "room.xml"));
  CHECK(session.ask({{"do", "reset"}})["text"] == kRoom);
}

TEST_CASE("What a run refuses is a sentence about the world, without the edits") {
  Session session;
  session.open(R"(<world format="1">
  <arena length="4" width="4"/>
  <obstacles><static_box id="crate" x="1" y="1"/></obstacles>
  <robots><robot id="r1" x="-1"/></robots>
</world>
)");
  session.step();
  const auto refusal = [](const Json& answer) {
    REQUIRE(answer.contains("refused"));
    return answer["refused"][0]["message"].get<std::string>();
  };
  const Json text = session.edit({"robot[r1]/@x=0"})["text"];
  std::string other = text.get<std::string>();
  other.replace(other.find(" y=\"1\""), 6, "");
  other.insert(other.find("<arena"), "<physics engine=\"planar\"/>");
  CHECK_THAT(refusal(session.ask({{"do", "become"}, {"text", other}})),
             Catch::StartsWith("The run cannot set engine of physics to planar and take y away "
                               "from crate: one engine cannot"));
  CHECK_THAT(refusal(session.edit({"obstacle[+]=<static_box/>"})),
             Catch::EndsWith("overlaps the box 'static_box_2'"));
}

TEST_CASE("A run that is under way goes back to its earlier texts") {
  Session session;
  session.open(kRoom);
  session.step();
  const Json typed = become(session, room("<turn_left/>", "<turn_left/><turn_right/>"));
  REQUIRE_FALSE(typed.contains("refused"));
  const Json edited = session.edit({"robot[r1]/@max_speed=0.3"});
  REQUIRE_FALSE(edited.contains("refused"));
  CHECK(become(session, typed["text"])["text"] == typed["text"]);
  CHECK(become(session, kRoom)["text"] == kRoom);
}

TEST_CASE("Several edits of a run mean what they mean in the text") {
  Session session;
  session.open(room("<robots>",
                    "<obstacles><static_box x=\"0\" y=\"1\"/><static_box x=\"1\" y=\"1\"/>"
                    "</obstacles><robots>"));
  session.step();
  // The second edit is of the box that is the first one by then.
  const Json edited = session.edit({"obstacle[1]/@remove=true", "obstacle[1]/@x=-1"});
  INFO(edited.dump());
  REQUIRE_FALSE(edited.contains("refused"));
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  REQUIRE(snapshot->bodies.size() == 2);
  CHECK(snapshot->bodies[1].origin[0] == -1.0F);
}

TEST_CASE("What has no id keeps its name in a run, and so in the text") {
  Session session;
  session.open(room("<robots>",
                    "<obstacles><static_box x=\"0\" y=\"1\"/><static_box x=\"1\" y=\"1\"/>"
                    "<static_box x=\"1\" y=\"-1\"/></obstacles><robots>"));
  session.step();
  REQUIRE_FALSE(session.edit({"obstacle[1]/@remove=true"}).contains("refused"));
  const Json moved = session.edit({"obstacle[static_box_2]/@x=-1"});
  INFO(moved.dump());
  REQUIRE_FALSE(moved.contains("refused"));
  CHECK(moved["text"].get<std::string>().find(
            "<static_box x=\"-1\" y=\"1\" id=\"static_box_2\"/>") != std::string::npos);
  CHECK(moved["scene"]["bodies"][1]["path"] == "obstacle[static_box_2]");
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  CHECK(snapshot->bodies[1].origin[0] == -1.0F);
  CHECK(snapshot->bodies[1].origin[1] == 1.0F);
}

TEST_CASE("The text for another folder names the same files from there") {
  const test::Workplace place;
  std::filesystem::create_directory(place.file("here"));
  std::filesystem::create_directory(place.file("there"));
  place.write("here/robot.xml", "<robot_template format=\"1\" max_speed=\"0.3\"/>\n");
  const std::string text = room("id=\"r1\"", "id=\"r1\" template=\"robot.xml\"");
  Session session;
  const Json opened = session.open(text, place.file("here/w.xml").string());
  INFO(opened.dump());
  REQUIRE_FALSE(opened.contains("refused"));
  const auto text_for = [&](const std::string& file) {
    return session.ask({{"do", "text_for"}, {"file", place.file(file).string()}});
  };
  CHECK(text_for("here/v.xml")["text"] == text);
  const std::string there = text_for("there/w.xml")["text"];
  CHECK(there.find("template=\"robot.xml\"") == std::string::npos);
  CHECK(there.find("here/robot.xml\"") != std::string::npos);
  CHECK(text_for("nowhere/w.xml").contains("refused"));
}

TEST_CASE("A world that is saved elsewhere is the world of that file from then on") {
  const test::Workplace place;
  std::filesystem::create_directories(place.file("old").string());
  std::filesystem::create_directories(place.file("new").string());
  place.write("old/part.xml", R"(<robot_template format="1" max_speed="0.2"/>)");
  const std::string text = room("id=\"r1\"", "id=\"r1\" template=\"part.xml\"");
  Session session;
  REQUIRE_FALSE(session.open(text, place.file("old/room.xml").string()).contains("refused"));
  session.step();
  REQUIRE_FALSE(session.edit({"robot[r1]/@x=0.5"}).contains("refused"));
  const std::string target = place.file("new/room.xml").string();
  const Json moved = session.ask({{"do", "move"}, {"file", target}});
  INFO(moved.dump());
  const std::string now = moved["text"];
  CHECK_THAT(now, Catch::Contains("old/part.xml"));
  CHECK_THAT(now, Catch::Contains("x=\"0.5\""));
  place.write("new/room.xml", now);

  // The run goes on, and its command names the new file.
  CHECK_THAT(session.ask({{"do", "command"}})["text"].get<std::string>(), Catch::Contains(target));
  CHECK(session.ask({{"do", "at"}})["time_s"].get<double>() > 0.0);
  // A text that was written for the old file leads back.
  const Json back = session.ask(
      {{"do", "become"}, {"text", text}, {"file", place.file("old/room.xml").string()}});
  INFO(back.dump());
  REQUIRE(back.contains("text"));
  CHECK_THAT(back["text"].get<std::string>(), Catch::Contains("old/part.xml"));
  CHECK_THAT(back["text"].get<std::string>(), Catch::Contains("x=\"-1\""));
  // What is named now is searched beside the new file.
  place.write("new/other.xml", R"(<robot_template format="1" max_speed="0.1"/>)");
  CHECK_FALSE(session.edit({"robot[r1]/@template=other.xml"}).contains("refused"));
  // A folder that is not there changes nothing.
  CHECK(session.ask({{"do", "move"}, {"file", place.file("no/room.xml").string()}})
            .contains("refused"));
}

TEST_CASE("The run of a world that is moved is edited as before") {
  const test::Workplace place;
  std::filesystem::create_directories(place.file("old").string());
  std::filesystem::create_directories(place.file("new").string());
  for (const char* name : {"old/samples.txt", "new/copy.txt"}) {
    place.write(name, "1 1\n0.2 0.9\n");
  }
  const auto world = [](const std::string& samples) {
    const std::string carried =
        "<sensors><beam_range/></sensors><behaviors><turn_left/></behaviors>"
        "<coordinator><fusion_neural_network training=\"" +
        samples + "\" presentations=\"100\"/></coordinator>";
    return "<world format=\"1\">\n<robots><robot id=\"r1\">" + carried +
           "</robot></robots>\n</world>\n";
  };
  Session session;
  const Json opened = session.open(world("samples.txt"), place.file("old/room.xml").string());
  INFO(opened.dump());
  REQUIRE_FALSE(opened.contains("refused"));
  session.step();
  const Json moved = session.ask({{"do", "move"}, {"file", place.file("new/room.xml").string()}});
  INFO(moved.dump());
  CHECK_THAT(moved["text"].get<std::string>(), Catch::Contains("old/samples.txt"));
  CHECK(session.ask({{"do", "at"}})["time_s"].get<double>() > 0.0);  // the run goes on
  // Files beside the new place are found, for the text and for the run.
  const Json edited =
      session.edit({"robot[r1]/coordinator=<fusion_neural_network "
                    "training=\"copy.txt\" presentations=\"200\"/>"});
  INFO(edited.dump());
  CHECK_FALSE(edited.contains("refused"));
}

TEST_CASE("What is described has the warnings of elsie check") {
  Session session;
  CHECK(session.open(kRoom)["warnings"].empty());
  const Json edited = session.edit({"physics/@cfm=0"});
  REQUIRE(edited["warnings"].size() == 1);
  CHECK_THAT(edited["warnings"][0]["message"].get<std::string>(), Catch::Contains("cfm"));
}

TEST_CASE("A world that is refused says whether plugins may have been made for it") {
  Session session;
  CHECK(session.open("<world format=\"1\"><arena")["made_plugins"] == false);
  CHECK(session.open("<world format=\"1\"><arena lenght=\"4\"/></world>")["made_plugins"] == false);
  CHECK(session.open(room("<limits", "<nonsense/><limits"))["made_plugins"] == true);
}

TEST_CASE("The scene has the outline of a prism, from its middle") {
  Session session;
  session.open(room("<robots>",
                    "<obstacles><static_prism x=\"0\" y=\"1\"><point x=\"0\" y=\"0\"/>"
                    "<point x=\"0\" y=\"0.3\"/><point x=\"0.6\" y=\"0\"/></static_prism>"
                    "<static_cylinder x=\"1\" y=\"1\"/></obstacles><robots>"));
  const Json scene = session.edit({"obstacle[static_cylinder_1]/@radius=0.3"})["scene"];
  const Json &prism = scene["shapes"].at(scene["shapes"].size() - 2),
             &cylinder = scene["shapes"].back();
  INFO(prism.dump());
  REQUIRE(prism["outline"].size() == 3);
  double x = 0.0;
  for (const Json& corner : prism["outline"]) x += corner.at(0).get<double>();
  CHECK(x == Approx(0.0).margin(1e-9));
  CHECK(prism["size"].at(0).get<double>() == Approx(0.8));  // twice the farthest corner
  CHECK(cylinder["shape"] == "cylinder");
  CHECK(cylinder["size"].at(0).get<double>() == Approx(0.6));
  CHECK_FALSE(cylinder.contains("outline"));
}
