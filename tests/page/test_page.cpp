// The page of a run as a file: what is in it, how large it is, and what is refused.
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/files/base64.h"
#include "elsie/page/run_page.h"
#include "elsie/results/hash.h"

#include "made_run.h"

using namespace elsie;
using namespace elsie::test;
using page::run_page;

namespace {

std::string html_of(const std::filesystem::path& recording, page::PageOptions options = {}) {
  return run_page(recording, shipped(), options).html;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t number = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; ++at) ++number;
  return number;
}

/// What is between two texts that the page has once.
std::string between(const std::string& html, const std::string& before, const std::string& after) {
  const std::size_t from = html.find(before);
  REQUIRE(from != std::string::npos);
  const std::size_t start = from + before.size();
  return html.substr(start, html.find(after, start) - start);
}

std::string policy_hash(const std::string& text) {
  return files::policy_hash(results::sha256(text));
}

/// The numbers after "poses every".
double pose_period(const std::string& html) {
  return std::stod(between(html, "poses every ", " s"));
}

}  // namespace

TEST_CASE("A page has everything in it, and its policy allows nothing but its own script") {
  RecordedFile run(two_robots(), shipped());
  const std::string html = html_of(run.path);
  CHECK_THAT(html, Catch::StartsWith("<!doctype html>") && Catch::EndsWith("</html>\n"));
  const std::string policy = between(html, "Content-Security-Policy\" content=\"", "\"");
  CHECK(policy == "default-src 'none'; style-src " +
                      policy_hash(between(html, "<style>", "</style>")) + "; script-src " +
                      policy_hash(between(html, "</script>\n<script>", "</script>\n</body>")) +
                      "; img-src data:; base-uri 'none'; form-action 'none'");
  // Every address is within the page.
  std::size_t addresses = 0;
  for (const std::string name : {"src=\"", "href=\"", "action=\""}) {
    for (std::size_t at = 0; (at = html.find(name, at)) != std::string::npos; ++at, ++addresses) {
      CHECK_THAT(html.substr(at + name.size(), 40), Catch::StartsWith("data:"));
    }
  }
  CHECK(addresses == 1);  // the icon
  CHECK(count(html, "://") == 0);
  CHECK(count(html, " style=\"") == 0);  // the policy would refuse it
  CHECK(count(html, " onclick=") == 0);
}

TEST_CASE("A page says what it holds") {
  RecordedFile run(two_robots(), shipped(), {.seed = 7}, {.program = "elsie 0.0.0"});
  const std::string html = html_of(run.path);
  const auto says = [&](const std::string& name, const std::string& value) {
    CHECK_THAT(between(html, "<dt>" + name + "</dt><dd>", "</dd>"), Catch::Equals(value));
  };
  says("world", "open arena");
  says("seed", "7");
  says("recorded by", "elsie 0.0.0");
  says("state hash", simulation::hash_text(run.result.state_hash) + " after 2000 steps");
  says("sampling", "poses every 0.1 s, to 0.1 mm and 0.0001 rad");
  CHECK_THAT(between(html, "<h1>", "</h1>"), Catch::Equals("open arena"));
}

TEST_CASE("The same recording gives the same page") {
  RecordedFile run(two_robots(), shipped());
  CHECK(html_of(run.path) == html_of(run.path));
}

TEST_CASE("Nothing that a recording says becomes a part of the page's markup") {
  RecordedFile run(two_robots(), shipped());
  McapFile hostile;
  write_hostile(run.path, hostile.path);
  const std::string html = html_of(hostile.path);
  CHECK(count(html, "<script") == 2);
  CHECK(count(html, "</script>") == 2);
  CHECK(count(html, "<img") == 1);
  CHECK(count(html, "onerror=\"") == 0);
  CHECK_THAT(between(html, "<h1>", "</h1>"), Catch::StartsWith("&lt;/script&gt;"));
  CHECK(count(html, "<dt>&lt;/script&gt;") == 1);  // the measure
}

TEST_CASE("A run that is too long for a page is sampled more coarsely, and the page says so") {
  RecordedFile run(shipped_world("ten_robots.xml", 10), shipped());
  const std::string whole = html_of(run.path);
  const std::size_t limit = whole.size() - 8'000;
  CHECK(html_of(run.path, {.most_bytes = limit}).size() <= limit);
  CHECK(pose_period(whole) == Approx(0.1));
  // At least so many samples stay, whatever the limit.
  const auto least = run_page(run.path, shipped(), {.most_bytes = 1});
  CHECK(pose_period(least.html) == Approx(least.poses_every_s));
  CHECK(least.poses_every_s > 0.1);
  CHECK(least.poses_every_s <= 10.0 / page::kFewestSamples * 2.0);
}

TEST_CASE("Worlds with all kinds of things become pages") {
  for (const char* const name : {"shapes.xml", "train.xml", "lane.xml", "recharge.xml",
                                 "pushing.xml", "nested.xml", "fetch.xml", "khepera.xml"}) {
    CAPTURE(name);
    RecordedFile run(shipped_world(name, 3), shipped());
    CHECK(html_of(run.path).size() < 1'000'000);
  }
}

TEST_CASE("What is no recording of a run is refused in a sentence") {
  McapFile file;
  {
    mcap::Writer writer(file.path);
    writer.close();
  }
  CHECK_THROWS_WITH(html_of(file.path),
                    Catch::Contains("has no run of Elsie; expected a recording with robots that"));
  RecordedFile run(two_robots(), shipped());
  std::filesystem::resize_file(run.path, 200);
  CHECK_THROWS_WITH(html_of(run.path), Catch::Contains("breaks off before its first second"));
  CHECK_THROWS_AS(html_of(file.path.string() + ".not"), mcap::McapError);
}

TEST_CASE("A recording that breaks off is a page up to there") {
  RecordedFile run(two_robots(), shipped());
  std::filesystem::resize_file(run.path, std::filesystem::file_size(run.path) / 2);
  const std::string html = html_of(run.path);
  CHECK_THAT(html, Catch::Contains("no outcome: the recording ends after"));
  CHECK_THAT(html, Catch::Contains("<dt>note</dt>"));
}
