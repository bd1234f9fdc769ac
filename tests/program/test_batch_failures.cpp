// Batches in which runs fail, and batches that are killed, stopped or out of disk space, and how
// they continue.
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>

#include "laboratory.h"
#include "places.h"

using Catch::Contains;
using elsie::test::Laboratory;
using elsie::test::world_with;
namespace fs = std::filesystem;

TEST_CASE("A crash, a hang or a plugin that fails costs one run, and is reported in full") {
  const Laboratory here;
  here.write_faulty({"segfaulting", "aborting", "overflowing", "looping", "not_a_number",
                     "throwing", "exiting", "thrifty"},
                    "<limits time=\"2\" wall_time=\"10\"/>");
  const auto run = here.batch("faulty.xml --workers 2");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 3);
  CHECK_THAT(run.out, Contains("elsie replay faulty.sqlite 1"));
  const auto facts = [&](const std::string& world) {
    return here.query("faulty.sqlite",
                      "SELECT state, outcome, signal, plugin, robot, step FROM runs JOIN cells ON "
                      "cells.id = cell_id WHERE world = '" +
                          world + "'");
  };
  CHECK(facts("segfaulting") == "crash|null|SIGSEGV|segfaulting|r1|50\n");
  CHECK(facts("overflowing") == "crash|null|SIGSEGV|overflowing|r1|50\n");
  CHECK(facts("aborting") == "crash|null|SIGABRT|aborting|r1|50\n");
  CHECK(facts("exiting") == "crash|null|null|exiting|r1|50\n");
  CHECK(facts("looping") == "hang|null|null|looping|r1|50\n");
  CHECK(facts("not_a_number") == "fault|null|null|not_a_number|r1|50\n");
  CHECK(facts("throwing") == "fault|null|null|throwing|r1|50\n");
  CHECK(facts("thrifty") == "done|time_limit|null|null|null|null\n");
  const std::string log =
      here.query("faulty.sqlite",
                 "SELECT log FROM runs JOIN cells ON cells.id = cell_id WHERE world = "
                 "'segfaulting'");
  CHECK_THAT(
      log, Contains("segmentation fault (SIGSEGV) in step 50 (at 0.5 s)") && Contains("the stack"));
  CHECK(
      here.query("faulty.sqlite", "SELECT message FROM runs WHERE plugin = 'looping'") ==
      "the run did not end within 10 s on the clock and was ended, while plugin 'looping' of robot "
      "'r1' was at work in step 50 (at 0.5 s)\n");
  CHECK(here.query("faulty.sqlite", "SELECT message FROM runs WHERE plugin = 'segfaulting'") ==
        "plugin 'segfaulting' of robot 'r1' crashed with SIGSEGV in step 50 (at 0.5 s)\n");
  // Data recorded before a plugin threw is kept, without measures.
  CHECK(here.query("faulty.sqlite",
                   "SELECT count(*) FROM trajectories JOIN runs ON runs.id = run_id "
                   "WHERE state = 'fault'") == "2\n");
  CHECK(here.query("faulty.sqlite", "SELECT count(DISTINCT run_id) FROM run_measures") == "1\n");
  here.check_sound("faulty.sqlite");

  // An orderly failure repeats itself; a crash is shown with its stack.
  const auto number = [&](const std::string& plugin) {
    const std::string text =
        here.query("faulty.sqlite", "SELECT id FROM runs WHERE plugin = '" + plugin + "'");
    return text.substr(0, text.size() - 1);
  };
  const auto fault = here.elsie("replay faulty.sqlite " + number("throwing"));
  CHECK(fault.exit_code == 0);
  CHECK_THAT(fault.out,
             Contains("the same: plugin 'throwing' of robot 'r1' failed in step 50 (at 0.5 s)"));
  const auto crash = here.elsie("replay faulty.sqlite " + number("segfaulting"));
  CHECK(crash.exit_code == 3);
  CHECK_THAT(crash.out, Contains("before: crash, plugin 'segfaulting' of robot 'r1' crashed"));
  CHECK_THAT(crash.err, Contains("ended the program with a segmentation fault"));

  // They are repeated only on request.
  const auto resumed = here.batch("faulty.xml --resume");
  CHECK(resumed.exit_code == 3);
  CHECK_THAT(resumed.out, Contains("all 8 runs are done already"));
  const auto again = here.batch("faulty.xml --resume --again");
  CHECK(again.exit_code == 3);
  CHECK_THAT(again.out, Contains("are done again: 7\n") && Contains("7 runs in "));
  here.check_sound("faulty.sqlite");
}

TEST_CASE("A run that fails in a copy of a process leaves the same results as in its own program") {
  const Laboratory here;
  here.write_faulty(
      {"segfaulting", "overflowing", "exiting", "throwing", "calling_nowhere", "thrifty", "leaving",
       "leaving_in_c", "leaving_quickly", "leaving_at_the_end", "leaving_elsewhere", "killing",
       "forking", "forking_and_crashing", "writing_to_a_broken_pipe", "printing", "rounding"},
      "<limits time=\"2\" wall_time=\"60\"/>", 2);
  for (const std::string database : {"copies", "programs"}) {
    const auto run = here.batch("faulty.xml --workers 2 --database " + database + ".sqlite" +
                                (database == "programs" ? " --fresh-processes" : ""));
    CAPTURE(run.out, run.err);
    CHECK(run.exit_code == 3);
    CHECK(here.query(database + ".sqlite", "SELECT count(*) FROM runs WHERE state = 'pending'") ==
          "0\n");
  }
  CHECK(here.table("copies.sqlite") == here.table("programs.sqlite"));
  const auto logs = [&](const std::string& database) {
    return here.query(database, "SELECT count(*) FROM runs WHERE log LIKE '%the stack%'");
  };
  CHECK(logs("copies.sqlite") == logs("programs.sqlite"));
}

TEST_CASE("A run whose end is a matter of chance does not affect others") {
  const Laboratory here;
  // What is overwritten depends on where it is; and a thread may crash before the run ends or not.
  here.write_faulty({"smashing_heap", "crashing_beside", "thrifty"},
                    "<limits time=\"2\" wall_time=\"60\"/>", 3);
  CHECK(here.batch("faulty.xml --workers 2").exit_code == 3);
  CHECK(here.query("faulty.sqlite",
                   "SELECT world, count(*) FROM runs JOIN cells ON cells.id = cell_id WHERE state "
                   "= CASE world WHEN 'smashing_heap' THEN 'crash' WHEN 'thrifty' THEN 'done' ELSE "
                   "state END AND state <> 'pending' GROUP BY world ORDER BY world") ==
        "crashing_beside|3\nsmashing_heap|3\nthrifty|3\n");
}

TEST_CASE("A worker that is killed from outside costs its run only") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 3);
  const auto run =
      here.sh(Laboratory::kWorkersOf + Laboratory::kDawdlesOnRequest +
              "elsie batch faulty.xml --workers 1 --quiet --plugin-path " + Laboratory::plugins() +
              " & batch=$!\n"
              "while ! worker=$(workers_of $batch) || [ -z \"$worker\" ]; do sleep "
              "0.02; done\n"
              "kill -9 $worker\n"
              "pass_all\n"
              "wait $batch && code=$? || code=$?\n"
              "exit $code");
  CHECK(run.exit_code == 3);
  CHECK(here.query("faulty.sqlite", "SELECT state, signal FROM runs ORDER BY id") ==
        "crash|SIGKILL\ndone|null\ndone|null\n");
  CHECK(here.batch_at_once("faulty.xml --resume --again --quiet").exit_code == 0);
}

TEST_CASE("A worker leaves a request to end to its batch: a run has no result because of it") {
  // A cluster sends SIGTERM to all processes of a task, in any order.
  const Laboratory here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 4);
  const auto run =
      here.sh(Laboratory::kWorkersOf + Laboratory::kDawdlesOnRequest +
              "elsie batch faulty.xml --workers 1 --quiet --plugin-path " + Laboratory::plugins() +
              " & batch=$!\n"
              "while ! worker=$(workers_of $batch) || [ -z \"$worker\" ]; do sleep "
              "0.002; done\n"
              "kill -TERM $worker; sleep 0.5; kill -TERM $worker; sleep 0.2; kill -TERM $batch\n"
              "wait $batch && code=$? || code=$?\n"
              "exit $code");
  CHECK(run.exit_code == 4);
  CHECK(here.query("faulty.sqlite",
                   "SELECT count(*) FROM runs WHERE state NOT IN ('pending', 'done')") == "0\n");
  CHECK(here.batch_at_once("faulty.xml --resume --quiet").exit_code == 0);
}

TEST_CASE("A batch that is killed continues where it was: no run is lost, none done twice") {
  const Laboratory here;
  here.write("many.xml", Laboratory::experiment("<world file=\"small.xml\"/>", Laboratory::kSpeeds,
                                                16, "<limits time=\"10\"/>"));
  REQUIRE(here.elsie("batch many.xml --quiet --database whole.sqlite").exit_code == 0);
  std::string ended;  // end of each run, as soon as it has ended
  int kills = 0;
  for (; kills < 200; ++kills) {
    // At any point of its work, and later each time, so that slow machines also finish runs.
    const int milliseconds = 30 + std::rand() % (100 + 30 * kills);
    const auto run = here.sh(
        "elsie batch many.xml --quiet --database killed.sqlite --resume & batch=$!\n"
        "sleep " +
        std::to_string(milliseconds / 1000.0) +
        "\n"
        "kill -9 $batch 2>/dev/null || true\n"
        "wait $batch && code=$? || code=$?\n"
        "exit $code");
    if (!fs::exists(here.file("killed.sqlite"))) {
      continue;
    }
    if (run.exit_code == 0) {
      break;
    }
    CHECK(run.exit_code == 128 + 9);
    try {
      const std::string now = here.query(
          "killed.sqlite", "SELECT id, ended FROM runs WHERE state <> 'pending' ORDER BY id");
      std::istringstream lines(ended);
      for (std::string line; std::getline(lines, line);) {
        CHECK_THAT(now, Contains(line + "\n"));
      }
      ended = now;
    } catch (const std::runtime_error& error) {
      CHECK_THAT(error.what(), Contains("no such table"));  // killed before the tables were made
    }
    if (kills > 20) {  // a slow machine: let it finish
      CHECK(here.elsie("batch many.xml --quiet --database killed.sqlite --resume").exit_code == 0);
      break;
    }
  }
  CHECK(kills > 1);
  CHECK(here.table("killed.sqlite") == here.table("whole.sqlite"));
  CHECK(here.query("killed.sqlite", "SELECT count(*) FROM runs WHERE state = 'done'") == "48\n");
  here.check_sound("killed.sqlite");
}

TEST_CASE("The workers of a batch that is killed end with it") {
  const Laboratory here;
  here.write_faulty({"looping"}, "", 2);
  const auto run =
      here.sh(Laboratory::kWorkersOf + "elsie batch faulty.xml --workers 2 --quiet --plugin-path " +
              Laboratory::plugins() +
              " & batch=$!\n"
              "while [ $(workers_of $batch | wc -w) -lt 2 ]; do sleep 0.02; done\n"
              "workers=$(processes_of $batch)\n"
              "kill -9 $batch; wait $batch || true\n"
              "i=0; while [ $i -lt 600 ]; do i=$((i+1))\n"
              "  left=0; for w in $workers; do\n"
              "    if grep -q '^State:.[RSD]' /proc/$w/status 2>/dev/null; then left=1; fi; done\n"
              "  if [ $left = 0 ]; then exit 0; fi; sleep 0.1\n"
              "done; exit 1");
  CHECK(run.exit_code == 0);
}

TEST_CASE("Ctrl-C stops a batch in order: done runs are kept, the others stay pending") {
  const Laboratory here;
  here.write_faulty({"thrifty", "dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  for (const std::string signal : {"INT", "TERM"}) {
    const std::string name = signal + ".sqlite";
    const auto run =
        here.sh(Laboratory::kDawdlesOnRequest + "elsie batch faulty.xml --workers 1 --database " +
                name + " --plugin-path " + Laboratory::plugins() +
                " & batch=$!\n"
                "pass_one; pass_one\n"
                "while ! sqlite3 " +
                name +
                " 'SELECT count(*) FROM runs WHERE state = \"done\"' 2>/dev/null "
                "| grep -q 3; do sleep 0.05; done\n"
                "kill -" +
                signal +
                " $batch\n"
                "wait $batch && code=$? || code=$?\n"
                "exit $code");
    CHECK(run.exit_code == 4);
    CHECK_THAT(run.out, Contains("; 1 of 2 seeds complete\n") && Contains("results: " + name));
    CHECK_THAT(run.err,
               Contains("interrupted; 1 of 4 runs are still to be done, 1 of 2 seeds "
                        "complete. Continue with\n  elsie "
                        "batch faulty.xml --plugin-path " +
                        Laboratory::plugins() + " --workers 1 --database " + name + " --resume\n"));
    // Both cells with the first seed, before the second begins.
    CHECK(here.query(name, "SELECT state FROM runs ORDER BY seed, id") ==
          "done\ndone\ndone\npending\n");
    CHECK_THAT(here.elsie("report " + name).out,
               Contains("4 runs: 2 cells, 1 of 2 seeds complete; 1 still to be done"));
    CHECK_FALSE(fs::exists(here.file(name + "-lock")));
  }
  CHECK(here.batch_at_once("faulty.xml --database INT.sqlite --resume --quiet").exit_code == 0);
  here.check_sound("INT.sqlite");
}

TEST_CASE("A batch that is interrupted while its database is made leaves nothing behind") {
  const Laboratory here;
  here.write("many.xml", Laboratory::experiment("<world file=\"small.xml\"/>", "", 300'000));
  for (const std::string signal : {"INT", "TERM"}) {
    const auto run = here.sh(
        "elsie batch many.xml & batch=$!\n"
        "while kill -0 $batch && ! [ -e many.sqlite-lock ]; do sleep 0.005; done\n"
        "kill -" +
        signal +
        " $batch\n"
        "wait $batch && code=$? || code=$?\n"
        "ls | grep '^many[.]sqlite' || true\n"
        "exit $code");
    CHECK(run.exit_code == 4);
    CHECK(run.out.empty());
    CHECK(run.err == "elsie: interrupted; nothing was begun\n");
  }
}

TEST_CASE("A signal that comes twice at once is one request to stop") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 4);
  // timeout(1) and schedulers send it to the process and to its group. On a busy machine the
  // signals may come too far apart, and prove nothing.
  elsie::test::ProgramRun run;
  bool in_time = false;
  for (int tries = 0; tries < 20 && !in_time; ++tries) {
    run = here.sh(Laboratory::kWorkersOf + Laboratory::kDawdlesOnRequest +
                  "rm -f faulty.sqlite* late\n"
                  "elsie batch faulty.xml --workers 1 --plugin-path " +
                  Laboratory::plugins() +
                  " & batch=$!\n"
                  "while [ -z \"$(workers_of $batch)\" ]; do sleep 0.02; done\n"
                  "begun=$(date +%s%N)\n"
                  "kill -TERM $batch; sleep 0.005; kill -TERM $batch 2>/dev/null || true\n"
                  "sleep 0.002; kill -INT $batch 2>/dev/null || true\n"
                  "if [ $(($(date +%s%N) - begun)) -gt 450000000 ]; then touch late; fi\n"
                  "wait $batch && code=$? || code=$?\n"
                  "exit $code");
    in_time = !fs::exists(here.file("late"));
  }
  REQUIRE(in_time);
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err, Contains("interrupted; 4 of 4 runs are still to be done"));
  CHECK_FALSE(fs::exists(here.file("faulty.sqlite-lock")));
  CHECK_FALSE(fs::exists(here.file("faulty.sqlite-wal")));
}

TEST_CASE("Two batches do not write one database") {
  const Laboratory here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  const auto run =
      here.sh(Laboratory::kWorkersOf + Laboratory::kDawdlesOnRequest +
              "elsie batch faulty.xml --workers 1 --quiet --plugin-path " + Laboratory::plugins() +
              " & batch=$!\n"
              "while [ -z \"$(workers_of $batch)\" ]; do sleep 0.02; done\n"
              "elsie batch faulty.xml --resume --plugin-path " +
              Laboratory::plugins() +
              " && code=$? || code=$?\n"
              "pass_all; wait $batch\n"
              "exit $code");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err, Contains("is being written by another batch (process "));
  CHECK(here.query("faulty.sqlite", "SELECT count(*) FROM runs WHERE state = 'done'") == "2\n");
}

TEST_CASE("A full disk ends a batch with a sentence; it continues when there is space") {
  const Laboratory here;
  here.write("many.xml", Laboratory::experiment("<world file=\"small.xml\"/>", Laboratory::kSpeeds,
                                                8, "<trajectories period=\"0.01\"/>"));
  // No file may grow beyond this, as on a full disk.
  const auto full = here.sh("ulimit -f 300; elsie batch many.xml --quiet");
  CHECK(full.exit_code == 4);
  CHECK_THAT(full.err, Contains("the database 'many.sqlite' could not be written: ") &&
                           Contains("elsie batch many.xml --database many.sqlite --resume"));
  CHECK(here.query("many.sqlite", "SELECT count(*) FROM runs WHERE state = 'pending'") != "0\n");
  CHECK(here.elsie("batch many.xml --quiet --resume").exit_code == 0);
  REQUIRE(here.elsie("batch many.xml --quiet --database whole.sqlite").exit_code == 0);
  CHECK(here.table("many.sqlite") == here.table("whole.sqlite"));
}

TEST_CASE("A batch notices files that change, even during its last run") {
  const Laboratory here;
  fs::remove(here.file("fuzzy_models"));
  fs::copy(elsie::test::source_path("fuzzy_models"), here.file("fuzzy_models"));
  const std::string model = "fuzzy_models/avoid_obstacle_left.fcl";
  here.write("small.xml", world_with("dawdling", "<avoid_obstacle left_model=\"" + model + "\"/>"));
  here.write("small_experiment.xml", Laboratory::experiment("<world file=\"small.xml\"/>", "", 3,
                                                            Laboratory::kTwoDawdledSteps));
  const std::string content = here.read(model);
  const auto run = here.sh(Laboratory::kWorkersOf + Laboratory::kDawdlesOnRequest +
                           "elsie batch small_experiment.xml --workers 1 --plugin-path " +
                           Laboratory::plugins() +
                           " & batch=$!\n"
                           "while [ -z \"$(workers_of $batch)\" ]; do sleep 0.02; done\n"
                           "echo >> " +
                           model +
                           "\n"
                           "pass_all; wait $batch && code=$? || code=$?\n"
                           "exit $code");
  CHECK(run.exit_code == 4);
  // The active run is not written: it may have read the file before or after the change.
  CHECK_THAT(run.err, Contains(model + "' has changed since the batch began"));
  CHECK(here.query("small_experiment.sqlite",
                   "SELECT count(*) FROM runs WHERE state = 'pending'") == "3\n");
  auto resumed = here.batch("small_experiment.xml --resume");
  CHECK(resumed.exit_code == 2);
  CHECK_THAT(resumed.err,
             Contains("changed since it was begun: the data file '") && Contains(", now "));
  here.write(model, content);
  resumed = here.batch_at_once("small_experiment.xml --resume --quiet");
  CHECK(resumed.exit_code == 0);
}
