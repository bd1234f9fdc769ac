#include <limits>

#include <catch2/catch.hpp>

#include "elsie/batch/job.h"

#include "support.h"

using namespace elsie;
using Catch::Contains;

TEST_CASE("A job arrives as it was sent") {
  const batch::Job job{7,
                       "<world name=\"\xc3\xa4 \n\"/>",
                       "/a b/w.xml",
                       {{"m.fcl", "/m.fcl"}},
                       {"/x.so", "/y.so"},
                       18446744073709551615U,
                       0.1};
  const std::string line = to_json(job);
  CHECK(line.find('\n') == std::string::npos);
  const batch::Job again = batch::job_from(line);
  CHECK(again.run == 7);
  CHECK(again.world_text == job.world_text);
  CHECK(again.world_file == job.world_file);
  CHECK(again.files == job.files);
  CHECK(again.libraries == job.libraries);
  CHECK(again.seed == job.seed);
  CHECK(again.trajectory_period_s == 0.1);
}

TEST_CASE("A record arrives as it was sent, numbers to the last bit") {
  batch::RunRecord record = test::some_record();
  record.signal = "SIGSEGV";
  record.plugin = "wander";
  record.robot = "r1";
  record.step = 50;
  record.log = "one\ntwo";
  record.measures.push_back({"none", "m", "there is none", std::nullopt});
  record.measures.push_back({"nan", "m", "not a number", std::numeric_limits<double>::quiet_NaN()});
  const std::string line = to_json(record);
  CHECK(line.find('\n') == std::string::npos);
  const batch::RunRecord again = batch::record_from(line);
  CHECK(again.solver_gave_up == record.solver_gave_up);
  CHECK(again.solver_unsolved == record.solver_unsolved);
  CHECK(to_json(again) == line);
  CHECK(again.robots[0].distance_m == 0.1 + 0.2);
  CHECK(again.robots[0].pose.heading_rad == 0.5);
  CHECK(again.state == batch::RunState::done);
  CHECK(again.step == 50U);
  CHECK_FALSE(again.measures[2].value);
  CHECK_FALSE(again.measures[3].value);
  CHECK(again.events[0].detail == "resource 'a'");
}

TEST_CASE("Junk from a worker is refused with a sentence") {
  CHECK_THROWS_WITH(batch::record_from("Segmentation fault"), Contains("not a JSON object"));
  CHECK_THROWS_WITH(batch::record_from("[]"), Contains("not a JSON object"));
  CHECK_THROWS_WITH(batch::record_from("{\"state\": \"done\"}"), Contains("is not complete"));
  CHECK_THROWS_WITH(batch::record_from("{\"state\": \"fine\"}"), Contains("'fine' is not a state"));
  CHECK_THROWS_WITH(batch::job_from("{}"), Contains("the job is not complete"));
}
