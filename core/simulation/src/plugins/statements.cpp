#include "plugins/statements.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace elsie::simulation {

void Statements::ask(const Component& object, const world::PluginUse& use, const std::string& path,
                     Guard& guard) {
  for (std::string& note : guard.run(use, [&] { return object.notes(); })) {
    notes.push_back({guard.robot(), use.id, std::move(note)});
  }
  const auto has = [&](std::size_t from, const std::string& of, const std::string* name) {
    return std::any_of(curves.begin() + static_cast<std::ptrdiff_t>(from), curves.end(),
                       [&](const LearningCurve& other) {
                         return other.robot == guard.robot() && other.plugin == of &&
                                (!name || other.curve.name == *name);
                       });
  };
  // A behaviour and a coordinator beside it may have one id.
  std::string called = path + use.id;
  for (int number = 2; has(0, called, nullptr); ++number) {
    called = path + use.id + "_" + std::to_string(number);
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
    curves.push_back({guard.robot(), called, std::move(curve)});
  }
}

}  // namespace elsie::simulation
