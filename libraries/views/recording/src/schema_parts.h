// The parts of JSON schemas.
#pragma once

#include <initializer_list>
#include <utility>

#include "format.h"

namespace elsie::recording::schemas {

struct Property {
  const char* name;
  Json schema;
  bool required = true;
};

inline Json described(Json schema, const char* description) {
  if (*description != '\0') {
    schema["description"] = description;
  }
  return schema;
}
inline Json plain(const char* type, const char* description = "") {
  return described({{"type", type}}, description);
}
inline Json number(const char* description = "") { return plain("number", description); }
inline Json text(const char* description = "") { return plain("string", description); }
inline Json base64_text(const char* description = "") {
  Json schema = text(description);
  schema["contentEncoding"] = "base64";
  return schema;
}
inline Json integer(const char* description = "") { return plain("integer", description); }
inline Json boolean(const char* description = "") { return plain("boolean", description); }

inline Json object(const char* title, std::initializer_list<Property> properties) {
  Json schema{{"title", title}, {"type", "object"}, {"properties", Json::object()}};
  Json required = Json::array();
  for (const Property& property : properties) {
    schema["properties"][property.name] = property.schema;
    if (property.required) {
      required.push_back(property.name);
    }
  }
  if (!required.empty()) {
    schema["required"] = required;
  }
  return schema;
}

inline Json list(Json items, const char* description = "") {
  return described({{"type", "array"}, {"items", std::move(items)}}, description);
}

/// An object with these members, each with its schema, and no others. All are optional.
inline Json members(Json properties, const char* description) {
  return described(
      {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}},
      description);
}

/// One of several numbers, by name.
inline Json choice(const char* title, std::initializer_list<std::pair<const char*, int>> values) {
  Json schema{{"title", title}, {"oneOf", Json::array()}};
  for (const auto& [name, value] : values) {
    schema["oneOf"].push_back({{"title", name}, {"const", value}});
  }
  return schema;
}

inline Json time(const char* title = "time", const char* description = "") {
  return described(object(title, {{"sec", integer()}, {"nsec", integer()}}), description);
}
inline Json vector() {
  return object("foxglove.Vector3", {{"x", number()}, {"y", number()}, {"z", number()}});
}
inline Json quaternion() {
  return object("foxglove.Quaternion",
                {{"x", number()}, {"y", number()}, {"z", number()}, {"w", number()}});
}
inline Json pose() {
  return object("foxglove.Pose", {{"position", vector()}, {"orientation", quaternion()}});
}
inline Json colour() {
  return object("foxglove.Color",
                {{"r", number()}, {"g", number()}, {"b", number()}, {"a", number()}});
}
}  // namespace elsie::recording::schemas
