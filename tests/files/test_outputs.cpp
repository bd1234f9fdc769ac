// Files that are to be written are kept apart from those that are read.
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/base/error.h"
#include "elsie/files/outputs.h"
#include "elsie/files/scratch_folder.h"

#include "folder.h"

namespace fs = std::filesystem;
namespace files = elsie::files;
using elsie::base::BadInput;
using elsie::test::Folder;

TEST_CASE("An output that is an input is refused, by whatever name") {
  const Folder folder;
  const fs::path plan = folder.write("plan.png", "a floor plan");
  fs::create_symlink(plan, folder / "link.png");
  fs::create_hard_link(plan, folder / "hard.png");
  fs::create_directory(folder / "inner");
  const auto refused = [&](const fs::path& output) {
    CAPTURE(output);
    CHECK_THROWS_AS(files::require_apart({{"--picture", output}}, {folder / "world.xml", plan}),
                    BadInput);
  };
  CHECK_THROWS_WITH(files::require_apart({{"--picture", plan}}, {plan}),
                    "--picture: '" + plan.string() +
                        "' is read here, and its content would be lost; choose another name");
  CHECK_THROWS_WITH(
      files::require_apart({{"--picture", folder / "link.png"}}, {plan}),
      Catch::Contains("link.png' is the file '" + plan.string() + "', which is read here"));
  refused(folder / "hard.png");
  refused(folder / "inner/../plan.png");
  CHECK_NOTHROW(files::require_apart({{"--picture", folder / "new.png"}}, {plan}));
  CHECK(folder.read("plan.png") == "a floor plan");
}

TEST_CASE("Two outputs that are one file are refused, whether it exists or not") {
  const Folder folder;
  fs::create_symlink("new.csv", folder / "link.csv");
  CHECK_THROWS_WITH(
      files::require_apart({{"--record", folder / "a.csv"}, {"--record", folder / "./a.csv"}}, {}),
      Catch::Contains("is given twice"));
  CHECK_THROWS_WITH(
      files::require_apart({{"--csv", folder / "new.csv"}, {"--cells-csv", folder / "link.csv"}},
                           {}),
      Catch::Contains("--cells-csv: ") && Catch::Contains("is also the file of --csv"));
  CHECK_NOTHROW(
      files::require_apart({{"--csv", folder / "a.csv"}, {"--cells-csv", folder / "b.csv"}}, {}));
}

TEST_CASE("Devices and pipes have no content to lose") {
  const Folder folder;
  REQUIRE(mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  for (const fs::path& device : {fs::path("/dev/null"), folder / "pipe"}) {
    CHECK_NOTHROW(files::require_apart({{"--csv", device}, {"--record", device}}, {device}));
  }
}

TEST_CASE("A file of another kind is not overwritten") {
  const Folder folder;
  const auto is_table = [](std::string_view start) { return start.starts_with("time,"); };
  const auto require = [&](const std::string& file) {
    files::require_replaceable(file, "--record", "table", is_table);
  };
  CHECK_NOTHROW(require(folder.write("old.csv", "time,x\n")));
  CHECK_NOTHROW(require(folder.write("empty.csv", "")));
  CHECK_NOTHROW(require(folder.file("new.csv")));
  CHECK_THROWS_WITH(require(folder.write("walls.csv", "0 0 1 1\n")),
                    Catch::Contains("already exists and is not a table"));
  CHECK_THROWS_WITH(require(folder.file("no/new.csv")), Catch::Contains("there is no folder"));
  CHECK_THROWS_WITH(require(folder.path().string()), Catch::Contains("it is a directory"));
  fs::create_symlink("no/new.csv", folder / "lost.csv");
  CHECK_THROWS_WITH(require(folder.file("lost.csv")), Catch::Contains("there is no folder"));
  CHECK_THROWS_WITH(require(folder.file(std::string(300, 'a'))), Catch::Contains("is too long"));
}

TEST_CASE("Two scratch folders in one place do not collide, and leave nothing behind") {
  const Folder folder;
  {
    const files::ScratchFolder first(folder.path()), second(folder.path());
    CHECK(first.path() != second.path());
    fs::create_directories(first.path() / "a/b");
    CHECK(folder.files() == 2);
  }
  CHECK(folder.files() == 0);
}

TEST_CASE("A scratch folder becomes a folder with all that is in it, but replaces none") {
  const Folder folder;
  fs::create_directory(folder / "taken");
  files::ScratchFolder scratch(folder.path());
  fs::create_directory(scratch.path() / "inner");
  CHECK_THROWS_AS(scratch.become(folder / "taken"), fs::filesystem_error);
  scratch.become(folder / "made");
  CHECK(fs::exists(folder / "made/inner"));
}

TEST_CASE("A scratch folder is removed with its content when the process is interrupted") {
  const Folder folder;
  const pid_t child = fork();
  if (child == 0) {
    files::ScratchFolder scratch(folder.path());
    fs::create_directories(scratch.path() / "a/b/c");
    for (int i = 0; i < 300; ++i) {
      fs::create_directory(scratch.path() / ("of many " + std::to_string(i)));
    }
    fs::create_symlink(folder.path(), scratch.path() / "a/link");
    files::clean_up_in_emergency();
    _exit(0);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  CHECK(folder.files() == 0);
}
