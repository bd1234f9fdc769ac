// Where data lies, and how a world there is opened by its short name.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <catch2/catch.hpp>

#include "elsie/world/data_directories.h"

#include "fixture.h"

using namespace elsie;
using namespace elsie::test;
namespace fs = std::filesystem;

namespace {

/// ELSIE_DATA_PATH for as long as it lives.
class DataPath {
 public:
  explicit DataPath(const std::string& value) {
    if (const char* const now = std::getenv(world::kDataPathVariable)) {
      before_ = now;
    }
    setenv(world::kDataPathVariable, value.c_str(), 1);
  }
  ~DataPath() {
    if (before_) {
      setenv(world::kDataPathVariable, before_->c_str(), 1);
    } else {
      unsetenv(world::kDataPathVariable);
    }
  }
  DataPath(const DataPath&) = delete;
  DataPath& operator=(const DataPath&) = delete;

 private:
  std::optional<std::string> before_;
};

std::string message_of(const std::string& name, const std::vector<std::string>& directories) {
  try {
    world::find_document(name, directories);
    return "";
  } catch (const world::WorldError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("Data directories: those of the environment, then what belongs to program and library") {
  const DataPath variable("/first::/second:/first/");
  const auto found = world::default_data_directories();
  REQUIRE(found.size() >= 3);
  CHECK(found[0] == "/first");
  CHECK(found[1] == "/second");
  const fs::path program = fs::read_symlink("/proc/self/exe");
  CHECK(found[2] == (program.parent_path().parent_path() / "share/elsie").string());
  // libelsie's, whether it is the same folder or another: the shipped worlds are there.
  CHECK(std::any_of(found.begin() + 2, found.end(), [](const std::string& directory) {
    return fs::exists(fs::path(directory) / "worlds/maze.xml");
  }));
}

TEST_CASE("A world is found by its name in the data directories, unless one is there already") {
  const std::vector<std::string> data{kFolder + "wrong", kFolder + "data"};
  CHECK(world::find_document("everything.xml", data) == kFolder + "data/everything.xml");
  CHECK(world::find_document("data/../data/everything.xml", {kFolder}) ==
        kFolder + "data/everything.xml");
  const std::string absolute = kFolder + "data/everything.xml";
  CHECK(world::find_document(absolute, data) == absolute);
  CHECK(world::find_document("", data).empty());
  CHECK(world::find_document("everything.xml", {}) ==
        "everything.xml");  // its reader says what is wrong
  // One that is there comes first.
  const fs::path before = fs::current_path();
  fs::current_path(kFolder + "data");
  CHECK(world::find_document("everything.xml", {kFolder + "wrong"}) == "everything.xml");
  fs::current_path(before);
}

TEST_CASE("A world that is nowhere is reported with the places and the nearest name") {
  CHECK(message_of("everythin.xml", {kFolder + "data"}) ==
        "everythin.xml: there is no such file; looked in the current folder or in the data "
        "directory " +
            kFolder + "data; did you mean 'everything.xml'?");
  CHECK(message_of("nowhere/at_all.xml", {kFolder + "data"}) ==
        "nowhere/at_all.xml: there is no such file; looked in the current folder or in the data "
        "directory " +
            kFolder + "data");
}

TEST_CASE("read_world() opens a world by its short name, and files beside it are found") {
  world::ReadOptions reading = options();
  const world::World world = world::read_world("everything.xml", host(), reading);
  CHECK(world.file == kFolder + "data/everything.xml");
}
