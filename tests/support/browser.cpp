#include "browser.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

#include <catch2/catch.hpp>

#include "places.h"

namespace elsie::test {
namespace {

using nlohmann::json;

// Of the clock, for a page's answer; of the browser's own time, before a picture is taken.
constexpr const char* kPatience = "--timeout=60000 ";
constexpr const char* kOpen = "--virtual-time-budget=5000 ";

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

Browser::Browser(const std::string& html, Setup setup)
    : setup_(std::move(setup)), folder_(build_path(setup_.folder)) {
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ / "page.html", std::ios::binary) << html;
}

json Browser::look(int width, const std::string& flags, const std::string& address) {
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
      << content(source_path(setup_.script)) << "</script>" << html.substr(head);
  const std::string dom =
      run("checked.html" + address, width, 900,
          std::string(kPatience) +
              "--dump-dom --log-net-log=net.json --net-log-capture-mode=Everything " + flags);
  const std::string mark = "<pre id=\"found\">";
  const std::size_t from = dom.find(mark);
  INFO(log());
  REQUIRE(from != std::string::npos);
  std::string text = dom.substr(from + mark.size(), dom.find("</pre>", from) - from - mark.size());
  for (const auto& [entity, character] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at) {
      text.replace(at, std::string(entity).size(), character);
    }
  }
  return json::parse(text);
}

std::filesystem::path Browser::shoot(const std::string& name, int width, int height,
                                     const std::string& flags, const std::string& address) {
  run("page.html" + address, width, height,
      std::string(kOpen) + "--screenshot=" + name + " " + flags);
  return folder_ / name;
}

std::vector<std::string> Browser::network() const {
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

std::string Browser::log() const { return content(folder_ / "log.txt"); }

// The page is in a frame, because a window of the browser is never narrower than 500 pixels. A
// second frame, whose document stays open, is loading until the page has answered.
std::string Browser::run(const std::string& page, int width, int height, const std::string& flags) {
  std::ofstream(folder_ / "frame.html")
      << "<!doctype html><meta name=\"color-scheme\" content=\"light dark\"><body "
         "style=\"margin:0\"><iframe src=\"" +
             page + "\" style=\"border:0;display:block;width:" + std::to_string(width) +
             "px;height:" + std::to_string(height) +
             "px\"></iframe><pre id=\"found\"></pre>"
             "<iframe id=\"hold\" style=\"display:none\"></iframe><script>"
             "const hold = document.getElementById('hold').contentDocument;" +
             (flags.find("--dump-dom") == std::string::npos ? "" : "hold.open();") +
             "addEventListener('message', (e) => {"
             "document.getElementById('found').textContent = e.data; hold.close(); })"
             "</script></body>";
  const std::string command =
      "cd '" + folder_.string() + "' && rm -rf profile && timeout 120 chromium --headless " +
      "--no-sandbox --disable-quic --no-first-run --disable-background-networking "
      "--disable-component-update --disable-sync --disable-extensions "
      "--disable-features=NetworkTimeServiceQuerying --hide-scrollbars --enable-logging=stderr "
      "--user-data-dir=profile --window-size=" +
      std::to_string(std::max(width, 500)) + "," + std::to_string(height) + " " + setup_.flags +
      " " + flags + " 'file://" + (folder_ / "frame.html").string() + "' > out.txt 2> log.txt";
  const int status = std::system(command.c_str());
  INFO(log());
  REQUIRE(status == 0);
  return content(folder_ / "out.txt");
}

}  // namespace elsie::test
