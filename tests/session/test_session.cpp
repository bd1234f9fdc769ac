// Sessions: a document and its run in a process of their own.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <sys/socket.h>
#include <sys/wait.h>

#include "session.h"

using namespace elsie;
using namespace elsie::test;
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
  const std::string world = GENERATE("clutter.xml", "train.xml");
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

TEST_CASE("An edit changes the text where it must") {
  Session session;
  session.open(kRoom);
  const Json edited = session.edit({"robot[r1]/@x=1"});
  std::string expected = kRoom;
  expected.replace(expected.find("x=\"-1\""), 6, "x=\"1\"");
  CHECK(edited["text"] == expected);
  CHECK(session.connection().snapshots().take()->bodies[0].origin[0] == 1.0F);

  const Json refused = session.edit({"robot[r1]/@x=9"});
  REQUIRE(refused.contains("refused"));
  CHECK(session.ask({{"do", "reset"}})["text"] == expected);
}

TEST_CASE("A run can be paused, paced and left") {
  Session session;
  session.open(kRoom);
  constexpr double kSpeed = 0.1;
  session.ask({{"do", "speed"}, {"factor", kSpeed}});
  const auto begun = std::chrono::steady_clock::now();
  session.ask({{"do", "run"}});
  REQUIRE(comes_true([&] {
    const auto snapshot = session.connection().snapshots().take();
    return snapshot && snapshot->facts.time_s > 0.025;
  }));
  session.ask({{"do", "pause"}});
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
  const auto paused = session.connection().snapshots().take();
  REQUIRE(paused);
  const std::uint64_t steps = paused->facts.steps;
  CHECK(paused->facts.time_s > 0.025);
  CHECK(paused->facts.time_s < kSpeed * taken.count() + 0.02);  // a control period ahead
  session.step();
  CHECK(session.ask({{"do", "pause"}}).contains("answer"));
  CHECK(session.connection().snapshots().take()->facts.steps == steps + 1);
  session.ask({{"do", "reset"}});
  CHECK(session.connection().snapshots().take()->facts.steps == 0);
}

TEST_CASE("Orders without sense are refused, and change nothing") {
  Session session;
  session.open(kRoom);
  for (const Json& order :
       {Json{{"do", 5}}, Json{{"do", "dance"}}, Json{{"what", "edit"}}, Json{{"do", "edit"}},
        Json{{"do", "edit"}, {"edits", 7}}, Json{{"do", "become"}},
        Json{{"do", "at"}, {"time_s", "now"}}, Json{{"do", "watch"}},
        Json{{"do", "watch"}, {"what", "all"}}, Json{{"do", "record"}}, Json{{"do", "open"}},
        Json{{"do", "speed"}, {"factor", "fast"}}, Json{{"do", "speed"}, {"factor", -1.0}},
        Json{{"do", "reset"}, {"seed", -1}}, Json{{"do", "reset"}, {"seed", 1.7}},
        Json{{"do", "reset"}, {"seed", 18446744073709551616.0}},
        Json{{"do", "reset"}, {"seed", "1"}},
        Json{{"do", "open"}, {"text", kRoom}, {"seed", -1}}}) {
    CAPTURE(order.dump());
    const Json answer = session.ask(order);
    REQUIRE(answer.contains("refused"));
    CHECK_FALSE(answer["refused"][0]["message"].get<std::string>().empty());
  }
  CHECK(session.ask({{"do", "reset"}})["text"] == kRoom);
}

TEST_CASE("A refused order does not pause the run") {
  Session session;
  session.open(kRoom);
  session.ask({{"do", "speed"}, {"factor", 0.01}});
  session.ask({{"do", "run"}});
  CHECK(session.ask({{"do", "run"}, {"paced", "x"}}).contains("refused"));
  CHECK(session.ask({{"do", "run"}, {"until_s", "soon"}}).contains("refused"));
  CHECK(session.ask({{"do", "reset"}, {"seed", -1}}).contains("refused"));
  CHECK(session.ask({{"do", "at"}}).contains("refused"));  // as it is while a run advances
}

TEST_CASE("A line that is no order has an answer, and the session goes on") {
  Session session;
  const auto send_line = [&](std::string line) {
    line += '\n';
    REQUIRE(::send(session.connection().descriptor(), line.data(), line.size(), 0) ==
            static_cast<ssize_t>(line.size()));
  };
  const std::string deep = std::string(50'000, '[') + std::string(50'000, ']');
  for (const std::string& line :
       {std::string("no JSON"), std::string(), std::string("[1, 2]"), std::string("{\"id\": 1"),
        std::string("{\"do\": \"ping\", \"x\": \"\xff\"}"),
        "{\"do\": \"ping\", \"id\": " + deep + "}", deep}) {
    CAPTURE(line.substr(0, 40));
    send_line(line);
    const Json answer = session.answer_to_no_order();
    CHECK_THAT(answer["refused"][0]["message"].get<std::string>(),
               Catch::Contains("expected a JSON object with `id` and `do`"));
  }
  CHECK_FALSE(session.ask({{"do", "ping"}}).contains("refused"));
}

TEST_CASE("Steps that are ordered all at once are all made, and all answered") {
  Session session;
  session.open(kRoom);
  for (int id = 1001; id <= 1005; ++id) {
    session.connection().send({{"id", id}, {"do", "step"}});
  }
  for (int id = 1001; id <= 1005; ++id) {
    CHECK(session.answer(id)["answer"] == id);
  }
  const auto snapshot = session.connection().snapshots().take();
  REQUIRE(snapshot);
  CHECK(snapshot->facts.time_s == Approx(0.05));
  for (int id = 1006; id <= 1010; ++id) {
    session.connection().send({{"id", id}, {"do", "step"}});
  }
  session.ask({{"do", "reset"}});
  for (int id = 1006; id <= 1010; ++id) {
    CHECK(session.answer(id)["answer"] == id);
  }
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

TEST_CASE("A program that a plugin has left behind does not keep the end from the window") {
  const test::Workplace place;
  place.write("stays", "");
  setenv("FAULTY_LEAVES_BEHIND", "program", 1);
  setenv("FAULTY_LEAVES_UNTIL", place.file("stays").c_str(), 1);
  Session session({"--plugin", test::build_path("tests/program/plugins/faulty.so")});
  unsetenv("FAULTY_LEAVES_BEHIND");
  unsetenv("FAULTY_LEAVES_UNTIL");
  std::string text = kRoom;
  text.replace(text.find("turn_left"), 9, "segfaulting");
  REQUIRE_FALSE(session.open(text).contains("refused"));
  session.ask({{"do", "run"}});
  CHECK(session.end().exit_code == 3);
}

namespace {

/// A session whose plugin `looping` makes a file when it loops.
class LoopingSession {
 public:
  LoopingSession() {
    setenv("FAULTY_LOOP_SIGN", sign_.c_str(), 1);
    session_.emplace(
        std::vector<std::string>{"--plugin", build_path("tests/program/plugins/faulty.so")});
    unsetenv("FAULTY_LOOP_SIGN");
  }
  void run_until_it_loops() {
    std::string text = kRoom;
    text.replace(text.find("turn_left"), 9, "looping");
    REQUIRE_FALSE(session_->open(text).contains("refused"));
    session_->ask({{"do", "run"}});
    REQUIRE(comes_true([&] { return std::filesystem::exists(sign_); }));
  }
  Session* operator->() { return &*session_; }

 private:
  const Workplace place_;
  const std::string sign_ = place_.file("it_loops").string();
  std::optional<Session> session_;
};

}  // namespace

// A program that a shell starts in the background ignores SIGQUIT.
TEST_CASE("A session that is told to quit names its plugin, whatever signals its window ignores") {
  const auto before = std::signal(SIGQUIT, SIG_IGN);
  LoopingSession session;
  std::signal(SIGQUIT, before);
  session.run_until_it_loops();
  session->connection().quit();
  CHECK_THAT(session->end().report, Catch::Contains("'looping'"));
}

TEST_CASE("A session whose window is gone ends, also when a plugin does not return") {
  LoopingSession session;
  session.run_until_it_loops();
  session->connection().close();
  // Nobody ends it meanwhile: ended() would. Its process is the only child of this one.
  REQUIRE(comes_true([] {
    siginfo_t child{};
    return waitid(P_ALL, 0, &child, WEXITED | WNOWAIT | WNOHANG) == 0 && child.si_pid != 0;
  }));
  const auto end = session->connection().ended();
  REQUIRE(end);
  CHECK_THAT(end->report, Catch::Contains("'looping'"));
}

TEST_CASE("What is no program of sessions is refused") {
  CHECK_THROWS_WITH(Connection("/nowhere/elsie", {}), Catch::Contains("/nowhere/elsie"));
}
