#include "effects.h"

#include <algorithm>
#include <limits>

#include "elsie/base/words.h"
#include "elsie/files/clean_text.h"
#include "elsie/report/contrasts.h"

#include "numbers.h"

namespace elsie::report {

namespace {

constexpr std::size_t kFactorLength = 40;

FactorEffect effect_of(const Findings& findings, const Response& response,
                       const VariedFactor& factor) {
  const std::vector<std::vector<std::size_t>> groups = factor.groups();
  const Balance balance = balanced(findings, response, groups, {factor.factor});
  FactorEffect effect;
  effect.factor = factor.name;
  effect.confounded = balance.confounded;
  std::vector<double> centres;
  for (std::size_t level = 0; level < groups.size(); ++level) {
    const Margin margin = margin_of(findings, response, balance, level, false);
    if (!margin.centre) {
      return effect;
    }
    centres.push_back(*margin.centre);
  }
  const auto [least, largest] = std::minmax_element(centres.begin(), centres.end());
  effect.size = are_equal(*least, *largest) ? 0.0 : *largest - *least;
  if (*effect.size > 0.0) {
    const auto group = [&](auto centre) {
      const auto level = static_cast<std::size_t>(centre - centres.begin());
      return Group{factor.levels[level], groups[level]};
    };
    const auto ends = contrast(findings, response, group(largest), group(least), {factor.factor});
    if (ends && ends->is_tested()) {
      const auto levels = static_cast<double>(groups.size());
      effect.p = std::min(1.0, ends->paired.p * levels * (levels - 1.0) / 2.0);
    }
  }
  return effect;
}

}  // namespace

std::optional<FactorEffects> factor_effects(const Findings& findings) {
  const std::vector<VariedFactor> factors = varied_factors(findings.results);
  const std::vector<Response> all = responses(findings);
  const auto response = std::find_if(
      all.begin(), all.end(), [&](const Response& one) { return !is_constant(findings, one); });
  if (factors.empty() || response == all.end()) {
    return std::nullopt;
  }
  FactorEffects effects{*response, {}};
  for (const VariedFactor& factor : factors) {
    effects.factors.push_back(effect_of(findings, *response, factor));
  }
  std::stable_sort(effects.factors.begin(), effects.factors.end(),
                   [](const FactorEffect& a, const FactorEffect& b) {
                     return a.size.value_or(-1.0) > b.size.value_or(-1.0);
                   });
  return effects;
}

std::string effects_in_words(const Findings& findings) {
  const auto effects = factor_effects(findings);
  if (!effects) {
    return "";
  }
  const auto shown = [](const std::string& text) {
    return files::shortened(files::one_line(text), kFactorLength);
  };
  const std::string unit =
      effects->response.unit.empty() ? "" : " " + shown(effects->response.unit);
  std::vector<std::string> parts;
  for (const FactorEffect& one : effects->factors) {
    std::string part = shown(in_words(one.factor, "")) +
                       (parts.empty() ? " moves " + shown(effects->response.words) : "");
    if (!one.size) {
      part += " by an unknown amount";
    } else if (*one.size == 0.0) {
      part += " by nothing";
    } else {
      part += " by " + brief(*one.size, 2) + unit +
              (one.may_be_chance() ? " (which may be chance)" : "") +
              (one.confounded ? " (its levels differ in other factors, too)" : "");
    }
    parts.push_back(std::move(part));
  }
  return base::joined(parts, ", ");
}

}  // namespace elsie::report
