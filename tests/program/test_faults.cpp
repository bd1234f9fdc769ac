// Plugins that fail: the message names the plugin, recordings are kept, the exit code is 3.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using Catch::Contains;
using elsie::test::ProgramRun;
using elsie::test::Workplace;
using nlohmann::json;

namespace {

/// The plugins of plugins/faulty.cpp, one at a time, on the robot r1.
class FaultyWorld {
 public:
  ProgramRun run(const std::string& behavior, const std::string& options = "",
                 const std::string& coordinator = "arbiter_suppression",
                 const std::string& sensor = "", const std::string& duration = "3") const {
    write(behavior, coordinator, sensor);
    return here.elsie("run world.xml --duration " + duration + " --plugin-path " +
                      elsie::test::build_path("tests/program/plugins") +
                      " --record run.csv --record run.mcap --record-rate 100 --json " + options);
  }
  /// Asks a run to terminate once the plugin loops, repeatedly until it does. Libraries are copied
  /// to the folder copies.
  ProgramRun interrupt(const std::string& behavior, const std::string& options = "") const {
    write(behavior, "arbiter_suppression", "");
    // The shell makes background processes ignore Ctrl-C, so the run gets a request to terminate.
    return here.sh(
        "rm -rf copies err; mkdir copies; export TMPDIR=$PWD/copies\n"
        "elsie run world.xml --watch --record run.csv --plugin-path " +
        elsie::test::build_path("tests/program/plugins") + " " + options +
        " 2> err & pid=$!\n"
        "until grep -q 'for ever' err || ! kill -0 $pid; do sleep 0.1; done\n"
        "ls copies | wc -l\n"
        "while kill $pid; do sleep 1; done 2> none\n"
        "ls copies | wc -l\n"
        "wait $pid");
  }
  void write(const std::string& behavior, const std::string& coordinator,
             const std::string& sensor) const {
    std::string all;
    for (int i = 0; i < robots; ++i) {
      all += "<robot id=\"r" + std::to_string(i + 1) + "\" x=\"" + std::to_string(i % 32 - 15) +
             "\" y=\"" + std::to_string(i / 32) + "\" team=\"red\"><sensors>" +
             (sensor.empty() ? "" : "<" + sensor + "/>") + "</sensors>\n<behaviors><" + behavior +
             "/></behaviors>\n<coordinator><" + coordinator + "/></coordinator></robot>";
    }
    here.write("world.xml", "<world format=\"1\"><arena length=\"40\" width=\"40\"/><robots>" +
                                all + "</robots></world>\n");
  }
  /// Lines of the recording without its heading.
  long rows() const {
    const std::string table = here.read("run.csv");
    CHECK(table.ends_with('\n'));
    return std::count(table.begin(), table.end(), '\n') - 1;
  }

  Workplace here;
  int robots = 1;  // 32 in a row
};

}  // namespace

TEST_CASE("A plugin that throws or answers NaN is named; the recording and the picture are kept") {
  FaultyWorld world;
  for (const std::string plugin : {"throwing", "not_a_number"}) {
    const auto run = world.run(plugin, "--picture run.png");
    CHECK(run.exit_code == 3);
    CHECK(run.out.empty());
    CHECK_THAT(run.err,
               Contains("plugin '" + plugin + "' of robot 'r1' failed in step 50 (at 0.5 s): "));
    CHECK(world.rows() == 51);
    CHECK_FALSE(world.here.read("run.png").empty());
  }
}

TEST_CASE("A plugin that crashes is named with robot, step and stack, and the recording is kept") {
  FaultyWorld world;
  struct Case {
    std::string plugin, what;
  };
  const Case cases[] = {
      {"segfaulting", "segmentation fault (SIGSEGV)"},
      {"overflowing", "segmentation fault (SIGSEGV)"},
      {"dividing", "arithmetic error"},
      {"aborting", "abort (SIGABRT)"},
      {"throwing_through", "abort (SIGABRT)"},
      {"illegal", "illegal instruction (SIGILL)"},
      {"bus_error", "bus error (SIGBUS)"},
      {"exiting", "by calling exit()"},
      {"erring", "by calling exit()"},
      {"user_signal", "with the signal SIGUSR1"},
      {"real_time", "with the signal SIGRTMIN+3"},
      {"timed", "with the signal SIGALRM"},
      {"calling_nowhere", "segmentation fault (SIGSEGV)"},
      {"trapping", "trap (SIGTRAP)"},
  };
  for (const Case& expected : cases) {
    CAPTURE(expected.plugin);
    const auto run = world.run(expected.plugin);
    CAPTURE(run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.out.empty());
    CHECK_THAT(run.err,
               Contains("elsie: plugin '" + expected.plugin + "' of robot 'r1' ended the program"));
    CHECK_THAT(run.err, Contains(expected.what) && Contains(" in step 50 (at 0.5 s)\n"));
    CHECK_THAT(run.err, Contains("the stack, from the inside out:\n") && Contains("faulty.so+0x"));
    // It ends where Elsie's code begins, which called the plugin.
    CHECK_THAT(run.err, !Contains("libelsie.so"));
    CHECK_THAT(run.err, Contains("what was recorded until then is kept\nthe stack"));
    CHECK(world.rows() == 51);
    CHECK_THAT(world.here.read("run.mcap"),
               Contains(R"("forward_m_s":0.2,"lateral_m_s":0,"turn_rad_s":0)"));
    const auto explained = world.here.elsie("explain run.mcap");
    CHECK(explained.exit_code == 0);
    CHECK_THAT(explained.out,
               Contains("stopped after 0.5 s: the program was brought down in the step "
                        "after it\n"));
  }
}

TEST_CASE("A crash with an overwritten stack names the plugin, too") {
  FaultyWorld world;
  const auto run = world.run("smashing_stack");
  CAPTURE(run.err);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("elsie: plugin 'smashing_stack' of robot 'r1' ended the program") &&
                          Contains("what was recorded until then is kept"));
  CHECK(world.rows() == 51);
}

TEST_CASE("Of a crash in a plugin's own thread, the recording is whole up to a line") {
  FaultyWorld world;
  const auto run = world.run("crashing_elsewhere");
  CAPTURE(run.err);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("elsie: plugin library '") &&
                          Contains("faulty.so', in a thread of its own, ended the program with a "
                                   "segmentation fault (SIGSEGV)"));
  const std::string table = world.here.read("run.csv");
  CHECK((table.empty() || table.ends_with('\n')));
}

TEST_CASE("Sensors and coordinators that crash are distinguished from behaviours") {
  FaultyWorld world;
  CHECK_THAT(world.run("thrifty", "", "crashing_coordinator").err,
             Contains("plugin 'crashing_coordinator' of robot 'r1' ended the program with a "
                      "segmentation fault (SIGSEGV) in step 50 (at 0.5 s)\n"));
  CHECK_THAT(world.run("segfaulting", "", "crashing_coordinator").err,
             Contains("plugin 'segfaulting' of robot 'r1' ended the program"));
  CHECK_THAT(world.run("thrifty", "", "arbiter_suppression", "crashing_sensor").err,
             Contains("plugin 'crashing_sensor' of robot 'r1' ended the program"));
}

TEST_CASE("A plugin that fails while it is made is named with its place in the world") {
  FaultyWorld world;
  auto run = world.run("throws_when_made");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("world.xml:2: ") && Contains("throws_when_made") &&
                          Contains("faulty.so) could not be made: no more of these"));
  run = world.run("crashes_when_made");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'crashes_when_made' ended the program with a segmentation "
                               "fault (SIGSEGV), while it was made (world.xml:2); it is from ") &&
                          Contains("faulty.so"));
  run = world.run("crashes_when_configured");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'crashes_when_configured' ended the program") &&
                          Contains(", while it was given its parameters (world.xml:2)"));
  run = world.run("crashes_when_destroyed");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin library ") && Contains("faulty.so' ended the program") &&
                          Contains(", while its object was destroyed"));
}

TEST_CASE("A plugin that takes longer than its time budget ends the run in order") {
  FaultyWorld world;
  CHECK(world.run("dawdling", "", "arbiter_suppression", "", "0.51").exit_code ==
        1);  // off by default
  // Wide, so that a busy machine does not interfere.
  const auto run = world.run("dawdling", "--time-budget 900 --picture run.png");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err,
             Contains("plugin 'dawdling' of robot 'r1' failed in step 50 (at 0.5 s): it took ") &&
                 Contains(" ms to answer, which is beyond its time budget of 900 ms"));
  CHECK(world.rows() == 51);
  CHECK_FALSE(world.here.read("run.png").empty());
}

TEST_CASE("A plugin that never returns is stopped") {
  FaultyWorld world;
  const auto start = std::chrono::steady_clock::now();
  const auto run = world.run("looping", "--time-budget 1000");
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'looping' of robot 'r1' did not return within its time "
                               "budget and was stopped in step 50 (at 0.5 s)\n") &&
                          Contains("faulty.so+0x"));
  CHECK(world.rows() == 51);
}

TEST_CASE("A budget that is not exceeded interrupts no plugin") {
  FaultyWorld world;
  const auto free = world.run("sleeping", "", "arbiter_suppression", "", "0.52");
  const auto limited =
      world.run("sleeping", "--time-budget 1000", "arbiter_suppression", "", "0.52");
  CHECK_THAT(free.out, Contains("state_hash"));
  CHECK(json::parse(free.out).at("state_hash") == json::parse(limited.out).at("state_hash"));
}

TEST_CASE("A second Ctrl-C ends even a plugin that does not return, and says which") {
  FaultyWorld world;
  const auto run = world.interrupt("looping");
  CHECK(run.exit_code == 4);
  CHECK_THAT(world.here.read("err"),
             Contains("plugin 'looping' of robot 'r1' was at work when the run was interrupted in "
                      "step 50 (at 0.5 s)\n") &&
                 Contains("faulty.so+0x"));
  CHECK(world.rows() >= 1);
  // The libraries that were loaded from copies; none of these is left.
  CHECK(std::stoi(run.out) > 1);
  CHECK_THAT(run.out, Catch::EndsWith("\n0\n"));
}

TEST_CASE("What ends the program in another thread of the run is named like in the first") {
  FaultyWorld world;
  world.robots = 512;  // enough to share
  struct Case {
    std::string plugin, what;
  };
  for (const auto& [plugin, what] :
       {Case{"segfaulting_beside", "a segmentation fault (SIGSEGV)"},
        Case{"aborting_beside", "an abort (SIGABRT)"}, Case{"exiting_beside", "exit()"}}) {
    const auto run = world.run(plugin, "--threads 2", "arbiter_suppression", "", "60");
    CAPTURE(plugin);
    CHECK(run.exit_code == 3);
    CHECK_THAT(run.err, Contains("plugin '" + plugin + "' of robot 'r") && Contains(what) &&
                            Contains("what was recorded until then is kept"));
    CHECK(world.rows() >= 512 * 50);
  }
}

TEST_CASE("It names a plugin that does not return in another thread of the run, too") {
  FaultyWorld world;
  world.robots = 512;  // enough to share
  const auto run = world.interrupt("looping_beside", "--threads 2");
  CHECK(run.exit_code == 4);
  CHECK_THAT(world.here.read("err"),
             Contains("plugin 'looping_beside' of robot 'r") &&
                 Contains("' was at work when the run was interrupted in step "));
}

TEST_CASE("Before the run, the first Ctrl-C says which plugin does not return") {
  FaultyWorld world;
  struct Case {
    std::string plugin, when;
  };
  for (const Case& expected :
       {Case{"loops_when_made",
             " was at work when the program was "
             "interrupted, while it was made (world.xml:2)"},
        {"loops_when_configured",
         " was at work when the program was interrupted, while it was given its parameters "
         "(world.xml:2)"},
        {"loops_when_equipped",
         " of robot 'r1' was at work when the program was interrupted, while it was prepared "
         "(world.xml:2)"},
        {"loops_when_reset",
         " of robot 'r1' was at work when the program was interrupted in step 0 (at 0 s)"}}) {
    const auto run = world.interrupt(expected.plugin);
    const std::string err = world.here.read("err");
    CAPTURE(err);
    CHECK(run.exit_code == 4);
    CHECK_THAT(err, Contains("elsie: plugin '" + expected.plugin + "'" + expected.when));
    CHECK_THAT(run.out, Catch::EndsWith("\n0\n"));
  }
}

TEST_CASE("While libraries are loaded, Ctrl-C names one only if it takes long") {
  FaultyWorld world;
  const auto err = [&](const std::string& when) {
    const auto run = world.here.sh("FAULTY_WHILE_LOADED=" + when + " elsie plugins --plugin-path " +
                                   elsie::test::build_path("tests/program/plugins"));
    CHECK(run.exit_code == 4);
    CHECK(run.out.empty());
    return run.err;
  };
  CHECK(err("soon") == "elsie: interrupted while plugins were loaded\n");
  CHECK_THAT(err("late"), Catch::StartsWith("elsie: plugin library '") &&
                              Contains("/faulty.so' was at work when the program was "
                                       "interrupted, while it was loaded\n"));
}

TEST_CASE("A locale that a plugin sets changes no number") {
  const Workplace here;
  if (here.sh("localedef -i de_DE -f UTF-8 $PWD/de_DE > none 2>&1").exit_code != 0) {
    WARN("no locale can be made here");
    return;
  }
  const auto train = [&](const std::string& variable) {
    auto text = here.sh("LOCPATH=$PWD " + variable +
                        " elsie train worlds/learned_priorities.xml --presentations 20 "
                        "--plugin-path " +
                        elsie::test::build_path("tests/program/plugins"))
                    .out;
    return text.substr(text.find("\n\n"));  // without the time that it took
  };
  const std::string usual = train("");
  CHECK_THAT(usual, Contains("answer") && Contains("0."));
  CHECK(train("FAULTY_LEAVES_BEHIND=locale") == usual);
}

TEST_CASE("An unhandled signal ends the program as usual, and leaves no copies") {
  FaultyWorld world;
  world.write("looping", "arbiter_suppression", "");
  for (const std::string signal : {"USR1", "PIPE", "XCPU"}) {
    CAPTURE(signal);
    const auto run = world.here.sh(
        "rm -rf copies err; mkdir copies; export TMPDIR=$PWD/copies; ulimit -c 0\n"
        "elsie run world.xml --watch --plugin-path " +
        elsie::test::build_path("tests/program/plugins") +
        " 2> err & pid=$!\nuntil grep -q 'for ever' err; do sleep 0.1; done\nkill -" + signal +
        " $pid; wait $pid || echo $(kill -l $?)\nls copies | wc -l");
    CHECK(run.out == signal + "\n0\n");
  }
}

TEST_CASE("Copies that a killed process left are removed by the next one") {
  const Workplace here;
  const auto run = here.sh(
      "mkdir copies; export TMPDIR=$PWD/copies; cd copies\n"
      "mkdir elsie-copy-999999999-dead elsie-copy-999999999-young elsie-copy-$$-alive other\n"
      "touch elsie-copy-999999999-dead/x.so\n"
      "touch -d '1 hour ago' elsie-copy-999999999-dead elsie-copy-$$-alive other\n"
      "cd ..; elsie run worlds/open_arena.xml --watch --duration 0.1 --quiet || ls copies | tr "
      "-d 0-9");
  CHECK(run.out == "elsie-copy--alive\nelsie-copy--young\nother\n");
}

TEST_CASE("A plugin that leaks runs into its memory budget; one that only allocates does not") {
  FaultyWorld world;
  CHECK(world.run("leaking").exit_code == 1);  // off by default
  const auto run = world.run("leaking", "--memory-budget 0.1");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'leaking' of robot 'r1' failed in step 1") &&
                          Contains("it holds 0.1") && Contains(" MB more than when the run began"));
  CHECK(world.run("thrifty", "--memory-budget 0.1 --time-budget 5000").exit_code == 1);
}

TEST_CASE("Budgets that are not met change nothing of a run") {
  FaultyWorld world;
  const auto hash = [](const std::string& text) {
    return text.substr(text.find("\"state_hash\""), 40);
  };
  const std::string run = "run worlds/clutter.xml --duration 5 --json";
  CHECK(hash(world.here.elsie(run).out) ==
        hash(world.here.elsie(run + " --time-budget 10000 --memory-budget 100").out));
}
