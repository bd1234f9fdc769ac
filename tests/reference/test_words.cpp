// The words for the vocabulary that the window's translations know.
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/world/vocabulary.h"

#include "places.h"

using namespace elsie;

namespace {

void collect(const world::ElementSpec& element, std::set<std::string>& names) {
  if (!element.plugins && !names.insert(element.name).second && element.nested) return;
  for (const auto& attribute : element.attributes) names.insert(attribute.name);
  for (const auto& child : element.children) collect(child, names);
}

}  // namespace

TEST_CASE("The window's translations know every element and attribute of world files") {
  std::set<std::string> names;
  collect(world::vocabulary(), names);
  collect(world::coordination_vocabulary(), names);
  REQUIRE(names.size() > 100);
  const std::string file = test::source_path("apps/desktop/world/words.cpp");
  std::ifstream stream(file);
  const std::string words{std::istreambuf_iterator<char>(stream), {}};
  for (const std::string& name : names) {
    if (name.size() == 1) continue;  // x is x in every language
    INFO("add it to " << file << ", and run scripts/translations");
    CAPTURE(name);
    CHECK(words.find("\"Vocabulary\", \"" + name + "\"") != std::string::npos);
  }
}
