#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <stdlib.h>

#include "elsie/plugin/search_path.h"

#include "places.h"
#include "support.h"

using namespace elsie::plugin;
using namespace elsie::plugin::test;
namespace fs = std::filesystem;

namespace {

/// Sets the environment variable, and puts it back afterwards.
class Variable {
 public:
  explicit Variable(const std::string& value) {
    if (const char* const before = getenv(kPluginPathVariable)) {
      before_ = before;
    }
    setenv(kPluginPathVariable, value.c_str(), 1);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() {
    if (before_) {
      setenv(kPluginPathVariable, before_->c_str(), 1);
    } else {
      unsetenv(kPluginPathVariable);
    }
  }

 private:
  std::optional<std::string> before_;
};

std::vector<std::string> origins(const std::vector<SearchDirectory>& directories) {
  std::vector<std::string> result;
  for (const SearchDirectory& directory : directories) {
    result.push_back(directory.origin);
  }
  return result;
}

}  // namespace

TEST_CASE("Given directories come first, then the environment's, then the program's own") {
  const Variable variable("/env/one:/env/two");
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
  const Variable variable("");
  CHECK(origins(default_search_path()) == std::vector<std::string>{"next to the program"});
}

TEST_CASE("Empty and repeated entries of the variable are passed over") {
  const Variable variable("::/env/one::/env/./one/:/env/two:");
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
  const Variable variable(folder.path());
  const Host host(default_search_path());
  CHECK(host.find(elsie::PluginKind::behavior, "good"));
  CHECK(host.file_of(elsie::PluginKind::behavior, "good") == folder / "good.so");
}
