// Refusals of edits for a window, whose users have not written the edits.
#pragma once

#include <string>
#include <vector>

namespace elsie::server {

/// An edit in words, to follow "cannot": "set x of r1 to 5", "take y away from static_box_1".
std::string words_of(const std::string& edit);

/// A refusal of these edits by a run, which begins with them, as a sentence that does not: "The run
/// cannot set x of r1 to 5: ..."; any other sentence as it is.
std::string refusal_in_words(const std::string& refusal, const std::vector<std::string>& edits);

/// A sentence that names edits as places, "(--set obstacle[+]=...)", without them.
std::string without_edits(std::string sentence, const std::vector<std::string>& edits);

}  // namespace elsie::server
