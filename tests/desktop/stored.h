// Samples of the past, as the engine sends them.
#pragma once

#include <QByteArray>
#include <map>
#include <string>
#include <vector>

#include "engine/past.h"

namespace elsie::desktop {

template <class Number>
std::string packed(const std::vector<Number>& numbers) {
  return QByteArray(reinterpret_cast<const char*>(numbers.data()),
                    static_cast<qsizetype>(numbers.size() * sizeof(Number)))
      .toBase64()
      .toStdString();
}

/// The answer to `paths` or `numbers` with these samples.
inline Json stored(const std::vector<double>& times,
                   const std::map<std::string, std::vector<float>>& values,
                   double period_s = 0.05) {
  Json answer{{"period_s", period_s}, {"more", false}, {"times", packed(times)}};
  answer["values"] = Json::object();
  for (const auto& [name, curve] : values) {
    answer["values"][name] = packed(curve);
  }
  return answer;
}

}  // namespace elsie::desktop
