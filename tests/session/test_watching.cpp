// Sessions: what a window watches, which changes nothing.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <thread>

#include "elsie/files/base64.h"

#include "session.h"

using namespace elsie;
using namespace elsie::test;

namespace {

Json watch(Session& session, const std::vector<std::string>& what,
           const std::vector<std::string>& robots = {}) {
  return session.ask({{"do", "watch"}, {"what", what}, {"robots", robots}});
}

const std::vector<std::string> kEverything{"decisions", "sensors", "cameras", "fuzzy", "graphs",
                                           "measures",  "fields",  "lights",  "stuck"};

void open_shipped(Session& session, const std::string& world) {
  const std::string file = test::source_path("worlds/" + world);
  const Json opened = session.open(text_of("worlds/" + world), file);
  INFO(opened.dump());
  REQUIRE_FALSE(opened.contains("refused"));
}

Json step(Session& session, int count = 1) {
  session.step(count);
  session.ask({{"do", "command"}});  // what has come before its answer is here
  return session.latest("state");
}

}  // namespace

TEST_CASE("Watching begins at once, and shows what robots decide and sense") {
  Session session;
  open_shipped(session, "clutter.xml");
  REQUIRE_FALSE(watch(session, {"decisions", "sensors", "measures"}).contains("refused"));
  const Json before = session.event("state");
  CHECK(before["time_s"] == 0.0);
  REQUIRE(before["robots"].size() > 0);
  CHECK(before["robots"][0]["members"][0]["asked"] == false);

  const Json state = step(session, 3);
  const Json& robot = state["robots"][0];
  CHECK(robot["id"] == "r1");
  CHECK(robot["energy"].is_number());
  CHECK(robot["asked"].size() == 3);
  CHECK(robot["possible"].size() == 3);
  CHECK_FALSE(robot["coordinator"].get<std::string>().empty());
  const Json& member = robot["members"][0];
  for (const char* name :
       {"path", "plugin", "coordinator", "depth", "parent", "priority", "activation", "strength",
        "weight", "share", "asked", "command", "inhibited_by", "reason"}) {
    CHECK(member.contains(name));
  }
  CHECK(std::any_of(robot["members"].begin(), robot["members"].end(),
                    [](const Json& each) { return each["asked"] == true; }));
  const Json& sensor = robot["sensors"][0];
  CHECK(sensor["fields"][0]["name"] == "distance_m");
  CHECK(sensor["fields"][0]["unit"] == "m");
  CHECK(sensor["fields"][0]["values"][0].get<double>() > 0.0);
  CHECK_FALSE(robot.contains("cameras"));
  CHECK_FALSE(robot.contains("fuzzy"));
}

TEST_CASE("States come, too, to a window that asks for the past with each picture") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "speed"}, {"factor", 0.5}});
  watch(session, {"decisions"});
  session.ask({{"do", "run"}});
  std::size_t states = 0;
  for (int picture = 0; picture < 30; ++picture) {
    session.connection().send({{"id", 1000 + picture}, {"do", "paths"}});
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (const Json& message : session.connection().receive()) {
      states += message.value("event", "") == "state" ? 1 : 0;
    }
  }
  CHECK(states >= 5);
}

TEST_CASE("Only what is watched comes, of the robots that are watched") {
  Session session;
  session.open(kRoom);
  session.edit({kSecond});
  watch(session, {"sensors"}, {"r2"});
  const Json state = session.event("state");
  REQUIRE(state["robots"].size() == 1);
  CHECK(state["robots"][0]["id"] == "r2");
  CHECK_FALSE(state["robots"][0].contains("members"));
  CHECK(watch(session, {"thoughts"}).contains("refused"));
  watch(session, {});
  session.ask({{"do", "step"}});
  session.ask({{"do", "catalog"}});
  CHECK_FALSE(session.has_event("state"));
}

TEST_CASE("Camera pictures come raw and processed, as RGB bytes in base64") {
  Session session;
  open_shipped(session, "find_resource.xml");
  watch(session, {"cameras"});
  CHECK(session.event("state")["robots"][0]["cameras"].empty());
  const Json state = step(session);
  const Json& pictures = state["robots"][0]["cameras"][0]["pictures"];
  REQUIRE(pictures.size() == 2);
  CHECK(pictures[0]["name"] == "raw");
  CHECK(pictures[1]["name"] == "processed");
  for (const Json& picture : pictures) {
    const std::size_t bytes =
        3 * picture["width"].get<std::size_t>() * picture["height"].get<std::size_t>();
    CHECK(picture["pixels"].get<std::string>().size() == (bytes + 2) / 3 * 4);
  }
}

TEST_CASE("Fuzzy models come with their file and the numbers of this instant") {
  Session session;
  open_shipped(session, "clutter.xml");
  watch(session, {"fuzzy", "sensors", "decisions"});
  CHECK(session.event("state")["robots"][0]["fuzzy"].empty());
  const Json state = step(session);
  const Json& robot = state["robots"][0];
  REQUIRE(robot["fuzzy"].size() == 2);  // a wheel each
  double nearest = 1e9;
  for (const Json& sensor : robot["sensors"]) {
    const Json& field = sensor["fields"][0];
    if (field["name"] == "distance_m") {
      nearest = std::min(nearest, field["values"][0].get<double>());
    }
  }
  for (const Json& model : robot["fuzzy"]) {
    CHECK_THAT(model["path"].get<std::string>(), Catch::Contains("avoid"));
    CHECK(std::filesystem::path(model["file"].get<std::string>()).is_absolute());
    CHECK(std::filesystem::exists(model["file"].get<std::string>()));
    CHECK(model["inputs"]["range"].get<double>() == Approx(nearest));
    CHECK(model["inputs"]["azimuth"].is_number());
    CHECK(model["outputs"].size() == 1);
  }
}

TEST_CASE("A fuzzy coordinator shows its rules' inputs and outputs") {
  Session session;
  open_shipped(session, "contexts.xml");
  watch(session, {"fuzzy"});
  const Json state = step(session);
  bool found = false;
  for (const Json& model : state["robots"][0]["fuzzy"]) {
    found = found || (model["path"] == "fusion_context_blending" && model["inputs"].size() > 0 &&
                      model["outputs"].size() > 0);
  }
  INFO(state.dump());
  CHECK(found);
}

TEST_CASE("The graphs of coordinators come with what is lit in them, nested ones by their paths") {
  Session session;
  session.open(R"(<world format="1"><robots>
    <robot id="r1">
      <behaviors>
        <blend id="errand">
          <behaviors><wander/></behaviors>
          <coordinator><arbiter_tree><run behavior="wander"/></arbiter_tree></coordinator>
        </blend>
      </behaviors>
      <coordinator><arbiter_states>
        <state name="work"><state name="go" behavior="errand">
          <transition to="stand" after="0.1"/></state></state>
        <state name="stand" ends="success"/>
      </arbiter_states></coordinator>
    </robot>
    <robot id="r2" x="1"><behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator></robot>
    </robots></world>)");
  watch(session, {"graphs"});
  const Json begun = session.event("state");
  CHECK(begun["robots"][1]["graphs"].empty());
  const Json& graphs = begun["robots"][0]["graphs"];
  REQUIRE(graphs.size() == 2);
  CHECK(graphs[0]["path"] == "arbiter_states");
  CHECK(graphs[0]["nodes"] == Json::parse(R"([{"label": "work"}, {"label": "go", "within": 0},
                                              {"label": "stand"}])"));
  CHECK(graphs[0]["edges"] == Json::parse(R"([{"from": 1, "to": 2, "label": "after 0.1 s"}])"));
  CHECK(graphs[0]["running"] == Json({0, 1}));
  CHECK(graphs[1]["path"] == "errand/arbiter_tree");
  CHECK(graphs[1]["running"].empty());

  const Json going = step(session)["robots"][0]["graphs"];
  CHECK(going[1]["running"] == Json({0}));
  CHECK(step(session, 20)["robots"][0]["graphs"][0]["running"] == Json({2}));
  watch(session, {"sensors"});
  CHECK_FALSE(session.event("state")["robots"][0].contains("graphs"));
}

TEST_CASE("Whatever is watched, the run is the same") {
  const std::string world = GENERATE("find_resource.xml", "contexts.xml", "fetch.xml");
  Session session;
  open_shipped(session, world);
  watch(session, kEverything);
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();
  CHECK(session.latest("state")["time_s"] == end["time_s"]);
  CHECK(end["state_hash"] ==
        hash_of_run(test::Workplace(), test::source_path("worlds/" + world) + " --seed 1"));
  CHECK(end["measures"]["time_s"] == end["time_s"]);
}

TEST_CASE("At most thirty states come a second, however fast the run") {
  Session session;
  open_shipped(session, "clutter.xml");
  watch(session, {"decisions"});
  session.event("state");
  const auto start = std::chrono::steady_clock::now();
  session.ask({{"do", "run"}});
  session.end_of_run();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::size_t count = 0;
  while (session.has_event("state")) {
    session.event("state");
    ++count;
  }
  CHECK(count >= 1);
  CHECK(static_cast<double>(count) <= 31.0 * taken.count() + 2.0);
}

TEST_CASE("A window that reads nothing does not hold up the run") {
  Session session;
  open_shipped(session, "find_resource.xml");
  session.ask({{"do", "speed"}, {"factor", 2}});  // as fast as possible it may end meanwhile
  watch(session, kEverything);
  session.ask({{"do", "run"}});
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  const double then_s = snapshot->facts.time_s;
  // Snapshots are made only once the last one is taken.
  for (int i = 0; i < 2; ++i) {
    double later_s = 0.0;
    REQUIRE(comes_true([&] {
      const auto later = session.connection().snapshots().take();
      later_s = later ? later->facts.time_s : 0.0;
      return later.has_value();
    }));
    CHECK(later_s > then_s);
  }
}

TEST_CASE("Events and notes of a run come as they arise") {
  Session session;
  open_shipped(session, "clutter.xml");
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();
  double last_s = 0.0;
  std::size_t collisions = 0;
  while (session.has_event("raised")) {
    const Json event = session.event("raised");
    CHECK(event["time_s"].get<double>() >= last_s);
    last_s = event["time_s"];
    CHECK(event.contains("robot"));
    CHECK(event.contains("detail"));
    collisions += event["name"] == "collision" ? 1 : 0;
  }
  CHECK(collisions == end["measures"]["collisions"].get<std::size_t>());

  std::string text = kRoom;
  text.replace(text.find("<robots>"), 8, "<physics cfm=\"0\"/><robots>");
  session.open(text);
  const Json note = session.event("note");
  CHECK_THAT(note["text"].get<std::string>(), Catch::Contains("physics: "));
  session.ask({{"do", "run"}});
  CHECK(session.end_of_run()["notes"][0] == note["text"]);
}

TEST_CASE("Fields of the floor are watched as opacities, from south to north") {
  Session session;
  session.open(R"(<world format="1"><arena length="4" width="2"/>
    <fields><field id="heat" cell="0.5" start="1" full="2" colour="#ff0000"/></fields></world>)");
  watch(session, {"fields"});
  const Json state = session.event("state");
  REQUIRE(state["fields"].size() == 1);
  const Json& field = state["fields"][0];
  CHECK(field["id"] == "heat");
  CHECK(field["columns"] == 8);
  CHECK(field["rows"] == 4);
  CHECK(field["colour"] == Json::array({255, 0, 0}));
  const auto opacity = files::unpacked<std::uint8_t>(field["opacity"].get<std::string>());
  REQUIRE(opacity);
  CHECK(*opacity == std::vector<std::uint8_t>(32, 108));
  watch(session, {"measures"});
  CHECK_FALSE(session.event("state").contains("fields"));
}

TEST_CASE("What robots shine is watched as shapes like those of lamps") {
  Session session({"--plugin", test::source_path("examples/09-acts/signal.cpp")});
  const Json opened = session.open(R"(<world format="1"><robots>
    <robot id="r1" x="0.5"><actuators><led x="0" y="0"/></actuators>
      <behaviors><signal/></behaviors></robot></robots></world>)");
  CHECK(opened["scene"]["has_actuators"] == true);
  watch(session, {"lights"});
  CHECK(session.event("state")["lights"].empty());
  const Json state = step(session, 3);
  REQUIRE(state["lights"].size() == 1);
  CHECK(state["lights"][0]["colour"] == Json::array({255, 200, 0}));
  CHECK(state["lights"][0]["frame"][0][0].get<double>() == Approx(0.5).margin(0.01));
  CHECK(state["lights"][0]["shape"] == "sphere");
}

TEST_CASE("What a robot hears is watched beside its sensors") {
  Session session({"--plugin", test::source_path("examples/09-acts/tell.cpp")});
  const std::string file = test::source_path("examples/09-acts/told.xml");
  std::string world = text_of("examples/09-acts/told.xml");
  world.replace(world.find("loss=\"0.5\""), 10, "");
  REQUIRE_FALSE(session.open(world, file).contains("refused"));
  watch(session, {"sensors"}, {"a"});
  CHECK(session.event("state")["robots"][0]["heard"].empty());
  const Json heard = step(session, 3)["robots"][0]["heard"];
  REQUIRE(heard.size() == 1);
  CHECK(heard[0]["by"] == "radio");
  CHECK(heard[0]["from"] == "scout");
  CHECK(heard[0]["fields"][0]["values"][0].get<double>() == Approx(1.4));
}

namespace {

/// A robot between two places that pull it alike, and one that goes round in circles.
constexpr const char* kPulled = R"(<world format="1">
  <arena length="8" width="8"/>
  <resources><resource id="far" x="3" y="3"/><resource id="gone" x="2" y="-3"/></resources>
  <robots>
    <robot id="torn" x="-1">
      <behaviors><go_to_point id="upper" x="0" y="2"/><go_to_point id="lower" x="0" y="-2"/></behaviors>
      <coordinator><fusion_vector_summation/></coordinator>
    </robot>
    <robot id="walled" x="-3.6" y="3" heading_deg="180">
      <behaviors><wander turn="0" restlessness="0"/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <goals><collect/><reach robot="torn" x="0" y="2" radius="0.5"/></goals>
  <limits time="40"/>
</world>
)";

}  // namespace

TEST_CASE("A robot that stands still for ten seconds is reported with what keeps it there") {
  Session session;
  REQUIRE_FALSE(session.open(kPulled).contains("refused"));
  watch(session, {"stuck"});
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();
  const Json stuck = session.latest("stuck");
  CHECK_FALSE(session.has_event("state"));
  for (const Json& said : {stuck, end}) {
    INFO(said.dump());
    REQUIRE(said["stuck_count"] == 2);
    CHECK(said["troubled_count"] == 2);
    CHECK(said["stuck"][0]["robot"] == "torn");
    CHECK(said["stuck"][0]["why"] == "cancel");
    CHECK(said["stuck"][0]["behaviors"].size() == 2);
    CHECK(said["stuck"][1]["robot"] == "walled");
    CHECK(said["stuck"][1]["why"] == "blocked");
    CHECK(said["stuck"][1]["since_s"] < 10.0);
  }
  CHECK(end["outcome"] == "time_limit");
  REQUIRE(end["open_goals"].size() == 2);
  CHECK(end["open_goals"][0]["missing"] == 2);
  CHECK(end["open_goals"][1]["robot"] == "torn");
  CHECK(end["open_goals"][1]["missing_m"] > 1.0);
}

TEST_CASE("Of the robots that nobody asks to move, those that an open goal needs come first") {
  Session session;
  REQUIRE_FALSE(session
                    .open(R"(<world format="1">
  <arena length="8" width="8"/>
  <robots>
    <robot id="idle"><behaviors><go_to_point x="0" y="0"/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
    <robot id="needed" x="2"><behaviors><go_to_point x="2" y="0"/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
  </robots>
  <goals><reach robot="needed" x="-2" y="0"/></goals>
  <limits time="12"/>
</world>)")
                    .contains("refused"));
  watch(session, {"stuck"});
  session.ask({{"do", "run"}});
  session.end_of_run();
  const Json stuck = session.latest("stuck");
  INFO(stuck.dump());
  CHECK(stuck["troubled_count"] == 0);
  CHECK(stuck["awaited_count"] == 1);
  REQUIRE(stuck["stuck_count"] == 2);
  CHECK(stuck["stuck"][0]["robot"] == "needed");
}

TEST_CASE("Of a goal that one robot is enough for, what is missing of the nearest is open") {
  Session session;
  REQUIRE_FALSE(session
                    .open(R"(<world format="1">
  <arena length="8" width="8"/>
  <nests><nest id="home" x="3" y="3" radius="0.3"/></nests>
  <resources><resource id="food" x="3" y="-3" collect="nest"/></resources>
  <robots>
    <robot id="near" x="2"><behaviors><wander/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
    <robot id="far" x="-2"><behaviors><wander/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>
  </robots>
  <goals>
    <reach any="true" x="2" y="0" radius="2"/>
    <reach any="true" x="3.5" y="3.5" radius="0.1"/>
    <deliver count="2"/>
  </goals>
  <limits time="1"/>
</world>)")
                    .contains("refused"));
  watch(session, {"stuck"});
  session.ask({{"do", "run"}});
  const Json open = session.end_of_run()["open_goals"];
  INFO(open.dump());
  REQUIRE(open.size() == 2);  // the first is reached
  CHECK(open[0]["robot"] == "near");
  CHECK(open[1]["goal"] == "deliver");
  CHECK(open[1]["missing"] == 2);
}

TEST_CASE(
    "A goal to keep was broken by the robot that it is about, not by the last that collided") {
  Session session;
  const auto driver = [](const std::string& id, double y) {
    const std::string at = "\" y=\"" + std::to_string(y);
    return "<robot id=\"" + id + at + "\"><behaviors><go_to_point x=\"1.95" + at +
           "\"/></behaviors><coordinator><arbiter_suppression/></coordinator></robot>";
  };
  REQUIRE_FALSE(session
                    .open("<world format=\"1\"><arena length=\"4\" width=\"4\"/><obstacles>"
                          "<static_box x=\"1\" y=\"1\"/><static_box x=\"1\" y=\"-1\"/>"
                          "</obstacles><robots>" +
                          driver("watched", 1.0) + driver("other", -1.0) +
                          "</robots><goals><no_collision robot=\"watched\"/></goals>"
                          "<limits time=\"60\"/></world>")
                    .contains("refused"));
  watch(session, {"stuck"});
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();
  INFO(end.dump());
  CHECK(end["outcome"] == "failure");
  CHECK(end["broken_by"]["robot"] == "watched");
}

TEST_CASE("Who is not watched is not judged, and who drives is not stuck") {
  Session session;
  open_shipped(session, "find_resource.xml");
  watch(session, {"stuck"});
  session.ask({{"do", "run"}, {"until_s", 30.0}});
  session.event("paused");
  CHECK_FALSE(session.has_event("stuck"));
  session.ask({{"do", "reset"}});
  watch(session, {});
  session.ask({{"do", "run"}});
  CHECK_FALSE(session.end_of_run().contains("stuck"));
}
