#include "text.h"

#include "elsie/base/number_text.h"
#include "elsie/files/clean_text.h"

namespace elsie::picture {
std::string clean_text(std::string_view text, std::size_t most) {
  return files::shortened(files::one_line(text), most);
}

std::string with_unit(const std::string& label, const std::string& unit) {
  if (unit.empty()) return label;
  return label.empty() ? unit : label + " (" + unit + ")";
}

std::string number_text(double value) {
  std::string text = base::number_text(value == 0.0 ? 0.0 : value, 4);
  if (text.front() == '-') text.replace(0, 1, "\xE2\x88\x92");
  return text;
}

}  // namespace elsie::picture
