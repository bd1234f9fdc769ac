// The page in a browser: headless Chromium opens it from its file, at the width of a desktop and of
// a phone, in light and dark mode.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "edge_cases.h"
#include "hostile.h"

namespace fs = std::filesystem;
using namespace elsie::test;
using nlohmann::json;

namespace {

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// A folder with a page, and a browser to view it.
class Browser {
 public:
  explicit Browser(const std::string& html)
      : folder_(elsie::test::build_path("tests/report/browser")) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "page.html", std::ios::binary) << html;
  }

  // The findings of check.js. It is inserted at the beginning of a copy of the page, where the
  // page's policy lets it run with the page's own script.
  json look(int width, const std::string& flags = "") {
    std::string html = content(folder_ / "page.html");
    const std::string policy = "script-src ";
    REQUIRE(html.find(policy) != std::string::npos);
    html.insert(html.find(policy) + policy.size(), "'nonce-check' ");
    const std::size_t head = html.find("<title>");
    REQUIRE(head != std::string::npos);
    std::ofstream(folder_ / "checked.html", std::ios::binary)
        << html.substr(0, head)
        << "<script nonce=\"check\">window.pageErrors = []; addEventListener('error', (e) => "
           "pageErrors.push(e.message)); addEventListener('securitypolicyviolation', (e) => "
           "pageErrors.push(e.violatedDirective));\n"
        << content(source_path("tests/report/browser/check.js")) << "</script>"
        << html.substr(head);
    const std::string dom = run("checked.html", width, 900,
                                "--dump-dom --log-net-log=net.json --net-log-capture-mode="
                                "Everything " +
                                    flags);
    const std::string mark = "<pre id=\"found\">";
    const std::size_t from = dom.find(mark);
    INFO(log());
    REQUIRE(from != std::string::npos);
    std::string text =
        dom.substr(from + mark.size(), dom.find("</pre>", from) - from - mark.size());
    for (const auto& [entity, character] :
         {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
      for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at) {
        text.replace(at, std::string(entity).size(), character);
      }
    }
    return json::parse(text);
  }

  // A screenshot, kept in the build folder for readers.
  fs::path shoot(const std::string& name, int width, int height, const std::string& flags = "") {
    run("page.html", width, height, "--screenshot=" + name + " " + flags);
    return folder_ / name;
  }

  // All addresses that the page has requested, except files. The browser's own requests, for
  // updates, were not started by a page.
  std::vector<std::string> network() const {
    std::vector<std::string> asked;
    std::set<std::string> own;
    const auto host = [](const std::string& address) {
      const std::size_t from = address.find("://");
      const std::size_t start = from == std::string::npos ? 0 : from + 3;
      return address.substr(start, address.find_first_of(":/?", start) - start);
    };
    const json log = json::parse(content(folder_ / "net.json"));
    const auto each = [&](const auto& visit) {
      for (const json& event : log.at("events")) {
        const auto params = event.find("params");
        if (params != event.end() && params->is_object()) visit(*params);
      }
    };
    each([&](const json& params) {
      if (!params.contains("initiator") || !params.contains("url")) return;
      const auto address = params["url"].get<std::string>();
      if (address.starts_with("file:") || address.starts_with("data:")) return;
      if (params["initiator"] == "not an origin") {
        own.insert(host(address));
      } else {
        asked.push_back(address);
      }
    });
    // Connections and names that were looked up in advance.
    each([&](const json& params) {
      for (const char* name : {"url", "host", "hostname"}) {
        const auto address = params.find(name);
        if (address == params.end() || !address->is_string()) continue;
        const auto text = address->get<std::string>();
        if (text.starts_with("file:") || text.starts_with("data:")) continue;
        if (!own.contains(host(text))) asked.push_back(text);
      }
    });
    return asked;
  }
  // What it wrote to its console, and its own errors.
  std::string log() const { return content(folder_ / "log.txt"); }

 private:
  // The page is in a frame, because a window of the browser is never narrower than 500 pixels.
  std::string run(const std::string& page, int width, int height, const std::string& flags) {
    std::ofstream(folder_ / "frame.html")
        << "<!doctype html><meta name=\"color-scheme\" content=\"light dark\"><body "
           "style=\"margin:0\"><iframe src=\"" +
               page + "\" style=\"border:0;display:block;width:" + std::to_string(width) +
               "px;height:" + std::to_string(height) +
               "px\"></iframe><pre id=\"found\"></pre><script>addEventListener('message', (e) => "
               "document.getElementById('found').textContent = e.data)</script></body>";
    const std::string command =
        "cd '" + folder_.string() +
        "' && rm -rf profile && timeout 120 chromium --headless --no-sandbox --disable-gpu "
        "--disable-quic --no-first-run --disable-background-networking --disable-component-update "
        "--disable-sync --disable-extensions --disable-features=NetworkTimeServiceQuerying "
        "--hide-scrollbars --enable-logging=stderr --virtual-time-budget=5000 "
        "--user-data-dir=profile --window-size=" +
        std::to_string(std::max(width, 500)) + "," + std::to_string(height) + " " + flags +
        " 'file://" + (folder_ / "frame.html").string() + "' > out.txt 2> log.txt";
    const int status = std::system(command.c_str());
    INFO(log());
    REQUIRE(status == 0);
    return content(folder_ / "out.txt");
  }

  fs::path folder_;
};

elsie::report::Questions questions() {
  elsie::experiment::Expectation fusion;
  fusion.name = "fusion completes every case";
  fusion.measure = "success";
  fusion.statistic = elsie::report::Statistic::rate;
  fusion.where = {{"coordinator", {"fusion"}}};
  fusion.at_least = 1.0;
  elsie::experiment::Expectation arbitration = fusion;
  arbitration.name = "arbitration does so, too";
  arbitration.where = {{"coordinator", {"arbitration"}}};
  elsie::report::Questions questions;
  questions.expectations = {fusion, arbitration};
  return questions;
}

void check(const json& found) {
  INFO(found.dump(1));
  CHECK(found["errors"].empty());
  CHECK(found["resources"].empty());
  CHECK(found["scrollWidth"].get<int>() <= found["width"].get<int>());
  CHECK(found["beyond"].empty());
  if (found["width"] > 1000) CHECK(found["wide"].empty());
  CHECK(found["flat"].empty());
  CHECK(found["tall"].empty());
  CHECK(found["cut"].empty());
  CHECK(found["small"].empty());
  CHECK(found["faint"].empty());
  CHECK(found["anchors"] == 0);
}

}  // namespace

TEST_CASE("The page of a study, at a desk and on a phone, in light and in dark") {
  Browser browser(Made(elsie::test::made_study(), questions()).html());
  const auto [width, flags] = GENERATE(table<int, std::string>(
      {{1280, ""}, {390, ""}, {1280, "--force-dark-mode"}, {390, "--force-dark-mode"}}));
  const json found = browser.look(width, flags);
  CAPTURE(width, flags);
  CHECK(found["width"] == width);
  CHECK(found["dark"] == !flags.empty());
  check(found);
  CHECK(found["figures"].get<int>() >= 8 * 3 + 5 + 1);
  CHECK(found["pictures"].get<int>() >= 8 * 3 + 5 + 1);

  auto upwards = found["upwards"].get<std::vector<std::string>>();
  const auto by_number = [](const std::string& a, const std::string& b) {
    return std::stod(a) < std::stod(b);
  };
  CHECK(upwards != found["before"].get<std::vector<std::string>>());
  CHECK(std::is_sorted(upwards.begin(), upwards.end(), by_number));
  CHECK(found["sortedAs"] == "ascending");
  std::reverse(upwards.begin(), upwards.end());
  CHECK(found["downwards"].get<std::vector<std::string>>() == upwards);

  CHECK(found["filter"] == true);
  CHECK(found["chosen"] == json({"2 2, fusion", "2 2 2 2, fusion"}));
  CHECK(found["chosenRows"] == 2);

  // There were no requests to the network, and no complaints.
  CHECK(browser.log().find("CONSOLE") == std::string::npos);
  CHECK(browser.network() == std::vector<std::string>{});
}

TEST_CASE("A page with a request to the network would be detected") {
  std::string html = Made(elsie::test::made_study(), questions()).html();
  const std::string policy = "img-src data:";
  html.replace(html.find(policy), policy.size(), "img-src *");
  html.insert(html.find("</main>"), "<img src=\"http://elsie.invalid/picture.png\">");
  Browser browser(html);
  browser.look(1280);
  const auto asked = browser.network();
  CHECK(std::find(asked.begin(), asked.end(), "http://elsie.invalid/picture.png") != asked.end());
}

TEST_CASE("Hostile names break neither the page nor its width") {
  Browser browser(
      Made(elsie::test::hostile(), elsie::test::expecting(elsie::test::hostile_expectation()))
          .html(elsie::test::kHostile));
  const json found = browser.look(390);
  check(found);
  CHECK(browser.log().find("CONSOLE") == std::string::npos);
}

TEST_CASE("Pages of what is hardly a study fit a desk and a phone") {
  for (const elsie::test::EdgeCase& edge : elsie::test::edge_cases()) {
    Browser browser(Made(edge.experiment, elsie::test::edge_questions()).html());
    for (const int width : {1280, 390}) {
      CAPTURE(edge.name, width);
      check(browser.look(width));
      CHECK(browser.log().find("CONSOLE") == std::string::npos);
    }
  }
}

TEST_CASE("Pictures of the page, to be looked at") {
  Browser browser(Made(elsie::test::made_study(), questions()).html());
  CHECK(fs::file_size(browser.shoot("desk.png", 1280, 9000)) > 100'000);
  CHECK(fs::file_size(browser.shoot("phone.png", 390, 12000)) > 100'000);
  CHECK(fs::file_size(browser.shoot("dark.png", 1280, 9000, "--force-dark-mode")) > 100'000);
}
