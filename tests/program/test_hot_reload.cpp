// elsie run --watch: the test follows its page literally.
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "places.h"
#include "program.h"

using Catch::Contains;
using elsie::test::Workplace;

namespace {

/// The first block of docs/hot-reload.md in this language.
std::string page_text() {
  std::ifstream in(elsie::test::source_path("docs/hot-reload.md"));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string block(const std::string& fence, const std::string& begins) {
  const std::string page = page_text();
  const std::size_t from = page.find("```" + fence + "\n" + begins) + fence.size() + 4;
  return page.substr(from, page.find("```\n", from) - from);
}

/// The first line of the page with this text.
std::string line_with(const std::string& text) {
  const std::string page = page_text();
  const std::size_t at = page.find(text);
  REQUIRE(at != std::string::npos);
  const std::size_t from = page.rfind('\n', at) + 1;
  return page.substr(from, page.find('\n', at) - from);
}

/// Compilers use the quotation marks of the user's language.
std::string plain_quotes(std::string text) {
  for (const std::string quote : {"‘", "’"}) {
    for (std::size_t at = 0; (at = text.find(quote, at)) != std::string::npos; ++at) {
      text.replace(at, quote.size(), "'");
    }
  }
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  REQUIRE(text.find(what) != std::string::npos);
  return text.replace(text.find(what), what.size(), by);
}

/// Wheel rates in the order in which they first occur.
std::vector<double> rates(const std::string& table) {
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  std::vector<double> rates;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i < 14; ++i) {  // up to command_forward_m_s
      std::getline(cells, cell, ',');
    }
    const double rate = std::round(std::abs(std::stod(cell)) / 0.02 * 1e6) / 1e6;
    if (rates.empty() || rates.back() != rate) {
      rates.push_back(rate);
    }
  }
  return rates;
}

}  // namespace

TEST_CASE("A behaviour changes while it drives; one that does not compile changes nothing") {
  Workplace here;
  const std::string pace = block("cpp", "#include");
  here.write("pace.cpp", pace);
  here.write("world.xml", block("", "<world"));
  here.write("wrong.cpp", replaced(pace, "now.time_s();", "now.time_s()"));
  here.write("faster.cpp", replaced(pace, "speed = 5.0", "speed = 8.0"));
  here.write("refusing.cpp", replaced(pace, ".meaning = \"wheel rate\"",
                                      ".meaning = \"wheel rate\", .required = true"));
  // Waits for a text in the program's output, at most three minutes.
  const auto run = here.sh(
      "says() { i=0; until grep -q \"$1\" err; do i=$((i+1)); [ $i -lt 1800 ] || exit 9; "
      "sleep 0.1; done; }\n"
      "export ELSIE_CACHE=$PWD/cache\n"
      "elsie run world.xml --plugin pace.cpp --watch --speed 1 --duration 3000 "
      "--record pace.csv --record-rate 100 2> err & pid=$!\n"
      "i=0; until [ -s pace.csv ]; do i=$((i+1)); [ $i -lt 1800 ] || exit 9; sleep 0.1; done\n"
      "cp wrong.cpp pace.cpp; says 'the old version stays in use'; echo >> err\n"
      "cp refusing.cpp pace.cpp; says 'cannot be used'\n"
      "cp faster.cpp pace.cpp; says 'new: pace'\n"
      "sleep 2; kill $pid; wait $pid || exit $?");
  const std::string err = here.read("err");
  CAPTURE(run.err, err);
  CHECK(run.exit_code == 4);  // interrupted
  // As on the page, with any quotation marks of the compiler, and any position.
  const std::string shown = line_with("error: expected");
  if (err.find("clang") == std::string::npos) {
    CHECK_THAT(plain_quotes(err), Contains(shown.substr(shown.find("error: "))));
  }
  CHECK_THAT(shown, Contains("    pace.cpp:"));
  CHECK_THAT(err, Contains("pace.cpp:") && Contains("pace.cpp could not be compiled") &&
                      Contains(" s, pace.cpp: the old version stays in use\n"));
  CHECK_THAT(err, Contains("pace.cpp cannot be used: robot 'r1', behavior[pace]: it needs the "
                           "parameter 'speed' now, which the world does not give"));
  CHECK_THAT(err, Contains(" s, pace.cpp: new: pace of 'r1', with what it remembers\n"));
  CHECK(rates(here.read("pace.csv")) == std::vector<double>{0.0, 5.0, 8.0});
}

TEST_CASE("A plugin that joins its threads is replaced as any other; no copies are left") {
  Workplace here;
  const std::string pace =
      replaced(replaced(block("cpp", "#include"), "#include <elsie/api/behavior.h>",
                        "#include <thread>\n#include <elsie/api/behavior.h>"),
               " private:\n",
               " private:\n  std::jthread worker_{[](std::stop_token stop) {\n"
               "    while (!stop.stop_requested()) std::this_thread::yield();\n  }};\n");
  here.write("pace.cpp", pace);
  here.write("faster.cpp", replaced(pace, "speed = 5.0", "speed = 8.0"));
  here.write("world.xml", block("", "<world"));
  const auto run = here.sh(
      "export ELSIE_CACHE=$PWD/cache TMPDIR=$PWD/copies; mkdir copies\n"
      "elsie run world.xml --plugin pace.cpp --watch --speed 1 --duration 3000 "
      "--record pace.csv --record-rate 100 2> err & pid=$!\n"
      "i=0; until [ -s pace.csv ]; do i=$((i+1)); [ $i -lt 1800 ] || exit 9; sleep 0.1; done\n"
      "cp faster.cpp pace.cpp\n"
      "i=0; until grep -q 'new: pace' err; do i=$((i+1)); [ $i -lt 1800 ] || exit 9; sleep 0.1; "
      "done\n"
      "! grep -q 'elsie-copy.*/pace.*deleted' /proc/$pid/maps\n"
      "sleep 1; kill $pid; wait $pid || echo $?\nls copies");
  CAPTURE(run.err, here.read("err"));
  CHECK(run.out == "4\n");
  CHECK(rates(here.read("pace.csv")) == std::vector<double>{0.0, 5.0, 8.0});
}

TEST_CASE(
    "A library that never finishes loading stops neither the run, nor the watch, nor Ctrl-C") {
  Workplace here;
  const std::string pace = block("cpp", "#include");
  here.write("pace.cpp", pace);
  here.write("endless.cpp",
             "#include <fstream>\n" + pace +
                 "[[maybe_unused]] const bool kEndless = [] {\n"
                 "  std::ofstream(\"tried\") << 1;\n"
                 "  for (volatile bool goes_on = true; goes_on;) {\n  }\n  return true;\n}();\n");
  here.write("faster.cpp", replaced(pace, "speed = 5.0", "speed = 8.0"));
  here.write("world.xml", block("", "<world"));
  const auto run = here.sh(
      "waits() { i=0; until \"$@\"; do i=$((i+1)); [ $i -lt 1800 ] || exit 9; sleep 0.1; done; }\n"
      "export ELSIE_CACHE=$PWD/cache TMPDIR=$PWD/copies; mkdir copies\n"
      "elsie run world.xml --plugin pace.cpp --watch --speed 1 --duration 3000 "
      "--record pace.csv --record-rate 100 2> err & pid=$!\n"
      "waits [ -s pace.csv ]\n"
      "cp endless.cpp pace.cpp; waits [ -s tried ]\n"
      "cp faster.cpp pace.cpp; waits grep -q 'new: pace' err; rm tried\n"
      "cp endless.cpp pace.cpp; waits [ -s tried ]\n"
      "kill $pid; wait $pid || echo $?\nls copies");
  CAPTURE(run.err, here.read("err"));
  CHECK(run.out == "4\n");
  CHECK_THAT(here.read("err"), Contains("elsie: interrupted after "));
  // Its name and place, as at the start of a run.
  const auto alone = here.sh(
      "elsie load-plugin $(find cache -name '*.so' -newer faster.cpp | xargs grep -l tried | head "
      "-1) "
      "pace.cpp 0.5");
  CHECK(alone.exit_code == 3);
  CHECK_THAT(alone.err, Contains("elsie: plugin library 'pace.cpp' did not return within 0.5 s and "
                                 "was stopped, while it was loaded\n") &&
                            Contains("pace.cpp:"));
}

TEST_CASE("Without a change on disk, --watch and --speed change nothing of a run") {
  Workplace here;
  const auto hash = [&](const std::string& options) {
    const auto run = here.elsie("run worlds/clutter.xml --duration 2 --json " + options);
    CAPTURE(run.err);
    CHECK(run.exit_code == 1);
    CHECK(run.err.empty());
    return nlohmann::json::parse(run.out).at("state_hash").get<std::string>();
  };
  const std::string plain = hash("");
  CHECK(hash("--watch") == plain);
  CHECK(hash("--watch --speed 4") == plain);
}

TEST_CASE("--speed keeps to the clock") {
  Workplace here;
  const auto run = here.elsie("run worlds/open_arena.xml --duration 3 --speed 2 --json");
  CHECK(nlohmann::json::parse(run.out).at("wall_s").get<double>() >= 1.49);
}
