#include "elsie/page/viewer.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/files/base64.h"

namespace elsie::page {

// The viewer's files, and the SHA-256 of style and script in hexadecimal digits, as CMake read
// them.
extern const char* const kPage;
extern const char* const kStyle;
extern const char* const kScript;
extern const char* const kStyleHash;
extern const char* const kScriptHash;

namespace {

using Values = std::vector<std::pair<std::string_view, std::string>>;

/// The template with the values of its {{names}}.
std::string filled(std::string_view text, const Values& values) {
  std::string out;
  for (std::size_t at = 0;;) {
    const std::size_t open = text.find("{{", at), close = text.find("}}", open);
    out += text.substr(at, open - at);
    if (open == std::string_view::npos) return out;
    const std::string_view name = text.substr(open + 2, close - open - 2);
    const auto value = std::find_if(values.begin(), values.end(),
                                    [&](const auto& each) { return each.first == name; });
    if (value == values.end()) throw std::logic_error("page.html: " + std::string(name));
    out += value->second;
    at = close + 2;
  }
}

std::string html_with(Values values) {
  values.emplace_back("policy", "default-src 'none'; style-src " + viewer_style_hash() +
                                    "; script-src " + viewer_script_hash() +
                                    "; img-src data:; base-uri 'none'; form-action 'none'");
  values.emplace_back("style", kStyle);
  values.emplace_back("script", kScript);
  return filled(kPage, values);
}

}  // namespace

std::string viewer_style_hash() { return files::policy_hash(kStyleHash); }
std::string viewer_script_hash() { return files::policy_hash(kScriptHash); }

std::string viewer_html() {
  Values values;
  PageRun().for_each_text([&](const char* name, const std::string&) {
    values.emplace_back(name, "{{" + std::string(name) + "}}");
  });
  return html_with(std::move(values));
}

std::string html_of(const PageRun& run) {
  Values values;
  run.for_each_text(
      [&](const char* name, const std::string& text) { values.emplace_back(name, text); });
  return html_with(std::move(values));
}

}  // namespace elsie::page
