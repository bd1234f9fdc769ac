// A build that has only a part of the program, like that of `make demo`.
#include <regex>
#include <set>

#include <catch2/catch.hpp>

#include "places.h"
#include "program.h"

using elsie::test::build_path;
using elsie::test::Workplace;

namespace {

std::set<std::string> subcommands(const std::string& help) {
  std::set<std::string> names;
  const std::regex line("\n  ([a-z-]+) {2,}[A-Z]");
  const std::string list = help.substr(help.find("Subcommands:"));
  for (std::sregex_iterator found(list.begin(), list.end(), line), end; found != end; ++found) {
    names.insert(found->str(1));
  }
  return names;
}

/// Copies the program with these libraries of subcommands to the folder `part`.
void copy_part(const Workplace& here, const std::string& libraries) {
  REQUIRE(
      here.sh("mkdir -p part/bin part/lib/elsie && cp \"$(command -v elsie)\" part/bin && cd '" +
              build_path("lib/elsie") + "' && cp elsie-program " + libraries + " '" +
              here.file("part/lib/elsie").string() + "'")
          .exit_code == 0);
}

const std::string kPart = "LD_LIBRARY_PATH='" + build_path("lib") + "' part/bin/elsie ";

}  // namespace

TEST_CASE("A subcommand that was not built is named, with what builds it") {
  const Workplace here;
  copy_part(here, "elsie-commands.so");
  const auto all = subcommands(here.elsie("--help").out);
  const auto help = here.sh(kPart + "--help");
  CHECK(help.exit_code == 0);
  const auto some = subcommands(help.out);
  CHECK(some.contains("run"));
  CHECK(some.contains("explain"));
  CHECK_THAT(help.out, Catch::Contains("Not built: batch, ") &&
                           Catch::Contains("test-plugin; `make program` builds them."));
  std::set<std::string> missing{"session"};  // which no help lists
  for (const std::string& name : all) {
    if (!some.contains(name)) missing.insert(name);
  }
  CHECK(missing.contains("batch"));
  CHECK(missing.contains("test-plugin"));
  for (const std::string& name : missing) {
    CAPTURE(name);
    const auto run = here.sh(kPart + name + " --help");
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_THAT(run.err, Catch::StartsWith("elsie: `elsie " + name + "` is not built: '") &&
                            Catch::EndsWith("run `make program`, or install Elsie again\n"));
  }
}

TEST_CASE("The completion and the manual page are of what was built") {
  const Workplace here;
  copy_part(here, "elsie-commands.so elsie-testing.so");
  const std::string manual = here.sh(kPart + "manual").out;
  CHECK_THAT(manual, Catch::Contains("Check a plugin by") &&
                         !Catch::Contains("Do all runs of an experiment"));
  const std::string completion = here.sh(kPart + "completion bash").out;
  CHECK_THAT(completion, Catch::Contains("test-plugin") && !Catch::Contains("batch"));
}

TEST_CASE("A mistyped subcommand that was not built is known") {
  const Workplace here;
  copy_part(here, "elsie-commands.so");
  const auto run = here.sh(kPart + "bacth");
  CHECK(run.exit_code == 2);
  CHECK_THAT(run.err,
             Catch::Contains("there is no subcommand 'bacth'; did you mean 'batch'?") &&
                 Catch::Contains("; not built: batch, replay, merge, report, test-plugin"));
}

TEST_CASE("A part of the program that is damaged harms no other") {
  const Workplace here;
  copy_part(here, "elsie-*.so");
  const std::string studies = "part/lib/elsie/elsie-studies.so";
  const auto refused = [&](const std::string& why) {
    const auto batch = here.sh(kPart + "batch --help");
    CHECK(batch.exit_code == 4);
    CHECK_THAT(batch.err, Catch::Contains("elsie-studies.so") && Catch::Contains(why));
    CHECK(here.sh(kPart + "test-plugin --help").err.empty());
    const auto help = here.sh(kPart + "--help");
    CHECK(help.exit_code == 0);
    CHECK_THAT(help.err, Catch::Contains(why));
    CHECK_THAT(help.out, Catch::Contains("test-plugin") && Catch::Contains("Not built: batch,"));
  };
  here.sh("head -c 20000 " + studies + " > short && cp short " + studies);
  refused("is a library that was cut short");
  here.sh("echo hello > " + studies);
  refused("is not a shared library");
  here.sh("cp part/lib/elsie/elsie-testing.so " + studies);
  refused("is another library, 'elsie-testing.so'");
}

TEST_CASE("A program that cannot be started is named") {
  const Workplace here;
  copy_part(here, "elsie-commands.so");
  here.sh(": > part/lib/elsie/elsie-program");
  const auto help = here.sh(kPart + "--help");
  CHECK(help.exit_code == 4);
  CHECK_THAT(help.err, Catch::Contains("part/lib/elsie/elsie-program' could not be started"));
}

TEST_CASE("A program without elsie-commands.so runs plain worlds, and says what is wrong") {
  const Workplace here;
  copy_part(here, "");
  here.write("world.xml", R"(<world format="1"><limits time="1"/></world>)");
  const auto plain = here.sh(kPart + "run world.xml --quiet");
  CHECK(plain.exit_code == 1);  // no goal is reached
  CHECK_THAT(plain.err, Catch::Equals(""));
  const auto run = here.sh(kPart + "picture world.xml");
  CHECK(run.exit_code == 4);
  CHECK_THAT(run.err, Catch::Contains("elsie-commands.so, cannot be read"));
}
