#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <stdlib.h>

#include "elsie/plugin/search_path.h"

#include "places.h"
#include "support.h"
#include "variable.h"

using namespace elsie::plugin;
using namespace elsie::plugin::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> origins(const std::vector<SearchDirectory>& directories) {
  std::vector<std::string> result;
  for (const SearchDirectory& directory : directories) {
    result.push_back(directory.origin);
  }
  return result;
}

}  // namespace

TEST_CASE("Given directories come first, then the environment's, then the program's own") {
  const Variable variable(kPluginPathVariable, "/env/one:/env/two");
  const std::vector<fs::path> given{"/given/one", "/given/two"};
  const auto path = default_search_path(given);
  REQUIRE(path.size() >= 5);
  CHECK(path[0].path == "/given/one");
  CHECK(path[1].path == "/given/two");
  CHECK(path[2].path == "/env/one");
  CHECK(path[3].path == "/env/two");
  CHECK(path[0].origin == "given");
  CHECK(path[2].origin == "ELSIE_PLUGIN_PATH");
  CHECK(path[4].path == fs::path(elsie::test::plugin_directory()));
  CHECK(path[4].origin == "next to the program");
}

TEST_CASE("The program's and the library's directory are one entry when they are the same") {
  const Variable variable(kPluginPathVariable, "");
  CHECK(origins(default_search_path()) == std::vector<std::string>{"next to the program"});
}

TEST_CASE("Empty and repeated entries of the variable are passed over") {
  const Variable variable(kPluginPathVariable, "::/env/one::/env/./one/:/env/two:");
  const std::vector<fs::path> given{"/env/two"};
  const auto path = default_search_path(given);
  REQUIRE(path.size() == 3);
  CHECK(path[0].path == "/env/two");
  CHECK(path[0].origin == "given");
  CHECK(path[1].path == "/env/one");
}

TEST_CASE("Plugins are found through the environment variable") {
  Folder folder;
  folder.with("good");
  const Variable variable(kPluginPathVariable, folder.path());
  const Host host(default_search_path());
  CHECK(host.find(elsie::PluginKind::behavior, "good"));
  CHECK(host.file_of(elsie::PluginKind::behavior, "good") == folder / "good.so");
}
