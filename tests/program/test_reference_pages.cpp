// The plugins' pages in docs/ agree with the declarations.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "pages.h"
#include "program.h"

using namespace elsie::test;
using nlohmann::json;

namespace {

const fs::path kDocs = source_path("docs");
const std::vector<std::string> kKinds{"sensor", "behavior", "coordinator",  "measure",
                                      "rule",   "drive",    "localisation", "actuator"};

/// The text between the lines <!-- mark --> and <!-- end of mark -->, without blank lines around
/// it; fails unless each occurs once.
std::string block(const std::string& page, const std::string& mark) {
  const std::string first = "\n<!-- " + mark + " -->\n\n",
                    last = "\n\n<!-- end of " + mark + " -->\n";
  const std::size_t begin = page.find(first), end = page.find(last);
  REQUIRE(begin != std::string::npos);
  REQUIRE(end != std::string::npos);
  CHECK(page.find(first, begin + 1) == std::string::npos);
  CHECK(page.find(last, end + 1) == std::string::npos);
  const std::size_t start = begin + first.size();
  REQUIRE(start <= end);
  return page.substr(start, end + 1 - start);
}

/// The shipped plugins of a kind, with their descriptions.
std::map<std::string, std::string> plugins(const Workplace& here, const std::string& kind) {
  std::map<std::string, std::string> found;
  const json all = json::parse(here.elsie("plugins --json").out);
  for (const json& plugin : all.at("plugins")) {
    if (plugin.at("kind") == kind) {
      found.emplace(plugin.at("name"), plugin.at("description"));
    }
  }
  return found;
}

std::vector<std::string> pages(const std::string& kind) {
  std::vector<std::string> names;
  const fs::path folder = kDocs / (kind + "s");
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      names.push_back(entry.path().stem().string());
    }
  }
  return names;
}

}  // namespace

TEST_CASE("Every page of a plugin says what the declaration says today (else: make reference)") {
  const Workplace here;
  for (const std::string& kind : kKinds) {
    for (const std::string& name : pages(kind)) {
      CAPTURE(kind, name);
      const std::string page = read(kDocs / (kind + "s") / (name + ".md"));
      CHECK_THAT(page, Catch::StartsWith("# " + name + "\n\n"));
      const auto run = here.elsie("describe " + kind + " " + name + " --declaration");
      REQUIRE(run.exit_code == 0);
      CHECK(block(page, "declaration") == run.out);
    }
  }
}

TEST_CASE("Every shipped plugin has a page, and every page a plugin") {
  const Workplace here;
  for (const std::string& kind : kKinds) {
    CAPTURE(kind);
    std::set<std::string> shipped;
    for (const auto& [name, description] : plugins(here, kind)) {
      shipped.insert(name);
    }
    const std::vector<std::string> names = pages(kind);
    CHECK_FALSE(shipped.empty());
    CHECK(std::set<std::string>(names.begin(), names.end()) == shipped);
  }
}

TEST_CASE("A plugin's page has more to say than its declaration, and names its sources") {
  for (const std::string& kind : kKinds) {
    for (const std::string& name : pages(kind)) {
      CAPTURE(kind, name);
      const std::string page = read(kDocs / (kind + "s") / (name + ".md"));
      const std::size_t end = page.find("<!-- end of declaration -->");
      REQUIRE(end != std::string::npos);
      const std::size_t sources = page.find("\n## Sources\n", end);
      REQUIRE(sources != std::string::npos);
      CHECK(sources - end > 300);
      // An author and a year: "- R. A. Brooks (1986): ...". Measures that only count need none, and
      // say so.
      const std::string cited = "\\n- [^\\n]*\\([12][0-9]{3}\\)";
      const std::string needed = kind == "measure" ? "(" + cited + "|\\nNone: )" : cited;
      CHECK_THAT(page.substr(sources), Catch::Matches("[\\s\\S]*" + needed + "[\\s\\S]*"));
    }
  }
}

TEST_CASE("The page of events lists what may be raised today (else: make reference)") {
  const Workplace here;
  CHECK(block(read(kDocs / "events.md"), "events") == here.elsie("describe events").out);
  const json all = json::parse(here.elsie("describe events --json").out);
  CHECK(all.at("simulator").at(0).at("name") == "collision");
  CHECK(all.at("simulator").at(0).at("perceived") == true);
  const json& of_plugins = all.at("plugins");
  CHECK(std::any_of(of_plugins.begin(), of_plugins.end(), [](const json& event) {
    return event.at("plugin") == "escape" && event.at("name") == "stuck";
  }));
}

TEST_CASE("The index lists every shipped plugin (else: make reference)") {
  const Workplace here;
  const std::string index = block(read(kDocs / "plugins.md"), "plugins");
  std::size_t count = 0;
  for (const std::string& kind : kKinds) {
    for (const auto& [name, description] : plugins(here, kind)) {
      CAPTURE(kind, name);
      ++count;
      const std::string page = kind + "s/" + name + ".md";
      CHECK(fs::exists(kDocs / page));
      CHECK_THAT(index,
                 Catch::Contains("| [" + name + "](" + page + ") | " + description + " |\n"));
    }
  }
  // Four lines above the plugins of each kind, and an empty one between kinds.
  CHECK(static_cast<std::size_t>(std::count(index.begin(), index.end(), '\n')) ==
        count + 5 * kKinds.size() - 1);
}
