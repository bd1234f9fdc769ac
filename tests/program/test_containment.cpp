// Plugins that end the process, copy it, print or change how it computes: the exit code, the answer
// and the results remain those of the program.
#include <chrono>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using Catch::Contains;
using elsie::test::ProgramRun;
using elsie::test::Workplace;

namespace {

/// A plugin of plugins/trespassers.cpp on the robot r1, in a run that reaches its goal after a
/// second.
class TrespassersWorld {
 public:
  ProgramRun run(const std::string& behavior, const std::string& options = "") const {
    here.write("world.xml",
               "<world format=\"1\"><robots><robot id=\"r1\"><behaviors><" + behavior +
                   "/></behaviors>\n<coordinator><arbiter_suppression/></coordinator></robot>"
                   "</robots>\n<goals><endure time=\"1\"/></goals></world>\n");
    return here.elsie("run world.xml --plugin-path " + plugins + " --json " + options);
  }

  const std::string plugins = elsie::test::build_path("tests/program/plugins");
  Workplace here;
};

std::string state_hash(const ProgramRun& run) {
  return nlohmann::json::parse(run.out).at("state_hash");
}

}  // namespace

TEST_CASE("A plugin that ends the process by a function of the C library is named, exit code 3") {
  TrespassersWorld world;
  struct Case {
    std::string plugin, what;
  };
  for (const Case& expected : {Case{"leaving", "_exit()"},
                               {"leaving_in_c", "_Exit()"},
                               {"leaving_quickly", "quick_exit()"}}) {
    CAPTURE(expected.plugin);
    const auto run = world.run(expected.plugin, "--record run.csv --record-rate 100");
    CAPTURE(run.err);
    CHECK(run.exit_code == 3);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Contains("elsie: plugin '" + expected.plugin +
                                 "' of robot 'r1' ended the program by calling " + expected.what +
                                 " in step 50 (at 0.5 s)\n") &&
                            Contains("what was recorded until then is kept\n") &&
                            Contains("trespassers.so+0x"));
    CHECK_THAT(world.here.read("run.csv"), Catch::EndsWith("\n"));
  }
}

TEST_CASE("It is also named when it is made, destroyed, or unloaded") {
  TrespassersWorld world;
  auto run = world.run("leaving_when_made");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'leaving_when_made' ended the program by calling _exit(), "
                               "while it was made (world.xml:1)"));
  run = world.run("leaving_when_destroyed");
  CHECK(run.exit_code == 3);
  CHECK_THAT(
      run.err,
      Contains(
          "trespassers.so' ended the program by calling _exit(), while its object was destroyed"));
  run = world.run("leaving_at_the_end");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("trespassers.so' ended the program by calling _exit(), while it was "
                               "unloaded"));
}

TEST_CASE("A library that ends the process while it is loaded is named, even if unused") {
  TrespassersWorld world;
  for (const std::string command :
       {"run worlds/open_arena.xml --duration 1", "check worlds/open_arena.xml",
        "test-plugin wander", "describe wander", "plugins"}) {
    CAPTURE(command);
    const auto run = world.here.sh(
        "TRESPASS_WHILE_LOADED=leave ELSIE_PLUGIN_PATH=" + world.plugins + " elsie " + command);
    CHECK(run.exit_code == 3);
    CHECK(run.out.empty());
    CHECK_THAT(run.err,
               Contains("elsie: plugin library '") &&
                   Contains("trespassers.so' ended the program by calling _exit(), while it "
                            "was loaded\n"));
  }
}

TEST_CASE("A process that is killed is no success") {
  TrespassersWorld world;
  const auto killed = world.run("killing");
  CHECK(killed.exit_code == 128 + 9);
  CHECK(killed.out.empty());
}

TEST_CASE("A plugin that ends its check is named, with the step") {
  TrespassersWorld world;
  const auto run = world.here.elsie("test-plugin segfaulting --plugin-path " + world.plugins);
  CAPTURE(run.err);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'segfaulting' ended the program with a segmentation fault "
                               "(SIGSEGV) in step 50 (at 0.5 s)"));
}

TEST_CASE("A thread of a plugin that ends the process or crashes is found in its library") {
  TrespassersWorld world;
  auto run = world.run("leaving_elsewhere");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("elsie: plugin library '") &&
                          Contains("trespassers.so', in a thread of its own, ended the program by "
                                   "calling _exit()"));
  // Slow and without an end, so that there is time for the crash.
  run = world.run("crashing_beside", "--speed 1 --duration 100 --set 'goal[*]/@remove=true'");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("trespassers.so', in a thread of its own, ended the program with a "
                               "segmentation fault (SIGSEGV)"));
}

TEST_CASE("A thread that a plugin leaves behind is found in the library that was unloaded") {
  TrespassersWorld world;
  // The program may end before the thread runs again: on a busy machine it often does.
  bool was_seen = false;
  const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (!was_seen && std::chrono::steady_clock::now() < patience) {
    const auto run = world.run("leaving_a_thread");
    CAPTURE(run.err);
    was_seen = run.exit_code == 3;
    CHECK((was_seen || (run.exit_code == 0 && run.err.empty())));
    if (was_seen) {
      CHECK_THAT(run.err,
                 Contains("trespassers.so', in a thread of its own, ended the program with "
                          "a segmentation fault (SIGSEGV)"));
    }
  }
  CHECK(was_seen);
}

TEST_CASE("A crash outside of plugins, after one has damaged the heap, says where to look") {
  TrespassersWorld world;
  const auto run = world.run("smashing_heap");
  // The damage shows, depending on the allocator, in the next call of a plugin, whose name it may
  // have reached, or outside.
  const bool is_noticed_outside = run.exit_code >= 128;
  CHECK((run.exit_code == 3 || is_noticed_outside));
  CHECK(run.out.empty());
  if (is_noticed_outside) {
    CHECK_THAT(run.err, Contains("if a plugin has written over memory that is not its own"));
  } else {
    CHECK_THAT(run.err, Contains("' of robot 'r1' ended the program") ||
                            Contains("something whose name is damaged ended the program"));
  }
}

TEST_CASE(
    "A copy of the process ends or crashes by itself, and the plugin that made it has failed") {
  TrespassersWorld world;
  for (const std::string plugin : {"forking", "forking_and_crashing"}) {
    const auto run = world.run(plugin, "--record run.csv --record-rate 100");
    CHECK(run.exit_code == 3);
    CHECK(run.out.empty());
    CHECK(run.err == "elsie: plugin '" + plugin +
                         "' of robot 'r1' failed in step 50 (at 0.5 s): it made a copy of the "
                         "program with fork(); start other programs with posix_spawn()\n");
  }
  CHECK(world.run("starting").exit_code == 0);
}

TEST_CASE("What plugins print is not mixed with the answer") {
  TrespassersWorld world;
  world.run("printing");
  const auto run = world.here.sh("elsie run world.xml --json --record /dev/stdout --plugin-path " +
                                 world.plugins + " | cat");
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains("printed by printf\n") && Contains("printed by cout\n") &&
                          Contains("written\n"));
  CHECK_THAT(run.out, !Contains("printed") && !Contains("written"));
  const std::size_t answer = run.out.find("\n{");
  REQUIRE(answer != std::string::npos);
  CHECK(nlohmann::json::parse(run.out.substr(answer)).at("outcome") == "success");
  CHECK(nlohmann::json::parse(world.run("printing").out).at("outcome") == "success");
}

TEST_CASE("A library that changes how numbers are rounded is named, and changes no run") {
  TrespassersWorld world;
  const std::string command = " elsie run worlds/clutter.xml --seed 5 --duration 5 --json";
  const auto plain = world.here.sh(command);
  const auto run =
      world.here.sh("TRESPASS_WHILE_LOADED=round ELSIE_PLUGIN_PATH=" + world.plugins + command);
  CHECK(state_hash(run) == state_hash(plain));
  CHECK(plain.err.empty());
  CHECK_THAT(run.err,
             Contains("trespassers.so: changed how results are rounded for the whole program "
                      "when it was loaded; this was undone\n"));
}

TEST_CASE("A plugin that changes how numbers are rounded is named, and changes no other") {
  TrespassersWorld world;
  const auto run = world.run("rounding");
  CHECK(run.exit_code == 0);
  const auto result = nlohmann::json::parse(run.out);
  REQUIRE(result.at("notes").size() == 1);
  CHECK(result.at("notes")[0].at("plugin") == "rounding");
  CHECK(result.at("notes")[0].at("text") ==
        "changed how results are rounded for the whole program, once, first in step 50 (at 0.5 s); "
        "this was "
        "undone after each call");
  CHECK(state_hash(run) == state_hash(world.run("starting")));  // which drives in the same way
  const auto made = world.run("rounding_when_made");
  CHECK(made.exit_code == 3);
  CHECK_THAT(made.err, Contains("world.xml:1: ") && Contains("rounding_when_made") &&
                           Contains("could not be made: it changed how results are rounded for "
                                    "the whole program"));
}

TEST_CASE("test-plugin stops a plugin that does not return, and one that takes ever more memory") {
  TrespassersWorld world;
  auto run = world.here.sh(
      "TRESPASS_WHILE_LOADED=loop elsie test-plugin wander --time-limit 1 "
      "--plugin-path " +
      world.plugins);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("trespassers.so' did not return within 1 s and was stopped, while "
                               "it was loaded"));
  run =
      world.here.elsie("test-plugin looping_at_once --time-limit 1 --plugin-path " + world.plugins);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'looping_at_once' did not return within 1 s and was stopped "
                               "in step 0 (at 0 s), while it was tried (its defaults; "));
  run = world.here.elsie("test-plugin hoarding --variants 0 --memory-limit 400 --plugin-path " +
                         world.plugins);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.out, Contains("behavior 'hoarding': its memory grows with the number of steps: "
                               "more than 200 MB"));
  run = world.here.elsie("test-plugin gulping --memory-limit 200 --plugin-path " + world.plugins);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.out, Contains("behavior 'gulping': ") && Contains("std::bad_alloc"));
}

TEST_CASE("A plugin that crashes while it is checked is named with the trial") {
  TrespassersWorld world;
  const auto run = world.here.elsie("test-plugin leaving_at_once --plugin-path " + world.plugins);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'leaving_at_once' ended the program by calling _exit() in "
                               "step 0 (at 0 s), while it was tried (its defaults; "));
}

TEST_CASE("Every command that reads a file refuses a pipe, a device and what is far too large") {
  const Workplace here;
  here.sh(
      "mkfifo pipe pipe.mcap pipe.xml pipe.sqlite pipe.fcl\n"
      "truncate -s 1100000000 sparse.fcl sparse.mcap sparse.xml sparse.txt");
  struct Case {
    std::string command, sentence;
  };
  const std::string kPipe = "is a pipe, not a file";
  const std::string kDevice = "is a device, not a file";
  const std::string kLarge = "MB are read";
  for (const Case& expected : {Case{"fuzzy pipe.fcl", kPipe},
                               {"fuzzy /dev/zero", kDevice},
                               {"fuzzy sparse.fcl", kLarge},
                               {"explain pipe.mcap", kPipe},
                               {"explain /dev/zero", kDevice},
                               {"explain sparse.mcap", "'sparse.mcap' is not a recording"},
                               {"replay pipe.mcap", kPipe},
                               {"replay /dev/zero", kDevice},
                               {"replay sparse.mcap", "is neither a recording"},
                               {"replay pipe.sqlite 3", kPipe},
                               {"run pipe.xml", kPipe},
                               {"check sparse.xml", kLarge},
                               {"report pipe.sqlite", "pipe.sqlite"},
                               {"train worlds/learned_priorities.xml --robot r1 --set "
                                "'robot[r1]/coordinator/@training=sparse.txt'",
                                kLarge},
                               {"run worlds/learned_priorities.xml --set "
                                "'robot[r1]/coordinator/@training=pipe'",
                                "there is no such file"}}) {
    CAPTURE(expected.command);
    const auto run = here.sh("ulimit -v 4000000; timeout 200 elsie " + expected.command);
    CAPTURE(run.err);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Contains(expected.sentence));
  }
}

TEST_CASE("A plugin that writes to a pipe that nobody reads is named") {
  TrespassersWorld world;
  const auto run = world.run("writing_to_a_broken_pipe");
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.err, Contains("plugin 'writing_to_a_broken_pipe' of robot 'r1' ended the program "
                               "with the signal SIGPIPE in step 50 (at 0.5 s)\n"));
}

TEST_CASE("A report that nobody reads to its end does not change the exit code") {
  TrespassersWorld world;
  world.run("starting");
  const auto run = world.here.sh(
      "sed -i s/starting/leaving/ world.xml\n"
      "{ elsie run world.xml --plugin-path " +
      world.plugins + " 2>&1 || echo $? > code; } | head -c 1\ncat code");
  CHECK_THAT(run.out, Catch::EndsWith("3\n"));
}

TEST_CASE("test-plugin finds plugins that fork or change how numbers are rounded") {
  TrespassersWorld world;
  const auto run =
      world.here.elsie("test-plugin forking rounding --variants 0 --plugin-path " + world.plugins);
  CHECK(run.exit_code == 1);
  CHECK_THAT(run.out, Contains("behavior 'forking': it makes a copy of the program with fork()") &&
                          Contains("behavior 'rounding': it changes how results are rounded for "
                                   "the whole program"));
}
