// elsie new: a folder with a new plugin. The package test builds and tests what it makes.
#include <filesystem>

#include <catch2/catch.hpp>

#include "program.h"

using Catch::Contains;
using elsie::test::Workplace;

TEST_CASE("What elsie new makes runs as it is, without a build system") {
  Workplace here;
  for (const std::string kind : {"behavior", "coordinator", "sensor", "measure", "rule", "drive",
                                 "localisation", "actuator"}) {
    CAPTURE(kind);
    const std::string name = "my_first_" + kind;
    const auto made = here.elsie("new " + kind + " " + name);
    CHECK(made.exit_code == 0);
    for (const std::string& file :
         {name + ".cpp", "test_" + name + ".cpp", std::string("CMakeLists.txt"),
          std::string("world.xml"), std::string("README.md")}) {
      CAPTURE(file);
      CHECK_THAT(made.out, Contains(file));
      const std::string text = here.read(name + "/" + file);
      CHECK_FALSE(text.empty());
      CHECK_THAT(text, !Contains("@name@") && !Contains("@Class@") && !Contains("@kind@"));
    }
    CHECK_THAT(here.read(name + "/" + name + ".cpp"), Contains("class MyFirst"));
    const auto run =
        here.sh("cd " + name + " && ELSIE_CACHE=../cache elsie run world.xml --plugin " + name +
                ".cpp --quiet");
    CAPTURE(run.err);
    CHECK(run.exit_code == 0);
    CHECK(run.err.empty());  // no compiler warnings
  }
}

TEST_CASE("A template may have folders, and nobody's folder is taken for scratch") {
  Workplace here;
  std::filesystem::create_directories(here.file("mine/templates/behavior/models/@name@"));
  std::filesystem::create_directories(here.file("shy.new"));
  here.write("shy.new/notes", "mine");
  here.write("mine/templates/behavior/@name@.cpp", "// @Class@\n");
  here.write("mine/templates/behavior/models/@name@/@kind@.fcl", "(* @name@ *)\n");
  const auto made = here.sh("ELSIE_DATA_PATH=mine elsie new behavior shy");
  CAPTURE(made.err);
  CHECK(made.exit_code == 0);
  CHECK(here.read("shy/shy.cpp") == "// Shy\n");
  CHECK(here.read("shy/models/shy/behavior.fcl") == "(* shy *)\n");
  CHECK(here.read("shy.new/notes") == "mine");
}

TEST_CASE("elsie new leaves existing files alone, and makes all or nothing") {
  Workplace here;
  const auto refused = [&](const std::string& arguments) {
    const auto run = here.elsie("new " + arguments);
    CAPTURE(arguments);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    return run.err.substr(0, run.err.find('\n'));
  };
  here.write("notes", "mine");
  CHECK(refused("behavior notes") ==
        "elsie: 'notes' exists already; choose another name, or --folder");
  CHECK(here.read("notes") == "mine");
  CHECK(refused("robot r1") ==
        "elsie: 'robot' is not a plugin kind; there are behavior, coordinator, sensor, measure, "
        "rule, drive, localisation and actuator");
  CHECK_THAT(refused("behavior Wall"), Contains("'Wall' is not a name for a plugin"));
  CHECK_THAT(refused("behavior 2nd"), Contains("'2nd' is not a name for a plugin"));
  CHECK_THAT(refused("behavior a-b"), Contains("'a-b' is not a name for a plugin"));
  CHECK_THAT(refused("behavior ''"), Contains("is not a name for a plugin"));
  CHECK(refused("sensor test") ==
        "elsie: 'test' is a word of the build system; choose another name");
  for (const std::string word : {"class", "register", "main", "std", "xor_eq", "active"}) {
    CHECK_THAT(refused("behavior " + word),
               Contains("'" + word + "' is a word of C++ or one that the generated files use"));
  }
  CHECK_THAT(refused("behavior wander"), Contains("there is a behavior 'wander' already"));
  CHECK(refused("drive differential") ==
        "elsie: there is a drive 'differential' already (built in); choose another name");
  CHECK(refused("measure success") ==
        "elsie: every run has a value 'success' already; choose another name for the measure");
  CHECK_THAT(refused("sensor sonar --folder notes/sonar"), Contains("cannot be made"));
  CHECK(refused("sensor") == "elsie: NAME is missing");
  for (const auto& entry : std::filesystem::directory_iterator(here.file(""))) {
    CHECK_FALSE(entry.path().extension() == ".new");
  }
  CHECK(here.elsie("new behaviour light --folder deep/er/light").exit_code == 0);
  CHECK_FALSE(here.read("deep/er/light/light.cpp").empty());
}
