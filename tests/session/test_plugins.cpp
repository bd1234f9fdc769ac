// Plugins that are written while a session is open.
#include "session.h"

using namespace elsie;
using namespace elsie::test;

namespace {

void write(const test::Workplace& place, const std::string& name, const std::string& speed) {
  place.write("mine.cpp",
              "#include <elsie/api/behavior.h>\n"
              "class Mine final : public elsie::Behavior {\n"
              " public:\n"
              "  double speed = " +
                  speed +
                  ";\n"
                  "  elsie::Response respond(const elsie::Perception&) override {\n"
                  "    return elsie::Motion{.forward = speed};\n"
                  "  }\n"
                  "};\n"
                  "ELSIE_BEHAVIOR(Mine, \"" +
                  name +
                  "\", \"drives\",\n"
                  "  elsie::parameter(\"speed\", &Mine::speed, {}));\n");
}

/// Of the behaviour `mine`; none if the catalog does not have it.
std::optional<double> default_speed(Session& session) {
  const Json catalog = session.ask({{"do", "catalog"}});
  for (const Json& plugin : catalog["plugins"]) {
    if (plugin["name"] == "mine") return plugin["parameters"][0]["default"].get<double>();
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("A plugin that changes on disk is taken, before, in and after a run") {
  const test::Workplace place;
  write(place, "mine", "0.1");
  Session session({"--plugin", place.file("mine.cpp").string()});
  std::string text = kRoom;
  text.replace(text.find("turn_left"), 9, "mine");
  text.replace(text.find("time=\"2\""), 8, "time=\"1000\"");
  const Json opened = session.open(text);
  INFO(opened.dump());
  REQUIRE_FALSE(opened.contains("refused"));
  CHECK(default_speed(session) == 0.1);

  write(place, "mine", "0.2");
  const Json before = session.event("plugins");
  INFO(before.dump());
  CHECK(before["problems"].empty());
  CHECK(before["files"].size() == 1);
  CHECK(before["epoch"] > opened["epoch"]);
  CHECK(default_speed(session) == 0.2);

  session.ask({{"do", "speed"}, {"factor", 1}});
  session.ask({{"do", "run"}});
  write(place, "mine", "0.05");
  CHECK(session.event("plugins")["problems"].empty());
  CHECK(default_speed(session) == 0.05);
  session.step();
  session.ask({{"do", "watch"}, {"what", {"decisions"}}});
  CHECK(session.event("state")["robots"][0]["asked"][0] == 0.05);

  write(place, "yours", "0.3");  // the world could not be read with it
  const Json kept = session.event("plugins");
  INFO(kept.dump());
  CHECK_FALSE(kept["problems"].empty());
  session.step();
  CHECK(session.ask({{"do", "reset"}})["text"] == text);
}

TEST_CASE("A plugin that does not compile yet is followed until it does") {
  const test::Workplace place;
  write(place, "mine", "no number");
  std::optional<Session> session;

  SECTION("from the beginning of the session") {
    session.emplace(std::vector<std::string>{"--draft", place.file("mine.cpp").string()});
  }
  SECTION("from an order on") {
    session.emplace();
    session->ask({{"do", "plugin"}, {"file", place.file("mine.cpp").string()}});
  }
  const Json broken = session->event("plugins");
  INFO(broken.dump());
  REQUIRE(broken["problems"].size() == 1);
  CHECK_THAT(broken["problems"][0].get<std::string>(), Catch::Contains("mine.cpp:4"));
  CHECK_FALSE(default_speed(*session));

  write(place, "mine", "0.3");
  const Json renewed = session->event("plugins");
  INFO(renewed.dump());
  CHECK(renewed["problems"].empty());
  CHECK(default_speed(*session) == 0.3);
}

TEST_CASE("A file that is no plugin is named in a sentence") {
  const test::Workplace place;
  place.write("notes.txt", "behaviours to write");
  Session session;
  for (const std::string& file :
       {place.file("none.cpp").string(), place.file("notes.txt").string()}) {
    session.ask({{"do", "plugin"}, {"file", file}});
    const Json told = session.event("plugins");
    INFO(told.dump());
    CHECK(told["files"].empty());
    REQUIRE(told["problems"].size() == 1);
    CHECK_THAT(told["problems"][0].get<std::string>(), Catch::Contains(file));
  }
}
