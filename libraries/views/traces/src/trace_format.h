// What the writer and the reader of traces agree on; docs/explaining-a-run.md describes it.
#pragma once

#include <string>
#include <string_view>

namespace elsie::traces::trace_format {

inline constexpr std::string_view kMagic = "# elsie trace ";
inline constexpr int kVersion = 1;
inline constexpr std::string_view kHeading =
    "time_s,robot,behavior,asked,left,right,activation,strength,weight,share,reason,inhibited_by,"
    "event,detail";
inline constexpr std::size_t kColumns = 14;

/// The outcome of a run that was ended before it had one.
inline constexpr std::string_view kStopped = "stopped";

/// Text that stays on its line.
inline std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      c = ' ';
    }
  }
  return line;
}

/// A line that tables pass over: "# robot id="r1" team="red"". Quotes in a value are doubled.
class Remark {
 public:
  explicit Remark(std::string_view word) : line_("# " + std::string(word)) {}
  Remark& add(std::string_view name, std::string_view value) {
    line_ += ' ';
    line_ += name;
    line_ += "=\"";
    for (const char c : one_line(value)) {
      line_ += c;
      if (c == '"') {
        line_ += c;
      }
    }
    line_ += '"';
    return *this;
  }
  const std::string& line() const { return line_; }

 private:
  std::string line_;
};

}  // namespace elsie::traces::trace_format
