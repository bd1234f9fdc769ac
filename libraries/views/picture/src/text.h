// Text from files and users, made fit for a picture.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace elsie::picture {

/// Valid UTF-8 of one line: what is not UTF-8 becomes U+FFFD, control characters become spaces. Of
/// more than `max_characters` code points the first ones and an ellipsis remain.
std::string clean_text(std::string_view text, std::size_t max_characters = 200);

/// Without its last `characters` code points. The text is valid UTF-8.
std::string without_tail(const std::string& text, std::size_t characters);

/// "label (unit)", or only one of them.
std::string with_unit(const std::string& label, const std::string& unit);

/// The shortest text that reads as the number to four digits; the same in every locale.
std::string number_text(double value);

}  // namespace elsie::picture
