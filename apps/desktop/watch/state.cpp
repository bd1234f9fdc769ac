#include "watch/state.h"

namespace elsie::desktop {

const Json& member(const Json& object, const char* name) {
  static const Json none;
  if (!object.is_object()) {
    return none;
  }
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

QString text_of(const Json& object, const char* name) {
  const Json& value = member(object, name);
  return value.is_string() ? QString::fromStdString(value.get<std::string>()) : QString();
}

double number_of(const Json& object, const char* name) {
  const Json& value = member(object, name);
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

const Json& robot_of(const Json& state, const QString& id) {
  static const Json none;
  for (const Json& robot : member(state, "robots")) {
    if (text_of(robot, "id") == id) {
      return robot;
    }
  }
  return none;
}

}  // namespace elsie::desktop
