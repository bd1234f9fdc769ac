// What pages name is there: files, links, versions.
#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>

#include "elsie/api/abi.h"

#include "pages.h"
#include "program.h"

using namespace elsie::test;

namespace {

/// A page without its fenced code, which has brackets, too.
std::string without_code(const std::string& page) {
  std::istringstream lines(page);
  std::string text;
  bool is_code = false;
  for (std::string line; std::getline(lines, line);) {
    is_code ^= line.starts_with("```");
    text += is_code ? "" : line + '\n';
  }
  return text;
}

/// What links to the headings of a page end in: `## In a viewer` gives "in-a-viewer".
std::set<std::string> headings(const std::string& page) {
  std::set<std::string> found;
  std::istringstream lines(without_code(page));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t text = line.find_first_not_of('#');
    if (text == 0 || text == line.npos || line[text] != ' ') {
      continue;
    }
    std::string anchor;
    for (const char c : line.substr(text + 1)) {
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      } else if (c == ' ') {
        anchor += '-';
      }
    }
    found.insert(anchor);
  }
  return found;
}

}  // namespace

TEST_CASE("Every file of ours that a help text names exists") {
  const Workplace here;
  std::string help = here.elsie("--help").out;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  int subcommands = 0;
  while (std::getline(lines, line) && line.starts_with("  ")) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    if (!name.empty()) {
      const auto run = here.elsie(name + " --help");
      CAPTURE(name);
      CHECK(run.exit_code == 0);
      help += run.out;
      ++subcommands;
    }
  }
  CHECK(subcommands >= 18);
  const std::regex file(
      "\\b(experiments|worlds|robots|fuzzy_models|training_sets|examples)/[^ '\":,;)]+");
  int count = 0;
  for (std::sregex_iterator at(help.begin(), help.end(), file), end; at != end; ++at) {
    ++count;
    CAPTURE(at->str());
    CHECK(here.sh("ls -d " + at->str()).exit_code == 0);
  }
  CHECK(count >= 20);
}

TEST_CASE("The page on the ABI word shows it as it is") {
  CHECK_THAT(read(elsie::test::source_path("docs/internals/abi-word.md")),
             Catch::Contains("    " ELSIE_ABI_API ELSIE_ABI_RUNTIME ELSIE_ABI_CONTAINERS));
}

TEST_CASE("Links between the docs lead to files, and to headings of pages") {
  for (const fs::path& page : pages()) {
    const std::string text = without_code(read(page));
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
      const std::string link = text.substr(at + 2, text.find(')', at) - at - 2);
      if (link.find("://") != std::string::npos) {
        continue;
      }
      CAPTURE(page.string(), link);
      const std::size_t mark = std::min(link.find('#'), link.size());
      const fs::path file = mark == 0 ? page : page.parent_path() / link.substr(0, mark);
      CHECK(fs::exists(file));
      if (mark < link.size() && file.extension() == ".md") {
        CHECK(headings(read(file)).contains(link.substr(mark + 1)));
      }
    }
  }
}

TEST_CASE("Every page is listed in the navigation of the site") {
  const fs::path source(elsie::test::source_path(""));
  const std::string site = read(source / "mkdocs.yml");
  for (const fs::path& page : pages()) {
    const std::string name = page.lexically_relative(source).string();
    CAPTURE(name);
    CHECK(site.find(" " + name + "\n") != site.npos);
  }
}

TEST_CASE("Every file that the recipes for contributors name exists") {
  const fs::path source(elsie::test::source_path(""));
  const std::string page = read(source / "CONTRIBUTING.md");
  const std::regex file(
      "`((apps|core|docs|examples|experiments|fuzzy_models|libraries|plugins|scripts|tests|"
      "training_sets|worlds)/[^` ]*)`");
  int count = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), file), end; at != end; ++at) {
    const std::string name = (*at)[1];
    if (name.find("NAME") == name.npos) {  // otherwise the reader creates it
      ++count;
      CAPTURE(name);
      CHECK(fs::exists(source / name));
    }
  }
  CHECK(count >= 50);
}

TEST_CASE("The citation has the program's version") {
  const std::string version = Workplace().elsie("--version").out;
  REQUIRE_THAT(version, Catch::StartsWith("elsie "));
  CHECK_THAT(read(elsie::test::source_path("CITATION.cff")),
             Catch::Contains("\nversion: " + version.substr(6)));
}
