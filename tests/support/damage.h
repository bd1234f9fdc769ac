// Random damage to files, which must still be read, or refused in sentences.
#pragma once

#include <algorithm>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace elsie::test {

/// Texts that matter to any file of XML, the words, which have blanks between them, and `more`.
inline std::vector<std::string> xml_pieces(const std::string& words,
                                           const std::vector<std::string>& more) {
  std::istringstream all(
      "< > / \" ' = & &amp; <!-- --> <![CDATA[ ]]> <? nan -1 1e999 \xC3 \x01 0 - 9 " + words);
  std::vector<std::string> pieces{std::istream_iterator<std::string>(all), {}};
  pieces.insert(pieces.end(), {" ", "\n"});
  pieces.insert(pieces.end(), more.begin(), more.end());
  return pieces;
}

class Damage {
 public:
  /// Inserts `pieces` anywhere, and an "x" after `names`: texts that matter to XML and the reader.
  Damage(unsigned seed, const std::vector<std::string>& pieces,
         const std::vector<std::string>& names)
      : random_(seed), pieces_(pieces), names_(names) {}

  std::string to(std::string text) {
    const int count = static_cast<int>(below(3)) + 1;
    for (int i = 0; i < count; ++i) {
      once(text);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  // Inserts `piece` after one of the places of `mark`.
  void insert_behind(std::string& text, const std::string& mark, const std::string& piece) {
    std::size_t at = text.find(mark, below(text.size()));
    at = at == std::string::npos ? text.find(mark) : at;
    if (at != std::string::npos) {
      text.insert(at + mark.size(), piece);
    }
  }

  void once(std::string& text) {
    if (text.empty()) {
      return;
    }
    const std::size_t at = below(text.size());
    switch (below(7)) {
      case 0:  // a byte
        text[at] = static_cast<char>(below(256));
        break;
      case 1:  // a gap
        text.erase(at, below(40));
        break;
      case 2:  // a text that matters to XML or the reader
        text.insert(at, pieces_[below(pieces_.size())]);
        break;
      case 3:  // a repeated part
        text.insert(below(text.size()), text.substr(at, below(200)));
        break;
      case 4:  // a bad id
        insert_behind(text, " id=\"", "1 ");
        break;
      case 5:  // an unknown name
        insert_behind(text, names_[below(names_.size())], "x");
        break;
      default:  // an end
        text.resize(std::max(at, text.size() - std::min(text.size(), below(100))));
    }
  }

  std::mt19937 random_;
  const std::vector<std::string>& pieces_;
  const std::vector<std::string>& names_;
};

}  // namespace elsie::test
