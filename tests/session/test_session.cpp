// Sessions: a document and its run in a process of their own.
#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>
#include <poll.h>

#include "elsie/client/connection.h"

#include "places.h"
#include "program.h"

using namespace elsie;
using client::Connection;
using client::Json;

namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(test::source_path(file));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

constexpr const char* kRoom = R"(<world format="1">
  <!-- a room -->
  <arena length="4" width="4"/>
  <robots>
    <robot id="r1" x="-1">
      <behaviors><turn_left/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot>
  </robots>
  <limits time="2"/>
</world>
)";

constexpr const char* kSecond =
    "robot[+]=<robot id=\"r2\" x=\"1\"><behaviors><turn_right/></behaviors>"
    "<coordinator><arbiter_suppression/></coordinator></robot>";

class Session {
 public:
  explicit Session(const std::vector<std::string>& arguments = {})
      : connection_(test::build_path("bin/elsie"), arguments) {}

  Connection& connection() { return connection_; }

  /// Sends an order and waits for its answer; what comes meanwhile is kept for event().
  Json ask(Json order) {
    order["id"] = ++last_id_;
    connection_.send(order);
    return wait([&](const Json& message) { return message.value("answer", 0) == last_id_; });
  }
  Json open(const std::string& text, const std::string& file = "") {
    return ask({{"do", "open"}, {"text", text}, {"file", file}});
  }
  Json edit(const std::vector<std::string>& edits) {
    return ask({{"do", "edit"}, {"edits", edits}});
  }
  Json end_of_run() {
    return wait([](const Json& message) { return message.value("event", "") == "ended"; });
  }
  client::SessionEnd end() {
    wait([](const Json&) { return false; });
    REQUIRE(end_);
    return *end_;
  }

 private:
  Json wait(const std::function<bool(const Json&)>& is_it) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (std::chrono::steady_clock::now() < patience) {
      for (Json& message : connection_.receive()) {
        kept_.push_back(std::move(message));
      }
      for (auto it = kept_.begin(); it != kept_.end(); ++it) {
        if (is_it(*it)) {
          const Json found = *it;
          kept_.erase(it);
          return found;
        }
      }
      if (const auto end = connection_.ended()) {
        end_ = *end;
        return {};
      }
      pollfd waiting{connection_.descriptor(), POLLIN, 0};
      poll(&waiting, 1, 100);
    }
    FAIL("no answer within two minutes");
    return {};
  }

  Connection connection_;
  std::vector<Json> kept_;
  std::optional<client::SessionEnd> end_;
  int last_id_ = 0;
};

std::string hash_of_run(const test::Workplace& place, const std::string& arguments) {
  return Json::parse(place.elsie("run --json " + arguments).out).at("state_hash");
}

}  // namespace

TEST_CASE("An opened world is described: its text, its elements, its shapes") {
  Session session;
  const Json answer = session.open(kRoom);
  CHECK(answer["text"] == kRoom);
  CHECK(answer["tree"]["name"] == "world");
  CHECK(answer["scene"]["arena"] == Json({4.0, 4.0}));
  REQUIRE(answer["scene"]["bodies"].size() == 1);
  CHECK(answer["scene"]["bodies"][0]["path"] == "robot[r1]");

  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  CHECK(snapshot->facts.steps == 0);
  REQUIRE(snapshot->bodies.size() == 1);
  CHECK(snapshot->bodies[0].origin[0] == -1.0F);
}

TEST_CASE("A world with mistakes is refused with each file, line and sentence") {
  Session session;
  const Json answer =
      session.open("<world format=\"1\">\n  <arena lenght=\"4\"/>\n</world>\n", "w.xml");
  REQUIRE(answer.contains("refused"));
  CHECK(answer["refused"][0]["file"] == "w.xml");
  CHECK(answer["refused"][0]["line"] == 2);
  CHECK_THAT(answer["refused"][0]["message"].get<std::string>(), Catch::Contains("lenght"));
  CHECK(session.ask({{"do", "run"}}).contains("refused"));
}

TEST_CASE("A run in a session is that of the program, bit for bit") {
  const std::string world = GENERATE("clutter.xml", "find_resource.xml", "train.xml");
  const std::string file = test::source_path("worlds/" + world);
  Session session;
  REQUIRE_FALSE(
      session
          .ask({{"do", "open"}, {"text", text_of("worlds/" + world)}, {"file", file}, {"seed", 3}})
          .contains("refused"));
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();
  CHECK(end["state_hash"] == hash_of_run(test::Workplace(), file + " --seed 3"));

  SECTION("also after a reset") {
    session.ask({{"do", "reset"}});
    session.ask({{"do", "run"}});
    CHECK(session.end_of_run()["state_hash"] == end["state_hash"]);
  }
}

TEST_CASE("An edit changes the text where it must, and can be undone") {
  Session session;
  session.open(kRoom);
  const Json edited = session.edit({"robot[r1]/@x=1"});
  REQUIRE(edited.contains("undo"));
  std::string expected = kRoom;
  expected.replace(expected.find("x=\"-1\""), 6, "x=\"1\"");
  CHECK(edited["text"] == expected);
  CHECK(session.connection().snapshots().take()->bodies[0].origin[0] == 1.0F);

  const Json undone = session.ask({{"do", "undo"}, {"edit", edited["undo"]}});
  CHECK(undone["text"] == kRoom);

  const Json refused = session.edit({"robot[r1]/@x=9"});
  REQUIRE(refused.contains("refused"));
  CHECK(session.ask({{"do", "reset"}})["text"] == kRoom);
}

TEST_CASE("A run that is under way becomes the edited world, as with --at") {
  Session session;
  session.open(kRoom);
  // The first decision is at time 0; after 50 more, 0.5 s have passed.
  for (int i = 0; i < 50; ++i) {
    session.ask({{"do", "step"}});
  }
  const Json edited = session.edit({kSecond});
  REQUIRE_FALSE(edited.contains("refused"));
  CHECK(edited["scene"]["bodies"].size() == 2);
  session.ask({{"do", "run"}});
  const Json end = session.end_of_run();

  const test::Workplace place;
  place.write("room.xml", kRoom);
  CHECK(end["state_hash"] ==
        hash_of_run(place, "room.xml --at '0.5:" + std::string(kSecond) + "'"));
}

TEST_CASE("A run can be paused, paced and left") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "speed"}, {"factor", 0.5}});
  session.ask({{"do", "run"}});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  session.ask({{"do", "pause"}});
  const auto paused = session.connection().snapshots().take();
  REQUIRE(paused);
  const std::uint64_t steps = paused->facts.steps;
  CHECK(paused->facts.time_s > 0.0);
  CHECK(paused->facts.time_s < 1.0);
  session.ask({{"do", "step"}});
  CHECK(session.ask({{"do", "pause"}}).contains("answer"));
  CHECK(session.connection().snapshots().take()->facts.steps == steps + 1);
  session.ask({{"do", "reset"}});
  CHECK(session.connection().snapshots().take()->facts.steps == 0);
}

TEST_CASE("A plugin that ends its process leaves the other end alive, with its name") {
  const std::string plugin = GENERATE("throwing", "segfaulting", "exiting", "smashing_stack");
  Session session({"--plugin", test::build_path("tests/program/plugins/faulty.so")});
  std::string text = kRoom;
  text.replace(text.find("turn_left"), 9, plugin);
  const Json opened = session.open(text);
  INFO(opened.dump());
  REQUIRE_FALSE(opened.contains("refused"));
  session.ask({{"do", "run"}});
  const client::SessionEnd end = session.end();
  CHECK(end.exit_code == 3);
  CHECK_THAT(end.report, Catch::Contains("'" + plugin + "'"));
}

TEST_CASE("What is no program of sessions is refused") {
  CHECK_THROWS_WITH(Connection("/nowhere/elsie", {}), Catch::Contains("/nowhere/elsie"));
}
