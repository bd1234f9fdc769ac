// A text that does not change, whose copies share its memory.
#pragma once

#include <memory>
#include <string>
#include <utility>

namespace elsie::base {

/// Copies are cheap, and may be made in several threads at once. It stands for a std::string, so
/// both convert to each other.
class SharedText {
 public:
  SharedText() = default;         // the empty text
  SharedText(std::string text) {  // NOLINT(google-explicit-constructor)
    if (!text.empty()) text_ = std::make_shared<const std::string>(std::move(text));
  }
  SharedText(const char* text)  // NOLINT(google-explicit-constructor)
      : SharedText(std::string(text)) {}

  const std::string& text() const {
    static const std::string kEmpty;
    return text_ ? *text_ : kEmpty;
  }
  operator const std::string&() const { return text(); }  // NOLINT(google-explicit-constructor)
  bool empty() const { return !text_; }

  friend bool operator==(const SharedText& a, const SharedText& b) {
    return a.text_ == b.text_ || a.text() == b.text();
  }
  friend bool operator==(const SharedText& a, const std::string& b) { return a.text() == b; }

 private:
  std::shared_ptr<const std::string> text_;
};

}  // namespace elsie::base
