// Random damage to files, to find out whether they are still read or refused in words.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace elsie::test {

class Damage {
 public:
  /// `pieces` are put anywhere, an "x" behind `names`: what XML and the reader care about.
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

  // Puts `piece` behind one of the places where `mark` stands.
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
      case 2:  // something that XML or the reader cares about
        text.insert(at, pieces_[below(pieces_.size())]);
        break;
      case 3:  // a part twice
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
