// A page in headless Chromium, which opens it from its file, at any width, in light and dark mode.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace elsie::test {

class Browser {
 public:
  struct Setup {
    std::string folder;  // for the page and pictures of it, in the build folder
    std::string script;  // looks at the page and posts its findings to the outer page as JSON
    std::string flags;   // of Chromium
  };
  Browser(const std::string& html, Setup setup);

  /// The script's findings. It is inserted at the beginning of a copy of the page, where the page's
  /// policy lets it run with the page's own script; `pageErrors` has what the page did wrong.
  nlohmann::json look(int width, const std::string& flags = "", const std::string& address = "");
  /// A screenshot, kept in the folder for readers.
  std::filesystem::path shoot(const std::string& name, int width, int height,
                              const std::string& flags = "", const std::string& address = "");

  /// After look(): all addresses that the page has requested, except files. The browser's own
  /// requests, for updates, were not started by a page.
  std::vector<std::string> network() const;
  /// What it wrote to its console, and its own errors.
  std::string log() const;

 private:
  std::string run(const std::string& page, int width, int height, const std::string& flags);

  Setup setup_;
  std::filesystem::path folder_;
};

}  // namespace elsie::test
