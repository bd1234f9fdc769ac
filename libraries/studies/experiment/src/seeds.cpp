#include "seeds.h"

#include <charconv>
#include <set>
#include <string>

#include "elsie/experiment/reader.h"

#include "factors.h"

namespace elsie::experiment {

namespace {

using base::Problems;

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
    std::int64_t seed = 0;
    const char* end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, seed);
    if (parsed.ec != std::errc() || parsed.ptr != end || seed < 0) {
      problems.add(draft.location, "list=\"" + *draft.list + "\" of " + element + ": '" + word +
                                       "' is no seed; expected whole numbers from 0, separated by "
                                       "blanks");
    } else if (!known.insert(static_cast<std::uint64_t>(seed)).second) {
      problems.add(draft.location,
                   "the seed " + word + " is listed twice: the same seed gives the same run");
    } else {
      seeds.push_back(static_cast<std::uint64_t>(seed));
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
  const auto from = static_cast<std::uint64_t>(*draft.from);
  const auto to = static_cast<std::uint64_t>(*draft.to);
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
  for (std::uint64_t seed = from; seed <= to; ++seed) {
    seeds.push_back(seed);
  }
  return seeds;
}

}  // namespace elsie::experiment
