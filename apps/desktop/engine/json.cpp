#include "engine/json.h"

#include <limits>

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

int integer_of(const Json& object, const char* name, int otherwise) {
  const double value = number_of(object, name);
  const bool fits = value >= std::numeric_limits<int>::min() &&
                    value <= std::numeric_limits<int>::max();  // NaN does not
  return fits && value == static_cast<int>(value) ? static_cast<int>(value) : otherwise;
}

QString written(const Json& value) {
  return value.is_string() ? QString::fromStdString(value.get<std::string>())
         : value.is_null() ? QString()
                           : QString::fromStdString(value.dump());
}

Json list_of(const QStringList& texts) {
  Json list = Json::array();
  for (const QString& each : texts) {
    list.push_back(each.toStdString());
  }
  return list;
}

}  // namespace elsie::desktop
