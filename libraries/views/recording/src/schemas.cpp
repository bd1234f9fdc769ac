#include "schemas.h"

namespace elsie::recording {

extern const char* const kSchemas;  // schemas.json, compiled in

namespace {

void resolve(Json& schema, const Json& all) {
  if (!schema.is_structured()) {
    return;
  }
  if (schema.contains("$ref")) {
    const std::string pointer = schema["$ref"].get<std::string>().substr(1);  // without the #
    schema = all.at(Json::json_pointer(pointer));
  }
  for (Json& part : schema) {
    resolve(part, all);
  }
}

}  // namespace

Json schema_of(const std::string& name) {
  static const Json all = Json::parse(kSchemas);
  Json schema = all.at(name);
  resolve(schema, all);
  return schema;
}

}  // namespace elsie::recording
