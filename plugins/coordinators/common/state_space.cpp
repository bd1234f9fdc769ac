#include "state_space.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <elsie/base/number_text.h>
#include <elsie/base/words.h>

namespace {

Expression expression_of(const Feature& feature) {
  try {
    return Expression(feature.of, "feature");
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("<feature of=\"" + feature.of + "\">: " + error.what());
  }
}

/// With one blank in place of white space, and none around it.
std::string on_one_line(const std::string& text) {
  std::istringstream words(text);
  return elsie::base::joined({std::istream_iterator<std::string>(words), {}}, " ");
}

std::size_t levels(const Feature& feature) { return feature.at.size() + 1; }

}  // namespace

StateSpace::StateSpace(std::vector<Feature> features) : features_(std::move(features)), size_(1) {
  if (features_.empty()) {
    throw std::invalid_argument(
        "it has no features, by which it tells states apart; expected <feature> inside it, such as "
        "<feature of=\"battery\" at=\"0.3\"/>");
  }
  for (const Feature& feature : features_) {
    expressions_.push_back(expression_of(feature));
    if (feature.at.empty() ||
        std::adjacent_find(feature.at.begin(), feature.at.end(),
                           [](double a, double b) { return !(a < b); }) != feature.at.end()) {
      throw std::invalid_argument("<feature of=\"" + feature.of +
                                  "\">: expected thresholds in ascending order in at, such as "
                                  "at=\"0.3 0.8\"");
    }
    if (levels(feature) > kMost / size_) {
      throw std::invalid_argument("its features have more than " + std::to_string(kMost) +
                                  " states together, too many to be learned; expected fewer "
                                  "features, or fewer thresholds in them");
    }
    size_ *= levels(feature);
  }
}

void StateSpace::equip(std::span<const elsie::Member> members, const elsie::Perception& example) {
  for (Expression& expression : expressions_) expression.equip(members, example);
}

std::size_t StateSpace::state(std::span<const elsie::Member> members,
                              const elsie::Perception& now) {
  std::size_t state = 0, of_level = 1;
  for (std::size_t i = 0; i < features_.size(); ++i) {
    const std::vector<double>& at = features_[i].at;
    if (const auto value = expressions_[i].value(members, now)) {
      const auto reached = std::upper_bound(at.begin(), at.end(), *value) - at.begin();
      state += of_level * static_cast<std::size_t>(reached);
    }
    of_level *= levels(features_[i]);
  }
  return state;
}

std::string StateSpace::text(std::size_t state) const {
  std::string text;
  for (const Feature& feature : features_) {
    const std::size_t level = state % levels(feature);
    state /= levels(feature);
    const std::string& name = feature.name.empty() ? feature.of : feature.name;
    text += text.empty() ? "" : " & ";
    if (levels(feature) > 2) {
      text += name + ' ' + std::to_string(level);
    } else {
      text += (level == 0 ? "not " : "") + name;
    }
  }
  return text;
}

std::string StateSpace::description() const {
  std::string text;
  for (const Feature& feature : features_) {
    text += (text.empty() ? "" : "; ") + on_one_line(feature.of) + " at";
    for (const double threshold : feature.at) text += ' ' + elsie::base::number_text(threshold);
  }
  return text;
}
