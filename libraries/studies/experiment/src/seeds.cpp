#include "seeds.h"

#include <charconv>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include "elsie/experiment/reader.h"
#include "elsie/experiment/split.h"

#include "factors.h"

namespace elsie::experiment {

namespace {

using base::Problems;

const std::string kGreatest = std::to_string(std::numeric_limits<std::uint64_t>::max());

std::optional<std::uint64_t> seed_of(const std::string& word) {
  std::uint64_t seed = 0;
  const char* const end = word.data() + word.size();
  const auto parsed = std::from_chars(word.data(), end, seed);
  return parsed.ec == std::errc() && parsed.ptr == end ? std::optional(seed) : std::nullopt;
}

std::vector<std::uint64_t> listed_seeds(const SeedsDraft& draft, const std::string& element,
                                        Problems& problems) {
  std::vector<std::uint64_t> seeds;
  std::set<std::uint64_t> known;
  bool any = false;
  for (const std::string& word : split(*draft.list, ' ')) {
    if (word.empty()) {
      continue;
    }
    any = true;
    const auto seed = seed_of(word);
    if (!seed) {
      problems.add(draft.location, "list=\"" + *draft.list + "\" of " + element + ": '" + word +
                                       "' is no seed; expected whole numbers from 0 to " +
                                       kGreatest + ", separated by blanks");
    } else if (!known.insert(*seed).second) {
      problems.add(draft.location,
                   "the seed " + word + " is listed twice: the same seed gives the same run");
    } else {
      seeds.push_back(*seed);
    }
  }
  if (!any) {
    problems.add(draft.location, element + " lists none; expected whole numbers from 0");
  }
  return seeds;
}

}  // namespace

std::vector<std::uint64_t> seeds_from(const SeedsDraft& draft, const std::string& element,
                                      std::uint64_t most, Problems& problems) {
  const auto complain = [&](const std::string& message) {
    problems.add(draft.location, message);
    return std::vector<std::uint64_t>{};
  };
  if (draft.list ? draft.from || draft.to : !(draft.from && draft.to)) {
    return complain(element + " must say which: expected from=\"1\" to=\"20\", or list=\"3 5 8\"");
  }
  if (draft.list) {
    return listed_seeds(draft, element, problems);
  }
  const auto end_of = [&](const char* attribute, const std::string& text) {
    const auto seed = seed_of(text);
    if (!seed) {
      complain(std::string(attribute) + "=\"" + text + "\" of " + element +
               ": expected a whole number from 0 to " + kGreatest);
    }
    return seed;
  };
  const auto first = end_of("from", *draft.from), last = end_of("to", *draft.to);
  if (!first || !last) {
    return {};
  }
  const std::uint64_t from = *first, to = *last;
  if (from > to) {
    return complain("there is no seed from " + std::to_string(from) + " to " + std::to_string(to) +
                    "; give the smaller number first");
  }
  if (to - from >= most) {
    return complain(
        "there are more than " + std::to_string(most) + " seeds from " + std::to_string(from) +
        " to " + std::to_string(to) +
        (most == kMostRuns ? ", and as many runs" : "; a factor has at most as many levels"));
  }
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t more = 0; more <= to - from; ++more) {
    seeds.push_back(from + more);
  }
  return seeds;
}

}  // namespace elsie::experiment
