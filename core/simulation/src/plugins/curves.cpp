#include "plugins/curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace elsie::simulation {

void append_curves(const Component& object, const world::PluginUse& use, const std::string& robot,
                   const std::string& plugin, Guard& guard, std::vector<LearningCurve>& curves) {
  const auto has = [&](std::size_t from, const std::string& of, const std::string* name) {
    return std::any_of(curves.begin() + static_cast<std::ptrdiff_t>(from), curves.end(),
                       [&](const LearningCurve& other) {
                         return other.robot == robot && other.plugin == of &&
                                (!name || other.curve.name == *name);
                       });
  };
  // A behaviour and a coordinator beside it may have one id.
  std::string called = plugin;
  for (int number = 2; has(0, called, nullptr); ++number) {
    called = plugin + "_" + std::to_string(number);
  }
  const std::size_t first = curves.size();
  for (Curve& curve : guard.run(use, [&] { return object.curves(); })) {
    for (const Curve::Point& point : curve.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        guard.fail(use, "its curve '" + curve.name + "' has a point that is not finite");
      }
    }
    if (has(first, called, &curve.name)) {
      guard.fail(use, "two of its curves have the name '" + curve.name + "'");
    }
    curves.push_back({robot, called, std::move(curve)});
  }
}

}  // namespace elsie::simulation
