#include "elsie/experiment/where.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "elsie/base/near_name.h"
#include "elsie/experiment/split.h"

#include "factors.h"
#include "grid.h"

namespace elsie::experiment {

namespace {

const Labels& named(const std::string& factor, const std::vector<Labels>& known) {
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const Labels& one) { return one.factor == factor; });
  if (found == known.end()) {
    std::vector<std::string> names;
    for (const Labels& one : known) {
      names.push_back(one.factor);
    }
    throw std::invalid_argument("there is no factor '" + factor + "'" +
                                base::near_or_all(factor, names, "there are"));
  }
  return *found;
}

// Whether a level goes on with another factor, as in "fusion, speed=0.1".
bool goes_on(const std::string& level, const std::vector<Labels>& known) {
  return std::any_of(known.begin(), known.end(), [&](const Labels& one) {
    const std::size_t at = level.find(one.factor + "=");
    return at != std::string::npos && trimmed(level.substr(0, at)).ends_with(',');
  });
}

}  // namespace

std::vector<Labels> labels_of(const Experiment& experiment) {
  std::vector<Labels> all{{kWorldFactor, {}}};
  for (const WorldUse& world : experiment.worlds) {
    all.front().labels.push_back(world.id);
  }
  for (const Factor& factor : experiment.factors) {
    Labels& labels = all.emplace_back(Labels{factor.name, {}});
    for (const Level& level : factor.levels) {
      labels.labels.push_back(level.label);
    }
  }
  return all;
}

std::vector<Where> parse_where(const std::string& text, const std::vector<Labels>& known) {
  std::vector<Where> all;
  std::set<std::string> used;
  for (const std::string& part : split(text, ';')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos) {
      throw std::invalid_argument(
          "expected FACTOR=LEVEL, several of them separated by \";\", found '" + part + "'");
    }
    Where where;
    where.factor = trimmed(part.substr(0, equals));
    const Labels& factor = named(where.factor, known);
    if (!used.insert(where.factor).second) {
      throw std::invalid_argument("'" + where.factor +
                                  "' stands there twice; one of several levels is " + where.factor +
                                  "=A|B");
    }
    where.levels = split(part.substr(equals + 1), '|');
    for (const std::string& level : where.levels) {
      if (std::none_of(factor.labels.begin(), factor.labels.end(),
                       [&](const std::string& label) { return matches(level, label); })) {
        throw std::invalid_argument("'" + where.factor + "' has no level '" + level + "'" +
                                    (goes_on(level, known)
                                         ? "; separate factors by \";\""
                                         : base::near_or_all(level, factor.labels, "it has")));
      }
    }
    all.push_back(std::move(where));
  }
  return all;
}

}  // namespace elsie::experiment
