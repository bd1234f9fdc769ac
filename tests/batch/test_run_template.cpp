// Workers that are copies of a process: the program's own, not scripts.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <unistd.h>

#include "elsie/batch/batch.h"
#include "elsie/batch/worker_pool.h"

#include "support.h"
#include "variable.h"

using namespace elsie;
using Catch::Contains;

namespace {

const std::string kProgram = test::build_path("bin/elsie");
const std::vector<std::string> kWorker{kProgram, "batch-worker"};
const std::vector<std::string> kTemplate{kProgram, "batch-template"};
/// Where only copies may do runs.
const std::vector<std::string> kNoWorker{"/bin/false"};

using Records = std::map<std::int64_t, std::string>;

Records records_of(const std::vector<batch::Job>& jobs, batch::PoolOptions options,
                   const std::function<void()>& after_run = {}) {
  batch::WorkerPool pool(std::move(options));
  Records records;
  auto next = jobs.begin();
  CHECK(pool.run([&] { return next == jobs.end() ? std::nullopt : std::optional(*next++); },
                 [&](std::int64_t run, batch::RunRecord record) {
                   record.wall_s = 0.0;
                   records[run] = to_json(record);
                   if (after_run) {
                     after_run();
                   }
                 }));
  return records;
}

std::vector<batch::Job> jobs_of(const batch::Plan& plan) {
  std::vector<batch::Job> jobs;
  for (const batch::PlannedRun& run : plan.runs) {
    jobs.push_back(batch::job_of(plan, run));
  }
  return jobs;
}

/// A stack has other addresses in each process.
Records without_log(Records records) {
  for (auto& [run, text] : records) {
    batch::RunRecord record = batch::record_from(text);
    record.log.reset();
    text = to_json(record);
  }
  return records;
}

/// The processes that this one and its children have started and that are copied.
std::vector<pid_t> templates(pid_t of = getpid()) {
  const std::string folder = "/proc/" + std::to_string(of);
  std::ifstream children(folder + "/task/" + std::to_string(of) + "/children");
  std::vector<pid_t> found;
  for (pid_t child = 0; children >> child;) {
    std::ifstream name("/proc/" + std::to_string(child) + "/comm");
    std::string text;
    if (std::getline(name, text) && text == "elsie-template") {
      found.push_back(child);
    }
    const std::vector<pid_t> more = templates(child);
    found.insert(found.end(), more.begin(), more.end());
  }
  return found;
}

/// A job with a plugin of a library that leaves something behind when it is loaded.
batch::Job job_with_faulty(const std::string& plugin = "thrifty") {
  batch::Job job;
  job.run = 7;
  job.cell = 0;
  job.world_text = R"(<world format="1"><limits time="1"/><robots><robot id="r1" team="red">
      <behaviors><)" +
                   plugin + R"(/></behaviors><coordinator><arbiter_suppression/></coordinator>
      </robot></robots></world>)";
  job.world_file = "w.xml";
  job.libraries = {test::plugin_directory() + "/arbiter_suppression.so",
                   test::build_path("tests/program/plugins/faulty.so")};
  return job;
}

}  // namespace

TEST_CASE_METHOD(
    test::SmallBatch,
    "Copies give the same records as programs of their own, with any number of workers") {
  const std::vector<batch::Job> jobs = jobs_of(plan);
  const Records expected = records_of(jobs, {.command = kWorker});
  CHECK(expected.size() == 6);
  for (const std::size_t workers : {1U, 2U, 5U}) {
    CHECK(records_of(jobs,
                     {.command = kNoWorker, .template_command = kTemplate, .workers = workers}) ==
          expected);
  }
}

TEST_CASE("Runs of a cell share a process that has read their world; repetitions do not") {
  const test::Folder folder;
  auto experiment = test::small_experiment(folder);
  experiment.repeats = 2;
  const auto jobs = jobs_of(batch::make_plan(experiment, test::shipped(), test::plan_options()));
  std::size_t most = 0;
  records_of(jobs, {.command = kNoWorker, .template_command = kTemplate, .workers = 3},
             [&] { most = std::max(most, templates().size()); });
  // For each repetition one with the libraries, and one for each of two cells.
  CHECK(most == 6);
  CHECK(templates().empty());
}

TEST_CASE_METHOD(test::SmallBatch,
                 "Runs with worlds of their own share a process that has loaded their libraries") {
  std::vector<batch::Job> jobs = jobs_of(plan);
  for (batch::Job& job : jobs) {
    job.cell.reset();
  }
  std::size_t most = 0;
  CHECK(records_of(jobs, {.command = kNoWorker, .template_command = kTemplate, .workers = 3}, [&] {
          most = std::max(most, templates().size());
        }) == records_of(jobs, {.command = kWorker}));
  CHECK(most == 1);
}

TEST_CASE_METHOD(test::SmallBatch, "Threads are started in the copies") {
  std::vector<batch::Job> jobs = jobs_of(plan);
  const Records expected = records_of(jobs, {.command = kWorker});
  for (batch::Job& job : jobs) {
    job.threads = 3;
  }
  CHECK(records_of(jobs, {.command = kNoWorker, .template_command = kTemplate, .workers = 2}) ==
        expected);
}

TEST_CASE_METHOD(
    test::SmallBatch,
    "A template that is killed costs no run, even one of its copies at work; another follows") {
  const std::vector<batch::Job> jobs = jobs_of(plan);
  std::vector<pid_t> seen;
  const Records records =
      records_of(jobs, {.command = kWorker, .template_command = kTemplate}, [&] {
        for (const pid_t process : templates()) {
          if (std::find(seen.begin(), seen.end(), process) == seen.end()) {
            seen.push_back(process);
          }
          if (seen.size() < 3) {
            kill(process, SIGKILL);
          }
        }
      });
  CHECK(seen.size() >= 2);
  CHECK(records == records_of(jobs, {.command = kWorker}));
}

TEST_CASE("Libraries that leave something behind when they are loaded are loaded by each run") {
  const std::vector<batch::Job> jobs{job_with_faulty()};
  const Records expected = records_of(jobs, {.command = kWorker});
  const std::map<std::string, std::string> reasons{{"thread", "one of them started a thread"},
                                                   {"process", "one of them started a process"},
                                                   {"file", "one of them opened or closed a file"},
                                                   {"memory", "one of them shared memory"}};
  for (const auto& [what, reason] : reasons) {
    CAPTURE(what);
    const Variable wish("FAULTY_LEAVES_BEHIND", what.c_str());
    std::string noted;
    const Records records =
        records_of(jobs, {.command = kWorker,
                          .template_command = kTemplate,
                          .note = [&](const std::string& text) { noted += text; }});
    CHECK(records.at(7) == expected.at(7));
    CHECK_THAT(noted, Contains(reason) && Contains("faulty.so"));
  }
}

TEST_CASE("A plugin that fails while its objects are made does so in its run, as ever") {
  const std::map<std::string, std::string> reasons{
      {"throws_when_made", "this failed"},
      {"crashes_when_made", "the process that was to be copied ended"},
      {"crashes_when_configured", "the process that was to be copied ended"},
      {"loops_when_made", "this took longer than the wall limit of a run"}};
  for (const auto& [plugin, reason] : reasons) {
    CAPTURE(plugin);
    const std::vector<batch::Job> jobs{job_with_faulty(plugin)};
    std::string noted;
    const double limit_s = plugin.starts_with("loops") ? 3.0 : 60.0;
    const Records records =
        records_of(jobs, {.command = kNoWorker,
                          .template_command = kTemplate,
                          .wall_limit_s = limit_s,
                          .grace_s = 60.0,
                          .note = [&](const std::string& text) { noted += text; }});
    const Records expected =
        records_of(jobs, {.command = kWorker, .wall_limit_s = limit_s, .grace_s = 60.0});
    CHECK(without_log(records).at(7) == without_log(expected).at(7));
    CHECK_THAT(noted, Contains("reads it and makes its plugins anew, because " + reason));
  }
}

TEST_CASE("A library that ends its process while it is loaded fails in its run, as ever") {
  const std::vector<batch::Job> jobs{job_with_faulty()};
  const Variable wish("FAULTY_WHILE_LOADED", "at once");
  std::string noted;
  const Records records =
      records_of(jobs, {.command = kWorker,
                        .template_command = kTemplate,
                        .note = [&](const std::string& text) { noted += text; }});
  CHECK_THAT(noted, Contains("the process that was to be copied ended"));
  CHECK(records == records_of(jobs, {.command = kWorker}));
  CHECK_THAT(records.at(7), Contains("\"state\":\"crash\""));
}

TEST_CASE("A library that is never loaded to the end fails in its run at the wall limit") {
  batch::Job job = job_with_faulty();
  job.libraries.push_back(test::build_path("tests/program/plugins/trespassers.so"));
  const Variable wish("TRESPASS_WHILE_LOADED", "loop");
  std::string noted;
  const Records records =
      records_of({job}, {.command = kWorker,
                         .template_command = kTemplate,
                         .wall_limit_s = 0.5,
                         .grace_s = 0.5,
                         .note = [&](const std::string& text) { noted += text; }});
  CHECK_THAT(noted, Contains("this took longer than the wall limit of a run"));
  CHECK_THAT(records.at(7), Contains("\"state\":\"hang\""));
}

TEST_CASE("What libraries print while they are loaded is in the log of a run that fails") {
  const batch::Job job = job_with_faulty("throwing");
  const Variable wish("FAULTY_LEAVES_BEHIND", "text");
  const Records records = records_of({job}, {.command = kNoWorker, .template_command = kTemplate});
  CHECK_THAT(records.at(7), Contains("\"state\":\"fault\"") && Contains("\"log\":\"loaded\\n"));
}
