#include "hostile.h"

#include <cstdlib>
#include <stdexcept>

namespace elsie::test {

std::vector<std::vector<std::string>> parsed_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',') {
      rows.back().emplace_back();
    } else if (text[i] == '\n') {
      rows.emplace_back(1);
    } else if (text[i] == '"') {
      if (!rows.back().back().empty()) throw std::runtime_error("a quote in the middle of a cell");
      for (++i; text.at(i) != '"' || (i + 1 < text.size() && text[i + 1] == '"'); ++i) {
        if (text[i] == '"') ++i;
        rows.back().back() += text[i];
      }
    } else {
      rows.back().back() += text[i];
    }
  }
  if (rows.back() != std::vector<std::string>(1)) throw std::runtime_error("an unfinished line");
  rows.pop_back();
  return rows;
}

std::string xmllint(const std::string& text, const std::string& options) {
  const Folder folder;
  const std::string file = folder.write("checked", text), log = folder.file("log");
  const int code =
      std::system(("xmllint --noout " + options + " '" + file + "' 2> '" + log + "'").c_str());
  return code == 0 ? "" : "failed: " + folder.read("log");
}

}  // namespace elsie::test
