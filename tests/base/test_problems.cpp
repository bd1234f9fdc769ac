// What is wrong with a file.
#include <string>

#include <catch2/catch.hpp>

#include "elsie/base/problems.h"

using namespace elsie;
using base::FileError;
using base::Problems;

TEST_CASE("Problems are reported together, by file and line") {
  Problems problems("world.xml");
  problems.raise<FileError>();  // there is none yet
  problems.add(7, "the last");
  problems.add({"template.xml", 3}, "in a template");
  problems.add(2, "the first");
  problems.add(0, "the file as a whole");
  problems.add({"template.xml", 3}, "in a template");  // met by another robot
  CHECK(problems.size() == 4);
  try {
    problems.raise<FileError>();
    FAIL("nothing was thrown");
  } catch (const FileError& error) {
    CHECK(std::string(error.what()) ==
          "world.xml: the file as a whole\n"
          "world.xml:2: the first\n"
          "world.xml:7: the last\n"
          "template.xml:3: in a template");
    CHECK(error.message() == error.what());
    CHECK(error.exit_code() == base::kBadInput);
  }
}

TEST_CASE("An error with a plugin's failure among its problems is the plugin's") {
  Problems problems;
  problems.add({"a.xml", 1}, "a mistake");
  problems.add({"a.xml", 2}, "its constructor throws", true);
  const FileError error(problems.sorted("a.xml"));
  CHECK(error.plugin_failed());
  CHECK(error.exit_code() == base::kPluginFailed);
}

TEST_CASE("Too many problems are counted, not listed, and the first lines are listed") {
  Problems problems("data", 2);
  for (int line = 5; line >= 1; --line) {
    problems.add(line, "no number");
  }
  const auto sorted = problems.sorted("data");
  REQUIRE(sorted.size() == 3);
  CHECK(sorted.front().text() == "data:1: no number");
  CHECK(sorted.back().text() == "data: and 3 more mistakes");
}

TEST_CASE("An error says who is speaking and how the program ends") {
  CHECK(base::BadInput("no such world").message() == "elsie: no such world");
  CHECK(base::BadInput("no such world").exit_code() == base::kBadInput);
  CHECK(base::Error("the disk is full").exit_code() == base::kOtherFailure);
}
