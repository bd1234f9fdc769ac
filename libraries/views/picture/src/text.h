// Texts of files and users, made suitable for pictures.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace elsie::picture {

/// files::one_line(), shortened to at most `most` characters.
std::string clean_text(std::string_view text, std::size_t most = 200);

/// "label (unit)", or only one of the two.
std::string with_unit(const std::string& label, const std::string& unit);

/// The shortest text of the number to four digits; the same in every locale.
std::string number_text(double value);

}  // namespace elsie::picture
