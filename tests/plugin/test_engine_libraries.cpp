// The libraries of physics engines: found by name, and refused with a sentence.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/error.h"

#include "support.h"

using namespace elsie::plugin;
using namespace elsie::plugin::test;
using Catch::Contains;

namespace {

constexpr const char* kEntry = "elsie_make_engine";

/// The sentence with which an engine is refused, which is no fault of the user's input.
std::string engine_refusal(const std::string& name) {
  try {
    engine_symbol(name, kEntry);
  } catch (const PluginError& error) {
    CHECK(error.exit_code() == elsie::base::kOtherFailure);
    return error.what();
  }
  return "it was loaded";
}

/// One of the libraries that are broken on purpose, as the name of an engine.
std::string broken(const std::string& name) {
  const std::string file = fixture(name).string();
  return file.substr(0, file.size() - std::string(".so").size());
}

}  // namespace

TEST_CASE("The engine that worlds have by default is there, and loaded once") {
  const auto names = engine_names();
  CHECK(std::find(names.begin(), names.end(), "ode") != names.end());
  CHECK(std::is_sorted(names.begin(), names.end()));
  CHECK(engine_symbol("ode", kEntry) != nullptr);
  CHECK(engine_symbol("ode", kEntry) == engine_symbol("ode", kEntry));
}

TEST_CASE("An engine that is missing, damaged, foreign or none is refused in a sentence") {
  CHECK_THAT(engine_refusal("mercury"),
             Contains("'mercury'") && Contains("mercury.so") &&
                 Contains("reinstall Elsie, or delete the file and build it again"));
  CHECK_THAT(engine_refusal(broken("new_api")), Contains("api"));
  CHECK_THAT(engine_refusal(broken("unresolved")), Contains("cannot be loaded"));
  CHECK_THAT(engine_refusal(broken("good")), Contains("does not export 'elsie_make_engine'"));
}
