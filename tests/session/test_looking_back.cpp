// Sessions: the past of a run, the command that repeats it, recordings, pictures.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

#include "session.h"

using namespace elsie;
using namespace elsie::test;

namespace {

Json at(Session& session, double time_s) { return session.ask({{"do", "at"}, {"time_s", time_s}}); }

float x_of_first(Session& session) {
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  return snapshot->bodies[0].origin[0];
}

void run_to(Session& session, double time_s) {
  session.ask({{"do", "run"}, {"until_s", time_s}});
  session.event("paused");
}

constexpr const char* kDriver = R"(<world format="1">
  <robots>
    <robot id="r1" x="-1">
      <behaviors><go_to_point x="2" y="0"/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <limits time="3"/>
</world>
)";

}  // namespace

TEST_CASE("A paused or ended run can be looked at as it was") {
  Session session;
  REQUIRE_FALSE(session.open(kDriver).contains("refused"));
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();
  const float last = x_of_first(session);

  const Json then = at(session, 1.01);
  CHECK(then["from_s"] == 0.0);
  CHECK(then["to_s"].get<double>() == Approx(3.0));
  CHECK(then["time_s"].get<double>() == Approx(1.0));
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  CHECK(snapshot->facts.time_s == Approx(1.0));
  CHECK(snapshot->bodies[0].origin[0] > -1.0F);
  CHECK(snapshot->bodies[0].origin[0] < last);
  at(session, -5.0);
  CHECK(x_of_first(session) == -1.0F);
  CHECK(session.ask({{"do", "at"}})["time_s"] == then["to_s"]);
  CHECK(x_of_first(session) == last);
}

TEST_CASE("Looking back changes nothing, and a run that goes on cannot be looked back at") {
  Session session;
  session.open(kDriver);
  session.step(30);
  at(session, 0.0);
  CHECK(x_of_first(session) == -1.0F);
  session.step();
  CHECK(session.connection().snapshots().take()->facts.steps > 30);
  session.ask({{"do", "speed"}, {"factor", 0.001}});
  session.ask({{"do", "run"}});
  CHECK(at(session, 0.0).contains("refused"));
  session.ask({{"do", "speed"}, {"factor", 0}});
  const test::Workplace place;
  place.write("driver.xml", kDriver);
  CHECK(session.end_of_run()["state_hash"] == hash_of_run(place, "driver.xml"));
}

TEST_CASE("Looking back tells the numbers of that time, of the robots that are asked for") {
  Session session;
  session.open(kDriver);
  session.edit({kSecond});
  run_to(session, 1.0);
  const auto numbers = [&](double time_s) {
    return session.ask({{"do", "at"}, {"time_s", time_s}, {"robots", {"r1"}}})["numbers"];
  };
  const Json then = numbers(0.5), later = numbers(0.9);
  CHECK(then["r1/distance"].get<double>() > 0.0);
  CHECK(then["r1/distance"] < later["r1/distance"]);
  CHECK(then["r1/go_to_point/share"] == 1.0);
  CHECK_FALSE(then.contains("r2/distance"));
  CHECK(at(session, 0.5)["numbers"].empty());
  const Json start = numbers(0.0);
  CHECK(start["r1/distance"] == 0.0);
  CHECK_FALSE(start.contains("r1/go_to_point/share"));  // nothing was decided yet
}

TEST_CASE("Pictures, messages and reasons of a time are there if they were watched then") {
  Session session;
  const std::string world = "worlds/find_resource.xml";
  session.open(text_of(world), test::source_path(world));
  const auto watch = [&](const std::vector<std::string>& what) {
    session.ask({{"do", "watch"}, {"what", what}});
  };
  watch({"cameras", "sensors", "decisions"});
  run_to(session, 0.5);
  const Json seen = session.latest("state")["robots"][0];
  run_to(session, 1.0);
  watch({});
  run_to(session, 2.0);

  const Json look = at(session, 0.5)["look"];
  REQUIRE(look.is_object());
  CHECK(look["time_s"].get<double>() == Approx(0.5));
  const Json& robot = look["robots"][0];
  CHECK(robot["cameras"] == seen["cameras"]);
  CHECK(robot["cameras"][0]["pictures"].size() == 2);
  CHECK(robot["heard"] == seen["heard"]);
  for (const Json& member : seen["members"]) {
    CHECK(robot["reasons"].value(member["path"].get<std::string>(), "") ==
          member["reason"].get<std::string>());
  }
  CHECK_FALSE(robot.contains("members"));  // they are among the numbers
  CHECK_FALSE(at(session, 1.5).contains("look"));
}

TEST_CASE("What an edit has added was not there before") {
  Session session;
  session.open(kRoom);
  session.step(20);
  session.edit({kSecond});
  session.step();
  at(session, 0.1);
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  REQUIRE(snapshot->bodies.size() == 2);
  CHECK(snapshot->bodies[0].present == 1.0F);
  CHECK(snapshot->bodies[1].present == 0.0F);
}

TEST_CASE("The command line repeats a run with its edits") {
  const test::Workplace place;
  place.write("my room.xml", kRoom);
  Session session;
  session.ask(
      {{"do", "open"}, {"text", kRoom}, {"file", place.file("my room.xml").string()}, {"seed", 5}});
  session.step(50);
  // Two edits before one step: the robot is taken out and comes back, from where it starts.
  std::string without = kRoom;
  const std::size_t begin = without.find("    <robot ");
  without.erase(begin, without.find("</robot>") + 9 - begin);
  REQUIRE_FALSE(session.edit({kSecond}).contains("refused"));
  REQUIRE_FALSE(session.edit({"robot[r1]/@remove=true"}).contains("refused"));
  REQUIRE_FALSE(session.ask({{"do", "become"}, {"text", kRoom}}).contains("refused"));
  session.step();
  REQUIRE_FALSE(session.edit({"robot[r1]/@max_speed=0.2"}).contains("refused"));
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();
  const Json command = session.ask({{"do", "command"}});
  CHECK(command["saved"] == true);
  const std::string text = command["text"];
  INFO(text);
  CHECK_THAT(text, Catch::StartsWith("elsie run "));
  CHECK_THAT(text, Catch::Contains("--seed 5"));
  CHECK(Json::parse(place.sh(text + " --json").out).at("state_hash") == end["state_hash"]);

  session.edit({"robot[r1]/@x=1"});
  CHECK(session.ask({{"do", "command"}})["saved"] == false);
}

TEST_CASE("The run that starts next is recorded, whole, and that alone") {
  const test::Workplace place;
  place.write("room.xml", kRoom);
  Session session;
  session.open(kRoom, place.file("room.xml").string());
  const std::string csv = place.file("a.csv").string(), mcap = place.file("b.mcap").string();
  const auto record = [&](const std::vector<std::string>& files) {
    return session.ask({{"do", "record"}, {"files", files}});
  };
  CHECK(record({"a.txt"}).contains("refused"));
  CHECK(record({"/nowhere/a.csv"}).contains("refused"));
  CHECK_FALSE(record({csv, mcap}).contains("refused"));
  CHECK_FALSE(std::filesystem::exists(csv));
  session.step();
  const Json late = record({csv});
  REQUIRE(late.contains("refused"));
  CHECK_THAT(late["refused"][0]["message"].get<std::string>(), Catch::Contains("reset"));
  session.ask({{"do", "run"}});
  session.end_of_run();

  place.elsie("run " + place.file("room.xml").string() + " --record c.csv --record d.mcap --quiet");
  CHECK(place.read("a.csv") == place.read("c.csv"));
  CHECK(place.read("b.mcap") == place.read("d.mcap"));
  session.ask({{"do", "reset"}});
  std::filesystem::remove(csv);
  session.ask({{"do", "run"}});
  session.end_of_run();
  CHECK_FALSE(std::filesystem::exists(csv));
}

TEST_CASE("No recording replaces a file that is none, or one that the world is read from") {
  const test::Workplace place;
  const std::string walls = place.file("walls.csv").string();
  place.write("walls.csv", "-1 0.5 1 0.5\n");
  Session session;
  session.open(
      "<world format=\"1\"><layouts><floor_plan id=\"p\" file=\"walls.csv\"/></layouts>"
      "<robots><robot id=\"r1\"/></robots><limits time=\"0.1\"/></world>",
      place.file("room.xml").string());
  const auto refusal = [&](const std::string& file) {
    const Json answer = session.ask({{"do", "record"}, {"files", {file}}});
    return answer.contains("refused") ? answer["refused"][0]["message"].get<std::string>() : "";
  };
  CHECK_THAT(refusal(walls), Catch::Contains("already exists and is not a recording"));
  place.elsie("run worlds/open_arena.xml --duration 0.1 --quiet --record other.csv");
  std::filesystem::copy_file(place.file("other.csv"), walls,
                             std::filesystem::copy_options::overwrite_existing);
  CHECK_THAT(refusal(walls), Catch::Contains("is read here, and its content would be lost"));
  CHECK(refusal(place.file("new.csv").string()) == "");
  CHECK(place.read("walls.csv") == place.read("other.csv"));
}

TEST_CASE("A recording that cannot be made refuses the start of the run, once") {
  const test::Workplace place;
  Session session;
  session.open(kRoom);
  const std::string file = place.file("a.csv").string();
  session.ask({{"do", "record"}, {"files", {file}}});
  std::filesystem::create_directory(file);
  CHECK(session.ask({{"do", "run"}}).contains("refused"));
  CHECK_FALSE(session.ask({{"do", "run"}}).contains("refused"));  // without the recording
  session.end_of_run();
  std::filesystem::remove(file);
  session.ask({{"do", "reset"}});
  session.ask({{"do", "record"}, {"files", {file}}});
  CHECK_FALSE(session.ask({{"do", "run"}}).contains("refused"));
  session.end_of_run();
  CHECK(std::filesystem::is_regular_file(file));
}

TEST_CASE("The present is drawn from above, with the paths so far, as a file of any kind") {
  const test::Workplace place;
  Session session;
  session.open(kRoom);
  session.step(50);
  for (const auto& [name, begins] : std::map<std::string, std::string>{
           {"now.png", "\x89PNG"}, {"now.svg", "<?xml"}, {"now.pdf", "%PDF"}}) {
    CAPTURE(name);
    const Json answer =
        session.ask({{"do", "picture"}, {"file", place.file(name).string()}, {"width", 400}});
    CHECK(answer["warnings"] == Json::array());
    CHECK(place.read(name).starts_with(begins));
  }
  SECTION("what cannot be drawn is refused with a sentence, and the run goes on") {
    const Json refused =
        session.ask({{"do", "picture"}, {"file", place.file("none/now.png").string()}});
    REQUIRE(refused.contains("refused"));
    CHECK_THAT(refused["refused"][0]["message"].get<std::string>(), Catch::Contains("now.png"));
    CHECK(session.ask({{"do", "picture"}, {"file", place.file("now.gif").string()}})
              .contains("refused"));
    session.step();
  }
}

TEST_CASE("A run goes on to a time as fast as it can, and says that it pauses there") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "speed"}, {"factor", 0.001}});
  session.ask({{"do", "run"}, {"until_s", 1.25}});
  CHECK(session.event("paused")["time_s"] == Approx(1.25));
  CHECK(session.ask({{"do", "at"}})["time_s"] == Approx(1.25));
  CHECK(session.ask({{"do", "run"}, {"until_s", "soon"}}).contains("refused"));
  session.ask({{"do", "speed"}, {"factor", 0.0}});
  session.ask({{"do", "run"}});
  const test::Workplace place;
  place.write("room.xml", kRoom);
  CHECK(session.end_of_run()["state_hash"] == hash_of_run(place, "room.xml"));
}

TEST_CASE("A time limit that has passed is refused, and the run goes on") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "run"}, {"until_s", 1.0}});
  session.event("paused");
  const Json refused = session.edit({"limits/@time=0.5"});
  REQUIRE(refused.contains("refused"));
  CHECK_THAT(refused["refused"][0]["message"].get<std::string>(),
             Catch::Contains("limits/@time would be 0.5 s, but the run is at 1 s already"));
  session.ask({{"do", "run"}, {"until_s", 1.5}});
  CHECK(session.event("paused")["time_s"] == Approx(1.5));
}

TEST_CASE("A run to a time that it has reached makes no step, and says so") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "run"}, {"until_s", 0.0}});
  CHECK(session.event("paused")["steps"] == 0);
  session.ask({{"do", "run"}, {"until_s", 1.0}});
  const Json first = session.event("paused");
  for (const double until_s : {1.0, 0.5, -1.0}) {
    CHECK_FALSE(session.ask({{"do", "run"}, {"until_s", until_s}}).contains("refused"));
    CHECK(session.event("paused") == first);
  }
  session.ask({{"do", "run"}});
  session.end_of_run();
  CHECK(session.ask({{"do", "run"}, {"until_s", 1.0}}).contains("refused"));
}

TEST_CASE(
    "A run that is paced goes to its time at its speed, and pauses as a run that ends there") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "speed"}, {"factor", 2.0}});
  const auto begun = std::chrono::steady_clock::now();
  session.ask({{"do", "run"}, {"until_s", 1.0}, {"paced", true}});
  const Json paused = session.event("paused");
  CHECK(std::chrono::steady_clock::now() - begun > std::chrono::milliseconds(450));
  CHECK(paused["time_s"] == Approx(1.0));
  const test::Workplace place;
  place.write("room.xml", std::regex_replace(kRoom, std::regex("time=\"2\""), "time=\"1\""));
  CHECK(paused["state_hash"] == hash_of_run(place, "room.xml"));
}
