// Pieces of sentences.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace elsie::base {

/// "1 run", "2 runs".
std::string counted(std::uint64_t count, std::string_view what);
/// "1 match", "2 matches".
std::string counted(std::uint64_t count, std::string_view one, std::string_view several);

/// The items with a separator between them.
std::string joined(const std::vector<std::string>& items, std::string_view separator = ", ");
/// "a, b, c"; of more than 20 items, the first 20 "and 5 more".
std::string listed(const std::vector<std::string>& items);
/// "a", "a and b", "a, b and c"; with "or" likewise.
std::string enumerated(const std::vector<std::string>& items, std::string_view last = "and");

/// A piece of a file for a message, between single quotes: at most `most` bytes, whole characters,
/// "?" for unprintable ones.
std::string in_quotes(std::string_view word, std::size_t most = 40);
/// A name in full length, likewise.
inline std::string name_in_quotes(std::string_view name) { return in_quotes(name, name.npos); }

}  // namespace elsie::base
