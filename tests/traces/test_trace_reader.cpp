#include <catch2/catch.hpp>

#include "elsie/traces/trace.h"

#include "trace_support.h"

using namespace elsie;
using namespace elsie::test;
using traces::read_trace;
using traces::Trace;
using traces::TraceError;

namespace {

const std::string kHead =
    "# elsie trace 1\n"
    "# run world=\"four, \"\"resources\"\"\" file=\"\" seed=\"7\" step_s=\"0.01\" "
    "period_s=\"0.02\"\n"
    "# robot id=\"r1\" team=\"red\" coordinator=\"outer\"\n"
    "# behavior robot=\"r1\" path=\"a\" plugin=\"wander\" coordinator=\"outer\" priority=\"1\"\n"
    "# behavior robot=\"r1\" path=\"b\" plugin=\"blend\" coordinator=\"outer\" priority=\"2\"\n"
    "# behavior robot=\"r1\" path=\"b/c\" plugin=\"flee\" coordinator=\"inner\" priority=\"0.5\"\n"
    "time_s,robot,behavior,asked,left,right,activation,strength,weight,share,reason,inhibited_by,"
    "event,detail\n";
const std::string kRows =
    "0,r1,a,1,1.5,-2,0.5,1,2,0.25,\"first, \"\"really\"\"\",b\n"
    "0,r1,b,0,,,,,0,0\n"
    "0.02,r1,,,3,4\n"
    "0.03,r1,,,,,,,,,,,collision,wall\n";
const std::string kEnd = "# end time_s=\"0.1\" outcome=\"success\" reason=\"done\"\n";

/// What a reader says of the text, as file "t.trace".
std::string error_of(const std::string& text) {
  const TraceFolder folder;
  const auto file = folder.write("t.trace", text);
  try {
    read_trace(file);
  } catch (const TraceError& error) {
    std::string sentence = error.what();
    for (std::size_t at; (at = sentence.find(file.string())) != std::string::npos;) {
      sentence.replace(at, file.string().size(), "t.trace");
    }
    return sentence;
  }
  return "no error";
}

/// What it says of a row in place of the others.
std::string error_of_row(const std::string& row) { return error_of(kHead + row + "\n" + kEnd); }

}  // namespace

TEST_CASE("A trace is read as it was written") {
  const TraceFolder folder;
  const Trace trace = read_trace(folder.write("t.trace", kHead + kRows + kEnd));
  CHECK(trace.world == "four, \"resources\"");
  CHECK(trace.seed == 7);
  CHECK(trace.period_s == 0.02);
  REQUIRE(trace.robots.size() == 1);
  const auto& members = trace.robots[0].members;
  REQUIRE(members.size() == 3);
  CHECK(members[2].path == "b/c");
  CHECK(members[2].parent == 1);
  CHECK(members[2].depth == 1);
  CHECK(members[2].coordinator == "inner");
  REQUIRE(members[0].notes.size() == 1);
  const auto& note = members[0].notes[0];
  CHECK(note.command == MotorCommand{1.5, -2});
  CHECK(note.activation == 0.5);
  CHECK(note.weight == 2);
  CHECK(note.share == 0.25);
  CHECK(trace.reasons[note.reason] == "first, \"really\"");
  CHECK(note.inhibited_by == 1);
  CHECK_FALSE(members[1].notes.at(0).asked);
  CHECK(trace.robots[0].commands.at(0).command == MotorCommand{3, 4});
  CHECK(trace.robots[0].events.at(0).detail == "wall");
  CHECK(trace.end_s == 0.1);
  CHECK(trace.outcome == "success");
  CHECK(trace.outcome_reason == "done");
}

TEST_CASE("A trace without an end goes to the end of the last decision's period") {
  const TraceFolder folder;
  const Trace trace = read_trace(folder.write("t.trace", kHead + kRows));
  CHECK(trace.outcome.empty());
  CHECK(trace.cut_off.empty());
  CHECK(trace.end_s == Approx(0.04));
  const Trace still =
      read_trace(folder.write("t.trace", kHead + kRows + "# until time_s=\"60\"\n"));
  CHECK(still.end_s == 60);
}

TEST_CASE("A trace that is cut off anywhere in its rows is read as far as it is whole") {
  const TraceFolder folder;
  const std::string text = kHead + kRows + kEnd;
  for (std::size_t length = kHead.size(); length < text.size(); ++length) {
    CAPTURE(length);
    const std::string part = text.substr(0, length);
    const Trace trace = read_trace(folder.write("t.trace", part));
    CHECK(trace.outcome.empty());
    const auto whole_rows = static_cast<std::size_t>(
        std::count(part.begin() + static_cast<std::ptrdiff_t>(kHead.size()), part.end(), '\n'));
    const auto& robot = trace.robots[0];
    CHECK(robot.members[0].notes.size() + robot.members[1].notes.size() + robot.commands.size() +
              robot.events.size() ==
          whole_rows);
    CHECK(trace.cut_off.empty() == (part.back() == '\n'));
  }
  const Trace trace = read_trace(folder.write("t.trace", kHead + "0,r1,a,1,1.5"));
  CHECK(trace.cut_off == "line 8 is cut off and was left out; everything before it was read");
}

TEST_CASE("A trace that ends within its head is an error") {
  const std::string sentence =
      "trace 't.trace' ends within its head: the program was stopped before the run began, and "
      "there is nothing in it to read";
  for (std::size_t length = 0; length < kHead.size(); ++length) {
    CAPTURE(length);
    CHECK(error_of(kHead.substr(0, length)) == sentence);
  }
}

TEST_CASE("What is no trace, or one of another format, is refused in a sentence") {
  for (const std::string text :
       {"time_s,robot,x_m\n0,r1,0\n", "\n", "# elsie\n", "<world/>", "\x89PNG\r\n"}) {
    CHECK_THAT(error_of(text), Catch::StartsWith("'t.trace' is no trace: its first line does not "
                                                 "begin with '# elsie trace '"));
  }
  CHECK_THAT(
      error_of("# elsie trace 2\n"),
      Catch::StartsWith("'t.trace' is a trace of format '2', but this program reads format 1 "
                        "only"));
  CHECK_THROWS_WITH(read_trace("/nowhere.trace"),
                    "trace '/nowhere.trace' cannot be read: No such file or directory");
  CHECK_THROWS_WITH(read_trace("/tmp"), "trace '/tmp' is a directory");
}

TEST_CASE("A damaged row is named by its line, with what was found and what was expected") {
  const auto says = [](const std::string& row, const std::string& sentence) {
    CAPTURE(row);
    CHECK_THAT(error_of_row(row), Catch::StartsWith("t.trace:8: " + sentence));
  };
  says("x,r1,a,1,1,1,1,1,1,1", "'x' stands as time_s, where a finite number was expected");
  says("0,r9,a,1,1,1,1,1,1,1", "the robot 'r9' is not in the head of the trace");
  says("0,r1,z,1,1,1,1,1,1,1", "the behaviour 'z' of the robot 'r1' is not in the head");
  says("0,r1,a,2,1,1,1,1,1,1", "'2' stands as asked, where 0 or 1 was expected");
  says("0,r1,a,1,1,,1,1,1,1", "nothing stands as right, where a finite number was expected");
  says("0,r1,a,1,1,1e999,1,1,1,1", "'1e999' stands as right, where a finite number");
  says("0,r1,a,1,1,1,1.5,1,1,1", "'1.5' stands as activation, where a number from 0 to 1");
  says("0,r1,a,1,1,1,1,-1,1,1", "'-1' stands as strength, where a number from 0 to 1");
  says("0,r1,a,1,1,1,1,1,nan,1", "'nan' stands as weight, where a finite number");
}

TEST_CASE("Rows that contradict each other are refused") {
  const auto says = [](const std::string& row, const std::string& sentence) {
    CAPTURE(row);
    CHECK_THAT(error_of_row(row), Catch::Contains(sentence));
  };
  says("0,r1,a,0,1,,,,0,0", "there is '1' in cell 5, which is empty for a behaviour that was not");
  says("0,r1,a,1,1,1,1,1,1,1,,b/c", "'a' is inhibited by 'b/c', which is not under the same");
  says("0,r1,,1,1,1", "there is '1' in cell 4, which is empty for a command");
  says("0,r1,a,,,,,,,,,,collision", "there is 'a' in cell 3, which is empty for an event");
  says("0,r1,,,1,1,,,,,,,,wall", "there is 'wall' in cell 14, which is empty for anything but");
  says("0,r1,a,1,1,1,1,1,1,1,\"x\"y", "the quotes around a cell are not as they should be");
  says("0,r1,a,1,1,1,1,1,1,1,\"x", "the quotes around a cell are not as they should be");
  says("0,r1,a,1,1,1,1,1,1,1,,,,,5", "there are more than 14 cells in the row");
  says("1,r1,,,1,1\n0,r1,,,1,1", "t.trace:9: the time goes back from 1");
  says("0,r1,a,1,1,1,1,1,1,1\n0,r1,a,1,1,1,1,1,1,0",
       "t.trace:9: there is a second row for 'a' of 'r1' at 0 s");
  says("", "t.trace:8: nothing stands as time_s");
  says(kEnd + "0,r1,,,1,1", "t.trace:9: something follows after the end of the trace");
  says("# comment", "'# comment' is not known here");
  says("#comment", "goes on with a space and a word");
  says("# until time_s=5", "the value of 'time_s' is not in quotes");
  says("# until time=\"5\"", "the line '# until' has no time_s");
  says(std::string("0,r1,\0,1", 9), "is not in the head of the trace");
}

TEST_CASE("The sentence about a damaged line says how to keep what is above it") {
  CHECK_THAT(error_of(kHead + kRows + "garbage\n" + kEnd),
             Catch::EndsWith("t.trace:12: 'garbage' stands as time_s, where a finite number was "
                             "expected; the lines above it are whole: `head -n 11` takes them "
                             "out"));
}

TEST_CASE("A damaged head is named by its line") {
  const auto says = [](std::string what, const std::string& instead, const std::string& sentence) {
    CAPTURE(what);
    std::string text = kHead + kRows + kEnd;
    text.replace(text.find(what), what.size(), instead);
    CHECK_THAT(error_of(text), Catch::Contains(sentence));
  };
  says("seed=\"7\"", "seed=\"-7\"", "t.trace:2: '-7' stands as seed, where a whole number");
  says("seed=\"7\"", "", "t.trace:2: the line '# run' has no seed");
  says("step_s=\"0.01\"", "step_s=\"0\"", "t.trace:2: '0' stands as step_s, where a number above");
  says("# robot", "# rabbit", "t.trace:3: '# rabbit' stands in the head");
  says("path=\"b\"", "path=\"a\"", "t.trace:5: the behaviour 'a' is there twice");
  says("path=\"b/c\"", "path=\"x/c\"", "t.trace:6: the behaviour 'x' of the robot 'r1' is not");
  says("time_s,robot", "time,robot", "t.trace:7: a line of the head or the heading");
  says("priority=\"2\"", "priority=\"high\"", "t.trace:5: 'high' stands as priority");
}

TEST_CASE("Whether a file may be overwritten by a trace is told by how it begins") {
  const TraceFolder folder;
  CHECK(traces::may_be_trace(folder.write("a", kHead)));
  CHECK(traces::may_be_trace(folder.write("b", "# elsie trace 99\n")));
  CHECK(traces::may_be_trace(folder.write("c", "")));
  CHECK_FALSE(traces::may_be_trace(folder.write("d", "# elsie")));
  CHECK_FALSE(traces::may_be_trace(folder / "nothing"));
}
