// The pool with shell scripts as workers, which do whatever a process may do.
#include <chrono>
#include <fstream>
#include <map>
#include <thread>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "elsie/batch/worker_pool.h"

#include "support.h"

using namespace elsie;
using Catch::Contains;

namespace {

/// Does `count` jobs with a script, which gets the job on its standard input.
std::map<std::int64_t, batch::RunRecord> results_of(const std::string& script, std::int64_t count,
                                                    batch::PoolOptions options = {}) {
  options.command = {"/bin/sh", "-c", script};
  batch::WorkerPool pool(std::move(options));
  std::map<std::int64_t, batch::RunRecord> results;
  std::int64_t next = 0;
  const bool complete = pool.run(
      [&]() -> std::optional<batch::Job> {
        if (next == count) {
          return std::nullopt;
        }
        batch::Job job;
        job.run = ++next;
        return job;
      },
      [&](std::int64_t run, batch::RunRecord record) {
        CHECK(results.emplace(run, std::move(record)).second);
      });
  CHECK(complete);
  return results;
}

batch::RunRecord result_of(const std::string& script, batch::PoolOptions options = {}) {
  auto results = results_of(script, 1, std::move(options));
  REQUIRE(results.size() == 1);
  return std::move(results.at(1));
}

const std::string kDone = to_json(test::some_record());

bool is_alive(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(status, text);
  return !text.empty() && text.find(") Z") == std::string::npos;
}

}  // namespace

TEST_CASE("A worker gets its job and hands over its record") {
  const auto record = result_of("grep -q '\"run\":1,' && echo '" + kDone + "' >&3");
  CHECK(record.state == batch::RunState::done);
  CHECK(record.outcome == simulation::Outcome::success);
  CHECK(record.exit_code == 0);
  CHECK_FALSE(record.log);
}

TEST_CASE("Every job is done once, with any number of workers") {
  for (const std::size_t workers : {1U, 3U, 16U}) {
    const auto results =
        results_of("cat >/dev/null; echo '" + kDone + "' >&3", 12, {.workers = workers});
    CHECK(results.size() == 12);
  }
}

TEST_CASE("Workers are at work at the same time, and no more than allowed") {
  const test::Folder folder;
  // Each waits until it has once seen three of them, and reports the largest number that it has
  // seen.
  const std::string script = "d='" + folder.file("") +
                             "'; mkdir -p $d/at_work/$$; most=0; tries=0\n"
                             "while [ $tries -lt 200 ]; do\n"
                             "  now=$(ls $d/at_work | wc -l)\n"
                             "  if [ $now -gt $most ]; then most=$now; fi\n"
                             "  if [ $now -ge 3 ]; then touch $d/three; fi\n"
                             "  if [ -e $d/three ]; then break; fi\n"
                             "  tries=$((tries + 1)); sleep 0.05\n"
                             "done\n"
                             "echo $most; rmdir $d/at_work/$$; exit 1";
  const auto results = results_of(script, 6, {.workers = 3});
  int most = 0;
  for (const auto& [run, record] : results) {
    most = std::max(most, std::stoi(record.log.value()));
  }
  CHECK(most == 3);
}

TEST_CASE("A large record arrives whole") {
  const test::Folder folder;
  batch::RunRecord large = test::some_record();
  large.trajectories[0].poses = std::string(3'000'000, ' ');
  folder.write("record", to_json(large) + "\n");
  const auto record = result_of("cat '" + folder.file("record") + "' >&3");
  REQUIRE(record.state == batch::RunState::done);
  CHECK(record.trajectories[0].poses.size() == 3'000'000);
}

TEST_CASE("A process that ends without a record is a crash") {
  const auto killed = result_of("echo some words; echo more >&2; kill -SEGV $$");
  CHECK(killed.state == batch::RunState::crash);
  CHECK(killed.signal == "SIGSEGV");
  CHECK_FALSE(killed.exit_code);
  CHECK(killed.log == "some words\nmore\n");
  CHECK(killed.message == "the process was ended by SIGSEGV");
  CHECK(killed.wall_s > 0.0);

  const auto out_of_memory = result_of("kill -KILL $$");
  CHECK(out_of_memory.signal == "SIGKILL");
  CHECK_THAT(out_of_memory.message, Contains("memory ran out"));

  const auto gone = result_of("exit 7");
  CHECK(gone.state == batch::RunState::crash);
  CHECK(gone.exit_code == 7);
  CHECK(gone.message == "the process ended with exit code 7 before its run did");
}

TEST_CASE("A worker's last line names the culprit") {
  const auto record = result_of(
      "printf '{\"state\":\"do\\n!wander\\troam\\tr1\\t50\\tSIGSEGV\\t0.5\\n' >&3; exit 3");
  CHECK(record.state == batch::RunState::crash);
  CHECK(record.signal == "SIGSEGV");
  CHECK(record.exit_code == 3);
  CHECK(record.plugin == "wander");
  CHECK(record.robot == "r1");
  CHECK(record.step == 50U);
  CHECK(record.message ==
        "plugin 'wander' (id 'roam') of robot 'r1' crashed with SIGSEGV in step 50 (at 0.5 s)");

  const auto left = result_of("printf '\\n!wander\\twander\\tr1\\t\\t\\n' >&3; exit 3");
  CHECK(left.state == batch::RunState::crash);
  CHECK_FALSE(left.signal);
  CHECK(left.message ==
        "plugin 'wander' of robot 'r1' ended the process by exit() or a similar call");
}

TEST_CASE("Junk instead of a record is reported as an error") {
  const auto junk = result_of("echo hello >&3");
  CHECK(junk.state == batch::RunState::error);
  CHECK_THAT(junk.message, Contains("exit code 0 before its run did") &&
                               Contains("the answer of the worker is not a JSON object"));
  const auto cut = result_of("printf '{\"state\":\"done\"' >&3");
  CHECK(cut.state == batch::RunState::error);
}

TEST_CASE("A worker that cannot be started is reported") {
  batch::WorkerPool pool({.command = {"/nowhere/elsie", "batch-worker"}});
  bool given = false;
  batch::RunRecord result;
  pool.run(
      [&]() -> std::optional<batch::Job> {
        return std::exchange(given, true) ? std::nullopt : std::optional<batch::Job>(batch::Job{});
      },
      [&](std::int64_t, batch::RunRecord record) { result = std::move(record); });
  CHECK(result.message == "the worker could not be started");
}

TEST_CASE("Only the tail of a worker's output is kept, as readable text") {
  const auto record = result_of(
      "i=0; while [ $i -lt 5000 ]; do echo line $i; i=$((i+1)); done; printf 'a\\001\\377\\303\\244"
      "\\000z'; exit 1");
  REQUIRE(record.log);
  CHECK(record.log->size() < batch::kLogTail + 100);
  CHECK(record.log->starts_with("[...]\n"));
  CHECK_THAT(*record.log,
             Catch::EndsWith("line 4999\na\xef\xbf\xbd\xef\xbf\xbd\xc3\xa4\xef\xbf\xbdz"));
}

TEST_CASE("A worker that takes too long reports the plugin at work, and is ended") {
  // A shell runs its trap when its child has ended, so it waits for the child in the background.
  const auto asked = result_of(
      "trap 'printf \"\\n!looping\\tlooping\\tr1\\t50\\t\\t0.5\\n\" >&3; exit 3' XCPU; sleep 60 & "
      "wait",
      {.wall_limit_s = 0.3});
  CHECK(asked.state == batch::RunState::hang);
  CHECK(asked.plugin == "looping");
  CHECK(asked.step == 50U);
  CHECK(asked.message ==
        "the run did not end within 0.3 s on the clock and was ended, while plugin 'looping' of "
        "robot 'r1' was at work in step 50 (at 0.5 s)");
}

TEST_CASE("A slow run is reported by its step: no plugin is to blame") {
  const auto slow =
      result_of("trap 'printf \"\\n!\\t\\t\\t626\\t\\t6.26\\n\" >&3; exit 3' XCPU; sleep 60 & wait",
                {.wall_limit_s = 0.3});
  CHECK(slow.state == batch::RunState::hang);
  CHECK(slow.step == 626);
  CHECK_FALSE(slow.plugin);
  CHECK(
      slow.message ==
      "the run did not end within 0.3 s on the clock and was ended in step 626 (at 6.26 s), while "
      "no plugin was at work");
}

TEST_CASE("A worker that ignores the request is killed with its children") {
  const test::Folder folder;
  const auto start = std::chrono::steady_clock::now();
  const auto deaf = result_of("trap '' XCPU; sleep 60 & echo $! > '" + folder.file("child") +
                                  "'; echo waiting; while :; do sleep 60; done",
                              {.wall_limit_s = 0.3, .grace_s = 0.2});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  CHECK(deaf.state == batch::RunState::hang);
  CHECK_FALSE(deaf.plugin);
  CHECK(deaf.message == "the run did not end within 0.3 s on the clock and was ended");
  CHECK(deaf.log == "waiting\n");
  const pid_t child = std::stoi(folder.read("child"));
  for (int i = 0; i < 100 && is_alive(child); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  CHECK_FALSE(is_alive(child));
}

TEST_CASE("A process that a worker leaves behind does not keep the pool waiting") {
  const auto start = std::chrono::steady_clock::now();
  const auto record = result_of("sleep 60 & echo '" + kDone + "' >&3");
  CHECK(record.state == batch::RunState::done);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}

TEST_CASE("A pool that is stopped kills its workers; their runs are not reported") {
  const test::Folder folder;
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  std::thread stopper([&] {
    while (folder.read("child").empty()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    CHECK(write(ends[1], "!", 1) == 1);
  });
  batch::WorkerPool pool(
      {.command = {"/bin/sh", "-c", "echo $$ > '" + folder.file("child") + "'; sleep 60"},
       .stop_descriptor = ends[0]});
  bool heard = false;
  CHECK_FALSE(pool.run([] { return batch::Job{}; },
                       [&](std::int64_t, const batch::RunRecord&) { heard = true; }));
  stopper.join();
  CHECK_FALSE(heard);
  CHECK_FALSE(is_alive(std::stoi(folder.read("child"))));
  close(ends[0]);
  close(ends[1]);
}

TEST_CASE("When a result cannot be stored, the work ends and workers are killed") {
  batch::WorkerPool pool({.command = {"/bin/sh", "-c", "exit 0"}, .workers = 2});
  int kept = 0;
  CHECK_THROWS_WITH(pool.run([] { return batch::Job{}; },
                             [&](std::int64_t, const batch::RunRecord&) {
                               if (++kept == 3) {
                                 throw std::runtime_error("full");
                               }
                             }),
                    "full");
  CHECK(kept == 3);
}

TEST_CASE("The first error is reported, also when the last results cannot be stored either") {
  batch::WorkerPool pool({.command = {"/bin/sh", "-c", "exit 0"}, .workers = 1});
  int given = 0;
  CHECK_THROWS_WITH(
      pool.run(
          [&]() -> std::optional<batch::Job> {
            if (++given == 2) {
              throw std::runtime_error("a file has changed");
            }
            return batch::Job{};
          },
          [](std::int64_t, const batch::RunRecord&) { throw std::runtime_error("full"); }),
      "a file has changed");
  CHECK(given == 2);
}
