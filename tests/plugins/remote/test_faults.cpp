// Programs that do not keep to the protocol are named with what they said, and nothing is left.
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <utility>

#include <catch2/catch.hpp>

#include "elsie/testing/coordinator.h"

#include "programs.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;
using testing::Situation;

namespace {

/// The process whose number is in this text; ends the test if it has none.
pid_t process_in(const std::string& text) {
  REQUIRE_FALSE(text.empty());
  return std::stoi(text);
}

/// Whether a process still runs; whoever waits for orphans decides when an ended one is gone.
bool is_running(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  in >> number >> name >> state;
  return !state.empty() && state != "Z" && state != "X";
}
/// Waits for the end of a process that was killed, which comes when it has its turn.
bool ends(pid_t process) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (is_running(process) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return !is_running(process);
}
bool is_there(pid_t process) { return kill(process, 0) == 0 || errno != ESRCH; }

}  // namespace

TEST_CASE("What is no object in a line of JSON is shown") {
  CHECK_THAT(fault_of(answering("turn left")),
             Contains("its program 'while read") &&
                 Contains("answered 'turn left': expected a JSON object in one line"));
  for (const std::string answer :
       {"[1,2]", "1", "null", "", "{\"turn\":NaN}", "{\"turn\":1e999}", "{\"turn\":1", "{} {}"}) {
    CAPTURE(answer);
    CHECK_THAT(fault_of(answering(answer)),
               Contains("answered '" + answer + "': expected a JSON object"));
  }
}

TEST_CASE("Fields that are unknown, or of another type, are named") {
  const std::pair<const char*, const char*> all[] = {
      {R"({"forwrd":1})", "there is no field 'forwrd'; did you mean 'forward'?"},
      {R"({"forward":"1"})", R"(its 'forward' is '"1"'; expected a number)"},
      {R"({"left":1})", "it has 'left' without 'right'; expected the rates of both wheels"},
      {R"({"left":1,"right":1,"turn":0})", "it has wheel rates ('left', 'right') and a motion"},
      {R"({"activation":1.5})", "its 'activation' is '1.5'; expected a number from 0 to 1"},
      {R"({"charge":1})", "its 'charge' is '1'; expected true or false"},
      {R"({"status":"done"})", R"(expected "running", "success" or "failure")"},
      {R"({"events":["alarm"]})", "it raises the event 'alarm'; expected 'remote_signal'"},
      {R"({"acts":{"red":1}})", "expected a list of objects"},
      {R"({"acts":[{"kind":"led","red":"full"}]})",
       R"(in 'acts', its 'red' is '"full"'; expected a number)"},
      {R"({"say":[{"numbers":{}}]})", "a message in 'say' has no 'kind'"},
      {R"({"say":[{"kind":"offer","x":1}]})", "in 'say', there is no field 'x'"}};
  for (const auto& [answer, problem] : all) {
    CAPTURE(answer);
    CHECK_THAT(fault_of(answering(answer)), Contains(problem));
  }
}

TEST_CASE("Only the first sixty characters of an answer are shown, without those of control") {
  const std::string fault = fault_of(program("printf 'a\\tb\\033[31m%080d\\n' 0"));
  CHECK_THAT(fault, Contains("answered 'a?b?[31m0000") && !Contains(std::string(70, '0')));
}

TEST_CASE("A line without an end, and one too many, are refused") {
  CHECK_THAT(fault_of("read -r line; head -c 3000000 /dev/zero | tr '\\0' x"),
             Contains("answered 'xxx") && Contains("the line has no end within 1 MB"));
  CHECK_THAT(fault_of(program("printf '{}\\n{}\\n'")),
             Contains("it said '{}' in another line; expected one line for each"));
}

TEST_CASE("An answer may nest as deep as a line is long") {
  const std::string many = "head -c 400000 /dev/zero | tr '\\0' ";
  CHECK_THAT(
      fault_of(program("printf '{\"forward\":'; " + many + "'['; " + many + "']'; echo '}'")),
      Contains("its 'forward' is a list; expected a number"));
}

TEST_CASE("A program that says something without being asked is refused") {
  Remote remote("echo hello; sleep 100");
  const std::string fault = [&]() -> std::string {
    try {
      for (;;) remote.respond(Situation());
    } catch (const std::exception& error) {
      return error.what();
    }
  }();
  CHECK_THAT(fault, Contains("'hello"));
}

TEST_CASE("A program that dies is named with how it ended") {
  CHECK_THAT(fault_of("exit 3"), Contains("ended with exit code 3 instead of answering"));
  CHECK_THAT(fault_of("kill -9 $$"), Contains("was ended by signal 9 (Killed)"));
  CHECK_THAT(fault_of(program("printf half; exit 0")),
             Contains("ended with exit code 0 instead of answering; it said 'half'"));
  CHECK_THAT(fault_of("exec 2>&-; no_such_program"),
             Contains("ended with exit code 127 (the shell finds no such command)"));
}

TEST_CASE("A program that does not answer in time is named with its time-out, and killed") {
  const Folder folder;
  const std::string note = "echo $$ > '" + folder.file("process") + "'; ";
  const auto start = std::chrono::steady_clock::now();
  CHECK_THAT(fault_of(note + "exec sleep 1000", 0.2),
             Contains("has not answered within 0.2 s (its 'timeout')"));
  CHECK_FALSE(is_there(process_in(folder.read("process"))));
  CHECK_THAT(fault_of(program("printf '{\"turn\"'; sleep 1000"), 0.2),
             Contains("it said '{\"turn\"' without an end of the line"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("After a fault, the program is started again for another run") {
  const Folder folder;
  Remote remote("if [ -e '" + folder.file("again") + "' ]; then " + answering(R"({"turn":1})") +
                "; else touch '" + folder.file("again") + "'; fi");
  CHECK_THROWS(remote.respond(Situation()));
  remote.reset(1);
  CHECK(remote.respond(Situation()).command.turn == 1.0);
}

TEST_CASE("What cannot be started is refused with what is missing") {
  const Folder folder;
  const auto fault = [](const testing::Settings& settings) -> std::string {
    testing::Behavior remote("remote", settings);
    try {
      remote.respond(Situation());
      return {};
    } catch (const std::exception& error) {
      return error.what();
    }
  };
  CHECK_THAT(fault({{"file", folder.write("drive.py", "print()\n")}}),
             Contains("cannot start its program 'drive.py': Permission denied; make the file "
                      "executable"));
  CHECK_THAT(fault({{"socket", folder.file("none")}}),
             Contains("cannot connect to the program at the socket") &&
                 Contains("No such file or directory; start it before the run"));
  CHECK_THAT(fault({{"socket", std::string(200, 'x')}}), Contains("expected at most 107"));
}

TEST_CASE("At the end the program may leave; one that stays is killed, and so are its children") {
  const Folder folder;
  {
    Remote remote("echo $$ > '" + folder.file("process") + "'; " + answering("{}") +
                  "; echo left > '" + folder.file("left") + "'");
    remote.respond(Situation());
  }
  CHECK(folder.read("left") == "left\n");
  CHECK_FALSE(is_there(process_in(folder.read("process"))));
  {
    Remote remote("sleep 1000 & echo $! > '" + folder.file("child") + "'; echo $$ > '" +
                      folder.file("process") + "'; " + answering("{}") + "; wait",
                  0.5);
    remote.respond(Situation());
  }
  CHECK_FALSE(is_there(process_in(folder.read("process"))));
  CHECK(ends(process_in(folder.read("child"))));
}

TEST_CASE("A program has no files of another one, and the default signals") {
  std::signal(SIGUSR1, SIG_IGN);
  const Folder folder;
  const auto command = [&](const std::string& name) {
    const std::string file = " >> '" + folder.file(name) + "'; ";
    return "ls -l /proc/$$/fd | grep -o 'socket:.*' | sort -u | wc -l" + file +
           "grep -E 'SigIgn|SigBlk' /proc/self/status" + file + answering("{}");
  };
  Remote first(command("first")), second(command("second"));
  first.respond(Situation());
  second.respond(Situation());
  std::signal(SIGUSR1, SIG_DFL);
  // Above the first 28 signals, the C library has some of its own.
  CHECK_THAT(folder.read("second"),
             Catch::Matches(R"(1\nSigBlk:\s0+\nSigIgn:\s[0-9a-f]*0000000\n)"));
}

TEST_CASE("Weights that do not fit the members are refused") {
  testing::Team team;
  team.member("seek", 1, testing::active(1, testing::wheels(20, 20)));
  for (const std::string answer :
       {R"({"weights":[1,2]})", R"({"weights":[-1]})", R"({"weights":{"seek":1}})"}) {
    CAPTURE(answer);
    testing::Coordinator arbiter("arbiter_remote", team, {{"command", answering(answer)}});
    CHECK_THROWS_WITH(arbiter.decide(),
                      Contains("a number of at least 0 for each of the 1 member"));
  }
}
