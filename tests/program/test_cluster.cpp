// Batches on a cluster: a real Slurm, started for each test on this machine.
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "laboratory.h"
#include "places.h"
#include "program.h"

using Catch::Contains;
using elsie::test::Laboratory;
using elsie::test::ProgramRun;
namespace fs = std::filesystem;

namespace {

class Cluster : public Laboratory {
 public:
  /// Runs shell lines next to a Slurm of this test.
  ProgramRun with_slurm(const std::string& lines) const {
    write("lines.sh",
          "set -eu\n"
          "batch() { elsie batch \"$@\" --plugin-path '" +
              plugins() +
              "'; }\n"
              // To be started with &: signals reach the program itself.
              "follow() { exec elsie batch \"$@\" --plugin-path '" +
              plugins() +
              "'; }\n"
              // The processes of this test's tasks only: their databases are in this folder.
              "tasks() { pgrep -f -- \"--database $PWD/.*shard-$1\\\\.sqlite\" || true; }\n"
              "until_there() { while [ -z \"$(tasks \"$1\")\" ]; do sleep 0.05; done; }\n"
              "until_begun() { until [ -s \"$1-shards/shard-$2.json\" ]; do sleep 0.05; done; }\n" +
              lines);
    return sh("'" + elsie::test::source_path("tests/program/slurm/with-slurm") +
              "' \"$PWD/slurm\" sh lines.sh");
  }
  /// The results of the same experiment without a cluster.
  std::string alone(const std::string& experiment) const {
    const auto run = sh("elsie batch \"$PWD/" + experiment +
                        "\" --quiet --database alone.sqlite --plugin-path '" + plugins() + "'");
    CHECK(run.err.empty());
    return table("alone.sqlite");
  }
};

}  // namespace

TEST_CASE("A cluster gives the results of one machine, and leaves one database") {
  const Cluster here;
  const auto run = here.with_slurm(
      "batch small_experiment.xml --cluster slurm --shards 5 --database all.sqlite\n"
      "echo ---\n"
      "batch small_experiment.xml --cluster slurm --resume --database all.sqlite\n");
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("5 of 5 shards, 24 runs in all") && Contains("24 runs in ") &&
                          Contains("results: all.sqlite"));
  CHECK_THAT(run.out.substr(run.out.find("---")), Contains("all 24 runs are done already"));
  CHECK(here.table("all.sqlite") == here.alone("small_experiment.xml"));
  CHECK_FALSE(fs::exists(here.file("all.sqlite-shards")));
  here.check_sound("all.sqlite");
}

TEST_CASE(
    "Tasks that are killed half-way leave their shards to be done, and nothing is done twice") {
  const Cluster here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 6);
  const auto run = here.with_slurm(
      // Each shard has two runs. After its first run, one process is killed, one task is cancelled.
      Laboratory::kDawdlesOnRequest +
      "follow faulty.xml --cluster slurm --shards 3 --database all.sqlite & follower=$!\n"
      "until_there 1\n"
      "pass_one 1; pass_one 1\n"
      "until grep -q '\"ended\":1' all.sqlite-shards/shard-1.json; do sleep 0.05; done\n"
      "kill -9 $(tasks 1)\n"
      "pass_one 2; pass_one 2\n"
      "until grep -q '\"ended\":1' all.sqlite-shards/shard-2.json; do sleep 0.05; done\n"
      "scancel $(cat all.sqlite-shards/cluster.json | sed "
      "'s/.*\"job\":\"\\([0-9]*\\)\".*/\\1/')_2\n"
      "pass_all 3; wait $follower && code=$? || code=$?\n"
      "echo code $code\n"
      "sqlite3 all.sqlite-shards/shard-1.sqlite \"SELECT id, ended FROM runs WHERE state = "
      "'done'\" "
      "> before\n"
      "pass_all 1; pass_all 2\n"
      "batch faulty.xml --cluster slurm --resume --database all.sqlite\n"
      "sqlite3 all.sqlite 'SELECT id, ended FROM runs' > after\n");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("code 4") && Contains("2 of 3 shards"));
  CHECK_THAT(run.err, Contains("tasks of the job array ended before their shards did") &&
                          Contains("shard 1: 1 of 2 runs are still to be done; FAILED") &&
                          Contains("shard 2: 1 of 2 runs are still to be done; CANCELLED") &&
                          !Contains("shard 3: ") &&
                          Contains("--cluster slurm --database all.sqlite --resume"));
  REQUIRE_FALSE(here.read("before").empty());
  CHECK_THAT(here.read("after"), Contains(here.read("before")));
  CHECK(here.table("all.sqlite") == here.alone("faulty.xml"));
}

TEST_CASE("A follower that is killed or leaves can be followed by another") {
  const Cluster here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 4);
  const auto run = here.with_slurm(
      Laboratory::kDawdlesOnRequest +
      "follow faulty.xml --cluster slurm --shards 2 --database all.sqlite & follower=$!\n"
      "until_begun all.sqlite 1\n"
      "kill -9 $follower; wait $follower || true\n"
      "follow faulty.xml --cluster slurm --resume --database all.sqlite & follower=$!\n"
      // It waits for Slurm and for signals on its own pipe.
      "until [ $(ls -l /proc/$follower/fd | grep -c ' [0-9]*[3-9] -> pipe:') -ge 2 ]; do sleep "
      "0.05; done\n"
      "sleep 0.3; kill -INT $follower\n"
      "wait $follower && code=$? || code=$?\n"
      "echo code $code\n"
      "batch faulty.xml --cluster slurm --resume --detach --database all.sqlite\n"
      "pass_all 1; pass_all 2\n"
      "batch faulty.xml --cluster slurm --resume --json --database all.sqlite > summary.json\n");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("code 4") && Contains("job array 1 is at work: ") &&
                          Contains("job array 1 continues; follow it with") &&
                          !Contains("array 2"));
  CHECK_THAT(run.err,
             Contains("interrupted; job array 1 continues") && Contains("scancel --name="));
  CHECK(nlohmann::json::parse(here.read("summary.json"))["done"] == 4);
  CHECK(here.table("all.sqlite") == here.alone("faulty.xml"));
}

TEST_CASE("Two followers of the same batch give the same result") {
  const Cluster here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  const auto run = here.with_slurm(
      "follow faulty.xml --cluster slurm --shards 2 --database all.sqlite & follower=$!\n"
      "until_begun all.sqlite 1\n"
      "batch faulty.xml --cluster slurm --resume --database all.sqlite --json > second.json\n"
      "wait $follower\n");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out, Contains("2 runs in ") || Contains("all 2 runs are done already"));
  CHECK(nlohmann::json::parse(here.read("second.json"))["done"] == 2);
}

TEST_CASE("A terminal shows a cluster's progress, also when only its tasks have yet to end") {
  const Cluster here;
  const auto run = here.with_slurm(
      "batch small_experiment.xml --cluster slurm --shards 1 --database all.sqlite --detach\n"
      "until grep -q '\"ended\":24' all.sqlite-shards/shard-1.json; do sleep 0.05; done\n"
      // All runs have ended, but Slurm reports twice that it is completing the task.
      "mkdir fake; real=$(command -v squeue)\n"
      "printf '#!/bin/sh\\nif [ ! -e once ]; then touch once; elif [ ! -e twice ]; then touch "
      "twice; else exec %s \"$@\"; fi\\necho \"1|CG|None\"\\n' \"$real\" > fake/squeue\n"
      "chmod +x fake/squeue\n"
      "PATH=$PWD/fake:$PATH script -qec \"stty cols 70; elsie batch small_experiment.xml --cluster "
      "slurm --resume --database all.sqlite --plugin-path '" +
      Laboratory::plugins() + "'\" /dev/null\n");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.out,
             Contains("100 %  0 of 0 runs, 1 task runs") && Contains("results: all.sqlite"));
  CHECK(here.table("all.sqlite") == here.alone("small_experiment.xml"));
}

TEST_CASE("A task that returns to the queue continues where it was") {
  const Cluster here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  const auto run = here.with_slurm(
      Laboratory::kDawdlesOnRequest +
      "follow faulty.xml --cluster slurm --shards 1 --database all.sqlite & follower=$!\n"
      "until_there 1\n"
      "pass_one 1; pass_one 1\n"
      "until grep -q '\"ended\":1' all.sqlite-shards/shard-1.json; do sleep 0.05; done\n"
      "scontrol requeue 1_1\n"
      "while [ -n \"$(tasks 1)\" ]; do sleep 0.05; done; pass_all 1\n"
      // Slurm delays such a task before it begins again; not here.
      "while :; do scontrol update jobid=1_1 starttime=now || true; sleep 1; done > updates 2>&1 & "
      "updates=$!\n"
      "wait $follower && code=$? || code=$?\n"
      "kill $updates; exit $code\n");
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(here.table("all.sqlite") == here.alone("faulty.xml"));
}

TEST_CASE("A job that a cluster refuses leaves nothing behind") {
  const Cluster here;
  const auto run = here.with_slurm(
      "refused() { batch small_experiment.xml --database all.sqlite \"$@\" && exit 1; [ $? = 2 ]; "
      "}\n"
      "refused --cluster slurm --sbatch=--partition=none\n"
      "refused --cluster slurm --shard 1/2\n"
      "refused --cluster pbs\n"
      "refused --cluster slurm --detach --json\n"
      "refused --cluster slurm --progress p.json\n"
      "refused --cluster slurm --resume --again\n"
      "refused --cluster slurm --shards 0\n"
      "refused --shards 3\n"
      "refused --sbatch=--time=1\n"
      "refused --detach\n"
      "SLURM_CONF=/dev/null refused --cluster slurm\n"
      "mkdir bin; ln -s \"$(command -v elsie)\" bin\n"
      "(PATH=bin; refused --cluster slurm)\n"
      "ls\n");
  CAPTURE(run.out);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains("Slurm does not take the job array: ") &&
                          Contains("invalid partition specified: none"));
  CHECK_THAT(run.err, Contains("--shard is one part of an experiment, and --cluster does all"));
  CHECK_THAT(run.err, Contains("--shards is for a cluster; it needs --cluster slurm"));
  CHECK_THAT(run.err, Contains("--sbatch is for a cluster; it needs --cluster slurm"));
  CHECK_THAT(run.err, Contains("--detach is for a cluster; it needs --cluster slurm"));
  CHECK_THAT(run.err, Contains("Slurm does not answer: ") && Contains("; nothing was submitted\n"));
  CHECK_THAT(run.err, Contains("there is no program 'squeue' here"));
  CHECK_THAT(run.out, !Contains("all.sqlite"));
}

TEST_CASE("A batch on a cluster is resumed with its own experiment only") {
  const Cluster here;
  here.write_faulty({"dawdling"}, Laboratory::kTwoDawdledSteps, 2);
  const auto run = here.with_slurm(
      "batch faulty.xml --cluster slurm --shards 2 --database all.sqlite --detach > said\n"
      "batch faulty.xml --cluster slurm --shards 2 --database all.sqlite && exit 1; [ $? = 2 ]\n"
      "batch faulty.xml --cluster slurm --shards 1 --resume --database all.sqlite && exit 1; [ $? "
      "= 2 ]\n"
      "batch small_experiment.xml --cluster slurm --resume --database all.sqlite && exit 1; [ $? = "
      "2 ]\n"
      "echo '{' > all.sqlite-shards/cluster.json\n"
      "batch faulty.xml --cluster slurm --resume --database all.sqlite && exit 1; [ $? = 2 ]\n");
  CAPTURE(run.out);
  CHECK(run.exit_code == 0);
  CHECK_THAT(run.err, Contains("of a batch that is not complete; continue it with --resume") &&
                          Contains("the batch was begun with 2 shards, not 1") &&
                          Contains("was begun with another experiment") &&
                          Contains("is missing or damaged; remove the folder to start again"));
}

TEST_CASE("Every command of the page on clusters runs") {
  const Cluster here;
  std::string commands;
  std::ifstream page(elsie::test::source_path("docs/clusters.md"));
  bool command = false;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("```", 0) == 0) {
      command = line == "```sh";
    } else if (command) {
      commands += line + "\n";
    }
  }
  const auto run = here.with_slurm(commands);
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 0);
  CHECK(run.err.empty());
  CHECK(here.table("top_speed.sqlite") == here.table("again.sqlite"));
  CHECK(here.query("all.sqlite", "SELECT count(*) FROM runs WHERE state = 'done'") == "12\n");
}
