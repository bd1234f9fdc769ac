// Samples of the past, as the engine sends them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "elsie/files/base64.h"

#include "engine/past.h"

namespace elsie::desktop {

/// The answer to `paths` or `numbers` with these samples.
inline Json stored(const std::vector<double>& times,
                   const std::map<std::string, std::vector<float>>& values,
                   double period_s = 0.05) {
  Json answer{{"period_s", period_s}, {"more", false}, {"times", files::packed(times)}};
  std::vector<float> all;
  answer["curves"] = Json::array();
  for (const auto& [name, curve] : values) {
    answer["curves"].push_back(name);
    all.insert(all.end(), curve.begin(), curve.end());
  }
  answer["values"] = files::packed(all);
  return answer;
}

}  // namespace elsie::desktop
