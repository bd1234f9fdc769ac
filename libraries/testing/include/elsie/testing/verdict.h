// The result of a check.
#pragma once

#include <string>
#include <utility>

namespace elsie::testing {

/// True, or false with a sentence: `if (const auto v = check(...); !v) puts(v.sentence.c_str());`
struct Verdict {
  Verdict() = default;
  static Verdict wrong(std::string sentence) { return {false, std::move(sentence)}; }
  explicit operator bool() const { return holds; }

  bool holds = true;
  std::string sentence;  // empty if it holds

 private:
  Verdict(bool is_so, std::string why) : holds(is_so), sentence(std::move(why)) {}
};

}  // namespace elsie::testing
